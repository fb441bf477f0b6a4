//! A gear file: one gear without a mate.

use super::check::Checked;
use super::gear::{GearPart, materials};
use super::pair_file::names;
use super::read::{GearEntry, GearsFile};
use super::spec::GEAR;
use crate::Tree;
use gearlash::gear::AsBuilt;

/// Whether `file` is a gear file: it has `[gear]`.
pub fn is_one(file: &Tree) -> bool {
    file.entries.iter().any(|(key, _)| key == "gear")
}

/// Reads the gear file `file`.
pub fn read(file: &Tree) -> Option<GearsFile> {
    let checked = Checked::new(&GEAR, file.table());
    let (stem, title) = names(&checked, file.path);
    let part = GearPart::read(&checked, "gear");
    let gear = part.as_built?;
    Some(GearsFile {
        title: title?,
        stem,
        gears: vec![GearEntry {
            name: "gear",
            materials: materials(&gear, AsBuilt::clone),
            drawn: Vec::new(),
            spec: part.spec?,
        }],
        temperature_c: None,
        warnings: part.warnings,
        remarks: part.remarks,
        sources: file.reading.sources(),
    })
}
