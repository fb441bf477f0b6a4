//! Lost motion of outlines: any curves, by branch and bound over all pairs of pieces that can meet.
//!
//! The frame is that of the exact method ([`super::ExactKernel`]): the free gear's axis at the origin, the locked one's at `(a, 0)`, the
//! left side mirrored. The contact of a side is the greatest gap of its facing half teeth. The whole tip of a half tooth counts on both
//! sides. Both methods search pairs of curves in `gap`, where rectangles around runs of pieces rule out most. Separate polygons check each
//! pose (`certificate`).
//!
//! A curve only needs points, normals, and bounds of both over a piece.

mod cell;
mod certificate;
mod discs;
mod extremes;
mod halves;
mod teeth;

use super::effort::Effort;
use super::gap::{
    C, CurveContact, CurvePoint, Origin, PathSearch, RunContent, common_normal, rounding, turn,
};
use super::lost_motion::{Contact, ContactInFrame, LostMotion, ToothPlace, Touch};
use super::outline_contact::{ContactNotConfirmed, SearchExhausted};
use crate::gear::Side;
use crate::outline::OutlinePair;
use crate::pair::{Mating, Member, overlap_half_angle};
use certificate::{CutSide, PosedHalves};
pub(crate) use extremes::OutlineCycle;
use halves::{FreeHalf, LockedHalf};
use std::f64::consts::TAU;
use teeth::{Frame, SideTeeth, nearest};

/// Lost motion of one pair of outlines.
#[derive(Debug)]
pub struct OutlineKernel<'a> {
    pair: &'a OutlinePair,
    sides: [SideKernel<'a>; 2],
    /// Least radius of the free outline about the free axis, mm: inside it the free gear is solid.
    solid: f64,
}

/// One side, the left one mirrored.
#[derive(Debug)]
struct SideKernel<'a> {
    side: Side,
    locked: SideTeeth<'a>,
    free: SideTeeth<'a>,
    /// The free half teeth, by number, at rotation 0.
    free_halves: Vec<FreeHalf<'a>>,
}

impl<'a> OutlineKernel<'a> {
    /// The kernel of `pair`.
    pub fn new(pair: &'a OutlinePair) -> OutlineKernel<'a> {
        let sides = Side::BOTH.map(|side| {
            let teeth = |member| SideTeeth::new(pair.gear(member), side);
            let free = teeth(pair.free());
            let halves = (1..=free.gear.teeth()).map(|tooth| FreeHalf::new(&free, tooth));
            SideKernel {
                side,
                locked: teeth(pair.locked()),
                free_halves: halves.collect(),
                free,
            }
        });
        let free = pair.gear(pair.free());
        OutlineKernel {
            solid: free.root_radius() - free.eccentricity(),
            pair,
            sides,
        }
    }

    /// Right- and left-flank contact at `mating`.
    ///
    /// # Errors
    /// [`SearchExhausted`]. No pair of curves is ever omitted.
    pub fn lost_motion(&self, mating: &Mating) -> Result<LostMotion, SearchExhausted> {
        self.lost_motion_at(self.pair, mating)
    }

    /// The lost motion from every pair of pieces, without rectangles. It checks [`OutlineKernel::lost_motion`] and is a hundred times
    /// slower.
    ///
    /// # Errors
    /// As [`OutlineKernel::lost_motion`].
    pub fn lost_motion_by_search(&self, mating: &Mating) -> Result<LostMotion, SearchExhausted> {
        self.found(self.pair, mating, false)
    }

    /// The lost motion of `pair`: these gears, perhaps at another centre distance.
    ///
    /// # Errors
    /// As [`OutlineKernel::lost_motion`].
    pub(crate) fn lost_motion_at(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
    ) -> Result<LostMotion, SearchExhausted> {
        self.found(pair, mating, true)
    }

    fn found(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
        prunes: bool,
    ) -> Result<LostMotion, SearchExhausted> {
        let effort = if prunes {
            Effort::of_pose()
        } else {
            // Each side has its own limit of nodes.
            Effort::endless()
        };
        let [right, left] = &self.sides;
        let right = right.side_contact(pair, mating, prunes, &effort)?;
        let left = left.side_contact(pair, mating, prunes, &effort)?;
        Ok(self.lost_motion_of(pair, mating, [right.as_ref(), left.as_ref()]))
    }

    /// The lost motion between the contacts of both sides.
    fn lost_motion_of(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
        contacts: [Option<&SideContact>; 2],
    ) -> LostMotion {
        let contact = |side: usize| Some(self.sides[side].report(pair, contacts[side]?));
        let (right, left) = (contact(0), contact(1));
        let overlap = right
            .zip(left)
            .map_or(0.0, |(right, left)| right.rotation - left.rotation);
        let free = pair.gear(pair.free());
        let deep = || self.sides[0].reaches_within(pair, mating, self.solid);
        LostMotion {
            right,
            left,
            solid: overlap >= free.pitch() || deep(),
        }
    }
}

/// The contact of a side: that of the greatest gap.
#[derive(Debug, Clone, Copy)]
struct SideContact {
    found: CurveContact,
    /// Locked and free tooth.
    teeth: [u32; 2],
    /// Frame of the locked gear.
    frame: Frame,
    /// The free gear's nominal rotation, rad.
    nominal: f64,
}

/// Greatest uncertainty of a rotation, as a part of a pitch, that is checked. With a wider one other teeth, or none, may be there.
const NARROW: f64 = 1e-2;

/// Confirms by polygons the contacts that a kernel finds.
#[derive(Debug)]
pub struct OutlineCertifier<'a> {
    kernel: &'a OutlineKernel<'a>,
    cut: [CutSide; 2],
}

impl<'a> OutlineCertifier<'a> {
    /// The certifier of the gears of `kernel`.
    pub fn new(kernel: &'a OutlineKernel<'a>) -> OutlineCertifier<'a> {
        let sides = kernel.sides.each_ref();
        OutlineCertifier {
            cut: sides.map(|side| CutSide::new([&side.locked, &side.free])),
            kernel,
        }
    }

    /// Confirms both contacts of `found` at `mating`. Two kinds of contact are not checked: the rotations of a jammed pose, which have no
    /// meaning, and contacts with a bound wider than a hundredth of a pitch.
    ///
    /// # Errors
    /// [`ContactNotConfirmed`]: something touches before, or nothing there.
    pub fn check(&self, mating: &Mating, found: &LostMotion) -> Result<(), ContactNotConfirmed> {
        if found.solid {
            return Ok(());
        }
        let contacts = [found.right.as_ref(), found.left.as_ref()];
        let sides = self.kernel.sides.iter().zip(&self.cut).zip(contacts);
        for ((side, cut), contact) in sides {
            let seen = side.confirm(self.kernel.pair, cut, mating, contact);
            seen.map_err(|reason| ContactNotConfirmed {
                flank: side.side.name(),
                reason,
            })?;
        }
        Ok(())
    }
}

impl SideKernel<'_> {
    fn confirm(
        &self,
        pair: &OutlinePair,
        cut: &CutSide,
        mating: &Mating,
        contact: Option<&Contact>,
    ) -> Result<(), &'static str> {
        let (rotation, locked) = self.locked_frame(pair, mating);
        let pairs = self.facing_pairs(pair, mating, rotation, 0.0);
        let witness = PosedHalves {
            teeth: [&self.locked, &self.free],
            cut,
            center_distance: pair.center_distance(),
            locked,
            pairs: pairs.collect(),
        };
        let Some(contact) = contact else {
            return witness.check_no_touch();
        };
        let lever = contact.lever(pair.axis(pair.free()));
        let turn_of_finest = contact.error + witness.turn_of_finest(lever);
        if !(turn_of_finest <= NARROW * self.free.gear.pitch()) {
            return Ok(());
        }
        let there = -self.side.sense() * contact.rotation;
        witness.touches(there + turn_of_finest, there - turn_of_finest)
    }

    /// Half teeth that face each other within reach at a rotation of the locked gear in this frame `± half`, locked and free, the likeliest to
    /// touch first.
    fn facing_pairs(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
        rotation: f64,
        half: f64,
    ) -> impl Iterator<Item = [u32; 2]> {
        let (locked_tooth, free_tooth) = (mating.tooth(pair.locked()), mating.tooth(pair.free()));
        let beyond = i64::from(mating.flank != self.side);
        let steps = self.steps(pair, mating, rotation, half);
        // From the middle outwards: most contacts are there, and they rule out the rest.
        let middle = (steps.start() + steps.end()).div_euclid(2);
        let farthest = (steps.end() - middle).max(middle - steps.start());
        let outwards = (0..=farthest).flat_map(move |away| [middle + away, middle - away]);
        let from_middle = outwards.skip(1).filter(move |step| steps.contains(step));
        from_middle.map(move |step| {
            [
                self.locked.beside(locked_tooth, step),
                self.free.beside(free_tooth, beyond - step),
            ]
        })
    }

    /// Rotation of the locked gear, in this frame, and its frame.
    fn locked_frame(&self, pair: &OutlinePair, mating: &Mating) -> (f64, Frame) {
        let rotation = -self.side.sense() * pair.rotation(pair.locked(), mating);
        let turned = turn(rotation);
        let frame = Frame {
            centre: C::from(pair.center_distance()) - turned * self.locked.displacement,
            direction: -turned,
        };
        (rotation, frame)
    }

    /// Steps, counter-clockwise of the mating's locked tooth, whose teeth can reach the free gear.
    fn steps(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
        rotation: f64,
        half: f64,
    ) -> std::ops::RangeInclusive<i64> {
        let (gear, mate) = (self.locked.gear, self.free.gear);
        let pitch = gear.pitch();
        let tooth = f64::from(mating.tooth(pair.locked()));
        let there = rotation - self.side.sense() * gear.tooth_angle(tooth);
        let there = there - TAU * (there / TAU).round();
        let lens =
            overlap_half_angle(gear.reach(), mate.reach(), pair.center_distance()).unwrap_or(0.0);
        let [least, greatest] = self.locked.around;
        // Never more than once round.
        let most = (i64::from(gear.teeth()) - 1) / 2;
        let window = |there: f64| {
            let first = ((-lens - greatest - there) / pitch).ceil() as i64;
            let last = ((lens - least - there) / pitch).floor() as i64;
            let middle = (-there / pitch).round() as i64;
            (first.max(middle - most), last.min(middle + most))
        };
        window(there + half).0..=window(there - half).1
    }

    fn side_contact(
        &self,
        pair: &OutlinePair,
        mating: &Mating,
        prunes: bool,
        effort: &Effort,
    ) -> Result<Option<SideContact>, SearchExhausted> {
        let (rotation, locked_frame) = self.locked_frame(pair, mating);
        let free_rotation = -self.side.sense() * pair.rotation(pair.free(), mating);
        // Gaps count from the nominal rotation.
        let origin = Origin {
            direction: turn(-free_rotation),
            about: 0.0,
        };
        let size = pair.center_distance() + self.locked.gear.reach() + self.free.gear.reach();
        let search = PathSearch::new(origin, size, f64::NEG_INFINITY, 0.0, effort.left());
        let mut search = if prunes {
            search
        } else {
            search.without_rectangles()
        };
        let most = search.nodes_left();
        let mut best: Option<(CurveContact, [u32; 2])> = None;
        for teeth in self.facing_pairs(pair, mating, rotation, 0.0) {
            let [locked_tooth, free_tooth] = teeth;
            let locked = LockedHalf::new(&self.locked, locked_tooth, locked_frame);
            let found = search.greatest(&locked, &self.free_halves[free_tooth as usize - 1]);
            let found = found.map_err(|_| self.search_exhausted(pair, teeth))?;
            best = found.map(|meeting| (meeting, teeth)).or(best);
        }
        effort.spend(most - search.nodes_left());
        Ok(best.map(|(found, teeth)| SideContact {
            found,
            teeth,
            frame: locked_frame,
            nominal: free_rotation,
        }))
    }

    fn search_exhausted(&self, pair: &OutlinePair, [locked, free]: [u32; 2]) -> SearchExhausted {
        let (wheel_tooth, pinion_tooth) = match pair.locked() {
            Member::Wheel => (locked, free),
            Member::Pinion => (free, locked),
        };
        SearchExhausted {
            wheel_tooth,
            pinion_tooth,
            flank: self.side.name(),
        }
    }

    /// The contact in the picture.
    fn report(&self, pair: &OutlinePair, meeting: &SideContact) -> Contact {
        let SideContact { found, nominal, .. } = meeting;
        let [locked, free] = meeting.teeth;
        let halves = [self.locked.half(locked), self.free.half(free)];
        let at = [found.locked, found.free];
        let pieces = [0, 1].map(|k: usize| &halves[k].pieces[at[k].0]);
        let ([p, _], normal, slope) = self.touching(meeting);
        let touch = |k: usize, tooth: u32| {
            let radius = pieces[k].point(at[k].1).norm();
            let region = match radius {
                _ if radius >= halves[k].tip_limit => ToothPlace::Tip,
                _ if radius <= halves[k].root_limit => ToothPlace::Root,
                _ => ToothPlace::Flank,
            };
            Touch {
                tooth,
                curve: region,
                radius,
            }
        };
        let radius = p.point.norm();
        let rounded = [0, 1].map(|k: usize| pieces[k].curve.rounded_lengths(at[k].1));
        let reach = self.locked.gear.reach() + self.free.gear.reach();
        let size = pair.center_distance() + 2.0 * reach + rounded[0] + rounded[1];
        let drawn = self.locked.gear.bound() + self.free.gear.bound();
        let drawn = drawn * (1.0 + slope.abs()) / radius;
        ContactInFrame {
            side: self.side,
            free: pair.free(),
            center_distance: pair.center_distance(),
            rotation: nominal + found.gap,
            error: rounding(size, radius, slope) + found.slack + drawn,
            locked: touch(0, locked),
            mated: touch(1, free),
            point: p.point,
            normal,
        }
        .contact()
    }

    /// Where both curves of a meeting are, the free one still at rotation 0; the normal out of the locked metal and the slope by which a
    /// shift of a curve turns the gap.
    fn touching(&self, meeting: &SideContact) -> ([CurvePoint; 2], C, f64) {
        let SideContact { found, nominal, .. } = meeting;
        let [locked, free] = meeting.teeth;
        let halves = [self.locked.half(locked), self.free.half(free)];
        let at = [found.locked, found.free];
        let pieces = [0, 1].map(|k: usize| &halves[k].pieces[at[k].0]);
        let frames = [meeting.frame, self.free.still()];
        let [p, q] = [0, 1].map(|k: usize| frames[k].placed(pieces[k]).at(at[k].1));
        let corners = [0, 1].map(|k: usize| pieces[k].is_corner(at[k].1));
        let turned = turn(found.gap + nominal);
        let (normal, slope) = common_normal(&p, &q, corners, || -q.normal * turned);
        ([p, q], normal, slope)
    }

    /// Whether a point of the locked outline is within `radius`, mm, of the free axis.
    fn reaches_within(&self, pair: &OutlinePair, mating: &Mating, radius: f64) -> bool {
        let (rotation, frame) = self.locked_frame(pair, mating);
        let tooth = mating.tooth(pair.locked());
        let halves = self
            .steps(pair, mating, rotation, 0.0)
            .map(|step| self.locked.beside(tooth, step));
        halves.into_iter().any(|tooth| {
            let boxes = self.locked.boxes(tooth);
            let pieces = &self.locked.half(tooth).pieces;
            let mut open: Vec<usize> = boxes.whole().into_iter().collect();
            while let Some(run) = open.pop() {
                let placed = boxes.shape(run).placed(frame.centre, frame.direction);
                if placed.squares().0 >= radius * radius {
                    continue;
                }
                match boxes.inside(run) {
                    RunContent::Runs(runs) => open.extend(runs),
                    RunContent::Pieces([name, _]) => {
                        let (low, high) = pieces[name].range();
                        if nearest(&frame.placed(&pieces[name]), low, high, radius) {
                            return true;
                        }
                    }
                }
            }
            false
        })
    }
}
