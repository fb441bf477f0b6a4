//! The pose with the least backlash of the whole mesh cycle: what `snapshot --worst` and `chart --kind field` draw.

use super::console::tell_verdict;
use super::verdict;
use crate::error::Error;
use gearlash::analysis::simulate::Run;
use gearlash::analysis::study::{Material, Study};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::PoseResult;
use gearlash_files::distance_refused;
use gearlash_results::verdict::lines;

/// Finds the extremes of `study`'s mesh cycle, at `distance` and with `material` alone where they are given; says the verdict on standard
/// error, and returns the worst pose (asked for by the option `asked`): jammed, or with the least backlash. Its run comes with it, and how many extremes are not proven.
pub(super) fn find(
    asked: &str,
    study: Study,
    distance: Option<f64>,
    material: Option<Material>,
) -> Result<(Run, PoseResult, usize), Error> {
    let study = narrowed(asked, study, distance, material)?;
    let (found, failed) = verdict::extremes_and_failed_checks(&study)?;
    let verdict = Verdict::of_study(&study, &found.each, failed);
    tell_verdict(&lines(&verdict));
    let Some((run, assembly, pose)) = verdict.worst() else {
        return Err(Error::Usage(format!(
            "{asked}: no pose is in mesh; nothing can be called the worst"
        )));
    };
    let unproven = found.runs.iter().map(|run| run.unproven().count()).sum();
    let run = Run {
        material: run.material,
        assembly: assembly.clone(),
        phase: run.phase,
        poses: Vec::new(),
    };
    Ok((run, pose.simulated.clone(), unproven))
}

fn narrowed(
    asked: &str,
    mut study: Study,
    distance: Option<f64>,
    material: Option<Material>,
) -> Result<Study, Error> {
    if let Some(material) = material {
        study.materials.retain(|gears| gears.0 == material);
    }
    let Some(distance) = distance else {
        return match study.center_distances.is_empty() {
            true => Err(Error::Usage(format!(
                "{asked}: the pair file has no centre distance; give one with --center-distance"
            ))),
            false => Ok(study),
        };
    };
    // Measured rows are run at their own distances.
    if study.sweep.is_none() && study.center_distances.contains(&distance) {
        study.center_distances = vec![distance];
        return Ok(study);
    }
    let moved = study.at(vec![distance]);
    moved.map_err(|reason| {
        let reason = distance_refused(&reason);
        Error::Usage(format!("--center-distance {distance}: {reason}"))
    })
}
