//! Simulated against analytic backlash, and the verdict for a CI run.
//!
//! Model 3 (line of action) is exact where involutes touch inside both gears' tip and form circles, so it must agree there. For flanks
//! whose profiles deviate it uses the deviation at its own contact point. It can then exceed the simulation by an amount quadratic in the
//! tilt of the normals. If a tip corner, an undercut edge or a fillet touches, a real pair has less backlash than the formula says. That is
//! a separate finding: the formula does not apply to this pair.

use crate::analysis::study::Run;
use crate::analytic::{Analytic, evaluate};
use crate::contact::{ContactClass, ContactKind, LostMotion, PoseResult, Status};
use crate::gear::Side;
use crate::outline::AssembledPair;
use crate::pair::GearPair;

/// Verdict of the comparison at one pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum PoseVerdict {
    /// Within tolerance + error bound.
    Agrees,
    /// Nothing to compare: the pose is jammed or out of mesh, and the formula finds no contact either; or a gear is drawn.
    Nothing,
    /// The simulation is below the formula because a tip, an undercut edge, a fillet or a root touches off the line of
    /// action. Or profiles deviate: a tilted normal moves the contact along the flanks.
    OffLine,
    /// The simulation is below the formula although involutes touch.
    Below,
    /// The simulation is above model 3, which is always an error.
    Above,
    /// The simulated pose is unproven: nothing to compare.
    Unproven,
}

impl PoseVerdict {
    /// All, in the order of their definition.
    pub const ALL: [PoseVerdict; 6] = [
        PoseVerdict::Agrees,
        PoseVerdict::Nothing,
        PoseVerdict::OffLine,
        PoseVerdict::Below,
        PoseVerdict::Above,
        PoseVerdict::Unproven,
    ];
}

/// A pose with its analytic values. Lengths in mm, all as `j_wt`.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ComparedPose {
    /// The simulated pose.
    pub simulated: PoseResult,
    /// Model 1, Michalec.
    pub michalec: Option<f64>,
    /// Model 2, involute.
    pub involute: Option<f64>,
    /// Model 3, line of action.
    pub line_of_action: Option<f64>,
    /// The verdict on the pose.
    pub verdict: PoseVerdict,
}

impl From<PoseResult> for ComparedPose {
    /// The pose without values of formulas.
    fn from(simulated: PoseResult) -> ComparedPose {
        ComparedPose {
            verdict: match simulated.found {
                Ok(_) => PoseVerdict::Nothing,
                Err(_) => PoseVerdict::Unproven,
            },
            michalec: None,
            involute: None,
            line_of_action: None,
            simulated,
        }
    }
}

impl ComparedPose {
    /// Whether simulation and model 3 both have a value.
    pub fn has_both(&self) -> bool {
        self.simulated.backlash.is_some() && self.line_of_action.is_some()
    }
}

/// A run with its analytic values.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedRun {
    /// The run.
    pub run: Run,
    /// Its poses, in order.
    pub poses: Vec<ComparedPose>,
}

impl ComparedRun {
    /// The poses with an unproven part, in order.
    pub fn unproven(&self) -> impl Iterator<Item = &ComparedPose> + Clone {
        self.poses
            .iter()
            .filter(|pose| pose.simulated.is_unproven())
    }
}

/// Summary of a run. Lengths in mm, as `j_wt`; `None` if no pose has the value.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Summary {
    /// Unproven poses, whose values do not count below.
    pub unproven: usize,
    /// Poses that are unproven at `a − c`, and at `a + c`.
    pub unproven_ends: [usize; 2],
    /// Poses that polygons checked.
    pub polygon_checked: usize,
    /// Least backlash.
    pub min: Option<f64>,
    /// Greatest backlash.
    pub max: Option<f64>,
    /// Mean over the poses that have one.
    pub mean: Option<f64>,
    /// Least at `a − c`, greatest at `a + c`.
    pub with_clearance: [Option<f64>; 2],
    /// Largest amount of simulated minus model 2.
    pub off_involute: Option<f64>,
    /// Largest amount of simulated minus model 3.
    pub off_line_of_action: Option<f64>,
}

/// A pose of `assembly` with the analytic values that it has, judged with `tolerance_um`.
pub fn compared(assembly: &AssembledPair, result: PoseResult, tolerance_um: f64) -> ComparedPose {
    let mut pose = ComparedPose::from(result);
    if let Some(pair) = assembly.data() {
        let analytic: Analytic = evaluate(pair, &pose.simulated.pose);
        pose.michalec = analytic.michalec;
        pose.involute = analytic.involute;
        pose.line_of_action = analytic.line_of_action.backlash(pair);
        pose.verdict = judge(pair, &pose, tolerance_um * 1e-3);
    }
    pose
}

fn judge(assembly: &GearPair, pose: &ComparedPose, tolerance: f64) -> PoseVerdict {
    let result = &pose.simulated;
    let Ok(found) = &result.found else {
        return PoseVerdict::Unproven;
    };
    let simulated = result.backlash.zip(result.error_bound);
    match (simulated, pose.line_of_action) {
        (Some((simulated, bound)), Some(formula)) => {
            let difference = simulated - formula;
            if difference.abs() <= tolerance + bound {
                PoseVerdict::Agrees
            } else if difference > 0.0 {
                PoseVerdict::Above
            } else if touches_off_line(assembly, found) || assembly.is_modified() {
                PoseVerdict::OffLine
            } else {
                PoseVerdict::Below
            }
        }
        // The formula finds no pair of involutes within reach: something else touches.
        (Some(_), None) => PoseVerdict::OffLine,
        (None, Some(_)) if found.status() == Status::Jammed => PoseVerdict::OffLine,
        (None, Some(_)) => PoseVerdict::Above,
        (None, None) => PoseVerdict::Nothing,
    }
}

/// Whether a tip, an undercut edge, a fillet or a root touches in either contact of `assembly`.
pub fn touches_off_line(assembly: &GearPair, lost_motion: &LostMotion) -> bool {
    Side::BOTH.into_iter().any(|side| {
        let contact = lost_motion.on(side);
        let class = contact.map(|contact| ContactClass::of(assembly, side, &contact));
        class.is_some_and(|class| class.kind != ContactKind::Involute)
    })
}
