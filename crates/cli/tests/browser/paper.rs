//! The page on paper and in windows of three widths.

use crate::chromium::{Chromium, Script};
use crate::page::{Site, open, unfold};
use data_encoding::BASE64;
use serde_json::{Value, json};
use std::path::Path;

/// A4 in points, as PDF counts: 210 × 297 mm.
const A4: [f64; 2] = [595.3, 841.9];

/// Every page of the PDF is A4 upright. Laid out for paper at the width of a page, each figure is lower than a page and must not
/// be broken, so none is cut.
pub fn prints_whole_figures_on_a4(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    let printed = tab.call(
        "Page.printToPDF",
        json!({ "preferCSSPageSize": true, "printBackground": true }),
    );
    let pdf = decoded(&printed["data"]);
    save("report.pdf", &pdf);
    let text = String::from_utf8_lossy(&pdf);
    let pages: Vec<&str> = text.split("/MediaBox [").skip(1).collect();
    assert!(pages.len() > 1, "{} pages", pages.len());
    for page in pages {
        let frame = page.split(']').next().expect("a box ends");
        let sides: Vec<f64> = frame
            .split_whitespace()
            .map(|n| n.parse().expect("a number"))
            .collect();
        assert_eq!(sides.len(), 4);
        assert!(
            (sides[2] - A4[0]).abs() < 1.0 && (sides[3] - A4[1]).abs() < 1.0,
            "{sides:?}"
        );
    }
    unfold(&mut tab);
    // CSS pixels are a 96th of an inch; margins of 15 mm at most are left round 180 × 267 mm.
    let [width, height] = [180.0, 267.0].map(|mm| mm / 25.4 * 96.0);
    let metrics =
        json!({ "width": width as u32, "height": 1000, "deviceScaleFactor": 1, "mobile": false });
    tab.call("Emulation.setDeviceMetricsOverride", metrics);
    tab.call("Emulation.setEmulatedMedia", json!({ "media": "print" }));
    let figures = tab.eval(
        "[...document.querySelectorAll('figure, .viewer')].map((f) => [f.getBoundingClientRect().height, getComputedStyle(f).breakInside, f.outerHTML.slice(0, 80)])",
    );
    let figures = figures.as_array().expect("figures");
    assert!(figures.len() > 1);
    for figure in figures {
        let tall = figure[0].as_f64().expect("a height");
        assert!(
            tall > 0.0 && tall < height,
            "{tall} of {height} px: {figure}"
        );
        assert_eq!(figure[1], "avoid", "{figure}");
    }
    assert_eq!(
        tab.eval("getComputedStyle(document.getElementById('viewer-controls')).display"),
        json!("none")
    );
}

/// Nothing is wider than the window. The pictures are left in the folder for test files, to be looked at.
pub fn fits_wide_and_narrow_windows(browser: &Chromium, site: &Site) {
    for width in [1280, 800, 390] {
        let mut tab = browser.tab(width, 900);
        tab.open(&site.page);
        let needed = tab.number("document.scrollingElement.scrollWidth");
        assert!(
            needed <= f64::from(width),
            "{needed} px wide in a window of {width}"
        );
        if width == 390 {
            // Every chart and snapshot is drawn for that width, and none has to be scrolled.
            let wide = "[...document.querySelectorAll('figure > svg')].filter((svg) => svg.getBoundingClientRect().width > 0 \
                        && svg.viewBox.baseVal.width > 400).length";
            assert_eq!(tab.number(wide), 0.0);
            let scrolled = "[...document.querySelectorAll('figure')].filter((figure) => figure.scrollWidth > figure.clientWidth + 1).length";
            assert_eq!(tab.number(scrolled), 0.0);
        }
        let whole = tab.call(
            "Page.captureScreenshot",
            json!({ "captureBeyondViewport": true, "format": "png" }),
        );
        let picture = decoded(&whole["data"]);
        save(&format!("report_{width}.png"), &picture);
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
        let style = |tab: &mut crate::chromium::Tab, of: &str, name: &str| {
            tab.text(&format!(
                "getComputedStyle(document.querySelector('{of}')).{name}"
            ))
        };
        [
            style(&mut tab, "body", "backgroundColor"),
            style(&mut tab, "body", "color"),
            style(&mut tab, "figure > svg [fill=white]", "fill"),
        ]
    };
    let light = media("screen", "light");
    assert_eq!(light[0], "rgb(255, 255, 255)");
    assert_eq!(light[2], light[0]);
    let dark = media("screen", "dark");
    assert_eq!(dark[0], "rgb(20, 20, 20)");
    assert_eq!(dark[2], dark[0], "a picture has the paper of its page");
    assert_eq!(media("print", "dark"), light);
}

fn decoded(data: &Value) -> Vec<u8> {
    let text = data.as_str().expect("data are text");
    BASE64.decode(text.as_bytes()).expect("data are base64")
}

fn save(name: &str, bytes: &[u8]) {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&file, bytes).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
}
