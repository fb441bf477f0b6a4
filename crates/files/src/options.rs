//! `[accuracy]` and `[compare]`: how finely and how strictly.

use super::limits::{CHORD, TOLERANCE};
use super::problems::Problems;
use super::spec::{AccuracySpec, CompareSpec};
use super::table::Table;

/// Reads `[accuracy]`.
pub fn accuracy(file: &Table, problems: &mut Problems) -> Option<AccuracySpec> {
    let table = file.table("accuracy", &["chord_um"], problems)?;
    let default = AccuracySpec::default().chord_um;
    let chord_um = table.number_or("chord_um", default, &CHORD, problems)?;
    Some(AccuracySpec { chord_um })
}

/// Reads `[compare]`.
pub fn compare(file: &Table, problems: &mut Problems) -> Option<CompareSpec> {
    let known = &["tolerance_um", "allow_off_line_contact"];
    let table = file.table("compare", known, problems)?;
    let default = CompareSpec::default();
    let tolerance_um = table.number_or("tolerance_um", default.tolerance_um, &TOLERANCE, problems);
    let allow = match table.optional("allow_off_line_contact") {
        Some(Some(entry)) => problems.keep(entry.flag()),
        absent => absent.map(|_| default.allow_off_line_contact),
    };
    Some(CompareSpec {
        tolerance_um: tolerance_um?,
        allow_off_line_contact: allow?,
    })
}
