//! `snapshot --worst`: the pose with the least backlash of all a pair file asks for.

use super::console::tell;
use super::progress::Progress;
use crate::error::Error;
use gearlash::analysis::simulate::{Run, each_block};
use gearlash::analysis::study::{Material, Study};
use gearlash::analytic::evaluate;
use gearlash::contact::{FirstLeast, Method, PoseResult, Status};

/// Runs `study` at `distance` and with `material` alone where they are given, says on standard error which
/// pose is the worst, and returns it alone in its run, with the number of poses that are not proven. Those are left
/// out, and told; only where no other is in mesh the first of them is returned.
pub(super) fn find(
    study: Study,
    distance: Option<f64>,
    material: Option<Material>,
) -> Result<(Run, PoseResult, usize), Error> {
    let study = narrowed(study, distance, material)?;
    let poses = study.pose_count();
    let progress = Progress::start(poses);
    let method = Method::Exact { certify: true };
    // Of a pose that is proven but for an end of the bearing clearance the picture is right all the same.
    let (mut unproven, mut left_out) = (0, 0);
    let (mut jammed, mut first_unproven) = (None, None);
    let mut least = FirstLeast::default();
    let tick = || progress.tick();
    each_block::<Error>(&study, study.runs()?, method, &tick, &mut |block| {
        for pose in &block.poses {
            let found = || {
                let run = Run {
                    material: block.material,
                    assembly: block.assembly.clone(),
                    phase: block.phase,
                    poses: Vec::new(),
                };
                (run, pose.clone())
            };
            unproven += usize::from(pose.is_unproven());
            if pose.found.is_err() {
                left_out += 1;
                first_unproven.get_or_insert_with(found);
            } else if pose.status() == Status::Jammed {
                jammed.get_or_insert_with(found);
            } else if let (Some(backlash), Some(bound)) = (pose.backlash, pose.error_bound) {
                least.add(backlash, bound, found);
            }
        }
        Ok(())
    })?;
    drop(progress);
    if let Some((run, pose)) = &first_unproven {
        tell(&format!(
            "{left_out} of {poses} poses unproven and left out, though one of them may be the worst; the first: {}",
            in_words(run, pose)
        ));
    }
    let worst = jammed.as_ref().or(least.first());
    let Some((run, pose)) = worst.or(first_unproven.as_ref()) else {
        return Err(Error::Usage(format!(
            "--worst: none of the {poses} poses is in mesh; nothing can be called the worst"
        )));
    };
    if pose.found.is_ok() {
        let compared = poses - left_out;
        tell(&format!(
            "worst of {compared} poses: {}",
            in_words(run, pose)
        ));
    }
    Ok((run.clone(), pose.clone(), unproven))
}

fn narrowed(
    mut study: Study,
    distance: Option<f64>,
    material: Option<Material>,
) -> Result<Study, Error> {
    if let Some(material) = material {
        study.materials.retain(|gears| gears.0 == material);
    }
    let Some(distance) = distance else {
        return match study.center_distances.is_empty() {
            true => Err(Error::Usage(
                "--worst: the pair file has no centre distance; give one with --center-distance"
                    .to_owned(),
            )),
            false => Ok(study),
        };
    };
    // Measured rows are run at their own distances.
    if study.sweep.is_none() && study.center_distances.contains(&distance) {
        study.center_distances = vec![distance];
        return Ok(study);
    }
    let moved = study.at(vec![distance]);
    moved.map_err(|reason| Error::Usage(format!("--center-distance {distance}: {reason}")))
}

fn in_words(run: &Run, pose: &PoseResult) -> String {
    let mating = pose.pose.mating();
    let beyond = match mating.fraction {
        0.0 => String::new(),
        fraction => format!(" {fraction:+} pitch"),
    };
    let um = |length: f64| format!("{:.3} µm", length * 1e3);
    let found = match (&pose.found, pose.backlash) {
        (Err(unproven), _) => format!("unproven: {}", unproven.reason),
        (Ok(_), None) => "jammed, a tip sits in a root".to_owned(),
        (Ok(_), Some(backlash)) => {
            let formula = evaluate(&run.assembly, &pose.pose).line_of_action;
            match formula.backlash(&run.assembly) {
                Some(formula) => format!(
                    "j_wt = {} (line of action: {}, lost to other contact: {})",
                    um(backlash),
                    um(formula),
                    // Rounding of two equal results is no loss.
                    um(if formula - backlash < 1e-9 {
                        0.0
                    } else {
                        formula - backlash
                    })
                ),
                None => format!("j_wt = {} (no involute contact)", um(backlash)),
            }
        }
    };
    format!(
        "wheel {} – pinion {} at {} flank{beyond}, centre distance {} mm, material {}: {found}",
        mating.wheel_tooth,
        mating.pinion_tooth,
        mating.flank.name(),
        run.assembly.center_distance(),
        run.material.name()
    )
}
