//! The page on paper and in windows of three widths.

use crate::browsers::{Chromium, Script, Tab};
use crate::page::{Site, open, unfold};
use data_encoding::BASE64;
use serde_json::{Value, json};
use std::path::Path;

/// Every page of the PDF is A4 upright: 595.3 × 841.9 points, 210 × 297 mm. Laid out for paper at the width of a page, each figure is lower than a
/// page and must not be broken, so none is cut.
pub fn prints_whole_figures_on_a4(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    unfold(&mut tab);
    let height = print(&mut tab, "report.pdf");
    let figures = tab.eval(
        "[...document.querySelectorAll('figure, .viewer')].map((f) => [f.getBoundingClientRect().height, getComputedStyle(f).breakInside, f.outerHTML.slice(0, 80)])",
    );
    let figures = figures.as_array().unwrap();
    assert!(figures.len() > 1);
    for figure in figures {
        let tall = figure[0].as_f64().unwrap();
        assert!(tall > 0.0 && tall < height, "of {height} px: {figure}");
        assert_eq!(figure[1], "avoid", "{figure}");
    }
    tab.holds("getComputedStyle(document.getElementById('viewer-controls')).display === 'none'");
}

/// Prints the page on A4 and lays it out for paper. Returns the height of a page, CSS pixels. The PDF is left in the folder for test files.
pub fn print(tab: &mut Tab, name: &str) -> f64 {
    let options = json!({ "preferCSSPageSize": true, "printBackground": true });
    let printed = tab.call("Page.printToPDF", options);
    let pdf = saved(name, &printed["data"]);
    let text = String::from_utf8_lossy(&pdf);
    let pages: Vec<&str> = text.split("/MediaBox [").skip(1).collect();
    assert!(pages.len() > 1, "{} pages", pages.len());
    for page in pages {
        let frame = page.split(']').next().unwrap().split_whitespace();
        let sides: Vec<f64> = frame.map(|side| side.parse().unwrap()).collect();
        assert_eq!(sides.len(), 4);
        let is_a4 = (sides[2] - 595.3).abs() < 1.0 && (sides[3] - 841.9).abs() < 1.0;
        assert!(is_a4, "{sides:?}");
    }
    // CSS pixels are a 96th of an inch; margins of 15 mm at most are left round 180 × 267 mm.
    let [width, height] = [180.0, 267.0].map(|mm| mm / 25.4 * 96.0);
    tab.resize(width as u32, 1000);
    tab.call("Emulation.setEmulatedMedia", json!({ "media": "print" }));
    height
}

/// Nothing is wider than the window. The pictures are left in the folder for test files, to be looked at.
pub fn fits_wide_and_narrow_windows(browser: &Chromium, site: &Site) {
    for width in [1280, 800, 390] {
        let mut tab = browser.tab(width, 900);
        tab.open(&site.page);
        tab.holds(&format!("document.scrollingElement.scrollWidth <= {width}"));
        if width == 390 {
            // Every chart and snapshot is drawn for that width, and none has to be scrolled.
            tab.holds(
                "[...document.querySelectorAll('figure > svg')].every((svg) => svg.getBoundingClientRect().width === 0 \
                 || svg.viewBox.baseVal.width <= 400)",
            );
            tab.holds("[...document.querySelectorAll('figure')].every((figure) => figure.scrollWidth <= figure.clientWidth + 1)");
        }
        let options = json!({ "captureBeyondViewport": true, "format": "png" });
        let whole = tab.call("Page.captureScreenshot", options);
        let picture = saved(&format!("report_{width}.png"), &whole["data"]);
        assert!(picture.starts_with(b"\x89PNG"));
    }
}

/// Where dark colours are preferred text is light on dark and pictures are turned round; on paper never.
pub fn the_dark_page_is_light_on_paper(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let mut media = |media: &str, scheme: &str| {
        tab.call(
            "Emulation.setEmulatedMedia",
            json!({ "media": media, "features": [{ "name": "prefers-color-scheme", "value": scheme }] }),
        );
        [
            ("body", "backgroundColor"),
            ("figure > svg [fill=white]", "fill"),
            ("body", "color"),
        ]
        .map(|(of, name)| {
            let style = format!("getComputedStyle(document.querySelector('{of}')).{name}");
            tab.text(&style)
        })
    };
    let [white, dark] = ["rgb(255, 255, 255)", "rgb(20, 20, 20)"];
    let light = media("screen", "light");
    assert_eq!(light[..2], [white, white]);
    // A picture has the paper of its page.
    assert_eq!(media("screen", "dark")[..2], [dark, dark]);
    assert_eq!(media("print", "dark"), light);
}

/// The bytes of an answer, which are left in the folder for test files.
fn saved(name: &str, data: &Value) -> Vec<u8> {
    let bytes = BASE64.decode(data.as_str().unwrap().as_bytes()).unwrap();
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(file, &bytes).unwrap();
    bytes
}
