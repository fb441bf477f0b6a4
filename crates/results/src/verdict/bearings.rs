//! What the play of the bearings does to a verdict: the axes pressed together by it, and pulled apart.

use super::coverage::{End, proof};
use super::{amount, each};
use gearlash::analysis::extremes::{BearingEnd, BearingPlay, RunExtreme, RunExtremes, WIDTH};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::Status;
use gearlash_files::numbers::stated_distance;

/// The sentence about it; `None` where no play is stated.
pub(super) fn bearings(verdict: &Verdict) -> Option<String> {
    let played = || verdict.runs.iter().filter_map(|run| run.bearings.as_ref());
    let clearance = stated_distance(played().next()?.clearance);
    let least = verdict.least_pressed();
    let greatest = verdict.greatest_apart();
    let mut parts = Vec::new();
    if played().any(|play| play.pressed.status == Status::Jammed) {
        parts.push("jammed with the axes pressed together".to_owned());
    } else if let Some((run, extreme)) = least {
        let value = value(verdict, run, extreme, |play| &play.pressed);
        let binds = verdict.assembles() == Some(true) && extreme.found() < -WIDTH;
        let binds = if binds { ", where they bind" } else { "" };
        parts.push(format!(
            "least {value} with the axes pressed together{binds}"
        ));
    }
    if played().any(|play| play.apart.status == Status::NoContact) {
        parts.push("out of mesh with them apart".to_owned());
    } else if let Some((run, extreme)) = greatest {
        let value = value(verdict, run, extreme, |play| &play.apart);
        parts.push(format!("greatest {value} with them apart"));
    }
    let pressed: Vec<&RunExtreme> = played()
        .filter_map(|play| play.pressed.extreme.as_ref())
        .collect();
    let apart: Vec<&RunExtreme> = played()
        .filter_map(|play| play.apart.extreme.as_ref())
        .collect();
    let proof = match pressed.is_empty() && apart.is_empty() {
        true => String::new(),
        false => format!(
            ", {}",
            proof(&[End::of(true, pressed), End::of(false, apart)])
        ),
    };
    Some(format!(
        "With the bearing clearance (a ± {clearance} mm): {}{proof}.",
        parts.join("; ")
    ))
}

/// An extreme with the distance at which the axes stand then, where several could be meant.
fn value(
    verdict: &Verdict,
    run: &RunExtremes,
    extreme: &RunExtreme,
    end: impl Fn(&BearingPlay) -> &BearingEnd,
) -> String {
    let distances = verdict
        .runs
        .iter()
        .map(|run| run.assembly.center_distance());
    let several = each(distances).len() > 1;
    let at = run.bearings.as_ref().filter(|_| several).map(end);
    let at = at.map(|end| stated_distance(end.assembly.center_distance()));
    let at = at.map_or(String::new(), |at| format!(" at a = {at} mm"));
    format!("{}{at}", amount(verdict, &extreme.assembly, extreme))
}
