//! The content of a file: the study or the gears, and the data of the file itself.

use crate::sources::Sources;
use crate::spec::{CenterDistanceSpec, GearSpec, PairSpec};
use gearlash::analysis::study::{Material, Study};
use gearlash::error::{Error, GearError};
use gearlash::gear::AsBuilt;

/// A pair file, understood.
#[derive(Debug, Clone, PartialEq)]
pub struct PairFile {
    /// The study that it asks for.
    pub study: Study,
    /// File stem, the name of the folder for results.
    pub stem: String,
    /// The input as understood: keys as in a pair file, defaults filled in. Read as a pair file
    /// (beside the same measured file) it gives the same study.
    pub spec: PairSpec,
    /// Warnings, for standard error.
    pub warnings: Vec<String>,
    /// Remarks, for standard error.
    pub remarks: Vec<String>,
    /// The files it was read from.
    pub sources: Sources,
}

/// One gear of a file, for what needs no mate.
#[derive(Debug, Clone, PartialEq)]
pub struct GearEntry {
    /// `wheel` or `pinion` of a pair file, `gear` of a gear file.
    pub name: &'static str,
    /// In the thicknesses it states: `AsMeasured` alone, or `Most` and `Least`.
    pub materials: Vec<(Material, AsBuilt)>,
    /// Its table as understood, defaults filled in.
    pub spec: GearSpec,
}

impl PairFile {
    /// The pair at other centre distances, mm.
    ///
    /// # Errors
    /// As [`Study::at`].
    pub fn at(mut self, center_distances: Vec<f64>) -> Result<PairFile, Error> {
        self.spec.assembly.center_distance_mm =
            CenterDistanceSpec::Distances(center_distances.clone());
        self.study = self.study.at(center_distances)?;
        Ok(self)
    }
}

/// The reason why a study has no other centre distances, in the keys of pair files.
pub fn distance_refused(reason: &Error) -> String {
    match reason {
        Error::Gear(GearError::MeasuredRows) => {
            "without [sweep] exactly the rows of [measured] are run, at their centre distances; add [sweep] to run others".to_owned()
        }
        other => other.to_string(),
    }
}

/// The gears of a gear file or a pair file.
///
/// Made by [`crate::read_gears`].
#[derive(Debug, Clone, PartialEq)]
pub struct GearsFile {
    /// Title; the file stem when the file has none.
    pub title: String,
    /// File stem, the name of the folder for results.
    pub stem: String,
    /// One gear, or wheel and pinion.
    pub gears: Vec<GearEntry>,
    /// The temperature that they have, °C, where a pair file states one; lengths are those of 20 °C elsewhere.
    pub temperature_c: Option<f64>,
    /// Warnings, for standard error.
    pub warnings: Vec<String>,
    /// Remarks, for standard error.
    pub remarks: Vec<String>,
    /// The files it was read from.
    pub sources: Sources,
}

impl From<PairFile> for GearsFile {
    fn from(file: PairFile) -> GearsFile {
        let study = file.study;
        let gear = |name, spec, of: fn(&(Material, AsBuilt, AsBuilt)) -> &AsBuilt| {
            let mut materials: Vec<(Material, AsBuilt)> = Vec::new();
            for pair in &study.materials {
                // A gear with a single thickness has it in both materials of its pair.
                match materials.first_mut() {
                    Some(first) if first.1 == *of(pair) => first.0 = Material::AsMeasured,
                    _ => materials.push((pair.0, of(pair).clone())),
                }
            }
            GearEntry {
                name,
                materials,
                spec,
            }
        };
        GearsFile {
            gears: vec![
                gear("wheel", file.spec.wheel, |pair| &pair.1),
                gear("pinion", file.spec.pinion, |pair| &pair.2),
            ],
            title: study.title,
            temperature_c: file.spec.assembly.temperature_c,
            stem: file.stem,
            warnings: file.warnings,
            remarks: file.remarks,
            sources: file.sources,
        }
    }
}
