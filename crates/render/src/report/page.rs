//! Content of a page, and the frame of every page: style, heading, contents, foot.

use super::phrases::plain;
use crate::chart::PictureError;
use crate::kit::dark_style;
use crate::viewer;
use gearlash::analysis::Analysis;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::curves::Course;
use gearlash::analysis::outcome::{Agreement, AtDistance, Outcome};
use gearlash::error::{Error, Tick};
use gearlash_input::PairFile;
use gearlash_results::gauge::GearGrades;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use std::ops::ControlFlow;

/// Input of a report.
#[derive(Clone, Copy)]
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
    /// Called before each part of the page.
    pub tick: &'a Tick<'a>,
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

impl Page<'_> {
    /// # Errors
    /// A break of the report's tick.
    pub fn tick(&self) -> Result<(), PictureError> {
        match (self.report.tick)(0) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(PictureError(Error::Interrupted.to_string())),
        }
    }
}

const STYLE: &str = include_str!("style.css");

pub(super) struct PageFrame<'a> {
    pub title: &'a str,
    /// The pair file, by name.
    pub file: &'a str,
    pub date: &'a str,
    pub sections: &'a [(&'a str, &'a str)],
    /// The conditions for reproducing the numbers.
    pub same: &'a str,
}

impl PageFrame<'_> {
    /// The page whose sections are `main`, in UTF-8.
    pub fn page(&self, main: &Markup) -> String {
        let title = self.title();
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
                    (PreEscaped(dark_style(&main.0)))
                }
                body {
                    (self.head(&title))
                    main { (main) }
                    footer { p {
                        "gearlash " (env!("CARGO_PKG_VERSION")) ", " (self.date) ". " (self.same)
                    } }
                }
            }
        };
        markup.into_string() + "\n"
    }

    /// The pair's title; its file where the title has no visible text.
    fn title(&self) -> String {
        let mut names = [self.title, self.file].map(plain).into_iter();
        let visible = names.find(|name| !name.trim().is_empty());
        visible.unwrap_or_else(|| "Gear pair".to_owned())
    }

    fn head(&self, title: &str) -> Markup {
        html! {
            header {
                p.kind { "Backlash of a gear pair · calculation report" }
                h1 { (title) }
                dl.about {
                    div { dt { "Pair file" } dd { (plain(self.file)) } }
                    div { dt { "Date" } dd { (self.date) " (UTC)" } }
                    div { dt { "Program" } dd { "gearlash " (env!("CARGO_PKG_VERSION")) } }
                }
            }
            nav aria-label="Contents" {
                @for (id, name) in self.sections { a href=(format!("#{id}")) { (name) } }
            }
        }
    }
}
