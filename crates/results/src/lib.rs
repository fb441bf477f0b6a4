//! Results of gearlash as data and as text: JSON, CSV, terminal tables, Markdown and JUnit, and the words of a verdict.
//!
//! Keys are those of the interface, with units in their names. Only `gauge::grades` computes: it runs the gauge.
//!
//! ```no_run
//! use gearlash::analysis::{Analysis, Plan};
//! use gearlash::contact::Method;
//! use std::path::Path;
//!
//! let pair = gearlash_input::read(Path::new("fixtures/karba_44x44.toml"))?;
//! let plan = Plan::new(&pair.study, Method::Exact { certify: true }).with_extremes();
//! let analysis = Analysis::silently(&plan)?;
//! let verdict = analysis.verdict();
//! println!("{}", gearlash_results::verdict::lines(&verdict));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assembly_state;
mod checks;
mod column;
mod comparison;
mod difference;
pub mod gauge;
pub mod judged;
mod layout;
pub mod matching;
mod notes;
pub mod population;
mod pose;
mod read;
mod remedies;
mod run;
mod simulation;
pub mod verdict;
mod writer;

/// Results as text for a terminal.
pub mod text {
    pub use crate::difference::difference_text;
    pub use crate::layout::Screen;
    pub use crate::read::{gearbox, gearbox_pair, imported, listed_outlines};
    pub use crate::simulation::{measured_shown, simulation};

    /// The checks of a pair as text.
    pub mod check {
        pub use crate::checks::{MARGIN, check_doubts, table, text, titles};
    }
}

use column::Row;

/// The keys of poses, runs, extremes, checks, comparisons and assignments in results; for a column without a key, its name in
/// CSV.
pub fn keys() -> impl Iterator<Item = &'static str> {
    fn of<R: Row>() -> impl Iterator<Item = &'static str> {
        R::columns().names()
    }
    of::<pose::PoseRow>()
        .chain(of::<run::RunRow>())
        .chain(of::<run::ExtremeRow>())
        .chain(of::<checks::CheckRow>())
        .chain(of::<comparison::ComparedRow>())
        .chain(of::<matching::AssignmentRow>())
}

pub use checks::{backlash_map_csv, checked, map_csv};
pub use column::{Array, Format, PeopleColumn, Value, Values};
pub use comparison::ComparedPair;
pub use difference::{comparison_json, difference_csv, difference_sentence, turn_words};
pub use notes::{drawn_notes, fitted_sentences};
pub use pose::{ContactRow, pose_arrays, pose_doubts, pose_page};
pub use remedies::RemedyRecords;
pub use run::{extremes_json, pose_json};
pub use writer::ResultWriter;
