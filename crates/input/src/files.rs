//! The content of a file: the study or the gears, and the data of the file itself.

use crate::check::check;
use crate::gear::GearPart;
use crate::names;
use crate::outlines::DrawingRead;
use crate::spec::{EitherGearSpec, GEAR, PairSpec};
use crate::temperature::REFERENCE_C;
use gearlash::analysis::study::{Material, Study};
use gearlash::error::{Error, GearError};
use gearlash::gear::AsBuilt;
use gearlash::metrology::Toleranced;
use gearlash::outline::OutlineGear;
use gearlash::pair::Member;
use gearlash_text::numbers::shortest;
use gearlash_text::{Sources, Table};

/// A pair file, understood.
#[derive(Debug, Clone, PartialEq)]
pub struct PairFile {
    /// The study of the file.
    pub study: Study,
    /// File stem, the name of the folder for results.
    pub stem: String,
    /// The input as understood: keys as in a pair file, defaults filled in. Read as a pair file
    /// (beside the same measured file) it gives the same study.
    pub spec: PairSpec,
    /// The content of the drawings of wheel and pinion; `None` for a gear given by data.
    pub drawings: [Option<DrawingRead>; 2],
    /// A sentence on what results leave out for lack of data.
    pub left_out: Option<&'static str>,
    /// Warnings, for standard error.
    pub warnings: Vec<String>,
    /// Remarks, for standard error.
    pub remarks: Vec<String>,
    /// The files it was read from.
    pub sources: Sources,
}

impl PairFile {
    /// The pair at other centre distances, mm.
    ///
    /// # Errors
    /// As [`Study::at`].
    pub fn at(mut self, center_distances: Vec<f64>) -> Result<PairFile, Error> {
        self.spec.assembly = self.spec.assembly.at(center_distances.clone());
        self.study = self.study.at(center_distances)?;
        Ok(self)
    }
}

/// The error for a centre distance that is not possible, in the keys of pair files.
pub fn distance_refused(reason: &Error) -> String {
    match reason {
        Error::Gear(GearError::MeasuredRows) => {
            "without [sweep] exactly the rows of [measured] are run, at their centre distances; add [sweep] to run others".to_owned()
        }
        other => other.to_string(),
    }
}

/// One gear of a file, for commands that need no mate.
#[derive(Debug, Clone, PartialEq)]
pub struct GearEntry {
    /// `wheel` or `pinion` of a pair file, `gear` of a gear file.
    pub name: &'static str,
    /// Its materials: `AsMeasured` alone, or `Most` and `Least`. Empty in a file with an outline.
    pub materials: Vec<(Material, AsBuilt)>,
    /// Its materials in a file with an outline.
    pub drawn: Vec<(Material, OutlineGear)>,
    /// Its table as understood, defaults filled in.
    pub spec: EitherGearSpec,
}

/// The gears of a gear file or a pair file.
#[derive(Debug, Clone, PartialEq)]
pub struct GearsFile {
    /// Title; the file stem when the file has none.
    pub title: String,
    /// File stem, the name of the folder for results.
    pub stem: String,
    /// One gear, or wheel and pinion.
    pub gears: Vec<GearEntry>,
    /// The temperature of the gears, °C, where a pair file states one; else lengths are those at 20 °C.
    pub temperature_c: Option<f64>,
    /// Warnings, for standard error.
    pub warnings: Vec<String>,
    /// Remarks, for standard error.
    pub remarks: Vec<String>,
    /// The files it was read from.
    pub sources: Sources,
}

impl GearsFile {
    /// The gear of a gear file, or the `member` of a pair file.
    pub(crate) fn of(&self, member: Member) -> Option<&GearEntry> {
        let is_own = |gear: &&GearEntry| gear.name == "gear" || gear.name == member.name();
        self.gears.iter().find(is_own)
    }
}

impl From<PairFile> for GearsFile {
    fn from(file: PairFile) -> GearsFile {
        let Study {
            title,
            mut materials,
            drawn,
            ..
        } = file.study;
        for (_, _, pinion) in &mut materials {
            *pinion = pinion.in_measuring_plane();
        }
        let (mut gears, specs) = (Vec::new(), [file.spec.wheel, file.spec.pinion]);
        for (k, spec) in specs.into_iter().enumerate() {
            let name = ["wheel", "pinion"][k];
            gears.push(GearEntry {
                name,
                materials: of_one(&materials, |(of, wheel, pinion)| (*of, [wheel, pinion][k])),
                drawn: of_one(&drawn, |(of, wheel, pinion)| (*of, [wheel, pinion][k])),
                spec,
            });
        }
        let temperature_c = file.spec.assembly.temperature_c;
        let mut warnings = file.warnings;
        warnings.extend(temperature_c.filter(|celsius| *celsius != REFERENCE_C).map(|celsius| {
            let celsius = shortest(celsius);
            format!("assembly.temperature_c = {celsius}: the gears have their lengths at {celsius} °C; for those at {REFERENCE_C} °C remove it")
        }));
        GearsFile {
            title,
            stem: file.stem,
            gears,
            temperature_c,
            warnings,
            remarks: file.remarks,
            sources: file.sources,
        }
    }
}

/// A gear in each of its materials. One with a single thickness has it in both materials of its pair.
fn of_one<'a, P, B: Clone + PartialEq + 'a>(
    pairs: &'a [P],
    gear: impl Fn(&'a P) -> (Material, &'a B),
) -> Vec<(Material, B)> {
    let mut materials: Vec<(Material, B)> = Vec::new();
    for (material, gear) in pairs.iter().map(gear) {
        match materials.first_mut() {
            Some(first) if first.1 == *gear => first.0 = Material::AsMeasured,
            _ => materials.push((material, gear.clone())),
        }
    }
    materials
}

/// A gear in each of its materials.
fn in_materials<T>(gear: Toleranced<T>) -> Vec<(Material, T)> {
    match gear {
        Toleranced::Single(gear) => vec![(Material::AsMeasured, gear)],
        Toleranced::Band { least, most } => {
            vec![(Material::Most, most), (Material::Least, least)]
        }
    }
}

pub(crate) fn gear_file(file: &Table) -> Option<GearsFile> {
    check(&GEAR, file);
    let (stem, title) = names(file);
    let part = GearPart::read(file, "gear");
    let (title, spec) = (title?, part.spec?);
    Some(GearsFile {
        title,
        stem,
        gears: vec![GearEntry {
            name: "gear",
            materials: part.as_built.map_or_else(Vec::new, in_materials),
            drawn: part.drawn.map_or_else(Vec::new, in_materials),
            spec,
        }],
        temperature_c: None,
        warnings: part.warnings,
        remarks: part.remarks,
        sources: file.reading().sources(),
    })
}
