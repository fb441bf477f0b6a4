//! The campaign: exact against polygon method on seeded random poses, each exact result certified.
//!
//! `cargo run --release --example campaign -- [--poses N] [--seed S] [--first I] [--helical] [--depth any|grazing|on-root]
//! [--longest SECONDS] [--proofs] [--brute] [--along-face SECTIONS [--profiles]] [--print I]`.
//! Whole gears are a further referee: just inside both contacts of a clear pose no metal may be in the other gear. It
//! exits with 1 if the methods differ by more than the sum of both error bounds, disagree on a status, or the
//! certificate refuses. It also does if a class of contact did not occur, or if the prover leaves an ordinary pose to the
//! polygons. Abandoned poses are counted and named. The first such poses are printed as pair files. `--proofs` has only the
//! certificate as referee: a million poses take minutes. `--brute` uses brute force instead of the polygon method.

#[path = "../common/along_face.rs"]
mod along_face;
#[path = "../common/campaign/mod.rs"]
mod campaign;
#[path = "../common/clearance/mod.rs"]
mod clearance;

use campaign::{Depth, Drawn, LONGEST, Tally, Teeth, run_within};
use clap::Parser;
use gearlash::contact::ExactKernel;
use gearlash::pair::Pose;
use rayon::prelude::*;
use std::ops::Range;
use std::process::ExitCode;
use std::time::{Duration, Instant};

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
    /// Seconds after which a pose is given up, and the campaign with it
    #[arg(long, default_value_t = LONGEST.as_secs())]
    longest: u64,
    /// Only the prover beside the certificate, without polygon method and whole gears
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
    let kind = if options.helical {
        Teeth::Helical
    } else {
        Teeth::Spur
    };
    if let Some(index) = options.print {
        print!("{}", Drawn::of(kind, depth, seed, index).pair_file());
        return ExitCode::SUCCESS;
    }
    let start = Instant::now();
    let indices = options.first..options.first + options.poses;
    let against = if let Some(sections) = options.along_face {
        Some(complaints(&indices, |index| {
            against_sections(seed, index, options.profiles, sections)
        }))
    } else if options.brute {
        Some(complaints(&indices, |index| brute(depth, seed, index)))
    } else {
        None
    };
    if let Some(faults) = against {
        let (poses, took) = (options.poses, start.elapsed());
        println!("{poses} poses of seed {seed}, {took:.1?}");
        name("fault", &faults);
        println!("{} faults", faults.len());
        return code(faults.is_empty());
    }
    let longest = Duration::from_secs(options.longest);
    let all = indices.clone();
    let tally = run_within(longest, kind, depth, seed, all, !options.proofs);
    println!("seed {seed}, {:.1?}", start.elapsed());
    println!("{}", tally.report());
    name("unproven", &tally.unproven);
    let left = tally.left.iter().take(NAMED).collect::<Vec<_>>();
    println!("{} poses left to the polygons: {left:?}", tally.left.len());
    let ordinary = &tally.ordinary_left;
    println!("{} of them ordinary: {ordinary:?}", ordinary.len());
    let border = tally
        .border
        .iter()
        .map(|(i, what)| (*i, (*what).to_owned()));
    name("on a border", &border.collect::<Vec<_>>());
    if kind == Teeth::Spur && !options.proofs {
        let overlaps = complaints(&indices, |index| whole(depth, seed, index));
        name("fault", &overlaps);
        if !overlaps.is_empty() {
            return ExitCode::FAILURE;
        }
    }
    verdict(&tally, kind, depth, seed)
}

/// The faults of each pose, on all threads.
fn complaints(indices: &Range<u64>, of: impl Fn(u64) -> Vec<String> + Sync) -> Vec<(u64, String)> {
    let each = indices
        .clone()
        .into_par_iter()
        .map(|index| (index, of(index).join("; ")));
    each.filter(|(_, against)| !against.is_empty()).collect()
}

/// Whole gears that overlap just inside a contact of a clear spur pose.
fn whole(depth: Option<Depth>, seed: u64, index: u64) -> Vec<String> {
    let drawn = Drawn::new(depth, seed, index);
    let pose = Pose::new(&drawn.assembly, drawn.mating);
    let found = ExactKernel::new(&drawn.assembly).lost_motion(&pose).ok();
    let overlap =
        found.and_then(|found| clearance::overlap_just_inside(&drawn.assembly, &pose, &found));
    Vec::from_iter(overlap)
}

/// Contradictions of brute force to the exact method, and abandoned poses.
fn brute(depth: Option<Depth>, seed: u64, index: u64) -> Vec<String> {
    let drawn = Drawn::new(depth, seed, index);
    let pose = Pose::new(&drawn.assembly, drawn.mating);
    match ExactKernel::new(&drawn.assembly).lost_motion(&pose) {
        Ok(found) => clearance::against(&drawn.assembly, &pose, &found),
        Err(error) => vec![error.to_string()],
    }
}

/// Contradictions of dense sections to a pose along the face.
fn against_sections(seed: u64, index: u64, profiles: bool, sections: u32) -> Vec<String> {
    let draw = if profiles {
        along_face::drawn_with_profiles
    } else {
        along_face::drawn
    };
    let (pair, pose) = draw(seed, index);
    match ExactKernel::new(&pair).lost_motion(&pose) {
        Ok(found) => {
            let known = [along_face::resolved(&pair); 2];
            along_face::against_sections(&pair, &pose, &found, sections, known)
        }
        Err(error) => vec![error.to_string()],
    }
}

/// Success if nothing is wrong.
fn code(is_right: bool) -> ExitCode {
    if is_right {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

fn name(what: &str, poses: &[(u64, String)]) {
    for (index, why) in poses.iter().take(NAMED) {
        println!(
            "{what}: pose {index}: {}",
            why.lines().next().unwrap_or_default()
        );
    }
}

fn verdict(tally: &Tally, kind: Teeth, depth: Option<Depth>, seed: u64) -> ExitCode {
    let empty = tally.empty(depth);
    for class in &empty {
        println!("never met: {class}");
    }
    for (index, fault) in tally.faults.iter().take(SHOWN) {
        let file = Drawn::of(kind, depth, seed, *index).pair_file();
        println!("\npose {index}: {fault}\n{file}");
    }
    name("fault", &tally.faults);
    if !tally.faults.is_empty() {
        let all: Vec<u64> = tally.faults.iter().map(|(index, _)| *index).collect();
        println!("{} faults: {all:?}", all.len());
    }
    code(tally.faults.is_empty() && empty.is_empty() && tally.ordinary_left.is_empty())
}
