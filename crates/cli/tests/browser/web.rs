//! The page that runs the program in the browser (`crates/web/build`), opened from disk.

use crate::chromium::{Chromium, Tab};
use crate::page::{Site, gearlash};
use data_encoding::BASE64;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// The page; `None` where it was not built.
pub fn built() -> Option<PathBuf> {
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let target = target.unwrap_or_else(|| root.join("target"));
    let page = target.join("page/gearlash.html");
    page.is_file().then_some(page)
}

/// The files of an example, its pair file first.
const EXAMPLES: [&[&str]; 5] = [
    &["docs/files/drawing.toml"],
    &[
        "fixtures/outlines/drawn_20x20.toml",
        "fixtures/outlines/wheel_20.dxf",
        "fixtures/outlines/pinion_20.svg",
    ],
    &["docs/files/sheet.toml", "docs/files/wheel.csv"],
    &["docs/files/jams.toml"],
    &["docs/files/helical.toml"],
];

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(name)
}

fn opened(browser: &Chromium, [width, height]: [u32; 2]) -> Tab {
    let mut tab = browser.tab(width, height);
    tab.open(&built().expect("the page is built"));
    settled(&mut tab);
    tab
}

/// Waits until a verdict, or problems, are shown and nothing is worked at.
fn settled(tab: &mut Tab) {
    tab.until(
        "document.getElementById('working').hidden && (!document.getElementById('problems').hidden \
         || document.querySelector('#verdict .status') !== null) && !document.getElementById('found').classList.contains('old')",
    );
}

/// Drops files onto the page.
fn drop_files(tab: &mut Tab, files: &[(String, Vec<u8>)]) {
    let files = files
        .iter()
        .map(|(name, bytes)| json!([name, BASE64.encode(bytes)]));
    let files = json!(files.collect::<Vec<_>>());
    tab.eval(&format!(
        "(() => {{ const given = new DataTransfer(); for (const [name, text] of {files}) given.items.add(new File([Uint8Array.from(atob(text), \
         (c) => c.charCodeAt(0))], name)); document.getElementById('found').classList.add('old'); \
         document.dispatchEvent(new DragEvent('drop', {{ dataTransfer: given, bubbles: true }})); }})()"
    ));
}

fn read(names: &[&str]) -> Vec<(String, Vec<u8>)> {
    let each = names.iter().map(|name| {
        let file = Path::new(name).file_name().expect("a file has a name");
        let bytes = std::fs::read(path(name)).expect("an example is in the repository");
        (file.to_string_lossy().into_owned(), bytes)
    });
    each.collect()
}

/// The visible text of an element.
fn text(tab: &mut Tab, id: &str) -> String {
    tab.text(&format!("document.getElementById('{id}').innerText"))
}

/// Each example gives the verdict of the program, word for word. Source: `check --format json`.
pub fn page_examples_have_the_verdict_of_the_program(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    for names in EXAMPLES {
        drop_files(&mut tab, &read(names));
        settled(&mut tab);
        let shown = text(&mut tab, "verdict");
        let file = path(names[0]);
        let told = gearlash(&["check", &file.display().to_string(), "--format", "json"]);
        let told: Value = serde_json::from_slice(&told).expect("check writes JSON");
        let verdict = &told["files"][0]["verdict"];
        let lines = verdict["text"].as_str().expect("a verdict has lines");
        let status = lines.split(['.', '\n']).next().expect("a first sentence");
        assert!(shown.contains(status), "{names:?}: {shown}\n{lines}");
        for end in ["least", "greatest"] {
            let Some(line) = lines.lines().find(|line| line.trim().starts_with(end)) else {
                continue;
            };
            let value = line.split_whitespace().nth(1).expect("a value");
            assert!(shown.contains(value), "{names:?}: {value} in {shown}");
        }
    }
    assert_eq!(tab.events("Log.entryAdded"), Vec::<&Value>::new());
    assert_eq!(tab.events("Runtime.exceptionThrown"), Vec::<&Value>::new());
    let requests = tab.events("Network.requestWillBeSent");
    let sent = requests
        .iter()
        .map(|event| &event["params"]["request"]["url"]);
    let outside: Vec<&Value> = sent
        .filter(|url| {
            let url = url.as_str().unwrap_or_default();
            !["file:", "blob:", "data:"]
                .iter()
                .any(|own| url.starts_with(own))
        })
        .collect();
    assert!(outside.is_empty(), "{outside:?}");
}

/// Three problems are listed with their places, and a button marks one in the text.
pub fn page_problems_have_their_places(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    let wrong = b"[wheel]\nteeth = 20.5\nmodul_mm = 2\npressure_angle_deg = 20\n[pinion]\nteeth = 30\nmodule_mm = 2\npressure_angle_deg = 200\n[assembly]\ncenter_distance_mm = 50\n";
    drop_files(&mut tab, &[("wrong.toml".to_owned(), wrong.to_vec())]);
    tab.until("document.querySelectorAll('#problem-list li').length >= 3");
    let shown = text(&mut tab, "problems");
    for key in [
        "wheel.teeth = 20.5",
        "modul_mm",
        "pinion.pressure_angle_deg = 200",
    ] {
        assert!(shown.contains(key), "{key}: {shown}");
    }
    tab.eval("document.querySelector('#problem-list button').click()");
    let marked = tab.text(
        "(() => { const t = document.getElementById('text'); return t.value.slice(t.selectionStart, t.selectionEnd); })()",
    );
    assert!(
        !marked.is_empty() && shown.contains(marked.split(' ').next().unwrap_or(&marked)),
        "{marked}"
    );
    // A table that is not there is named.
    drop_files(&mut tab, &read(&["docs/files/sheet.toml"]));
    tab.until("document.getElementById('problem-list').innerText.includes('wheel.csv')");
}

/// The centre distance moves least and greatest as the program has them there. Source: `simulate --center-distance`.
pub fn page_slider_gives_the_extremes_of_the_program(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    drop_files(&mut tab, &read(&["docs/files/drawing.toml"]));
    settled(&mut tab);
    let a = tab.number("Number(document.getElementById('a-number').value)");
    for step in 1..=3 {
        let a = ((a + 0.05 * f64::from(step)) * 1e3).round() / 1e3;
        tab.eval(&format!(
            "(() => {{ const a = document.getElementById('a-number'); a.value = {a}; \
             a.dispatchEvent(new Event('input')); }})()"
        ));
        tab.until(&format!(
            "document.getElementById('cycle').dataset.a === '{a}'"
        ));
        let shown = text(&mut tab, "cycle");
        let pair = path("docs/files/drawing.toml").display().to_string();
        let told = gearlash(&[
            "simulate",
            &pair,
            "--center-distance",
            &a.to_string(),
            "--no-files",
        ]);
        let told = String::from_utf8(told).expect("text is UTF-8");
        for end in ["least", "greatest"] {
            let line = told.lines().find(|line| line.trim().starts_with(end));
            let value = line.and_then(|line| line.split_whitespace().nth(1));
            let value = value.expect("a verdict has both ends");
            assert!(shown.contains(value), "{a}: {value} in {shown}");
        }
    }
}

/// No width lets the page scroll sideways.
pub fn page_fits_its_window(browser: &Chromium, _: &Site) {
    for width in [360, 800, 1280] {
        let mut tab = opened(browser, [width, 900]);
        let wide = tab.number("document.documentElement.scrollWidth");
        assert!(wide <= f64::from(width), "{wide} of {width}");
    }
}

/// A saved page opens with its own pair.
pub fn page_saved_has_its_pair(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    drop_files(&mut tab, &read(EXAMPLES[2]));
    settled(&mut tab);
    let verdict = text(&mut tab, "verdict");
    tab.eval(
        "(() => { const make = URL.createObjectURL; URL.createObjectURL = (blob) => { window.saved = blob.text(); return make(blob); }; \
         HTMLAnchorElement.prototype.click = () => {}; document.getElementById('save-page').click(); })()",
    );
    let page = tab.text("window.saved");
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("saved.html");
    std::fs::write(&file, page).expect("a file is written");
    tab.open(&file);
    settled(&mut tab);
    assert_eq!(text(&mut tab, "verdict"), verdict);
    assert!(text(&mut tab, "files").contains("wheel.csv"));
}

/// A table alone is shown as understood, with the lines that name it. A pair in the link opens with it.
pub fn page_tables_and_links_are_understood(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    drop_files(&mut tab, &read(&["docs/files/wheel.csv"]));
    tab.until("document.getElementById('understood-toml').textContent.includes('wheel.csv')");
    drop_files(&mut tab, &read(&["docs/files/jams.toml"]));
    settled(&mut tab);
    tab.eval("document.querySelector('#files li:not(.now) button').click()");
    settled(&mut tab);
    tab.eval("[...document.querySelectorAll('#files li:not(.now) button')].forEach((out) => out.click())");
    settled(&mut tab);
    let verdict = text(&mut tab, "verdict");
    tab.eval("document.getElementById('link').click()");
    tab.until("location.hash.startsWith('#pair=')");
    let address = tab.text("location.href");
    let mut other = browser.tab(1280, 900);
    other.open_address(&address);
    settled(&mut other);
    assert_eq!(text(&mut other, "verdict"), verdict);
}

/// Noise, a long file and a name with markup are problems in words; no script of theirs runs.
pub fn page_hostile_files_are_problems(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    let noise: Vec<u8> = (0..200_000u32)
        .map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8)
        .collect();
    let name = "<img src=x onerror=\"window.ran = true\">.toml";
    let files = [
        (name, noise.clone()),
        ("long.toml", vec![b'#'; 3 << 20]),
        (
            "deep.toml",
            format!("a = {}1{}", "[".repeat(10_000), "]".repeat(10_000)).into_bytes(),
        ),
    ];
    for (name, bytes) in files {
        tab.eval("document.getElementById('problems').hidden = true");
        drop_files(&mut tab, &[(name.to_owned(), bytes)]);
        tab.until("!document.getElementById('problems').hidden && document.getElementById('working').hidden");
        let shown = text(&mut tab, "problem-list");
        assert!(!shown.is_empty(), "{name}");
    }
    assert_eq!(tab.eval("window.ran === undefined"), json!(true));
    assert_eq!(tab.events("Runtime.exceptionThrown"), Vec::<&Value>::new());
    // The page goes on.
    tab.eval("document.getElementById('examples').dispatchEvent(new Event('change'))");
    tab.until("document.getElementById('problems').hidden && document.querySelector('#verdict .status') !== null && document.getElementById('working').hidden");
}
