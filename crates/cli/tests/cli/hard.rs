//! The pairs of `fixtures/reference/hard` by every method through the built binary: the status of each pose, and the exit code.

use super::{fixture, run};
use serde_json::Value;
use std::collections::BTreeMap;

/// The number of poses by status.
type Ends = &'static [(&'static str, u64)];

const CLEAR: Ends = &[("clear", 2)];
const CLEAR_AND_JAMMED: Ends = &[("clear", 1), ("jammed", 1)];
const TIGHT_AND_JAMMED: Ends = &[("interference", 1), ("jammed", 1)];

/// The statuses of each pair, as proven in `tests/contact/hard_pairs.rs`.
const PAIRS: [(&str, Ends); 13] = [
    ("far_land_5_30", TIGHT_AND_JAMMED),
    ("fine_fillet_3_387", TIGHT_AND_JAMMED),
    ("jammed_hangs_15_16", CLEAR_AND_JAMMED),
    ("jammed_hangs_25_36", TIGHT_AND_JAMMED),
    ("over_the_axis_14_3", &[("jammed", 2)]),
    ("root_gap_20_20", &[("clear", 4), ("jammed", 4)]),
    ("root_hole_20_20", CLEAR_AND_JAMMED),
    ("stub_bad_13_1", &[("interference", 75), ("jammed", 25)]),
    ("stub_bad_4_7", &[("clear", 20)]),
    ("stub_c1", CLEAR),
    ("stub_n10", &[("interference", 2)]),
    ("thin_land_3_7", &[("clear", 1), ("interference", 1)]),
    ("tip_corner_missed_9_7", CLEAR),
];

/// Pairs whose verdict over the whole mesh cycle takes more than a second by each method: their poses are in
/// `tests/contact/hard_pairs.rs` alone.
const SLOW: [&str; 7] = [
    "far_land_5_14",
    "grazing_bound_a",
    "grazing_bound_b",
    "stub_bad_13_2",
    "stub_n1",
    "stub_n29",
    "tip_corner_missed_84_16",
];

fn ends_by(name: &str, method: &str) -> (Option<i32>, BTreeMap<String, u64>, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = fixture("reference/hard").join(format!("{name}.toml"));
    let file = file.to_str().unwrap();
    let args = ["simulate", file, "--method", method, "--format", "json"];
    let (code, json, message) = run(folder.path(), &args);
    let json: Value = serde_json::from_str(&json).expect(&message);
    let mut ends = BTreeMap::new();
    for run in json["runs"].as_array().unwrap() {
        for pose in run["poses"].as_array().unwrap() {
            let status = pose["status"].as_str().unwrap().to_owned();
            *ends.entry(status).or_insert(0) += 1;
        }
    }
    (code, ends, message)
}

#[test]
fn every_hard_pair_ends_alike_by_every_method() {
    let one = |(name, want): &(&str, Ends)| {
        let want: BTreeMap<String, u64> = want
            .iter()
            .map(|(status, poses)| ((*status).to_owned(), *poses))
            .collect();
        for method in ["exact", "polygon", "both"] {
            let (code, ends, message) = ends_by(name, method);
            assert_eq!(code, Some(0), "{name} by {method}: {message}");
            assert_eq!(ends, want, "{name} by {method}");
            let agree = message.contains("exact and polygon method agree: largest difference ");
            assert_eq!(agree, method == "both", "{name} by {method}: {message}");
        }
    };
    std::thread::scope(|scope| {
        for pairs in PAIRS.chunks(PAIRS.len().div_ceil(2)) {
            scope.spawn(move || pairs.iter().for_each(one));
        }
    });
}

#[test]
fn no_hard_pair_is_forgotten() {
    let mut known: Vec<&str> = PAIRS.iter().map(|(name, _)| *name).collect();
    known.extend(SLOW);
    known.sort_unstable();
    let mut there: Vec<String> = std::fs::read_dir(fixture("reference/hard"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter_map(|name| Some(name.strip_suffix(".toml")?.to_owned()))
        .collect();
    there.sort_unstable();
    assert_eq!(there, known);
}
