//! Random poses for both methods, from a seed: the campaign of exact against polygon, each exact result certified.
//!
//! A pair is drawn as the numbers of a pair file, so that any pose can be printed and run again. The draws go far beyond practice and favour
//! difficult cases: undercut teeth, tips turned down or raised, eccentric axes, tips deep in roots, and tips that barely reach.

#![allow(dead_code, unused_imports)] // each test binary uses its part

mod draw;
mod gear;
mod outcome;
pub mod random;
mod tally;
mod watch;

use draw::POSES_A_PAIR;
pub use draw::{Depth, Drawn, Pair, Teeth};
use gearlash::contact::CutPair;
use outcome::Outcome;
pub use outcome::{differ, turned, with_contact, without_turns};
use rayon::prelude::*;
use std::ops::Range;
pub use tally::Tally;
use watch::Watch;

/// Poses of `seed` by both methods on all threads, at `depth` or mixed. Without the polygon method, certificate and proof alone judge spur poses.
pub fn run(
    kind: Teeth,
    depth: Option<Depth>,
    seed: u64,
    indices: Range<u64>,
    has_polygon_method: bool,
) -> Tally {
    let watch = Watch::new(seed);
    let pairs = indices.start / POSES_A_PAIR..indices.end.div_ceil(POSES_A_PAIR);
    let each = pairs.into_par_iter().map(|number| {
        let pair = Pair::of(kind, seed, number);
        let [wheel, pinion] = pair.gears();
        let cut = CutPair::new(wheel, pinion, 1e-4 * wheel.gear().basic_data().module());
        let mut tally = Tally::default();
        let poses = number * POSES_A_PAIR..(number + 1) * POSES_A_PAIR;
        for index in poses.filter(|index| indices.contains(index)) {
            let drawn = pair.pose(index % POSES_A_PAIR, depth);
            let outcome = watch.run(index, || Outcome::new(&drawn, &cut, has_polygon_method));
            tally.add(index, &drawn, outcome);
        }
        tally
    });
    each.reduce(Tally::default, Tally::and)
}

/// The cases of which `of` complains, each with its complaints, on all threads.
pub fn complaints<T: Sync + Clone + Send>(
    cases: &[T],
    of: impl Fn(&T) -> Vec<String> + Sync,
) -> Vec<(T, Vec<String>)> {
    let each = cases.par_iter().map(|case| (case.clone(), of(case)));
    each.filter(|(_, against)| !against.is_empty()).collect()
}
