//! The same answers: the page's program under node against the native one, for examples and fixtures.

use super::{last, page, path, silent};
use gearlash::error::go_on;
use gearlash_web::answers::LivePlace;
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

/// Folders of pair files. Each file is opened with all files of its folder; of those that are no pair, the problems are compared.
const FOLDERS: &str = "docs/files fixtures fixtures/grazing fixtures/sheets fixtures/outlines crates/web/page/example";

/// Files without a pair file.
const OTHERS: [&str; 3] = [
    "docs/files/wheel.csv",
    "fixtures/sheets/pitch.xlsx",
    "fixtures/outlines/wheel_20.dxf fixtures/outlines/pinion_20.svg",
];

/// Files whose report and whose distance out of mesh are compared.
const SLOW: [&str; 2] = ["docs/files/drawing.toml", "docs/files/helical.toml"];

/// Most time of the processor between two steps of a long answer, ms. Ticks come every 100 ms; other threads of node count too.
const SILENCE: f64 = 400.0;

/// The path of each file of a case, its main file first.
type Files = Vec<PathBuf>;

/// A pair whose backlash its own error bound leaves open by 0.2 µm: another rounding of a sine moves it by 0.01 µm.
const ILL_CONDITIONED: &str = "tips_just_meet_5_18.toml";

fn cases() -> Vec<Files> {
    let with_folder = FOLDERS.split(' ').flat_map(|folder| {
        let entries = std::fs::read_dir(path(folder)).expect("it is in the repository");
        let paths = entries.map(|entry| entry.expect("a folder can be read").path());
        let mut paths: Files = paths.filter(|path| path.is_file()).collect();
        paths.sort();
        let is_pair = |path: &&PathBuf| {
            path.extension().is_some_and(|end| end == "toml") && !path.ends_with(ILL_CONDITIONED)
        };
        let mains: Files = paths.iter().filter(is_pair).cloned().collect();
        mains.into_iter().map(move |main| {
            let others = paths.iter().filter(|path| **path != main);
            [&main].into_iter().chain(others).cloned().collect()
        })
    });
    let alone = OTHERS.map(|names| names.split(' ').map(path).collect());
    with_folder.chain(alone).collect()
}

/// The answers that the script asks for, natively; the time of the verdict, ms, and its steps are added to `times`.
fn answers(files: &Files, times: &mut Vec<[f64; 2]>) -> Value {
    let mut page = page(files.iter().cloned());
    let main = &last(&files[0]);
    let opened = page.open(main);
    let mut answers = vec![opened.clone()];
    if opened["stem"].is_string() {
        let (since, steps) = (Instant::now(), AtomicU64::new(0));
        let result = page.result(&|_, _, _| go_on(steps.fetch_add(1, Ordering::Relaxed)));
        let ms = since.elapsed().as_secs_f64() * 1e3;
        times.push([ms, steps.into_inner() as f64]);
        let a = opened["distances_mm"][0].as_f64().expect("a distance");
        let start = &result["start"];
        let tooth = |name: &str| start[name].as_u64().expect("a tooth") as u32;
        let at = LivePlace {
            distance: a,
            material: 0,
            teeth: [tooth("wheel"), tooth("pinion")],
            left: start["left"] == true,
            fraction: start["fraction"].as_f64().expect("a fraction"),
        };
        let text = std::fs::read_to_string(&files[0]).expect("it was read");
        let moved = LivePlace {
            distance: a + 0.01,
            ..at
        };
        answers.extend([
            page.with_distance(main, &text, moved.distance),
            page.too_large(main, (1 << 20) + 1),
            page.said("tables", main),
            result,
            page.marks(0, &silent),
            page.live_band(a, false, &go_on),
            page.live(&at),
            page.mesh(&at),
            page.picture(&at),
            page.live_band(moved.distance, false, &go_on),
            page.live(&moved),
            page.live_band(moved.distance, true, &go_on),
        ]);
    } else {
        let other = &last(&files[files.len() - 1]);
        answers.extend([
            page.understand(main),
            page.drawings([main, other], 0.0, "", &silent),
            page.drawings([main, other], 20.1, "", &silent),
        ]);
    }
    answers.push(json!([page.zip().len(), "2 s"]));
    Value::Array(answers)
}

/// The words between the tags of a picture or page.
fn words(text: &str) -> Vec<&str> {
    let pieces = text.split('<').filter_map(|piece| piece.split_once('>'));
    let words = pieces.map(|(_, words)| words.trim());
    // The data of the viewer are numbers. Differences below 1e-9 µm are rounding.
    let is_data = |words: &str| words.starts_with('{') || words.contains("·10⁻¹");
    words.filter(|it| !it.is_empty() && !is_data(it)).collect()
}

/// The places where `other` is not equal to `native` are added to `unlike`: words are equal exactly, numbers within 1e-6 (µm, mm, degrees), pictures and
/// pages in their words. A line that is drawn through other points within its bound is no other picture.
fn compare(native: &Value, other: &Value, place: &str, unlike: &mut Vec<String>) {
    let is_same = match (native, other) {
        (Value::Number(one), Value::Number(two)) => {
            let [one, two] = [one, two].map(|number| number.as_f64().expect("a number"));
            (one - two).abs() <= 1e-6
        }
        (Value::Array(one), Value::Array(two)) => {
            for (number, (one, two)) in one.iter().zip(two).enumerate() {
                compare(one, two, &format!("{place}.{number}"), unlike);
            }
            one.len() == two.len()
        }
        (Value::Object(one), Value::Object(two)) => {
            // A search that ends by its effort examines other poses where last digits differ.
            let is_open = one.get("is_proven") == Some(&json!(false));
            let is_found = |key: &str| is_open && ["words", "spoken"].contains(&key);
            for (key, one) in one.iter().filter(|(key, _)| !is_found(key)) {
                compare(one, &two[key], &format!("{place}.{key}"), unlike);
            }
            one.keys().eq(two.keys())
        }
        (Value::String(one), Value::String(two)) if one.contains("<svg") => {
            let [one, two] = [one, two].map(|text| words(text.as_str()));
            let pairs = one.iter().zip(&two).filter(|(one, two)| one != two);
            unlike.extend(pairs.map(|(one, two)| format!("{place}: {one} {two}")));
            one.len() == two.len()
        }
        _ => native == other,
    };
    if !is_same {
        let short = |value: &Value| value.to_string().chars().take(300).collect::<String>();
        unlike.push(format!("{place}: {} {}", short(native), short(other)));
    }
}

#[test]
fn answers_under_node_are_the_native_ones() {
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let folder = target.unwrap_or_else(|| path("target")).join("page");
    if !folder.join("gearlash_bg.wasm").is_file() {
        return println!(
            "skipped: target/page/gearlash_bg.wasm is not there, see crates/web/build"
        );
    }
    let node = Command::new("node")
        .arg(path("crates/web/tests/page/under_node.cjs"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn();
    let Ok(mut node) = node else {
        return println!("skipped: node is not installed");
    };
    let cases = cases();
    let named = |files: &Files| -> Vec<_> {
        let named = files.iter().map(|path| json!([last(path), path]));
        named.collect()
    };
    let slow = SLOW.map(|name| vec![path(name)]);
    let all: Vec<_> = cases.iter().map(named).collect();
    let input = json!({ "page": folder, "cases": all, "slow": slow.each_ref().map(named) });
    let mut stdin = node.stdin.take().expect("stdin is piped");
    stdin
        .write_all(input.to_string().as_bytes())
        .expect("node reads its input");
    drop(stdin);
    // All before the native answers, which would slow node down.
    let lines = BufReader::new(node.stdout.take().expect("stdout is piped")).lines();
    let mut lines = lines.collect::<Vec<_>>().into_iter();
    let mut next = || -> Value {
        let line = lines.next().expect("node answers").expect("text");
        serde_json::from_str(&line).expect("an answer is JSON")
    };
    let (mut native, mut unlike) = (Vec::new(), Vec::new());
    for files in &cases {
        let answers = answers(files, &mut native);
        compare(&answers, &next(), &last(&files[0]), &mut unlike);
    }
    for files in slow {
        let mut page = page(files.iter().cloned());
        let opened = page.open(&last(&files[0]));
        let a = opened["distances_mm"][0].as_f64().expect("a distance");
        let report = page.report("2026-01-01", &silent);
        let curve = page.curve(a + 0.01, &silent);
        let answers = json!([report, page.marks(1, &silent), curve]);
        compare(&answers, &next(), "report", &mut unlike);
    }
    let end = next();
    assert_eq!(end["uncalled"], json!([]), "every function is called");
    let silence = format!("{} ms, {}", end["silence"], end["where"]);
    println!("longest silence: {silence}");
    assert!(end["silence"].as_f64() < Some(SILENCE), "{silence}");
    println!("verdict native and under node, first and next live answer with band, ms:");
    let pairs = cases.iter().zip(end["times"].as_array().expect("times"));
    let pairs = pairs.filter(|(_, times)| times[0].is_number());
    for ((files, times), [native, steps]) in pairs.zip(native) {
        let [verdict, taken, first, next] = [0, 1, 2, 3].map(|i| times[i].as_f64().unwrap());
        let name = last(&files[0]);
        println!("{name:25} {native:8.0} {verdict:8.0} {first:8.1} {next:8.1}");
        // Its time is guarded by its steps: at most a fourth more than natively. Last digits change how searches go.
        let is_small = taken <= 2.0 + 1.25 * steps;
        assert!(is_small, "{name}: {taken} steps for {steps}");
    }
    assert!(unlike.is_empty(), "{}", unlike.join("\n"));
    assert!(node.wait().expect("node ends").success());
}
