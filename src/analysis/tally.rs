//! A run in numbers, without its poses: enough for its summary, its verdict and its pictures.
//!
//! A pose takes half a kilobyte of memory and 4 kB of result, and runs have up to ten million. So poses are processed
//! block by block ([`simulate_by_blocks`]), and memory does not grow with their number.

use crate::analysis::compare::{ComparedPose, ComparedRun, PoseVerdict, Summary};
use crate::analysis::diagnosis::PoseEvidence;
use crate::analysis::simulate::Simulation;
use crate::analysis::study::{Material, Run, Study};
use crate::contact::{BLOCK, FirstLeast, Method, MethodAgreement, Status};
use crate::error::{Error, Tick};
use crate::outline::AssembledPair;
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
    pub out_of_mesh: usize,
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
    verdicts: [usize; PoseVerdict::ALL.len()],
    valued: usize,
    /// Without the mean.
    summary: Summary,
    /// Sum of the values, mm.
    sum: f64,
    least: FirstLeast<ComparedPose>,
    greatest: FirstLeast<ComparedPose>,
    worst: Option<ComparedPose>,
    /// Whether all poses are kept.
    lists: bool,
    /// Limit of the unproven poses that are kept.
    most_unproven: usize,
}

impl RunTally {
    /// The tally of `run` before its first pose, in a study of `poses` that may keep `unproven` of them, after the runs `done`.
    fn new(run: &Run, poses: u64, unproven: usize, done: &[RunTally]) -> RunTally {
        let data = run.assembly.data();
        let kept: usize = done.iter().map(|run| run.first_unproven.len()).sum();
        RunTally {
            evidence: data.map(|pair| PoseEvidence::new(pair, run.material)),
            material: run.material,
            assembly: run.assembly.clone(),
            phase: run.phase,
            poses: 0,
            compared: 0,
            compared_off_line: 0,
            interfering: 0,
            jammed: 0,
            out_of_mesh: 0,
            unproven: 0,
            first_unproven: Vec::new(),
            listed: Vec::new(),
            agreement: MethodAgreement::default(),
            verdicts: [0; PoseVerdict::ALL.len()],
            valued: 0,
            summary: Summary::default(),
            sum: -0.0,
            least: FirstLeast::default(),
            greatest: FirstLeast::default(),
            worst: None,
            lists: poses <= MOST_LISTED as u64,
            most_unproven: unproven.saturating_sub(kept),
        }
    }

    fn add_block<E>(&mut self, poses: &[ComparedPose], take: &mut Take<E>) -> Result<(), E> {
        poses.iter().for_each(|pose| self.add(pose));
        take(Piece::Poses(self, poses))
    }

    /// Adds the next pose.
    fn add(&mut self, pose: &ComparedPose) {
        let result = &pose.simulated;
        self.poses += 1;
        self.compared += usize::from(pose.has_both());
        self.compared_off_line +=
            usize::from(pose.has_both() && pose.verdict == PoseVerdict::OffLine);
        self.verdicts[pose.verdict as usize] += 1;
        self.interfering += usize::from(result.interferes());
        match result.status() {
            Status::Jammed => self.jammed += 1,
            Status::NoContact => self.out_of_mesh += 1,
            Status::Clear | Status::Interference | Status::Unproven => {}
        }
        if result.is_unproven() {
            self.unproven += 1;
            if self.first_unproven.len() < self.most_unproven {
                self.first_unproven.push(pose.clone());
            }
        }
        if self.lists {
            self.listed.push(pose.clone());
        }
        self.agreement.add(result);
        if let Some(evidence) = &mut self.evidence {
            evidence.add(pose);
        }
        self.summarise(pose);
        if let (Some(backlash), Some(bound)) = (result.backlash, result.error_bound) {
            self.least.add(backlash, bound, || pose.clone());
            self.greatest.add(-backlash, bound, || pose.clone());
        }
        if let Some(difference) = off_line_of_action(pose)
            && (self.worst()).is_none_or(|(_, worst)| difference.abs() > worst.abs())
        {
            self.worst = Some(pose.clone());
        }
    }

    /// Adds the next pose to the summary.
    fn summarise(&mut self, pose: &ComparedPose) {
        let join = |known: &mut Option<f64>, value: Option<f64>, of: fn(f64, f64) -> f64| {
            *known = known.iter().copied().chain(value).reduce(of);
        };
        let result = &pose.simulated;
        let off = |formula: Option<f64>| Some((result.backlash? - formula?).abs());
        if let Some(backlash) = result.backlash {
            self.sum += backlash;
            self.valued += 1;
        }
        let summary = &mut self.summary;
        summary.unproven += usize::from(pose.verdict == PoseVerdict::Unproven);
        for end in [0, 1] {
            summary.unproven_ends[end] += usize::from(result.is_end_unproven(end));
        }
        summary.polygon_checked += usize::from(result.polygon_checked);
        join(&mut summary.min, result.backlash, f64::min);
        join(&mut summary.max, result.backlash, f64::max);
        let [near, far] = result.range();
        join(&mut summary.with_clearance[0], near, f64::min);
        join(&mut summary.with_clearance[1], far, f64::max);
        join(&mut summary.off_involute, off(pose.involute), f64::max);
        let off_line_of_action = &mut summary.off_line_of_action;
        join(off_line_of_action, off(pose.line_of_action), f64::max);
    }

    /// Number of poses with this verdict.
    pub fn count(&self, verdict: PoseVerdict) -> usize {
        self.verdicts[verdict as usize]
    }

    /// Number of poses with a simulated backlash and none by model 3, although the gears have one: no involutes reach each other.
    pub fn simulated_alone(&self) -> usize {
        let evidence = self.evidence.as_ref();
        evidence.map_or(0, |_| self.valued - self.compared)
    }

    /// Whether the run passes: something was compared, and everything agrees, or is off the line if that is allowed. A
    /// run without any pose in mesh does not pass, nor does one with an unproven pose.
    pub fn passes(&self, allow_off_line: bool) -> bool {
        self.compared > 0 && self.unproven == 0 && !self.disagrees(allow_off_line)
    }

    /// Whether some proven pose disagrees with the formula, or is off the line if that is not allowed.
    pub fn disagrees(&self, allow_off_line: bool) -> bool {
        let off_line = !allow_off_line && self.count(PoseVerdict::OffLine) > 0;
        off_line || self.count(PoseVerdict::Below) + self.count(PoseVerdict::Above) > 0
    }

    /// Whether every pose is proven to have backlash of zero or more.
    pub fn assembles(&self) -> bool {
        let fails = self.interfering + self.jammed + self.out_of_mesh > 0;
        self.poses > 0 && self.count(PoseVerdict::Unproven) == 0 && !fails
    }

    /// Variation of backlash over the run, greatest minus least, mm; `None` if a pose has no backlash.
    pub fn variation(&self) -> Option<f64> {
        let whole = self.valued == self.poses;
        whole.then_some(self.summary.max? - self.summary.min?)
    }

    /// Simulated minus model 3, mm, of the pose where its amount is largest.
    pub fn worst(&self) -> Option<(&ComparedPose, f64)> {
        let pose = self.worst.as_ref()?;
        Some((pose, off_line_of_action(pose)?))
    }

    /// The run in numbers.
    pub fn summary(&self) -> Summary {
        Summary {
            mean: (self.valued > 0).then(|| self.sum / self.valued as f64),
            ..self.summary
        }
    }

    /// The poses with the least and the greatest backlash; among those within their error bounds, the first.
    pub fn extremes(&self) -> Option<(&ComparedPose, &ComparedPose)> {
        Some((self.least.first()?, self.greatest.first()?))
    }
}

/// Simulated minus model 3, mm.
fn off_line_of_action(pose: &ComparedPose) -> Option<f64> {
    Some(pose.simulated.backlash? - pose.line_of_action?)
}

/// The tallies of whole `runs`.
pub fn tally(runs: &[ComparedRun]) -> Vec<RunTally> {
    let Ok(tallies) = tally_by_blocks(runs, &mut |_| Ok::<(), Infallible>(()));
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

/// Receives the pieces of runs in order; its error ends the work.
type Take<'a, E> = dyn FnMut(Piece) -> Result<(), E> + 'a;

/// [`simulate_by_blocks`] for `runs` that already exist.
pub fn tally_by_blocks<E>(runs: &[ComparedRun], take: &mut Take<E>) -> Result<Vec<RunTally>, E> {
    let count = runs.iter().map(|run| run.poses.len() as u64).sum();
    let mut done = Vec::with_capacity(runs.len());
    for ComparedRun { run, poses } in runs {
        let mut tally = RunTally::new(run, count, MOST_UNPROVEN, &done);
        take(Piece::Begin(&tally))?;
        for block in poses.chunks(BLOCK) {
            tally.add_block(block, take)?;
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
    take: &mut Take<E>,
) -> Result<Vec<RunTally>, E> {
    let simulation = Simulation::new(study, method, tolerance_um, tick);
    let (poses, mut done) = (study.pose_count(), Vec::new());
    for plan in study.runs()? {
        let mut tally = RunTally::new(&plan.run, poses, unproven, &done);
        take(Piece::Begin(&tally))?;
        simulation.each_block(&plan, &mut |block| tally.add_block(&block, take))?;
        take(Piece::End(&tally))?;
        done.push(tally);
    }
    Ok(done)
}
