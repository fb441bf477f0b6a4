//! `[assembly]`: the assembly of the two gears, checked together with them; another centre distance in the text of a pair file.

use super::known_gear::KnownGear;
use super::shafts;
use super::spec::{AssemblySpec, CenterDistanceSpec};
use gearlash::error::GearError;
use gearlash_text::numbers::{ascii, trimmed};
use gearlash_text::source::is_json;
use gearlash_text::{Node, Table};
use serde::Deserialize;
use serde_json::value::RawValue;
use std::collections::HashSet;
use std::ops::Range;
use std::path::Path;
use toml::de::DeTable;

/// Reads `[assembly]`; the centre distances may be absent when not `needed`.
pub fn read(file: &Table, needed: bool) -> Option<AssemblySpec> {
    const KEY: &str = "assembly.center_distance_mm";
    let empty = Node::Table(Vec::new());
    let stated = file.read::<AssemblySpec>("assembly")?;
    let spec = stated.or_else(|| empty.to::<AssemblySpec>().ok())?;
    shafts::check_keys(file, &spec)?;
    let CenterDistanceSpec::Distances(list) = &spec.center_distance_mm else {
        return Some(spec);
    };
    if list.is_empty() && needed {
        return file.refuse(
            KEY,
            "missing, expected a number of mm above 0 and up to 1e9",
            "add `center_distance_mm` to [assembly]",
        );
    }
    let mut seen = HashSet::new();
    let duplicate = list.iter().find(|mm| !seen.insert(mm.to_bits()));
    if let Some(duplicate) = duplicate {
        return file.refuse(
            spelling(file),
            format!("{duplicate:?} is listed twice, allowed is each distance once"),
            "list each centre distance to be run once",
        );
    }
    Some(spec)
}

/// The key of the centre distances, in British or American spelling.
fn spelling(file: &Table) -> &'static str {
    let british = "assembly.centre_distance_mm";
    if file.has(british) {
        british
    } else {
        "assembly.center_distance_mm"
    }
}

/// Reports module or pressure angle that the gears do not share; `None` then, or when either is not known.
pub fn check_shared(file: &Table, wheel: &KnownGear, pinion: &KnownGear) -> Option<()> {
    let mut shared = Some(());
    for (name, wheel, pinion) in [
        ("module_mm", wheel.module_mm, pinion.module_mm),
        (
            "pressure_angle_deg",
            wheel.pressure_angle_deg,
            pinion.pressure_angle_deg,
        ),
    ] {
        let (Some(wheel), Some(pinion)) = (wheel, pinion) else {
            shared = None;
            continue;
        };
        if wheel != pinion {
            file.add(
                &format!("pinion.{name}"),
                format!("differs from wheel.{name} = {wheel:?}, must be equal on both gears"),
                "correct one of them: gears of different basic racks do not mesh",
            );
            shared = None;
        }
    }
    shared
}

/// The fault of the centre distance `a`, mm, where the base circles overlap; `base_radii` is the sum of both radii.
pub fn overlap(a: f64, base_radii: f64) -> Option<String> {
    let overlap = GearError::BaseCirclesOverlap {
        center_distance_mm: a,
        least_mm: base_radii,
    };
    (a <= base_radii).then(|| overlap.to_string())
}

/// Reports each distance of the pair file at which base circles overlap.
pub fn check_distances(file: &Table, list: &[f64], base_radii: f64) {
    let key = spelling(file);
    file.reading().list(key, || {
        for reason in list.iter().filter_map(|&a| overlap(a, base_radii)) {
            file.add(
                key,
                reason,
                "check the distance, teeth and module: a pair without profile shift runs at m (z_1 + z_2)/2",
            );
        }
        Some(())
    });
}

/// Reports a bearing clearance that lets the base circles overlap at the least good distance of `list`.
pub fn check_clearance(file: &Table, list: &[f64], base_radii: f64, clearance: f64) {
    let least = list
        .iter()
        .copied()
        .filter(|&a| a > base_radii)
        .min_by(f64::total_cmp);
    if let Some(a) = least.filter(|&a| a - clearance <= base_radii) {
        file.add(
            "assembly.bearing_clearance_mm",
            format!(
                "lets the gears at {a:?} mm approach to {} mm, where base circles overlap: allowed is both clearances together below {} mm",
                ascii(a - clearance, 6),
                ascii(a - base_radii, 6)
            ),
            "check the unit: mm, as radial play",
        );
    }
}

/// The pair file `text` with the centre distance `mm`, and the statement that it replaces; `None` where the file states none in
/// millimetres as one value.
///
/// ```
/// use gearlash_input::with_distance;
/// use std::path::Path;
///
/// let toml = "[assembly]\ncenter_distance_mm = [50, 51] # nominal\n";
/// let (text, before) = with_distance(Path::new("pair.toml"), toml, 50.5).unwrap();
/// assert_eq!(text, "[assembly]\ncenter_distance_mm = 50.5 # nominal\n");
/// assert_eq!(before, "[50, 51]");
///
/// let json = r#"{"assembly": {"centre_distance_mm": 50}}"#;
/// let (text, _) = with_distance(Path::new("pair.json"), json, 50.5).unwrap();
/// assert_eq!(text, r#"{"assembly": {"centre_distance_mm": 50.5}}"#);
///
/// // A table of its own is no one value.
/// let table = "[assembly.center_distance_mm]\nnear = 50\nfar = 51\n";
/// assert_eq!(with_distance(Path::new("pair.toml"), table, 50.5), None);
/// ```
pub fn with_distance(path: &Path, text: &str, mm: f64) -> Option<(String, String)> {
    let range = if is_json(path, text) {
        let file: JsonFile = serde_json::from_str(text).ok()?;
        let value = file.assembly.center_distance_mm.get();
        // The value is a part of the text.
        let start = value.as_ptr().addr() - text.as_ptr().addr();
        start..start + value.len()
    } else {
        let file = DeTable::parse(text).ok()?;
        let assembly = file.get_ref().get("assembly")?.get_ref().as_table()?;
        let value = DISTANCE_KEYS.iter().find_map(|key| assembly.get(*key))?;
        let is_inline = |span: &Range<usize>| text[span.clone()].starts_with('{');
        Some(value.span()).filter(|span| !value.get_ref().is_table() || is_inline(span))?
    };
    let written = trimmed(mm, 0, 6);
    let new = [&text[..range.start], &written, &text[range.end..]].concat();
    Some((new, text[range].to_owned()))
}

/// The key of the centre distance, and its British spelling.
const DISTANCE_KEYS: [&str; 2] = ["center_distance_mm", "centre_distance_mm"];

#[derive(Deserialize)]
struct JsonFile<'a> {
    #[serde(borrow)]
    assembly: JsonAssembly<'a>,
}

#[derive(Deserialize)]
struct JsonAssembly<'a> {
    #[serde(borrow, alias = "centre_distance_mm")]
    center_distance_mm: &'a RawValue,
}
