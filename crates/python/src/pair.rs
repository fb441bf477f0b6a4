//! Two gears and their assembly.

use crate::error::Outcome;
use crate::gear::chosen;
use gearlash::analysis::study::{Material, Study};
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash::pair::{Mating, Member};
use gearlash_input::{PairFile, distance_refused};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// A pair as stated by a pair file.
#[pyclass(frozen, module = "gearlash._core")]
pub struct Pair {
    pub file: PairFile,
}

impl Pair {
    pub fn study(&self) -> &Study {
        &self.file.study
    }

    /// The gears in the material called `material` (default: the most, where there are two) at `distance` mm (default: the least
    /// of the pair).
    pub fn assembly(
        &self,
        distance: Option<f64>,
        material: Option<&str>,
    ) -> Outcome<(Material, AssembledPair)> {
        let study = self.study();
        let distance = distance.or(study.center_distances.first().copied());
        let none = "the pair has no centre distance; give center_distance_mm";
        let distance = distance.ok_or(none)?;
        let refused = |reason| format!("center_distance_mm = {distance}: {reason}");
        let pairs = study.pairs(distance).map_err(refused)?;
        chosen(pairs.into_iter(), material)
    }
}

/// The mating of these `teeth` in `assembly`. A tooth that does not exist, or a fraction of too many pitches, is an error.
pub fn mating(
    assembly: &AssembledPair,
    [wheel, pinion]: [i64; 2],
    left: bool,
    fraction: f64,
) -> Outcome<Mating> {
    for (member, tooth) in Member::BOTH.into_iter().zip([wheel, pinion]) {
        let teeth = assembly.teeth(member);
        if !(1..=i64::from(teeth)).contains(&tooth) {
            let name = member.name();
            let has = format!("the {name} has teeth 1 … {teeth}, not {tooth}");
            return Err(format!("mating {wheel},{pinion}: {has}").into());
        }
    }
    if !(fraction.abs() <= 1000.0) {
        let reason = format!("fraction = {fraction}: a number of pitches between -1000 and 1000");
        return Err(reason.into());
    }
    Ok(Mating {
        wheel_tooth: wheel as u32,
        pinion_tooth: pinion as u32,
        flank: if left { Side::Left } else { Side::Right },
        fraction,
    })
}

#[pymethods]
impl Pair {
    /// The pair of `text` with the keys of a pair file.
    #[staticmethod]
    fn from_text(py: Python<'_>, name: &str, text: &str) -> Outcome<Pair> {
        let file = py.detach(|| gearlash_input::read_text(Path::new(name), text))?;
        Ok(Pair { file })
    }

    /// The pair of the pair file at `path`.
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> Outcome<Pair> {
        let file = py.detach(|| gearlash_input::read(&path))?;
        Ok(Pair { file })
    }

    /// The pair at other centre distances, mm.
    fn at(&self, distances: Vec<f64>) -> Outcome<Pair> {
        if let Some(wrong) = distances.iter().find(|distance| !distance.is_finite()) {
            return Err(format!("center_distance_mm = {wrong}: a number of mm").into());
        }
        let refused = |reason| format!("center_distance_mm: {}", distance_refused(&reason));
        let file = self.file.clone().at(distances).map_err(refused)?;
        Ok(Pair { file })
    }

    /// The input as JSON: keys of a pair file, defaults filled in.
    fn spec(&self) -> Outcome<String> {
        Ok(serde_json::to_string(&self.file.spec)?)
    }

    #[getter]
    fn title(&self) -> &str {
        &self.study().title
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.file.warnings.clone()
    }

    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.file.remarks.clone()
    }

    /// Names of its materials.
    #[getter]
    fn materials(&self) -> Vec<&'static str> {
        self.study().material_names().map(Material::name).collect()
    }

    /// Its centre distances, mm.
    #[getter]
    fn center_distances_mm(&self) -> Vec<f64> {
        self.study().center_distances.clone()
    }

    /// Ends of the common face, mm from the wheel's measuring plane; `None` where all sections are equal.
    #[getter]
    fn face_mm(&self) -> Option<[f64; 2]> {
        let study = self.study();
        study.varies_along_face().then_some(study.face)
    }

    /// Teeth of wheel and pinion.
    #[getter]
    fn teeth(&self) -> Vec<u32> {
        self.study().teeth().to_vec()
    }
}
