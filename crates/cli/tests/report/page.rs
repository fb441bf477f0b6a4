//! The page as parsers see it.

use super::{SMALL, page, page_of};
use scraper::{ElementRef, Html, Selector};
use std::collections::HashSet;
use std::path::Path;

/// Everything that holds of every page; the page, parsed.
fn checked(page: &str) -> Html {
    let document = Html::parse_document(page);
    assert!(document.errors.is_empty(), "{:?}", document.errors);
    let ids = all(&document, "[id]", "id");
    let distinct: HashSet<&String> = ids.iter().collect();
    assert_eq!(distinct.len(), ids.len(), "an id stands there twice");
    for reference in references(&document) {
        assert!(distinct.contains(&reference), "#{reference} is nowhere");
    }
    let svgs = svgs(page);
    // Over the teeth and the mesh: all that a pair has that is out of mesh and without deviations.
    assert!(svgs.len() >= 2, "{} pictures", svgs.len());
    for svg in svgs {
        roxmltree::Document::parse(svg).unwrap();
    }
    for name in ["src", "srcset", "data", "poster", "action"] {
        let found = all(&document, &format!("[{name}]"), name);
        assert!(found.is_empty(), "{found:?}");
    }
    assert!(all(&document, "link, base, iframe, object, embed, img", "").is_empty());
    // Names of vocabularies are no addresses.
    let rest = page
        .replace("http://www.w3.org/2000/svg", "")
        .replace("http://www.w3.org/1999/xlink", "");
    assert!(!rest.contains("http://") && !rest.contains("https://"));
    assert!(!rest.contains("@import"));
    document
}

/// The attribute `name` of all elements that match `selector`.
fn all(document: &Html, selector: &str, name: &str) -> Vec<String> {
    let selector = Selector::parse(selector).unwrap();
    let elements = document.select(&selector);
    elements
        .map(|element| element.attr(name).unwrap_or_default().to_owned())
        .collect()
}

/// The targets of `href="#…"`, `url(#…)` and `aria-labelledby`.
fn references(document: &Html) -> Vec<String> {
    let mut found = all(document, "[aria-labelledby]", "aria-labelledby");
    let every = Selector::parse("*").unwrap();
    for element in document.select(&every) {
        for (name, value) in element.value().attrs() {
            if name == "href" {
                found.push(value.strip_prefix('#').unwrap().to_owned());
            } else if let Some((_, after)) = value.split_once("url(#") {
                found.push(after.split_once(')').unwrap().0.to_owned());
            }
        }
    }
    // The contents alone are more.
    assert!(found.len() > 5);
    found
}

/// Each picture of the page, as text.
fn svgs(page: &str) -> Vec<&str> {
    page.match_indices("<svg")
        .map(|(start, _)| {
            let length = page[start..].find("</svg>").unwrap();
            &page[start..start + length + "</svg>".len()]
        })
        .collect()
}

#[test]
fn every_kind_of_deviation() {
    let page = page(SMALL, &[]);
    let document = checked(&page);
    // The title is text in head, heading and pictures. A control character, which pages cannot contain, becomes a space.
    let heading = Selector::parse("h1").unwrap();
    let heading: String = document.select(&heading).next().unwrap().text().collect();
    assert_eq!(heading, "<script>alert(\"1\")</script> & a  bell");
    assert!(page.contains("<title>&lt;script&gt;"));
    assert!(!page.contains("<script>alert"));
    assert_eq!(all(&document, "script", "type").len(), 2, "data and viewer");
}

#[test]
fn the_pages_of_the_fixtures() {
    let fixtures = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures"));
    for name in [
        "karba_86x21.toml",
        "tip_on_fillet_86x21.toml",
        "outlines/drawn_20x20.toml",
    ] {
        checked(&page_of(&fixtures.join(name), &[]));
    }
}

/// d_a = 44, d_f = 35: a tip sits in a root below a = 39.5; tips pass each other above 44.
#[test]
fn the_pages_of_a_jammed_pair_and_one_out_of_mesh() {
    let gear = "teeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n";
    for a in ["39.0", "44.5"] {
        let pair = format!(
            "[wheel]\n{gear}[pinion]\n{gear}[assembly]\ncenter_distance_mm = {a}\n[sweep]\nmating = [[1, 1]]\n"
        );
        checked(&page(&pair, &[]));
    }
}

fn text(element: &ElementRef) -> String {
    let words: Vec<&str> = element.text().flat_map(str::split_whitespace).collect();
    words.join(" ")
}

/// A line an element that holds words of its own; pictures and script left out. `tests/sessions/reports.txt` holds other pages.
#[test]
fn the_words_of_a_small_report() {
    let document = Html::parse_document(&page(SMALL, &[]));
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
