//! Cells of the mesh cycle of outlines, for the search of their extremes ([`CycleSearch`]).
//!
//! A side's contact lies between two lines all through a cell ([`SideCell`]), so the lost motion does too, with the difference of both rates.
//! Near an edge that passes an edge the bounds are off by the first order of a cell's width, elsewhere by the second: each division brings the
//! extreme nearer by a constant factor, and few cells stay open.

use super::cell::{Bound, SideCell, Touching};
use super::teeth::Frame;
use super::{Meeting, OutlineKernel, SideKernel};
use crate::contact::cycle_search::{Cell, CycleCells, CycleSearch};
use crate::contact::effort::Effort;
use crate::contact::exact::{Doubt, End, Extremes};
use crate::contact::gap::{C, turn};
use crate::outline::{OutlinePair, ToothClasses};
use crate::pair::Mating;

/// Greatest rate of a contact over the ratio of the teeth. The ratio itself replaces greater rates.
const FASTEST: f64 = 4.0;

/// Comparisons of two rectangles per unit of effort (tuned).
const A_UNIT: u64 = 2;

/// A mesh cycle.
#[derive(Debug, Clone)]
pub(crate) struct OutlineCycle {
    /// Where it begins.
    pub first: Mating,
    /// Matings after which all is as it was.
    pub distinct: u64,
    /// All of its matings.
    pub matings: u64,
    /// Equal teeth, of the locked and the free gear.
    pub classes: [ToothClasses; 2],
}

impl OutlineKernel<'_> {
    /// The extremes `ends` of `pair`, these gears, over a cycle, in brackets of `width` mm where no more effort is needed than a search may spend.
    pub(crate) fn extremes(
        &self,
        pair: &OutlinePair,
        cycle: &OutlineCycle,
        ends: &[End],
        width: f64,
    ) -> Extremes {
        let radius = pair.operating_pitch_radius(pair.free());
        let cells = OutlineCells {
            kernel: self,
            pair,
            cycle,
        };
        let search = CycleSearch {
            cells: &cells,
            distinct: cycle.distinct,
            matings: cycle.matings,
            width: width / radius,
            radius,
        };
        search.extremes(ends).0
    }
}

/// The cycle of a pair of outlines.
struct OutlineCells<'a> {
    kernel: &'a OutlineKernel<'a>,
    pair: &'a OutlinePair,
    cycle: &'a OutlineCycle,
}

impl CycleCells for OutlineCells<'_> {
    const LEFT_OPEN: Doubt = Doubt::Drawing;

    fn mating(&self, pitches: f64) -> Mating {
        self.cycle.first.onward(self.pair, pitches)
    }

    fn likeness(&self, pitches: f64, half: f64) -> Option<Vec<u32>> {
        let (pair, mating) = (self.pair, self.mating(pitches));
        let half = half * pair.gear(pair.locked()).pitch();
        let [locked, free] = &self.cycle.classes;
        let sides = self.kernel.sides.iter();
        let facing = sides.flat_map(|side| {
            let (rotation, _) = side.locked_frame(pair, &mating);
            side.facing(pair, &mating, rotation, half)
        });
        let classes = facing.flat_map(|teeth| [locked.first(teeth[0]), free.first(teeth[1])]);
        Some(classes.collect())
    }

    fn look(&self, pitches: f64, half: f64, ends: &[End], wanted: f64) -> Cell {
        let (kernel, pair) = (self.kernel, self.pair);
        let mating = self.mating(pitches);
        let spent = Effort::of_pose();
        let mut cell = Cell::unknown(pitches, half);
        let meetings = kernel
            .sides
            .each_ref()
            .map(|side| side.meeting(pair, &mating, true, &spent));
        cell.effort = spent.used();
        let [Ok(right), Ok(left)] = meetings else {
            return cell;
        };
        let meetings = [right, left];
        let found = kernel.lost_motion_of(pair, &mating, meetings.each_ref().map(Option::as_ref));
        cell.status = found.status();
        cell.angle = found.angle().zip(found.error());
        // Nothing bounds a cell wider than a pitch.
        if half > 0.5 {
            return cell;
        }
        let width = half * pair.gear(pair.locked()).pitch();
        let cells = [0, 1].map(|side: usize| {
            let meeting = meetings[side].as_ref();
            let mut cell = kernel.sides[side].cell(pair, &mating, meeting, width, wanted);
            cell.bound += self.cycle.classes.iter().map(|of| of.apart).sum::<f64>();
            cell
        });
        let drift = (cells[0].rate - cells[1].rate).abs() * width;
        if ends.contains(&End::Least) && !kernel.may_jam(pair, &mating, width) {
            let each = [0, 1].map(|side: usize| {
                let floor = meetings[side]
                    .map_or(-0.5 * pair.gear(pair.free()).pitch(), |meeting| {
                        meeting.found.gap
                    });
                let (bound, looked) =
                    kernel.sides[side].above(pair, &mating, &cells[side], floor.max(-0.5));
                cell.effort += u64::from(looked) / A_UNIT;
                bound
            });
            if let [Some(right), Some(left)] = each {
                cell.low = (-right.level - left.level - drift, right.drawn + left.drawn);
            }
        }
        if ends.contains(&End::Greatest) {
            let each = [0, 1].map(|side: usize| {
                let meeting = meetings[side].as_ref()?;
                cells[side].below(&kernel.sides[side].touch(meeting))
            });
            if let [Some(right), Some(left)] = each {
                cell.high = (-right.level - left.level + drift, right.drawn + left.drawn);
            }
        }
        cell
    }
}

impl OutlineKernel<'_> {
    /// Whether teeth may reach the solid body of the mate in a cell of half width `half`, rad.
    fn may_jam(&self, pair: &OutlinePair, mating: &Mating, half: f64) -> bool {
        let reach = pair.gear(pair.locked()).reach();
        // No point turns faster about the locked axis.
        pair.center_distance() - reach < self.solid
            && self.sides[0].reaches_within(pair, mating, self.solid + half * reach)
    }
}

impl<'a> SideKernel<'a> {
    /// The cell of half the width `half`, rad of the locked gear, about `mating`, for bounds that are `width` wide in the end, rad of the free gear.
    fn cell(
        &'a self,
        pair: &OutlinePair,
        mating: &Mating,
        meeting: Option<&Meeting>,
        half: f64,
        width: f64,
    ) -> SideCell<'a> {
        let (_, locked) = self.locked_frame(pair, mating);
        let free_rotation = -self.side.sense() * pair.rotation(pair.free(), mating);
        let ratio = -self.free.gear.pitch() / self.locked.gear.pitch();
        let distance = pair.center_distance();
        // Both points of a contact move equally fast along its normal.
        let rate = meeting.map_or(ratio, |meeting| {
            let ([p, _], n, _) = self.touching(meeting);
            let along = |arm: C| n.re * -arm.im + n.im * arm.re;
            along(p.point - distance) / along(p.point)
        });
        SideCell {
            teeth: [&self.locked, &self.free],
            still: &self.still,
            frames: [
                locked,
                Frame {
                    centre: self.free.displacement,
                    direction: C::ONE,
                },
            ],
            nominal: turn(free_rotation),
            distance,
            half,
            ratio,
            rate: if (rate / ratio).abs() <= FASTEST {
                rate
            } else {
                ratio
            },
            fine: (width / 16.0).max(half * half / 8.0),
            bound: self.locked.gear.bound() + self.free.gear.bound(),
        }
    }

    fn touch(&self, meeting: &Meeting) -> Touching {
        let ([p, q], normal, _) = self.touching(meeting);
        Touching {
            level: meeting.found.gap,
            teeth: meeting.teeth,
            at: [meeting.found.locked, meeting.found.free],
            normals: [
                normal,
                p.normal,
                -q.normal * turn(meeting.nominal + meeting.found.gap),
            ],
        }
    }

    fn above(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
        cell: &SideCell,
        floor: f64,
    ) -> (Option<Bound>, u32) {
        let (rotation, _) = self.locked_frame(pair, mating);
        cell.above(self.facing(pair, mating, rotation, cell.half), floor)
    }
}
