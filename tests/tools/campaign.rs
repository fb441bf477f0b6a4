//! The campaign: exact against polygon method on seeded random poses, each exact result certified. Options: `--help`.
//!
//! Whole gears are a further referee: just inside both contacts of a clear pose no metal may be in the other gear. The program exits with 1 if
//! the methods differ by more than both error bounds or in status, or if the certificate refuses. It does so, too, if a class of contact did not
//! occur, or if the prover leaves an ordinary pose to the polygons. Abandoned poses are counted and named. The first faulty poses are printed as pair files.

#[path = "../common/along_face.rs"]
mod along_face;
#[path = "../common/campaign/mod.rs"]
mod campaign;
#[path = "../common/clearance/mod.rs"]
mod clearance;
#[path = "../common/kit.rs"]
mod kit;

use campaign::{Depth, Drawn, Teeth, complaints, run};
use clap::Parser;
use gearlash::contact::{ExactKernel, LostMotion};
use gearlash::pair::{GearPair, Pose};
use std::process::ExitCode;

/// Exact against polygon method on random poses
#[derive(Parser)]
struct Options {
    /// Number of poses, four of each pair
    #[arg(long, default_value_t = 10_000)]
    poses: u64,
    /// Seed of the random numbers
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Index of the first pose
    #[arg(long, default_value_t = 0)]
    first: u64,
    /// Helical pairs, over their whole face, in place of spur ones
    #[arg(long, conflicts_with = "brute")]
    helical: bool,
    /// Only poses of this depth, instead of all mixed
    #[arg(long)]
    depth: Option<Depth>,
    /// Only the prover beside the certificate, without polygon method and whole gears: a million poses take minutes
    #[arg(long, conflicts_with_all = ["helical", "brute"])]
    proofs: bool,
    /// Ask brute force about the exact method, instead of the polygon method and the certificate: some 0.4 s a pose
    #[arg(long)]
    brute: bool,
    /// Pairs that deviate along the face, one pose each, against this many sections with zoom at the tightest
    #[arg(long, conflicts_with_all = ["helical", "brute", "proofs"])]
    along_face: Option<u32>,
    /// With profile deviations, and parallel axes
    #[arg(long, requires = "along_face")]
    profiles: bool,
    /// Print this pose of the campaign as a pair file, and nothing else
    #[arg(long)]
    print: Option<u64>,
}

/// Poses printed in full.
const SHOWN: usize = 3;

/// Poses named with their reasons.
const NAMED: usize = 40;

fn main() -> ExitCode {
    let options = Options::parse();
    let (depth, seed) = (options.depth, options.seed);
    let kind = match options.helical {
        true => Teeth::Helical,
        false => Teeth::Spur,
    };
    if let Some(index) = options.print {
        print!("{}", Drawn::of(kind, depth, seed, index).pair_file());
        return ExitCode::SUCCESS;
    }
    let indices = options.first..options.first + options.poses;
    let all = Vec::from_iter(indices.clone());
    let spur = |index: u64| {
        let drawn = Drawn::new(depth, seed, index);
        let pose = Pose::new(&drawn.assembly, drawn.mating);
        (drawn.assembly, pose)
    };
    if let Some(sections) = options.along_face {
        return judged(&all, |index| {
            let (pair, pose) = along_face::drawn(seed, index, options.profiles);
            let known = [along_face::resolved(&pair); 2];
            let against = |found: &LostMotion| {
                along_face::against_sections(&pair, &pose, found, sections, known)
            };
            of_exact(&pair, &pose, against)
        });
    }
    if options.brute {
        return judged(&all, |index| {
            let (pair, pose) = spur(index);
            of_exact(&pair, &pose, |found| {
                clearance::against(&pair, &pose, found)
            })
        });
    }
    let tally = run(kind, depth, seed, indices, !options.proofs);
    println!("seed {seed}\n{}", tally.report());
    name("unproven", &tally.unproven);
    let left = &tally.left[..tally.left.len().min(NAMED)];
    println!("{} poses left to the polygons: {left:?}", tally.left.len());
    let ordinary = &tally.ordinary_left;
    println!("{} of them ordinary: {ordinary:?}", ordinary.len());
    name("on a border", &tally.border);
    let empty = tally.empty(kind, depth);
    println!("never met: {empty:?}");
    for (index, fault) in tally.faults.iter().take(SHOWN) {
        let file = Drawn::of(kind, depth, seed, *index).pair_file();
        println!("\npose {index}: {fault}\n{file}");
    }
    name("fault", &tally.faults);
    if !(tally.faults.is_empty() && empty.is_empty() && ordinary.is_empty()) {
        return ExitCode::FAILURE;
    }
    if kind == Teeth::Helical || options.proofs {
        return ExitCode::SUCCESS;
    }
    judged(&all, |index| {
        let (pair, pose) = spur(index);
        let found = ExactKernel::new(&pair).lost_motion(&pose).ok();
        let overlap = found.and_then(|found| clearance::overlap_just_inside(&pair, &pose, &found));
        Vec::from_iter(overlap)
    })
}

/// The finding `against` the result of the exact method, or that it has none.
fn of_exact(
    pair: &GearPair,
    pose: &Pose,
    against: impl Fn(&LostMotion) -> Vec<String>,
) -> Vec<String> {
    match ExactKernel::new(pair).lost_motion(pose) {
        Ok(found) => against(&found),
        Err(error) => vec![error.to_string()],
    }
}

/// Names the faults of all poses; success if there are none.
fn judged(all: &[u64], of: impl Fn(u64) -> Vec<String> + Sync) -> ExitCode {
    let faults = complaints(all, |index| of(*index));
    let lines = faults
        .into_iter()
        .map(|(index, why)| (index, why.join("; ")));
    let lines = Vec::from_iter(lines);
    name("fault", &lines);
    println!("{} faults among {} poses", lines.len(), all.len());
    match lines.is_empty() {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    }
}

fn name(what: &str, poses: &[(u64, String)]) {
    for (index, why) in poses.iter().take(NAMED) {
        println!("{what}: pose {index}: {}", why.lines().next().unwrap_or(""));
    }
}
