//! Backlash of a pose or a mating over the centre distance.

use super::first_mating;
use crate::analysis::compare::ComparedRun;
use crate::analysis::extremes::RunExtremes;
use crate::analysis::measured::{Bands, bands};
use crate::analysis::requirement::Requirements;
use crate::analysis::simulate::simulate_plans;
use crate::analysis::study::{MeasuredRow, Run, RunPlan, Study};
use crate::contact::{Method, MethodAgreement, Status, first_least};
use crate::error::{Error, GearError, Tick};
use crate::gear::Side;
use crate::outline::AssembledPair;
use crate::pair::{Mating, Member};

/// Steps over the range of centre distances.
const STEPS: u32 = 40;
/// Margin beside the listed distances, as a part of their range.
const MARGIN: f64 = 0.1;
/// Range on each side of a single distance, modules: at 20° 15 µm of backlash per mm of module.
const AROUND: f64 = 0.02;

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

/// Backlash of one or two poses over the centre distance.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OverDistance {
    /// Subject of the curve.
    pub followed: Followed,
    /// Its poses, whose mean is the curve. Poses of two teeth have one assembly phase. A measured mating has the same
    /// teeth at both flanks, as in the file.
    pub matings: Vec<Mating>,
    /// Radial clearance `c` of both bearings together, mm.
    pub clearance: f64,
    /// Whether the bands have two ends: most and least material.
    pub two_materials: bool,
    /// For a pair that does not assemble at a stated distance: the distance from which it does, mm. The curve reaches it.
    pub assembles_from: Option<f64>,
    /// In ascending order of centre distance.
    pub points: Vec<DistancePoint>,
    /// The measured rows of the teeth, in the order of their file.
    pub measured: Vec<MeasuredRow>,
    /// The requirements on the pair.
    pub required: Requirements,
    /// With [`Method::Both`]: agreement of the two methods.
    pub agreement: MethodAgreement,
    /// Number of unproven poses, including the ends of the bearing clearance. The bands have gaps there.
    pub unproven: usize,
}

/// The bands at one centre distance, from most to least material.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct DistancePoint {
    /// `a`, mm.
    pub center_distance: f64,
    /// Means of the poses.
    pub bands: Bands,
    /// The status of the first pose without a value, an unproven one first, if the simulated band has none.
    pub gap: Option<Status>,
}

/// The curve of `followed` over a grid of centre distances around those of the study and the measurements. It reaches
/// the distance from which the pair assembles, if the extremes of its `cycle` have one.
///
/// # Errors
/// [`GearError::NoSuchTooth`]; otherwise as [`crate::analysis::simulate::simulate`].
pub fn over_distance(
    study: &Study,
    followed: Followed,
    cycle: &[RunExtremes],
    method: Method,
    tick: &Tick,
) -> Result<OverDistance, Error> {
    let of_teeth =
        |row: &&MeasuredRow| followed == Followed::Teeth(row.wheel_tooth, row.pinion_tooth);
    let measured: Vec<MeasuredRow> = study.measured.iter().filter(of_teeth).cloned().collect();
    let from = cycle.iter().filter_map(|run| run.assembles_from);
    let assembles_from = from.map(|from| from.high).reduce(f64::max);
    let distances = grid(study, &measured, assembles_from)?;
    let mut plans = Vec::new();
    for &a in &distances {
        for (material, assembly) in study.pairs(a)? {
            plans.push(RunPlan {
                matings: poses(&assembly, followed, !measured.is_empty())?,
                run: Run {
                    material,
                    assembly,
                    phase: None,
                },
            });
        }
    }
    let matings = plans
        .first()
        .map_or(Vec::new(), |plan| plan.matings.clone());
    let runs = simulate_plans(study, plans, method, tick)?;
    let gap = |a: f64| {
        let here = runs
            .iter()
            .filter(|run| run.run.assembly.center_distance() == a);
        let poses = here.flat_map(|run| &run.poses);
        let mut without = poses
            .filter(|pose| pose.simulated.backlash.is_none())
            .map(|pose| pose.simulated.status());
        // Unproven poses first: the status of the others is known.
        if without.clone().any(|status| status == Status::Unproven) {
            Some(Status::Unproven)
        } else {
            without.next()
        }
    };
    let point = |&a: &f64| DistancePoint {
        center_distance: a,
        bands: bands(study, &runs, a, |_| true),
        gap: gap(a),
    };
    let found = runs.iter().flat_map(|run| &run.poses);
    let agreement = MethodAgreement::of(found.map(|pose| &pose.simulated));
    Ok(OverDistance {
        followed,
        matings,
        clearance: study.clearance_of_poses(),
        agreement,
        unproven: runs.iter().map(|run| run.unproven().count()).sum(),
        two_materials: study.material_count() > 1,
        assembles_from,
        points: distances.iter().map(point).collect(),
        measured,
        required: study.requirements.clone(),
    })
}

/// The poses of `followed`; two `measured` teeth are the same at both flanks.
fn poses(
    assembly: &AssembledPair,
    followed: Followed,
    measured: bool,
) -> Result<Vec<Mating>, Error> {
    let (wheel_tooth, pinion_tooth) = match followed {
        Followed::Pose(mating) => return Ok(vec![mating]),
        Followed::Teeth(wheel, pinion) => (wheel, pinion),
    };
    for (member, tooth) in [(Member::Wheel, wheel_tooth), (Member::Pinion, pinion_tooth)] {
        let teeth = assembly.teeth(member);
        if !(1..=teeth).contains(&tooth) {
            return Err(GearError::NoSuchTooth { tooth, teeth }.into());
        }
    }
    let right = Mating::at(wheel_tooth, pinion_tooth, Side::Right);
    let mut left = right.at_flank(assembly, Side::Left);
    if measured {
        left.pinion_tooth = pinion_tooth;
    }
    Ok(vec![right, left])
}

/// Limit of the number of poses of [`over_distance`].
pub fn over_distance_pose_count(study: &Study) -> u64 {
    2 * u64::from(STEPS + 2) * study.material_count() as u64
}

/// Centre distances around those of the study and of `measured`, and up to `reach`, which is one of them. None is so
/// small that the gears cannot be assembled at `a − c`.
fn grid(study: &Study, measured: &[MeasuredRow], reach: Option<f64>) -> Result<Vec<f64>, Error> {
    let all = || {
        let measured = measured.iter().map(|row| row.center_distance);
        study.center_distances.iter().copied().chain(measured)
    };
    let (Some(first), Some(last)) = (all().reduce(f64::min), all().reduce(f64::max)) else {
        return Ok(Vec::new());
    };
    let pairs = study.pairs(last)?;
    let mut margin = MARGIN * (last - first);
    if last == first {
        let module = pairs.first().map_or(0.0, |(_, pair)| pair.module());
        margin = AROUND * module;
    }
    let last = last.max(reach.unwrap_or(last));
    margin = margin.max(MARGIN * (last - first));
    let least = pairs.iter().map(|(_, pair)| pair.least_distance());
    let least = least.fold(0.0, f64::max);
    let possible = |a: &f64| a - study.bearing_clearance > least;
    let (from, to) = (first - margin, last + margin);
    let step = (to - from) / f64::from(STEPS);
    let grid = (0..=STEPS).map(|i| from + f64::from(i) * step);
    let mut grid: Vec<f64> = grid.chain(reach).filter(possible).collect();
    grid.sort_unstable_by(f64::total_cmp);
    grid.dedup();
    Ok(grid)
}
