//! A gear file: one gear without a mate.

use super::gear::GearPart;
use super::node::Node;
use super::pair_file::names;
use super::place::Place;
use super::problems::Problems;
use super::read::{GearEntry, GearsFile};
use super::table::Table;
use gearlash::analysis::study::Material;
use std::path::Path;

const KEYS: &[&str] = &["title", "gear"];

/// Whether these are the entries of a gear file: it has `[gear]`.
pub fn is_one(entries: &[(String, Node)]) -> bool {
    entries.iter().any(|(key, _)| key == "gear")
}

/// Reads the gear file at `path`.
pub fn read(
    path: &Path,
    place: &Place,
    entries: &[(String, Node)],
    problems: &mut Problems,
) -> Option<GearsFile> {
    let table = Table::new("", place, entries, KEYS, problems);
    let (stem, title) = names(&table, path, problems);
    let part = GearPart::read(&table, "gear", problems);
    let gear = part.as_built?;
    let materials = match gear.is_band() {
        true => vec![
            (Material::Most, gear.most().clone()),
            (Material::Least, gear.least().clone()),
        ],
        false => vec![(Material::AsMeasured, gear.most().clone())],
    };
    Some(GearsFile {
        title: title?,
        stem,
        gears: vec![GearEntry {
            name: "gear",
            materials,
            spec: part.spec?,
        }],
        temperature_c: None,
        warnings: part.warnings,
        remarks: part.remarks,
        sources: place.sources(),
    })
}
