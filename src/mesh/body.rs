//! Teeth in the solid body of the mate: a pose that no rotation of the free gear frees, whatever touches first.
//!
//! Below its root circle a gear is solid, and its shaft stands in its axis. Two things are enough each of an overlap, and need no
//! contact:
//!
//! 1. a tip land of the locked gear comes nearer to the free axis than `r_f − e`, `e` the free gear's eccentricity:
//!    there is metal at every rotation;
//! 2. the locked gear's root circle, seen from the free outline's centre, is wider on a circle of that outline than the free gear's
//!    widest space there: a free tooth stands in it at every rotation.
//!
//! And where a tip circle reaches over the mate's axis, as it may with three or four long teeth whose root circle is next to
//! nothing, no pose of the pair can be assembled ([`reaches_over_an_axis`]).
//!
//! For 2, the circle of radius `ρ` about a centre `d` away lies within the disc of radius `r_f` over
//! `2 acos((d² + ρ² − r_f²)/(2 d ρ))`, at most where `ρ² = d² − r_f²`; between form and tip circle a tooth is at least as wide,
//! in angle, as its tip land.
//!
//! Where none holds a pose may still be jammed: what touches then says so ([`super::LostMotion::status`]).

use crate::gear::{AsBuilt, Curve, Placed, Profile, Side};
use crate::pair::{Assembly, Member, Pose};
use std::f64::consts::PI;

/// Whether teeth of one gear reach to where the mate's outline has its centre, and its shaft stands: all poses are jammed. What
/// turned there would meet teeth from all sides, and no pair of them would come first.
pub(super) fn reaches_over_an_axis(assembly: &Assembly) -> bool {
    [Member::Wheel, Member::Pinion].into_iter().any(|member| {
        let (gear, mate) = (assembly.gear(member), assembly.gear(member.mate()));
        gear.reach() + mate.eccentricity() >= assembly.center_distance()
    })
}

/// Whether there may be a pose of which [`is_solid`] is true: nearly never.
pub(super) fn may_be_solid(assembly: &Assembly) -> bool {
    let locked = assembly.gear(assembly.locked());
    let free = assembly.gear(assembly.free());
    let nearest = assembly.center_distance() - locked.eccentricity();
    nearest - locked.gear().tip_radius() < solid_radius(free)
        || nearest - locked.gear().root_radius() < free.reach()
}

/// Radius about its axis within which a gear is solid at every rotation, mm.
fn solid_radius(gear: &AsBuilt) -> f64 {
    gear.gear().root_radius() - gear.eccentricity()
}

/// Whether teeth of one gear stand in the body of the other at every rotation of the free gear.
pub(super) fn is_solid(assembly: &Assembly, pose: &Pose) -> bool {
    let locked = assembly.gear(assembly.locked());
    let free = assembly.gear(assembly.free());
    let (tip, root) = (locked.gear().tip_radius(), locked.gear().root_radius());
    let solid = solid_radius(free);
    let tooth_1 = assembly.mate_direction(assembly.locked()) + pose.locked_rotation();
    let placed = Placed::new(locked, assembly.axis(assembly.locked()), tooth_1);
    let axis = assembly.axis(assembly.free());
    let distance = (axis - placed.centre()).norm();
    let off = free.eccentricity();
    if distance - tip < solid {
        let teeth = placed.teeth_near(axis, solid.max(0.0));
        if teeth
            .iter()
            .any(|&tooth| land_distance(&placed, tooth, axis) < solid)
        {
            return true;
        }
    }
    let spans = [distance - off, distance + off].map(|distance| seen(distance, root, free));
    spans[0].min(spans[1]) > widest_space(free)
}

/// Least distance of a tooth's tip land from `point`, mm.
fn land_distance(placed: &Placed, tooth: u32, point: nalgebra::Point2<f64>) -> f64 {
    let gear = placed.as_built();
    let tip = gear.gear().tip_radius();
    let (_, half) = Profile::new(gear.gear()).range(Curve::Tip);
    let to_point = point - placed.centre();
    let beside = to_point.y.atan2(to_point.x) - placed.direction(tooth);
    let beside = beside - 2.0 * PI * (beside / (2.0 * PI)).round();
    let ends = [
        gear.flank_offset(Side::Right, tooth) - half,
        gear.flank_offset(Side::Left, tooth) + half,
    ];
    let off = beside - beside.clamp(ends[0].min(ends[1]), ends[1]);
    let d = to_point.norm();
    (d * d + tip * tip - 2.0 * d * tip * off.cos()).sqrt()
}

/// Angle of the widest arc about the free outline's centre, between its form and tip circle, that lies within the locked root
/// circle of radius `root`, its centre `distance` away.
fn seen(distance: f64, root: f64, free: &AsBuilt) -> f64 {
    let gear = free.gear();
    if !(distance > root) {
        return 0.0;
    }
    let widest = ((distance - root) * (distance + root)).sqrt();
    let radius = widest.clamp(gear.form_radius(), gear.tip_radius());
    let cos = (distance * distance + radius * radius - root * root) / (2.0 * distance * radius);
    2.0 * cos.clamp(-1.0, 1.0).acos()
}

/// Greatest angle between two neighbouring tip lands.
fn widest_space(gear: &AsBuilt) -> f64 {
    let (_, half) = Profile::new(gear.gear()).range(Curve::Tip);
    let nominal = gear.gear().toothing().angular_pitch() - 2.0 * half;
    let teeth = gear.gear().toothing().teeth();
    let wider = (1..=teeth).map(|tooth| {
        let next = gear.counter_clockwise(tooth, 1);
        gear.flank_offset(Side::Right, next) - gear.flank_offset(Side::Left, tooth)
    });
    nominal + wider.fold(f64::NEG_INFINITY, f64::max)
}
