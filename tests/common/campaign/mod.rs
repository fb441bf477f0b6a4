//! Random poses for both methods, each certified, drawn as the numbers of a pair file, so that any pose can be printed and run again. The draws go
//! far beyond practice: undercut teeth, tips turned down or raised, eccentric axes, tips deep in roots, and tips that barely reach.

#![allow(dead_code, unused_imports)] // each test binary uses its part

mod draw;
mod gear;
mod outcome;
pub mod random;
mod tally;

use draw::POSES_A_PAIR;
pub use draw::{Depth, Drawn, Pair, Teeth};
use gearlash::contact::CutPair;
use outcome::Outcome;
pub use outcome::{differ, turned, with_contact, without_turns};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;
pub use tally::Tally;

/// Poses of `seed` by both methods on all threads, at `depth` or mixed. Without the polygon method, certificate and proof alone judge spur poses.
pub fn run(
    kind: Teeth,
    depth: Option<Depth>,
    seed: u64,
    indices: Range<u64>,
    has_polygon_method: bool,
) -> Tally {
    let pairs = indices.start / POSES_A_PAIR..indices.end.div_ceil(POSES_A_PAIR);
    let each = pairs.into_par_iter().map(|number| {
        let pair = Pair::of(kind, seed, number);
        let [wheel, pinion] = pair.gears();
        let cut = CutPair::new(wheel, pinion, 1e-4 * wheel.gear().basic_data().module());
        let mut tally = Tally::default();
        let poses = number * POSES_A_PAIR..(number + 1) * POSES_A_PAIR;
        for index in poses.filter(|index| indices.contains(index)) {
            let drawn = pair.pose(index % POSES_A_PAIR, depth);
            let outcome = watched(seed, index, || {
                Outcome::new(&drawn, &cut, has_polygon_method)
            });
            tally.add(index, &drawn, outcome);
        }
        tally
    });
    each.reduce(Tally::default, Tally::and)
}

/// Runs a pose. The process ends if it takes longer than a minute, hundreds of times what any may take: an endless search would hide all other faults.
fn watched<T>(seed: u64, index: u64, pose: impl FnOnce() -> T) -> T {
    let (running, ended) = channel::<()>();
    std::thread::spawn(move || {
        let ended = ended.recv_timeout(Duration::from_secs(60));
        if ended == Err(RecvTimeoutError::Timeout) {
            eprintln!("pose {index} of seed {seed} runs on and on: given up, and all with it");
            std::process::exit(1);
        }
    });
    let found = pose();
    drop(running);
    found
}

/// The cases of which `of` complains, each with its complaints, on all threads.
pub fn complaints<T: Sync + Clone + Send>(
    cases: &[T],
    of: impl Fn(&T) -> Vec<String> + Sync,
) -> Vec<(T, Vec<String>)> {
    let each = cases.par_iter().map(|case| (case.clone(), of(case)));
    each.filter(|(_, against)| !against.is_empty()).collect()
}
