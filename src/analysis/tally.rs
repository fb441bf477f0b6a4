//! What is kept of a run whose poses are written and gone: enough for its summary, its verdict and its pictures.
//!
//! A pose takes half a kilobyte of memory and 4 kB of result; ten million of them are run, so poses are gone through block
//! by block ([`simulate_by_blocks`]), and nothing grows with their number.

use crate::analysis::compare::{
    ComparedPose, ComparedRun, Summary, SummaryTally, Verdict, compared,
};
use crate::analysis::diagnosis::Seen;
use crate::analysis::simulate::each_block;
use crate::analysis::study::{Material, Study};
use crate::contact::{BLOCK, FirstLeast, Method, MethodAgreement, Status};
use crate::error::Error;
use crate::outline::AssembledPair;
use crate::parallel;
use std::convert::Infallible;
use std::ops::ControlFlow;

/// Poses of a study that are kept one by one for a table, where there are no more (tuned: what a screen shows).
pub const MOST_LISTED: usize = 40;

/// Unproven poses that are kept with their reasons, the first of a study (tuned: up to a kilobyte each).
pub const MOST_UNPROVEN: usize = 100_000;

/// One run in numbers, with the few poses that stand for it.
#[derive(Debug, Clone)]
pub struct RunTally {
    /// Which end of the thickness tolerances.
    pub material: Material,
    /// The gears at their centre distance.
    pub assembly: AssembledPair,
    /// Wheel and pinion tooth that name the assembly phase, where phases are run apart.
    pub phase: Option<(u32, u32)>,
    /// How many poses there are.
    pub poses: usize,
    /// How many have both a simulated backlash and one by model 3.
    pub compared: usize,
    /// How many of these lie below model 3 because something touches off the line of action.
    pub compared_off_line: usize,
    /// How many have negative backlash, beyond their error bounds.
    pub interfering: usize,
    /// How many are jammed: a tip sits in a root.
    pub jammed: usize,
    /// How many are out of mesh.
    pub apart: usize,
    /// How many are not proven, or not at an end of the bearing clearance.
    pub unproven: usize,
    /// The first of these.
    pub first_unproven: Vec<ComparedPose>,
    /// All poses, where the study has up to [`MOST_LISTED`].
    pub listed: Vec<ComparedPose>,
    /// How far both methods agree, where both were asked for.
    pub agreement: MethodAgreement,
    /// What touched, where, and what it cost; `None` of a drawn pair, which no formula is known of.
    pub seen: Option<Seen>,
    verdicts: [usize; Verdict::ALL.len()],
    valued: usize,
    summary: SummaryTally,
    least: FirstLeast<ComparedPose>,
    greatest: FirstLeast<ComparedPose>,
    worst: Option<(ComparedPose, f64)>,
}

impl RunTally {
    /// Of no pose yet.
    fn new(material: Material, assembly: AssembledPair, phase: Option<(u32, u32)>) -> RunTally {
        RunTally {
            seen: assembly.data().map(|pair| Seen::new(pair, material)),
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

    /// Takes the next pose in.
    fn add(&mut self, pose: &ComparedPose, keep: Keep) {
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
        if let Some(seen) = &mut self.seen {
            seen.add(pose);
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

    /// How many poses have this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.verdicts[verdict as usize]
    }

    /// How many have a simulated backlash and none by model 3, though the gears have one: no two involutes reach each other.
    pub fn simulated_alone(&self) -> usize {
        match self.assembly.data() {
            Some(_) => self.valued - self.compared,
            None => 0,
        }
    }

    /// As [`ComparedRun::passes`].
    pub fn passes(&self, allow_off_line: bool) -> bool {
        self.compared > 0 && self.unproven == 0 && !self.disagrees(allow_off_line)
    }

    /// As [`ComparedRun::disagrees`].
    pub fn disagrees(&self, allow_off_line: bool) -> bool {
        let off_line = if allow_off_line {
            0
        } else {
            self.count(Verdict::OffLine)
        };
        off_line + self.count(Verdict::Below) + self.count(Verdict::Above) > 0
    }

    /// Whether every pose is proven to have room to turn, or just none too little.
    pub fn assembles(&self) -> bool {
        let fails = self.interfering + self.jammed + self.apart > 0;
        self.poses > 0 && self.count(Verdict::Unproven) == 0 && !fails
    }

    /// Variation of backlash over the run, greatest minus least, mm; `None` where a pose has no backlash.
    pub fn variation(&self) -> Option<f64> {
        let summary = self.summary();
        let whole = self.valued == self.poses;
        whole.then_some(summary.max? - summary.min?)
    }

    /// Simulated minus model 3, mm, of the pose where it is largest in amount.
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

/// What of the poses is kept.
#[derive(Debug, Clone, Copy)]
struct Keep {
    listed: bool,
    unproven: usize,
}

impl Keep {
    /// For the next run, after `done`, of a study of so many `poses`, of which `unproven` may be kept.
    fn of(poses: usize, unproven: usize, done: &[RunTally]) -> Keep {
        let kept: usize = done.iter().map(|run| run.first_unproven.len()).sum();
        Keep {
            listed: poses <= MOST_LISTED,
            unproven: unproven.saturating_sub(kept),
        }
    }
}

/// What whole `runs` come to.
pub fn tally(runs: &[ComparedRun]) -> Vec<RunTally> {
    let Ok(tallies) = whole(runs, &mut |_| Ok::<(), Infallible>(()));
    tallies
}

/// What [`simulate_by_blocks`] delivers, in order.
#[derive(Debug, Clone, Copy)]
pub enum Piece<'a> {
    /// A run begins; nothing is counted yet.
    Begin(&'a RunTally),
    /// Its next poses.
    Poses(&'a RunTally, &'a [ComparedPose]),
    /// A run ends; all is counted.
    End(&'a RunTally),
}

/// As [`simulate_by_blocks`], of `runs` that are there already.
pub fn whole<E>(
    runs: &[ComparedRun],
    take: &mut dyn FnMut(Piece) -> Result<(), E>,
) -> Result<Vec<RunTally>, E> {
    let poses = runs.iter().map(|run| run.poses.len()).sum();
    let mut done = Vec::with_capacity(runs.len());
    for ComparedRun { run, poses: of_run } in runs {
        let keep = Keep::of(poses, MOST_UNPROVEN, &done);
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

/// Simulates every run of `study` by `method`, compares its poses within `tolerance_um` and keeps what they come to.
///
/// `take` gets the poses block by block, in order, whatever the number of threads; an error of it ends the work. Up to
/// `unproven` poses that are not proven are kept, at most [`MOST_UNPROVEN`] of all that a command does.
///
/// # Errors
/// As [`crate::analysis::simulate::simulate`], and of `take`.
pub fn simulate_by_blocks<E: From<Error>>(
    study: &Study,
    method: Method,
    tolerance_um: f64,
    unproven: usize,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    take: &mut dyn FnMut(Piece) -> Result<(), E>,
) -> Result<Vec<RunTally>, E> {
    let poses = study.pose_count();
    let mut done: Vec<RunTally> = Vec::new();
    let mut current: Option<(RunTally, Keep)> = None;
    let plans = study.runs()?;
    each_block::<E>(study, plans, method, tick, &mut |block| {
        if block.first {
            let run = RunTally::new(block.material, block.assembly.clone(), block.phase);
            take(Piece::Begin(&run))?;
            let poses = usize::try_from(poses).unwrap_or(usize::MAX);
            current = Some((run, Keep::of(poses, unproven, &done)));
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
