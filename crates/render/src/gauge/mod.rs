//! What the gauges read, as text, JSON, CSV and as a gear file that states it.

mod by_tooth;
mod charts;
mod csv_files;
mod file_names;
mod json;
mod text;

use file_names::FileName;
use gearlash::gauge::Gauged;
use gearlash::gear::AsBuilt;
use gearlash::study::Material;
use gearlash_files::spec::GearSpec;
use gearlash_files::{GaugedTables, NoGearFile, gauged_file};

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
    pub spec: &'a GearSpec,
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
    pub fn gear_file(&self) -> Result<(String, String), NoGearFile> {
        let stem = self.stem();
        let tables = GaugedTables {
            spans: FileName::Spans.csv(&stem),
            pitch: FileName::PitchOwn.csv(&stem),
        };
        let text = gauged_file(self.title, &self.words(), self.spec, &self.gauged, tables)?;
        Ok((file_names::gear_file_name(&stem), text))
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
