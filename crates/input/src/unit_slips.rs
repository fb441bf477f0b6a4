//! Warnings about numbers that look like another unit, by one rule per unit. Nothing is changed.

use super::spec::{SpurSlopeSpec, each_value};
use gearlash_text::numbers::ascii;
use serde::Serialize;

/// Below this a value in µm looks like one in mm: no shop measures teeth so finely, and 0.5 mm is more than any deviation of a
/// gear that is worth measuring.
const MIN_UM: f64 = 0.5;
/// Below this a value is 0 but for rounding: as mm it would be 0.1 µm, less than the last digit that machines print.
const ROUNDING_UM: f64 = 1e-4;
/// Above this temperature gears of steel lose their hardness, °C.
const MAX_C: f64 = 120.0;
/// Below this helix angle helical teeth are hardly distinct from spur ones, degrees: 1° in radians is 57 times less.
const MIN_HELIX_DEG: f64 = 1.0;
/// Lengths that look like metres below these, mm: no face ends so near to its measuring plane, and no flank is placed so finely.
const MIN_MM: [(&str, f64); 2] = [("face_mm", 0.1), ("flank_offset_mm", 0.001)];

/// Warnings of numbers in the table at `path` that look like another unit.
pub fn warnings(path: &str, table: &impl Serialize) -> Vec<String> {
    let mut table = serde_json::to_value(table).unwrap_or_default();
    // The number of greatest size of each key.
    let mut found: Vec<(String, String, f64)> = Vec::new();
    each_value(&mut table, (path, ""), &mut |path, unit, value| {
        let slope = value.as_str().map(SpurSlopeSpec::of_text);
        let slope = slope.and_then(|slope| slope.parsed());
        let Some(number) = value.as_f64().or(slope.map(|(um, _)| um)) else {
            return;
        };
        let mut known = found.iter_mut();
        match known.find(|(known, of, _)| known == path && of == unit) {
            Some((.., greatest)) if greatest.abs() >= number.abs() => {}
            Some((.., greatest)) => *greatest = number,
            None => found.push((path.to_owned(), unit.to_owned(), number)),
        }
    });
    let slips = found.iter();
    let slips = slips.filter_map(|(path, unit, value)| in_unit(path, unit, *value));
    slips.collect()
}

/// The warning of a key whose greatest number is `value`.
pub fn in_unit(path: &str, unit: &str, value: f64) -> Option<String> {
    let size = value.abs();
    let least_mm = MIN_MM.iter().find(|(key, _)| path.ends_with(key));
    let words = match unit {
        "um" if (ROUNDING_UM..MIN_UM).contains(&size) => format!(
            "the greatest value is {value} µm, less than is measured on teeth: if mm were meant, multiply by 1000 ({value} mm are {} µm)",
            ascii(1000.0 * value, 4)
        ),
        "c" if value > MAX_C => format!(
            "{value} °C is hotter than gears run: if K were meant, write {}; if °F, {}",
            ascii(value - 273.15, 2),
            ascii((value - 32.0) / 1.8, 1)
        ),
        "deg" if path.ends_with("helix_angle_deg") && 0.0 < size && size < MIN_HELIX_DEG => {
            format!(
                "{value}° is hardly a helix: if rad were meant, write {}",
                ascii(value.to_degrees(), 4)
            )
        }
        "mm" if least_mm.is_some_and(|(_, least)| 0.0 < size && size < *least) => {
            format!("{value} mm is less than is made: if m were meant, multiply by 1000")
        }
        _ => return None,
    };
    Some(format!("{path}: {words}"))
}
