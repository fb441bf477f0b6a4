//! Values on the page, compared with published ones.

use crate::command::{SMALL, page};
use scraper::{ElementRef, Html, Selector};

pub fn select<'a>(document: &'a Html, selector: &str) -> Vec<ElementRef<'a>> {
    let selector = Selector::parse(selector).unwrap();
    document.select(&selector).collect()
}

pub fn text(element: &ElementRef) -> String {
    let words: Vec<&str> = element.text().flat_map(str::split_whitespace).collect();
    words.join(" ")
}

/// The cells of a row, told by the text of its first.
pub fn row(document: &Html, table: &str, first: &str) -> Vec<String> {
    let rows = select(document, &format!("{table} tbody tr"));
    let cell = Selector::parse("td, th").unwrap();
    let mut cells = rows.iter().map(|row| {
        let cells = row.select(&cell);
        cells.map(|cell| text(&cell)).collect::<Vec<_>>()
    });
    cells.find(|cells| cells[0] == first).unwrap()
}

/// The words of a page, a line an element that holds words of its own; pictures and script left out.
#[test]
fn the_words_of_a_small_report() {
    let document = Html::parse_document(&page(SMALL));
    let mut words = String::new();
    for element in select(
        &document,
        "h1, h2, h3, dl.about, p, li, caption, tr, summary, figcaption",
    ) {
        let cells = Selector::parse("td, th").unwrap();
        let cells: Vec<String> = element.select(&cells).map(|cell| text(&cell)).collect();
        words += &if cells.is_empty() {
            text(&element)
        } else {
            cells.join(" | ")
        };
        words.push('\n');
    }
    insta::assert_snapshot!(words);
}
