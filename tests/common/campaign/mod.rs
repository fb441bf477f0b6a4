//! Random poses for both methods, from a seed: the campaign of exact against polygon, each exact result certified.
//!
//! `tests/tools/campaign.rs` and tests use it. A pair is drawn as the numbers of a pair file (`gear`, `draw`), so that any pose can be
//! printed and run again (`pair_file`). The draws go far beyond practice and favour difficult cases. Examples are undercut teeth, tips
//! turned down or raised, hand-over on tip corners, eccentric axes, tips deep in roots, and tips that barely reach.

#![allow(dead_code, unused_imports)] // each test binary uses its part

mod draw;
mod gear;
mod outcome;
mod pair_file;
pub mod random;
mod tally;
mod watch;

use draw::POSES_A_PAIR;
pub use draw::{Depth, Drawn, Pair, Teeth};
use gearlash::contact::CutPair;
use outcome::Outcome;
use rayon::prelude::*;
use std::ops::Range;
use std::time::Duration;
pub use tally::Tally;
pub use watch::LONGEST;
use watch::Watch;

/// Poses of `seed` by both methods on all threads, at `depth` or mixed.
pub fn run(kind: Teeth, depth: Option<Depth>, seed: u64, indices: Range<u64>) -> Tally {
    run_within(LONGEST, kind, depth, seed, indices, true)
}

/// [`run`]; without the polygon method, certificate and proof alone judge spur poses.
///
/// The process ends if a pose takes longer than `longest`: an endless search is a fault that would hide all others.
pub fn run_within(
    longest: Duration,
    kind: Teeth,
    depth: Option<Depth>,
    seed: u64,
    indices: Range<u64>,
    has_polygon_method: bool,
) -> Tally {
    let Range { start: first, end } = indices;
    let watch = Watch::new(seed, longest);
    let pairs = first / POSES_A_PAIR..end.div_ceil(POSES_A_PAIR);
    let mut tally = pairs
        .into_par_iter()
        .map(|number| {
            let pair = Pair::of(kind, seed, number);
            let [wheel, pinion] = pair.gears();
            let cut = CutPair::new(wheel, pinion, 1e-4 * wheel.gear().basic_data().module());
            let mut tally = Tally {
                redrawn: pair.redrawn,
                ..Tally::default()
            };
            let poses = number * POSES_A_PAIR..(number + 1) * POSES_A_PAIR;
            for index in poses.filter(|index| (first..end).contains(index)) {
                let drawn = pair.pose(index % POSES_A_PAIR, depth);
                let outcome = watch.run(index, || Outcome::new(&drawn, &cut, has_polygon_method));
                tally.add(index, &drawn, outcome);
            }
            tally
        })
        .reduce(Tally::default, Tally::and);
    tally.shorten();
    tally
}
