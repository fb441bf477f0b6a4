//! Poses that nothing vouches for, in words: each with its reason, and its doubtful values named as such.

use super::layout::where_it_is;
use gearlash::tally::RunTally;
use gearlash_files::numbers::distance;
use gearlash_files::results::doubts;

/// Poses up to this many are told one by one (tuned: a screen).
const MOST_TOLD: usize = 10;

/// How many poses of `runs` are not proven, and the first of them, each on a line; nothing where all are proven.
pub fn note(runs: &[RunTally]) -> String {
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
