//! Over how much of a cycle a verdict is, and why what is not proven is not.

use super::{DECIMALS, each};
use crate::numbers::um;
use gearlash::analysis::extremes::{RunExtreme, RunExtremes};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::Doubt;

/// Over how much of the cycle, and whether that is proven.
pub(super) fn coverage(verdict: &Verdict) -> String {
    let matings = verdict.matings();
    let phases = each(verdict.runs.iter().filter_map(|run| run.phase)).len();
    let of = match phases {
        0 => format!("all {matings} matings"),
        phases => format!("all {matings} matings of each of {phases} assembly phases"),
    };
    let runs = verdict.runs.iter();
    let extremes = runs.flat_map(|run| run.least.iter().chain(&run.greatest));
    let extremes: Vec<&RunExtreme> = extremes.collect();
    let rotation = match verdict.runs.iter().any(RunExtremes::any_direction) {
        true => "every rotation and every direction of the runout",
        false => "every rotation",
    };
    // What is sampled is not over every rotation.
    let doubts = doubts(&extremes);
    let over = match doubts.is_empty() || widest(&extremes, &doubts).is_some() {
        true => format!("{of} and {rotation}"),
        false => of,
    };
    format!("Over {over}, {}.", proof(&extremes))
}

/// That `extremes` are proven, or how far, or why not.
pub(super) fn proof(extremes: &[&RunExtreme]) -> String {
    let doubts = doubts(extremes);
    match (&doubts[..], widest(extremes, &doubts)) {
        ([], _) => "proven".to_owned(),
        ([only], Some(width)) => format!("proven to {} µm: {only}", um(width, DECIMALS)),
        (doubts, _) => format!("not proven: {}", doubts.join("; ")),
    }
}

fn doubts(extremes: &[&RunExtreme]) -> Vec<String> {
    each(extremes.iter().filter_map(|extreme| doubt(extreme)))
}

/// The width of the widest bracket, where all hold and only one doubt is left.
fn widest(extremes: &[&RunExtreme], doubts: &[String]) -> Option<f64> {
    let wide = extremes
        .iter()
        .filter(|extreme| extreme.doubt.is_some() && extreme.holds());
    let widest = wide
        .map(|extreme| extreme.high - extreme.low)
        .reduce(f64::max);
    widest.filter(|_| doubts.len() == 1)
}

/// Why an extreme is only the one found; `None` where it is proven.
pub fn doubt(extreme: &RunExtreme) -> Option<String> {
    match &extreme.pose.swept.found {
        Err(unproven) => Some(unproven.reason.clone()),
        Ok(_) => extreme.doubt.map(|doubt| in_words(doubt).to_owned()),
    }
}

/// A doubt in words.
pub(crate) fn in_words(doubt: Doubt) -> &'static str {
    match doubt {
        Doubt::OffInvolute => {
            "fillets or roots may be touched, so only sampled poses were looked at"
        }
        Doubt::Effort => "too many stretches of the cycle come too near to each other",
        Doubt::Unbounded => "too many stretches of the cycle have no bound",
        Doubt::SecondOrder => {
            "what a runout of any direction does is bounded to the second order of the lost motion"
        }
        Doubt::Profile => {
            "profile deviations are bounded by the greatest and the least of each flank alone"
        }
        Doubt::ContactLost => "at a pose the contact was lost",
    }
}

/// Beside a distance from or up to which something holds.
pub(super) fn unless_proven(doubt: Option<Doubt>) -> &'static str {
    match doubt {
        None => "",
        Some(_) => " (not proven)",
    }
}
