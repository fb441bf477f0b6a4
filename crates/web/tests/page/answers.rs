//! The answers of the page against the same files read from disk.

use super::{last, page, path, silent};
use gearlash::analysis::requirement::Quantity;
use gearlash::analysis::study::Study;
use gearlash::analysis::{Analysis, Plan};
use gearlash::contact::{Method, lost_motion_at};
use gearlash::error::go_on;
use gearlash::gear::Side;
use gearlash::pair::{Mating, Member};
use gearlash_input::read;
use gearlash_results::verdict::lines;
use gearlash_web::answers::{LivePlace, OnStep, Page};
use serde_json::{Value, json};
use std::io::{Cursor, Read};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};

/// A page with these files, and the answer to opening the first.
fn opened(names: &[&str]) -> (Page, Value) {
    let mut page = page(names.iter().map(|name| path(name)));
    let found = page.open(&last(&path(names[0])));
    (page, found)
}

fn study(name: &str) -> Study {
    read(&path(name)).expect("an example can be read").study
}

fn certified(study: &Study) -> Plan<'_> {
    Plan::new(study, Method::Exact { certify: true })
}

/// The right flanks of teeth 1 at a centre distance.
fn first(distance: f64) -> LivePlace {
    LivePlace {
        distance,
        material: 0,
        teeth: [1, 1],
        left: false,
        fraction: 0.0,
    }
}

/// Two drawings of one pair, behind its file.
const DRAWN: [&str; 3] = [
    "fixtures/outlines/drawn_20x20.toml",
    "fixtures/outlines/wheel_20.dxf",
    "fixtures/outlines/pinion_20.svg",
];

/// Pairs with their tables and drawings: first those of the page.
const EXAMPLES: [&[&str]; 7] = [
    &["docs/files/drawing.toml"],
    &[
        "crates/web/page/example/drawn.toml",
        "crates/web/page/example/wheel.dxf",
        "crates/web/page/example/tooth.svg",
    ],
    &["docs/files/sheet.toml", "docs/files/wheel.csv"],
    &["docs/files/jams.toml"],
    &["docs/files/helical.toml"],
    &["fixtures/karba_44x44.toml", "fixtures/karba_tables_5_6.csv"],
    &DRAWN,
];

/// The third line states the teeth; the table is missing.
#[test]
fn problems_have_their_lines_and_a_missing_table_its_name() {
    let mut page = Page::default();
    let text = "title = \"é\"\n[wheel]\nteeth = 20.5\n";
    page.files.add("pair.toml", text.as_bytes().to_vec());
    let found = page.open("pair.toml");
    let problems = found["problems"].as_array().expect("it has problems");
    let teeth = problems.iter().find(|one| one["key"] == "wheel.teeth");
    let teeth = teeth.expect("the teeth are wrong");
    assert_eq!(teeth["line"], 3);
    let units: Vec<u16> = text.encode_utf16().collect();
    let [from, to] = ["from", "to"].map(|end| teeth[end].as_u64().unwrap() as usize);
    assert_eq!(String::from_utf16_lossy(&units[from..to]), "teeth = 20.5");
    let (_, found) = opened(&["docs/files/sheet.toml"]);
    let missing = found.to_string().contains("wheel.csv: not here yet");
    assert!(missing, "{found}");
}

/// Source: the library's pose and, for the whole cycle, its extremes at the same distance.
#[test]
fn a_moved_pair_has_the_backlash_of_its_distance() {
    let name = "docs/files/jams.toml";
    let (page, _) = opened(&[name]);
    let study = study(name);
    let a = study.center_distances[0] + 0.3;
    let (left, fraction) = (true, 0.25);
    let place = LivePlace {
        left,
        fraction,
        ..first(a)
    };
    let live = page.live(&place);
    let (_, assembly) = study.pairs(a).unwrap().remove(0);
    let mating = Mating {
        fraction,
        ..Mating::at(1, 1, Side::Left)
    };
    let own = lost_motion_at(&assembly, mating).unwrap().backlash.unwrap() * 1e3;
    assert_eq!(live["j_wt_um"].as_f64(), Some(own));
    let run = &live["mesh"]["runs"][0];
    assert_eq!(run["j_wt_um"][0], live["j_wt_um"]);
    assert_eq!(run["center_distance_mm"], a);
    for (answer, key, part) in [
        (page.mesh(&place), "html", "id=\"viewer-pinion\""),
        (page.picture(&place), "svg", "<svg"),
    ] {
        assert!(answer[key].as_str().unwrap().contains(part), "{key}");
    }
    let band = page.live_band(a, false, &go_on);
    let moved = study.at(vec![a]).unwrap();
    let analysis = Analysis::silently(&certified(&moved).with_extremes()).unwrap();
    let verdict = analysis.verdict();
    let least = verdict.least().unwrap().1.low * 1e3;
    assert_eq!(band["least_um"].as_f64(), Some(least));
    let wrong = page.live(&LivePlace {
        teeth: [0, 1],
        ..place
    });
    let reason = wrong["failed"].as_str().unwrap();
    assert!(reason.contains("teeth 1"), "{wrong}");
}

/// Source: the pair read from disk, as the program does. A band takes the least from the thickest gears and the greatest from the thinnest. It
/// says nothing of other distances: these are not searched.
#[test]
fn a_verdict_and_a_band_are_those_of_the_files_on_disk() {
    for names in EXAMPLES {
        let (page, found) = opened(names);
        let result = page.result(&silent);
        assert!(result["curve"][1].as_str().unwrap().contains("-narrow"));
        let file = read(&path(names[0])).unwrap();
        let plan = certified(&file.study).with_remedies(file.spec.stated_gears());
        let analysis = Analysis::silently(&plan.with_checks()).unwrap();
        let text = lines(&analysis.verdict()).to_string();
        assert_eq!(result["verdict"]["text"], text, "{names:?}");
        let a = found["distances_mm"][0].as_f64().unwrap();
        let is_one = found["distances_mm"][1].is_null();
        assert!(!is_one || page.curve(a, &silent)["curve"] == result["curve"]);
        let [low, high] = [0, 1].map(|end| found["range_mm"][end].as_f64().unwrap());
        for end in [low, high] {
            let band = page.live_band(end, false, &go_on);
            let is_said = band.to_string().contains("no centre distance");
            assert!(band["words"].is_string() && !is_said, "{band}");
        }
        for more in [0.0, 0.02] {
            let Ok(study) = file.study.clone().at(vec![a + more]) else {
                continue;
            };
            let analysis = Analysis::silently(&certified(&study).with_extremes()).unwrap();
            let verdict = analysis.verdict();
            let quick = page.live_band(a + more, false, &go_on);
            let is_proven = verdict.runs.iter().all(|run| run.is_proven());
            assert_eq!(quick["is_proven"], is_proven, "{names:?}: {quick}");
            let band = page.live_band(a + more, true, &go_on);
            let least = verdict.least().map(|(_, least)| least.low);
            let greatest = verdict.greatest().map(|(_, greatest)| greatest.high);
            for (name, end) in [("least_um", least), ("greatest_um", greatest)] {
                let (own, shown) = (end.map(|mm| mm * 1e3), band[name].as_f64());
                let is_same = match (own, shown) {
                    (Some(own), Some(shown)) => (own - shown).abs() < 2e-3,
                    (own, shown) => own == shown,
                };
                assert!(is_same, "{names:?}, {name}: {own:?} {shown:?}");
            }
            let words = band["words"].as_str().unwrap();
            for row in &lines(&verdict).extremes {
                assert!(words.contains(row.name), "{names:?}: {words}");
            }
        }
    }
}

/// Two drawings without a pair file: the text that is made can be opened, and the gears touch there.
#[test]
fn two_drawings_make_a_pair_file() {
    let (mut page, _) = opened(&DRAWN[1..]);
    let made = page.drawings(["wheel_20.dxf", "pinion_20.svg"], 0.0, "", &silent);
    let text = made["text"].as_str().expect("both state their unit");
    page.files.add("pair.toml", text.as_bytes().to_vec());
    let found = page.open("pair.toml");
    let a = found["distances_mm"][0].as_f64().unwrap();
    let band = page.live_band(a, false, &go_on);
    let least = band["least_um"].as_f64().unwrap();
    // Rounded up to 1 µm, the distance leaves at most 2 µm tan α_w.
    assert!((-1e-3..2.0).contains(&least), "{a}: {least}");
}

/// A table that was given without its folder. Its name is among those that the pair file names, also where it is missing.
#[test]
fn a_table_is_found_by_its_name_alone() {
    let text = std::fs::read_to_string(path("docs/files/sheet.toml")).unwrap();
    let text = text.replace("\"wheel.csv\"", "\"./sheets/Bob's wheel.csv\"");
    let mut page = Page::default();
    page.files.add("pair.toml", text.into_bytes());
    let missed = page.open("pair.toml");
    let table = std::fs::read(path("docs/files/wheel.csv")).unwrap();
    page.files.add("bob's wheel.csv", table);
    let found = page.open("pair.toml");
    assert!(found["stem"].is_string(), "{found}");
    let understood = page.understand("bob's wheel.csv");
    let toml = understood["toml"].as_str().unwrap();
    assert!(toml.contains("wheel.csv"), "{toml}");
    let text = understood["text"].as_str().unwrap();
    // Lines of the table are shown though no folder holds it.
    assert!(text.contains("pitch") && text.contains("\"Max\""), "{text}");
    assert!(page.understand("pinion.csv")["failed"].is_string());
    for found in [missed, found] {
        assert_eq!(found["files"], json!(["pair.toml", "Bob's wheel.csv"]));
    }
}

/// The archive holds every file as it was given. Source: the crate `zip`, which checks its sums.
#[test]
fn the_archive_holds_the_files() {
    let names = ["docs/files/sheet.toml", "docs/files/wheel.csv"];
    let (page, _) = opened(&names);
    let mut archive = zip::ZipArchive::new(Cursor::new(page.zip())).unwrap();
    assert_eq!(archive.len(), names.len());
    for name in names {
        let mut found = Vec::new();
        let mut file = archive.by_name(&last(&path(name))).unwrap();
        file.read_to_end(&mut found).unwrap();
        assert_eq!(found, std::fs::read(path(name)).unwrap());
    }
}

/// A break at any tick ends verdict, report, marks and curve: nothing of them is left.
#[test]
fn a_tick_ends_any_work() {
    let (page, _) = opened(&["docs/files/jams.toml"]);
    let works: [&dyn Fn(&OnStep) -> Value; 5] = [
        &|report| page.result(report),
        &|report| page.report("2026-01-01", report),
        &|report| page.marks(0, report),
        &|report| page.marks(1, report),
        &|report| page.curve(39.3, report),
    ];
    for work in works {
        let calls = AtomicU64::new(0);
        work(&|_, _, _| go_on(calls.fetch_add(1, Ordering::Relaxed)));
        let all = calls.into_inner();
        for part in 0..8 {
            let (left, most) = (AtomicU64::new(0), all * part / 8);
            let ended = work(&|_, _, _| match left.fetch_add(1, Ordering::Relaxed) {
                call if call < most => ControlFlow::Continue(()),
                _ => ControlFlow::Break(()),
            });
            let is_ended = ended["failed"].is_string() || ended == json!([]);
            assert!(is_ended, "after {most} of {all}: {ended}");
        }
    }
}

/// Counts stand for time: the picture is drawn once, an answer that moves it stays short, a band takes few steps, and so does a verdict. A
/// page is usable with the verdict of the first example.
#[test]
fn a_frame_and_a_verdict_are_small() {
    for names in EXAMPLES {
        let (page, found) = opened(names);
        let at = first(found["distances_mm"][0].as_f64().unwrap());
        let mesh = page.mesh(&at)["html"].as_str().unwrap().to_owned();
        let steps = AtomicU64::new(0);
        let step = |_| go_on(steps.fetch_add(1, Ordering::Relaxed));
        let band = page.live_band(at.distance, false, &step).to_string();
        let of_verdict = AtomicU64::new(0);
        page.result(&|_, _, _| go_on(of_verdict.fetch_add(1, Ordering::Relaxed)));
        let [steps, of_verdict] = [steps, of_verdict].map(|steps| steps.into_inner() as usize);
        let (elements, live) = (mesh.matches('<').count(), page.live(&at).to_string().len());
        let counts = [elements, mesh.len(), live, band.len(), steps, of_verdict];
        // Elements and bytes of the picture, bytes of a pose and of a band, rounds of up to 96 cells of the band, steps of the verdict.
        let mut pairs = counts.iter().zip([400, 600_000, 2_000, 500, 40, 20_000]);
        assert!(pairs.all(|(count, most)| *count <= most), "{counts:?}");
    }
}

/// A unit is that of the drawing that states none alone. The band shows limits of lost motion as backlash: `j_wt = φ r_w`, r_w = a z/Σz.
#[test]
fn units_and_limits_are_those_of_what_states_them() {
    let (mut page, _) = opened(&DRAWN[1..]);
    let mut dxf = String::from_utf8(page.files.get("wheel_20.dxf").unwrap().to_vec()).unwrap();
    for unit in ["$INSUNITS", "$MEASUREMENT", "unit: mm"] {
        dxf = dxf.replace(unit, "$UNKNOWN");
    }
    page.files.add("wheel_20.dxf", dxf.into_bytes());
    let made = |unit: &str| page.drawings(["wheel_20.dxf", "pinion_20.svg"], 0.0, unit, &silent);
    assert!(made("")["problems"].is_array());
    let text = made("mm")["text"].as_str().unwrap().to_owned();
    assert_eq!(text.matches("units").count(), 1, "{text}");
    let (page, found) = opened(&["docs/files/joint.toml"]);
    let a = found["distances_mm"][0].as_f64().unwrap();
    let study = study("docs/files/joint.toml");
    let band = page.live_band(a, false, &go_on);
    let [wheel, pinion] = study.teeth().map(f64::from);
    let (quantity, limits) = study.requirements[0];
    let teeth = match quantity {
        Quantity::LostMotion(Member::Wheel) => wheel,
        Quantity::LostMotion(Member::Pinion) => pinion,
        other => panic!("{other:?}"),
    };
    let limit = limits.min.unwrap() * a * teeth / (wheel + pinion) * 1e3;
    let shown = band["limits"][0]["um"].as_f64().unwrap();
    assert!((shown - limit).abs() < 1e-9, "{band}: {limit}");
}

/// A pair file may have 1 MiB, any other file 64 MiB; the problem names the limit.
#[test]
fn files_that_are_too_large_are_named_with_the_limit() {
    let page = Page::default();
    for (name, most, limit) in [("a.toml", 1 << 20, "1 MiB"), ("a.dxf", 64 << 20, "64 MiB")] {
        assert!(page.too_large(name, most).is_null());
        let words = page.too_large(name, most + 1)["problems"].to_string();
        let is_named = words.contains(name) && words.contains(&format!("up to {limit}"));
        assert!(is_named, "{words}");
    }
}
