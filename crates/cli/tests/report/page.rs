//! The page as parsers see it.

use crate::command::{SMALL, fixture, page};
use scraper::{Html, Selector};
use std::collections::HashSet;

/// Everything that holds of every page; the page, parsed.
pub fn checked(page: &str) -> Html {
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
    let page = page(SMALL);
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
    for name in ["karba_86x21.toml", "tip_on_fillet_86x21.toml"] {
        checked(&fixture(name));
    }
}

/// Issue 6: synthetic values say so in title and chart, in a page, too; and the mating that binds comes first.
#[test]
fn every_chart_of_the_page_has_the_pairs_title() {
    let page = fixture("karba_44x44_pitch.toml");
    let charts = svgs(&page);
    let charts = charts
        .iter()
        .filter(|svg| svg.contains("class=\"gearlash-chart\""));
    let mut count = 0;
    for chart in charts {
        let title = "Test rig pair 44/44 with synthetic pitch deviations</text>";
        assert!(chart.contains(title), "{}", &chart[..300]);
        count += 1;
    }
    assert!(count > 4, "{count} charts");
    assert!(page.contains("at the pose that binds"));
}

/// Two gears of 20 teeth and module 2 without deviations at one centre distance or a list of them.
pub fn plain(a: &str) -> String {
    let gear =
        |name: &str| format!("[{name}]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n");
    format!(
        "{}{}[assembly]\ncenter_distance_mm = {a}\n[sweep]\nmating = [[1, 1]]\n",
        gear("wheel"),
        gear("pinion")
    )
}

#[test]
fn a_jammed_pair_and_one_out_of_mesh() {
    // d_a = 44, d_f = 35: a tip sits in a root below a = 39.5; tips pass each other above 44.
    let jammed = page(&plain("39.0"));
    checked(&jammed);
    assert!(jammed.contains("Jammed at a = 39.000 mm"));
    assert!(jammed.contains("Jammed, a tip in a root, wheel 1 with pinion 1"));
    // Two gears of 20 teeth and module 2 without allowances assemble from a = 40 on.
    assert!(jammed.contains("assembles from a = 40.0000 mm on"));
    assert!(jammed.contains("Scale bars are correct"));
    let out_of_mesh = page(&plain("44.5"));
    checked(&out_of_mesh);
    assert!(out_of_mesh.contains("Out of mesh at a = 44.500 mm"));
    assert!(
        out_of_mesh
            .contains("Left out: over these centre distances the gears are jammed or out of mesh")
    );
    // Every heading has content.
    assert!(out_of_mesh.contains("No pose is in mesh: there is nothing to draw."));
    assert!(!out_of_mesh.contains("Scale bars are correct"));
}
