//! Which gears of a file, in which material.

use crate::error::Error;
use clap::ValueEnum;
use gearlash::analysis::study::Material;
use gearlash::gear::AsBuilt;
use gearlash_files::{GearEntry, GearsFile};
use std::path::Path;

/// `--gear`.
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
    /// As files name it.
    pub(super) fn name(self) -> &'static str {
        match self {
            GearName::Wheel => "wheel",
            GearName::Pinion => "pinion",
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

/// That a file has no gear of the name asked for.
pub(super) fn one_only(name: &str, file: &Path) -> Error {
    Error::Usage(format!(
        "--gear {name}: {} has one gear only; leave --gear out",
        file.display()
    ))
}

/// The gears and materials asked for, in the order of the file.
///
/// # Errors
/// [`Error::Usage`] where the file has one gear only and one of a pair is asked for.
pub(super) fn choose<'a>(
    file: &Path,
    gear: Option<GearName>,
    material: Option<MaterialName>,
    study: &'a GearsFile,
) -> Result<Vec<(&'a GearEntry, Material, &'a AsBuilt)>, Error> {
    let name = gear.map(GearName::name);
    let material = material.map(MaterialName::material);
    let mut chosen = Vec::new();
    for gear in &study.gears {
        if name.is_some_and(|name| name != gear.name) {
            continue;
        }
        for (of, as_built) in &gear.materials {
            // A single thickness is both ends of its tolerance.
            if material.is_none_or(|material| *of == material || *of == Material::AsMeasured) {
                chosen.push((gear, *of, as_built));
            }
        }
    }
    match (chosen.is_empty(), name) {
        (true, Some(name)) => Err(one_only(name, file)),
        _ => Ok(chosen),
    }
}
