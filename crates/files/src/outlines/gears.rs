//! Gears that are measured as outlines: of a pair or gear file of which one is a drawing, or of a drawing by itself.

use super::gear::{self, OutlinePart};
use super::pair::{OutlinePairFile, outline_table};
use crate::Tree;
use crate::check::Checked;
use crate::pair_file::names;
use crate::sources::Sources;
use crate::spec::{EitherGearSpec, GEAR};
use gearlash::analysis::study::Material;
use gearlash::outline::OutlineGear;
use std::path::Path;

/// Gears by their outline, for commands that need no mate. A gear by its data, of a pair with a drawing, has its exact curves.
#[derive(Debug, Clone)]
pub struct OutlineGearsFile {
    /// Title; the file stem when the file has none.
    pub title: String,
    /// The gears.
    pub gears: Vec<OutlineGearEntry>,
    /// Warnings, for standard error.
    pub warnings: Vec<String>,
    /// Remarks, for standard error.
    pub remarks: Vec<String>,
    /// The files it was read from.
    pub sources: Sources,
}

/// One of them, in one material.
#[derive(Debug, Clone)]
pub struct OutlineGearEntry {
    /// `wheel` or `pinion` of a pair file, else `gear`.
    pub name: &'static str,
    /// Which thickness; a drawing has one.
    pub material: Material,
    /// The gear.
    pub gear: OutlineGear,
}

/// Reads a gear file whose gear is an outline.
pub(crate) fn read(tree: &Tree) -> Option<OutlineGearsFile> {
    let file = Checked::new(&GEAR, tree.table());
    let (_, title) = names(&file, tree.path);
    let OutlinePart { gear, remarks, .. } = gear::read(&file, "gear")?;
    Some(OutlineGearsFile {
        title: title?,
        gears: vec![OutlineGearEntry {
            name: "gear",
            material: Material::AsMeasured,
            gear,
        }],
        warnings: Vec::new(),
        remarks,
        sources: tree.reading.sources(),
    })
}

/// The gear file that says the same as a drawing alone.
pub(crate) fn of_drawing(path: &Path, units: Option<&str>, center: Option<&str>) -> String {
    outline_table("gear", path, units, center)
}

impl From<OutlinePairFile> for OutlineGearsFile {
    fn from(pair: OutlinePairFile) -> OutlineGearsFile {
        let (wheel, pinion) = (&pair.spec.wheel, &pair.spec.pinion);
        let mut gears = Vec::new();
        for (name, spec) in [("wheel", wheel), ("pinion", pinion)] {
            for (material, wheel, pinion) in &pair.study.drawn {
                let gear = if name == "wheel" { wheel } else { pinion };
                // A drawing is the same in every material of its mate.
                let drawn = matches!(spec, EitherGearSpec::Outline(_));
                gears.push(OutlineGearEntry {
                    name,
                    material: if drawn {
                        Material::AsMeasured
                    } else {
                        *material
                    },
                    gear: gear.clone(),
                });
                if drawn {
                    break;
                }
            }
        }
        OutlineGearsFile {
            title: pair.study.title,
            gears,
            warnings: pair.warnings,
            remarks: pair.remarks,
            sources: pair.sources,
        }
    }
}
