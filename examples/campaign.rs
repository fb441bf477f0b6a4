//! The campaign: exact against polygon method on seeded random poses.
//!
//! `cargo run --release --example campaign -- [--poses N] [--seed S] [--grazing | --on-root]`. Ends with 1 when the methods differ by
//! more than 1e-6 µm of `j_wt` (grazing or on a root: than their error bounds), disagree on a status, or have no result; the first such
//! poses are printed as pair files.

#[path = "../tests/common/campaign.rs"]
mod campaign;

use campaign::{Depth, Drawn, run};
use clap::Parser;
use std::process::ExitCode;
use std::time::Instant;

/// Exact against polygon method on random poses
#[derive(Parser)]
struct Options {
    /// Number of poses, a new pair each
    #[arg(long, default_value_t = 10_000)]
    poses: u64,
    /// Seed of the random numbers
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Tips that hardly reach each other; the methods must agree within their error bounds
    #[arg(long)]
    grazing: bool,
    /// Tips that just reach a root, or just do not; the same
    #[arg(long, conflicts_with = "grazing")]
    on_root: bool,
    /// Print this pose of the campaign as a pair file, and nothing else
    #[arg(long)]
    print: Option<u64>,
}

/// Faults printed in full.
const SHOWN: usize = 3;

fn main() -> ExitCode {
    let options = Options::parse();
    let (poses, seed) = (options.poses, options.seed);
    let depth = match (options.grazing, options.on_root) {
        (true, _) => Depth::Grazing,
        (_, true) => Depth::OnRoot,
        _ => Depth::Any,
    };
    let pair_file = |index| Drawn::new(depth, seed, index).pair_file();
    if let Some(index) = options.print {
        print!("{}", pair_file(index));
        return ExitCode::SUCCESS;
    }
    let start = Instant::now();
    let tally = run(depth, poses, seed);
    let percent = |count: u64| 100.0 * count as f64 / tally.poses.max(1) as f64;
    println!(
        "{} poses of seed {seed} in {:.1?}",
        tally.poses,
        start.elapsed()
    );
    for (what, count) in [
        ("contact off involute on involute", tally.off_involute),
        ("free gear eccentric", tally.free_eccentric),
        ("undercut teeth", tally.undercut),
    ] {
        println!("  {count:7}  {:5.1} %  {what}", percent(count));
    }
    println!("statuses");
    for (status, count) in &tally.statuses {
        println!("  {count:7}  {:5.1} %  {status}", percent(*count));
    }
    println!("contacts of clear and interfering poses");
    for (curves, count) in &tally.curves {
        println!("  {count:7}  {curves}");
    }
    println!("largest difference {:.2e} µm", tally.greatest_um);
    println!("largest error bound {:.2e} µm", tally.greatest_bound_um);
    println!("poses without a result {}", tally.without_result);
    for (index, fault) in tally.faults.iter().take(SHOWN) {
        println!("\npose {index}: {fault}\n{}", pair_file(*index));
    }
    if tally.faults.is_empty() {
        return ExitCode::SUCCESS;
    }
    let numbers: Vec<u64> = tally.faults.iter().map(|(index, _)| *index).collect();
    println!("{} faults: {numbers:?}", numbers.len());
    for (index, fault) in &tally.faults {
        println!(
            "  pose {index}: {}",
            fault.lines().next().unwrap_or_default()
        );
    }
    ExitCode::FAILURE
}
