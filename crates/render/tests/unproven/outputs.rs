//! Every text, file and picture says that a pose is not proven, and none gives its value as if it were.

use super::{BELIEVED, CERTIFIED, Case, LOW_TIPS, REVOLUTION, on, unproven};
use gearlash::analysis::Analysis;
use gearlash::analysis::compare::{ComparedRun, Summary};
use gearlash::analysis::curves::courses;
use gearlash::analysis::diagnosis::{self, Diagnosis, diagnose};
use gearlash::analysis::extremes::CycleExtremes;
use gearlash::analysis::outcome::{Agreement, Outcome as PoseOutcome};
use gearlash::analysis::study::Material;
use gearlash::analysis::tally::{tally, tally_by_blocks};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::{Method, PoseClass};
use gearlash::pair::BacklashUnit;
use gearlash_render::chart::{self, Chart, Heading};
use gearlash_render::{Report, Snapshot, report, snapshot};
use gearlash_results::judged::{JudgedFile, Outcome};
use gearlash_results::text::{Screen, check, simulation as simulation_table};
use gearlash_results::{ComparedPair, RemedyRecords, ResultWriter, checked};
use roxmltree::Document;
use serde_json::Value;
use std::sync::LazyLock;

static RUNS: LazyLock<Vec<ComparedRun>> = LazyLock::new(|| LOW_TIPS.compared(CERTIFIED));

/// Poses of [`RUNS`] that are not proven.
fn count() -> usize {
    summary(&RUNS).unproven
}

fn no_verdict() -> Verdict<'static> {
    Verdict::new(&[], &Vec::new(), None, Vec::new())
}

/// The first of `runs` in numbers.
fn summary(runs: &[ComparedRun]) -> Summary {
    tally(runs)[0].summary()
}

/// The value of the exact method that would be the least of all, as texts print µm.
fn doubtful(runs: &[ComparedRun], decimals: usize) -> String {
    let poses = runs[0].poses.iter();
    let doubts = poses.filter_map(|pose| unproven(&pose.simulated)?.exact);
    let least = doubts.reduce(f64::min).unwrap();
    assert!(least < summary(runs).min.unwrap());
    format!("{:.decimals$}", least * 1e3)
}

/// The outcome of `compare` for `runs`.
fn outcome(runs: &[ComparedRun]) -> Outcome {
    let mut file = LOW_TIPS.pair.clone();
    file.study.allow_off_line_contact = true;
    let pair = ComparedPair {
        name: "pair.toml".to_owned(),
        file: &file,
        tolerance_um: LOW_TIPS.study.tolerance_um,
        is_proven: runs.iter().all(|run| run.unproven().count() == 0),
        runs: tally(runs),
        extremes: Vec::new(),
        failed_checks: Vec::new(),
    };
    let judged = pair.judged(&Screen::default());
    Outcome {
        command: "compare",
        files: vec![JudgedFile::Judged(Box::new(judged))],
    }
}

/// The result of `runs` as JSON and as CSV.
fn written(case: &Case, runs: &[ComparedRun]) -> [String; 2] {
    let (mut json, mut csv) = (Vec::new(), Vec::new());
    let (to_json, to_csv) = (Box::new(&mut json), Box::new(&mut csv));
    let mut writer = ResultWriter::begin(&case.pair, Some(to_json), Some(to_csv)).unwrap();
    tally_by_blocks(runs, &mut |piece| writer.take(piece)).unwrap();
    writer.finish(&no_verdict()).unwrap();
    [json, csv].map(|text| String::from_utf8(text).unwrap())
}

#[test]
fn json_has_nulls_and_the_doubtful_values_under_their_own_keys() {
    let um = |mm: Option<f64>| mm.map(|mm| mm * 1e3);
    for method in [CERTIFIED, Method::Both] {
        let runs = LOW_TIPS.compared(method);
        let [json, _] = written(&LOW_TIPS, &runs);
        let json: Value = serde_json::from_str(&json).unwrap();
        let run = &json["runs"][0];
        let mut count = 0;
        for (written, pose) in run["poses"].as_array().unwrap().iter().zip(&runs[0].poses) {
            let Some(doubt) = unproven(&pose.simulated) else {
                assert_ne!(written["status"], "unproven");
                assert!(written.get("unproven").is_none() && written["j_wt_um"].is_number());
                continue;
            };
            count += 1;
            assert_eq!(written["status"], "unproven");
            assert_eq!(written["class"], "unproven");
            let null = "right_rad left_rad lost_motion_rad j_wt_um j_t_um j_bn_um j_r_um error_bound_um right left";
            for key in null.split(' ') {
                assert!(written[key].is_null(), "{key}");
            }
            let record = &written["unproven"];
            assert_eq!(record["reason"], doubt.reason.as_str());
            assert_eq!(record["exact_j_wt_um"].as_f64(), um(doubt.exact));
            assert_eq!(record["polygon_j_wt_um"].as_f64(), um(doubt.polygon));
        }
        assert!(count > 0 && run["summary"]["unproven"] == count);
        assert_eq!(run["summary"]["contact"]["classes"]["unproven"], count);
    }
}

#[test]
fn csv_has_empty_cells_and_columns_of_doubt() {
    let case = Case::low_tips(&format!("bearing_clearance_mm = 0.01\n{REVOLUTION}"));
    let runs = case.compared(Method::Both);
    let [_, csv] = written(&case, &runs);
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let headers = reader.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 160);
    for (row, pose) in rows.iter().zip(&runs[0].poses) {
        let cell = |name: &str| &row[headers.iter().position(|header| header == name).unwrap()];
        let doubt = unproven(&pose.simulated);
        let reason = doubt.map_or("", |doubt| &doubt.reason);
        assert_eq!(cell("unproven_reason"), reason);
        assert_eq!(cell("status") == "unproven", doubt.is_some());
        for found in ["j_wt_um", "right_wheel_tooth"] {
            assert_eq!(cell(found).is_empty(), doubt.is_some(), "{found}");
        }
        for (end, name) in ["min", "max"].into_iter().enumerate() {
            let is_proven = cell(&format!("unproven_range_{name}_reason")).is_empty();
            assert_ne!(is_proven, pose.simulated.is_end_unproven(end));
        }
    }
}

/// The lines of each text that say that a pose is not proven, or that show the value in doubt. `simulate` has few enough poses to list
/// them one by one, the four of the revolution among them.
#[test]
fn texts_say_so() {
    let few = Case::low_tips(
        "[sweep]\nmating = [[3, 3], [4, 4], [5, 5]]\nfraction = [0.0, 0.25, 0.5, 0.75]\n",
    );
    let screen = Screen::default();
    let swept = tally(&few.compared(CERTIFIED));
    let (none, unit) = (no_verdict(), BacklashUnit::Um);
    let simulated = simulation_table(&few.study, &none, &swept, &[], unit, &screen);
    let compared = outcome(&RUNS);
    let found = diagnosed(&RUNS);
    let verdict = Verdict::new(&[], &Vec::new(), None, found.failed());
    let remedies = RemedyRecords::default();
    let checked = check::text(&LOW_TIPS.pair, &verdict, &found, &remedies, &screen);
    let doubtful = doubtful(&RUNS, 3);
    let mut told = String::new();
    for (name, text) in [
        ("simulate", simulated),
        ("compare", compared.text(&screen)),
        ("junit", compared.junit().unwrap()),
        ("github", compared.github(|_| String::new())),
        ("markdown", compared.markdown()),
        ("check", checked),
    ] {
        let is_of_doubt = |line: &&str| {
            let words = ["unproven", "not proven", "the certificate failed"];
            let mut words = words.into_iter().chain([doubtful.as_str()]);
            words.any(|words| line.to_lowercase().contains(words))
        };
        let lines: Vec<&str> = text.lines().filter(is_of_doubt).collect();
        told += &format!("{name}\n{}\n", lines.join("\n"));
    }
    // On other platforms last digits differ.
    if cfg!(all(target_os = "linux", target_arch = "x86_64")) {
        insta::assert_snapshot!(told);
    }
}

#[test]
fn a_comparison_fails_for_them() {
    let sound = outcome(&LOW_TIPS.compared(BELIEVED)).text(&Screen::default());
    assert!(sound.contains(" backlash agree within "), "{sound}");
    let (count, outcome) = (count(), outcome(&RUNS));
    assert!(!outcome.passes());
    let json: Value = serde_json::from_str(&outcome.json()).unwrap();
    let run = &json["files"][0]["runs"][0];
    assert_eq!(run["passed"], false);
    assert_eq!(run["unproven"], count);
    assert_eq!(run["unproven_poses"].as_array().unwrap().len(), count);
    assert_eq!(run["compared"], 160 - count);
}

#[test]
fn an_outcome_counts_its_unproven_poses() {
    let whole = PoseOutcome::of(&[&RUNS[0]], &[]);
    assert_eq!(whole.unproven, count());
    assert_eq!(whole.unproven_ends, [whole.unproven; 2]);
    let agreement = Agreement::of(&[&RUNS[0]]);
    assert_eq!(agreement.unproven, whole.unproven);
    assert_eq!((agreement.jammed, agreement.neither), (0, 0));
    let sum = agreement.both + agreement.simulated_alone + whole.unproven;
    assert_eq!(agreement.poses, sum);
}

/// Both charts of the runs, which say how many poses are not drawn.
fn charts(runs: &[ComparedRun]) -> [Chart; 2] {
    let course = &courses(runs)[0];
    let heading = Heading {
        prefix: "chart",
        title: "t",
        subtitle: "",
    };
    let drawn = [
        chart::revolution(BacklashUnit::Um, &heading, course),
        chart::difference(&heading, course, 0.1).unwrap(),
    ];
    let words = format!("{} poses unproven, not drawn", summary(runs).unproven);
    for chart in &drawn {
        assert!(chart.svg.contains(&words), "{}", chart.svg);
    }
    drawn
}

#[test]
fn charts_have_a_gap_and_a_caption() {
    let course = &courses(&RUNS)[0];
    let mut points = course.lines[0].points.clone();
    points.retain(|point| point.simulated_um.is_none());
    assert_eq!(points.len(), count());
    let least = course.least.unwrap().backlash_um;
    assert_eq!(Some(least), summary(&RUNS).min.map(|mm| mm * 1e3));
    let [revolution, _] = charts(&RUNS);
    assert!(revolution.svg.contains("gaps: unproven"));
    // Texts only: coordinates can contain any digits.
    let document = Document::parse(&revolution.svg).unwrap();
    let mut texts = document.descendants().filter_map(|node| node.text());
    assert!(!texts.any(|text| text.contains(&doubtful(&RUNS, 1))));
}

/// Nothing but unproven poses.
#[test]
fn charts_of_nothing_proven_are_drawn_empty() {
    let runs = Case::far(REVOLUTION).compared(Method::Both);
    assert_eq!(summary(&runs).unproven, 160);
    assert_eq!(tally(&runs)[0].extremes(), None);
    charts(&runs);
}

#[test]
fn a_picture_draws_no_contact_and_says_why() {
    let run = &RUNS[0];
    let pose = run.unproven().next().unwrap();
    let svg = snapshot(&Snapshot {
        title: "t",
        assembly: &run.run.assembly,
        pose: &pose.simulated.pose,
        material: Material::AsMeasured,
        found: pose.simulated.found.as_ref(),
        section: None,
    });
    let words = "unproven, no contact is drawn: the certificate failed";
    assert!(svg.contains(words), "{svg}");
    assert_eq!(svg.matches("not proven: none is drawn").count(), 2);
    for words in ["j_wt =", "flanks touch", "gap j_bn", "overlap"] {
        assert!(!svg.contains(words), "{words}");
    }
}

/// The checks that are measured over the poses.
const OF_POSES: [&str; 6] = [
    "backlash_condition",
    "non_involute_form",
    "non_involute_k8",
    "non_involute_onset",
    "off_line_contact",
    "zero_backlash_distance",
];

fn diagnosed(runs: &[ComparedRun]) -> Diagnosis {
    let outlines = Default::default();
    diagnose(&LOW_TIPS.study, runs, &outlines, &mut |_| Ok(()), &on).unwrap()
}

#[test]
fn a_report_vouches_for_nothing() {
    let runs = RUNS.clone();
    let analysis = Analysis {
        maps: Vec::new(),
        widths: Vec::new(),
        field: None,
        study: &LOW_TIPS.study,
        method: CERTIFIED,
        diagnosis: diagnosed(&runs),
        runs: runs.clone(),
        revolution: runs.clone(),
        curves: runs,
        extremes: CycleExtremes::default(),
        failed_checks: Vec::new(),
        remedies: Default::default(),
        over_distance: Vec::new(),
        measured: Vec::new(),
    };
    let page = report(&Report {
        pair: &LOW_TIPS.pair,
        file: "pair.toml",
        date: "2026-01-01",
        analysis: &analysis,
        grades: &[],
        tick: &on,
    })
    .unwrap();
    let document = scraper::Html::parse_document(&page);
    let text = |selector: &str| {
        let selector = scraper::Selector::parse(selector).unwrap();
        let element = document.select(&selector).next().unwrap();
        let words = element.text().collect::<String>();
        words.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let count = count();
    assert!(analysis.unproven() >= count);
    let unproven = format!("{count} of 160 poses are unproven");
    for (place, words) in [
        ("#result .verdict.unproven", &*unproven),
        ("#result tbody", "unproven"),
        ("#trust", "Not without a check"),
        ("#models", &format!("{count} are unproven: not compared")),
        ("#unproven", "the certificate failed"),
        ("#checks", "No check fails, but some are unproven"),
        ("#viewer-data", "\"unproven\""),
    ] {
        assert!(text(place).contains(words), "{place}: {words}");
    }
    let doubtful = doubtful(&RUNS, 2);
    for section in ["#result", "#trust", "#checks", "#models", "#poses"] {
        assert!(!text(section).contains(&doubtful), "{section}");
    }
}

/// Checks whose poses are not proven are not proven, and no other.
#[test]
fn what_is_measured_over_an_unproven_pose_is_unproven() {
    use diagnosis::CheckVerdict::Unproven;
    let [certified, believed] = [&RUNS, &LOW_TIPS.compared(BELIEVED)].map(|runs| diagnosed(runs));
    let [checks, others] = [&certified, &believed].map(|one| &one.groups[0].checks);
    for (check, believed) in checks.iter().zip(others) {
        if !OF_POSES.contains(&check.id) {
            assert_eq!(check, believed);
            continue;
        }
        let reason = check.unproven.as_deref().unwrap();
        assert!(reason.contains("of 160 poses are unproven"), "{reason}");
        assert!(reason.contains("the certificate failed"), "{reason}");
        assert_eq!(check.formula, believed.formula);
        assert_eq!((check.outlines, check.margin), (None, None), "{}", check.id);
        assert_eq!(check.verdict, Unproven, "{}", check.id);
        assert!(check.details.is_empty());
    }
    assert_eq!(certified.verdict(), Unproven);
    assert!(certified.groups[0].zero.is_err() && certified.groups[0].onset.is_err());
    assert!(believed.verdict() < Unproven);
    let unproven = certified.contact.classes[&PoseClass::Unproven];
    assert!(unproven > 0 && certified.contact.poses() == 160);
}

#[test]
fn json_of_checks_says_so() {
    let found = diagnosed(&RUNS);
    let verdict = Verdict::new(&[], &Vec::new(), None, found.failed());
    let (screen, remedies) = (Screen::default(), RemedyRecords::default());
    let pair = &LOW_TIPS.pair;
    let name = "pair.toml";
    let json = checked(name, pair, &found, &verdict, &remedies, true, &screen).json;
    assert_eq!(json["checks_verdict"], "unproven");
    for check in json["checks"].as_array().unwrap() {
        let id = check["id"].as_str().unwrap();
        let unproven = OF_POSES.contains(&id);
        assert_eq!(check["verdict"] == "unproven", unproven, "{id}");
        assert_eq!(check["unproven"].is_string(), unproven, "{id}");
        assert!(!unproven || check["outlines"].is_null(), "{id}");
    }
}
