//! A run in numbers, without its poses: enough for its summary, its verdict and its pictures.
//!
//! A pose takes half a kilobyte of memory and 4 kB of result, and runs have up to ten million. So poses are processed
//! block by block ([`simulate_by_blocks`]), and memory does not grow with their number.

use crate::analysis::compare::{
    ComparedPose, ComparedRun, Summary, SummaryTally, Verdict, compared,
};
use crate::analysis::diagnosis::PoseEvidence;
use crate::analysis::simulate::each_block;
use crate::analysis::study::{Material, Study};
use crate::contact::{BLOCK, FirstLeast, Method, MethodAgreement, Status};
use crate::error::{Error, Tick};
use crate::outline::AssembledPair;
use crate::parallel;
use std::convert::Infallible;

/// Limit of poses that a study keeps for a table (tuned: the height of a screen).
pub const MOST_LISTED: usize = 40;

/// Limit of unproven poses that are kept with their reasons, the first of a study (tuned: up to a kilobyte each).
pub const MOST_UNPROVEN: usize = 100_000;

/// One run in numbers, with a few representative poses.
#[derive(Debug, Clone)]
pub struct RunTally {
    /// The end of the thickness tolerances.
    pub material: Material,
    /// The gears at their centre distance.
    pub assembly: AssembledPair,
    /// Wheel and pinion tooth that name the assembly phase, if phases are run separately.
    pub phase: Option<(u32, u32)>,
    /// Number of poses.
    pub poses: usize,
    /// Number of poses with both a simulated backlash and one by model 3.
    pub compared: usize,
    /// Number of these that are below model 3 because of a contact off the line of action.
    pub compared_off_line: usize,
    /// Number of poses with negative backlash beyond their error bounds.
    pub interfering: usize,
    /// Number of jammed poses: a tip is in a root.
    pub jammed: usize,
    /// Number of poses out of mesh.
    pub apart: usize,
    /// Number of unproven poses, including the ends of the bearing clearance.
    pub unproven: usize,
    /// The first unproven poses.
    pub first_unproven: Vec<ComparedPose>,
    /// All poses, if the study has at most [`MOST_LISTED`].
    pub listed: Vec<ComparedPose>,
    /// Agreement of both methods, if both were used.
    pub agreement: MethodAgreement,
    /// The contacts of the poses and their cost; `None` for a drawn pair, which has no formula.
    pub evidence: Option<PoseEvidence>,
    verdicts: [usize; Verdict::ALL.len()],
    valued: usize,
    summary: SummaryTally,
    least: FirstLeast<ComparedPose>,
    greatest: FirstLeast<ComparedPose>,
    worst: Option<(ComparedPose, f64)>,
}

impl RunTally {
    /// The tally of a run before its first pose.
    fn new(material: Material, assembly: AssembledPair, phase: Option<(u32, u32)>) -> RunTally {
        RunTally {
            evidence: assembly
                .data()
                .map(|pair| PoseEvidence::new(pair, material)),
            material,
            assembly,
            phase,
            poses: 0,
            compared: 0,
            compared_off_line: 0,
            interfering: 0,
            jammed: 0,
            apart: 0,
            unproven: 0,
            first_unproven: Vec::new(),
            listed: Vec::new(),
            agreement: MethodAgreement::default(),
            verdicts: [0; Verdict::ALL.len()],
            valued: 0,
            summary: SummaryTally::default(),
            least: FirstLeast::default(),
            greatest: FirstLeast::default(),
            worst: None,
        }
    }

    /// Adds the next pose.
    fn add(&mut self, pose: &ComparedPose, keep: KeepLimits) {
        let result = &pose.simulated;
        self.poses += 1;
        self.compared += usize::from(pose.has_both());
        self.compared_off_line += usize::from(pose.has_both() && pose.verdict == Verdict::OffLine);
        self.verdicts[pose.verdict as usize] += 1;
        self.valued += usize::from(result.backlash.is_some());
        self.interfering += usize::from(result.interferes());
        match result.status() {
            Status::Jammed => self.jammed += 1,
            Status::NoContact => self.apart += 1,
            Status::Clear | Status::Interference | Status::Unproven => {}
        }
        if result.is_unproven() {
            self.unproven += 1;
            if self.first_unproven.len() < keep.unproven {
                self.first_unproven.push(pose.clone());
            }
        }
        if keep.listed {
            self.listed.push(pose.clone());
        }
        self.agreement.add(result);
        if let Some(evidence) = &mut self.evidence {
            evidence.add(pose);
        }
        self.summary.add(pose);
        if let (Some(backlash), Some(bound)) = (result.backlash, result.error_bound) {
            self.least.add(backlash, bound, || pose.clone());
            self.greatest.add(-backlash, bound, || pose.clone());
        }
        if let (Some(backlash), Some(formula)) = (result.backlash, pose.line_of_action) {
            let difference = backlash - formula;
            let worst = self.worst.as_ref();
            if worst.is_none_or(|(_, worst)| difference.abs() > worst.abs()) {
                self.worst = Some((pose.clone(), difference));
            }
        }
    }

    /// Number of poses with this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.verdicts[verdict as usize]
    }

    /// Number of poses with a simulated backlash and none by model 3, although the gears have one: no involutes reach each other.
    pub fn simulated_alone(&self) -> usize {
        match self.assembly.data() {
            Some(_) => self.valued - self.compared,
            None => 0,
        }
    }

    /// Whether the run passes: something was compared, and everything agrees, or is off the line if that is allowed. A
    /// run without any pose in mesh does not pass, nor does one with an unproven pose.
    pub fn passes(&self, allow_off_line: bool) -> bool {
        self.compared > 0 && self.unproven == 0 && !self.disagrees(allow_off_line)
    }

    /// Whether some proven pose disagrees with the formula, or is off the line if that is not allowed.
    pub fn disagrees(&self, allow_off_line: bool) -> bool {
        let off_line = !allow_off_line && self.count(Verdict::OffLine) > 0;
        off_line || self.count(Verdict::Below) + self.count(Verdict::Above) > 0
    }

    /// Whether every pose is proven to have backlash of zero or more.
    pub fn assembles(&self) -> bool {
        let fails = self.interfering + self.jammed + self.apart > 0;
        self.poses > 0 && self.count(Verdict::Unproven) == 0 && !fails
    }

    /// Variation of backlash over the run, greatest minus least, mm; `None` if a pose has no backlash.
    pub fn variation(&self) -> Option<f64> {
        let summary = self.summary();
        let whole = self.valued == self.poses;
        whole.then_some(summary.max? - summary.min?)
    }

    /// Simulated minus model 3, mm, of the pose where its amount is largest.
    pub fn worst(&self) -> Option<(&ComparedPose, f64)> {
        let (pose, difference) = self.worst.as_ref()?;
        Some((pose, *difference))
    }

    /// The run in numbers.
    pub fn summary(&self) -> Summary {
        self.summary.summary()
    }

    /// As [`ComparedRun::extremes`].
    pub fn extremes(&self) -> Option<(&ComparedPose, &ComparedPose)> {
        Some((self.least.first()?, self.greatest.first()?))
    }
}

/// The poses to keep.
#[derive(Debug, Clone, Copy)]
struct KeepLimits {
    listed: bool,
    unproven: usize,
}

impl KeepLimits {
    /// For the next run, after `done`, of a study of `poses`, which may keep `unproven` of them.
    fn of(poses: usize, unproven: usize, done: &[RunTally]) -> KeepLimits {
        let kept: usize = done.iter().map(|run| run.first_unproven.len()).sum();
        KeepLimits {
            listed: poses <= MOST_LISTED,
            unproven: unproven.saturating_sub(kept),
        }
    }
}

/// The tallies of whole `runs`.
pub fn tally(runs: &[ComparedRun]) -> Vec<RunTally> {
    let Ok(tallies) = whole(runs, &mut |_| Ok::<(), Infallible>(()));
    tallies
}

/// An item from [`simulate_by_blocks`], in order.
#[derive(Debug, Clone, Copy)]
pub enum Piece<'a> {
    /// Start of a run, before any pose is counted.
    Begin(&'a RunTally),
    /// The next poses of the run.
    Poses(&'a RunTally, &'a [ComparedPose]),
    /// End of a run; all poses are counted.
    End(&'a RunTally),
}

/// [`simulate_by_blocks`] for `runs` that already exist.
pub fn whole<E>(
    runs: &[ComparedRun],
    take: &mut dyn FnMut(Piece) -> Result<(), E>,
) -> Result<Vec<RunTally>, E> {
    let poses = runs.iter().map(|run| run.poses.len()).sum();
    let mut done = Vec::with_capacity(runs.len());
    for ComparedRun { run, poses: of_run } in runs {
        let keep = KeepLimits::of(poses, MOST_UNPROVEN, &done);
        let mut tally = RunTally::new(run.material, run.assembly.clone(), run.phase);
        take(Piece::Begin(&tally))?;
        for block in of_run.chunks(BLOCK) {
            for pose in block {
                tally.add(pose, keep);
            }
            take(Piece::Poses(&tally, block))?;
        }
        take(Piece::End(&tally))?;
        done.push(tally);
    }
    Ok(done)
}

/// Simulates every run of `study` by `method`, compares its poses within `tolerance_um` and keeps their tallies.
///
/// `take` receives the poses block by block, in order, with any number of threads; its error ends the work. Up to
/// `unproven` unproven poses are kept, and at most [`MOST_UNPROVEN`] per command.
///
/// # Errors
/// As [`crate::analysis::simulate::simulate`], and of `take`.
pub fn simulate_by_blocks<E: From<Error>>(
    study: &Study,
    method: Method,
    tolerance_um: f64,
    unproven: usize,
    tick: &Tick,
    take: &mut dyn FnMut(Piece) -> Result<(), E>,
) -> Result<Vec<RunTally>, E> {
    let poses = study.pose_count();
    let mut done: Vec<RunTally> = Vec::new();
    let mut current: Option<(RunTally, KeepLimits)> = None;
    let plans = study.runs()?;
    each_block::<E>(study, plans, method, tick, &mut |block| {
        if block.first {
            let run = RunTally::new(block.material, block.assembly.clone(), block.phase);
            take(Piece::Begin(&run))?;
            let poses = usize::try_from(poses).unwrap_or(usize::MAX);
            current = Some((run, KeepLimits::of(poses, unproven, &done)));
        }
        let Some((run, keep)) = &mut current else {
            return Ok(());
        };
        let poses = parallel::map(block.poses, |result| {
            compared(&run.assembly, result, tolerance_um)
        });
        for pose in &poses {
            run.add(pose, *keep);
        }
        take(Piece::Poses(run, &poses))?;
        if block.last
            && let Some((run, _)) = current.take()
        {
            take(Piece::End(&run))?;
            done.push(run);
        }
        Ok(())
    })?;
    Ok(done)
}
