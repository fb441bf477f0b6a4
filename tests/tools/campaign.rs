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

use campaign::{Depth, Drawn, LONGEST, Tally, Teeth, run_of};
use clap::{Parser, ValueEnum};
use gearlash::contact::ExactKernel;
use gearlash::pair::{GearPair, Pose};
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
    depth: Option<Bundle>,
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

/// How far the gears are apart
#[derive(Clone, Copy, ValueEnum)]
enum Bundle {
    /// From jammed to tips that hardly reach
    Any,
    /// Tips that hardly reach each other
    Grazing,
    /// Tips that just reach a root, or just do not
    OnRoot,
}

impl Bundle {
    fn depth(self) -> Depth {
        match self {
            Bundle::Any => Depth::Any,
            Bundle::Grazing => Depth::Grazing,
            Bundle::OnRoot => Depth::OnRoot,
        }
    }
}

/// Poses printed in full.
const SHOWN: usize = 3;

/// Poses named with their reasons.
const NAMED: usize = 40;

fn main() -> ExitCode {
    let options = Options::parse();
    let (poses, seed) = (options.poses, options.seed);
    let depth = options.depth.map(Bundle::depth);
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
    if options.brute {
        let complaints = brute(depth, seed, options.first, poses);
        println!(
            "{poses} poses of seed {seed} against brute force, {:.1?}",
            start.elapsed()
        );
        name("fault", &complaints);
        println!("{} faults", complaints.len());
        return if complaints.is_empty() {
            ExitCode::SUCCESS
        } else {
            ExitCode::FAILURE
        };
    }
    let indices = options.first..options.first + poses;
    if let Some(sections) = options.along_face {
        let drawn = if options.profiles {
            along_face::drawn_with_profiles
        } else {
            along_face::drawn
        };
        return against_sections(drawn, seed, indices, sections);
    }
    let longest = Duration::from_secs(options.longest);
    let tally = run_of(kind, depth, seed, indices, longest, !options.proofs);
    println!("seed {seed}, {:.1?}", start.elapsed());
    println!("{}", tally.report());
    name("unproven", &tally.unproven);
    let left = tally.left.iter().take(NAMED).collect::<Vec<_>>();
    println!("{} poses left to the polygons: {left:?}", tally.left.len());
    let ordinary = &tally.ordinary_left;
    println!("{} of them ordinary: {ordinary:?}", ordinary.len());
    let border: Vec<(u64, String)> = tally
        .border
        .iter()
        .map(|(i, what)| (*i, (*what).to_owned()))
        .collect();
    name("on a border", &border);
    let overlaps = if options.proofs {
        Vec::new()
    } else {
        whole(kind, depth, seed, options.first..options.first + poses)
    };
    name("fault", &overlaps);
    if overlaps.is_empty() {
        verdict(&tally, kind, depth, seed)
    } else {
        ExitCode::FAILURE
    }
}

/// Clear spur poses in which whole gears overlap just inside a contact.
fn whole(kind: Teeth, depth: Option<Depth>, seed: u64, indices: Range<u64>) -> Vec<(u64, String)> {
    if matches!(kind, Teeth::Helical) {
        return Vec::new();
    }
    let complaint = |index: u64| {
        let drawn = Drawn::new(depth, seed, index);
        let pose = Pose::new(&drawn.assembly, drawn.mating);
        let found = ExactKernel::new(&drawn.assembly).lost_motion(&pose).ok()?;
        let complaint = clearance::overlap_just_inside(&drawn.assembly, &pose, &found)?;
        Some((index, complaint))
    };
    indices.into_par_iter().filter_map(complaint).collect()
}

/// Contradictions of brute force to the exact method, and abandoned poses.
fn brute(depth: Option<Depth>, seed: u64, first: u64, poses: u64) -> Vec<(u64, String)> {
    let indices = (first..first + poses).into_par_iter();
    let complaints = indices.filter_map(|index| {
        let drawn = Drawn::new(depth, seed, index);
        let pose = Pose::new(&drawn.assembly, drawn.mating);
        let complaint = match ExactKernel::new(&drawn.assembly).lost_motion(&pose) {
            Ok(found) => clearance::against(&drawn.assembly, &pose, &found).join("; "),
            Err(error) => error.to_string(),
        };
        (!complaint.is_empty()).then_some((index, complaint))
    });
    complaints.collect()
}

/// Poses along the face against dense sections: faults, and how far sections without zoom are from the contacts.
fn against_sections(
    drawn: fn(u64, u64) -> (GearPair, Pose),
    seed: u64,
    indices: Range<u64>,
    sections: u32,
) -> ExitCode {
    let start = Instant::now();
    let witnessed: Vec<_> = indices
        .into_par_iter()
        .filter_map(|index| {
            let (pair, pose) = drawn(seed, index);
            Some((index, along_face::witness(&pair, &pose, sections)?))
        })
        .collect();
    let took = start.elapsed().as_secs_f64();
    let count = witnessed.len();
    let mut between: Vec<f64> = witnessed.iter().map(|(_, found)| found.between).collect();
    between.sort_by(f64::total_cmp);
    let part = |share: f64| between[(share * (count as f64 - 1.0)) as usize];
    println!(
        "seed {seed}: {count} poses against {sections} sections, {:.2} poses/s",
        count as f64 / took
    );
    println!(
        "tighter than sections without zoom, µm: median {:.1e}, ninth decile {:.1e}, most {:.1e}",
        part(0.5),
        part(0.9),
        part(1.0)
    );
    let off = |found: &along_face::Witnessed| found.looser.max(found.tighter);
    let mut faults: Vec<_> = witnessed
        .iter()
        .filter(|(_, found)| off(found) > 0.0)
        .collect();
    faults.sort_by(|(_, one), (_, other)| off(other).total_cmp(&off(one)));
    let reasons: Vec<(u64, String)> = faults
        .iter()
        .map(|(index, found)| (*index, format!("{found:?}")))
        .collect();
    name("fault", &reasons);
    println!("{} faults", faults.len());
    if faults.is_empty() {
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
    if tally.faults.is_empty() && empty.is_empty() && tally.ordinary_left.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
