//! Backlash of one mating over the centre distance.

use super::first_mating;
use crate::compare::compare;
use crate::error::Error;
use crate::gear::Side;
use crate::measured::{Bands, bands};
use crate::mesh::{Method, Status};
use crate::pair::{Assembly, Mating};
use crate::simulate::simulate_plans;
use crate::study::{MeasuredRow, RunPlan, Study};
use std::ops::ControlFlow;

/// Steps over the range of centre distances.
const STEPS: u32 = 40;
/// Room beside the listed distances, as a part of their range.
const MARGIN: f64 = 0.1;
/// Range on each side of a single distance, modules: some 40 µm of backlash a side at 20°.
const AROUND: f64 = 0.02;

/// One mating's backlash over the centre distance.
#[derive(Debug, Clone, PartialEq)]
pub struct OverDistance {
    /// Wheel and pinion tooth.
    pub mating: (u32, u32),
    /// Radial clearance `c` of both bearings together, mm.
    pub clearance: f64,
    /// Whether the bands have two ends: most and least material.
    pub two_materials: bool,
    /// In ascending order of centre distance.
    pub points: Vec<DistancePoint>,
    /// The measured rows of the mating, in the order of their file.
    pub measured: Vec<MeasuredRow>,
    /// With [`Method::Both`]: the largest difference between the two methods, mm.
    pub polygon_difference: Option<f64>,
}

/// The bands at one centre distance, from most to least material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DistancePoint {
    /// `a`, mm.
    pub center_distance: f64,
    /// Means of the right-flank and the left-flank pose.
    pub bands: Bands,
    /// How the first pose without a value ended, where the simulated band has none.
    pub gap: Option<Status>,
}

/// `mating` (of the study's first, where `None`) over a grid of centre distances round the study's.
///
/// # Errors
/// [`Error::Usage`] for a tooth that is not there; else as [`crate::simulate::simulate`].
pub fn over_distance(
    study: &Study,
    mating: Option<(u32, u32)>,
    method: Method,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<OverDistance, Error> {
    let mating = mating.unwrap_or_else(|| first_mating(study));
    let distances = grid(study);
    let mut plans = Vec::new();
    for &a in &distances {
        for (material, wheel, pinion) in &study.materials {
            let assembly = Assembly::new(wheel.clone(), pinion.clone(), a, study.locked)?;
            for (gear, tooth) in [(wheel, mating.0), (pinion, mating.1)] {
                let teeth = gear.gear().toothing().teeth();
                if !(1..=teeth).contains(&tooth) {
                    return Err(Error::Usage(format!(
                        "--mating {},{}: the gear has teeth 1 … {teeth}, not {tooth}",
                        mating.0, mating.1
                    )));
                }
            }
            plans.push(RunPlan {
                material: *material,
                assembly,
                phase: None,
                matings: Side::BOTH
                    .map(|flank| Mating {
                        wheel_tooth: mating.0,
                        pinion_tooth: mating.1,
                        flank,
                        fraction: 0.0,
                    })
                    .to_vec(),
            });
        }
    }
    let runs = compare(
        simulate_plans(study, plans, method, tick)?,
        study.tolerance_um,
    );
    let gap = |a: f64| {
        let here = runs
            .iter()
            .filter(|run| run.run.assembly.center_distance() == a);
        let mut poses = here.flat_map(|run| &run.poses);
        let without = poses.find(|pose| pose.swept.backlash.is_none())?;
        Some(without.swept.lost_motion.status())
    };
    let point = |&a: &f64| DistancePoint {
        center_distance: a,
        bands: bands(study, &runs, a, mating),
        gap: gap(a),
    };
    let poses = runs.iter().flat_map(|run| &run.poses);
    let differences = poses.filter_map(|pose| pose.swept.polygon_difference);
    let of_mating = |row: &&MeasuredRow| (row.wheel_tooth, row.pinion_tooth) == mating;
    Ok(OverDistance {
        mating,
        clearance: study.bearing_clearance,
        polygon_difference: differences.map(f64::abs).reduce(f64::max),
        two_materials: study.materials.len() > 1,
        points: distances.iter().map(point).collect(),
        measured: study.measured.iter().filter(of_mating).cloned().collect(),
    })
}

/// How many poses [`over_distance`] will take.
pub fn over_distance_pose_count(study: &Study) -> usize {
    2 * grid(study).len() * study.materials.len()
}

/// Centre distances round the study's, none so near that base circles overlap at `a − c`.
fn grid(study: &Study) -> Vec<f64> {
    let Some((_, wheel, pinion)) = study.materials.first() else {
        return Vec::new();
    };
    let all = || study.center_distances.iter().copied();
    let (Some(first), Some(last)) = (all().reduce(f64::min), all().reduce(f64::max)) else {
        return Vec::new();
    };
    let module = wheel.gear().toothing().module();
    let margin = match last > first {
        true => MARGIN * (last - first),
        false => AROUND * module,
    };
    let touching = wheel.gear().base_radius() + pinion.gear().base_radius();
    let possible = |a: &f64| a - study.bearing_clearance > touching;
    let (from, to) = (first - margin, last + margin);
    let step = (to - from) / f64::from(STEPS);
    let grid = (0..=STEPS).map(|i| from + f64::from(i) * step);
    grid.filter(possible).collect()
}
