//! The verdict in one sentence: what every command says first, in the same words.

mod bearings;
mod coverage;

use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::extremes::{RunExtreme, RunExtremes, WIDTH};
use gearlash::analysis::verdict::{Requirement, Unmet, Verdict};
use gearlash::contact::Status;
use gearlash::pair::{GearPair, Member};
use gearlash_files::numbers::{fixed, stated_distance, um, unit_of};

use bearings::bearings;
pub use coverage::doubt;
pub(crate) use coverage::in_words;
use coverage::{coverage, unless_proven};

/// Decimals of a backlash in µm.
const DECIMALS: usize = 2;

/// Centre distances that are named, at most.
const NAMED: usize = 4;

/// What `verdict` says: whether and where the pair assembles, its least and greatest backlash with the teeth, and over what that holds.
pub fn sentence(verdict: &Verdict) -> String {
    if verdict.runs.is_empty() {
        return "Nothing was run.".to_owned();
    }
    let mut text = status(verdict);
    if verdict.assembles() == Some(true) && verdict.requirement == Requirement::Met {
        text += " and meets its requirement";
    }
    let (failed, assembles) = (checks(verdict), verdict.assembles() == Some(true));
    let first = failed.clone().filter(|_| assembles);
    let beside: Vec<String> = [requirement(verdict), first]
        .into_iter()
        .flatten()
        .collect();
    if !beside.is_empty() {
        let but = match verdict.assembles() {
            Some(true) => ", but ",
            _ => "; ",
        };
        text += but;
        text += &beside.join("; ");
    }
    if let Some(values) = values(verdict) {
        text += ": ";
        text += &values;
    }
    text += ". ";
    text += &coverage(verdict);
    if let Some(bearings) = bearings(verdict) {
        text += " ";
        text += &bearings;
    }
    // Below what is worse: the same words as of a command that makes no checks.
    if let Some(failed) = failed.filter(|_| !assembles) {
        text += &format!(" It also {failed}.");
    }
    text
}

/// Whether and where it assembles.
fn status(verdict: &Verdict) -> String {
    let of = |holds: &dyn Fn(&RunExtremes) -> bool| -> Vec<&RunExtremes> {
        verdict.runs.iter().filter(|run| holds(run)).collect()
    };
    let jammed = of(&|run| run.status == Status::Jammed);
    let apart = of(&|run| run.status == Status::NoContact);
    let tight = of(&|run| run.assembles() == Some(false) && run.status != Status::NoContact);
    let open = of(&|run| run.assembles().is_none());
    if jammed.len() == verdict.runs.len() {
        return format!("Jammed {}", places(verdict, &jammed));
    }
    if !tight.is_empty() {
        return format!("Does not assemble {}", places(verdict, &tight));
    }
    if !apart.is_empty() {
        return format!("Out of mesh {}", places(verdict, &apart));
    }
    if !open.is_empty() {
        return format!("Not proven to assemble {}", places(verdict, &open));
    }
    let without = verdict.runs.iter().any(without_backlash);
    let how = if without { " without backlash" } else { "" };
    format!("Assembles{how} {}", places(verdict, &of(&|_| true)))
}

/// Whether the least backlash of a run cannot be told from none.
fn without_backlash(run: &RunExtremes) -> bool {
    let least = run.least.as_ref();
    least.is_some_and(|least| least.found().abs() <= WIDTH)
}

/// Whether all poses of a run have one backlash.
fn uniform(run: &RunExtremes) -> bool {
    let both = run.least.as_ref().zip(run.greatest.as_ref());
    both.is_some_and(|(least, greatest)| greatest.found() - least.found() <= WIDTH)
}

/// The centre distances and the material of some runs.
fn places(verdict: &Verdict, runs: &[&RunExtremes]) -> String {
    let distances = |runs: &[&RunExtremes]| {
        let mut distances: Vec<f64> = Vec::new();
        for run in runs {
            let distance = run.assembly.center_distance();
            if !distances.contains(&distance) {
                distances.push(distance);
            }
        }
        distances
    };
    let all: Vec<&RunExtremes> = verdict.runs.iter().collect();
    let (here, everywhere) = (distances(runs), distances(&all).len());
    let named = here.iter().take(NAMED).map(|a| stated_distance(*a));
    let named = named.collect::<Vec<_>>().join(", ");
    let more = match here.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let mut text = match (here.len(), everywhere) {
        (_, 1) => format!("at a = {named} mm"),
        (2, 2) => "at both centre distances".to_owned(),
        (some, all) if some == all => format!("at all {all} centre distances"),
        (some, all) => format!("at a = {named} mm{more} ({some} of {all} centre distances)"),
    };
    // Of the same places: the material, and the phases, where it is not so in all.
    let within: Vec<&&RunExtremes> = all
        .iter()
        .filter(|run| here.contains(&run.assembly.center_distance()))
        .collect();
    if let [material] = &each(runs.iter().map(|run| run.material))[..]
        && each(within.iter().map(|run| run.material)).len() > 1
    {
        text += &format!(" with {}", material.words());
    }
    let phases = each(runs.iter().filter_map(|run| run.phase));
    let possible = each(within.iter().filter_map(|run| run.phase)).len();
    if !phases.is_empty() && phases.len() < possible {
        let named = phases.iter().take(NAMED).map(|(w, p)| format!("{w}·{p}"));
        let named = named.collect::<Vec<_>>().join(", ");
        let more = match phases.len().saturating_sub(NAMED) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        text += &format!(
            " in {} of {possible} assembly phases ({named}{more})",
            phases.len()
        );
    }
    text
}

fn each<T: PartialEq>(items: impl Iterator<Item = T>) -> Vec<T> {
    let mut each = Vec::new();
    for item in items {
        if !each.contains(&item) {
            each.push(item);
        }
    }
    each
}

fn requirement(verdict: &Verdict) -> Option<String> {
    if verdict.unmet.is_empty() {
        return None;
    }
    Some(not_met(&verdict.unmet))
}

/// That `unmet` is not kept.
pub(crate) fn not_met(unmet: &[Unmet]) -> String {
    let each = unmet.iter().map(limit).collect::<Vec<_>>();
    let says = match unmet.iter().all(keeps_what_was_found) {
        true => "is not proven to meet",
        false => "does not meet",
    };
    format!("{says} its requirement ({})", each.join("; "))
}

/// Whether what was found lies within the limit, and no more than that is known.
fn keeps_what_was_found(unmet: &Unmet) -> bool {
    let is_within = |[low, high]: [f64; 2]| match unmet.is_max {
        true => high <= unmet.limit,
        false => low >= unmet.limit,
    };
    !unmet.holds && unmet.found.is_some_and(is_within)
}

fn limit(unmet: &Unmet) -> String {
    let (name, unit, per, decimals) = unit_of(unmet.quantity);
    let end = if unmet.is_max { "most" } else { "least" };
    let limit = fixed(unmet.limit * per, decimals);
    let found = match unmet.found {
        None => "has no value".to_owned(),
        Some([low, high]) => {
            let value = if unmet.is_max { high } else { low };
            match value.is_finite() {
                true => format!("is {} {unit}", fixed(value * per, decimals)),
                false => "has no end".to_owned(),
            }
        }
    };
    let play = if unmet.with_play {
        " with the bearing clearance"
    } else {
        ""
    };
    let why = match (unmet.straddles, unmet.holds) {
        (true, _) => ", the limit inside its bracket",
        (false, false) => ", which is not proven",
        (false, true) => "",
    };
    format!("{name} at {end} {limit} {unit}, {found}{play}{why}")
}

/// Checks that fail when the pair does not assemble: said already.
const OF_ASSEMBLY: [&str; 2] = ["zero_backlash_distance", "backlash_condition"];

fn checks(verdict: &Verdict) -> Option<String> {
    let said = |id: &&&str| verdict.assembles() == Some(false) && OF_ASSEMBLY.contains(*id);
    let failed = verdict.failed_checks.iter().filter(|id| !said(id));
    let failed: Vec<String> = failed.map(|id| id.replace('_', " ")).collect();
    match failed.len() {
        0 => None,
        1 => Some(format!("fails the check {}", failed[0])),
        several => Some(format!("fails {several} checks: {}", failed.join(", "))),
    }
}

/// Least and greatest of the cycle in a line, for a picture of fewer poses; empty where there are none.
pub fn in_short(verdict: &Verdict) -> String {
    let (Some((_, least)), Some((_, greatest))) = (verdict.least(), verdict.greatest()) else {
        return String::new();
    };
    format!(
        "whole mesh cycle ({} matings): least {} µm, greatest {} µm",
        verdict.matings(),
        um(least.found(), DECIMALS),
        um(greatest.found(), DECIMALS)
    )
}

/// Least and greatest, and from where on it assembles.
fn values(verdict: &Verdict) -> Option<String> {
    let least = verdict.least();
    let greatest = verdict.greatest();
    let mut parts = Vec::new();
    if let [only] = verdict.runs
        && let (Some((run, extreme)), true) = (least, uniform(only))
    {
        parts.push(value(verdict, run, extreme, true));
    } else {
        if let Some((run, extreme)) = least {
            parts.push(format!("least {}", value(verdict, run, extreme, true)));
        }
        if let Some((run, extreme)) = greatest {
            parts.push(format!("greatest {}", value(verdict, run, extreme, false)));
        }
    }
    if verdict.assembles() == Some(false)
        && verdict
            .runs
            .iter()
            .any(|run| run.assembles() == Some(false) && run.status != Status::NoContact)
    {
        parts.push(match verdict.assembles_from() {
            Some(from) => {
                let distance = fixed(upward(from.high), 4);
                format!(
                    "assembles from a = {distance} mm on{}",
                    unless_proven(from.doubt)
                )
            }
            None => "assembles at no centre distance in mesh".to_owned(),
        });
    }
    if verdict
        .runs
        .iter()
        .any(|run| run.status == Status::NoContact)
    {
        parts.push(match verdict.meshes_to() {
            Some(to) => {
                let distance = fixed(downward(to.low), 4);
                format!("in mesh up to a = {distance} mm{}", unless_proven(to.doubt))
            }
            None => "in mesh at no centre distance".to_owned(),
        });
    }
    (!parts.is_empty()).then(|| parts.join("; "))
}

fn value(verdict: &Verdict, run: &RunExtremes, extreme: &RunExtreme, is_least: bool) -> String {
    let several = |differs: &dyn Fn(&RunExtremes) -> bool| verdict.runs.iter().any(differs);
    let mut text = amount(verdict, &run.assembly, extreme);
    if uniform(run) {
        text += ", the same at every pose";
    } else if run.has_like_teeth() {
        text += " at any tooth";
    } else if let Some(teeth) = teeth(&extreme.pose) {
        text += &format!(" at teeth {teeth}");
    }
    if run.any_direction() {
        text += match is_least {
            true => ", the high teeth towards the mate",
            false => ", the high teeth away from the mate",
        };
    }
    let distance = run.assembly.center_distance();
    let mut place = Vec::new();
    if several(&|other| other.assembly.center_distance() != distance) {
        place.push(format!("a = {} mm", stated_distance(distance)));
    }
    if several(&|other| other.material != run.material) {
        place.push(run.material.words().to_owned());
    }
    if let Some((wheel, pinion)) = run.phase {
        place.push(format!("phase {wheel}·{pinion}"));
    }
    if !place.is_empty() {
        text += &format!(", {}", place.join(", "));
    }
    text
}

/// An extreme as a backlash with its uncertainty, and as a lost motion of both gears of `assembly`.
fn amount(verdict: &Verdict, assembly: &GearPair, extreme: &RunExtreme) -> String {
    let found = extreme.found();
    let off = match (verdict.expanded(extreme), verdict.uncertainty) {
        (Some(expanded), Some(stated)) => {
            format!(" ± {} µm (k = {})", um(expanded, DECIMALS), stated.coverage)
        }
        _ => " µm".to_owned(),
    };
    format!(
        "j_wt {}{off} ({})",
        um(found, DECIMALS),
        lost_motion(assembly, found)
    )
}

/// Lost motion of a backlash, mm, at both gears, in minutes of arc.
fn lost_motion(assembly: &GearPair, backlash: f64) -> String {
    let backlash = assembly.backlash(backlash);
    let [wheel, pinion] = Member::BOTH.map(|member| fixed(backlash.arcmin(member), 3));
    format!("{wheel} arcmin at the wheel, {pinion} at the pinion")
}

/// `10·4 (right flanks) and 11·4 (left flanks)`.
fn teeth(pose: &ComparedPose) -> Option<String> {
    let found = pose.simulated.proven()?;
    let named = |contact: &gearlash::contact::Contact| {
        format!("{}·{}", contact.wheel.tooth, contact.pinion.tooth)
    };
    let (right, left) = (found.right.as_ref()?, found.left.as_ref()?);
    Some(format!(
        "{} (right flanks) and {} (left flanks)",
        named(right),
        named(left)
    ))
}

/// A distance, mm, to the next ten thousandth up: at one printed lower the pair would interfere.
fn upward(distance: f64) -> f64 {
    (distance * 1e4).ceil() * 1e-4
}

/// The same down: at one printed higher tips would pass each other.
fn downward(distance: f64) -> f64 {
    (distance * 1e4).floor() * 1e-4
}
