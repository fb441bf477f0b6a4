//! Drawn gears in words, and the fitted involute of a drawing as a record.

use gearlash::outline::{FittedInvolute, OutlineGear, StandardGear};
use gearlash_files::PairFile;
use gearlash_files::numbers::{fixed, trimmed, um, within};
use gearlash_files::spec::EitherGearSpec;
use serde_json::{Value, json};

/// The drawn gears of a pair that resemble an involute, by name.
fn fitted(file: &PairFile) -> Vec<(&'static str, &OutlineGear, FittedInvolute)> {
    let Some((_, wheel, pinion)) = file.study.drawn.first() else {
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

/// A sentence for each drawn gear that resembles an involute.
pub fn fitted_sentences(file: &PairFile) -> Vec<String> {
    let each = fitted(file).into_iter();
    each.map(|(name, gear, found)| sentence(name, gear.teeth(), &found))
        .collect()
}

/// Notes on a pair with a drawn gear, one per line; empty for other pairs.
pub fn drawn_notes(file: &PairFile) -> String {
    if file.spec.by_data().is_some() {
        return String::new();
    }
    let left_out = "A drawn gear has no module and no involute: formulas and checks are left out.";
    let lines = [left_out.to_owned()]
        .into_iter()
        .chain(fitted_sentences(file));
    lines.map(|line| line + "\n").collect()
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
    // Rounding errors are not printed.
    let base_module = match (cosine * found.base_radius, cosine * found.base_radius_error) {
        (value, off) if off >= 5e-6 => within(value, off),
        (value, _) => fixed(value, 5),
    };
    let like = match &standard.collect::<Vec<_>>()[..] {
        [] => format!(
            "an involute of no standard module at 20°, 14.5° or 25°, m cos α = {base_module} mm"
        ),
        several => several.join(", or "),
    };
    format!(
        "Found, not used: the {name} looks like {like} (residual {} µm over the middle of its flanks, of {} µm allowed).",
        um(found.residual, 2),
        um(found.limit, 2)
    )
}

/// The fitted involutes of drawn gears as JSON, one object each.
pub(super) fn records(file: &PairFile) -> Vec<Value> {
    let standard = |standard: &StandardGear| {
        json!({
            "module_mm": standard.module,
            "pressure_angle_deg": standard.pressure_angle.to_degrees(),
            "generating_shift": standard.shift,
        })
    };
    let record = |(gear, outline, found): (&str, &OutlineGear, FittedInvolute)| {
        json!({
            "gear": gear,
            "base_diameter_mm": 2.0 * found.base_radius,
            "base_diameter_error_mm": 2.0 * found.base_radius_error,
            "base_tooth_thickness_mm": found.base_thickness,
            "module_times_cos_mm": 2.0 * found.base_radius / f64::from(outline.teeth()),
            "residual_um": 1e3 * found.residual,
            "residual_limit_um": 1e3 * found.limit,
            "standard": found.standard.iter().map(standard).collect::<Vec<_>>(),
        })
    };
    fitted(file).into_iter().map(record).collect()
}
