//! One gear.

use crate::error::Outcome;
use gearlash::analysis::study::Material;
use gearlash::gear::AsBuilt;
use gearlash_input::spec::GearSpec;
use gearlash_input::{GearEntry, GearsFile};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// A gear by its data and measurements.
#[pyclass(frozen, module = "gearlash._core")]
pub struct Gear {
    pub title: String,
    pub entry: GearEntry,
    pub spec: GearSpec,
    #[pyo3(get)]
    warnings: Vec<String>,
    #[pyo3(get)]
    remarks: Vec<String>,
}

impl Gear {
    fn of(file: GearsFile, name: Option<&str>) -> Outcome<Gear> {
        let mut gears = file.gears;
        let place = match name {
            None if gears.len() == 1 => Some(0),
            None => None,
            Some(name) => gears.iter().position(|gear| gear.name == name),
        };
        let Some(place) = place else {
            let names: Vec<&str> = gears.iter().map(|gear| gear.name).collect();
            let which = names.join(", ");
            return Err(format!("which gear? the file has: {which}").into());
        };
        let entry = gears.swap_remove(place);
        let spec = entry.spec.data().cloned();
        Ok(Gear {
            title: file.title,
            entry,
            spec: spec.ok_or("the gear is given by an outline")?,
            warnings: file.warnings,
            remarks: file.remarks,
        })
    }

    /// The gear in a material; without a name the one with the most, where there are two.
    pub fn as_built(&self, name: Option<&str>) -> Outcome<(Material, &AsBuilt)> {
        let materials = self.entry.materials.iter();
        let materials = materials.map(|(material, gear)| (*material, gear));
        chosen(materials, name)
    }

    fn any(&self) -> &AsBuilt {
        &self.entry.materials[0].1
    }
}

/// The one of `materials` called `name`, or the first.
pub fn chosen<T>(
    materials: impl Iterator<Item = (Material, T)>,
    name: Option<&str>,
) -> Outcome<(Material, T)> {
    let named = |material: &Material| name.is_none_or(|name| name == material.name());
    let mut names = Vec::new();
    let mut materials = materials.inspect(|(material, _)| names.push(material.name()));
    let found = materials.find(|(material, _)| named(material));
    found.ok_or_else(|| {
        let (name, has) = (name.unwrap_or_default(), names.join(", "));
        format!("material = {name}: not stated here, which has: {has}").into()
    })
}

#[pymethods]
impl Gear {
    /// The gear of `text` with the keys of a gear file.
    #[staticmethod]
    fn from_text(py: Python<'_>, name: &str, text: &str) -> Outcome<Gear> {
        let read = py.detach(|| gearlash_input::read_gears_text(Path::new(name), text));
        Gear::of(read?, None)
    }

    /// The gear of the gear file or pair file at `path`; `name` selects a gear of a pair.
    #[staticmethod]
    #[pyo3(signature = (path, name=None))]
    fn read(py: Python<'_>, path: PathBuf, name: Option<&str>) -> Outcome<Gear> {
        let read = py.detach(|| gearlash_input::read_gears_by_data(&path));
        Gear::of(read?, name)
    }

    /// Its table as JSON: keys of a gear file, defaults filled in.
    fn spec(&self) -> Outcome<String> {
        Ok(serde_json::to_string(&self.spec)?)
    }

    #[getter]
    fn title(&self) -> &str {
        &self.title
    }

    #[getter]
    fn teeth(&self) -> u32 {
        self.any().gear().basic_data().teeth()
    }

    #[getter]
    fn module_mm(&self) -> f64 {
        self.any().gear().basic_data().module()
    }

    #[getter]
    fn pressure_angle_deg(&self) -> f64 {
        self.any().gear().basic_data().pressure_angle().to_degrees()
    }

    /// β at the reference circle, degrees; 0 for a spur gear.
    #[getter]
    fn helix_angle_deg(&self) -> f64 {
        self.spec.helix_angle_deg.unwrap_or(0.0)
    }

    /// Names of its materials.
    #[getter]
    fn materials(&self) -> Vec<&'static str> {
        let materials = self.entry.materials.iter();
        materials.map(|(material, _)| material.name()).collect()
    }

    /// Base tooth thickness, mm.
    #[pyo3(signature = (material=None))]
    fn base_thickness_mm(&self, material: Option<&str>) -> Outcome<f64> {
        let (_, gear) = self.as_built(material)?;
        Ok(gear.gear().base_thickness())
    }

    /// Diameters of tip, root form and root circle, mm.
    #[pyo3(signature = (material=None))]
    fn diameters_mm(&self, material: Option<&str>) -> Outcome<[f64; 3]> {
        let (_, gear) = self.as_built(material)?;
        let gear = gear.gear();
        Ok([gear.tip_radius(), gear.form_radius(), gear.root_radius()].map(|radius| 2.0 * radius))
    }
}
