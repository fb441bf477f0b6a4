//! What the gauges read, as text, JSON, CSV and as a gear file that states it.

mod by_tooth;
mod charts;
mod csv_files;
mod file_names;
mod gear_file;
mod json;
mod text;

use gearlash::gauge::{Gauged, Unmeasured};
use gearlash::gear::AsBuilt;
use gearlash::study::Material;
use serde_json::Value;

pub use charts::charts;
pub use csv_files::{csv_files, teeth_csv};
pub use file_names::{possible_files, stem};
pub use json::json;
pub use text::text;

/// One gear in one material and what the gauges read on it.
#[derive(Debug)]
pub struct GaugedGear<'a> {
    /// Title of the file.
    pub title: &'a str,
    /// `wheel`, `pinion` or `gear`.
    pub name: &'static str,
    /// Which thickness.
    pub material: Material,
    /// The gear.
    pub gear: &'a AsBuilt,
    /// Its table as understood.
    pub echo: &'a Value,
    /// The readings.
    pub gauged: Gauged,
}

impl GaugedGear<'_> {
    /// How its files begin: `gauge_wheel`, with the material where there are two.
    pub fn stem(&self) -> String {
        stem(self.name, self.material)
    }

    /// Its gear file: name and content.
    ///
    /// # Errors
    /// Where the readings do not say enough for one.
    pub fn gear_file(&self) -> Result<(String, String), Unmeasured> {
        Ok((
            file_names::gear_file_name(&self.stem()),
            gear_file::gear_file(self)?,
        ))
    }

    /// What the gauges did not read on it, and why: a line each.
    pub fn missing(&self) -> Vec<String> {
        let lines = text::missing(&self.gauged);
        let named = |line| format!("{}: {line}", self.words());
        lines.into_iter().map(named).collect()
    }

    /// The gear in a few words.
    fn words(&self) -> String {
        let basic_data = self.gear.gear().basic_data();
        format!(
            "{}, {} teeth, module {} mm, material {}",
            self.name,
            basic_data.teeth(),
            basic_data.module(),
            self.material.name()
        )
    }
}
