//! The least and the greatest backlash of every run of a study, over its whole mesh cycle and every rotation.
//!
//! Teeth of a 17/100 pair meet in 1700 matings; one wheel revolution contains 17 of them. All matings and all rotations between poses
//! decide whether the pair assembles. [`cycle_extremes`](crate::contact::cycle_extremes) proves the bounds. Its extreme poses
//! are then simulated like any other, with certificate and formulas. `cycles` lists the cycles and both ends of the bearing clearance;
//! [`super::verdict`] draws the conclusions. The checks in the verdict use the evidence of poses (`diagnosis::PoseEvidence`), so that poses
//! need not be kept. `failed_checks` runs only the checks whose outcome is not yet known, `diagnose` all.

use super::assembles_from::Threshold;
use super::compare::{ComparedPose, ComparedRun};
use super::cycles::{CyclePlan, CycleResult, SearchedEnd, distinct, plans, worse};
use super::directions::PosedPair;
use super::face_loss::FaceLoss;
use super::simulate::Simulation;
use super::study::{Material, Run, RunPlan, Study};
use crate::contact::{Doubt, End, Extreme, Method, Status, is_proven};
use crate::error::{Error, Tick, go_on};
use crate::outline::AssembledPair;
use crate::pair::{Member, ToothNumbers};
use crate::parallel;
use std::cell::OnceCell;

pub(crate) use super::cycles::phases_differ;
pub use super::cycles::{WIDTH, extremes_of_phase, proven_width};

/// One centre distance, material and assembly phase.
#[derive(Debug, Clone)]
pub struct RunExtremes {
    /// The thickness.
    pub material: Material,
    /// The pair as assembled.
    pub assembly: AssembledPair,
    /// The assembly phase by the same teeth as `own_phase`, if the study has several: for headings.
    pub phase: Option<(u32, u32)>,
    /// Wheel and pinion tooth that name the phase that the extremes hold for; `None` if they hold for every phase.
    pub own_phase: Option<(u32, u32)>,
    /// Matings of the cycle: lcm(z_1, z_2).
    pub matings: u64,
    /// The status of its worst pose.
    pub status: Status,
    /// The least `j_wt`; `None` if a pose is jammed.
    pub least: Option<RunExtreme>,
    /// The greatest `j_wt`; `None` if a pose is out of mesh.
    pub greatest: Option<RunExtreme>,
    /// A pose that is jammed or out of mesh.
    pub lost: Option<PairPose>,
    /// For a pair that does not assemble: the centre distance from which it does. `None` if there is none up to tips that pass each other.
    pub assembles_from: Option<Threshold>,
    /// For a pair out of mesh: the centre distance up to which it is in mesh.
    pub meshes_to: Option<Threshold>,
    /// Loss of the least by deviations along the face; `None` for a pair without any.
    pub face_loss: Option<FaceLoss>,
    /// Extremes with the axes moved together and apart by the bearing clearance; `None` without clearance.
    pub bearings: Option<BearingExtremes>,
}

/// A pair whose axes move in their bearings.
#[derive(Debug, Clone)]
pub struct BearingExtremes {
    /// `c`, mm: radial clearance of both bearings together.
    pub clearance: f64,
    /// The gears pressed together.
    pub pressed: BearingEnd,
    /// The gears pulled apart.
    pub pulled_apart: BearingEnd,
}

/// One end of the bearing clearance.
#[derive(Debug, Clone)]
pub struct BearingEnd {
    /// The pair at the centre distance `a − c` or `a + c`.
    pub assembly: AssembledPair,
    /// The status of its worst pose.
    pub status: Status,
    /// The least of the pair pressed together, `None` if it is jammed; the greatest of the pair pulled apart, `None` if it is out of mesh.
    pub extreme: Option<RunExtreme>,
}

/// The extremes of a study.
#[derive(Debug, Clone, Default)]
pub struct CycleExtremes {
    /// Each centre distance, material and assembly phase.
    pub each: Vec<RunExtremes>,
    /// Their poses, run by run: least, greatest, lost, and the binding one at the distance from which the pair assembles.
    pub runs: Vec<ComparedRun>,
}

impl CycleExtremes {
    /// The greatest loss by deviations along the face of the runs at a centre distance, mm, of a material; `None` without any.
    pub fn face_loss(&self, center_distance: f64, material: Material) -> Option<FaceLoss> {
        let here = |run: &&RunExtremes| run.group_key() == (center_distance, material);
        let runs = self.each.iter().filter(here);
        let losses = runs.filter_map(|run| run.face_loss);
        losses.reduce(|one, other| if other.all > one.all { other } else { one })
    }
}

/// A pose and its pair. A runout without direction has its high tooth at the worst place.
#[derive(Debug, Clone)]
pub struct PairPose {
    /// The pair.
    pub assembly: AssembledPair,
    /// The pose, simulated.
    pub pose: ComparedPose,
}

/// An extreme and the pose that attains it.
#[derive(Debug, Clone)]
pub struct RunExtreme {
    /// Lower bound of `j_wt`, mm; −∞ without a bound.
    pub low: f64,
    /// Upper bound; ∞ without a bound.
    pub high: f64,
    /// The attained value, mm.
    pub found: f64,
    /// The reason why the bracket is too wide.
    pub doubt: Option<Doubt>,
    /// The pair. A runout without direction has its high tooth at the worst place.
    pub assembly: AssembledPair,
    /// The pose, simulated.
    pub pose: ComparedPose,
}

/// The poses of `runs`, in order.
fn poses(runs: &[ComparedRun]) -> impl Iterator<Item = PairPose> + '_ {
    runs.iter().flat_map(|run| {
        run.poses.iter().map(|pose| PairPose {
            assembly: run.run.assembly.clone(),
            pose: pose.clone(),
        })
    })
}

impl RunExtreme {
    fn new(found: Extreme, PairPose { assembly, pose }: PairPose) -> RunExtreme {
        RunExtreme {
            low: found.low,
            high: found.high,
            found: found.found,
            doubt: found.doubt,
            assembly,
            pose,
        }
    }

    /// Whether the bracket is at most [`proven_width`] wide, and the pose is proven.
    pub fn is_proven(&self) -> bool {
        let width = proven_width(&self.assembly);
        is_proven(self.low, self.high, width) && self.pose.simulated.found.is_ok()
    }

    /// Whether the bracket has two finite ends and the pose is proven.
    pub fn holds(&self) -> bool {
        self.low.is_finite() && self.high.is_finite() && self.pose.simulated.found.is_ok()
    }

    /// The attained `j_wt`, mm.
    pub fn found(&self) -> f64 {
        self.pose.simulated.backlash.unwrap_or(self.found)
    }
}

impl RunExtremes {
    fn new(
        planned: &CyclePlan,
        searched: &CycleResult,
        poses: &mut impl Iterator<Item = PairPose>,
        bearings: Option<BearingExtremes>,
    ) -> RunExtremes {
        let found = &searched.found;
        let of_each = searched.poses.each_ref();
        let [least, greatest, lost, _] = of_each.map(|own| own.as_ref().and_then(|_| poses.next()));
        let one = |(extreme, pose)| RunExtreme::new(extreme, pose);
        RunExtremes {
            material: planned.run.material,
            assembly: planned.run.assembly.clone(),
            phase: planned.phase,
            own_phase: planned.own_phase(),
            matings: planned.run.assembly.hunting_pitches(),
            status: found.status,
            least: found.least.zip(least).map(one),
            greatest: found.greatest.zip(greatest).map(one),
            lost,
            assembles_from: searched.assembles_from,
            meshes_to: searched.meshes_to,
            face_loss: searched.face_loss,
            bearings,
        }
    }

    /// Its centre distance, mm, and its material.
    pub(super) fn group_key(&self) -> (f64, Material) {
        (self.assembly.center_distance(), self.material)
    }

    /// The least or the greatest.
    pub(super) fn at(&self, end: End) -> Option<&RunExtreme> {
        match end {
            End::Least => self.least.as_ref(),
            End::Greatest => self.greatest.as_ref(),
        }
    }

    /// The least with the axes pressed together, or the greatest with them pulled apart, and their pair. Without bearing clearance, as [`RunExtremes::at`].
    pub(super) fn with_clearance(&self, end: End) -> (&AssembledPair, Option<&RunExtreme>) {
        let moved = self.bearings.as_ref().map(|play| match end {
            End::Least => &play.pressed,
            End::Greatest => &play.pulled_apart,
        });
        match moved {
            Some(moved) => (&moved.assembly, moved.extreme.as_ref()),
            None => (&self.assembly, self.at(end)),
        }
    }

    /// Whether the pair assembles over the whole cycle; `None` if unproven.
    pub fn assembles(&self) -> Option<bool> {
        let width = proven_width(&self.assembly);
        match (self.status, &self.least) {
            (Status::Jammed | Status::NoContact, _) => Some(false),
            (_, Some(least)) if least.high < 0.0 => Some(false),
            (Status::Unproven, _) => None,
            (_, Some(least)) if least.low >= -width && least.pose.simulated.found.is_ok() => {
                Some(true)
            }
            _ => None,
        }
    }

    /// Whether all teeth are equal: no deviation distinguishes them, and a runout may have any direction.
    pub fn has_like_teeth(&self) -> bool {
        distinct(&self.assembly) == 1
    }

    /// Whether a runout has no direction, so that all directions are covered.
    pub fn any_direction(&self) -> bool {
        let is_open = |member| {
            self.assembly.any_direction(member) && self.assembly.eccentricity(member) > 0.0
        };
        Member::BOTH.into_iter().any(is_open)
    }

    /// Whether every part of the result is proven.
    pub fn is_proven(&self) -> bool {
        let both = self.least.iter().chain(&self.greatest);
        both.into_iter().all(RunExtreme::is_proven)
    }
}

/// The extremes of every run of `study`, in the order of [`Study::runs`], with their poses found again by `method`.
///
/// They cover every assembly phase, or those of the listed matings ([`Study::all_phases`]). `tick` is called as each
/// run begins, from any thread.
///
/// # Errors
/// As [`super::simulate::simulate`].
pub fn extremes(study: &Study, method: Method, tick: &Tick) -> Result<CycleExtremes, Error> {
    of_plans(study, plans(study, tick)?, method, tick)
}

/// Least and greatest backlash alone, in one run for each centre distance and assembly phase of `study`. With several materials the least is
/// that of the thickest gears, and the greatest that of the thinnest. Thicker teeth contain thinner ones, so no thickness between has less or
/// more.
///
/// The effort is that of [`extremes`] divided by `divisor`. The distances from which a pair assembles and up to which it is in mesh are left
/// out, and so are losses along the face.
///
/// # Errors
/// As [`super::simulate::simulate`].
pub fn extremes_alone(
    study: &Study,
    method: Method,
    divisor: u64,
    tick: &Tick,
) -> Result<CycleExtremes, Error> {
    let mut plans = plans(study, tick)?;
    let has = |wanted| plans.iter().any(|plan| plan.run.material == wanted);
    let is_band = has(Material::Most) && has(Material::Least);
    for plan in &mut plans {
        (plan.is_alone, plan.divisor) = (true, divisor);
        plan.wanted = match plan.run.material {
            Material::Most if is_band => &[End::Least],
            Material::Least if is_band => &[End::Greatest],
            _ => &End::BOTH,
        };
    }
    let CycleExtremes { mut each, runs } = of_plans(study, plans, method, tick)?;
    if is_band {
        let is_thin = |run: &mut RunExtremes| run.material == Material::Least;
        // Both materials have the same distances and phases, in one order.
        let thin: Vec<RunExtremes> = each.extract_if(.., is_thin).collect();
        for (run, thin) in each.iter_mut().zip(thin) {
            run.greatest = thin.greatest;
            run.status = worse(run.status, thin.status);
            run.lost = run.lost.take().or(thin.lost);
        }
    }
    Ok(CycleExtremes { each, runs })
}

fn of_plans(
    study: &Study,
    plans: Vec<CyclePlan>,
    method: Method,
    tick: &Tick,
) -> Result<CycleExtremes, Error> {
    let clearance = study.bearing_clearance;
    let found = parallel::map(&plans, |plan| {
        Error::if_stopped(tick(1))?;
        let ends = (clearance > 0.0).then(|| plan.at_clearance_ends(clearance));
        Ok::<_, Error>((plan.search()?, ends.transpose()?))
    });
    // At the ends of their clearance the bearings have no further play.
    let without_play = Study {
        bearing_clearance: 0.0,
        bearing_ends: None,
        ..study.clone()
    };
    let simulation =
        |study| Simulation::new(study, method.of_extremes(), study.tolerance_um, &go_on);
    let (own, at_ends) = (simulation(study), OnceCell::new());
    let mut all = CycleExtremes::default();
    for (planned, found) in plans.iter().zip(found) {
        let (searched, ends) = found?;
        let posed: Vec<&PosedPair> = searched.poses.iter().flatten().collect();
        // Poses that follow each other and have the same pair share a run.
        let shared = posed.chunk_by(|one, other| one.assembly == other.assembly);
        let runs = own.runs(shared.map(|poses| pose_plan(planned, poses)))?;
        let bearing_end = |end: SearchedEnd| {
            let posed = end.pose.iter().map(|pose| pose_plan(planned, &[pose]));
            let at_ends = at_ends.get_or_init(|| simulation(&without_play));
            let runs = at_ends.runs(posed)?;
            let found = end.extreme.zip(poses(&runs).next());
            Ok::<_, Error>(BearingEnd {
                assembly: end.assembly,
                status: end.status,
                extreme: found.map(|(extreme, pose)| RunExtreme::new(extreme, pose)),
            })
        };
        let bearings = match ends {
            Some([near, far]) => Some(BearingExtremes {
                clearance,
                pressed: bearing_end(near)?,
                pulled_apart: bearing_end(far)?,
            }),
            None => None,
        };
        let each = RunExtremes::new(planned, &searched, &mut poses(&runs), bearings);
        all.each.push(each);
        all.runs.extend(runs);
    }
    Ok(all)
}

/// The `poses` of one pair in the run of `planned`.
fn pose_plan(planned: &CyclePlan, poses: &[&PosedPair]) -> RunPlan {
    RunPlan {
        run: Run {
            assembly: poses[0].assembly.clone(),
            ..planned.run.clone()
        },
        matings: poses.iter().map(|pose| pose.mating).collect(),
    }
}

/// Number of runs of [`extremes`], which is its number of ticks.
///
/// # Errors
/// As [`Study::runs`].
pub fn run_count(study: &Study) -> Result<u64, Error> {
    Ok(plans(study, &go_on)?.len() as u64)
}

/// The assembly phases that extremes cover.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum CoveredPhases {
    /// Every phase of the pair.
    All,
    /// Wheel and pinion tooth that name each.
    Some(Vec<(u32, u32)>),
}

impl CoveredPhases {
    /// The phases of `runs`.
    pub fn of<'a>(runs: impl IntoIterator<Item = &'a RunExtremes>) -> CoveredPhases {
        let (mut phases, mut all) = (Vec::new(), 1);
        for run in runs {
            if let Some(phase) = run.own_phase {
                phases.push(phase);
                all = run.assembly.phase_count() as usize;
            }
        }
        phases.sort_unstable();
        phases.dedup();
        if phases.is_empty() || phases.len() == all {
            CoveredPhases::All
        } else {
            CoveredPhases::Some(phases)
        }
    }
}
