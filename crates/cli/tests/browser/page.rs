//! The pages under test, and what holds of a page as a whole.

use crate::chromium::{Chromium, Script, Tab};
use assert_cmd::Command;
use serde_json::{Value, json};
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
    /// Runs the program on the test pair.
    pub fn make() -> Site {
        let folder = tempfile::tempdir().expect("a folder");
        let page = folder.path().join("report.html");
        let file = page.to_str().expect("a path of plain letters");
        gearlash(&["report", PAIR, "-o", file]);
        let result = gearlash(&["simulate", PAIR, "--format", "json"]);
        let result = serde_json::from_slice(&result).expect("the result is JSON");
        let stuck = folder.path().join("stuck.html");
        let stuck_pair = folder.path().join("stuck.toml");
        std::fs::write(&stuck_pair, STUCK).expect("a pair file");
        let [pair, file] =
            [&stuck_pair, &stuck].map(|path| path.to_str().expect("a path of plain letters"));
        gearlash(&["report", pair, "-o", file]);
        let helical = folder.path().join("helical.html");
        let file = helical.to_str().expect("a path of plain letters");
        gearlash(&["report", HELICAL, "-o", file]);
        let helical_result = gearlash(&["simulate", HELICAL, "--format", "json"]);
        let helical_result = serde_json::from_slice(&helical_result).expect("the result is JSON");
        Site {
            page,
            result,
            stuck,
            helical,
            helical_result,
            _folder: folder,
        }
    }

    /// A pose of the result.
    pub fn pose(&self, run: usize, pose: usize) -> &Value {
        &self.result["runs"][run]["poses"][pose]
    }
}

/// Standard output of the program, whatever its verdict.
pub fn gearlash(arguments: &[&str]) -> Vec<u8> {
    let mut command = Command::cargo_bin("gearlash").expect("the program is built");
    let output = command.args(arguments).output();
    let output = output.expect("the program runs");
    assert!(matches!(output.status.code(), Some(0 | 1)), "{arguments:?}");
    output.stdout
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

/// The text of an element of the viewer.
pub fn shown_text(tab: &mut Tab, name: &str) -> String {
    tab.text(&format!(
        "document.getElementById('viewer-{name}').textContent"
    ))
}

pub fn opens_from_disk_without_errors(browser: &Chromium, site: &Site) {
    let mut tab = open(browser, site);
    tab.until("document.getElementById('viewer').classList.contains('viewer-js')");
    for name in [
        "Runtime.exceptionThrown",
        "Runtime.consoleAPICalled",
        "Log.entryAdded",
        "Page.javascriptDialogOpening",
    ] {
        assert!(
            tab.events(name).is_empty(),
            "{name}: {:?}",
            tab.events(name)
        );
    }
    for request in tab.events("Network.requestWillBeSent") {
        let url = request["params"]["request"]["url"]
            .as_str()
            .expect("a request has an address");
        assert!(url.starts_with("file://"), "the page asks for {url}");
    }
    assert_eq!(
        tab.eval("document.getElementById('viewer-controls').hidden"),
        json!(false)
    );
}

/// The picture and the texts of the first pose come from Rust, the later ones from the script. Both must be equal. (The script
/// draws only the visible part of dash-dotted lines.)
pub fn says_the_same_without_script(browser: &Chromium, site: &Site) {
    let parts = "JSON.stringify([...document.querySelectorAll('#viewer-picture [transform], #viewer-picture [d], .viewer dd, #viewer-backlash')]\
                 .filter((e) => !e.closest('defs path') && !e.matches('[stroke-dasharray]'))\
                 .map((e) => [e.id, e.getAttribute('transform'), e.tagName === 'path' && e.getAttribute('d'), e.children.length ? '' : e.textContent]))";
    let mut with = open(browser, site);
    let mut without = browser.tab(1280, 900);
    without.call(
        "Emulation.setScriptExecutionDisabled",
        json!({ "value": true }),
    );
    without.open(&site.page);
    assert_eq!(
        without.eval("document.getElementById('viewer-controls').hidden"),
        json!(true)
    );
    assert!(
        without.number("document.querySelector('.viewer noscript').getBoundingClientRect().height")
            > 0.0
    );
    let [drawn, set] = [without.text(parts), with.text(parts)]
        .map(|text| serde_json::from_str::<Vec<Value>>(&text).expect("a list of parts"));
    assert!(drawn.len() > 50, "parts are found");
    assert_eq!(drawn.len(), set.len());
    for (drawn, set) in drawn.iter().zip(&set) {
        assert_eq!(drawn, set);
    }
    let shown: f64 = without
        .text("document.getElementById('viewer-backlash').dataset.um")
        .parse()
        .expect("a number");
    let least = site.result["runs"].as_array().expect("runs").iter();
    let least = least
        .filter_map(|run| run["summary"]["min_j_wt_um"].as_f64())
        .fold(f64::INFINITY, f64::min);
    assert!(shown <= least, "{shown} µm is no worse than {least} µm");
    // A pose without a value has an empty title, not a lone unit.
    without.open(&site.stuck);
    let title = "document.getElementById('viewer-backlash').title";
    assert_eq!(without.text(title), "");
}

/// Issue 14: within a screen and a half of 1280 × 800, 1200 px; and a reader sees that the chart can be clicked.
pub fn the_first_chart_is_near_the_top_and_says_it_can_be_clicked(browser: &Chromium, site: &Site) {
    let mut tab = browser.tab(1280, 800);
    for page in [&site.page, &site.stuck] {
        tab.open(page);
        let top = "document.querySelector('.gearlash-chart').getBoundingClientRect().top + scrollY";
        let top = tab.number(top);
        assert!(top > 0.0 && top < 1200.0, "{top} px");
        let hint = "document.querySelector('figure:has(.gearlash-chart) .hint').getBoundingClientRect().height";
        assert!(tab.number(hint) > 0.0);
    }
}
