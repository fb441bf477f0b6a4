//! Simulated against analytic backlash, and the verdict that gates a CI run.
//!
//! Model 3 (line of action) is exact where involutes touch inside both gears' tip and form circles, so
//! there it must agree; of flanks whose profiles deviate it takes the deviation at its own contact point, and may lie above by the square of
//! what that tilts their normals. Where a tip corner, an undercut edge or a fillet touches instead, a real
//! pair has less backlash than the formula says: the formula is wrong about this
//! pair, and that is a finding of its own.

use crate::analysis::simulate::Run;
use crate::analysis::study::Study;
use crate::analytic::{Analytic, evaluate};
use crate::contact::{
    Contact, ContactClass, ContactKind, LostMotion, PoseResult, Status, first_least,
};
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
    /// There is nothing to compare: jammed or out of mesh, and the formula finds no contact either; or a gear is drawn and has no formula.
    Nothing,
    /// The simulation lies below because a tip, an undercut edge, a fillet or a root touches off the line of action, or flanks whose profiles deviate: a tilted
    /// normal moves their contact along them.
    OffLine,
    /// The simulation lies below though involutes touch.
    Below,
    /// The simulation lies above model 3: never right.
    Above,
    /// Nothing vouches for what was simulated: there is nothing to compare.
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
    /// The verdict that decides.
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
    /// How many poses have this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.poses
            .iter()
            .filter(|pose| pose.verdict == verdict)
            .count()
    }

    /// How many poses have both a simulated backlash and one by model 3.
    pub fn compared(&self) -> usize {
        let both = |pose: &&ComparedPose| pose.has_both();
        self.poses.iter().filter(both).count()
    }

    /// Whether the run passes: something was compared, and everything agrees, or lies off the line where that is
    /// allowed. A run that is jammed or out of mesh throughout agrees with nothing, and of an unproven pose nobody knows.
    pub fn passes(&self, allow_off_line: bool) -> bool {
        let unproven = self.poses.iter().any(|pose| pose.simulated.is_unproven());
        self.compared() > 0 && !unproven && !self.disagrees(allow_off_line)
    }

    /// Whether some pose, proven, disagrees with the formula, or lies off the line where that is not allowed.
    pub fn disagrees(&self, allow_off_line: bool) -> bool {
        self.poses.iter().any(|pose| match pose.verdict {
            Verdict::Agrees | Verdict::Nothing | Verdict::Unproven => false,
            Verdict::OffLine => !allow_off_line,
            Verdict::Below | Verdict::Above => true,
        })
    }

    /// The poses of which something is not proven, in order.
    pub fn unproven(&self) -> impl Iterator<Item = &ComparedPose> + Clone {
        self.poses
            .iter()
            .filter(|pose| pose.simulated.is_unproven())
    }

    /// Simulated minus model 3, mm, of the pose where it is largest in amount.
    pub fn worst(&self) -> Option<(&ComparedPose, f64)> {
        let differences = self.poses.iter().filter_map(|pose| {
            let difference = pose.simulated.backlash? - pose.line_of_action?;
            Some((pose, difference))
        });
        differences.reduce(|worst, next| {
            if next.1.abs() > worst.1.abs() {
                next
            } else {
                worst
            }
        })
    }

    /// The run in numbers.
    pub fn summary(&self) -> Summary {
        let mut tally = SummaryTally::default();
        for pose in &self.poses {
            tally.add(pose);
        }
        tally.summary()
    }

    /// The poses with the least and the greatest backlash; of those that their error bounds cannot tell
    /// apart, the first.
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

/// Summary of a run. Lengths in mm, as `j_wt`; `None` where no pose has the value.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Summary {
    /// Poses that are not proven: none of their values counts below.
    pub unproven: usize,
    /// Poses that are not proven at `a − c`, and at `a + c`.
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

/// A [`Summary`] of poses that come one by one.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct SummaryTally {
    unproven: usize,
    unproven_ends: [usize; 2],
    polygon_checked: usize,
    min: Option<f64>,
    max: Option<f64>,
    /// Sum and number of the values.
    sum: Option<(f64, usize)>,
    with_clearance: [Option<f64>; 2],
    off_involute: Option<f64>,
    off_line_of_action: Option<f64>,
}

impl SummaryTally {
    /// Takes the next pose in.
    pub(crate) fn add(&mut self, pose: &ComparedPose) {
        let join = |known: &mut Option<f64>, value: Option<f64>, of: fn(f64, f64) -> f64| {
            if let Some(value) = value {
                *known = Some(known.map_or(value, |known| of(known, value)));
            }
        };
        let result = &pose.simulated;
        let off = |formula: Option<f64>| Some((result.backlash? - formula?).abs());
        self.unproven += usize::from(pose.verdict == Verdict::Unproven);
        for end in [0, 1] {
            self.unproven_ends[end] += usize::from(result.is_end_unproven(end));
        }
        self.polygon_checked += usize::from(result.polygon_checked);
        join(&mut self.min, result.backlash, f64::min);
        join(&mut self.max, result.backlash, f64::max);
        if let Some(backlash) = result.backlash {
            let (sum, count) = self.sum.unwrap_or((-0.0, 0));
            self.sum = Some((sum + backlash, count + 1));
        }
        let [near, far] = result.range();
        join(&mut self.with_clearance[0], near, f64::min);
        join(&mut self.with_clearance[1], far, f64::max);
        join(&mut self.off_involute, off(pose.involute), f64::max);
        let off_line_of_action = off(pose.line_of_action);
        join(&mut self.off_line_of_action, off_line_of_action, f64::max);
    }

    /// Summary of the poses.
    pub(crate) fn summary(&self) -> Summary {
        Summary {
            unproven: self.unproven,
            unproven_ends: self.unproven_ends,
            polygon_checked: self.polygon_checked,
            min: self.min,
            max: self.max,
            mean: self.sum.map(|(sum, count)| sum / count as f64),
            with_clearance: self.with_clearance,
            off_involute: self.off_involute,
            off_line_of_action: self.off_line_of_action,
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

/// The tolerance in force: the command line's, or else the pair file's.
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
        // The formula has no pair of involutes in reach of each other: what touches is something else.
        (Some(_), None) => Verdict::OffLine,
        (None, Some(_)) if found.status() == Status::Jammed => Verdict::OffLine,
        (None, Some(_)) => Verdict::Above,
        (None, None) => Verdict::Nothing,
    }
}

/// Whether a tip, an undercut edge, a fillet or a root touches in either contact of `assembly`.
pub fn touches_off_line(assembly: &GearPair, lost_motion: &LostMotion) -> bool {
    let off = |(side, contact): (Side, &Option<Contact>)| {
        let class = contact
            .as_ref()
            .map(|contact| ContactClass::of(assembly, side, contact));
        class.is_some_and(|class| class.kind != ContactKind::Involute)
    };
    [
        (Side::Right, &lost_motion.right),
        (Side::Left, &lost_motion.left),
    ]
    .into_iter()
    .any(off)
}
