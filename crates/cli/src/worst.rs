//! The pose with the least backlash of all a pair file asks for: what `snapshot --worst` and `simulate` draw.

use super::console::tell;
use super::progress::Progress;
use crate::error::Error;
use gearlash::analysis::simulate::{Run, each_block};
use gearlash::analysis::study::{Material, Study};
use gearlash::analytic::evaluate;
use gearlash::contact::{FirstLeast, Method, PoseResult, Status};
use gearlash::pair::GearPair;

/// A pose and the run it belongs to.
pub(super) type PoseOfRun = (Run, PoseResult);

/// Looks for the worst of the poses that come by: the first that is jammed, else the first that cannot be told from the least.
///
/// Those that are not proven are left out; only where no other is in mesh the first of them is the worst.
#[derive(Default)]
pub(super) struct Worst {
    /// Poses that are not proven, an end of the bearing clearance included.
    unproven: usize,
    /// Poses of which no backlash is proven. Of one that is proven but for an end of the bearing clearance the picture is
    /// right all the same.
    left_out: usize,
    first_unproven: Option<PoseOfRun>,
    jammed: Option<PoseOfRun>,
    least: FirstLeast<PoseOfRun>,
}

impl Worst {
    /// Takes the next pose in.
    pub(super) fn add(
        &mut self,
        (material, assembly, phase): (Material, &GearPair, Option<(u32, u32)>),
        pose: &PoseResult,
    ) {
        let found = || {
            let run = Run {
                material,
                assembly: assembly.clone(),
                phase,
                poses: Vec::new(),
            };
            (run, pose.clone())
        };
        self.unproven += usize::from(pose.is_unproven());
        if pose.found.is_err() {
            self.left_out += 1;
            self.first_unproven.get_or_insert_with(found);
        } else if pose.status() == Status::Jammed {
            self.jammed.get_or_insert_with(found);
        } else if let (Some(backlash), Some(bound)) = (pose.backlash, pose.error_bound) {
            self.least.add(backlash, bound, found);
        }
    }

    /// The worst of all so far; `None` where none is in mesh.
    pub(super) fn pose(&self) -> Option<&PoseOfRun> {
        let proven = self.jammed.as_ref().or(self.least.first());
        proven.or(self.first_unproven.as_ref())
    }
}

/// Runs `study` at `distance` and with `material` alone where they are given, says on standard error which
/// pose is the [`Worst`], and returns it alone in its run, with the number of poses that are not proven.
pub(super) fn find(
    study: Study,
    distance: Option<f64>,
    material: Option<Material>,
) -> Result<(Run, PoseResult, usize), Error> {
    let study = narrowed(study, distance, material)?;
    let poses = study.pose_count();
    let progress = Progress::start(poses);
    let method = Method::Exact { certify: true };
    let mut worst = Worst::default();
    let tick = || progress.tick();
    each_block::<Error>(&study, study.runs()?, method, &tick, &mut |block| {
        for pose in &block.poses {
            worst.add((block.material, block.assembly, block.phase), pose);
        }
        Ok(())
    })?;
    drop(progress);
    let left_out = worst.left_out;
    if let Some((run, pose)) = &worst.first_unproven {
        tell(&format!(
            "{left_out} of {poses} poses unproven and left out, though one of them may be the worst; the first: {}",
            in_words(run, pose)
        ));
    }
    let Some((run, pose)) = worst.pose() else {
        return Err(Error::Usage(format!(
            "--worst: none of the {poses} poses is in mesh; nothing can be called the worst"
        )));
    };
    if pose.found.is_ok() {
        let compared = poses - left_out as u64;
        tell(&format!(
            "worst of {compared} poses: {}",
            in_words(run, pose)
        ));
    }
    Ok((run.clone(), pose.clone(), worst.unproven))
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
