//! Simulated against analytic backlash, and the verdict for a CI run.
//!
//! Model 3 (line of action) is exact where involutes touch inside both gears' tip and form circles, so it must agree there. For flanks
//! whose profiles deviate it uses the deviation at its own contact point. It can then exceed the simulation by an amount quadratic in the
//! tilt of the normals. If a tip corner, an undercut edge or a fillet touches, a real pair has less backlash than the formula says. That is
//! a separate finding: the formula does not apply to this pair.

use crate::analysis::simulate::Run;
use crate::analysis::study::Study;
use crate::analytic::{Analytic, evaluate};
use crate::contact::{ContactClass, ContactKind, LostMotion, PoseResult, Status, first_least};
use crate::gear::Side;
use crate::outline::AssembledPair;
use crate::pair::GearPair;

/// Verdict of the comparison at one pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Verdict {
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

impl Verdict {
    /// All, in the order of their definition.
    pub const ALL: [Verdict; 6] = [
        Verdict::Agrees,
        Verdict::Nothing,
        Verdict::OffLine,
        Verdict::Below,
        Verdict::Above,
        Verdict::Unproven,
    ];

    /// The verdict in words.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Agrees => "agrees",
            Verdict::Nothing => "nothing to compare",
            Verdict::OffLine => "off-line contact",
            Verdict::Below => "below the formula",
            Verdict::Above => "above the formula",
            Verdict::Unproven => "unproven",
        }
    }
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
    pub verdict: Verdict,
}

impl From<PoseResult> for ComparedPose {
    /// The pose without values of formulas.
    fn from(simulated: PoseResult) -> ComparedPose {
        ComparedPose {
            verdict: match simulated.found {
                Ok(_) => Verdict::Nothing,
                Err(_) => Verdict::Unproven,
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
    /// The simulated run; its poses are moved to `poses`.
    pub run: Run,
    /// In order.
    pub poses: Vec<ComparedPose>,
}

impl ComparedRun {
    /// The poses with an unproven part, in order.
    pub fn unproven(&self) -> impl Iterator<Item = &ComparedPose> + Clone {
        self.poses
            .iter()
            .filter(|pose| pose.simulated.is_unproven())
    }

    /// The run in numbers.
    pub fn summary(&self) -> Summary {
        let mut tally = SummaryTally::default();
        self.poses.iter().for_each(|pose| tally.add(pose));
        tally.summary()
    }

    /// The poses with the least and the greatest backlash; among those within their error bounds, the first.
    pub fn extremes(&self) -> Option<(&ComparedPose, &ComparedPose)> {
        let first = |sign: f64| {
            first_least(self.poses.iter().filter_map(|pose| {
                Some((
                    pose,
                    pose.simulated.backlash? * sign,
                    pose.simulated.error_bound?,
                ))
            }))
        };
        Some((first(1.0)?, first(-1.0)?))
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

/// A [`Summary`] of poses that arrive one by one.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct SummaryTally {
    /// Without the mean.
    summary: Summary,
    /// Sum and number of the values.
    sum: Option<(f64, usize)>,
}

impl SummaryTally {
    /// Adds the next pose.
    pub(crate) fn add(&mut self, pose: &ComparedPose) {
        let join = |known: &mut Option<f64>, value: Option<f64>, of: fn(f64, f64) -> f64| {
            *known = known.iter().copied().chain(value).reduce(of);
        };
        let result = &pose.simulated;
        let off = |formula: Option<f64>| Some((result.backlash? - formula?).abs());
        let summary = &mut self.summary;
        summary.unproven += usize::from(pose.verdict == Verdict::Unproven);
        for end in [0, 1] {
            summary.unproven_ends[end] += usize::from(result.is_end_unproven(end));
        }
        summary.polygon_checked += usize::from(result.polygon_checked);
        join(&mut summary.min, result.backlash, f64::min);
        join(&mut summary.max, result.backlash, f64::max);
        if let Some(backlash) = result.backlash {
            let (sum, count) = self.sum.unwrap_or((-0.0, 0));
            self.sum = Some((sum + backlash, count + 1));
        }
        let [near, far] = result.range();
        join(&mut summary.with_clearance[0], near, f64::min);
        join(&mut summary.with_clearance[1], far, f64::max);
        join(&mut summary.off_involute, off(pose.involute), f64::max);
        let off_line_of_action = off(pose.line_of_action);
        join(
            &mut summary.off_line_of_action,
            off_line_of_action,
            f64::max,
        );
    }

    /// Summary of the poses.
    pub(crate) fn summary(&self) -> Summary {
        Summary {
            mean: self.sum.map(|(sum, count)| sum / count as f64),
            ..self.summary
        }
    }
}

/// Adds the analytic values to `runs` and judges them with `tolerance_um`.
pub fn compare(runs: Vec<Run>, tolerance_um: f64) -> Vec<ComparedRun> {
    let of_run = |mut run: Run| {
        let poses = std::mem::take(&mut run.poses).into_iter();
        let poses = poses.map(|result| compared(&run.assembly, result, tolerance_um));
        ComparedRun {
            poses: poses.collect(),
            run,
        }
    };
    runs.into_iter().map(of_run).collect()
}

/// A pose of `assembly` with its analytic values, judged with `tolerance_um`. A drawn pair has none.
pub(crate) fn compared(
    assembly: &AssembledPair,
    result: PoseResult,
    tolerance_um: f64,
) -> ComparedPose {
    let Some(assembly) = assembly.data() else {
        return result.into();
    };
    let analytic: Analytic = evaluate(assembly, &result.pose);
    let line_of_action = analytic.line_of_action.backlash(assembly);
    ComparedPose {
        verdict: judge(assembly, &result, line_of_action, tolerance_um * 1e-3),
        michalec: analytic.michalec,
        involute: analytic.involute,
        line_of_action,
        simulated: result,
    }
}

/// The tolerance in force: that of the command line, otherwise that of the pair file.
pub fn tolerance_um(study: &Study, given: Option<f64>) -> f64 {
    given.unwrap_or(study.tolerance_um)
}

fn judge(
    assembly: &GearPair,
    result: &PoseResult,
    formula: Option<f64>,
    tolerance: f64,
) -> Verdict {
    let Ok(found) = &result.found else {
        return Verdict::Unproven;
    };
    let simulated = result.backlash.zip(result.error_bound);
    match (simulated, formula) {
        (Some((simulated, bound)), Some(formula)) => {
            let difference = simulated - formula;
            if difference.abs() <= tolerance + bound {
                Verdict::Agrees
            } else if difference > 0.0 {
                Verdict::Above
            } else if touches_off_line(assembly, found) || assembly.is_modified() {
                Verdict::OffLine
            } else {
                Verdict::Below
            }
        }
        // The formula finds no pair of involutes within reach: something else touches.
        (Some(_), None) => Verdict::OffLine,
        (None, Some(_)) if found.status() == Status::Jammed => Verdict::OffLine,
        (None, Some(_)) => Verdict::Above,
        (None, None) => Verdict::Nothing,
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
