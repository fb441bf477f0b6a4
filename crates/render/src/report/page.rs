//! What a page is made of.

use gearlash::compare::ComparedRun;
use gearlash::curves::{Course, OverDistance};
use gearlash::cycle::Cycle;
use gearlash::diagnosis::Diagnosis;
use gearlash::gauge::{GradedReading, Unmeasured};
use gearlash::measured::MeasuredMating;
use gearlash::mesh::Method;
use gearlash::outcome::{Agreement, AtDistance, Outcome};
use gearlash_files::PairFile;

/// What a report is of.
#[derive(Debug, Clone, Copy)]
pub struct Report<'a> {
    /// The pair as read.
    pub pair: &'a PairFile,
    /// Name of its file.
    pub file: &'a str,
    /// Day of the report, as it shall stand there.
    pub date: &'a str,
    /// How lost motion was found.
    pub method: Method,
    /// The poses the pair file asks for.
    pub runs: &'a [ComparedRun],
    /// Whole revolutions at the same centre distances.
    pub revolution: &'a [ComparedRun],
    /// The hunting cycle beyond these.
    pub cycle: &'a Cycle,
    /// Over the centre distance: what binds, then the matings that were measured.
    pub over_distance: &'a [OverDistance],
    /// Measured values beside their bands.
    pub measured: &'a [MeasuredMating],
    /// Every check.
    pub diagnosis: &'a Diagnosis,
    /// Pitch and runout of each gear that deviates, as the gauge reads and grades them.
    pub grades: &'a [(&'static str, Result<Vec<GradedReading>, Unmeasured>)],
}

impl<'a> Report<'a> {
    /// Every run that counts, none twice: whole revolutions, and what the pair file asks for beside them.
    pub(super) fn runs(&self) -> Vec<&'a ComparedRun> {
        let asked = match self.pair.study.sweeps() {
            true => &[],
            false => self.runs,
        };
        self.revolution.iter().chain(asked).collect()
    }
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
