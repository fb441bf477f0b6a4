//! A gear file: one gear without a mate.

use super::check::Checked;
use super::gear::{GearPart, materials};
use super::read::{GearEntry, GearsFile};
use super::spec::GEAR;
use crate::Tree;
use gearlash::gear::AsBuilt;
use gearlash::outline::OutlineGear;

/// Reads the gear file `file`.
pub fn read(file: &Tree) -> Option<GearsFile> {
    let checked = Checked::new(&GEAR, file.table());
    let (stem, title) = file.names(&checked);
    let part = GearPart::read(&checked, "gear");
    let (title, spec) = (title?, part.spec?);
    let built = part.as_built.as_ref();
    let drawn = part.drawn.as_ref();
    Some(GearsFile {
        title,
        stem,
        gears: vec![GearEntry {
            name: "gear",
            materials: built.map_or_else(Vec::new, |gear| materials(gear, AsBuilt::clone)),
            drawn: drawn.map_or_else(Vec::new, |gear| materials(gear, OutlineGear::clone)),
            spec,
        }],
        temperature_c: None,
        warnings: part.warnings,
        remarks: part.remarks,
        sources: file.reading.sources(),
    })
}
