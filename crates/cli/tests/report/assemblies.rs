//! 20 and 20 teeth can be assembled in 20 ways: the page states the ones of its numbers.

use crate::command::{folder, gearlash, page};
use crate::two_thick_teeth::two_thick_teeth;
use crate::words::{row, select, text};
use scraper::Html;
use serde_json::Value;

fn twenty(sweep: &str) -> String {
    two_thick_teeth(20, 2.0, &format!("[sweep]\n{sweep}\n"))
}

/// The phases by `simulate`: teeth and least backlash.
fn phases() -> Vec<(String, f64)> {
    let folder = folder(&twenty("phases = \"all\""));
    let output = gearlash(&folder)
        .args(["simulate", "pair.toml", "--format", "json"])
        .assert()
        .success();
    let json: Value = serde_json::from_slice(&output.get_output().stdout).unwrap();
    let runs = json["runs"].as_array().unwrap().iter();
    runs.map(|run| {
        let phase = &run["phase"];
        (
            format!("{}·{}", phase["wheel_tooth"], phase["pinion_tooth"]),
            run["summary"]["min_j_wt_um"].as_f64().unwrap(),
        )
    })
    .collect()
}

fn words(document: &Html, selector: &str) -> String {
    let found = select(document, selector);
    found.iter().map(text).collect::<Vec<_>>().join(" ")
}

/// The page of phase 1·1 had left-flank poses of phase 1·2, and said that the pair does not assemble.
#[test]
fn a_pair_that_assembles_as_stated_assembles() {
    let phases = phases();
    let least = |name: &str| phases.iter().find(|(phase, _)| phase == name).unwrap().1;
    assert!(least("1·1") > 3.0 && least("1·2") < -20.0, "{phases:?}");
    let document = Html::parse_document(&page(&twenty("revolutions = \"wheel\"")));
    let answer = words(&document, ".answer");
    assert_eq!(answer, "Assembles at a = 39.950 mm.");
    let value = words(&document, ".extremes div:first-child .value");
    assert_eq!(value, format!("{:.2} µm", least("1·1")));
}

/// A left flank that the pair file names may be one of another assembly: the page says so.
#[test]
fn poses_of_another_assembly_are_reported() {
    let document = Html::parse_document(&page(&twenty("mating = [[1, 1], [5, 5]]")));
    let notes = words(&document, "#result .note");
    let shown = "Of the poses that the pair file asks for, 2 belong to another phase: the teeth that it names meet at those flanks \
                where wheel tooth 1 meets pinion tooth 2.";
    assert!(notes.contains(shown), "{notes}");
}

/// One other phase and one pose of it: the page said "there are 1 other ways" and "1 belong".
#[test]
fn one_other_assembly_is_counted_as_one() {
    let text = twenty("mating = [[1, 1]]");
    let (wheel, pinion) = text.split_once("[pinion]").unwrap();
    let twenty_two = pinion
        .replace("teeth = 20", "teeth = 22")
        .replace("per_tooth_um = [", "per_tooth_um = [0, 0, ");
    let text = format!("{wheel}[pinion]{twenty_two}").replace("39.95", "41.95");
    let document = Html::parse_document(&page(&text));
    let notes = words(&document, "#result .note");
    assert!(notes.contains("there is one other way to put"), "{notes}");
    assert!(notes.contains(", 1 belongs to another phase"), "{notes}");
}

/// How many phases fail, and each with its charts.
#[test]
fn phases_that_do_not_assemble_are_counted() {
    let phases = phases();
    let failing: Vec<&str> = phases
        .iter()
        .filter_map(|(phase, least)| (*least < 0.0).then_some(phase.as_str()))
        .collect();
    assert!((1..6).contains(&failing.len()), "{phases:?}");
    let document = Html::parse_document(&page(&twenty("phases = \"all\"")));
    let answer = words(&document, ".answer");
    let expected = format!(
        "Does not assemble at a = 39.950 mm in {} of 20 phases.",
        failing.len()
    );
    assert!(answer.starts_with(&expected), "{answer}");
    let cells = row(
        &document,
        "#backlash div[aria-label=\"Assembly phases\"]",
        "39.950",
    );
    let assemble = (20 - failing.len()).to_string();
    assert_eq!(cells[1..4], ["single thickness", "20", &assemble]);
    let more = words(&document, "#backlash summary");
    assert!(
        more.contains("More: backlash over the teeth in the other phases"),
        "{more}"
    );
    let titles = words(&document, "#backlash svg");
    assert!(
        titles.contains("Backlash over the teeth at a = 39.950 mm, phase 1·2"),
        "{titles}"
    );
}
