//! A study as one HTML page, in the form of a calculation report: for a colleague who never saw the tool.
//!
//! The page is complete in itself: it contains style, pictures and script. It is built with `maud`: the compiler checks the page,
//! every text is escaped unless stated otherwise, and no file is read or parsed at run time.

mod drawings;
mod face;
mod figures;
mod gears;
mod grades;
mod input;
mod method;
mod models;
mod page;
mod phrases;
mod results;
mod stated;
mod table;
mod tolerance;
mod trust;
mod verdict;

use crate::chart::PictureError;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::curves::courses;
use gearlash::analysis::outcome::{Agreement, Outcome, by_distance};
use gears::Gears;
use maud::html;
use page::{Page, PageFrame};

pub use page::Report;
pub use tolerance::{ToleranceReport, tolerance_report};

/// The page of `report`, in UTF-8.
///
/// # Errors
/// A chart that cannot be drawn or data that cannot be written; never for results of a simulation.
pub fn report(report: &Report) -> Result<String, PictureError> {
    let runs: Vec<&ComparedRun> = report.analysis.distinct_runs().collect();
    let picked: Vec<&ComparedRun> = report.analysis.extremes.runs.iter().collect();
    let all = [&runs[..], &picked[..]].concat();
    let each = &report.analysis.extremes.each;
    let mut distances = by_distance(&runs, &picked);
    // Numbers that are not negative have the order of their bits.
    distances.sort_by_cached_key(|at| at.center_distance.to_bits());
    let page = Page {
        whole: Outcome::of(&runs, &picked),
        agreement: Agreement::of(&all),
        distances,
        courses: courses(&report.analysis.curves)
            .into_iter()
            .map(|course| course.with_cycle(each, &report.pair.study.requirements))
            .collect(),
        all,
        report,
    };
    let mut sections = vec![
        ("result", "Result"),
        ("backlash", "Backlash and mesh"),
        ("face", "Face width"),
        ("trust", "Trust"),
        ("checks", "Checks"),
        ("input", "Input"),
        ("measured", "Measured"),
        ("models", "Formulas"),
        ("poses", "Worst poses"),
        ("method", "Method"),
    ];
    sections.retain(|(id, _)| *id != "measured" || !report.analysis.measured.is_empty());
    sections.retain(|(id, _)| *id != "face" || face::is_of(&page));
    let has_checks = !report.analysis.diagnosis.groups.is_empty();
    sections.retain(|(id, _)| has_checks || !matches!(*id, "trust" | "checks" | "models"));
    let main = html! {
        (verdict::section(&page))
        (trust::unproven(&page))
        (results::section(&page)?)
        (face::section(&page))
        @if has_checks {
            (trust::section(&page))
            (models::checks(&page))
        }
        @match report.pair.spec.by_data() {
            Some(gears) => (input::section(&page, gears)?),
            None => (drawings::section(&page)),
        }
        (models::measured(&page))
        @if has_checks { (models::section(&page)?) }
        (results::poses(&page))
        (method::section(&page))
    };
    let page_frame = PageFrame {
        title: &report.pair.study.title,
        file: report.file,
        date: report.date,
        sections: &sections,
        same: Gears::of(report.pair).same,
    };
    Ok(page_frame.page(&main))
}
