//! Reliability of the numbers: the compared values, and the others.

use crate::command::{fixture, page};
use crate::page::plain;
use crate::words::{select, text};
use scraper::Html;

fn trust(page: &str) -> String {
    text(&select(&Html::parse_document(page), "#trust")[0])
}

/// d_a = 44, d_f = 35: a tip sits in a root below a = 39.5; tips pass each other above 44.
#[test]
fn what_has_no_value_is_not_said_to_agree() {
    for (a, what) in [("39.0", "jammed"), ("44.5", "out of mesh")] {
        let trust = trust(&page(&plain(a)));
        assert!(trust.contains("No backlash exists"), "{trust}");
        assert!(
            trust.contains(&format!("nothing was compared. Every pose is {what}.")),
            "{trust}"
        );
        for wrong in ["Yes", "agree", "Only involutes"] {
            assert!(!trust.contains(wrong), "{wrong}: {trust}");
        }
    }
}

/// Each centre distance has 640 poses of whole revolutions and 2 of the file. The mesh cycle adds the least and the greatest. A
/// cycle without them adds the one pose that has none; a jammed one, what binds where the pair begins to assemble.
#[test]
fn only_poses_with_both_values_are_counted() {
    for (a, others, what) in [
        ("[40.2, 44.5]", 643, "out of mesh"),
        ("[39.0, 40.2]", 644, "jammed"),
    ] {
        let page = page(&plain(a));
        let trust = trust(&page);
        assert!(
            trust.contains("simulation and formula agree at all 644 poses that have a backlash."),
            "{trust}"
        );
        assert!(
            trust.contains("at 644 of the 644 poses where both give a value"),
            "{trust}"
        );
        assert!(
            trust.contains(&format!("The other {others} poses are {what}.")),
            "{trust}"
        );
        assert!(
            trust.contains("Where there is backlash, only involutes touch."),
            "{trust}"
        );
    }
}

/// Issue 4: the tips lose up to 22.522 µm on the fillets at 24 phases, a little more between them, which no formula sees.
#[test]
fn a_formula_that_is_wrong_about_the_pair_is_called_so() {
    let page = fixture("tip_on_fillet_86x21.toml");
    let trust = trust(&page);
    let start = "Can the numbers be trusted? Yes, the simulation, for the gears as measured. The line-of-action formula does not apply at ";
    assert!(trust.starts_with(start), "{trust}");
    assert!(
        trust.contains("the largest difference is −22.53"),
        "{trust}"
    );
    // The page distinguishes poses at which the formula is wrong from those that merely touch off the line.
    let number = |after: &str| -> usize {
        let (_, rest) = trust.split_once(after).unwrap();
        rest.split_whitespace().next().unwrap().parse().unwrap()
    };
    let (wrong, slight) = (
        number(start),
        if trust.contains("of them that costs") {
            number("or a root touches; at ")
        } else {
            0
        },
    );
    let (before, _) = trust.split_once(" poses a tip corner").unwrap();
    let touch: usize = before
        .split_whitespace()
        .next_back()
        .unwrap()
        .parse()
        .unwrap();
    assert_eq!(touch, wrong + slight);
    assert!(wrong > 0);
}

/// Ten teeth on ten, undercut: edges of the involutes touch, which the formula knows nothing of. The page said that no reason was found, and
/// that the pair assembles, of which its verdict said that it is not proven.
#[test]
fn an_undercut_edge_is_a_reason_and_a_wide_bracket_is_no_proof() {
    let gear = |name: &str| {
        format!(
            "[{name}]\nteeth = 10\nmodule_mm = 2\npressure_angle_deg = 20\nthickness.allowance_um = -40\n\
             runout = {{ total_um = 22, high_tooth = 3 }}\n"
        )
    };
    let steps = "[0, 20, 0, 20, 0, 20, 0, 20, 0, 20]";
    let pitch =
        format!("[wheel.pitch]\nkind = \"cumulative\"\nright_um = {steps}\nleft_um = {steps}\n");
    let rest = "[assembly]\ncenter_distance_mm = 20.15\n";
    let page = page(&(gear("wheel") + &pitch + &gear("pinion") + rest));
    let trust = trust(&page);
    assert!(!trust.contains("no reason was found"), "{trust}");
    assert!(
        trust.contains("Yes, the simulation, for the gears as measured."),
        "{trust}"
    );
    assert!(
        trust.contains("a tip corner, an undercut edge, a fillet or a root"),
        "{trust}"
    );
    let document = Html::parse_document(&page);
    let result = text(&select(&document, "#result")[0]);
    assert!(result.contains("Least not proven"), "{result}");
    assert!(
        result.contains(": bounded by poses alone, as fillets or roots may"),
        "{result}"
    );
}
