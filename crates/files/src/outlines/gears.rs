//! A gear file with an outline, or a drawing by itself.

use super::gear::{self, OutlinePart};
use super::pair::{OutlineOptions, outline_table};
use crate::Tree;
use crate::check::Checked;
use crate::gear::materials;
use crate::pair_file::names;
use crate::read::{AnyGears, GearEntry};
use crate::spec::{EitherGearSpec, GEAR};
use gearlash::outline::OutlineGear;
use std::path::Path;

/// Reads a gear file with an outline.
pub(crate) fn read(tree: &Tree) -> Option<AnyGears> {
    let file = Checked::new(&GEAR, tree.table());
    let (stem, title) = names(&file, tree.path);
    let OutlinePart {
        gears,
        spec,
        remarks,
        ..
    } = gear::read(&file, "gear")?;
    Some(AnyGears {
        title: title?,
        stem,
        gears: vec![GearEntry {
            name: "gear",
            materials: Vec::new(),
            drawn: materials(&gears, OutlineGear::clone),
            spec: EitherGearSpec::Outline(Box::new(spec)),
        }],
        temperature_c: None,
        warnings: Vec::new(),
        remarks,
        sources: tree.reading.sources(),
    })
}

/// The text of the gear file for a drawing alone.
pub(crate) fn of_drawing(path: &Path, options: &OutlineOptions) -> String {
    outline_table("gear", path, options)
}
