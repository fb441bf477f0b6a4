//! What the gauges read, as JSON and CSV.

mod drawn;
mod json;
mod readings;

use gearlash::analysis::study::Material;
use gearlash::gauge::Gauged;
use gearlash::gear::AsBuilt;
use gearlash_files::short_for_span;
use gearlash_files::spec::GearSpec;
use gearlash_files::{NoGearFile, gauged_file};

pub use drawn::{GaugedOutline, gauged_json};
pub use json::json;
pub use readings::{ByTooth, Chart, Readings, teeth_csv};

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
        let text = gauged_file(self.title, &self.words(), self.spec, &self.gauged)?;
        Ok((gear_file_name(&stem), text))
    }

    /// The gear in a few words.
    pub fn words(&self) -> String {
        let basic_data = self.gear.gear().basic_data();
        format!(
            "{}, {} teeth, module {} mm{}, material {}",
            self.name,
            basic_data.teeth(),
            basic_data.module(),
            self.helix(),
            self.material.name()
        )
    }

    /// Its readings tooth by tooth.
    pub fn by_tooth(&self) -> ByTooth<'_> {
        ByTooth {
            gear: self.name,
            material: self.material.name(),
            teeth: self.gear.gear().basic_data().teeth(),
            readings: Readings::Stated(&self.gauged),
        }
    }

    /// Helix angle and hand, after a comma; empty of a spur gear.
    pub fn helix(&self) -> String {
        match (
            self.gear.gear().basic_data().hand(),
            self.spec.helix_angle_deg,
        ) {
            (Some(hand), Some(degrees)) => format!(", β {degrees}° {}", hand.name()),
            _ => String::new(),
        }
    }

    /// A warning where the face of a helical gear is too short for the spans read, and the file itself did not warn.
    pub fn short_face(&self) -> Option<String> {
        let k = self.gauged.spans.as_ref().ok()?.teeth;
        let stated = self.spec.thickness.statement.span.as_ref();
        let warned = stated.is_some_and(|span| span.teeth == k);
        let k = (!warned).then_some(k);
        short_for_span(self.spec.face_mm, self.name, self.gear, k)
    }
}

/// The table of all readings of the gear of `stem`.
pub fn table_name(stem: &str) -> String {
    format!("{stem}.csv")
}

/// How the files of the gear called `name` begin: `gauge_wheel`, with the material where there are two.
pub fn stem(name: &str, material: Material) -> String {
    match material {
        Material::AsMeasured => format!("gauge_{name}"),
        material => format!("gauge_{name}_{}", material.name()),
    }
}

/// The gear file of the gear of `stem`.
pub fn gear_file_name(stem: &str) -> String {
    format!("{stem}.toml")
}

/// The page of all charts of the gear of `stem`.
pub fn page_name(stem: &str) -> String {
    format!("{stem}.html")
}

/// Every name that a run could write for the gear of `stem`.
pub fn possible_files(stem: &str) -> Vec<String> {
    let charts = Chart::ALL.into_iter().map(|chart| chart.svg(stem));
    charts
        .chain([gear_file_name(stem), page_name(stem), table_name(stem)])
        .collect()
}
