//! What a page is made of.

use gearlash::analysis::Analysis;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::curves::Course;
use gearlash::analysis::outcome::{Agreement, AtDistance, Outcome};
use gearlash::gauge::{GradedReading, PitchReadings, ProfileReadings, Unmeasured};
use gearlash_files::AnyPair;

/// What a report is of.
#[derive(Debug, Clone, Copy)]
pub struct Report<'a> {
    /// The pair as read.
    pub pair: &'a AnyPair,
    /// Name of its file.
    pub file: &'a str,
    /// Day of the report, as it shall stand there.
    pub date: &'a str,
    /// What was found out about it: the whole of [`gearlash::analysis::Plan::whole`].
    pub analysis: &'a Analysis<'a>,
    /// Pitch and runout of each gear that deviates, as the gauge reads and grades them.
    pub grades: &'a [GearGrades],
}

/// Pitch and runout of one gear as the gauge reads them, and what was required.
#[derive(Debug, Clone)]
pub struct GearGrades {
    /// `wheel` or `pinion`.
    pub name: &'static str,
    /// The grade that its table requires.
    pub required: Option<u32>,
    /// What has a grade.
    pub graded: Result<Vec<GradedReading>, Unmeasured>,
    /// Pitch about both axes.
    pub pitches: Vec<PitchReadings>,
    /// Profiles, where the file states how they deviate.
    pub profile: Option<ProfileReadings>,
}

/// What the sections of a page share.
pub(super) struct Page<'a> {
    pub report: &'a Report<'a>,
    /// Every run, and the extremes of the rest of the hunting cycle.
    pub all: Vec<&'a ComparedRun>,
    pub whole: Outcome<'a>,
    pub agreement: Agreement,
    pub distances: Vec<AtDistance<'a>>,
    pub courses: Vec<Course>,
}
