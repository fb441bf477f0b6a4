//! The result of a run in one sentence, for production managers and designers.

use super::result::{PopulationSummary, ToleranceResult, required_ends};
use gearlash::pair::Member;
use gearlash::population::{Contributions, Factor, OutcomeKind, Share};
use gearlash_text::numbers::{rounded, shortest};

/// The sentence of `result`: the share that misses the requirement, with its interval, and the main source of the spread.
///
/// "310 ppm (270 … 354) below 40 µm; 71 % of the scatter from the centre distance"
pub fn sentence(result: &ToleranceResult) -> String {
    let about = &result.about;
    let least = required_ends(about.min_mm, &about.others, false);
    let most = required_ends(about.max_mm, &about.others, true);
    let mut text = shares(result);
    if most.is_some() {
        text = format!("{}: {text}", share(&result.statistics.outside, "outside"));
    }
    // The limited extreme: the least, or the greatest where only that is limited.
    let greatest = least.is_none() && most.is_some();
    if let Some(most) = largest(&result.contributions[usize::from(greatest)]) {
        text += &format!("; {most}");
    }
    let counts = &result.tally.counts;
    for (count, what) in [
        (counts.of(OutcomeKind::Jammed), "jammed"),
        (counts.of(OutcomeKind::NoContact), "out of mesh"),
        (counts.of(OutcomeKind::Impossible), "of no gear"),
        (counts.of(OutcomeKind::Unproven), "without a result"),
        (result.tally.doubtful, "in a wide bracket"),
    ] {
        if count > 0 {
            text += &format!("; {count} {what}");
        }
    }
    if let Some(met) = result.is_met() {
        let most = about.max_ppm.unwrap_or_default();
        text += if met { "; meets" } else { "; does not meet" };
        text += &format!(" the {} ppm allowed", shortest(most));
        if met && 1e6 * result.statistics.outside.high > most {
            text += ", but the interval reaches above it";
        }
    }
    text
}

/// The assemblies that mean, standard deviation and capability omit; `None` where all have a least and a greatest backlash.
pub fn without_backlash(result: &ToleranceResult) -> Option<String> {
    let statistics = &result.statistics;
    let without = [
        (&statistics.least, "least"),
        (&statistics.greatest, "greatest"),
    ];
    let each = without.into_iter().filter_map(|(spread, end)| {
        let count = statistics.total.saturating_sub(spread.count);
        (count > 0).then(|| format!("the {count} that have no {end} backlash"))
    });
    let each: Vec<String> = each.collect();
    (!each.is_empty()).then(|| {
        format!(
            "Mean, standard deviation, Cp and Cpk are without {} (jammed, out of mesh, of no gear or without a result); none of them is left out of the share that misses the requirement.",
            each.join(" and ")
        )
    })
}

/// The shares of `result` that miss the requirement on each side.
pub fn shares(result: &ToleranceResult) -> String {
    let (about, statistics) = (&result.about, &result.statistics);
    let least = required_ends(about.min_mm, &about.others, false);
    let below = least.map_or("do not assemble".to_owned(), |least| {
        format!("below {least}")
    });
    let mut text = share(&statistics.below, &below);
    if let Some(most) = required_ends(about.max_mm, &about.others, true) {
        text += &format!(", {}", share(&statistics.above, &format!("above {most}")));
        // An assembly can miss both limits.
        let both = statistics.below.count + statistics.above.count;
        if let Some(both @ 1..) = both.checked_sub(statistics.outside.count) {
            text += &format!(", {both} of {} both", statistics.total);
        }
    }
    text
}

/// The reason for no worst case; `None` where there is one.
pub fn without_worst_case(about: &PopulationSummary) -> Option<&'static str> {
    if about.limit_cases.is_some() {
        return None;
    }
    let wholes = Member::BOTH.map(|member| Factor::Gear(member).name());
    let has_wholes = wholes.iter().any(|name| about.quantities.contains(name));
    Some(if has_wholes {
        "No worst case: whole gears that were measured have no limits."
    } else {
        "No worst case: the worst direction of a drawn gear's runout is not searched."
    })
}

/// The assembly phases of worst case and root sum of squares; `None` where the phase does not scatter.
pub fn phases_of_limits(about: &PopulationSummary) -> Option<&'static str> {
    let phase = Factor::Phase.name();
    let scatters = about.quantities.contains(&phase);
    (scatters && about.limit_cases.is_some()).then_some(
        "At the mean, worst case and root sum of squares: each number is of its worst assembly phase.",
    )
}

/// "310 ppm (270 … 354) below 40 µm".
fn share(share: &Share, what: &str) -> String {
    let [low, high] = [share.low, share.high].map(ppm);
    format!("{} ppm ({low} … {high}) {what}", ppm(share.share))
}

/// Parts per million, whole from ten on.
pub(crate) fn ppm(share: f64) -> String {
    let ppm = 1e6 * share;
    shortest(rounded(ppm, if ppm < 10.0 { 1 } else { 0 }))
}

/// "71 % of the scatter from the centre distance".
fn largest(found: &Contributions) -> Option<String> {
    let each = found.each.iter();
    let most = each.max_by(|a, b| a.total.value.total_cmp(&b.total.value))?;
    let percent = (100.0 * most.total.value).round().clamp(0.0, 100.0);
    let article = match most.factor {
        Factor::Gear(_) => "",
        _ => "the ",
    };
    let name = most.factor.name();
    Some(format!("{percent} % of the scatter from {article}{name}"))
}
