//! Poses that nothing vouches for, in words: each with its reason, and its doubtful values named as such.

use super::table::where_it_is;
use gearlash::compare::ComparedPose;
use gearlash::mesh::Unproven;
use gearlash::tally::RunTally;
use gearlash_files::numbers::{distance, um_ascii};

/// Poses up to this many are told one by one (tuned: a screen).
const MOST_TOLD: usize = 10;

/// Why something is not proven, and the values that it leaves in doubt.
pub(super) fn doubt(unproven: &Unproven) -> String {
    let told = |name: &str, value: Option<f64>| {
        let um = um_ascii(value?, 3);
        Some(format!("{name} method, not proven: {um} µm"))
    };
    let values = [
        told("exact", unproven.exact),
        told("polygon", unproven.polygon),
    ];
    let parts = [Some(unproven.reason.clone())].into_iter().chain(values);
    parts.flatten().collect::<Vec<_>>().join("; ")
}

/// Everything about `pose` that is not proven, in words.
pub(super) fn doubts(pose: &ComparedPose) -> String {
    let swept = &pose.swept;
    let here = swept.found.as_ref().err().map(doubt);
    let ends = swept
        .with_clearance
        .iter()
        .flatten()
        .zip(["a − c", "a + c"]);
    let ends = ends.filter_map(|(end, name)| {
        let doubt = doubt(end.as_ref().err()?);
        Some(format!("at {name} of the bearing clearance: {doubt}"))
    });
    here.into_iter().chain(ends).collect::<Vec<_>>().join("; ")
}

/// How many poses of `runs` are not proven, and the first of them, each on a line; nothing where all are proven.
pub(super) fn note(runs: &[RunTally]) -> String {
    let poses: usize = runs.iter().map(|run| run.poses).sum();
    let count: usize = runs.iter().map(|run| run.unproven).sum();
    let of_run = |run| move |pose| (run, pose);
    let first = runs
        .iter()
        .flat_map(|run: &RunTally| run.first_unproven.iter().map(of_run(run)));
    if count == 0 {
        return String::new();
    }
    let mut text = format!(
        "\nUNPROVEN: {count} of {poses} poses. No number above takes them in, and nobody knows whether the pair \
         has backlash there.\n"
    );
    for (run, pose) in first.take(MOST_TOLD) {
        text += &format!(
            "  a = {} mm, {}, {}: {}\n",
            distance(run.assembly.center_distance()),
            run.material.name(),
            where_it_is(pose),
            doubts(pose)
        );
    }
    if count > MOST_TOLD {
        text += &format!(
            "  … and {} more: --format json has all\n",
            count - MOST_TOLD
        );
    }
    text
}
