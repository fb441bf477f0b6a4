//! Lost motion on polygons: the free gear is turned in safe steps until it touches.
//!
//! Each side is a matter of the half teeth of that side alone, so an interfering
//! pair gives its negative value by the same path as a clear one. Every pair of
//! facing half teeth within reach is searched on its own (`facing`); the
//! side's contact is the tightest.

mod certificate;
mod facing;
mod far_land;

use super::contact::Shape;
use super::lost_motion::{Contact, LostMotion};
use crate::error::Error;
use crate::gear::{AsBuilt, HalfTooth, Side};
use crate::pair::{Assembly, Member, Pose};
pub use certificate::Certifier;
use facing::{Facing, Found};
use far_land::FarLands;
use nalgebra::Point2;
use std::f64::consts::PI;
use std::ops::Range;

/// A gear's two half teeth, cut and ready for distance queries. Shared by all its teeth.
pub struct CutGear {
    halves: [CutHalf; 2],
}

/// One half tooth, or a stretch of it, as polygon and as parry sees it.
struct CutHalf {
    polygon: HalfTooth,
    shape: Shape,
}

impl CutHalf {
    fn new(polygon: HalfTooth) -> CutHalf {
        CutHalf {
            shape: Shape::new(polygon.points()),
            polygon,
        }
    }
}

impl CutGear {
    /// Cuts the half teeth of `gear` with chords within `chord` mm of its curves.
    pub fn new(gear: &AsBuilt, chord: f64) -> CutGear {
        CutGear {
            halves: Side::BOTH.map(|side| CutHalf::new(HalfTooth::new(gear.gear(), side, chord))),
        }
    }

    fn half(&self, side: Side) -> &CutHalf {
        match side {
            Side::Right => &self.halves[0],
            Side::Left => &self.halves[1],
        }
    }
}

/// The polygon method on one assembly.
pub struct PolygonKernel<'a> {
    assembly: &'a Assembly,
    locked: &'a CutGear,
    free: &'a CutGear,
    /// Chordal error, mm, down to which polygons are cut again round the contact; infinite: as they are.
    finest: f64,
}

impl<'a> PolygonKernel<'a> {
    /// The kernel for `assembly`, whose wheel and pinion were cut beforehand, with the same chord.
    pub fn new(assembly: &'a Assembly, wheel: &'a CutGear, pinion: &'a CutGear) -> Self {
        let (locked, free) = match assembly.locked() {
            Member::Wheel => (wheel, pinion),
            Member::Pinion => (pinion, wheel),
        };
        PolygonKernel {
            assembly,
            locked,
            free,
            finest: f64::INFINITY,
        }
    }

    /// The same, with the polygons cut again ever finer round each contact, down to what f64 resolves.
    pub fn refined(assembly: &'a Assembly, wheel: &'a CutGear, pinion: &'a CutGear) -> Self {
        PolygonKernel {
            finest: finest_chord(assembly),
            ..PolygonKernel::new(assembly, wheel, pinion)
        }
    }

    /// Right- and left-flank contact of the free gear at `pose`.
    ///
    /// # Errors
    /// [`Error::ContactLost`] names the pair of teeth whose search did not end.
    pub fn lost_motion(&self, pose: &Pose) -> Result<LostMotion, Error> {
        Ok(LostMotion {
            right: self.side(pose, Side::Right)?,
            left: self.side(pose, Side::Left)?,
        })
    }

    /// The tightest contact of one side.
    ///
    /// Pairs that their brackets cannot tell apart tie (perfect gears always do); the one
    /// that touches nearest the operating pitch point gives the contact its name.
    fn side(&self, pose: &Pose, side: Side) -> Result<Option<Contact>, Error> {
        let mut found = Vec::new();
        let steps = steps_in_reach(self.assembly, pose);
        let lands: Vec<(i64, FarLands)> = steps
            .map(|steps| (steps, FarLands::new(self, pose, side, steps)))
            .collect();
        for (steps, far) in &lands {
            let facing = Facing::new(self, pose, side, *steps, far);
            if let Some(bracket) = facing.search(self.finest)? {
                found.push((facing, bracket));
            }
        }
        let tightest = |found: &[(Facing, Found)], end: fn(&Found) -> f64| {
            let openings = found.iter().map(|(_, bracket)| end(bracket));
            openings.fold(f64::NEG_INFINITY, f64::max)
        };
        // What is proven clear where another pair is proven to touch has no part in the contact.
        let closed = tightest(&found, |bracket| bracket.closed);
        found.retain(|(_, bracket)| bracket.clear >= closed);
        for (facing, bracket) in &mut found {
            *bracket = facing.refine(*bracket, self.finest)?;
        }
        let touching = tightest(&found, |bracket| bracket.touching);
        let clear = tightest(&found, |bracket| bracket.clear);
        let closed = tightest(&found, |bracket| bracket.closed);
        let pitch_point = Point2::new(self.assembly.operating_pitch_radius(Member::Wheel), 0.0);
        let rotation = pose.free_rotation() - side.sense() * touching;
        let error = (clear - touching).max(touching - closed);
        let off = |contact: &Contact| (contact.point - pitch_point).norm();
        Ok(found
            .iter()
            .filter(|(_, bracket)| bracket.clear >= closed)
            .map(|(facing, bracket)| facing.contact(bracket, rotation, error))
            .min_by(|a, b| off(a).total_cmp(&off(b))))
    }
}

/// Chordal error, mm, below which finer polygons tell no more: 64 ulps of the centre distance
/// (1.9e-12 mm at 132 mm); a point of a gear is known to some dozens.
fn finest_chord(assembly: &Assembly) -> f64 {
    64.0 * f64::EPSILON * assembly.center_distance()
}

/// Places of the locked teeth, counted counter-clockwise from the mating's, that the free gear can reach.
///
/// A ray at the angle `ζ` from the line of centres, `R_l` long, comes as near to the free axis as its
/// end, or as the foot of the perpendicular, `a sin ζ`, where that lies on it. The
/// greatest `ζ` at which that is still `R_f` bounds the window; a tooth spreads half a pitch to
/// either side of its centre, and deviations of up to another half.
fn steps_in_reach(assembly: &Assembly, pose: &Pose) -> Range<i64> {
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
    let toothing = locked.gear().toothing();
    let mating = f64::from(pose.mating().tooth(assembly.locked()));
    let here = pose.locked_rotation() + locked.tooth_angle(mating);
    let first = ((-widest - here) / toothing.angular_pitch() - 1.0).ceil() as i64;
    let last = ((widest - here) / toothing.angular_pitch() + 1.0).floor() as i64;
    first..(last + 1).min(first + i64::from(toothing.teeth()))
}
