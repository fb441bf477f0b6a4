//! The other half of a tip land, where tips hardly reach each other.
//!
//! The half teeth of a side end in the middle of their tip lands. Beyond it a land can touch first only where
//! the mate reaches past nothing else of the half tooth:
//!
//! - The *locked* tooth's land stands nearly along the circles on which the free gear's points move; what turns in
//!   enters it at its highest point first. So its far half matters where the free tip circle does not surely pass
//!   the land's middle, and passes some of its far half. It matters also where it is deeper than the near half and the curve
//!   below runs as nearly along those circles: a root land, and the foot of its fillet.
//! - The *free* tooth's land moves along itself, but for its eccentricity `e`: over the whole land the radius about the axis
//!   lies within `r_a ± e`. So its far half can only lead where the locked land's or root's nearest point lies in that
//!   band. (A point farther back leads only on a curve whose polar slope exceeds `r_a/e`, which is so within about
//!   `e²/a` of the nearest point's radius: less than the `2 e` that the band is widened by.)
//!
//! Then the half tooth is cut anew with its whole land, down to the far corner.

use super::facing::facing_teeth;
use super::{CutHalf, PolygonKernel};
use crate::gear::{AsBuilt, Curve, HalfTooth, Placed, Profile, Side};
use crate::pair::Pose;
use nalgebra::{Point2, Vector2};
use std::f64::consts::TAU;

/// A tip land this near to the mate's root circle, in modules, counts as on its root. A fillet is as flat as a
/// land opposite up to 0.01 modules above the root on ordinary gears (its radius of curvature there times
/// `1 − sin(atan σ)`, `σ = r_1 r_2/(a s_a)`), to 0.2 on gears of six teeth.
const ROOT_MODULES: f64 = 0.2;

/// Half teeth of one facing pair with their whole tip lands, where those may matter.
#[derive(Default)]
pub(super) struct FarLands {
    pub locked: Option<CutHalf>,
    pub free: Option<CutHalf>,
}

impl FarLands {
    /// Of the locked tooth `steps` counter-clockwise of the mating's and the free tooth facing its `side`.
    pub fn new(kernel: &PolygonKernel, pose: &Pose, side: Side, steps: i64) -> FarLands {
        let assembly = kernel.assembly;
        let (locked, free) = (assembly.locked(), assembly.free());
        let [locked_tooth, free_tooth] = facing_teeth(assembly, pose, side, steps);
        let (ours, theirs) = (assembly.gear(locked), assembly.gear(free));
        let tooth_1 = assembly.mate_direction(locked) + pose.locked_rotation();
        let placed = Placed::new(ours, assembly.axis(locked), tooth_1);
        let land = Land::new(&placed, side, locked_tooth, assembly.axis(free));
        let (tip, off) = (theirs.gear().tip_radius(), theirs.eccentricity());
        let module = theirs.gear().toothing().module();
        let bottom = theirs.gear().root_radius() + off + ROOT_MODULES * module;
        let in_band = |radius: f64| radius > tip - 3.0 * off && radius < tip + off;
        let on_root = in_band(land.distance - ours.gear().root_radius());
        // Nearly always nothing: no need to look at the land's ends.
        if land.foot() >= bottom
            && !on_root
            && (land.middle <= tip - 3.0 * off || land.middle - land.length >= tip + off)
        {
            return FarLands::default();
        }
        let nearest = land.nearest();
        let past_middle = land.middle > tip - off && nearest < tip + off;
        let deep = nearest < land.middle && nearest < bottom;
        let cut = |gear: &AsBuilt, tooth: u32, half: &CutHalf| {
            let start = land_start(gear, tooth);
            let chord = half.polygon.chord();
            CutHalf::new(HalfTooth::with_land(gear.gear(), side, chord, start))
        };
        FarLands {
            locked: (past_middle || deep)
                .then(|| cut(ours, locked_tooth, kernel.locked.half(side))),
            free: (off > 0.0 && (on_root || in_band(nearest)))
                .then(|| cut(theirs, free_tooth, kernel.free.half(side))),
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

/// The tip land of a placed tooth as the mate's axis sees it; lengths in mm.
struct Land {
    /// Of the outline's centre from the axis.
    distance: f64,
    radius: f64,
    /// Distance of its middle, where the half tooth ends.
    middle: f64,
    /// Length from corner to corner, or more.
    length: f64,
    /// Towards the axis, from the outline's centre.
    away: Vector2<f64>,
    /// Direction of the middle, and of rising parameters from it.
    direction: f64,
    sense: f64,
    ends: (f64, f64),
}

impl Land {
    fn new(placed: &Placed, side: Side, tooth: u32, axis: Point2<f64>) -> Land {
        let gear = placed.as_built();
        let radius = gear.gear().tip_radius();
        let away = axis - placed.centre();
        let direction = placed.direction(tooth) + gear.flank_offset(side, tooth);
        let (sin, cos) = direction.sin_cos();
        let (_, corner) = Profile::new(gear.gear()).range(Curve::Tip);
        let ends = (land_start(gear, tooth), corner);
        Land {
            distance: away.norm(),
            radius,
            middle: (away - radius * Vector2::new(cos, sin)).norm(),
            length: radius * (ends.1 - ends.0),
            away,
            direction,
            // The land's parameter runs clockwise on a right-hand half.
            sense: side.sense(),
            ends,
        }
    }

    /// The least distance of the whole tip circle.
    fn foot(&self) -> f64 {
        self.distance - self.radius
    }

    /// The least distance of the land.
    fn nearest(&self) -> f64 {
        let seen = self.away.y.atan2(self.away.x) - self.direction;
        let foot = self.sense * (seen - TAU * (seen / TAU).round());
        let beside = foot.clamp(self.ends.0, self.ends.1) - foot;
        let (d, r) = (self.distance, self.radius);
        (d * d + r * r - 2.0 * d * r * beside.cos()).sqrt()
    }
}
