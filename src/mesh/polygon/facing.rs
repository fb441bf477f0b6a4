//! One half tooth of the free gear against one of the locked gear.
//!
//! The free gear starts where, seen from its axis, the two half teeth share no
//! direction, and is turned towards contact. A step of `d/R`, `d` the distance
//! and `R` the greatest radius of the free gear about its axis, cannot pass
//! through anything: no point moves farther than `d`.
//!
//! # The bracket
//!
//! Chords lie within `δ` of their curves, so curves are clear where polygons are
//! `2δ` apart. On the way in, steps of `(d − 2δ)/R` prove every angle passed to be
//! clear of the *curves* too; the last of them, with `d` down to about `2δ`, is the
//! outer end. The inner end: the polygons of involute and tip land are
//! inscribed, so where they touch, the curves touch or overlap already; a
//! fillet's chords stand in front of their hollow curve by up to `δ`. To turn
//! the free gear by `h/X`, `X` the lever of the contact normal about its axis, brings
//! the contact point `h` deeper; `h` is `δ` for each fillet that may take part,
//! and the distance at which the search stopped.

mod place;

use super::far_land::FarLands;
use super::{CutGear, CutHalf, PolygonKernel};
use crate::error::Error;
use crate::gear::{Curve, Side};
use crate::mesh::contact::{Closest, Turning};
use crate::mesh::lost_motion::Contact;
use crate::pair::{Assembly, Member, Pose};
use nalgebra::{Isometry2, UnitComplex};
use place::Place;
use std::f64::consts::PI;
use std::ops::Range;

/// The search ends at this part of the chordal error: it adds a thousandth to the error.
const STOP: f64 = 1e-3;

/// Plain steps before the levers of what is near are looked at, too: a contact takes a few dozen.
const PLAIN_STEPS: usize = 64;

/// Steps after which polygons within both chordal errors of each other are cut finer instead. (They take up to
/// 4 δ/d steps a chord at the distance d.)
const CLOSE_STEPS: usize = 2_000;

/// Steps before a search is given up as a fault. Tips that pass each other take longest, some two a chord of the
/// land: 1e5 chords of 1.9e-12 mm on a land of 2 mm.
const MOST_STEPS: usize = 2_000_000;

/// Each re-cut is this much finer: some thirty chords over the stretch that may still touch (tuned:
/// 1e-2 takes more re-cuts, 1e-4 more chords; both are slower).
const FINER: f64 = 1e-3;

/// A stretch of more chords than this is cut ten times finer only: curves that nestle against each other,
/// or a normal nearly through the axis, leave long ones, and all pairs of their chords are gone through.
const LONG: usize = 32;

/// A pair of half teeth of one side. The opening `u`, rad, is how far the free gear is turned
/// from its nominal rotation in the sense away from contact: of two pairs, the one that touches at the greater opening is tighter.
#[derive(Clone, Copy)]
pub(super) struct Facing<'a> {
    assembly: &'a Assembly,
    pose: &'a Pose,
    side: Side,
    locked_tooth: u32,
    free_tooth: u32,
    locked: &'a CutHalf,
    free: &'a CutHalf,
    locked_frame: Isometry2<f64>,
}

/// Where a pair touches.
#[derive(Clone, Copy)]
pub(super) struct Found {
    /// The curves are clear of each other at every opening from the start down to this one.
    pub clear: f64,
    /// The polygons touch, as near as the search goes.
    pub touching: f64,
    /// The curves touch or overlap.
    pub closed: f64,
    place: Place,
}

/// How turning in ended.
enum Turned {
    Touching(Found),
    /// The polygons passed each other within both chordal errors.
    Near,
    /// The curves passed each other clear.
    Clear,
}

impl<'a> Facing<'a> {
    /// The locked tooth `steps` places counter-clockwise of the mating's, and the free tooth that faces its `side`,
    /// with the whole of those tip lands that `far` has.
    pub fn new(
        kernel: &PolygonKernel<'a>,
        pose: &'a Pose,
        side: Side,
        steps: i64,
        far: &'a FarLands,
    ) -> Facing<'a> {
        let assembly = kernel.assembly;
        let locked = assembly.locked();
        let [locked_tooth, free_tooth] = facing_teeth(assembly, pose, side, steps);
        let half =
            |far: &'a Option<CutHalf>, cut: &'a CutGear| far.as_ref().unwrap_or(cut.half(side));
        Facing {
            assembly,
            pose,
            side,
            locked_tooth,
            free_tooth,
            locked: half(&far.locked, kernel.locked),
            free: half(&far.free, kernel.free),
            locked_frame: frame(assembly, locked, pose.locked_rotation(), side, locked_tooth),
        }
    }

    /// Turns the free gear in until the polygons touch; `None` when the curves pass each other clear.
    ///
    /// Polygons that pass within both chordal errors prove nothing: whole half teeth are cut finer, down to `finest`.
    pub fn search(&self, finest: f64) -> Result<Option<Found>, Error> {
        let (start, end) = self.shared_directions();
        let mut cut: Option<[CutHalf; 2]> = None;
        loop {
            let on = self.on(&cut);
            match on.turn_in(start, end, finest)? {
                Turned::Touching(found) => return Ok(Some(found)),
                Turned::Near if on.chord() > finest => {
                    let whole = [on.locked, on.free].map(|half| 0..half.polygon.segments().len());
                    cut = Some(on.recut(whole, (on.chord() * FINER).max(finest)));
                }
                Turned::Near | Turned::Clear => return Ok(None),
            }
        }
    }

    /// Cuts the stretches that may still touch finer and searches again, until chords are within `finest`.
    ///
    /// Between the ends of the bracket no point moves farther than `R` times its width. What is farther
    /// from the other polygon than that and both chordal errors touches nothing in the bracket: only the rest is cut again.
    pub fn refine(&self, mut found: Found, finest: f64) -> Result<Found, Error> {
        let mut chord = self.chord();
        let mut cut: Option<[CutHalf; 2]> = None;
        while chord > finest {
            let coarse = self.on(&cut);
            let width = (found.clear - found.touching).max(found.touching - found.closed);
            let margin = 2.0 * chord + self.reach() * width;
            let near = coarse.near(found.touching, margin);
            let near = near.ok_or_else(|| self.lost(NOTHING_NEAR))?;
            let long = near.iter().any(|stretch| stretch.len() > LONG);
            chord = (chord * if long { 0.1 } else { FINER }).max(finest);
            cut = Some(coarse.recut(near, chord));
            // Inscribed polygons touch a little after their curves.
            let end = found.closed - (found.clear - found.closed);
            let again = self.on(&cut).turn_in(found.clear, end, chord)?;
            let Turned::Touching(touching) = again else {
                return Err(self.lost(PASSED));
            };
            found = touching;
        }
        Ok(found)
    }

    /// The same pair, on polygons cut again.
    pub fn on<'b>(&'b self, cut: &'b Option<[CutHalf; 2]>) -> Facing<'b> {
        match cut {
            None => *self,
            Some([locked, free]) => Facing {
                locked,
                free,
                ..*self
            },
        }
    }

    /// The stretches of chords within `margin` of the other half tooth at `opening`; `None` when nothing is.
    pub fn near(&self, opening: f64, margin: f64) -> Option<[Range<usize>; 2]> {
        let pose = self.locked_frame.inverse() * self.free_frame(opening);
        self.locked.shape.near(&self.free.shape, &pose, margin)
    }

    /// The curves behind stretches of chords, cut again within `chord`.
    pub fn recut(&self, [locked, free]: [Range<usize>; 2], chord: f64) -> [CutHalf; 2] {
        let again = |half: &CutHalf, member, stretch| {
            let gear = self.assembly.gear(member).gear();
            CutHalf::new(half.polygon.recut(gear, stretch, chord))
        };
        [
            again(self.locked, self.assembly.locked(), locked),
            again(self.free, self.assembly.free(), free),
        ]
    }

    /// Chordal error of the polygons, mm.
    pub fn chord(&self) -> f64 {
        self.locked.polygon.chord()
    }

    /// Steps from the opening `start`, where nothing touches, until the polygons do, or to `end`.
    fn turn_in(&self, start: f64, end: f64, finest: f64) -> Result<Turned, Error> {
        let chord = self.chord();
        // Below its own rounding a distance says nothing.
        let stop = (STOP * chord).max(self.rounding() / 8.0);
        let to_locked = self.locked_frame.inverse();
        let mut opening = start;
        let mut hint = [0, 0];
        let mut clear = None;
        let mut close_steps = 0;
        for count in 0..MOST_STEPS {
            let pose = to_locked * self.free_frame(opening);
            let closest = self.locked.shape.closest(&self.free.shape, &pose, hint);
            hint = closest.segments;
            // Steps of d − 2δ never arrive at 2δ: 5 % above it is near enough.
            if clear.is_none() && closest.distance <= 2.1 * chord {
                clear = Some(opening);
            }
            if closest.distance <= stop {
                let clear = clear.unwrap_or(opening);
                return Ok(Turned::Touching(self.bracket(clear, opening, &closest)));
            }
            let margin = if clear.is_none() { 2.0 * chord } else { 0.0 };
            let plain = (closest.distance - margin) / self.reach();
            opening -= match count < PLAIN_STEPS {
                true => plain,
                false => self.lever_step(&pose, plain, margin),
            };
            close_steps += usize::from(clear.is_some() && count >= PLAIN_STEPS);
            let weary = close_steps > CLOSE_STEPS && chord > finest;
            if opening < end || weary {
                return Ok(match clear {
                    Some(_) => Turned::Near,
                    None => Turned::Clear,
                });
            }
        }
        Err(self.lost(ENDLESS))
    }

    /// A safe step that sees in which direction the nearest chords would move, at least `plain`.
    ///
    /// Tips that graze each other move along each other: their distance is far less than what they can turn.
    /// Chords farther than two of the longest (on a curve of the radius `R`) bound the step by their distance.
    fn lever_step(&self, pose: &Isometry2<f64>, plain: f64, margin: f64) -> f64 {
        let (chord, reach) = (self.chord(), self.reach());
        let far = 2.0 * (8.0 * reach * chord).sqrt();
        let most = (far - margin) / reach;
        if most <= plain {
            return plain;
        }
        let free = self.assembly.free();
        let axis = self
            .locked_frame
            .inverse_transform_point(&self.assembly.axis(free));
        let turning = Turning {
            axis,
            // A smaller opening turns the free gear in the sense of its side.
            sense: self.side.sense(),
            reach,
            chord,
            margin,
        };
        self.locked
            .shape
            .safe_turn(&self.free.shape, pose, &turning, most)
            .max(plain)
    }

    /// Greatest radius `R` of the free gear about its axis, mm.
    pub fn reach(&self) -> f64 {
        self.assembly.gear(self.assembly.free()).reach()
    }

    /// Rounding of a distance, mm: coordinates up to the centre distance, and radii turned by angles
    /// of the size of both rotations, some dozens of operations on each.
    pub fn rounding(&self) -> f64 {
        let turned = self.pose.locked_rotation().abs() + self.pose.free_rotation().abs();
        64.0 * f64::EPSILON * (self.assembly.center_distance() + self.reach() * turned)
    }

    /// The opening above which, and the one below which, the half teeth share no direction seen from the free axis.
    fn shared_directions(&self) -> (f64, f64) {
        let free = self.assembly.free();
        let axis = self.assembly.axis(free);
        let from_mate = UnitComplex::new(-self.assembly.mate_direction(free));
        let spread = |frame: &Isometry2<f64>, half: &CutHalf| {
            let directions = half.polygon.points().iter().map(|point| {
                let seen = from_mate * (frame * point - axis);
                -self.side.sense() * seen.y.atan2(seen.x)
            });
            directions.fold(
                (f64::INFINITY, f64::NEG_INFINITY),
                |(least, most), angle| (least.min(angle), most.max(angle)),
            )
        };
        let locked = spread(&self.locked_frame, self.locked);
        let free = spread(&self.free_frame(0.0), self.free);
        (locked.1 - free.0, locked.0 - free.1)
    }

    fn free_frame(&self, opening: f64) -> Isometry2<f64> {
        let rotation = self.pose.free_rotation() - self.side.sense() * opening;
        let free = self.assembly.free();
        frame(self.assembly, free, rotation, self.side, self.free_tooth)
    }

    fn bracket(&self, clear: f64, touching: f64, closest: &Closest) -> Found {
        let place = self.place(touching, closest);
        let arm = place.point - self.assembly.axis(self.assembly.free());
        // Half a turn is as far as a bracket means anything.
        let turned = |depth: f64| (depth / arm.perp(&place.normal).abs()).min(PI);
        let halves = [self.locked, self.free];
        let hollow = (0..2)
            .filter(|&i| near_fillet(halves[i], closest.segments[i] as usize))
            .count();
        let rounding = self.rounding();
        let depth = hollow as f64 * self.chord() + closest.distance + rounding;
        Found {
            clear: clear + turned(rounding),
            touching,
            closed: touching - turned(depth),
            place,
        }
    }

    /// The contact by name: teeth, curves, radii, point and normal, with the side's `rotation` and `error`.
    pub fn contact(&self, found: &Found, rotation: f64, error: f64) -> Contact {
        let Place {
            locked,
            free,
            point,
            normal,
        } = found.place;
        let (wheel, pinion, normal) = match self.assembly.locked() {
            Member::Wheel => (locked, free, normal),
            Member::Pinion => (free, locked, -normal),
        };
        Contact {
            rotation,
            error,
            wheel,
            pinion,
            point,
            normal,
        }
    }

    fn lost(&self, reason: &'static str) -> Error {
        let (wheel_tooth, pinion_tooth) = match self.assembly.locked() {
            Member::Wheel => (self.locked_tooth, self.free_tooth),
            Member::Pinion => (self.free_tooth, self.locked_tooth),
        };
        Error::ContactLost {
            wheel_tooth,
            pinion_tooth,
            flank: self.side.name(),
            locked_rotation_rad: self.pose.locked_rotation(),
            reason,
        }
    }
}

const ENDLESS: &str = "the safe steps did not come to an end";
const NOTHING_NEAR: &str = "no stretch of the outlines is left that could touch";
const PASSED: &str = "finer polygons passed the contact that coarser ones had found";

/// The locked tooth `steps` places counter-clockwise of the mating's, and the free tooth that faces its `side`.
pub(super) fn facing_teeth(assembly: &Assembly, pose: &Pose, side: Side, steps: i64) -> [u32; 2] {
    let locked = assembly.locked();
    let mating = pose.mating().tooth(locked);
    [
        assembly.gear(locked).counter_clockwise(mating, steps),
        pose.facing_tooth(assembly, side, steps),
    ]
}

/// Frame in the picture of the half tooth of `member` on `side` of `tooth`, the gear turned to `rotation`.
fn frame(
    assembly: &Assembly,
    member: Member,
    rotation: f64,
    side: Side,
    tooth: u32,
) -> Isometry2<f64> {
    let gear = assembly.gear(member);
    let tooth_1 = assembly.mate_direction(member) + rotation;
    let centre = assembly.axis(member) + gear.displacement(tooth_1);
    let turn = gear.tooth_angle(f64::from(tooth)) + gear.flank_offset(side, tooth);
    Isometry2::new(centre.coords, tooth_1 + turn)
}

/// Whether the chord or a neighbour stands for a fillet.
fn near_fillet(half: &CutHalf, segment: usize) -> bool {
    let segments = half.polygon.segments();
    let near = segment.saturating_sub(1)..(segment + 2).min(segments.len());
    segments[near]
        .iter()
        .any(|segment| segment.curve == Curve::Fillet)
}
