//! Content of a page.

use gearlash::analysis::Analysis;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::curves::Course;
use gearlash::analysis::outcome::{Agreement, AtDistance, Outcome};
use gearlash_files::PairFile;
use gearlash_results::grades::GearGrades;

/// Input of a report.
#[derive(Debug, Clone, Copy)]
pub struct Report<'a> {
    /// The pair as read.
    pub pair: &'a PairFile,
    /// Name of its file.
    pub file: &'a str,
    /// Day of the report, as printed.
    pub date: &'a str,
    /// Its results: the whole of [`gearlash::analysis::Plan::whole`].
    pub analysis: &'a Analysis<'a>,
    /// Pitch and runout of each gear that deviates, with the gauge's readings and grades.
    pub grades: &'a [GearGrades],
}

/// Data shared by the sections of a page.
pub(super) struct Page<'a> {
    pub report: &'a Report<'a>,
    /// Every run, and the extremes of the rest of the mesh cycle.
    pub all: Vec<&'a ComparedRun>,
    pub whole: Outcome<'a>,
    pub agreement: Agreement,
    pub distances: Vec<AtDistance<'a>>,
    pub courses: Vec<Course>,
}
