//! `[accuracy]` and `[compare]`: how finely and how strictly.

use super::limits::{CHORD, TOLERANCE};
use super::problems::Problems;
use super::table::Table;
use serde_json::{Value, json};

/// `[accuracy]`.
#[derive(Debug, Clone, Copy)]
pub struct Accuracy {
    /// Chordal error of the polygons, µm.
    pub chord_um: f64,
}

impl Accuracy {
    /// Reads the table.
    pub fn read(file: &Table, problems: &mut Problems) -> Option<Accuracy> {
        let table = file.table("accuracy", &["chord_um"], problems)?;
        let chord_um = table.number_or("chord_um", 0.01, &CHORD, problems)?;
        Some(Accuracy { chord_um })
    }

    /// As in the pair file.
    pub fn echo(&self) -> Value {
        json!({ "chord_um": self.chord_um })
    }
}

/// `[compare]`.
#[derive(Debug, Clone, Copy)]
pub struct Compare {
    /// Tolerance, µm of `j_wt`.
    pub tolerance_um: f64,
    /// Whether contact off the line of action passes.
    pub allow_off_line_contact: bool,
}

impl Compare {
    /// Reads the table.
    pub fn read(file: &Table, problems: &mut Problems) -> Option<Compare> {
        let known = &["tolerance_um", "allow_off_line_contact"];
        let table = file.table("compare", known, problems)?;
        let tolerance_um = table.number_or("tolerance_um", 0.1, &TOLERANCE, problems);
        let allow = match table.optional("allow_off_line_contact") {
            Some(Some(entry)) => problems.keep(entry.flag()),
            absent => absent.map(|_| false),
        };
        Some(Compare {
            tolerance_um: tolerance_um?,
            allow_off_line_contact: allow?,
        })
    }

    /// As in the pair file.
    pub fn echo(&self) -> Value {
        json!({
            "tolerance_um": self.tolerance_um,
            "allow_off_line_contact": self.allow_off_line_contact,
        })
    }
}
