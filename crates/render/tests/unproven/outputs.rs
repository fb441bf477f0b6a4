//! Every text, file and picture says that a pose is not proven, and none gives its value as if it were.

use super::{CERTIFIED, Case, REVOLUTION, unproven};
use gearlash::analysis::Analysis;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::curves::courses;
use gearlash::analysis::diagnosis::diagnose;
use gearlash::analysis::extremes::CycleExtremes;
use gearlash::analysis::outcome::{Agreement, Outcome as PoseOutcome};
use gearlash::analysis::tally::tally;
use gearlash::analysis::tally::whole;
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::Method;
use gearlash::pair::BacklashUnit;
use gearlash_render::chart::{self, Heading};
use gearlash_render::snapshot;
use gearlash_render::{Report, Snapshot, report};
use gearlash_results::ComparedPair;
use gearlash_results::ResultWriter;
use gearlash_results::judged::{JudgedFile, Outcome};
use gearlash_results::text::Screen;
use gearlash_results::text::simulation as simulation_table;
use roxmltree::Document;
use serde_json::Value;

/// Keys of a pose that hold what was found.
const FOUND: [&str; 10] = [
    "right_rad",
    "left_rad",
    "lost_motion_rad",
    "j_wt_um",
    "j_t_um",
    "j_bn_um",
    "j_r_um",
    "error_bound_um",
    "right",
    "left",
];

/// The value of the exact method that would be the least of all, as texts print µm.
fn doubtful(runs: &[ComparedRun], decimals: usize) -> String {
    let poses = runs[0].poses.iter();
    let doubts = poses.filter_map(|pose| unproven(&pose.simulated)?.exact);
    let least = doubts.reduce(f64::min).unwrap();
    assert!(least < runs[0].summary().min.unwrap());
    format!("{:.decimals$}", least * 1e3)
}

/// The outcome of `compare` for `runs`.
fn compared(case: &Case, runs: &[ComparedRun]) -> Outcome {
    let mut file = case.pair.clone();
    file.study.allow_off_line_contact = true;
    let pair = ComparedPair {
        name: "pair.toml".to_owned(),
        file: &file,
        tolerance_um: case.study.tolerance_um,
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
    whole(runs, &mut |piece| writer.take(piece)).unwrap();
    let verdict = Verdict::new(&[], &Vec::new(), None, Vec::new());
    writer.finish(&verdict).unwrap();
    [json, csv].map(|text| String::from_utf8(text).unwrap())
}

#[test]
fn json_has_nulls_and_the_doubtful_values_under_their_own_keys() {
    for method in [CERTIFIED, Method::Both] {
        let case = Case::low_tips();
        let runs = case.compared(method);
        let [json, _] = written(&case, &runs);
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
            assert!(FOUND.iter().all(|key| written[key].is_null()));
            let record = &written["unproven"];
            assert_eq!(record["reason"], doubt.reason.as_str());
            assert_eq!(
                record["exact_j_wt_um"].as_f64(),
                doubt.exact.map(|mm| mm * 1e3)
            );
            assert_eq!(
                record["polygon_j_wt_um"].as_f64(),
                doubt.polygon.map(|mm| mm * 1e3)
            );
        }
        assert!(count > 0 && run["summary"]["unproven"] == count);
        assert_eq!(run["summary"]["contact"]["classes"]["unproven"], count);
    }
}

#[test]
fn csv_has_empty_cells_and_columns_of_doubt() {
    let case = Case::of(&format!("bearing_clearance_mm = 0.01\n{REVOLUTION}"));
    let runs = case.compared(Method::Both);
    let [_, csv] = written(&case, &runs);
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let headers = reader.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 160);
    for (row, pose) in rows.iter().zip(&runs[0].poses) {
        let cell = |name: &str| &row[headers.iter().position(|header| header == name).unwrap()];
        let doubt = unproven(&pose.simulated);
        assert_eq!(cell("status") == "unproven", doubt.is_some());
        assert_eq!(
            cell("unproven_reason"),
            doubt.map_or("", |doubt| &doubt.reason)
        );
        assert_eq!(cell("j_wt_um").is_empty(), doubt.is_some());
        assert_eq!(cell("right_wheel_tooth").is_empty(), doubt.is_some());
        let end = |end: usize| {
            !["unproven_range_min_reason", "unproven_range_max_reason"].map(cell)[end].is_empty()
        };
        assert!((0..2).all(|at| end(at) == pose.simulated.is_end_unproven(at)));
    }
}

#[test]
fn the_table_counts_them_and_takes_none_in() {
    // Few enough to be listed one by one, the four of the revolution among them.
    let case =
        Case::of("[sweep]\nmating = [[3, 3], [4, 4], [5, 5]]\nfraction = [0.0, 0.25, 0.5, 0.75]\n");
    let runs = case.compared(CERTIFIED);
    let text = simulation_table(
        &case.study,
        &Verdict::new(&[], &Vec::new(), None, Vec::new()),
        &tally(&runs),
        &[],
        BacklashUnit::Um,
        &Screen::default(),
    );
    let count = runs[0].summary().unproven;
    assert!(
        text.contains(&format!("\nUNPROVEN: {count} of 24 poses.")),
        "{text}"
    );
    // The formula, which agrees with it, has a column of its own.
    let rows = text.lines().filter(|line| line.contains("  unproven  "));
    let rows: Vec<Vec<&str>> = rows.map(|row| row.split_whitespace().collect()).collect();
    assert_eq!(rows.len(), count);
    for row in rows {
        let status = row.iter().position(|cell| *cell == "unproven").unwrap();
        assert_eq!(
            row[status - 2..status + 3],
            ["–", "–", "unproven", "–", "–"]
        );
    }
    let doubtful = doubtful(&runs, 3);
    let mut lines = text.lines().skip_while(|line| !line.ends_with("unproven"));
    let summary = lines.nth(1).unwrap();
    assert!(summary.ends_with(&format!(" {count}")), "{summary}");
    assert!(!summary.contains(&doubtful), "{summary}");
    assert_eq!(
        text.matches("the certificate failed").count(),
        count.min(10)
    );
    assert!(text.contains(&doubtful));
}

#[test]
fn a_comparison_fails_for_them_in_every_format() {
    let case = Case::low_tips();
    let sound = compared(&case, &case.compared(Method::Exact { certify: false }));
    let sound = sound.text(&Screen::default());
    assert!(sound.contains(" backlash agree within "), "{sound}");
    let runs = case.compared(CERTIFIED);
    let (count, doubtful) = (runs[0].summary().unproven, doubtful(&runs, 3));
    let outcome = compared(&case, &runs);
    assert!(!outcome.passes());
    let texts = [
        outcome.text(&Screen::default()),
        outcome.junit().unwrap(),
        outcome.github(),
        outcome.markdown(),
    ];
    for text in &texts {
        assert!(
            text.contains(&format!("{count} of 160 poses: unproven")),
            "{text}"
        );
        let bare = |line: &&str| line.contains(&doubtful) && !line.contains("not proven");
        assert_eq!(text.lines().find(bare), None);
    }
    assert!(
        texts[0].contains("error bound not proven.\n"),
        "{}",
        texts[0]
    );
    assert!(texts[1].contains("<failure"));
    assert!(texts[2].starts_with("::error"));
    assert!(texts[3].contains("❌ 1 fails, of 1: pair.toml"));
    let json: Value = serde_json::from_str(&outcome.json().unwrap()).unwrap();
    let run = &json["files"][0]["runs"][0];
    assert_eq!(
        (&run["passed"], &run["unproven"]),
        (&Value::Bool(false), &count.into())
    );
    assert_eq!(run["unproven_poses"].as_array().unwrap().len(), count);
    assert_eq!(run["compared"], 160 - count);
}

#[test]
fn an_outcome_counts_its_unproven_poses() {
    let case = Case::low_tips();
    let runs = case.compared(CERTIFIED);
    let whole = PoseOutcome::of(&[&runs[0]], &[]);
    assert_eq!(whole.unproven, runs[0].summary().unproven);
    assert_eq!(whole.unproven_ends, [whole.unproven; 2]);
    let agreement = Agreement::of(&[&runs[0]]);
    assert_eq!(agreement.unproven, whole.unproven);
    assert_eq!((agreement.jammed, agreement.neither), (0, 0));
    assert_eq!(
        agreement.poses,
        agreement.both + agreement.simulated_alone + whole.unproven
    );
}

#[test]
fn charts_have_a_gap_and_a_caption() {
    let case = Case::low_tips();
    let runs = case.compared(CERTIFIED);
    let count = runs[0].summary().unproven;
    let course = &courses(&runs)[0];
    let gaps = course.lines[0].points.iter();
    assert_eq!(
        gaps.filter(|point| point.simulated_um.is_none()).count(),
        count
    );
    let least = course.least.unwrap().backlash_um;
    assert_eq!(Some(least), runs[0].summary().min.map(|mm| mm * 1e3));
    let heading = Heading {
        prefix: "chart",
        title: "t",
        subtitle: "",
    };
    let drawn = [
        chart::revolution(&heading, course).unwrap(),
        chart::difference(&heading, course, 0.1).unwrap(),
    ];
    for chart in &drawn {
        let words = format!("{count} poses unproven, not drawn · ");
        assert!(chart.svg.contains(&words), "{}", chart.svg);
    }
    assert!(drawn[0].svg.contains("gaps: unproven"));
    // Texts only: coordinates can contain any digits.
    let document = Document::parse(&drawn[0].svg).unwrap();
    let mut texts = document.descendants().filter_map(|node| node.text());
    assert!(!texts.any(|text| text.contains(&doubtful(&runs, 1))));
}

#[test]
fn a_picture_draws_no_contact_and_says_why() {
    let case = Case::low_tips();
    let runs = case.compared(CERTIFIED);
    let run = &runs[0];
    let pose = run.unproven().next().unwrap();
    let svg = snapshot(&Snapshot {
        title: "t",
        assembly: &run.run.assembly,
        pose: &pose.simulated.pose,
        material: gearlash::analysis::study::Material::AsMeasured,
        found: pose.simulated.found.as_ref(),
        section: None,
    });
    assert!(
        svg.contains("unproven, no contact is drawn: the certificate failed"),
        "{svg}"
    );
    assert_eq!(svg.matches("not proven: none is drawn").count(), 2);
    for words in ["j_wt =", "flanks touch", "gap j_bn", "overlap"] {
        assert!(!svg.contains(words), "{words}");
    }
}

#[test]
fn a_report_vouches_for_nothing() {
    let case = Case::low_tips();
    let runs = case.compared(CERTIFIED);
    let doubtful = doubtful(&runs, 2);
    let diagnosis = diagnose(
        &case.study,
        &runs,
        &Default::default(),
        &mut |_| Ok(()),
        &|| std::ops::ControlFlow::Continue(()),
    )
    .unwrap();
    let analysis = Analysis {
        maps: Vec::new(),
        widths: Vec::new(),
        field: None,
        study: &case.study,
        method: CERTIFIED,
        runs: runs.clone(),
        revolution: runs.clone(),
        curves: runs.clone(),
        extremes: CycleExtremes::default(),
        failed_checks: Vec::new(),
        remedies: Default::default(),
        over_distance: Vec::new(),
        measured: Vec::new(),
        diagnosis,
    };
    let page = report(&Report {
        pair: &case.pair,
        file: "pair.toml",
        date: "2026-01-01",
        analysis: &analysis,
        grades: &[],
    })
    .unwrap();
    let document = scraper::Html::parse_document(&page);
    let text = |selector: &str| {
        let selector = scraper::Selector::parse(selector).unwrap();
        let element = document.select(&selector).next().unwrap();
        let words = element.text().collect::<String>();
        words.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let count = runs[0].summary().unproven;
    let answer = text("#result .verdict");
    let expected = format!("{count} of 160 poses are unproven");
    assert!(answer.contains(&expected), "{answer}");
    assert!(text("#result tbody").contains("unproven"));
    let selector = scraper::Selector::parse(".verdict.unproven").unwrap();
    assert_eq!(document.select(&selector).count(), 1);
    assert!(text("#trust").contains("Not without a check"));
    assert!(text("#models").contains(&format!("{count} are unproven: not compared")));
    assert!(text("#unproven").contains("the certificate failed"));
    assert!(text("#checks").contains("No check fails, but some are unproven"));
    for section in ["#result", "#trust", "#checks", "#models", "#poses"] {
        assert!(!text(section).contains(&doubtful), "{section}");
    }
    assert!(text("#viewer-data").contains("\"unproven\""));
}

/// Nothing but unproven poses: polygons whose tips do not reach the mate's involutes.
#[test]
fn charts_of_nothing_proven_are_drawn_empty() {
    let pair = |tip: f64| {
        format!(
            "[wheel]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\ntip_diameter_mm = {tip}\n\
             [pinion]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\ntip_diameter_mm = {tip}\n\
             [assembly]\ncenter_distance_mm = 43.5\n{REVOLUTION}"
        )
    };
    let case = Case::new(&pair(44.0), &pair(43.0));
    let runs = case.compared(Method::Both);
    assert_eq!(runs[0].summary().unproven, 160);
    assert_eq!(runs[0].extremes(), None);
    let course = &courses(&runs)[0];
    let heading = Heading {
        prefix: "chart",
        title: "t",
        subtitle: "",
    };
    for chart in [
        chart::revolution(&heading, course),
        chart::difference(&heading, course, 0.1),
    ] {
        let svg = chart.unwrap().svg;
        assert!(svg.contains("160 poses unproven, not drawn"), "{svg}");
    }
}
