//! One side of a pair: which half teeth face each other, and where a pose puts them.
//!
//! The frame: origin on the free gear's axis, the locked gear's axis at
//! `(a, 0)`; for a free pinion that is the picture turned by half a turn. The left
//! side is mirrored in the line of centres. So there is one problem only: right-hand
//! halves on both gears, contact where the free gear can turn no farther clockwise,
//! that is, at the *greatest* gap.
//!
//! *Steps* count places counter-clockwise from the locked tooth nearest to the line of
//! centres; the free tooth facing it lies as many steps clockwise of its own.

use super::branch::{Hit, Placed};
use super::shape::{C, turn};
use super::teeth::{Teeth, reduced};
use crate::gear::{AsBuilt, Side};
use crate::pair::{Assembly, Pose};
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// Pairs whose gaps differ by less than this at the free gear's base circle touch together.
///
/// A thousand times the rounding of ordinary gears, and below what any result claims.
const TIE_MM: f64 = 1e-9;

/// Of pairs that tie, contacts whose distances from the pitch point differ by less count as
/// equally near: far above rounding, far below a base pitch.
const EQUALLY_NEAR_MM: f64 = 1e-6;

/// Both gears' half teeth of one side.
#[derive(Debug, Clone)]
pub(super) struct Facing {
    pub side: Side,
    pub locked: Teeth,
    pub free: Teeth,
    /// `a`.
    pub distance: f64,
    /// Half teeth whose centre line lies within these angles of the line of centres can reach the mate.
    window: Option<(f64, f64)>,
}

impl Facing {
    pub fn new(assembly: &Assembly, side: Side) -> Facing {
        let (locked, free) = (
            assembly.gear(assembly.locked()),
            assembly.gear(assembly.free()),
        );
        let mut facing = Facing {
            side,
            locked: Teeth::new(locked, side),
            free: Teeth::new(free, side),
            distance: assembly.center_distance(),
            window: None,
        };
        facing.window = lens(locked, free, facing.distance).map(|half| {
            let (least, most) = facing.locked.extremes;
            (-half - most, half + facing.locked.pitch / 2.0 - least)
        });
        facing
    }

    /// Puts the teeth where `pose` has them.
    pub fn stand(&self, pose: &Pose, locked_tooth: u32, free_tooth: u32) -> Stand<'_> {
        let mirror = -self.side.sense();
        let rotation = reduced(mirror * pose.locked_rotation());
        // Whole turns matter: a free gear with another number of teeth faces it with another tooth
        // each turn. The raw rotation counts them.
        let pitch = self.locked.pitch;
        let raw = mirror * pose.locked_rotation() + self.locked.pitches_to(locked_tooth) * pitch;
        let steps = -(raw / pitch).round() as i64;
        let locked_place = self.locked.place(locked_tooth, steps);
        // Facing place, in the mirrored frame: see `Pose::facing_tooth`.
        let beyond = i64::from(pose.mating().flank != self.side);
        let free_place = self.free.place(free_tooth, beyond - steps);
        let ahead = reduced(rotation + self.locked.angle(locked_place));
        let turned = turn(rotation);
        Stand {
            facing: self,
            turned,
            centre: C::from(self.distance) - turned * self.locked.displacement,
            ahead,
            locked_place,
            free_place,
            origin: turn(self.free.angle(free_place)),
        }
    }

    /// Tie tolerance, rad.
    pub fn tie(&self) -> f64 {
        TIE_MM / self.free.shape.base + 2.0 * self.rounding(self.free.shape.base, 1.0)
    }

    /// Bound on the rounding of a gap, rad, whose contact lies at `radius` from the free axis and
    /// whose curves have the slope `σ`.
    ///
    /// Positions come from a table direction (angle and sine and cosine: 6 ε), the locked
    /// rotation (reduction, sine and cosine: 4 ε), the curve itself (4 ε) and sums: within
    /// 16 ε of the largest length in them. Off by `δ` a point turns the gap by at most
    /// `(δ/ρ)(1 + |σ|)`. Angles up to π are added four times: 16 ε.
    pub fn rounding(&self, radius: f64, slope: f64) -> f64 {
        let size = self.distance + self.locked.shape.tip_radius + self.free.shape.tip_radius;
        f64::EPSILON * (16.0 * size / radius * (1.0 + slope.abs()) + 16.0)
    }
}

/// Half the angle at the locked axis within which the locked gear's teeth can reach into the free
/// gear's tip circle, both about their rotation axes; `None` when they cannot.
fn lens(locked: &AsBuilt, free: &AsBuilt, distance: f64) -> Option<f64> {
    let (ours, theirs) = (locked.reach(), free.reach());
    if ours + theirs < distance {
        return None;
    }
    // The nearest point of the free gear's circle; the rest of the lens lies farther out.
    let nearest = distance - theirs;
    if nearest <= locked.eccentricity() {
        return Some(PI);
    }
    let tangent = distance * distance - theirs * theirs;
    let half = if ours * ours >= tangent {
        (theirs / distance).asin()
    } else {
        ((ours * ours + tangent) / (2.0 * distance * ours))
            .min(1.0)
            .acos()
    };
    Some(half + (locked.eccentricity() / nearest).asin())
}

/// The half teeth of one side at one pose.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stand<'a> {
    pub facing: &'a Facing,
    /// Rotation of the locked gear.
    pub turned: C,
    /// Centre of the locked outline.
    pub centre: C,
    /// Angle of the locked tooth of step 0 from the line of centres, rad.
    pub ahead: f64,
    locked_place: usize,
    free_place: usize,
    /// Direction of the free tooth of step 0 at rotation 0.
    pub origin: C,
}

impl<'a> Stand<'a> {
    /// Steps whose locked half tooth can reach the free gear; empty when none can.
    pub fn steps(&self) -> RangeInclusive<i64> {
        let Some((low, high)) = self.facing.window else {
            #[allow(clippy::reversed_empty_ranges)]
            return 1..=0;
        };
        let pitch = self.facing.locked.pitch;
        // Never more than once round.
        let half = (self.facing.locked.count() - 1) / 2;
        let first = ((low - self.ahead) / pitch).ceil() as i64;
        let last = ((high - self.ahead) / pitch).floor() as i64;
        first.max(-half)..=last.min(half + 1)
    }

    /// Places of the locked and the free tooth of a step.
    pub fn places(&self, step: i64) -> (usize, usize) {
        (
            self.facing.locked.beside(self.locked_place, step),
            self.facing.free.beside(self.free_place, -step),
        )
    }

    /// The locked half tooth of a step.
    pub fn locked(&self, step: i64) -> Placed<'a> {
        let teeth = &self.facing.locked;
        let place = teeth.beside(self.locked_place, step);
        Placed {
            shape: &teeth.shape,
            centre: self.centre,
            direction: -self.turned * teeth.direction(place),
        }
    }

    /// The free half tooth of a step, at rotation 0.
    pub fn free(&self, step: i64) -> Placed<'a> {
        let teeth = &self.facing.free;
        let place = teeth.beside(self.free_place, -step);
        Placed {
            shape: &teeth.shape,
            centre: teeth.displacement,
            direction: teeth.direction(place),
        }
    }

    /// The free gear's rotation at a gap, in this (mirrored) frame.
    pub fn rotation(&self, gap: f64) -> f64 {
        gap - self.facing.free.angle(self.free_place)
    }

    /// Of hits that tie with the greatest gap, the one to name: nearest to the operating pitch
    /// point, of equally near ones the first counter-clockwise of the locked gear as this frame sees it.
    pub fn choose(&self, hits: &[(i64, Hit)]) -> Option<Touching> {
        let greatest = hits.iter().map(|(_, hit)| hit.gap).reduce(f64::max)?;
        let level = greatest - self.facing.tie();
        let (base, mate) = (self.facing.free.shape.base, self.facing.locked.shape.base);
        let pitch_point = C::from(self.facing.distance * base / (base + mate));
        let mut chosen: Option<(f64, Touching)> = None;
        for &(step, hit) in hits.iter().filter(|(_, hit)| hit.gap >= level) {
            let point = self.locked(step).at(hit.locked.0, hit.locked.1).point;
            let away = (point - pitch_point).norm();
            if chosen.is_none_or(|(least, _)| away < least - EQUALLY_NEAR_MM) {
                let touching = Touching {
                    step,
                    hit,
                    greatest,
                };
                chosen = Some((away, touching));
            }
        }
        chosen.map(|(_, touching)| touching)
    }
}

/// The pair that touches, and the greatest gap of all pairs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touching {
    pub step: i64,
    pub hit: Hit,
    pub greatest: f64,
}
