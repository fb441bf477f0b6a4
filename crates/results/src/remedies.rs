//! Remedies, the single changes that make a pair fit: as JSON and in words.

use gearlash::analysis::remedies::{Change, Remedy};
use gearlash::analysis::study::Study;
use gearlash_files::numbers::rounded;
use gearlash_files::spec::PairSpec;
use gearlash_files::{AnyPairSpec, PairView};
use serde::Serialize;

/// A remedy in the keys and units of a pair file.
#[derive(Debug, Clone, Serialize)]
pub struct RemedyRecord {
    what: &'static str,
    gear: &'static str,
    value: f64,
    bracket: [f64; 2],
}

impl RemedyRecord {
    /// The records of `remedies`, found for the study of `file`; none of a file with a temperature, which states its lengths at 20 °C.
    pub fn all<'a>(file: impl Into<PairView<'a>>, remedies: &[Remedy]) -> Vec<RemedyRecord> {
        let file = file.into();
        let AnyPairSpec::Data(spec) = file.spec else {
            return Vec::new();
        };
        if spec.assembly.temperature_c.is_some() {
            return Vec::new();
        }
        // Thicknesses of a scaled gear are stated before its lengths are multiplied.
        let is_scaled = spec.wheel.scale.or(spec.pinion.scale).is_some();
        let records = remedies
            .iter()
            .filter(|remedy| !is_scaled || matches!(remedy.what, Change::CenterDistance))
            .map(|remedy| RemedyRecord::new(spec, file.study, remedy));
        records.collect()
    }

    fn new(spec: &PairSpec, study: &Study, remedy: &Remedy) -> RemedyRecord {
        let (what, scale, decimals) = match remedy.what {
            Change::CenterDistance => ("center_distance_mm", 1.0, 3),
            Change::FlankOffset => ("flank_offset_mm", 1.0, 3),
            Change::ThicknessAllowance => ("thickness_allowance_um", 1e3, 0),
        };
        // A file states the nominal distance of a band. The middle one of the study may be an end of the band.
        let stated = spec.assembly.center_distance_mm.nominal_mm();
        let listed = &study.center_distances;
        let shift = match (remedy.what, stated, study.band) {
            (Change::CenterDistance, Some(nominal), Some(_)) => nominal - listed[listed.len() / 2],
            _ => 0.0,
        };
        RemedyRecord {
            what,
            gear: remedy.gears.name(),
            value: rounded((remedy.value + shift) * scale, decimals),
            bracket: remedy.bracket.map(|at| (at + shift) * scale),
        }
    }

    /// The change in words, such as `centre distance 48.561 mm`.
    pub fn sentence(&self) -> String {
        let of = match self.gear {
            "both" => "both gears".to_owned(),
            gear => format!("the {gear}"),
        };
        let value = self.value;
        match self.what {
            "center_distance_mm" => format!("centre distance {value:.3} mm"),
            "flank_offset_mm" => format!("flank offset of {of} {value:.3} mm"),
            _ => format!("thickness allowance of {of} {value:.0} µm"),
        }
    }
}

/// The remedies below a table of checks; empty without any. `requires` says whether the file states a requirement.
pub fn text(remedies: &[RemedyRecord], requires: bool) -> String {
    if remedies.is_empty() {
        return String::new();
    }
    let lines = remedies
        .iter()
        .map(|remedy| format!("  {}\n", remedy.sentence()));
    let what = if requires {
        "assemble and meet [require]"
    } else {
        "assemble"
    };
    let lines: String = lines.collect();
    format!("\nEach of these changes alone makes the pair {what}:\n{lines}")
}
