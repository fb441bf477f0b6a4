//! Another centre distance in the text of a pair file.

use gearlash_text::numbers::trimmed;
use gearlash_text::source::is_json;
use serde::Deserialize;
use serde_json::value::RawValue;
use std::ops::Range;
use std::path::Path;
use toml::de::DeTable;

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
        let value = DISTANCE.iter().find_map(|key| assembly.get(*key))?;
        let is_inline = |span: &Range<usize>| text[span.clone()].starts_with('{');
        Some(value.span()).filter(|span| !value.get_ref().is_table() || is_inline(span))?
    };
    let written = trimmed(mm, 0, 6);
    let new = [&text[..range.start], &written, &text[range.end..]].concat();
    Some((new, text[range].to_owned()))
}

/// The key of the centre distance, and its British spelling.
const DISTANCE: [&str; 2] = ["center_distance_mm", "centre_distance_mm"];

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
