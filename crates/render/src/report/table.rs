//! Tables of a page, each in a frame that scrolls on a narrow screen. Marks for pass, warning, unproven and fail, distinguished by
//! shape, colour and word.

use super::phrases::with_symbols;
use gearlash::analysis::diagnosis::CheckVerdict;
use gearlash_results::{Format, PeopleColumn};
use maud::{Markup, Render, html};

/// A column: its heading, and the classes of its cells.
pub(super) struct Column {
    heading: Markup,
    classes: String,
    pub is_shown: bool,
}

/// The columns of a table from `headings` such as `a mm:n | material:w | least:n w`: `n` numbers, `w` never broken, `text` wide
/// enough for a sentence. `a` and symbols such as `j_wt` are set as symbols.
pub(super) fn columns(headings: &str) -> Vec<Column> {
    let each = headings.split('|').map(|column| {
        let (heading, classes) = column.split_once(':').unwrap_or((column, ""));
        Column {
            heading: heading_markup(heading.trim()),
            classes: classes.trim().to_owned(),
            is_shown: true,
        }
    });
    each.collect()
}

fn heading_markup(heading: &str) -> Markup {
    html! {
        @for (number, word) in heading.split(' ').enumerate() {
            @if number > 0 { " " }
            @if word == "a" { i { "a" } } @else { (with_symbols(word)) }
        }
    }
}

/// The cells of a row: anything that `maud` renders.
macro_rules! cells {
    ($($cell:expr),* $(,)?) => { vec![$(maud::Render::render(&$cell)),*] };
}
pub(super) use cells;

pub(super) struct Table<'a> {
    /// The name for screen readers.
    label: &'a str,
    /// The class of the table; usually empty.
    class: &'static str,
    caption: Markup,
    columns: Vec<Column>,
    /// The index of the column that names the row.
    named_by: usize,
    pub rows: Vec<Vec<Markup>>,
}

impl<'a> Table<'a> {
    /// A table with rows named by their first column; an empty caption is left out.
    pub fn new(
        label: &'a str,
        caption: Markup,
        columns: Vec<Column>,
        rows: impl IntoIterator<Item = Vec<Markup>>,
    ) -> Table<'a> {
        Table {
            label,
            class: "",
            caption,
            columns,
            named_by: 0,
            rows: rows.into_iter().collect(),
        }
    }

    /// The table of the columns that results show. Cells below their row are below the name of the row, in small type.
    pub fn of_shown(label: &'a str, caption: Markup, shown: &[PeopleColumn]) -> Table<'a> {
        let (below, shown): (Vec<&PeopleColumn>, Vec<&PeopleColumn>) =
            shown.iter().partition(|column| column.heading.is_below());
        let named_by = shown
            .iter()
            .position(|column| column.format != Format::Severity);
        let named_by = named_by.unwrap_or(0);
        let columns = shown.iter().map(|column| Column {
            heading: heading_markup(column.heading.heading()),
            classes: match (column.heading.is_left(), column.format) {
                (_, Format::Severity) => "w".to_owned(),
                (false, Format::Plain) | (true, _) => String::new(),
                (false, _) => "n".to_owned(),
            },
            is_shown: true,
        });
        let count = shown.first().map_or(0, |column| column.cells.len());
        let cell = |place: usize, number: usize| {
            let text = &shown[place].cells[number];
            let notes = below.iter().map(|column| column.cells[number].as_str());
            let mut notes = notes.filter(|note| place == named_by && !note.is_empty());
            html! {
                @match named(text).filter(|_| shown[place].format == Format::Severity) {
                    Some(verdict) => (mark(verdict)),
                    None => (with_symbols(text)),
                }
                @if let Some(note) = notes.next() { div.remark { (with_symbols(&note.replace(" -", " −"))) } }
            }
        };
        let rows =
            (0..count).map(|number| (0..shown.len()).map(|place| cell(place, number)).collect());
        Table::new(label, caption, columns.collect(), rows).named_by(named_by)
    }

    pub fn big(self) -> Table<'a> {
        let class = "big";
        Table { class, ..self }
    }

    /// The table with rows named by column `named_by`, from 0.
    pub fn named_by(self, named_by: usize) -> Table<'a> {
        Table { named_by, ..self }
    }
}

impl Render for Table<'_> {
    fn render(&self) -> Markup {
        let shown = || self.columns.iter().filter(|column| column.is_shown);
        let has_headings = shown().any(|column| !column.heading.0.is_empty());
        let named = |text: &str| Some(text.to_owned()).filter(|text| !text.is_empty());
        let cell = |number: usize, column: &Column, content: &Markup| {
            let classes = named(&column.classes);
            html! {
                @if number == self.named_by { th class=[classes] scope="row" { (content) } }
                @else { td class=[classes] { (content) } }
            }
        };
        html! {
            div.scroll tabindex="0" role="region" aria-label=(self.label) {
                table class=[named(self.class)] {
                    @if !self.caption.0.is_empty() { caption { (self.caption) } }
                    @if has_headings {
                        thead { tr { @for column in shown() {
                            th class=[column.classes.contains('n').then_some("n")] scope="col" { (column.heading) }
                        } } }
                    }
                    tbody { @for row in &self.rows { tr {
                        @for (number, (column, content)) in self.columns.iter().zip(row).enumerate() {
                            @if column.is_shown { (cell(number, column, content)) }
                        }
                    } } }
                }
            }
        }
    }
}

/// Outline in a box of 16 by 16, and the strokes in it.
fn shape(verdict: CheckVerdict) -> [&'static str; 2] {
    match verdict {
        CheckVerdict::Pass => ["M8 1a7 7 0 1 0 .01 0z", "M4.5 8.2L7 10.7L11.5 5.5"],
        CheckVerdict::Warn => ["M8 1.2L15.4 14.6H.6z", "M8 5.8V10M8 11.6V13"],
        CheckVerdict::Unproven => ["M8 .6L15.4 8L8 15.4L.6 8z", "M5 8H11"],
        CheckVerdict::Fail => ["M1.5 1.5H14.5V14.5H1.5z", "M5 5L11 11M11 5L5 11"],
    }
}

/// The verdict called `word`.
pub(super) fn named(word: &str) -> Option<CheckVerdict> {
    let all = [
        CheckVerdict::Pass,
        CheckVerdict::Warn,
        CheckVerdict::Unproven,
        CheckVerdict::Fail,
    ];
    all.into_iter().find(|verdict| verdict.name() == word)
}

/// The mark of a verdict and its word.
pub(super) fn mark(verdict: CheckVerdict) -> Markup {
    let word = match verdict {
        CheckVerdict::Warn => "warning",
        other => other.name(),
    };
    marked(verdict, word)
}

/// The mark of a verdict before another word.
pub(super) fn marked(verdict: CheckVerdict, word: &str) -> Markup {
    let [outline, strokes] = shape(verdict);
    html! {
        span.mark.(verdict.name()) {
            svg viewBox="0 0 16 16" aria-hidden="true" {
                path d=(outline) fill="currentColor" {}
                path.stroke d=(strokes) {}
            }
            (word)
        }
    }
}
