//! The same answers: the page's program under node against the native one, for examples and fixtures.

use gearlash_web::answers::{LivePlace, Page};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Pair files, each with all files of its folder.
const PAIRS: [&str; 17] = [
    "docs/files/drawing.toml",
    "docs/files/sheet.toml",
    "docs/files/jams.toml",
    "docs/files/helical.toml",
    "docs/files/helical_runout.toml",
    "docs/files/joint.toml",
    "docs/files/limits.toml",
    "docs/files/printed.toml",
    // No pair: its problems.
    "docs/files/tolerances.toml",
    "fixtures/karba_86x21.toml",
    "fixtures/tip_on_fillet_86x21.toml",
    "fixtures/profiled_44x44.toml",
    "fixtures/grazing/land_on_land.toml",
    "fixtures/grazing/passed_by.toml",
    "fixtures/grazing/tips_just_meet_5_18.toml",
    "fixtures/sheets/inspected_44x44.toml",
    "fixtures/outlines/drawn_20x20.toml",
];

/// Files without a pair file.
const OTHERS: [&[&str]; 3] = [
    &["docs/files/wheel.csv"],
    &["fixtures/sheets/pitch.xlsx"],
    &[
        "fixtures/outlines/wheel_20.dxf",
        "fixtures/outlines/pinion_20.svg",
    ],
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Name and path of each file of a case, its main file first.
type Files = Vec<(String, PathBuf)>;

fn named(path: PathBuf) -> (String, PathBuf) {
    let name = path.file_name().expect("a file has a name");
    (name.to_string_lossy().into_owned(), path)
}

fn cases() -> Vec<Files> {
    let with_folder = PAIRS.iter().map(|pair| {
        let main = root().join(pair);
        let folder = main.parent().expect("a file is in a folder");
        let entries = std::fs::read_dir(folder).expect("an example is in the repository");
        let paths = entries.map(|entry| entry.expect("a folder can be read").path());
        let mut others: Vec<PathBuf> = paths
            .filter(|path| path.is_file() && *path != main)
            .collect();
        others.sort();
        let files = [main].into_iter().chain(others);
        files.map(named).collect()
    });
    let alone = OTHERS.iter().map(|names| {
        let paths = names.iter().map(|name| root().join(name));
        paths.map(named).collect()
    });
    with_folder.chain(alone).collect()
}

fn silent(_: u64, _: u64, _: &str) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn page(files: &Files) -> Page {
    let mut page = Page::default();
    for (name, path) in files {
        let bytes = std::fs::read(path).expect("an example is in the repository");
        page.files.add(name, bytes);
    }
    page
}

/// The answers that the script asks for, natively.
fn answers(files: &Files) -> Value {
    let mut page = page(files);
    let main = &files[0].0;
    let opened = page.open(main);
    let mut answers = vec![opened.clone()];
    if opened["title"].is_string() {
        let result = page.result(&silent);
        let a = opened["distances_mm"][0].as_f64().expect("a distance");
        let start = &result["start"];
        let tooth = |name: &str| start[name].as_u64().unwrap_or(1) as u32;
        let at = LivePlace {
            distance: a,
            material: 0,
            teeth: [tooth("wheel"), tooth("pinion")],
            left: start["left"].as_bool().unwrap_or(false),
            fraction: start["fraction"].as_f64().unwrap_or(0.0),
        };
        answers.extend([result, page.mark_of_jam(), page.live_band(a)]);
        answers.extend([page.live(&at), page.mesh(&at), page.picture(&at)]);
    } else {
        let last = &files[files.len() - 1].0;
        answers.extend([page.understand(main), page.of_drawings([main, last], "")]);
    }
    answers.push(json!(page.zip().len()));
    Value::Array(answers)
}

/// The words between the tags of a picture or page.
fn words(text: &str) -> Vec<&str> {
    let pieces = text.split('<').filter_map(|piece| piece.split_once('>'));
    let words = pieces.map(|(_, words)| words.trim());
    // The data of the viewer are numbers.
    let is_shown = |words: &&str| !words.is_empty() && !words.starts_with('{');
    words.filter(is_shown).collect()
}

/// Both are equal: words exactly, numbers within 1e-6, pictures and pages by their words. A line that is drawn through other
/// points within its bound is no other picture.
fn assert_same(native: &Value, other: &Value, place: &str) {
    match (native, other) {
        (Value::Number(one), Value::Number(two)) => {
            let [one, two] = [one, two].map(|number| number.as_f64().expect("a number"));
            let bound = 1e-6 * one.abs().max(1.0);
            assert!((one - two).abs() <= bound, "{place}: {one} {two}");
        }
        (Value::Array(one), Value::Array(two)) => {
            assert_eq!(one.len(), two.len(), "{place}");
            for (number, (one, two)) in one.iter().zip(two).enumerate() {
                assert_same(one, two, &format!("{place}.{number}"));
            }
        }
        (Value::Object(one), Value::Object(two)) => {
            let keys = one.keys().ne(two.keys());
            assert!(!keys, "{place}: {:?} {:?}", one.keys(), two.keys());
            for (key, one) in one {
                assert_same(one, &two[key], &format!("{place}.{key}"));
            }
        }
        (Value::String(one), Value::String(two)) if one.contains("<svg") => {
            let [one, two] = [one, two].map(|text| words(text.as_str()));
            assert_eq!(one, two, "{place}: another picture");
        }
        _ => assert_eq!(native, other, "{place}"),
    }
}

#[test]
fn answers_under_node_are_the_native_ones() {
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let folder = target.unwrap_or_else(|| root().join("target")).join("page");
    if !folder.join("gearlash_bg.wasm").is_file() {
        println!("skipped: target/page/gearlash_bg.wasm is not there; crates/web/build makes it");
        return;
    }
    let node = Command::new("node")
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/under_node.cjs"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn();
    let Ok(mut node) = node else {
        println!("skipped: node is not installed");
        return;
    };
    let cases = cases();
    let input = json!({ "page": folder, "cases": cases }).to_string();
    let mut stdin = node.stdin.take().expect("stdin is piped");
    stdin
        .write_all(input.as_bytes())
        .expect("node reads its input");
    drop(stdin);
    let mut lines = BufReader::new(node.stdout.take().expect("stdout is piped")).lines();
    let mut next = || -> Value {
        let line = lines.next().expect("node answers").expect("text");
        serde_json::from_str(&line).expect("an answer is JSON")
    };
    for files in &cases {
        assert_same(&answers(files), &next(), &files[0].0);
    }
    let mut page = page(&cases[0]);
    page.open(&cases[0][0].0);
    let slow = json!([page.report("2026-01-01", &silent), page.mark_of_mesh()]);
    assert_same(&slow, &next(), "report");
    let last = next();
    assert_eq!(last["uncalled"], json!([]), "every function is called");
    assert!(last["steps"].as_u64() > Some(0), "progress is reported");
    assert!(node.wait().expect("node ends").success());
}
