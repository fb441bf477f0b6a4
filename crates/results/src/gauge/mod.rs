//! Readings of the gauges as JSON, CSV and tables.

mod grades;
mod json;
mod lengths;
mod readings;

use gearlash::analysis::study::Material;
use gearlash::gauge::{Gauged, Unmeasured};
use gearlash::gear::{AsBuilt, BasicGearData};
use gearlash_input::short_for_span;
use gearlash_input::spec::GearSpec;
use gearlash_input::{NoGearFile, gauged_file};

pub use grades::{GearGrades, grades, stated_leads};
pub use json::{grade_table, json};
pub use lengths::{ByTooth, Length, length_table, lengths};
pub use readings::{Chart, teeth_csv, tooth_table};

/// One gear in one material, and the gauges' readings.
#[derive(Debug)]
pub struct GaugedGear<'a> {
    /// Title of the file.
    pub title: &'a str,
    /// `wheel`, `pinion` or `gear`.
    pub name: &'static str,
    /// The thickness.
    pub material: Material,
    /// The number of its teeth.
    pub teeth: u32,
    /// The gear, and its table as understood; `None` for a drawn gear.
    pub data: Option<(&'a AsBuilt, &'a GearSpec)>,
    /// How far its outline may lie from the drawing, mm; `None` for a gear by its data.
    pub outline_bound: Option<f64>,
    /// The readings.
    pub gauged: Gauged,
}

impl GaugedGear<'_> {
    /// The start of its file names: `gauge_wheel`, with the material where there are two.
    pub fn stem(&self) -> String {
        stem(self.name, self.material)
    }

    /// Its gear file: name and content; `None` for a drawn gear.
    ///
    /// # Errors
    /// The readings are incomplete.
    pub fn gear_file(&self) -> Result<Option<(String, String)>, NoGearFile> {
        let Some((_, spec)) = self.data else {
            return Ok(None);
        };
        let text = gauged_file(self.title, &self.words(), spec, &self.gauged)?;
        Ok(Some((gear_file_name(&self.stem()), text)))
    }

    /// Its basic data; `None` for a drawn gear.
    pub fn basic_data(&self) -> Option<&BasicGearData> {
        Some(self.data?.0.gear().basic_data())
    }

    /// Whether its teeth are helical.
    pub fn is_helical(&self) -> bool {
        self.basic_data().is_some_and(|data| data.hand().is_some())
    }

    /// The gear in a few words.
    pub fn words(&self) -> String {
        let (name, teeth, material) = (self.name, self.teeth, self.material.name());
        match self.basic_data() {
            Some(data) => format!(
                "{name}, {teeth} teeth, module {} mm{}, material {material}",
                data.module(),
                self.helix(),
            ),
            None => format!("{name}, outline of {teeth} teeth, material {material}"),
        }
    }

    /// Helix angle and hand, after a comma; empty for a spur gear.
    pub fn helix(&self) -> String {
        let hand = self.basic_data().and_then(BasicGearData::hand);
        let degrees = self.data.and_then(|(_, spec)| spec.helix_angle_deg);
        match (hand, degrees) {
            (Some(hand), Some(degrees)) => format!(", β {degrees}° {}", hand.name()),
            _ => String::new(),
        }
    }

    /// A warning where the face of a helical gear is too short for its spans, and the file itself did not warn.
    pub fn short_face(&self) -> Option<String> {
        let (gear, spec) = self.data?;
        let k = self.gauged.spans.as_ref().ok()?.teeth;
        let stated = spec.thickness.statement.span.as_ref();
        let warned = stated.is_some_and(|span| span.teeth == k);
        let k = (!warned).then_some(k);
        short_for_span(spec.face(), self.name, gear, k)
    }

    /// The readings that were not taken, one line per reason.
    pub fn unmeasured(&self) -> Vec<String> {
        let read = &self.gauged;
        let each = [
            ("span", read.spans.as_ref().err()),
            ("over pins", read.pins.as_ref().err()),
            ("runout", read.runout.as_ref().err()),
            ("pitch", read.pitch_own.as_ref().err()),
            ("pitch about the axis", read.pitch_datum.as_ref().err()),
            ("thickness", read.thickness.as_ref().err()),
            ("profile", read.profile.as_ref().err()),
            ("root diameter", read.root.as_ref().err()),
            ("roll test", read.roll.as_ref().err()),
        ];
        let mut reasons: Vec<(&Unmeasured, Vec<&str>)> = Vec::new();
        for (what, reason) in each {
            let Some(reason) = reason else { continue };
            match reasons.iter_mut().find(|(known, _)| *known == reason) {
                Some((_, names)) => names.push(what),
                None => reasons.push((reason, vec![what])),
            }
        }
        let lines = reasons.into_iter();
        lines
            .map(|(reason, names)| format!("not measured, {}: {reason}", names.join(", ")))
            .collect()
    }
}

/// The start of the file names of the gear called `name`: `gauge_wheel`, with the material where there are two.
pub fn stem(name: &str, material: Material) -> String {
    match material {
        Material::AsMeasured => format!("gauge_{name}"),
        material => format!("gauge_{name}_{}", material.name()),
    }
}

/// The name of the gear file, for the gear of `stem`.
fn gear_file_name(stem: &str) -> String {
    format!("{stem}.toml")
}

/// The file name of the table of all readings, for the gear of `stem`.
pub fn table_name(stem: &str) -> String {
    format!("{stem}.csv")
}

/// The file name of the page of all charts, for the gear of `stem`.
pub fn page_name(stem: &str) -> String {
    format!("{stem}.html")
}

/// Every file name that a run can write for the gear of `stem`.
pub fn possible_files(stem: &str) -> Vec<String> {
    let charts = Chart::ALL.into_iter().map(|chart| chart.svg(stem));
    let others = [gear_file_name, table_name, page_name].map(|name| name(stem));
    charts.chain(others).collect()
}
