//! The other half of a tip land, where tips hardly reach each other.
//!
//! The half teeth of a side end in the middle of their tip lands. Beyond it a land can touch first only where
//! the mate reaches past nothing else of the half tooth:
//!
//! - The *locked* tooth's land runs nearly along the circles on which the free gear's points move; what turns in
//!   enters it at its highest point first. So its far half matters where the free tip circle does not surely
//!   pass the land's middle, and passes some of its far half.
//! - The *free* tooth's land moves along itself, but for its eccentricity `e`: over the whole land the radius about the axis
//!   lies within `r_a ± e`. So its far half can only lead where the locked land's nearest point lies in that band. (A point
//!   farther back leads only on a land whose polar slope exceeds `r_a/e`, which is so within about `e²/a` of the
//!   line of centres' foot: less than the `2 e` that the band is widened by.)
//!
//! Then the half tooth is cut anew with its whole land, down to the far corner.

use super::facing::facing_teeth;
use super::{CutHalf, PolygonKernel};
use crate::gear::{AsBuilt, Curve, HalfTooth, Placed, Profile, Side};
use crate::pair::Pose;
use nalgebra::Point2;
use std::f64::consts::TAU;

/// Half teeth of one facing pair with their whole tip lands, where those may matter.
#[derive(Default)]
pub(super) struct FarLands {
    pub locked: Option<CutHalf>,
    pub free: Option<CutHalf>,
}

impl FarLands {
    /// Of the locked tooth `steps` counter-clockwise of the mating's and the free tooth facing its `side`.
    pub fn new(
        kernel: &PolygonKernel,
        pose: &Pose,
        side: Side,
        steps: i64,
    ) -> FarLands {
        let assembly = kernel.assembly;
        let (locked, free) = (assembly.locked(), assembly.free());
        let [locked_tooth, free_tooth] = facing_teeth(assembly, pose, side, steps);
        let (ours, theirs) = (assembly.gear(locked), assembly.gear(free));
        let tooth_1 = assembly.mate_direction(locked) + pose.locked_rotation();
        let placed = Placed::new(ours, assembly.axis(locked), tooth_1);
        let axis = assembly.axis(free);
        let land = Land::new(&placed, side, locked_tooth, axis);
        let (tip, off) = (theirs.gear().tip_radius(), theirs.eccentricity());
        let cut = |gear: &AsBuilt, tooth: u32, chord: f64| {
            let start = land_start(gear, tooth);
            CutHalf::new(HalfTooth::with_land(gear.gear(), side, chord, start))
        };
        let in_reach = land.nearest < tip + off;
        FarLands {
            locked: (in_reach && land.middle > tip - off)
                .then(|| cut(ours, locked_tooth, kernel.locked.half(side).polygon.chord())),
            free: (in_reach && off > 0.0 && land.nearest > tip - 3.0 * off)
                .then(|| cut(theirs, free_tooth, kernel.free.half(side).polygon.chord())),
        }
    }
}

/// Where a tooth's tip land ends on the other half: `ψ_a` and what both flanks' deviations add. A tooth left thinner
/// than half its land keeps that half.
fn land_start(gear: &AsBuilt, tooth: u32) -> f64 {
    let widening = gear.flank_offset(Side::Left, tooth) - gear.flank_offset(Side::Right, tooth);
    let (_, corner) = Profile::new(gear.gear()).range(Curve::Tip);
    (-corner - widening).min(0.0)
}

/// Distances of a tip land from the mate's axis, mm.
struct Land {
    /// Of the middle, where the half tooth ends.
    middle: f64,
    /// The least of the whole land.
    nearest: f64,
}

impl Land {
    fn new(placed: &Placed, side: Side, tooth: u32, axis: Point2<f64>) -> Land {
        let gear = placed.as_built();
        let radius = gear.gear().tip_radius();
        let away = axis - placed.centre();
        let distance = away.norm();
        // From the middle of the half tooth's land, clockwise positive on the right-hand half, as the land's parameter.
        let middle = placed.direction(tooth) + gear.flank_offset(side, tooth);
        let seen = away.y.atan2(away.x) - middle;
        let foot = side.sense() * (seen - TAU * (seen / TAU).round());
        let (_, corner) = Profile::new(gear.gear()).range(Curve::Tip);
        let at = |t: f64| {
            let cos = (t - foot).cos();
            (distance * distance + radius * radius - 2.0 * distance * radius * cos).sqrt()
        };
        Land {
            middle: at(0.0),
            nearest: at(foot.clamp(land_start(gear, tooth), corner)),
        }
    }
}
