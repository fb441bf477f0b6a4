//! The verdict in lines: what is proven and what is not, and that every pair keeps to six lines of 80 columns.

use gearlash::analysis::diagnosis::CheckName;
use gearlash::analysis::extremes::{RunExtreme, RunExtremes, extremes};
use gearlash::analysis::requirement::{Limits, Quantity};
use gearlash::analysis::uncertainty::Uncertainty;
use gearlash::analysis::verdict::{RequirementOutcome, Verdict};
use gearlash::contact::{Doubt, Method};
use gearlash::error::go_on;
use gearlash::pair::Member;
use gearlash_input::{PairFile, read_text};
use gearlash_results::verdict::{MAX_COLUMNS, MAX_LINES, lines};
use std::path::Path;

const PAIR: &str = include_str!("pair.toml");

fn study(text: &str) -> PairFile {
    read_text(Path::new("pair.toml"), text).unwrap()
}

fn found(file: &PairFile) -> Vec<RunExtremes> {
    let method = Method::Exact { certify: true };
    extremes(&file.study, method, &go_on).unwrap().each
}

/// The bracket of an extreme, mm, as a search that ended early leaves it.
fn doubt(extreme: &mut Option<RunExtreme>, [low, high]: [f64; 2], doubt: Doubt) {
    let extreme = extreme.as_mut().unwrap();
    (extreme.low, extreme.high, extreme.doubt) = (low, high, Some(doubt));
}

/// "proven to 123443.57 µm: too many stretches …", and JSON said `proven: false`. An extreme that nothing bounds shows no bracket.
#[test]
fn a_search_that_stopped_is_no_proof_and_says_between_what_the_extremes_lie() {
    let pair = PAIR.replace("75.2", "75.2\nbearing_clearance_mm = 0.01");
    let runout = "runout = { total_um = 20, high_tooth = 3 }\n[pinion]";
    let file = study(&pair.replace("[pinion]", runout));
    let proven = found(&file);
    let check = |runs: &[RunExtremes], expected: &[&str]| {
        let text = lines(&Verdict::of_study(&file.study, runs, Vec::new())).to_string();
        for words in expected {
            assert!(text.contains(words), "{words}: {text}");
        }
        text
    };
    let first = "Assembles at a = 75.200 mm. Proven for 60 matings";
    assert!(check(&proven, &[]).starts_with(first));
    let mut runs = proven.clone();
    doubt(&mut runs[0].least, [0.0797, 0.2032], Doubt::Effort);
    let least = [
        "Assembles at a = 75.200 mm. Least not proven.\n",
        "\n  Least (79.70 … 203.20 µm) not proven: search budget used up\n",
    ];
    check(&runs, &least);
    // Both ends have one reason, which is printed once.
    doubt(&mut runs[0].greatest, [0.21, 0.22], Doubt::Effort);
    let both = [
        ". Least and greatest not proven.\n",
        "\n  Least 79.70 … 203.20 µm, greatest 210.00 … 220.00 µm: search budget used up\n",
    ];
    check(&runs, &both);
    let mut runs = proven;
    let low = runs[0].greatest.as_ref().unwrap().low;
    doubt(
        &mut runs[0].greatest,
        [low, f64::INFINITY],
        Doubt::OffInvolute,
    );
    let greatest = [
        ". Greatest not proven.\n",
        "\n  Greatest not proven: bounded by poses alone, as fillets or roots may touch\n",
    ];
    let text = check(&runs, &greatest);
    let of_bearings = text.contains("(bearing clearance): ");
    assert!(!of_bearings || !text.contains(" µm, not proven"), "{text}");
    // Nor is either end of the bearing clearance told as proven where it is not.
    let pressed = &mut runs[0].bearings.as_mut().unwrap().pressed.extreme;
    let high = pressed.as_ref().unwrap().high;
    doubt(pressed, [f64::NEG_INFINITY, high], Doubt::OffInvolute);
    let reason = "With bearing clearance: bounded by poses";
    check(&runs, &[" µm, not proven", reason]);
}

/// A limit is met where the whole bracket keeps it, not met where the whole bracket misses it, and else not proven.
#[test]
fn a_limit_inside_a_bracket_is_not_proven() {
    let file = study(PAIR);
    let mut runs = found(&file);
    doubt(&mut runs[0].least, [0.08, 0.12], Doubt::Effort);
    let not_proven = "Requirement not proven: j_wt ≥ 100.00 µm, found 80.00 … 120.00";
    let not_met = "Requirement not met: j_wt ≥ 130.00 µm, found 120.00";
    for (min, expected, words) in [
        (0.07, RequirementOutcome::Met, ""),
        (0.08, RequirementOutcome::Met, ""),
        (0.1, RequirementOutcome::NotProven, not_proven),
        (0.12, RequirementOutcome::NotProven, ""),
        (0.13, RequirementOutcome::NotMet, not_met),
    ] {
        let limits = Limits {
            min: Some(min),
            max: None,
        };
        let required = vec![(Quantity::OperatingBacklash, limits)];
        let verdict = Verdict::new(&runs, &required, None, Vec::new());
        assert_eq!(verdict.requirement, expected, "{min}");
        let text = lines(&verdict).to_string();
        assert!(text.contains(words), "{text}");
    }
}

/// All that can be said at once, of gears with four-digit teeth: the lines stay short, and what finds no room is counted.
#[test]
fn the_most_that_can_be_said_fits() {
    let distances = "[4498.5123456, 4498.7123456]\nbearing_clearance_mm = 0.01";
    let runout = |teeth: u32, high: u32| {
        format!("teeth = {teeth}\nrunout = {{ total_um = 20, high_tooth = {high} }}")
    };
    let text = PAIR.replace("teeth = 20", &runout(1999, 1003));
    let text = text.replace("teeth = 30", &runout(1000, 107));
    let text = text.replace("75.2", distances);
    let file = study(&text);
    let mut runs = found(&file);
    runs[0].least.as_mut().unwrap().doubt = Some(Doubt::Profile);
    let limits = Limits {
        min: Some(1.0),
        max: Some(0.1),
    };
    let required = [
        Quantity::LostMotion(Member::Pinion),
        Quantity::OperatingBacklash,
        Quantity::RadialClearance,
    ];
    let required = required.map(|quantity| (quantity, limits)).to_vec();
    let uncertainty = Uncertainty {
        center_distance: 0.01,
        coverage: 2.0,
        ..Uncertainty::default()
    };
    let failed = [
        ("radial_clearance", "radial clearance of tip, K (9), (10)"),
        ("contact_ratio", "contact ratio; between real form circles"),
        ("undercut", "involute begins outside base circle"),
        (
            "off_line_contact",
            "poses that touch off the line of action",
        ),
    ];
    let failed = failed.map(|(id, title)| CheckName { id, title }).to_vec();
    let lines = lines(&Verdict::new(&runs, &required, Some(uncertainty), failed));
    let text = lines.to_string();
    assert_eq!(lines.lines().len(), MAX_LINES, "{text}");
    for line in lines.lines() {
        assert!(line.chars().count() <= MAX_COLUMNS, "{line}");
    }
    let left_out = lines.left_out.len();
    let more = format!("; {left_out} more notes");
    assert!(left_out > 1 && text.ends_with(&more), "{text}");
    let last = lines.left_out.last().unwrap();
    assert_eq!(last, "± is the expanded uncertainty, k = 2");
    assert!(text.contains("Requirement not met: "), "{text}");
    assert!(!text.contains("contact_ratio"), "{text}");
}
