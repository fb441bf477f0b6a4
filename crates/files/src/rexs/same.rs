//! Whether a pair file is that of a stage: only then its backlash is the stage's.

use crate::numbers::{fixed, shortest};
use crate::spec::{AssemblySpec, Either, GearSpec, HandName, PairSpec};
use gearlash::gear::{BasicGearData, Hand, ThicknessField};

/// Degrees, and profile shift in modules: what rounds off when a pair file is written by hand.
const ROUNDING: f64 = 1e-6;
/// mm: a nm.
const ROUNDING_MM: f64 = 1e-6;
/// Allowances of a drawing are whole µm.
const ROUNDING_UM: f64 = 1.0;

/// What tells `pair` from the pair file `stage` of a stage, with both values. Either gear of one may be wheel.
///
/// Measured lengths may be anywhere, so may a thickness where the stage states none. A centre distance and an allowance may lie within
/// the band of the stage.
///
/// # Errors
/// The words that tell them apart, to be set behind "stage 3".
pub fn same(stage: &PairSpec, pair: &PairSpec) -> Result<(), String> {
    let gears = |spec: &'_ PairSpec| [spec.wheel.clone(), spec.pinion.clone()];
    let (of_stage, straight) = (gears(stage), gears(pair));
    let mut turned = straight.clone();
    turned.reverse();
    let basic = |gears: &[GearSpec; 2]| gears.each_ref().map(|gear| (gear.teeth, gear.module_mm));
    let fits: Vec<&[GearSpec; 2]> = [&straight, &turned]
        .into_iter()
        .filter(|gears| basic(gears) == basic(&of_stage))
        .collect();
    let Some(&first) = fits.first() else {
        let words = |gears: [(u32, f64); 2]| {
            let [(z1, m1), (z2, m2)] = gears;
            match m1 == m2 {
                true => format!("{z1}/{z2} teeth, m {m1}"),
                false => format!("{z1}/{z2} teeth, m {m1}/{m2}"),
            }
        };
        return Err(unlike(words(basic(&of_stage)), words(basic(&straight))));
    };
    let both = |gears: &[GearSpec; 2]| {
        let [one, two] = &of_stage;
        same_gear(one, &gears[0]).and_then(|()| same_gear(two, &gears[1]))
    };
    if !fits.iter().any(|gears| both(gears).is_ok()) {
        both(first)?;
    }
    same_distance(&stage.assembly, &pair.assembly)
}

fn unlike(stage: String, pair: String) -> String {
    format!("has {stage}, the pair file {pair}")
}

fn same_gear(stage: &GearSpec, pair: &GearSpec) -> Result<(), String> {
    let of = format!("of the gear of {} teeth", stage.teeth);
    for (what, stage, pair, unit) in [
        (
            "pressure angle",
            stage.pressure_angle_deg,
            pair.pressure_angle_deg,
            "°",
        ),
        (
            "helix angle",
            stage.helix_angle_deg.unwrap_or(0.0),
            pair.helix_angle_deg.unwrap_or(0.0),
            "°",
        ),
        ("profile shift", stage.profile_shift, pair.profile_shift, ""),
    ] {
        if (stage - pair).abs() > ROUNDING {
            let stage = format!("{what} {}{unit} {of}", shortest(stage));
            return Err(unlike(stage, format!("{}{unit}", shortest(pair))));
        }
    }
    let hands = [stage, pair].map(|gear| gear.hand.filter(|_| gear.is_helical()));
    if let [Some(one), Some(other)] = hands.map(|hand| hand.map(HandName::name))
        && one != other
    {
        return Err(unlike(format!("hand {one} {of}"), other.to_owned()));
    }
    let width = |gear: &GearSpec| {
        gear.face_mm
            .filter(|_| gear.is_helical())
            .map(|[a, b]| b - a)
    };
    if let (Some(one), Some(other)) = (width(stage), width(pair))
        && (one - other).abs() > ROUNDING_MM
    {
        let stage = format!("face width {} mm {of}", shortest(one));
        return Err(unlike(stage, format!("{} mm", shortest(other))));
    }
    let (Some(band), Some(found)) = (allowances(stage), allowances(pair)) else {
        return Ok(());
    };
    let designations = [stage, pair].map(|gear| gear.thickness.statement.designation.as_deref());
    let is_same = match designations {
        [Some(_), Some(_)] => band == found,
        // The reader makes a thickness that is not stated an allowance of 0.
        _ => {
            band == [0.0; 2]
                || (found[0] >= band[0] - ROUNDING_UM && found[1] <= band[1] + ROUNDING_UM)
        }
    };
    let words = |designation: Option<&str>, [lower, upper]: [f64; 2]| {
        let um = format!("{} / {} µm", fixed(upper, 1), fixed(lower, 1));
        designation.map_or(um.clone(), |name| format!("{name} ({um})"))
    };
    match is_same {
        true => Ok(()),
        false => Err(unlike(
            format!("thickness {} {of}", words(designations[0], band)),
            words(designations[1], found),
        )),
    }
}

/// Lower and upper allowance of the thickness, µm; `None`: it is stated in another form.
fn allowances(gear: &GearSpec) -> Option<[f64; 2]> {
    let statement = &gear.thickness.statement;
    if gear.thickness.file.is_some() {
        return None;
    }
    if let Some(allowance) = &statement.allowance_um {
        return Some(match allowance {
            Either::One(um) => [*um; 2],
            Either::Other(band) => [band.min, band.max],
        });
    }
    let field: ThicknessField = statement.designation.as_ref()?.parse().ok()?;
    let angle = gear.pressure_angle_deg.to_radians();
    let basic_data = BasicGearData::new(gear.teeth, gear.module_mm, angle).ok()?;
    let helix = gear.helix_angle_deg.unwrap_or(0.0).to_radians();
    let basic_data = basic_data.with_helix(helix, Hand::Right).ok()?;
    let [upper, lower] = field.allowances_um(&basic_data).ok()?;
    Some([lower, upper])
}

/// All distances of the pair lie in the band of the stage; where it has none, its distance lies among them.
fn same_distance(stage: &AssemblySpec, pair: &AssemblySpec) -> Result<(), String> {
    let range = |assembly: &AssemblySpec| {
        let all = assembly.center_distance_mm.distances_mm();
        let least = all.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = all.into_iter().fold(f64::NEG_INFINITY, f64::max);
        [least, greatest]
    };
    let within = |inner: [f64; 2], outer: [f64; 2]| {
        inner[0] >= outer[0] - ROUNDING_MM && inner[1] <= outer[1] + ROUNDING_MM
    };
    let (of_stage, found) = (range(stage), range(pair));
    let is_same = match stage.center_distance_mm.band_mm() {
        Some(_) => within(found, of_stage),
        None => within(of_stage, found),
    };
    let words = |[least, greatest]: [f64; 2]| match least == greatest {
        true => format!("{} mm", shortest(least)),
        false => format!("{}…{} mm", shortest(least), shortest(greatest)),
    };
    match is_same {
        true => Ok(()),
        false => Err(unlike(
            format!("centre distance {}", words(of_stage)),
            words(found),
        )),
    }
}
