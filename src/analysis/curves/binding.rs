//! The poses to follow over the centre distance.

use super::first_mating;
use crate::analysis::compare::ComparedRun;
use crate::analysis::study::Study;
use crate::contact::first_least;
use crate::gear::Side;
use crate::pair::Mating;

/// Subject of a curve over the centre distance.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Followed {
    /// Wheel and pinion tooth: the mean of their right-flank and their left-flank pose at the pitch point.
    Teeth(u32, u32),
    /// One pose.
    Pose(Mating),
}

/// The pose with the least backlash of all `runs`, or its teeth if it is at most half a pitch past a measured mating.
/// Without any value it is the study's first mating.
pub fn binding<'a>(study: &Study, runs: impl Iterator<Item = &'a ComparedRun> + Clone) -> Followed {
    let poses = runs.flat_map(|run| run.poses.iter().map(move |pose| (run, pose)));
    let known = poses.filter_map(|(run, pose)| {
        let result = &pose.simulated;
        Some((
            (run, result.pose.mating()),
            result.backlash?,
            result.error_bound?,
        ))
    });
    let Some((run, mating)) = first_least(known) else {
        let (wheel, pinion) = first_mating(study);
        return Followed::Teeth(wheel, pinion);
    };
    let whole = Mating {
        fraction: 0.0,
        ..*mating
    };
    let assembly = &run.run.assembly;
    let nearest = whole
        .onward(assembly, mating.fraction.round())
        .at_flank(assembly, Side::Right);
    let teeth = (nearest.wheel_tooth, nearest.pinion_tooth);
    let mut measured = study.measured.iter();
    if measured.any(|row| (row.wheel_tooth, row.pinion_tooth) == teeth) {
        Followed::Teeth(teeth.0, teeth.1)
    } else {
        Followed::Pose(*mating)
    }
}

/// `binding`, then the measured matings in the order of their file.
pub fn followed(study: &Study, binding: Followed) -> Vec<Followed> {
    let measured = measured_teeth(study).into_iter();
    let others = measured.filter(|teeth| *teeth != binding);
    std::iter::once(binding).chain(others).collect()
}

/// The measured matings, each once, in the order of their file.
pub fn measured_teeth(study: &Study) -> Vec<Followed> {
    let mut measured = Vec::new();
    for row in &study.measured {
        let teeth = Followed::Teeth(row.wheel_tooth, row.pinion_tooth);
        if !measured.contains(&teeth) {
            measured.push(teeth);
        }
    }
    measured
}
