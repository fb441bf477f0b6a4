//! Backlash in the requested unit, in tables.

use gearlash::pair::BacklashUnit;
use gearlash_files::numbers::backlash_ascii;

/// `j_wt`, given in mm, at centre distance `a`, mm, in ASCII; with `decimals` decimals if in µm.
pub fn cell(unit: BacklashUnit, j_wt: Option<f64>, a: f64, decimals: usize) -> String {
    backlash_ascii(unit, j_wt.map(|mm| mm * 1e3), a, decimals)
}

/// The heading of a column: its name with the unit; lost motion with its gear.
pub fn column(unit: BacklashUnit, name: &str) -> String {
    match unit {
        BacklashUnit::Um => name.to_owned(),
        BacklashUnit::Arcmin { at, .. } if name == "j_wt" => format!("{} arcmin", at.name()),
        BacklashUnit::Arcmin { at, .. } => format!("{name}, {}", at.name()),
    }
}

/// The quantity at the head of a legend.
pub fn measure(unit: BacklashUnit) -> String {
    match unit {
        BacklashUnit::Um => "Backlash j_wt in µm".to_owned(),
        BacklashUnit::Arcmin { at, .. } => format!("Lost motion at the {} in arcmin", at.name()),
    }
}
