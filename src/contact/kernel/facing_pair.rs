//! Two facing half teeth with their tops, and their extents along a direction.

use super::convex::{Convex, Support};
use super::facing_halves::{Apart, FacingHalves};
use super::hollow::Hollow;
use super::proof::Reason;
use crate::contact::exact::PlacedHalf;
use crate::contact::gap::{C, dot};

/// The half teeth of one step, and their tops.
pub(super) struct FacingPair<'a> {
    pub step: i64,
    pub at: FacingHalves<'a>,
    pub placed: [PlacedHalf<'a>; 2],
    pub tops: [Convex<'a>; 2],
}

impl<'a> FacingPair<'a> {
    /// Greatest radius of the free tooth about its axis, mm: the whole tooth turns within its top's disc.
    pub fn farthest_of_free(&self) -> f64 {
        self.tops[1].farthest(self.at.centres[1] * self.at.directions[1].conj())
    }

    /// The pair with the far half of the locked tooth instead of the near one.
    pub fn far_at(&self) -> FacingHalves<'a> {
        let direction = self.placed[0].far_direction();
        FacingHalves {
            angles: [direction.im.atan2(direction.re), self.at.angles[1]],
            directions: [direction, self.at.directions[1]],
            ..self.at
        }
    }
}

/// The extents of the pieces of a pair along the direction that separates its tops.
pub(super) struct EndsAlong {
    pub n: C,
    /// Reach of the locked tooth, mm.
    pub tooth: f64,
    pub top: FreeStart,
    /// Whether a disc in which the free tooth turns represents each of its pieces.
    is_disc: bool,
}

/// The nearest point of a free piece along a direction, mm, and its arm.
#[derive(Clone, Copy)]
pub(super) struct FreeStart {
    pub at: f64,
    arm: f64,
}

impl EndsAlong {
    /// The ends along the direction of `apart`, in which the tops have these supports.
    pub fn new(pair: &FacingPair, apart: Apart, [locked, free]: [Support; 2]) -> EndsAlong {
        let (at, n) = (&pair.at, apart.normal);
        let is_disc = apart.by == Reason::OutOfReach;
        let top = if is_disc {
            FreeStart {
                at: -pair.farthest_of_free(),
                arm: f64::INFINITY,
            }
        } else {
            lowest(at, n, free)
        };
        EndsAlong {
            n,
            tooth: dot(at.centres[0], n) + locked.reach,
            top,
            is_disc,
        }
    }

    pub fn of_locked(&self, pair: &FacingPair, hollow: &Hollow, is_far: bool) -> f64 {
        let direction = if is_far {
            pair.placed[0].far_direction()
        } else {
            pair.at.directions[0]
        };
        dot(pair.at.centres[0], self.n) + hollow.bound(self.n * direction.conj()).reach
    }

    pub fn of_free(&self, at: &FacingHalves, hollow: &Hollow) -> FreeStart {
        if self.is_disc {
            return self.top;
        }
        lowest(at, self.n, hollow.bound(-self.n * at.directions[1].conj()))
    }

    pub fn keeps_off(&self, at: &FacingHalves, reach: f64, free: FreeStart) -> bool {
        at.stays_apart(free.at - reach, free.arm)
    }
}

/// The nearest point of a free piece along `n`; `back` is its support against `n`.
fn lowest(at: &FacingHalves, n: C, back: Support) -> FreeStart {
    FreeStart {
        at: dot(at.centres[1], n) - back.reach,
        arm: at.least_arm(back, n),
    }
}
