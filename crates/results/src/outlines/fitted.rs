//! What an outline looks like, in words and as a record.

use gearlash::outline::{FittedInvolute, OutlineGear};
use gearlash_files::OutlinePairFile;
use gearlash_files::numbers::{fixed, trimmed, um};
use gearlash_files::spec::EitherGearSpec;
use serde::Serialize;

/// The gears of a pair that are outlines and look like an involute, by name.
fn fitted(file: &OutlinePairFile) -> Vec<(&'static str, &OutlineGear, FittedInvolute)> {
    let Some((_, wheel, pinion)) = file.study.materials.first() else {
        return Vec::new();
    };
    let gears = [
        ("wheel", &file.spec.wheel, wheel),
        ("pinion", &file.spec.pinion, pinion),
    ];
    let fitted = gears
        .into_iter()
        .filter_map(|(name, spec, gear)| match spec {
            EitherGearSpec::Data(_) => None,
            EitherGearSpec::Outline(_) => Some((name, gear, gear.fitted_involute()?)),
        });
    fitted.collect()
}

/// A sentence for each gear that is an outline and looks like an involute.
pub fn looks_like(file: &OutlinePairFile) -> Vec<String> {
    let each = fitted(file).into_iter();
    each.map(|(name, gear, found)| sentence(name, gear.teeth(), &found))
        .collect()
}

fn sentence(name: &str, teeth: u32, found: &FittedInvolute) -> String {
    let standard = found.standard.iter().map(|standard| {
        format!(
            "module {} mm, {}°, {teeth} teeth, x = {}",
            trimmed(standard.module, 1, 3),
            trimmed(standard.pressure_angle.to_degrees(), 0, 1),
            fixed(standard.shift, 3)
        )
    });
    let cosine = 2.0 / f64::from(teeth);
    // Rounding is not said.
    let off = match cosine * found.base_radius_error {
        off if off >= 5e-6 => format!(" ± {}", fixed(off, 5)),
        _ => String::new(),
    };
    let like = match &standard.collect::<Vec<_>>()[..] {
        [] => format!(
            "an involute of no standard module at 20°, 14.5° or 25°, m cos α = {}{off} mm",
            fixed(cosine * found.base_radius, 5)
        ),
        several => several.join(", or "),
    };
    format!(
        "Found, not used: the {name} looks like {like} (residual {} µm over the middle of its flanks, of {} µm allowed).",
        um(found.residual, 2),
        um(found.limit, 2)
    )
}

/// An involute that a gear looks like.
#[derive(Serialize)]
pub(super) struct FittedRecord {
    gear: &'static str,
    base_diameter_mm: f64,
    base_diameter_error_mm: f64,
    base_tooth_thickness_mm: f64,
    module_times_cos_mm: f64,
    residual_um: f64,
    residual_limit_um: f64,
    standard: Vec<StandardRecord>,
}

#[derive(Serialize)]
struct StandardRecord {
    module_mm: f64,
    pressure_angle_deg: f64,
    generating_shift: f64,
}

/// Of each gear that is an outline and looks like an involute.
pub(super) fn records(file: &OutlinePairFile) -> Vec<FittedRecord> {
    let each = fitted(file).into_iter();
    each.map(|(gear, outline, found)| FittedRecord {
        gear,
        base_diameter_mm: 2.0 * found.base_radius,
        base_diameter_error_mm: 2.0 * found.base_radius_error,
        base_tooth_thickness_mm: found.base_thickness,
        module_times_cos_mm: 2.0 * found.base_radius / f64::from(outline.teeth()),
        residual_um: 1e3 * found.residual,
        residual_limit_um: 1e3 * found.limit,
        standard: found
            .standard
            .iter()
            .map(|standard| StandardRecord {
                module_mm: standard.module,
                pressure_angle_deg: standard.pressure_angle.to_degrees(),
                generating_shift: standard.shift,
            })
            .collect(),
    })
    .collect()
}
