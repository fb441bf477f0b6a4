//! Over how much of a cycle a verdict is, and why what is not proven is not.

use super::{DECIMALS, each};
use gearlash::analysis::extremes::{RunExtreme, RunExtremes, WIDTH};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::Doubt;
use gearlash_files::numbers::um;

/// Over how much of the cycle, and whether that is proven.
pub(super) fn coverage(verdict: &Verdict) -> String {
    let matings = verdict.matings();
    let phases = each(verdict.runs.iter().filter_map(|run| run.phase)).len();
    let of = match phases {
        0 => format!("all {matings} matings"),
        phases => format!("all {matings} matings of each of {phases} assembly phases"),
    };
    let runs = || verdict.runs.iter();
    let least = runs().filter_map(|run| run.least.as_ref()).collect();
    let greatest = runs().filter_map(|run| run.greatest.as_ref()).collect();
    let ends = [End::of(true, least), End::of(false, greatest)];
    let rotation = match verdict.runs.iter().any(RunExtremes::any_direction) {
        true => "every rotation and every direction of the runout",
        false => "every rotation",
    };
    // What is sampled is not over every rotation.
    let over = match ends.iter().all(End::holds) {
        true => format!("{of} and {rotation}"),
        false => of,
    };
    format!("Over {over}, {}.", proof(&ends))
}

/// The least of some runs, or the greatest.
pub(super) struct End<'a> {
    is_least: bool,
    extremes: Vec<&'a RunExtreme>,
}

impl<'a> End<'a> {
    pub fn of(is_least: bool, extremes: Vec<&'a RunExtreme>) -> End<'a> {
        End { is_least, extremes }
    }

    fn name(&self) -> &'static str {
        match self.is_least {
            true => "the least",
            false => "the greatest",
        }
    }

    fn doubts(&self) -> Vec<String> {
        each(self.extremes.iter().filter_map(|extreme| doubt(extreme)))
    }

    /// Whether no pose lies beyond what is said of it, proven to a narrow bracket or not.
    fn holds(&self) -> bool {
        self.extremes.iter().all(|extreme| extreme.holds())
    }

    /// Between which it lies, mm, where that is known and says something.
    fn bracket(&self) -> Option<[f64; 2]> {
        let of_all = |end: fn(&RunExtreme) -> f64| {
            let ends = self.extremes.iter().map(|extreme| end(extreme));
            ends.reduce(if self.is_least { f64::min } else { f64::max })
        };
        let [low, high] = [of_all(|of| of.low)?, of_all(|of| of.high)?];
        (self.holds() && high - low > WIDTH).then_some([low, high])
    }
}

/// That both `ends` are proven, or which is not, why, and between what it lies.
pub(super) fn proof(ends: &[End; 2]) -> String {
    let open: Vec<&End> = ends.iter().filter(|end| !end.doubts().is_empty()).collect();
    let which = match open[..] {
        [] => return "proven".to_owned(),
        [only] => format!("{} is not proven", only.name()),
        _ => "least and greatest are not proven".to_owned(),
    };
    let mut parts = each(open.iter().flat_map(|end| end.doubts()));
    parts.extend(open.iter().filter_map(|end| {
        let [low, high] = end.bracket()?.map(|end| um(end, DECIMALS));
        Some(format!("{} lies between {low} and {high} µm", end.name()))
    }));
    format!("{which}: {}", parts.join("; "))
}

/// Why an extreme is only the one found; `None` where it is proven.
pub fn doubt(extreme: &RunExtreme) -> Option<String> {
    match &extreme.pose.simulated.found {
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
        Doubt::Effort => "the search stopped, as too many stretches of the cycle come near to it",
        Doubt::Unbounded => "the search stopped, as too many stretches of the cycle have no bound",
        Doubt::SecondOrder => "a runout of any direction is bounded to the second order alone",
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
