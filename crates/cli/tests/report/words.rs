//! The words of a page.

use crate::command::{SMALL, page};
use scraper::{ElementRef, Html, Selector};

fn text(element: &ElementRef) -> String {
    let words: Vec<&str> = element.text().flat_map(str::split_whitespace).collect();
    words.join(" ")
}

/// A line an element that holds words of its own; pictures and script left out. `tests/sessions/reports.txt` holds other pages.
#[test]
fn the_words_of_a_small_report() {
    let document = Html::parse_document(&page(SMALL));
    let mut words = String::new();
    let elements = "h1, h2, h3, dl.about, p, li, caption, tr, summary, figcaption";
    let [elements, cells] = [elements, "td, th"].map(|selector| Selector::parse(selector).unwrap());
    for element in document.select(&elements) {
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
