//! The campaign: exact against polygon method on seeded random poses.
//!
//! `cargo run --release --example campaign -- [--poses N] [--seed S]`. Ends with 1 when the methods differ by
//! more than 1e-6 µm of `j_wt`, disagree on a status, or have no result; the first such
//! poses are printed as pair files.

#[path = "../tests/common/campaign.rs"]
mod campaign;

use campaign::{Drawn, run};
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
    /// Print this pose of the campaign as a pair file, and nothing else
    #[arg(long)]
    print: Option<u64>,
}

/// Faults printed in full.
const SHOWN: usize = 3;

fn main() -> ExitCode {
    let Options { poses, seed, print } = Options::parse();
    if let Some(index) = print {
        print!("{}", Drawn::new(seed, index).pair_file());
        return ExitCode::SUCCESS;
    }
    let start = Instant::now();
    let tally = run(poses, seed);
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
    println!("poses without a result {}", tally.without_result);
    for (index, fault) in tally.faults.iter().take(SHOWN) {
        println!(
            "\npose {index}: {fault}\n{}",
            Drawn::new(seed, *index).pair_file()
        );
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
