//! A study as one HTML page, in the manner of a calculation report: for a colleague who never saw the tool.
//!
//! The page needs nothing but itself: style, pictures and script stand in it. Built with `maud`: the page is
//! Rust that the compiler checks, every text is escaped unless said otherwise, and nothing is read or
//! parsed when it runs.

mod checks;
mod cycle;
mod figures;
mod grades;
mod input;
mod marks;
mod measured;
mod method;
mod models;
mod notes;
mod page;
mod phrases;
mod poses;
mod results;
mod stated;
mod trust;
mod unproven;
mod verdict;

use crate::chart::PictureError;
use crate::viewer;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::curves::courses;
use gearlash::analysis::outcome::{Agreement, Outcome, by_distance};
use maud::{DOCTYPE, Markup, PreEscaped, html};
use page::Page;
use phrases::plain;

pub use page::{GearGrades, Report};

const STYLE: &str = include_str!("style.css");

/// The page of `report`, in UTF-8.
///
/// # Errors
/// A chart that cannot be drawn or data that cannot be written: none for results of a simulation.
pub fn report(report: &Report) -> Result<String, PictureError> {
    let runs: Vec<&ComparedRun> = report.analysis.distinct_runs().collect();
    let picked: Vec<&ComparedRun> = report.analysis.extremes.runs.iter().collect();
    let all = [&runs[..], &picked[..]].concat();
    let mut distances = by_distance(&runs, &picked);
    distances.sort_by(|a, b| a.center_distance.total_cmp(&b.center_distance));
    let page = Page {
        whole: Outcome::of(&runs, &picked),
        agreement: Agreement::of(&all),
        distances,
        courses: courses(&report.analysis.revolution),
        all,
        report,
    };
    let title = title(report);
    let style = PreEscaped(format!("\n{STYLE}{}", viewer::STYLE));
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="generator" content=(format!("gearlash {}", env!("CARGO_PKG_VERSION")));
                title { (title) " – backlash" }
                style { (style) }
            }
            body {
                (head(report, &title))
                main {
                    (verdict::section(&page))
                    (unproven::section(&page))
                    (results::section(&page)?)
                    (trust::section(&page))
                    (checks::section(&page))
                    (input::section(&page)?)
                    (measured::section(&page))
                    (models::section(&page)?)
                    (poses::section(&page))
                    (method::section(&page))
                }
                footer { p {
                    "gearlash " (env!("CARGO_PKG_VERSION")) ", " (report.date)
                    ". The same pair file and version give the same numbers."
                } }
            }
        }
    };
    Ok(markup.into_string() + "\n")
}

/// The pair's title; its file where that holds nothing to be read.
fn title(report: &Report) -> String {
    [report.pair.study.title.as_str(), report.file]
        .map(plain)
        .into_iter()
        .find(|title| !title.trim().is_empty())
        .unwrap_or_else(|| "Gear pair".to_owned())
}

fn head(report: &Report, title: &str) -> Markup {
    html! {
        header {
            p.kind { "Backlash of a gear pair · calculation report" }
            h1 { (title) }
            dl.about {
                div { dt { "Pair file" } dd { (plain(report.file)) } }
                div { dt { "Date" } dd { (report.date) " (UTC)" } }
                div { dt { "Program" } dd { "gearlash " (env!("CARGO_PKG_VERSION")) } }
            }
        }
        nav aria-label="Contents" {
            a href="#result" { "Result" }
            a href="#backlash" { "Backlash and mesh" }
            a href="#trust" { "Trust" }
            a href="#checks" { "Checks" }
            a href="#input" { "Input" }
            @if !report.analysis.measured.is_empty() { a href="#measured" { "Measured" } }
            a href="#models" { "Formulas" }
            a href="#poses" { "Worst poses" }
            a href="#method" { "Method" }
        }
    }
}
