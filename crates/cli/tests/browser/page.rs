//! The pages under test, and what holds of a page as a whole.

use crate::browsers::{Chromium, Script, Tab};
use assert_cmd::Command;
use serde_json::Value;
use std::path::PathBuf;

/// d_a = 44, d_f = 35: a tip sits in a root below a = 39.5; tips pass each other above 44.
const STUCK: &str = "[wheel]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n\
                     [pinion]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n\
                     [assembly]\ncenter_distance_mm = [39.0, 44.5]\n\
                     [sweep]\nrevolutions = \"wheel\"\nsteps_per_pitch = 2\n";

const PAIR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/browser/pair.toml");

const HELICAL: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../docs/files/helical_measured.toml"
);

/// A report on disk, and the result of the same pair.
pub struct Site {
    pub page: PathBuf,
    /// The output of `simulate --format json`.
    pub result: Value,
    /// A report on a pair that is jammed at its first centre distance and out of mesh at its second.
    pub stuck: PathBuf,
    /// A report on a helical pair, and the output of `simulate --format json`.
    pub helical: PathBuf,
    pub helical_result: Value,
    _folder: tempfile::TempDir,
}

impl Site {
    /// Runs the program on the test pairs.
    pub fn make() -> Site {
        let folder = tempfile::tempdir().unwrap();
        let report = |pair: &str, name: &str| {
            let page = folder.path().join(name);
            gearlash(&["report", pair, "-o", page.to_str().unwrap()]);
            page
        };
        let result = |pair| {
            let json = gearlash(&["simulate", pair, "--format", "json"]);
            serde_json::from_str(&json).unwrap()
        };
        let stuck = folder.path().join("stuck.toml");
        std::fs::write(&stuck, STUCK).unwrap();
        Site {
            page: report(PAIR, "report.html"),
            result: result(PAIR),
            stuck: report(stuck.to_str().unwrap(), "stuck.html"),
            helical: report(HELICAL, "helical.html"),
            helical_result: result(HELICAL),
            _folder: folder,
        }
    }

    /// A pose of the result.
    pub fn pose(&self, run: usize, pose: usize) -> &Value {
        &self.result["runs"][run]["poses"][pose]
    }

    /// The backlash of a pose, µm.
    pub fn backlash(&self, run: usize, pose: usize) -> f64 {
        self.pose(run, pose)["j_wt_um"].as_f64().unwrap()
    }
}

/// Standard output of the program, whatever its verdict.
pub fn gearlash(arguments: &[&str]) -> String {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    let output = command.args(arguments).output().unwrap();
    assert!(matches!(output.status.code(), Some(0 | 1)), "{arguments:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// A tab with the page in a window of a desk.
pub fn open(browser: &Chromium, site: &Site) -> Tab {
    let mut tab = browser.tab(1280, 900);
    tab.open(&site.page);
    tab
}

/// Unfolds what the page shows on demand.
pub fn unfold(tab: &mut Tab) {
    tab.eval("document.querySelectorAll('details').forEach((details) => { details.open = true; })");
}

/// The text of a property of an element of the viewer.
pub fn of(tab: &mut Tab, name: &str, property: &str) -> String {
    tab.text(&format!(
        "document.getElementById('viewer-{name}').{property}"
    ))
}

/// The text of an element of the viewer.
pub fn shown_text(tab: &mut Tab, name: &str) -> String {
    of(tab, name, "textContent")
}

/// The picture and the texts of the first pose come from Rust, the later ones from the script. Both must be equal. (The script
/// draws only the visible part of dash-dotted lines.)
pub fn says_the_same_without_script(browser: &Chromium, site: &Site) {
    let parts = "JSON.stringify([...document.querySelectorAll('#viewer-picture [transform], #viewer-picture [d], .viewer dd, #viewer-backlash')]\
                 .filter((e) => !e.closest('defs path') && !e.matches('[stroke-dasharray]'))\
                 .map((e) => [e.id, e.getAttribute('transform'), e.tagName === 'path' && e.getAttribute('d'), e.children.length ? '' : e.textContent]))";
    let mut with = open(browser, site);
    let mut without = browser.tab(1280, 900);
    let disabled = serde_json::json!({ "value": true });
    without.call("Emulation.setScriptExecutionDisabled", disabled);
    without.open(&site.page);
    without.holds("document.getElementById('viewer-controls').hidden");
    without.holds("document.querySelector('.viewer noscript').getBoundingClientRect().height > 0");
    let [drawn, set] = [without.text(parts), with.text(parts)]
        .map(|text| serde_json::from_str::<Vec<Value>>(&text).unwrap());
    assert!(drawn.len() > 50, "parts are found");
    assert_eq!(drawn.len(), set.len());
    for (drawn, set) in drawn.iter().zip(&set) {
        assert_eq!(drawn, set);
    }
    let shown: f64 = of(&mut without, "backlash", "dataset.um").parse().unwrap();
    for run in site.result["runs"].as_array().unwrap() {
        let least = run["summary"]["min_j_wt_um"].as_f64();
        assert!(least.is_none_or(|least| shown <= least), "{shown}: {run}");
    }
}

/// Issue 14: within a screen and a half of 1280 × 800, 1200 px; and a reader sees that the chart can be clicked.
pub fn the_first_chart_is_near_the_top_and_says_it_can_be_clicked(browser: &Chromium, site: &Site) {
    let mut tab = browser.tab(1280, 800);
    for page in [&site.page, &site.stuck] {
        tab.open(page);
        let top = "document.querySelector('.gearlash-chart').getBoundingClientRect().top + scrollY";
        let top = tab.number(top);
        assert!(top > 0.0 && top < 1200.0, "{top} px");
        tab.holds("document.querySelector('figure:has(.gearlash-chart) .hint').getBoundingClientRect().height > 0");
    }
}
