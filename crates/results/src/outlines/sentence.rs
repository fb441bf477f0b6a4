//! The verdict of a pair of outlines in one sentence.

use crate::verdict::not_met;
use gearlash::analysis::outlines::{OutlinePose, OutlineRun, OutlineStudy, unproven, worst};
use gearlash::analysis::study::Material;
use gearlash::analysis::verdict::Requirement;
use gearlash::contact::{OutlineContact, Status};
use gearlash::pair::{Member, arcmin};
use gearlash_files::numbers::{fixed, stated_distance, um};

/// Decimals of a backlash in µm.
const DECIMALS: usize = 2;

/// What the runs say: whether the pair turns, where it binds and from which centre distance on it turns freely.
pub fn sentence(study: &OutlineStudy, runs: &[OutlineRun]) -> String {
    let several = runs.len() > 1;
    let each: Vec<String> = runs.iter().map(|run| of_run(run, several)).collect();
    each.join(" ") + &required(study, runs) + &scope(runs)
}

/// The same in no more words than of one run: of several how many turn, and what is said of the tightest.
pub fn summary(study: &OutlineStudy, runs: &[OutlineRun]) -> String {
    let Some((run, _)) = worst(runs).filter(|_| runs.len() > 1) else {
        return sentence(study, runs);
    };
    let turning = runs.iter().filter(|run| run.turns() == Some(true)).count();
    let materials = runs.iter().any(|run| run.material != Material::AsMeasured);
    format!(
        "Turns freely at {} {} centre distances{}. The tightest: {}{}{}",
        match turning {
            0 => "none of".to_owned(),
            all if all == runs.len() => "all".to_owned(),
            some => format!("{some} of"),
        },
        runs.len(),
        if materials { " and materials" } else { "" },
        of_run(run, true),
        required(study, runs),
        scope(runs)
    )
}

/// Whether what is required is kept; empty where nothing is.
fn required(study: &OutlineStudy, runs: &[OutlineRun]) -> String {
    match study.requirement(runs) {
        Requirement::None => String::new(),
        Requirement::Met => " At the poses looked at the pair meets its requirement.".to_owned(),
        Requirement::NotMet => format!(" The pair {}.", not_met(&study.unmet(runs))),
    }
}

/// Of how many poses it is said, and how surely.
fn scope(runs: &[OutlineRun]) -> String {
    let Some(run) = runs.first() else {
        return "Nothing was run.".to_owned();
    };
    let poses = runs.iter().map(|run| run.poses.len()).sum::<usize>();
    let proven = match unproven(runs) {
        0 if run.certified => {
            "each pose is proven and checked by polygons, and nothing between poses".to_owned()
        }
        0 => "each pose is proven, and nothing between poses".to_owned(),
        open => {
            format!("{open} of them are not, the others proven, and nothing between poses")
        }
    };
    let matings = run.matings;
    format!(" Over all {matings} matings, {poses} sampled poses: {proven}.")
}

fn of_run(run: &OutlineRun, several: bool) -> String {
    let how = match run.turns() {
        Some(true) => "Turns freely",
        Some(false) if run.count(Status::Jammed) == run.poses.len() => "Jammed",
        Some(false) => "Binds",
        None if run.count(Status::NoContact) > 0 => "Out of mesh",
        None => "Not known to turn",
    };
    let mut text = format!(
        "{how} at a = {} mm",
        stated_distance(run.pair.center_distance())
    );
    if several && run.material != Material::AsMeasured {
        text += &format!(" with {}", run.material.words());
    }
    let mut parts = Vec::new();
    for (name, pose) in [("least", &run.least), ("greatest", &run.greatest)] {
        if let Some(words) = pose.as_ref().and_then(|pose| value(run, pose)) {
            parts.push(format!("{name} {words}"));
        }
    }
    let all_jammed = run.count(Status::Jammed) == run.poses.len();
    if let Some(jammed) = run
        .lost
        .as_ref()
        .filter(|pose| pose.status() == Status::Jammed && !all_jammed)
    {
        parts.push(format!(
            "jammed where wheel tooth {} and pinion tooth {} mate",
            jammed.mating.wheel_tooth, jammed.mating.pinion_tooth
        ));
    }
    if run.turns() == Some(false) {
        parts.push(match &run.turns_from {
            Some(from) => format!("turns freely from a = {} mm on", fixed(from.rounded(), 4)),
            None => "no centre distance in mesh is known from which it turns freely".to_owned(),
        });
    }
    match parts.is_empty() {
        true => text + ".",
        false => format!("{text}: {}.", parts.join("; ")),
    }
}

fn value(run: &OutlineRun, pose: &OutlinePose) -> Option<String> {
    let found = pose.found.as_ref().ok()?;
    let (j_wt, error) = pose.j_wt?;
    let at = |member| fixed(arcmin(j_wt / run.pair.operating_pitch_radius(member)), 3);
    // What a drawing says no more closely is said; rounding is not.
    let off = match error >= 5e-6 {
        true => format!(" ± {}", um(error, DECIMALS)),
        false => String::new(),
    };
    let named = |contact: &OutlineContact| {
        format!(
            "{}·{} ({})",
            contact.wheel.tooth,
            contact.pinion.tooth,
            region_words(contact)
        )
    };
    Some(format!(
        "j_wt {}{off} µm ({} arcmin at the wheel, {} at the pinion) at teeth {} on right flanks and {} on left flanks",
        um(j_wt, DECIMALS),
        at(Member::Wheel),
        at(Member::Pinion),
        named(found.right.as_ref()?),
        named(found.left.as_ref()?)
    ))
}

/// What touches: `tip on flank`, the wheel's first.
pub fn region_words(contact: &OutlineContact) -> String {
    format!(
        "{} on {}",
        contact.wheel.curve.name(),
        contact.pinion.curve.name()
    )
}
