//! A gear file: one gear without a mate.

use super::check::Checked;
use super::gear::{GearPart, materials};
use super::node::Node;
use super::pair_file::names;
use super::place::Place;
use super::problems::Problems;
use super::read::{GearEntry, GearsFile};
use super::spec::GEAR;
use gearlash::gear::AsBuilt;
use std::path::Path;

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
    let table = Checked::new(&GEAR, place, entries, problems);
    let (stem, title) = names(&table, path, problems);
    let part = GearPart::read(&table, "gear", problems);
    let gear = part.as_built?;
    Some(GearsFile {
        title: title?,
        stem,
        gears: vec![GearEntry {
            name: "gear",
            materials: materials(&gear, AsBuilt::clone),
            spec: part.spec?,
        }],
        temperature_c: None,
        warnings: part.warnings,
        remarks: part.remarks,
        sources: place.sources(),
    })
}
