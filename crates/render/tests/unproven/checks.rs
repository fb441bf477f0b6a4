//! Checks whose poses are not proven are not proven, and no other.

use super::{CERTIFIED, Case};
use gearlash::analysis::diagnosis::{Check, Diagnosis, Verdict, diagnose};
use gearlash::analysis::verdict::Verdict as CycleVerdict;
use gearlash::contact::{Method, PoseClass};
use gearlash_results::text::{Screen, check};
use gearlash_results::{RemedyRecords, checked};

/// The checks that are measured over the poses.
const OF_POSES: [&str; 6] = [
    "backlash_condition",
    "non_involute_form",
    "non_involute_k8",
    "non_involute_onset",
    "off_line_contact",
    "zero_backlash_distance",
];

fn diagnosed(case: &Case, method: Method) -> Diagnosis {
    diagnose(
        &case.study,
        &case.compared(method),
        &Default::default(),
        &mut |_| Ok(()),
        &|| std::ops::ControlFlow::Continue(()),
    )
    .unwrap()
}

#[test]
fn what_is_measured_over_an_unproven_pose_is_unproven() {
    let case = Case::low_tips();
    let certified = diagnosed(&case, CERTIFIED);
    let believed = diagnosed(&case, Method::Exact { certify: false });
    let of = |diagnosis: &Diagnosis| -> Vec<Check> { diagnosis.groups[0].checks.clone() };
    for (check, believed) in of(&certified).iter().zip(of(&believed)) {
        if !OF_POSES.contains(&check.id) {
            assert_eq!(check, &believed);
            continue;
        }
        let reason = check.unproven.as_deref().unwrap();
        assert!(reason.contains("of 160 poses are unproven"), "{reason}");
        assert!(reason.contains("the certificate failed"), "{reason}");
        assert_eq!(check.formula, believed.formula);
        assert_eq!((check.outlines, check.margin), (None, None), "{}", check.id);
        assert_eq!(check.verdict, Verdict::Unproven, "{}", check.id);
        assert!(check.details.is_empty());
    }
    assert_eq!(certified.verdict(), Verdict::Unproven);
    assert!(certified.groups[0].zero.is_err() && certified.groups[0].onset.is_err());
    assert!(believed.verdict() < Verdict::Unproven);
    let unproven = certified.contact.classes[&PoseClass::Unproven];
    assert!(unproven > 0 && certified.contact.poses() == 160);
}

#[test]
fn its_text_and_json_say_so() {
    let case = Case::low_tips();
    let found = diagnosed(&case, CERTIFIED);
    let text = check::text(
        &case.pair,
        &CycleVerdict::new(&[], &Vec::new(), None, found.failed()),
        &found,
        &RemedyRecords::default(),
        &Screen::default(),
    );
    assert!(text.contains("\nUNPROVEN: "), "{text}");
    assert!(text.contains(" checks are unproven: "), "{text}");
    let backlash = text
        .lines()
        .find(|line| line.contains("within the pitch"))
        .unwrap();
    assert!(backlash.trim_start().starts_with("unproven"), "{backlash}");
    assert_eq!(backlash.matches("unproven").count(), 2);
    let verdict = CycleVerdict::new(&[], &Vec::new(), None, found.failed());
    let screen = Screen::default();
    let judged = checked(
        "pair.toml",
        &case.pair,
        &found,
        &verdict,
        &RemedyRecords::default(),
        true,
        &screen,
    );
    let json = judged.json;
    assert_eq!(json["checks_verdict"], "unproven");
    for check in json["checks"].as_array().unwrap() {
        let id = check["id"].as_str().unwrap();
        let unproven = OF_POSES.contains(&id);
        assert_eq!(check["verdict"] == "unproven", unproven, "{id}");
        assert_eq!(check["unproven"].is_string(), unproven, "{id}");
        assert!(!unproven || check["outlines"].is_null(), "{id}");
    }
}
