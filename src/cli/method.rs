//! `--method` and `--no-certify`: what several commands share.

use super::console::tell;
use crate::compare::ComparedRun;
use crate::mesh::Method;
use clap::ValueEnum;

/// Largest difference between the two methods that passes, mm: 1e-6 µm, a picometre.
const AGREEMENT: f64 = 1e-9;

#[derive(clap::Args)]
pub(super) struct MethodArgs {
    /// How lost motion is found
    #[arg(long, value_enum, default_value_t = Name::Exact)]
    method: Name,
    /// Leave out the check of each exact result by polygons
    #[arg(long)]
    no_certify: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Name {
    /// On the smooth curves, each result checked by polygons
    Exact,
    /// On polygons cut ever finer round each contact: the referee, slower
    Polygon,
    /// By both: prints the largest difference, exit 1 above 1e-6 µm
    Both,
}

impl MethodArgs {
    /// The method asked for.
    pub fn method(&self) -> Method {
        match self.method {
            Name::Exact => Method::Exact {
                certify: !self.no_certify,
            },
            Name::Polygon => Method::Polygon,
            Name::Both => Method::Both,
        }
    }
}

/// Says on standard error how far both methods lie apart, where both were asked for; whether that passes.
pub(super) fn agreement<'a>(runs: impl IntoIterator<Item = &'a ComparedRun>) -> bool {
    agreement_within(largest_difference(runs))
}

/// The largest difference of the two methods over `runs`, mm; `None` where only one was asked for.
pub(super) fn largest_difference<'a>(
    runs: impl IntoIterator<Item = &'a ComparedRun>,
) -> Option<f64> {
    let poses = runs.into_iter().flat_map(|run| &run.poses);
    let differences = poses.filter_map(|pose| pose.swept.polygon_difference);
    differences.map(f64::abs).reduce(f64::max)
}

/// The same of the largest difference, mm; `None` where one method alone was asked for.
pub(super) fn agreement_within(largest: Option<f64>) -> bool {
    let Some(largest) = largest else {
        return true;
    };
    let passes = largest <= AGREEMENT;
    let verdict = if passes { "agree" } else { "DISAGREE" };
    tell(&format!(
        "exact and polygon method {verdict}: largest difference {:.2e} µm of j_wt (allowed 1e-6)",
        largest * 1e3
    ));
    passes
}
