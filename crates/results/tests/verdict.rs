//! The verdict in lines: what is proven and what is not, and that every pair keeps to six lines of 80 columns.

use gearlash::analysis::diagnosis::CheckName;
use gearlash::analysis::extremes::{RunExtremes, extremes};
use gearlash::analysis::requirement::{Limits, Quantity};
use gearlash::analysis::uncertainty::Uncertainty;
use gearlash::analysis::verdict::{Requirement, Verdict};
use gearlash::contact::{Doubt, Method};
use gearlash::pair::Member;
use gearlash_files::{PairFile, read_text};
use gearlash_results::verdict::{COLUMNS, LINES, lines};
use std::ops::ControlFlow;
use std::path::Path;

const PAIR: &str = r#"
title = "A pair"
[wheel]
teeth = 20
module_mm = 3.0
pressure_angle_deg = 20.0
[pinion]
teeth = 30
module_mm = 3.0
pressure_angle_deg = 20.0
[assembly]
center_distance_mm = 75.2
"#;

fn study(text: &str) -> PairFile {
    read_text(Path::new("pair.toml"), text).unwrap()
}

fn told(file: &PairFile, runs: &[RunExtremes]) -> String {
    lines(&Verdict::of_study(&file.study, runs, Vec::new())).to_string()
}

fn found(file: &PairFile) -> Vec<RunExtremes> {
    let method = Method::Exact { certify: true };
    let on = || ControlFlow::Continue(());
    extremes(&file.study, method, &on).unwrap().each
}

fn small() -> (PairFile, Vec<RunExtremes>) {
    let pair = PAIR.replace("75.2", "75.2\nbearing_clearance_mm = 0.01");
    let file = study(&pair.replace(
        "[pinion]",
        "runout = { total_um = 20, high_tooth = 3 }\n[pinion]",
    ));
    let runs = found(&file);
    (file, runs)
}

/// "proven to 123443.57 µm: too many stretches …", and JSON said `proven: false`.
#[test]
fn a_search_that_stopped_is_no_proof_and_says_between_what_the_least_lies() {
    let (file, mut runs) = small();
    let first = "Assembles at a = 75.200 mm. Proven for 60 matings";
    assert!(
        told(&file, &runs).starts_with(first),
        "{}",
        told(&file, &runs)
    );
    for run in &mut runs {
        let least = run.least.as_mut().unwrap();
        (least.low, least.high, least.doubt) = (0.0797, 0.2032, Some(Doubt::Effort));
    }
    let text = told(&file, &runs);
    for words in [
        "Assembles at a = 75.200 mm. Least not proven.\n",
        "\n  Least 79.70 … 203.20 µm: search budget used up\n",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    // Both ends have one reason, which is printed once.
    for run in &mut runs {
        let greatest = run.greatest.as_mut().unwrap();
        (greatest.low, greatest.high, greatest.doubt) = (0.21, 0.22, Some(Doubt::Effort));
    }
    let text = told(&file, &runs);
    for words in [
        ". Least and greatest not proven.\n",
        "\n  Least 79.70 … 203.20 µm, greatest 210.00 … 220.00 µm: search budget used up\n",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
}

/// An extreme that nothing bounds shows no bracket.
#[test]
fn an_extreme_without_a_bound_shows_no_bracket() {
    let (file, mut runs) = small();
    for run in &mut runs {
        let greatest = run.greatest.as_mut().unwrap();
        (greatest.high, greatest.doubt) = (f64::INFINITY, Some(Doubt::OffInvolute));
    }
    let text = told(&file, &runs);
    for words in [
        ". Greatest not proven.\n",
        "\n  Greatest: bounded by poses alone, as fillets or roots may touch\n",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(
        !text.contains("(bearing clearance): ") || !text.contains(" µm, not proven"),
        "{text}"
    );
    // Nor is either end of the bearing clearance told as proven where it is not.
    let bearings = runs[0].bearings.as_mut().unwrap();
    let pressed = bearings.pressed.extreme.as_mut().unwrap();
    (pressed.low, pressed.doubt) = (f64::NEG_INFINITY, Some(Doubt::OffInvolute));
    let text = told(&file, &runs);
    assert!(text.contains(" µm, not proven"), "{text}");
}

/// A limit is met where the whole bracket keeps it, not met where the whole bracket misses it, and else not proven.
#[test]
fn a_limit_inside_a_bracket_is_not_proven() {
    let file = study(PAIR);
    let mut runs = found(&file);
    for run in &mut runs {
        let least = run.least.as_mut().unwrap();
        (least.low, least.high, least.doubt) = (0.08, 0.12, Some(Doubt::Effort));
    }
    let verdict = |min: f64| {
        let limits = Limits {
            min: Some(min),
            max: None,
        };
        let required = vec![(Quantity::OperatingBacklash, limits)];
        Verdict::new(&runs, &required, None, Vec::new())
    };
    for (min, expected) in [
        (0.07, Requirement::Met),
        (0.08, Requirement::Met),
        (0.1, Requirement::NotProven),
        (0.12, Requirement::NotProven),
        (0.13, Requirement::NotMet),
    ] {
        assert_eq!(verdict(min).requirement, expected, "{min}");
    }
    let text = lines(&verdict(0.1)).to_string();
    let words = "Requirement not proven: j_wt ≥ 100.00 µm, found 80.00 … 120.00";
    assert!(text.contains(words), "{text}");
    let text = lines(&verdict(0.13)).to_string();
    assert!(
        text.contains("Requirement not met: j_wt ≥ 130.00 µm, found 80.00"),
        "{text}"
    );
}

/// All that can be said at once, of gears with four-digit teeth: the lines stay short, and what finds no room is counted.
#[test]
fn the_most_that_can_be_said_fits() {
    let text = PAIR
        .replace(
            "teeth = 20",
            "teeth = 1999\nrunout = { total_um = 20, high_tooth = 1003 }",
        )
        .replace(
            "teeth = 30",
            "teeth = 1000\nrunout = { total_um = 20, high_tooth = 107 }",
        )
        .replace(
            "75.2",
            "[4498.5123456, 4498.7123456]\nbearing_clearance_mm = 0.01",
        );
    let file = study(&text);
    let mut runs = found(&file);
    runs[0].least.as_mut().unwrap().doubt = Some(Doubt::Profile);
    let limits = Limits {
        min: Some(1.0),
        max: Some(0.1),
    };
    let required = vec![
        (Quantity::LostMotion(Member::Pinion), limits),
        (Quantity::OperatingBacklash, limits),
        (Quantity::RadialClearance, limits),
    ];
    let uncertainty = Uncertainty {
        center_distance: 0.01,
        coverage: 2.0,
        ..Uncertainty::default()
    };
    let check = |id, title| CheckName { id, title };
    let failed = vec![
        check("radial_clearance", "radial clearance of tip, K (9), (10)"),
        check("contact_ratio", "contact ratio; between real form circles"),
        check("undercut", "involute begins outside base circle"),
        check(
            "off_line_contact",
            "poses that touch off the line of action",
        ),
    ];
    let lines = lines(&Verdict::new(&runs, &required, Some(uncertainty), failed));
    let text = lines.to_string();
    assert_eq!(lines.lines().len(), LINES, "{text}");
    for line in lines.lines() {
        assert!(line.chars().count() <= COLUMNS, "{line}");
    }
    let left_out = lines.left_out.len();
    assert!(
        left_out > 0 && text.ends_with(&format!(", and {left_out} more")),
        "{text}"
    );
    let last = lines.left_out.last().unwrap();
    assert_eq!(last, "± is the expanded uncertainty, k = 2");
    assert!(text.contains("Requirement not met: "), "{text}");
    assert!(!text.contains("contact_ratio"), "{text}");
}
