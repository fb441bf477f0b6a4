//! What charts show, computed: backlash over the teeth and over the centre distance.
//!
//! In a curve over the teeth each pose stands where its flank passes through the operating pitch point. A
//! right-flank and a left-flank pose of one tooth are two rotations, half a pitch or so apart: the two curves of a
//! gear without pitch deviations are one curve, shifted. Values in µm of `j_wt`, centre distances in mm.

mod binding;
mod course;
mod over_distance;
mod scale;

pub use binding::{Followed, binding, followed};
pub use course::{Course, CourseLine, CoursePoint, Extreme, courses};
pub use over_distance::{
    DistancePoint, OverDistance, Range, over_distance, over_distance_pose_count,
};

use crate::compare::{ComparedRun, compare};
use crate::error::Error;
use crate::gear::Side;
use crate::mesh::Method;
use crate::pair::{Assembly, Mating, Member, SweepPlan};
use crate::simulate::simulate_plans;
use crate::study::{RunPlan, Study};
use std::ops::ControlFlow;

/// Poses a pitch where the study does not sweep itself.
const STEPS_PER_PITCH: u32 = 16;

/// The runs behind curves over the teeth: each centre distance, material and phase.
///
/// Where the study sweeps a revolution, its own poses; else one wheel revolution from wheel tooth 1 on, in the
/// assembly phase of the study's first mating, at 16 steps a pitch. The left-flank poses of the same wheel teeth and
/// fractions follow the right-flank ones, the gears put together alike.
///
/// # Errors
/// As [`crate::simulate::simulate`].
pub fn revolution(
    study: &Study,
    method: Method,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Vec<ComparedRun>, Error> {
    let runs = simulate_plans(study, revolution_plans(study)?, method, tick)?;
    Ok(compare(runs, study.tolerance_um))
}

/// How many poses [`revolution`] will take.
///
/// # Errors
/// As [`Study::runs`].
pub fn revolution_pose_count(study: &Study) -> Result<usize, Error> {
    let plans = revolution_plans(study)?;
    Ok(plans.iter().map(|plan| plan.matings.len()).sum())
}

/// `study` with a sweep over whole revolutions: its own, or else one wheel revolution from wheel
/// tooth 1 on, in the assembly phase of its first mating, at 16 steps a pitch. Unlike a study of measured rows it can be had [`Study::at`] other centre distances.
pub fn swept(mut study: Study) -> Study {
    let sweeps = matches!(
        study.sweep,
        Some(SweepPlan::Revolution { .. } | SweepPlan::Phases { .. })
    );
    if let Some((_, wheel, _)) = study.materials.first()
        && !sweeps
    {
        study.sweep = Some(SweepPlan::Revolution {
            pitches: u64::from(wheel.gear().toothing().teeth()),
            steps_per_pitch: STEPS_PER_PITCH,
            start: from_tooth_1(&study),
        });
    }
    study
}

fn revolution_plans(study: &Study) -> Result<Vec<RunPlan>, Error> {
    let mut plans = swept(study.clone()).runs()?;
    for plan in &mut plans {
        let right = plan.matings.clone();
        let left = right
            .iter()
            .map(|mating| mating.at_flank(&plan.assembly, Side::Left));
        plan.matings.extend(left);
    }
    Ok(plans)
}

/// The mating the study names first.
fn first_mating(study: &Study) -> (u32, u32) {
    let of_sweep = match &study.sweep {
        Some(SweepPlan::Matings { matings, .. }) => matings.first().copied(),
        Some(SweepPlan::Revolution { start, .. }) => Some(*start),
        Some(SweepPlan::Phases { .. }) | None => None,
    };
    let row = study.measured.first();
    let of_row = row.map(|row| (row.wheel_tooth, row.pinion_tooth));
    of_sweep.or(of_row).unwrap_or((1, 1))
}

/// The mating of wheel tooth 1 in the assembly phase of the study's first mating.
fn from_tooth_1(study: &Study) -> (u32, u32) {
    let (wheel_tooth, pinion_tooth) = first_mating(study);
    let mating = Mating {
        wheel_tooth,
        pinion_tooth,
        flank: Side::Right,
        fraction: 0.0,
    };
    let first = study.materials.first().zip(study.center_distances.first());
    let assembly = first.and_then(|((_, wheel, pinion), a)| {
        Assembly::new(wheel.clone(), pinion.clone(), *a, study.locked).ok()
    });
    let Some(assembly) = assembly else {
        return (wheel_tooth, pinion_tooth);
    };
    let start = mating.of_wheel_tooth_1(&assembly);
    (start.wheel_tooth, start.pinion_tooth)
}

fn wheel_teeth(assembly: &Assembly) -> u32 {
    assembly.gear(Member::Wheel).gear().toothing().teeth()
}
