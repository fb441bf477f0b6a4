//! `--method` and `--no-certify`, options of several commands.

use super::console::print_error_line;
use crate::error::Error;
use clap::ValueEnum;
use gearlash::analysis::Analysis;
use gearlash::analysis::study::Study;
use gearlash::analysis::tally::RunTally;
use gearlash::contact::{METHODS_AGREE_WITHIN, Method, MethodAgreement};
use gearlash_files::numbers::{order_um, power};

#[derive(clap::Args, Default)]
pub(super) struct MethodArgs {
    /// How lost motion is found [default: exact]
    #[arg(long, value_enum)]
    method: Option<Name>,
    /// Skip the proof of each exact result
    #[arg(long)]
    no_certify: bool,
}

#[derive(Clone, Copy, ValueEnum)]
enum Name {
    /// On the exact tooth curves, each result proven; polygons check every 64th
    Exact,
    /// On polygons refined around each contact: an independent method, slower
    Polygon,
    /// Both: prints the largest difference; exit 1 where a pose has one above 1e-6 µm and both error bounds
    Both,
}

impl MethodArgs {
    /// Whether one of the options is given.
    pub fn given(&self) -> bool {
        self.method.is_some() || self.no_certify
    }

    /// The requested method, for the pair of `study`.
    ///
    /// # Errors
    /// [`Error::Usage`]: drawn curves have only one method.
    pub fn of(&self, study: &Study) -> Result<Method, Error> {
        if study.is_drawn() && self.method.is_some() {
            Err(Error::usage(
                "--method is for gears by their data: drawn curves are searched as drawn, and polygons check every pose; leave it out",
            ))
        } else {
            Ok(self.method())
        }
    }

    /// The requested method.
    pub fn method(&self) -> Method {
        match self.method.unwrap_or(Name::Exact) {
            Name::Exact => Method::Exact {
                certify: !self.no_certify,
            },
            Name::Polygon => Method::Polygon,
            Name::Both => Method::Both,
        }
    }
}

/// Prints on standard error the difference of both methods, where both were requested, and the number of unproven poses. Returns
/// whether both pass.
pub(super) fn agreement<'a>(runs: impl IntoIterator<Item = &'a RunTally> + Clone) -> bool {
    let each = runs.clone().into_iter().map(|run| run.agreement);
    let agree = agreement_of(each.fold(MethodAgreement::default(), MethodAgreement::and));
    agree & all_proven(runs.into_iter().map(|run| run.unproven).sum())
}

/// [`agreement`] over everything that was analysed.
pub(super) fn agreed(analysis: &Analysis) -> bool {
    agreement_of(analysis.agreement()) & all_proven(analysis.unproven())
}

/// Prints on standard error the number of unproven poses, if any. Returns whether all are proven.
pub(super) fn all_proven(unproven: usize) -> bool {
    match unproven {
        0 => return true,
        1 => print_error_line("warning: 1 pose is UNPROVEN; the result tells which and why"),
        poses => print_error_line(&format!(
            "warning: {poses} poses are UNPROVEN; the result tells which and why"
        )),
    }
    false
}

/// Prints on standard error the difference of both methods. Returns whether it passes. Prints nothing for a single method.
pub(super) fn agreement_of(found: MethodAgreement) -> bool {
    if !found.is_empty() {
        print_error_line(&in_words(found));
    }
    found.agrees()
}

fn in_words(found: MethodAgreement) -> String {
    let verdict = if found.agrees() { "agree" } else { "DISAGREE" };
    let poses = |count: usize| match count {
        1 => "1 pose".to_owned(),
        _ => format!("{count} poses"),
    };
    let mut parts = Vec::new();
    if found.one_alone > 0 {
        parts.push(format!(
            "at {} only one method has a contact",
            poses(found.one_alone)
        ));
    }
    if found.beyond > 0 {
        parts.push(format!(
            "at {} they differ by more than is allowed",
            poses(found.beyond)
        ));
    }
    if found.compared > 0 {
        parts.push(format!(
            "largest difference {} µm of j_wt (allowed at a pose: {} or the sum of both error bounds)",
            power(found.largest * 1e3, 2),
            order_um(METHODS_AGREE_WITHIN)
        ));
    }
    format!("exact and polygon method {verdict}: {}", parts.join("; "))
}
