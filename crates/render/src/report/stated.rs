//! What a pair file states of a gear, in words.

use super::phrases::plain;
use gearlash_files::numbers::{rounded, shortest};
use serde_json::Value;

/// A value of the pair file.
pub(super) fn words(value: &Value) -> String {
    match value {
        Value::Null => "–".to_owned(),
        Value::String(text) => plain(text),
        Value::Number(number) => number.as_f64().map_or_else(|| number.to_string(), shortest),
        other => plain(&other.to_string()),
    }
}

/// `key`, or `min … max`.
fn single_or_band(table: &Value, [single, min, max]: [&str; 3]) -> String {
    match &table[single] {
        Value::Null => format!("{} … {}", words(&table[min]), words(&table[max])),
        one => words(one),
    }
}

/// `key`, or `min … max`, or how many readings and between which.
fn measured(table: &Value) -> String {
    match &table["mm"] {
        Value::Array(readings) => {
            let numbers = || readings.iter().filter_map(Value::as_f64);
            let ends = [numbers().reduce(f64::min), numbers().reduce(f64::max)];
            let [least, most] = ends.map(|end| end.map_or("–".to_owned(), shortest));
            format!("{} readings, {least} … {most}", readings.len())
        }
        _ => single_or_band(table, ["mm", "min_mm", "max_mm"]),
    }
}

/// The tooth thickness, as it was measured or given.
pub(super) fn thickness(stated: &Value) -> String {
    const BARE: [&str; 3] = ["", "min", "max"];
    let bare = |value: &Value| match value {
        Value::Object(_) => single_or_band(value, BARE),
        one => words(one),
    };
    let mut parts = Vec::new();
    for (key, value) in stated.as_object().into_iter().flatten() {
        parts.push(match (key.as_str(), value) {
            ("span", span) => format!(
                "span over {} teeth {} mm",
                words(&span["teeth"]),
                measured(span)
            ),
            ("over_pins", pins) => format!(
                "over pins of {} mm {} mm",
                words(&pins["pin_mm"]),
                measured(pins)
            ),
            ("allowance_um", value) if value.as_f64() == Some(0.0) => "nominal".to_owned(),
            ("allowance_um", value) => format!("allowance {} µm", bare(value)),
            ("base_thickness_mm", value) => format!("base thickness {} mm", bare(value)),
            ("per_tooth_um", Value::Array(values)) if values.is_empty() => continue,
            // The notes below the table compare it.
            ("cross_check", Value::Null) => continue,
            ("cross_check", _) => "cross-check: see below".to_owned(),
            ("per_tooth_um", Value::Array(values)) => {
                format!("{} values tooth by tooth", values.len())
            }
            (other, value) => format!("{other} {}", words(value)),
        });
    }
    parts.join(", ")
}

/// A value that may have been found from readings: no more than four decimals.
fn found(value: &Value) -> String {
    let full = words(value);
    match value.as_f64() {
        Some(number) => {
            let short = shortest(rounded(number, 4));
            if short.len() < full.len() {
                short
            } else {
                full
            }
        }
        None => full,
    }
}

/// `F_r`, µm.
pub(super) fn runout(stated: &Value) -> String {
    match &stated["total_um"] {
        Value::Null => "0".to_owned(),
        total => found(total),
    }
}

/// The tooth it points to.
pub(super) fn high_tooth(stated: &Value) -> String {
    found(&stated["high_tooth"])
}

/// What kind of pitch deviations, and how many; `by_tooth`: the teeth differ in thickness.
pub(super) fn pitch(stated: &Value, by_tooth: bool) -> String {
    let values = |flank: &str| stated[flank].as_array().map_or(0, Vec::len);
    match values("right_um") + values("left_um") {
        0 if by_tooth => "not given; those shown below follow from the thickness tooth by tooth, half of it to each flank".to_owned(),
        0 => "not given".to_owned(),
        _ => format!(
            "{}, {} axis, {} + {} values",
            words(&stated["kind"]),
            words(&stated["axis"]),
            values("right_um"),
            values("left_um")
        ),
    }
}
