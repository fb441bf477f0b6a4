//! The verdict's sentence says "proven" only of what is, and which end is not.

use gearlash::analysis::extremes::{RunExtremes, extremes};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::{Doubt, Method};
use gearlash_files::{PairFile, read_text};
use gearlash_results::verdict::sentence as sentence_of;
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

fn sentence(file: &PairFile, runs: &[RunExtremes]) -> String {
    sentence_of(&Verdict::of_study(&file.study, runs, Vec::new()))
}

fn small() -> (PairFile, Vec<RunExtremes>) {
    let pair = PAIR.replace("75.2", "75.2\nbearing_clearance_mm = 0.01");
    let file = study(&pair.replace(
        "[pinion]",
        "runout = { total_um = 20, high_tooth = 3 }\n[pinion]",
    ));
    let method = Method::Exact { certify: true };
    let found = extremes(&file.study, method, &|| ControlFlow::Continue(())).unwrap();
    (file, found.each)
}

/// "proven to 123443.57 µm: too many stretches …", and JSON said `proven: false`.
#[test]
fn a_search_that_stopped_is_no_proof_and_says_between_what_the_least_lies() {
    let (file, mut runs) = small();
    assert!(sentence(&file, &runs).contains("every rotation, proven."));
    let least = runs[0].least.as_mut().unwrap();
    (least.low, least.high, least.doubt) = (0.0797, 0.2032, Some(Doubt::Effort));
    let told = sentence(&file, &runs);
    let words = "Over all 60 matings and every rotation, the least is not proven: the search stopped, as too many stretches of the \
                 cycle come near to it; the least lies between 79.70 and 203.20 µm.";
    assert!(told.contains(words), "{told}");
    assert!(!told.contains("proven to"), "{told}");
    // Both ends, one reason once.
    let greatest = runs[0].greatest.as_mut().unwrap();
    (greatest.low, greatest.high, greatest.doubt) = (0.21, 0.22, Some(Doubt::Effort));
    let told = sentence(&file, &runs);
    for words in [
        "every rotation, least and greatest are not proven: the search stopped",
        "near to it; the least lies between 79.70 and 203.20 µm; the greatest lies between 210.00 and 220.00 µm.",
    ] {
        assert!(told.contains(words), "{words}: {told}");
    }
}

/// What is sampled alone has no bracket, and is not of every rotation.
#[test]
fn what_is_sampled_names_its_end_and_no_bracket() {
    let (file, mut runs) = small();
    let greatest = runs[0].greatest.as_mut().unwrap();
    (greatest.high, greatest.doubt) = (f64::INFINITY, Some(Doubt::OffInvolute));
    let told = sentence(&file, &runs);
    let words = "Over all 60 matings, the greatest is not proven: fillets or roots may be touched, so only sampled poses were \
                 looked at. With the bearing clearance";
    assert!(told.contains(words), "{told}");
    // Nor is either end of the bearing clearance told as proven where it is not.
    let bearings = runs[0].bearings.as_mut().unwrap();
    bearings.pressed.extreme.as_mut().unwrap().doubt = Some(Doubt::OffInvolute);
    let told = sentence(&file, &runs);
    assert!(
        told.contains("with them apart, the least is not proven: fillets"),
        "{told}"
    );
}
