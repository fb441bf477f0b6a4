//! Limits of a pair from its parameters alone, for mean teeth on centred axes.
//!
//! Margins are positive if the limit is met. Lengths are mm.

use super::InvolutePair;
use crate::gear::{BasicGearData, BasicRack, Gear};
use crate::pair::{GearPair, Member};

/// Tolerance of a limit, mm: decimal input such as 160.2 − 132 − 27.75 is not exact in binary.
pub const MET_WITHIN: f64 = 1e-9;

/// Recommended radial clearance, modules (study, section 3).
pub const RECOMMENDED_CLEARANCE: f64 = 0.25;

/// Lower limit of the radial clearance, modules (study, section 3).
pub const LEAST_CLEARANCE: f64 = 0.15;

/// Length `(r_b1 + r_b2) tan α_wt` of the line of action between the base circles, mm.
pub fn base_tangent(assembly: &GearPair) -> f64 {
    let base = |member| assembly.gear(member).gear().base_radius();
    (base(Member::Wheel) + base(Member::Pinion)) * assembly.operating_pressure_angle().tan()
}

/// Length `√(r_a² − r_b²)` of a gear's line of action from base to tip circle, mm.
pub fn tip_tangent(gear: &Gear) -> f64 {
    gear.base_radius() * gear.tip_roll()
}

/// Line of action of `member` beyond its mate's tip circle, `(r_b1 + r_b2) tan α_wt − √(r_a,mate² − r_b,mate²)`, mm.
///
/// K (8): if it is negative, the mate's tip would touch `member` inside the base circle, where there is no involute.
pub fn non_involute_margin(assembly: &GearPair, member: Member) -> f64 {
    base_tangent(assembly) - tip_tangent(assembly.gear(member.mate()).gear())
}

/// [`non_involute_margin`] counted from `member`'s root form circle instead of its base circle, mm along the line of action.
pub fn form_margin(assembly: &GearPair, member: Member) -> f64 {
    let gear = assembly.gear(member).gear();
    non_involute_margin(assembly, member) - gear.base_radius() * gear.form_roll()
}

/// Radius on `member` at which its mate's tip leaves the line of action, mm; `None` if K (8) is violated.
pub fn active_root_radius(assembly: &GearPair, member: Member) -> Option<f64> {
    let margin = non_involute_margin(assembly, member);
    (margin >= 0.0).then(|| margin.hypot(assembly.gear(member).gear().base_radius()))
}

/// Contact ratio `ε_α`: the path of contact between both tip circles over the base pitch (ISO 21771).
///
/// It is negative if the tip circles do not meet on the line of action. Flanks are assumed to reach as deep as the tips: see
/// [`form_margin`].
pub fn contact_ratio(assembly: &GearPair) -> f64 {
    let gear = |member| assembly.gear(member).gear();
    let path = tip_tangent(gear(Member::Wheel)) + tip_tangent(gear(Member::Pinion))
        - base_tangent(assembly);
    path / gear(Member::Wheel).basic_data().base_pitch()
}

/// Contact ratio over the part of the path outside both form circles.
pub fn usable_contact_ratio(assembly: &GearPair) -> f64 {
    let lost = Member::BOTH.map(|member| (-form_margin(assembly, member)).max(0.0));
    let lost: f64 = lost.iter().sum();
    let wheel = assembly.gear(Member::Wheel).gear().basic_data();
    contact_ratio(assembly) - lost / wheel.base_pitch()
}

/// Tooth thickness of `member` on its operating pitch circle, `s_wt = 2 r_w (ψ_b − inv α_wt)`, mm.
pub fn operating_thickness(assembly: &GearPair, member: Member) -> f64 {
    2.0 * assembly.operating_pitch_radius(member) * assembly.operating_half_angle(member)
}

/// Pitch on the operating pitch circles, `p_wt = p_b/cos α_wt`, mm.
///
/// Backlash condition (K (12), (13)): the sum of both operating thicknesses does not exceed it.
pub fn operating_pitch(assembly: &GearPair) -> f64 {
    let basic_data = assembly.gear(Member::Wheel).gear().basic_data();
    assembly.operating_pitch_radius(Member::Wheel) * basic_data.angular_pitch()
}

/// Zero-backlash centre distance `a_0` of the mean teeth, mm, K (17).
///
/// The thickness may come from measured spans (K (15), (16): [`crate::gear::thickness::base_from_span`]). `None` if touching base
/// circles have backlash.
pub fn zero_backlash_distance(assembly: &GearPair) -> Option<f64> {
    InvolutePair::of(assembly).center_distance(0.0)
}

/// Zero-backlash centre distance of the nominal teeth, mm: `inv α_0 = inv α + 2 (x_1 + x_2) tan α/(z_1 + z_2)`.
pub fn nominal_zero_backlash_distance(assembly: &GearPair) -> Option<f64> {
    InvolutePair::nominal(assembly).center_distance(0.0)
}

/// Radial backlash `j_r = a − a_0`, mm; `None` as [`zero_backlash_distance`].
pub fn radial_backlash(assembly: &GearPair) -> Option<f64> {
    Some(assembly.center_distance() - zero_backlash_distance(assembly)?)
}

/// Normal tooth thickness `s_an` on the tip circle, mm: the transverse thickness times `cos β_a`.
pub fn tip_thickness(gear: &Gear) -> f64 {
    2.0 * gear.tip_radius() * gear.half_angle_at_roll(gear.tip_roll()) * tip_helix_cos(gear)
}

/// `cos β_a` at the tip circle, `tan β_a = r_a tan β/r` (ISO 21771); 1 for spur gears.
pub fn tip_helix_cos(gear: &Gear) -> f64 {
    let tan = gear.tip_radius() * gear.basic_data().twist();
    1.0 / (1.0 + tan * tan).sqrt()
}

/// Overlap ratio `ε_β = b tan β_b/p_bt` of the common face `b`, mm; 0 for spur gears.
pub fn overlap_ratio(assembly: &GearPair) -> f64 {
    let basic_data = assembly.gear(Member::Wheel).gear().basic_data();
    let [from, to] = assembly.face();
    let winding = basic_data.twist().abs() * basic_data.base_radius();
    (to - from) * winding / basic_data.base_pitch()
}

/// Least generating shift `x_E` without undercut, modules: `h_fP* − ρ_fP* (1 − sin α_n) − z sin² α_t/(2 cos β)`.
///
/// It solves `r sin α − (h_0/sin α + ρ) ≥ 0` for the shift.
pub fn least_shift_without_undercut(basic_data: &BasicGearData, rack: &BasicRack) -> f64 {
    let sin = basic_data.pressure_angle().sin();
    let transverse = basic_data.transverse_pressure_angle().sin();
    rack.dedendum()
        - rack.root_radius() * (1.0 - sin)
        - f64::from(basic_data.teeth()) * transverse * transverse
            / (2.0 * basic_data.helix_angle().cos())
}
