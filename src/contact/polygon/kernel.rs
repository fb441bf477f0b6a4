//! The polygon method on one pair of gears.

use super::chord::CutPair;
use super::facing_pair::{CutTeeth, FacingPair};
use super::search::{FoundTouch, search};
use crate::contact::Effort;
use crate::contact::body::{
    FarFlanks, beside_root_circles, is_solid, may_be_solid, reaches_over_an_axis,
};
use crate::contact::lost_motion::{Contact, LostMotion};
use crate::error::Error;
use crate::gear::Side;
use crate::pair::{GearPair, Member, Pose};
use nalgebra::Point2;
use std::f64::consts::PI;
use std::ops::Range;

/// The polygon method on one assembly.
pub struct PolygonKernel<'a> {
    pub(super) teeth: CutTeeth<'a>,
    /// Chordal error, mm, down to which chords are cut round the contact.
    pub(super) finest: f64,
}

impl CutPair {
    /// The polygon method on `assembly`, which must consist of these gears.
    pub fn kernel<'a>(&'a self, assembly: &'a GearPair) -> PolygonKernel<'a> {
        PolygonKernel {
            teeth: CutTeeth {
                assembly,
                cut: self,
            },
            finest: self.wheel.chordal_error.max(self.pinion.chordal_error),
        }
    }

    /// The polygon method, cut finer around each contact, down to the resolution of f64: accurate to about a picometre.
    pub fn refined_kernel<'a>(&'a self, assembly: &'a GearPair) -> PolygonKernel<'a> {
        self.kernel(assembly).refined()
    }
}

impl PolygonKernel<'_> {
    /// The method on the same polygons, cut finer around each contact.
    pub(super) fn refined(&self) -> Self {
        PolygonKernel {
            finest: finest_chord(self.teeth.assembly),
            ..*self
        }
    }

    /// Right- and left-flank contact of the free gear at `pose`.
    ///
    /// # Errors
    /// [`Error::ContactLost`] names the pair of teeth whose search did not end.
    pub fn lost_motion(&self, pose: &Pose) -> Result<LostMotion, Error> {
        self.lost_motion_within(pose, &Effort::of_pose())
    }

    /// [`PolygonKernel::lost_motion`] within the budget `effort` of this pose.
    pub(in crate::contact) fn lost_motion_within(
        &self,
        pose: &Pose,
        effort: &Effort,
    ) -> Result<LostMotion, Error> {
        let assembly = self.teeth.assembly;
        if reaches_over_an_axis(assembly) {
            return Ok(LostMotion::JAMMED);
        }
        let may_be_solid = may_be_solid(assembly);
        let found = LostMotion {
            right: self.side(pose, Side::Right, effort)?,
            left: self.side(pose, Side::Left, effort)?,
            solid: may_be_solid && is_solid(assembly, pose),
        };
        let free = assembly.gear(assembly.free());
        let found = found.within(free.gear().basic_data().angular_pitch());
        if may_be_solid {
            beside_root_circles(assembly, pose, found)
        } else {
            Ok(found)
        }
    }

    /// The tightest contact of one side.
    ///
    /// Pairs whose brackets overlap tie; pairs of perfect gears always do. The contact nearest the operating pitch point is reported.
    pub(super) fn side(
        &self,
        pose: &Pose,
        side: Side,
        effort: &Effort,
    ) -> Result<Option<Contact>, Error> {
        let steps = steps_in_reach(self.teeth.assembly, pose);
        let facing = |steps| FacingPair::new(&self.teeth, pose, side, steps);
        let facing: Vec<FacingPair> = steps.clone().map(facing).collect();
        let mut found = search(&facing, self.finest, effort)?;
        if !found.is_empty() && FarFlanks::of(self.teeth.assembly) != FarFlanks::Clear {
            let all: Vec<FacingPair> = FacingPair::all(&self.teeth, pose, side, steps).collect();
            found = search(&all, self.finest, effort)?;
        }
        let tightest = |end: fn(&FoundTouch) -> f64| {
            let openings = found.iter().map(end);
            openings.fold(f64::NEG_INFINITY, f64::max)
        };
        let touching = tightest(|bracket| bracket.touching);
        let clear = tightest(|bracket| bracket.clear);
        let closed = tightest(|bracket| bracket.closed);
        let pitch_point = Point2::new(
            self.teeth.assembly.operating_pitch_radius(Member::Wheel),
            0.0,
        );
        let rotation = pose.free_rotation() - side.sense() * touching;
        let error = (clear - touching).max(touching - closed);
        let off = |contact: &Contact| (contact.point - pitch_point).norm();
        Ok(found
            .iter()
            .filter(|bracket| bracket.clear >= closed)
            .map(|found| {
                found
                    .place
                    .contact(self.teeth.assembly.locked(), rotation, error)
            })
            .min_by(|a, b| off(a).total_cmp(&off(b))))
    }
}

/// Finest useful chordal error, mm: 64 ulps of the centre distance (1.9e-12 mm at 132 mm). A point of a gear is known to a few dozen ulps.
pub(super) fn finest_chord(assembly: &GearPair) -> f64 {
    64.0 * f64::EPSILON * assembly.center_distance()
}

/// Positions of the locked teeth that the free gear can reach, counted counter-clockwise from the mating's.
///
/// Take a ray of length `R_l` at the angle `ζ` from the line of centres. It is nearest to the free axis at its end, or
/// at the foot of the perpendicular, `a sin ζ`, if it reaches that. The greatest `ζ` whose distance is still `R_f`
/// bounds the window. A tooth extends half a pitch to either side of its centre, and deviations add up to another half.
pub(super) fn steps_in_reach(assembly: &GearPair, pose: &Pose) -> Range<i64> {
    let locked = assembly.gear(assembly.locked());
    let a = assembly.center_distance();
    let (reach, other) = (locked.reach(), assembly.gear(assembly.free()).reach());
    if reach + other <= a {
        return 0..0;
    }
    let cosine = (a * a + reach * reach - other * other) / (2.0 * a * reach);
    let widest = if other >= a {
        PI
    } else if a * cosine >= reach {
        cosine.min(1.0).acos()
    } else {
        (other / a).asin()
    };
    let basic_data = locked.gear().basic_data();
    let mating = f64::from(pose.mating().tooth(assembly.locked()));
    let here = pose.locked_rotation() + locked.tooth_angle(mating);
    let first = ((-widest - here) / basic_data.angular_pitch() - 1.0).ceil() as i64;
    let last = ((widest - here) / basic_data.angular_pitch() + 1.0).floor() as i64;
    first..(last + 1).min(first + i64::from(basic_data.teeth()))
}
