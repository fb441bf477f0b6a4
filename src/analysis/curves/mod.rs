//! Data of charts: backlash over the teeth and over the centre distance.
//!
//! In a curve over the teeth each pose is at the place where its flank passes through the operating pitch point. A
//! right-flank and a left-flank pose of one tooth are two rotations, about half a pitch apart. So without pitch
//! deviations the two curves of a gear are one curve, shifted. Values in µm of `j_wt`, centre distances in mm.

mod course;
mod field;
mod over_distance;
mod refined;

pub use course::{Course, CourseLine, CoursePoint, Extreme, courses};
pub use field::{
    BindingContact, ContactLine, Field, FieldSection, FieldSide, PathLimit, STRETCH_END,
};
pub use over_distance::{
    DistancePoint, Followed, OverDistance, binding, followed, measured_teeth, over_distance,
    over_distance_pose_count,
};
pub use refined::refined;

use crate::analysis::compare::ComparedRun;
use crate::analysis::simulate::{simulate, simulate_plans};
use crate::analysis::study::Study;
use crate::contact::Method;
use crate::error::{Error, Tick};
use crate::gear::Side;
use crate::pair::{Mating, SweepPlan};

/// Poses per pitch if the study has no sweep.
const STEPS_PER_PITCH: u32 = 16;

/// The runs of curves over the teeth: each centre distance, material and phase.
///
/// They are the study's own poses if it sweeps a revolution. Otherwise they are one wheel revolution from wheel tooth
/// 1, in the assembly phase of the study's first mating, at 16 steps per pitch. The left-flank poses of the same wheel
/// teeth and fractions follow the right-flank ones, in the same assembly phase.
///
/// # Errors
/// As [`crate::analysis::simulate::simulate`].
pub fn revolution(study: &Study, method: Method, tick: &Tick) -> Result<Vec<ComparedRun>, Error> {
    let study = with_sweep(study.clone());
    let right = simulate(&study, method, tick)?;
    with_left_flanks(&study, right, method, tick)
}

/// The study's own runs, and [`revolution`]. If the study sweeps, its poses are simulated once for both.
///
/// # Errors
/// As [`crate::analysis::simulate::simulate`].
pub fn with_revolution(
    study: &Study,
    method: Method,
    tick: &Tick,
) -> Result<[Vec<ComparedRun>; 2], Error> {
    let own = simulate(study, method, tick)?;
    let turned = if study.sweeps() {
        with_left_flanks(study, own.clone(), method, tick)?
    } else {
        revolution(study, method, tick)?
    };
    Ok([own, turned])
}

/// The right-flank `runs` of a `study` that sweeps, each followed by the left-flank poses of the same wheel teeth and
/// fractions in the same assembly phase.
fn with_left_flanks(
    study: &Study,
    mut runs: Vec<ComparedRun>,
    method: Method,
    tick: &Tick,
) -> Result<Vec<ComparedRun>, Error> {
    // Formulas alone distinguish right and left flanks.
    let mut poses = runs.iter().flat_map(|run| &run.poses);
    if poses.all(|pose| pose.involute.is_none()) {
        return Ok(runs);
    }
    let mut plans = study.runs()?;
    for plan in &mut plans {
        for mating in &mut plan.matings {
            *mating = mating.at_flank(&plan.run.assembly, Side::Left);
        }
    }
    let left = simulate_plans(study, plans, method, tick)?;
    for (run, left) in runs.iter_mut().zip(left) {
        run.poses.extend(left.poses);
    }
    Ok(runs)
}

/// Number of poses of [`with_revolution`].
pub fn with_revolution_pose_count(study: &Study) -> u64 {
    let turned = 2 * with_sweep(study.clone()).pose_count();
    if study.sweeps() {
        turned
    } else {
        study.pose_count() + turned
    }
}

/// `study` with a sweep over whole revolutions: its own, or one wheel revolution from wheel tooth 1, in the assembly phase of its first
/// mating, at 16 steps per pitch. Unlike a study of measured rows it can be moved to other centre distances ([`Study::at`]).
pub fn with_sweep(mut study: Study) -> Study {
    if !study.sweeps() {
        study.sweep = Some(SweepPlan::Revolution {
            pitches: u64::from(study.teeth()[0]),
            steps_per_pitch: STEPS_PER_PITCH,
            start: from_tooth_1(&study),
        });
    }
    study
}

/// The first mating of the study.
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
    let (wheel, pinion) = first_mating(study);
    let Some(assembly) = study.first_pairs().next() else {
        return (wheel, pinion);
    };
    let start = Mating::at(wheel, pinion, Side::Right).of_wheel_tooth_1(&assembly);
    (start.wheel_tooth, start.pinion_tooth)
}
