//! Cells of the mesh cycle of outlines, for the search of their extremes ([`CycleSearch`]).
//!
//! Cells share the poses at their ends. A line parallel to the chord between both ends is above the gap of a side all through a cell. The two
//! lines that touch the gap at the ends are below it ([`SideCell`]). Bounds of the lost motion follow from the lines of both sides.
//!
//! Where contact passes from one edge to the next within a cell, the gap is least at a kink. Both lines below meet near it. So the bounds are
//! off by the second order of a cell's width there too.

use super::cell::{Bound, ContactInCell, SideCell};
use super::{OutlineKernel, SideContact, SideKernel};
use crate::contact::cycle_search::{Cell, CycleCells, CycleSearch, GRID};
use crate::contact::effort::Effort;
use crate::contact::exact::{Doubt, End, Extremes};
use crate::contact::gap::{C, turn};
use crate::contact::lost_motion::{LostMotion, Status};
use crate::error::Tick;
use crate::outline::{OutlineGear, OutlinePair, ToothClasses};
use crate::pair::Mating;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Comparisons of two rectangles per unit of effort (tuned).
const A_UNIT: u64 = 2;

/// Limit of [`Effort`] for one extreme, nodes (tuned: ten seconds at most; gears of 26 and 17 teeth that differ by 0.02 µm take five).
const MOST_EFFORT: u64 = 30_000_000;

/// A mesh cycle.
#[derive(Clone)]
pub(crate) struct OutlineCycle<'t> {
    /// Its first mating.
    pub first: Mating,
    /// Matings after which all teeth meet again.
    pub distinct: u64,
    /// Number of its matings.
    pub matings: u64,
    /// Equal teeth, of the locked and the free gear.
    pub classes: [Arc<ToothClasses>; 2],
    /// Number of equal parts of the effort. A search may use one.
    pub parts_of_effort: u64,
    pub tick: &'t Tick<'t>,
}

impl OutlineCycle<'_> {
    /// The extremes `ends` of `pair`, the gears of `kernel`, over this cycle, in brackets of `width` mm where no more effort is needed than a
    /// search may spend.
    pub(crate) fn extremes(
        &self,
        kernel: &OutlineKernel,
        pair: &OutlinePair,
        ends: &[End],
        width: f64,
    ) -> Extremes {
        let radius = pair.operating_pitch_radius(pair.free());
        let cells = OutlineCells {
            kernel,
            pair,
            cycle: self,
            poses: Mutex::default(),
        };
        let search = CycleSearch {
            cells: &cells,
            distinct: self.distinct,
            matings: self.matings,
            width: width / radius,
            radius,
            most_effort: MOST_EFFORT / self.parts_of_effort,
            tick: self.tick,
        };
        search.extremes(ends).0
    }
}

/// The cycle of a pair of outlines.
struct OutlineCells<'a> {
    kernel: &'a OutlineKernel<'a>,
    pair: &'a OutlinePair,
    cycle: &'a OutlineCycle<'a>,
    /// By their places on the grid.
    poses: Mutex<HashMap<i64, Arc<EndPose>>>,
}

impl CycleCells for OutlineCells<'_> {
    const DOUBT_OF_BOUNDS: Doubt = Doubt::Drawing;

    fn mating(&self, pitches: f64) -> Mating {
        self.cycle.first.onward(self.pair, pitches)
    }

    fn teeth_in_reach(&self, pitches: f64, half: f64) -> Option<Vec<u32>> {
        let (pair, mating) = (self.pair, self.mating(pitches));
        let half = half * pair.gear(pair.locked()).pitch();
        let [locked, free] = &self.cycle.classes;
        let sides = self.kernel.sides.iter();
        let facing = sides.flat_map(|side| {
            let (rotation, _) = side.locked_frame(pair, &mating);
            side.facing_pairs(pair, &mating, rotation, half)
        });
        let classes = facing.flat_map(|teeth| [locked.first(teeth[0]), free.first(teeth[1])]);
        Some(classes.collect())
    }

    fn examine(&self, pitches: f64, half: f64, ends: &[End], wanted: f64) -> Cell {
        let pair = self.pair;
        let mut cell = Cell::unknown(pitches, half);
        let from = self.pose(pitches - half);
        cell.known = from.pitches;
        cell.effort = from.effort;
        cell.status = from.status;
        cell.angle = from.angle;
        // Nothing bounds a cell wider than a pitch.
        if half == 0.0 || half > 0.5 || from.contacts.is_none() {
            return cell;
        }
        let poses = [from, self.pose(pitches + half)];
        let mating = self.mating(pitches);
        let width = half * pair.gear(pair.locked()).pitch();
        let sides = self.sides(pitches, half, wanted, &poses);
        if ends.contains(&End::Least) && !self.may_jam(&mating, width) {
            let [right, left] = sides.each_ref().map(|side| {
                let (line, looked) = side.above(pair, &mating);
                cell.effort += u64::from(looked) / A_UNIT;
                line
            });
            if let (Some(right), Some(left)) = (right, left) {
                let (lost, drawn) = lost_between(&[right], &[left], width);
                cell.low = (lost.into_iter().fold(f64::INFINITY, f64::min), drawn);
            }
        }
        if ends.contains(&End::Greatest) {
            let [right, left] = sides.each_ref().map(SideOverCell::below);
            if !right.is_empty() && !left.is_empty() {
                let (lost, drawn) = lost_between(&right, &left, width);
                cell.high = (lost.into_iter().fold(f64::NEG_INFINITY, f64::max), drawn);
            }
        }
        cell
    }
}

/// A straight bound of a side's gap over a cell.
#[derive(Debug, Clone, Copy)]
struct BoundLine {
    /// In the middle of the cell.
    bound: Bound,
    /// By the rotation of the locked gear along the cycle.
    slope: f64,
}

impl BoundLine {
    fn at(&self, away: f64) -> f64 {
        self.bound.level + self.slope * away
    }
}

/// The lost motion between the highest lines of both sides, at the ends of a cell and where lines cross: elsewhere it is between these. Also
/// the effect of the outlines' error bounds on it.
fn lost_between(right: &[BoundLine], left: &[BoundLine], half: f64) -> (Vec<f64>, f64) {
    let highest = |lines: &[BoundLine], away: f64| {
        let gaps = lines.iter().map(|line| line.at(away));
        gaps.fold(f64::NEG_INFINITY, f64::max)
    };
    let crossing = |lines: &[BoundLine]| match lines {
        [one, other] => (other.bound.level - one.bound.level) / (one.slope - other.slope),
        _ => 0.0,
    };
    let places = [-half, half, crossing(right), crossing(left)].into_iter();
    let within = places.filter(|away| away.abs() <= half);
    let lost = within.map(|away| -highest(right, away) - highest(left, away));
    let drawn = [right, left].map(|lines| {
        let each = lines.iter().map(|line| line.bound.drawn);
        each.fold(0.0, f64::max)
    });
    (lost.collect(), drawn[0] + drawn[1])
}

/// A pose at the end of a cell.
#[derive(Debug)]
struct EndPose {
    pitches: f64,
    effort: u64,
    status: Status,
    /// The lost motion, rad, and its error.
    angle: Option<(f64, f64)>,
    /// `None` where a contact is not found within the effort of a pose.
    contacts: Option<[Option<SideContact>; 2]>,
}

impl OutlineCells<'_> {
    /// Whether teeth may reach the solid body of the mate in a cell of half width `half`, rad.
    fn may_jam(&self, mating: &Mating, half: f64) -> bool {
        let (kernel, pair) = (self.kernel, self.pair);
        let reach = pair.gear(pair.locked()).reach();
        // No point turns faster about the locked axis.
        pair.center_distance() - reach < kernel.solid
            && kernel.sides[0].reaches_within(pair, mating, kernel.solid + half * reach)
    }

    /// The pose at `pitches`, rounded to [`GRID`].
    fn pose(&self, pitches: f64) -> Arc<EndPose> {
        let place = (pitches * GRID).round();
        let poses = || self.poses.lock().unwrap_or_else(PoisonError::into_inner);
        let known = poses().get(&(place as i64)).cloned();
        known.unwrap_or_else(|| {
            let pose = Arc::new(self.found_at(place / GRID));
            poses().insert(place as i64, pose.clone());
            pose
        })
    }

    fn found_at(&self, pitches: f64) -> EndPose {
        let (kernel, pair, mating) = (self.kernel, self.pair, self.mating(pitches));
        let spent = Effort::of_pose();
        let sides = kernel.sides.each_ref();
        let [right, left] = sides.map(|side| side.side_contact(pair, &mating, true, &spent).ok());
        let contacts = right.zip(left).map(|(right, left)| [right, left]);
        let found = contacts.map(|contacts| {
            kernel.lost_motion_of(pair, &mating, contacts.each_ref().map(Option::as_ref))
        });
        EndPose {
            pitches,
            effort: spent.used(),
            status: found.as_ref().map_or(Status::Unproven, LostMotion::status),
            angle: found.and_then(|found| found.angle().zip(found.error())),
            contacts,
        }
    }

    /// Both sides of a cell, with the contacts of the poses at its ends.
    fn sides(
        &self,
        pitches: f64,
        half: f64,
        wanted: f64,
        poses: &[Arc<EndPose>; 2],
    ) -> [SideOverCell<'_>; 2] {
        let pitch = self.pair.gear(self.pair.locked()).pitch();
        [0, 1].map(|side: usize| {
            let contacts = poses.each_ref().map(|pose| {
                let away = (pose.pitches - pitches) * pitch;
                Some((away, pose.contacts?[side]?))
            });
            SideOverCell::new(
                self,
                side,
                &self.mating(pitches),
                half * pitch,
                wanted,
                contacts,
            )
        })
    }
}

/// A side of a cell, with the contacts at its ends.
struct SideOverCell<'a> {
    side: &'a SideKernel<'a>,
    /// Its rate is that of the nominal rotation.
    cell: SideCell<'a>,
    /// Rotation of the locked gear in the side's frame over that along the cycle: 1 or −1.
    sense: f64,
    contacts: [Option<EndContact>; 2],
}

/// The contact at an end of a cell.
struct EndContact {
    /// Rotation of the locked gear from the middle, rad, in the side's frame.
    away: f64,
    /// From the nominal rotation.
    gap: f64,
    rate: f64,
    touching: ContactInCell,
}

impl EndContact {
    /// The contact of `side` in a pose whose locked gear is turned by `away` from the middle of `cell`.
    fn new(side: &SideKernel, cell: &SideCell, meeting: &SideContact, away: f64) -> EndContact {
        let ([p, q], normal, _) = side.touching(meeting);
        // Both points of a contact move equally fast along its normal.
        let along = |arm: C| normal.re * -arm.im + normal.im * arm.re;
        let rate = cell.limited(along(p.point - cell.distance) / along(p.point));
        let gap = meeting.found.gap;
        let with_line = turn(-rate * away);
        EndContact {
            away,
            gap,
            rate,
            touching: ContactInCell {
                level: gap + (cell.ratio - rate) * away,
                teeth: meeting.teeth,
                at: [meeting.found.locked, meeting.found.free],
                normals: [
                    normal * with_line,
                    p.normal * turn(-away),
                    -q.normal * turn(meeting.nominal + gap) * with_line,
                ],
            },
        }
    }
}

impl<'a> SideOverCell<'a> {
    /// The side of a cell about `mating`. Half its width is `half`, rad of the locked gear. Bounds are `width` wide in the end, rad of the free
    /// gear. The contacts come with their distances from the middle, rad of the locked gear.
    fn new(
        cells: &OutlineCells<'a>,
        side: usize,
        mating: &Mating,
        half: f64,
        width: f64,
        contacts: [Option<(f64, SideContact)>; 2],
    ) -> SideOverCell<'a> {
        let (side, pair) = (&cells.kernel.sides[side], cells.pair);
        let (_, locked) = side.locked_frame(pair, mating);
        let gears = [side.locked.gear, side.free.gear];
        let apart = cells.cycle.classes.iter().map(|of| of.difference_bound);
        let ratio = -gears[1].pitch() / gears[0].pitch();
        let cell = SideCell {
            teeth: [&side.locked, &side.free],
            free_halves: &side.free_halves,
            frames: [locked, side.free.still()],
            reach: gears.map(OutlineGear::reach),
            nominal: turn(-side.side.sense() * pair.rotation(pair.free(), mating)),
            distance: pair.center_distance(),
            half,
            ratio,
            rate: ratio,
            fine: (width / 16.0).max(half * half / 8.0),
            bound: apart.sum::<f64>() + gears[0].bound() + gears[1].bound(),
        };
        let sense = side.side.sense() * gears[0].face().ascending();
        let contacts = contacts.map(|contact| {
            let (away, meeting) = contact?;
            Some(EndContact::new(side, &cell, &meeting, sense * away))
        });
        SideOverCell {
            side,
            cell,
            sense,
            contacts,
        }
    }

    fn line(&self, bound: Bound, rate: f64) -> BoundLine {
        BoundLine {
            bound,
            slope: self.sense * (rate - self.cell.ratio),
        }
    }

    /// A line above the gap, parallel to that through both contacts, and how many rectangles were compared.
    fn above(&self, pair: &OutlinePair, mating: &Mating) -> (Option<BoundLine>, u32) {
        let (floor, rate) = match &self.contacts {
            [Some(from), Some(to)] => {
                let slope = (to.gap - from.gap) / (to.away - from.away);
                let rate = self.cell.limited(self.cell.ratio + slope);
                (0.5 * (from.gap + to.gap), rate)
            }
            _ => (-0.5 * self.side.free.gear.pitch(), self.cell.ratio),
        };
        let cell = SideCell { rate, ..self.cell };
        let (rotation, _) = self.side.locked_frame(pair, mating);
        let facing = self.side.facing_pairs(pair, mating, rotation, cell.half);
        let (bound, looked) = cell.above(facing, floor.max(-0.5));
        (bound.map(|bound| self.line(bound, rate)), looked)
    }

    /// Lines below the gap, by the contact at each end.
    fn below(&self) -> Vec<BoundLine> {
        let contacts = self.contacts.iter().flatten();
        let lines = contacts.filter_map(|contact| {
            let rate = contact.rate;
            let bound = SideCell { rate, ..self.cell }.below(&contact.touching)?;
            Some(self.line(bound, rate))
        });
        lines.collect()
    }
}
