//! Warnings about numbers of a pair that look like slips. Nothing is changed.

use super::gear::GearPart;
use super::spec::{BearingClearanceSpec, EitherGearSpec, GearSpec};
use gearlash::gear::involute::{inv, inv_of_roll, roll_at, roll_of_inv};
use gearlash::gear::{AsBuilt, Gear};
use gearlash_text::numbers::{ascii, signed, um_ascii};

/// Radial play above which a bearing is no bearing, mm: plain bearings of 100 mm bore have 0.1 mm in diameter.
const MAX_PLAY_MM: f64 = 0.1;
/// The share of the radial clearance that a runout may take. An eccentricity of half the runout moves the tips that much nearer
/// to the roots.
const MAX_OF_CLEARANCE: f64 = 0.5;
/// Tolerance of `compare` above which it is meaningless, µm: more than the backlash of many gears.
pub const MAX_TOLERANCE_UM: f64 = 100.0;
/// Pressure angles of usual basic racks, degrees: 20 (ISO 53, DIN 867), 14.5, 20 and 25 (AGMA), 17.5 and 22.5 between them.
const USUAL_ANGLES: [f64; 5] = [14.5, 17.5, 20.0, 22.5, 25.0];
/// Distance of a centre distance from the computed one up to which they match, in modules: the rounding of a drawing and a
/// tolerance.
const MATCH_WITHIN: f64 = 0.002;
/// Least difference from the distance of the stated pair for a warning, in modules. Distances that are opened for backlash differ
/// less: 0.05 modules give 2 tan 20° · 0.05 = 0.04 modules of backlash.
const MIN_DIFFERENCE: f64 = 0.05;
/// Both limits where only the pressure angle differs: such distances are close together.
const ANGLE_MATCH_WITHIN: f64 = 0.0005;
const ANGLE_LEAST_DIFFERENCE: f64 = 0.01;
/// Backlash of nominal teeth, in modules, above which a distance is questioned: more than gears are run with.
const MAX_BACKLASH: f64 = 0.25;
/// Difference of thicknesses that is rounding, mm.
const ROUNDING_MM: f64 = 1e-9;
/// Sums of profile shifts that are tried where none is stated, in tenths: from more than is used for backlash to more than racks
/// allow.
const SHIFTS: std::ops::RangeInclusive<i32> = 3..=15;

/// Radial play that no bearing has.
pub fn bearing_slips(bearings: &BearingClearanceSpec) -> Vec<String> {
    let [wheel, pinion] = bearings.each().map(|[one, other]| one.max(other));
    let members = [("wheel", wheel), ("pinion", pinion)];
    let large = members.into_iter().filter(|(_, mm)| *mm > MAX_PLAY_MM);
    let warnings = large.map(|(name, mm)| {
        format!(
            "assembly.bearing_clearance_mm: {mm} mm of radial play at the {name} is more than a bearing has: if µm were meant, write {}; diametral play is twice the radial play",
            mm / 1000.0
        )
    });
    warnings.collect()
}

/// A warning of a tolerance of `compare` that lets everything pass; `key` is its place.
pub fn tolerance_slip(key: &str, um: f64) -> Option<String> {
    (um > MAX_TOLERANCE_UM).then(|| {
        format!(
            "{key}: {um} µm is as large as backlash itself, so that hardly a difference would fail: the default is 0.1; if nm were meant, write {}",
            um / 1000.0
        )
    })
}

/// Warnings about the centre `distances`, mm, beside the gears.
pub fn distance_slips(wheel: &GearPart, pinion: &GearPart, distances: &[f64]) -> Vec<String> {
    let mut warnings = Vec::new();
    warnings.extend(large_runout(wheel, pinion, distances));
    let distance = other_distance(wheel, pinion, distances);
    warnings.extend(distance.or_else(|| excessive_backlash(wheel, pinion, distances)));
    warnings
}

/// A warning that tooth numbers may run in opposite directions: both gears have data of single teeth, and neither states its
/// reference face.
pub fn face_slip(gears: [&GearPart; 2]) -> Option<String> {
    let is_open = gears.iter().all(|gear| {
        let spec = gear.spec.as_ref().and_then(EitherGearSpec::data);
        !gear.states_face && spec.is_some_and(has_tooth_data)
    });
    is_open.then(|| {
        "wheel.reference_face, pinion.reference_face: both gears have data of single teeth, and neither says from which face its teeth are \
         counted; both count from the front. If one was measured from the face that is at the back in the pair, write \
         reference_face = \"back\" there; else \"front\""
            .to_owned()
    })
}

/// Both gears in their most material; `None` unless both have data.
fn both<'a>(wheel: &'a GearPart, pinion: &'a GearPart) -> Option<[&'a AsBuilt; 2]> {
    let wheel = wheel.as_built.as_ref()?.most();
    let pinion = pinion.as_built.as_ref()?.most();
    Some([wheel, pinion])
}

/// Whether a gear's data distinguish its teeth.
fn has_tooth_data(gear: &GearSpec) -> bool {
    let per_tooth = gear.thickness.per_tooth_um.as_ref();
    gear.pitch.is_some() || per_tooth.is_some_and(|each| !each.is_empty())
}

/// Runouts that take more than half of the radial clearance.
fn large_runout(wheel: &GearPart, pinion: &GearPart, distances: &[f64]) -> Option<String> {
    let a = distances.iter().copied().reduce(f64::min)?;
    let gears = both(wheel, pinion)?;
    let clearance =
        |tip: &AsBuilt, root: &AsBuilt| a - tip.gear().tip_radius() - root.gear().root_radius();
    let clearance = clearance(gears[0], gears[1]).min(clearance(gears[1], gears[0]));
    // Without clearance, the check of radial clearance reports the fault.
    let large = |(_, _, gear): &(_, _, &AsBuilt)| {
        clearance > 0.0 && 2.0 * gear.eccentricity() > MAX_OF_CLEARANCE * clearance
    };
    let named = [
        ("wheel", wheel.scale, gears[0]),
        ("pinion", pinion.scale, gears[1]),
    ];
    let (name, scale, gear) = named.into_iter().find(large)?;
    let um = 2000.0 * gear.eccentricity();
    let scaled = match scale {
        1.0 => String::new(),
        scale => format!(", {} µm with scale = {scale},", ascii(um, 1)),
    };
    Some(format!(
        "{name}.runout: {} µm{scaled} is more than half of the radial clearance, which is {} µm at a = {a} mm: check the unit (µm), and that it is the \
         runout F_r = 2e of the teeth",
        ascii(um / scale, 1),
        um_ascii(clearance, 1)
    ))
}

/// A warning of centre distances that all leave nominal teeth more backlash than usual gears have. Teeth that are stated thicker
/// count as stated; thinner teeth are no reason to doubt the distance.
///
/// Exact for involutes: `j_t = 2 r_b (inv α_wt − inv α_w0)/cos α_t` with `r_b` the sum of both base radii, at the reference circles.
fn excessive_backlash(wheel: &GearPart, pinion: &GearPart, distances: &[f64]) -> Option<String> {
    let least = distances.iter().copied().reduce(f64::min)?;
    let [wheel, pinion] = both(wheel, pinion)?.map(AsBuilt::gear);
    let data = wheel.basic_data();
    let base = wheel.base_radius() + pinion.base_radius();
    let at = inv_of_roll(roll_at(least, base));
    let inv_0 = inv_without_backlash([wheel, pinion]);
    let backlash = 2.0 * base * (at - inv_0) / data.transverse_pressure_angle().cos();
    let teeth = if is_thick(wheel) || is_thick(pinion) {
        "the stated"
    } else {
        "nominal"
    };
    excessive(
        least,
        teeth,
        backlash,
        data.module(),
        "the distance, the teeth and the module",
    )
}

/// Whether the teeth are stated thicker than nominal ones.
fn is_thick(gear: &Gear) -> bool {
    gear.base_thickness() > gear.design().nominal_base_thickness() + ROUNDING_MM
}

/// `inv α` of the operating pressure angle without backlash. Thin teeth count as nominal ones.
fn inv_without_backlash(gears: [&Gear; 2]) -> f64 {
    let thickness = |gear: &Gear| {
        let nominal = gear.design().nominal_base_thickness();
        gear.base_thickness().max(nominal)
    };
    let [wheel, pinion] = gears;
    let base = wheel.base_radius() + pinion.base_radius();
    let pitch = wheel.basic_data().base_pitch();
    (thickness(wheel) + thickness(pinion) - pitch) / (2.0 * base)
}

/// A warning of `backlash`, mm, at the centre distance `a`, mm, that is more than usual for `module`, mm; it says what to `check`.
pub fn excessive(a: f64, teeth: &str, backlash: f64, module: f64, check: &str) -> Option<String> {
    let modules = backlash / module;
    (modules > MAX_BACKLASH).then(|| {
        format!(
            "assembly.center_distance_mm: {} mm leaves {teeth} teeth {} µm of backlash, {} of the module: check {check}",
            ascii(a, 4),
            um_ascii(backlash, 0),
            ascii(modules, 2)
        )
    })
}

/// A warning of a centre distance that suits another pair than the stated one.
fn other_distance(wheel: &GearPart, pinion: &GearPart, distances: &[f64]) -> Option<String> {
    let teeth = f64::from(wheel.known.teeth? + pinion.known.teeth?);
    let scaled = |gear: &GearPart| {
        let known = &gear.known;
        Some(gear.scale * known.module_mm? * f64::from(known.teeth?))
    };
    let module = (scaled(wheel)? + scaled(pinion)?) / teeth;
    let gears = both(wheel, pinion)?.map(AsBuilt::gear);
    let [x_1, x_2] = gears.map(|gear| gear.design().profile_shift);
    let (angle, helix_deg) = (
        wheel.known.pressure_angle_deg?,
        wheel.known.helix?.angle_deg,
    );
    // Module, pressure angle and shifts are those of the normal section.
    let nominal = |degrees: f64, helix_deg: f64, shift: f64| {
        let (normal, cos_helix) = (degrees.to_radians().tan(), helix_deg.to_radians().cos());
        let alpha = (normal / cos_helix).atan();
        let roll = roll_of_inv(inv(alpha) + 2.0 * shift * normal / teeth);
        module * teeth / (2.0 * cos_helix) * alpha.cos() * roll.hypot(1.0)
    };
    let without_backlash = |degrees: f64, shift: f64| nominal(degrees, helix_deg, shift);
    // A scan leaves the distance on purpose: one suitable distance of it is enough.
    let suits = |mm: f64, within: f64| {
        let near = |a: &&f64| (**a - mm).abs() <= within * module;
        mm.is_finite() && distances.iter().any(|a| near(&a))
    };
    if gears.into_iter().any(is_thick) {
        // Thick teeth need a greater distance than nominal ones.
        let base = gears[0].base_radius() + gears[1].base_radius();
        let own = base * roll_of_inv(inv_without_backlash(gears)).hypot(1.0);
        if suits(own, MIN_DIFFERENCE) {
            return None;
        }
    }
    let (stated, a) = (without_backlash(angle, x_1 + x_2), *distances.first()?);
    let off = format!(
        "assembly.center_distance_mm: {a} mm is {} mm off {} mm, the zero-backlash distance of the stated pair with nominal teeth",
        signed(a - stated, 4),
        ascii(stated, 4)
    );
    let spur = nominal(angle, 0.0, x_1 + x_2);
    if helix_deg != 0.0 && !suits(stated, MIN_DIFFERENCE) && suits(spur, MATCH_WITHIN) {
        return Some(format!(
            "{off}; it would fit β = 0 ({} mm): was the helix angle forgotten in the distance?",
            ascii(spur, 4)
        ));
    }
    if x_1 != 0.0 || x_2 != 0.0 {
        let otherwise = [
            ("no profile shift", 0.0),
            ("the wheel's profile shift alone", x_1),
            ("the pinion's profile shift alone", x_2),
            ("profile shifts of the other sign", -x_1 - x_2),
        ];
        let mut otherwise = otherwise
            .into_iter()
            .map(|(words, x)| (words, without_backlash(angle, x)));
        if !suits(stated, MIN_DIFFERENCE)
            && let Some((words, mm)) = otherwise.find(|(_, mm)| suits(*mm, MATCH_WITHIN))
        {
            return Some(format!(
                "{off}; it would fit {words} ({} mm): was a profile shift forgotten, in the distance or in the file?",
                ascii(mm, 4)
            ));
        }
        let mut angles = USUAL_ANGLES.into_iter().filter(|usual| *usual != angle);
        if !suits(stated, ANGLE_LEAST_DIFFERENCE)
            && let Some(usual) =
                angles.find(|usual| suits(without_backlash(*usual, x_1 + x_2), ANGLE_MATCH_WITHIN))
        {
            return Some(format!(
                "{off}; it would fit a pressure angle of {usual}° ({} mm): check pressure_angle_deg",
                ascii(without_backlash(usual, x_1 + x_2), 4)
            ));
        }
    } else if !suits(stated, f64::from(*SHIFTS.start()) / 10.0 - 0.1) {
        let tenths = SHIFTS
            .flat_map(|tenths| [tenths, -tenths])
            .map(|tenths| f64::from(tenths) / 10.0);
        let shift = tenths
            .into_iter()
            .find(|x| suits(without_backlash(angle, *x), MATCH_WITHIN))?;
        return Some(format!(
            "{off}; it would fit profile shifts of {shift} together ({} mm): was profile_shift forgotten?",
            ascii(without_backlash(angle, shift), 4)
        ));
    }
    None
}
