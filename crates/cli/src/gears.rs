//! Gears, materials and teeth on the command line.

use crate::error::Error;
use clap::ValueEnum;
use gearlash::analysis::study::{Material, Study};
use gearlash::pair::Member;
use gearlash_files::{GearEntry, GearsFile};
use std::path::Path;

/// `--gear`, `--at`.
#[derive(Clone, Copy, ValueEnum)]
pub(super) enum GearName {
    /// Gear 1
    Wheel,
    /// Gear 2
    Pinion,
}

/// `--material`.
#[derive(Clone, Copy, ValueEnum)]
pub(super) enum MaterialName {
    /// Teeth at their thickest
    Most,
    /// Teeth at their thinnest
    Least,
}

impl GearName {
    /// The gear of a pair.
    pub(super) fn member(self) -> Member {
        match self {
            GearName::Wheel => Member::Wheel,
            GearName::Pinion => Member::Pinion,
        }
    }
}

impl MaterialName {
    /// The material.
    pub(super) fn material(self) -> Material {
        match self {
            MaterialName::Most => Material::Most,
            MaterialName::Least => Material::Least,
        }
    }
}

/// A gear of a file, one of its materials, and the gear in that material.
pub(super) type Chosen<'a, T> = (&'a GearEntry, Material, T);

/// The requested gears and materials, in the order of the file; `materials` are those of a gear.
///
/// # Errors
/// [`Error::Usage`] where the file has one gear only and one of a pair is requested.
pub(super) fn choose<'a, T>(
    path: &Path,
    gear: Option<GearName>,
    material: Option<MaterialName>,
    file: &'a GearsFile,
    materials: impl Fn(&'a GearEntry) -> Vec<(Material, T)>,
) -> Result<Vec<Chosen<'a, T>>, Error> {
    let name = gear.map(|gear| gear.member().name());
    let material = material.map(MaterialName::material);
    let mut chosen = Vec::new();
    for gear in &file.gears {
        if name.is_some_and(|name| name != gear.name) {
            continue;
        }
        for (of, found) in materials(gear) {
            // A single thickness is both ends of its tolerance.
            if material.is_none_or(|material| of == material || of == Material::AsMeasured) {
                chosen.push((gear, of, found));
            }
        }
    }
    match (chosen.is_empty(), name) {
        (true, Some(name)) => Err(Error::Usage(format!(
            "--gear {name}: {} has one gear only; leave --gear out",
            path.display()
        ))),
        _ => Ok(chosen),
    }
}

/// Wheel and pinion tooth, such as `11,11`.
pub(super) fn teeth(text: &str) -> Result<(u32, u32), String> {
    let parsed = text.split_once(',').and_then(|(wheel, pinion)| {
        Some((wheel.trim().parse().ok()?, pinion.trim().parse().ok()?))
    });
    parsed.ok_or_else(|| "two tooth numbers are needed, wheel,pinion, such as 11,11".to_owned())
}

/// The material of `study` that `--material` names.
pub(super) fn material(name: MaterialName, study: &Study) -> Result<Material, Error> {
    match study.material_count() {
        2 => Ok(name.material()),
        _ => Err(Error::usage(
            "--material: this pair file states one thickness a gear; leave the option out",
        )),
    }
}
