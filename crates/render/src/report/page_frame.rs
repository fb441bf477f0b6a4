//! The frame of every page: style, heading, contents, foot.

use super::phrases::plain;
use crate::kit::dark_style;
use crate::viewer;
use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("style.css");

/// A page without its sections.
pub(super) struct PageFrame<'a> {
    pub title: &'a str,
    /// The pair file, by name.
    pub file: &'a str,
    pub date: &'a str,
    /// Ids and titles of the sections.
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
