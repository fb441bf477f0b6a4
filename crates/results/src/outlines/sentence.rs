//! The verdict on a pair of outlines, in the same lines as that on gears by their data.

use crate::verdict::{ExtremeRow, Place, State, VerdictLines, limit, lost_motion, status, value};
use gearlash::analysis::diagnosis::Verdict;
use gearlash::analysis::outlines::{OutlinePose, OutlineRun, OutlineStudy, turns, unproven};
use gearlash::analysis::study::Material;
use gearlash::analysis::verdict::Requirement;
use gearlash::contact::{OutlineContact, Status};
use gearlash_files::numbers::{fixed, stated_distance};

/// The verdict of `runs` in lines: whether the pair turns, its least and greatest backlash, and from which centre distance it turns.
pub fn lines(study: &OutlineStudy, runs: &[OutlineRun]) -> VerdictLines {
    if runs.is_empty() {
        return VerdictLines::nothing();
    }
    let places: Vec<Place> = runs.iter().map(place).collect();
    let best = |pose: fn(&OutlineRun) -> &Option<OutlinePose>, sign: f64| {
        let each = runs.iter().filter_map(|run| {
            let pose = pose(run).as_ref()?;
            Some((run, pose, sign * pose.j_wt?.0))
        });
        each.min_by(|one, other| one.2.total_cmp(&other.2))
    };
    let least = best(|run| &run.least, 1.0);
    let greatest = best(|run| &run.greatest, -1.0);
    let rows = [("least", least), ("greatest", greatest)];
    let rows = rows
        .into_iter()
        .filter_map(|(name, found)| row(study, runs, name, found?.0, found?.1));
    let state = match (turns(runs), study.requirement(runs)) {
        (Some(false), _) | (_, Requirement::NotMet) => Verdict::Fail,
        (None, _) | (_, Requirement::NotProven) => Verdict::Unproven,
        (Some(true), _) if unproven(runs) > 0 => Verdict::Unproven,
        (Some(true), _) => Verdict::Pass,
    };
    VerdictLines::new(
        state,
        &status(&places),
        &proof(runs),
        rows.collect(),
        sentences(study, runs),
    )
}

fn place(run: &OutlineRun) -> Place {
    Place {
        distance: run.pair.center_distance(),
        material: run.material,
        phase: None,
        state: match run.turns() {
            Some(true) => State::Assembles,
            Some(false) if run.count(Status::Jammed) > 0 => State::Jammed,
            Some(false) => State::Interferes,
            None if run.count(Status::NoContact) > 0 => State::OutOfMesh,
            None => State::NotProven,
        },
    }
}

/// How many poses are proven, in full and shorter.
fn proof(runs: &[OutlineRun]) -> Vec<String> {
    let poses = runs.iter().map(|run| run.poses.len()).sum::<usize>();
    let matings = runs.first().map_or(0, |run| run.matings);
    match unproven(runs) {
        0 => vec![
            format!("Proven at {poses} poses of {matings} matings, not between them."),
            format!("Proven at {poses} poses, not between them."),
            "Proven at poses.".to_owned(),
        ],
        open => vec![
            format!("{open} of {poses} poses are not proven."),
            "Not proven.".to_owned(),
        ],
    }
}

/// What qualifies the extremes, the most important first.
fn sentences(study: &OutlineStudy, runs: &[OutlineRun]) -> Vec<String> {
    let mut sentences = Vec::new();
    let binding: Vec<&OutlineRun> = runs
        .iter()
        .filter(|run| run.turns() == Some(false))
        .collect();
    if !binding.is_empty() {
        let from = binding.iter().map(|run| run.turns_from.as_ref());
        let from = from.collect::<Option<Vec<_>>>();
        let from = from.and_then(|each| each.iter().map(|from| from.rounded()).reduce(f64::max));
        sentences.push(match from {
            Some(from) => format!("Assembles from a = {} mm", fixed(from, 4)),
            None => "No centre distance in mesh is known at which it assembles".to_owned(),
        });
    }
    let jammed = binding.iter().find_map(|run| {
        let lost = run
            .lost
            .as_ref()
            .filter(|pose| pose.status() == Status::Jammed)?;
        (run.count(Status::Jammed) < run.poses.len()).then_some(lost.mating)
    });
    sentences.extend(jammed.map(|mating| {
        format!(
            "Jammed at teeth {}·{}",
            mating.wheel_tooth, mating.pinion_tooth
        )
    }));
    sentences.extend(study.unmet(runs).iter().map(limit));
    if runs
        .iter()
        .flat_map(|run| [&run.least, &run.greatest])
        .flatten()
        .any(|pose| off(pose).is_some())
    {
        sentences.push("± is what the drawings leave open".to_owned());
    }
    if study.requirement(runs) == Requirement::Met {
        sentences.push("Requirement met".to_owned());
    }
    sentences
}

fn row(
    study: &OutlineStudy,
    runs: &[OutlineRun],
    name: &'static str,
    run: &OutlineRun,
    pose: &OutlinePose,
) -> Option<ExtremeRow> {
    let found = pose.found.as_ref().ok()?;
    let (j_wt, _) = pose.j_wt?;
    let (right, left) = (found.right.as_ref()?, found.left.as_ref()?);
    let teeth =
        [right, left].map(|contact| format!("{}·{}", contact.wheel.tooth, contact.pinion.tooth));
    let curves = [right, left].map(region_words);
    let distance = run.pair.center_distance();
    let several = runs
        .iter()
        .any(|other| other.pair.center_distance() != distance);
    Some(ExtremeRow {
        name,
        value: value(j_wt, off(pose)),
        arcmin: study.lost_motion_of().map(|member| {
            let radius = run.pair.operating_pitch_radius(member);
            (lost_motion(j_wt / radius), member)
        }),
        teeth: Some(teeth.join(" / ")),
        curves: Some(match curves[0] == curves[1] {
            true => curves[0].clone(),
            false => curves.join(" / "),
        }),
        distance: several.then(|| stated_distance(distance)),
        material: (run.material != Material::AsMeasured).then_some(run.material),
        ..ExtremeRow::default()
    })
}

/// What the drawings leave open of a backlash, mm; `None` where it is rounding alone.
fn off(pose: &OutlinePose) -> Option<f64> {
    let (_, error) = pose.j_wt?;
    (error >= 5e-6).then_some(error)
}

/// What touches: `tip on flank`, the wheel's first.
pub fn region_words(contact: &OutlineContact) -> String {
    format!(
        "{} on {}",
        contact.wheel.curve.name(),
        contact.pinion.curve.name()
    )
}
