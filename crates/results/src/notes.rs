//! Consistency of the statements about each gear.

use gearlash::analysis::study::Study;
use gearlash::metrology::{Eccentricity, EccentricityNote, GearNotes, ThicknessStatements};
use serde_json::{Map, Value, json};

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
