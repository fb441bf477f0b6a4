//! Notes on gears: the consistency of the statements about each, and the involutes that drawn gears resemble.

use gearlash::analysis::study::Study;
use gearlash::metrology::{Eccentricity, EccentricityNote, GearNotes, ThicknessStatements};
use gearlash::outline::{FittedInvolute, OutlineGear, StandardGear, fit_involute};
use gearlash_input::PairFile;
use gearlash_text::numbers::{fixed, trimmed, um, within};
use serde_json::{Map, Value, json};

/// The keys of a result with notes on `file`. Only `warnings` stands there without any.
pub(super) fn entries(file: &PairFile) -> impl Iterator<Item = (&'static str, Value)> {
    let each = [
        ("fitted_involutes", fitted_records(file)),
        ("warnings", json!(file.warnings)),
        ("remarks", json!(file.remarks)),
    ];
    each.into_iter()
        .filter(|(key, list)| *key == "warnings" || *list != json!([]))
}

/// The notes on each gear by its name; `None` without any.
pub(super) fn notes(study: &Study) -> Option<Value> {
    let gears = ["wheel", "pinion"].into_iter().zip(&study.notes);
    let entries = gears.filter_map(|(name, notes)| Some((name.to_owned(), of_gear(notes)?)));
    filled(entries.collect())
}

fn of_gear(notes: &GearNotes) -> Option<Value> {
    let all_round = notes
        .all_round
        .map(|note| json!({ "readings": note.readings, "amplification": note.amplification }));
    let eccentricity = notes.eccentricity.as_ref().map(eccentricity);
    let entries = [
        ("eccentricity", eccentricity),
        ("all_round", all_round),
        ("cross_check", notes.thickness.as_ref().map(cross_check)),
    ];
    let stated = entries.into_iter();
    let stated = stated.filter_map(|(key, value)| Some((key.to_owned(), value?)));
    filled(stated.collect())
}

fn filled(entries: Map<String, Value>) -> Option<Value> {
    (!entries.is_empty()).then_some(Value::Object(entries))
}

fn eccentricity(note: &EccentricityNote) -> Value {
    let shown = |e: Eccentricity| json!({ "um": e.um, "high_tooth": e.high_tooth });
    json!({
        "in_pitch": shown(note.in_pitch),
        "in_runout": note.stated.map(shown),
        "counts": if note.stated_counts { "runout" } else { "pitch" },
        "difference_um": note.difference_um,
    })
}

fn cross_check(note: &ThicknessStatements) -> Value {
    json!({
        "base_thickness_mm": note.counts,
        "cross_check_mm": note.cross,
        "difference_um": note.difference_um,
        "gap_um": note.gap_um,
        "tolerance_um": note.tolerance_um,
        "agree": note.agree(),
    })
}

/// The drawn gears of a pair that resemble an involute, by name.
fn fitted(file: &PairFile) -> Vec<(&'static str, &OutlineGear, FittedInvolute)> {
    let gears = file.study.drawn.iter().take(1);
    let gears = gears.flat_map(|(_, wheel, pinion)| [("wheel", wheel), ("pinion", pinion)]);
    let drawings = gears.zip(&file.drawings);
    let fitted = drawings.filter_map(|((name, gear), drawing)| {
        drawing.as_ref()?;
        Some((name, gear, fit_involute(gear)?))
    });
    fitted.collect()
}

/// A sentence for each drawn gear that resembles an involute.
pub fn fitted_sentences(file: &PairFile) -> Vec<String> {
    let each = fitted(file).into_iter();
    each.map(|(name, gear, found)| sentence(name, gear.teeth(), &found))
        .collect()
}

/// Notes on what was read of drawings, one per line.
pub fn drawn_notes(file: &PairFile) -> String {
    let left_out = file.left_out.map(str::to_owned);
    let lines = left_out.into_iter().chain(fitted_sentences(file));
    lines.map(|line| line + "\n").collect()
}

fn sentence(name: &str, teeth: u32, found: &FittedInvolute) -> String {
    let standard = found.standard.iter().map(|standard| {
        format!(
            "module {} mm, {}°, {teeth} teeth, x = {} by thickness",
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
            "an involute of module {} mm at 20°, not a standard one, with m cos α = {base_module} mm",
            trimmed(cosine * found.base_radius / 20f64.to_radians().cos(), 1, 4)
        ),
        several => several.join(", or "),
    };
    format!(
        "The {name} looks like {like}, which is not used. The middle of its flanks is within {} µm of that involute.",
        um(found.residual, 2)
    )
}

/// The fitted involutes of drawn gears as JSON, one object each.
fn fitted_records(file: &PairFile) -> Value {
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
