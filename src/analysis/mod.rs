//! One analysis of a study: the data of every command, page and chart.
//!
//! A [`Plan`] lists the parts and their work; [`Analysis::run`] does it, each pose once.

pub mod assembles_from;
pub mod axes;
pub mod backlash_map;
pub mod compare;
pub mod curves;
mod cycles;
pub mod diagnosis;
mod directions;
pub mod extremes;
pub mod face_loss;
pub mod face_width;
pub mod measured;
pub mod outcome;
pub mod phases;
pub mod remedies;
pub mod requirement;
pub mod simulate;
pub mod study;
pub mod tally;
pub mod uncertainty;
pub mod verdict;
pub mod without_play;

use self::backlash_map::BacklashMap;
use self::compare::ComparedRun;
use self::curves::{Field, OverDistance};
use self::diagnosis::{CheckName, Diagnosis, PoseEvidence, failed_checks};
use self::extremes::CycleExtremes;
use self::face_width::AtWidth;
use self::measured::{MeasuredMating, measured_matings};
use self::remedies::{Remedies, StatedGear};
use self::simulate::simulate;
use self::study::Study;
use self::verdict::Verdict;
use crate::contact::{Method, MethodAgreement};
use crate::error::{Error, Tick, go_on};

/// Parts of an analysis of a pair, and the method.
#[derive(Debug, Clone)]
#[must_use]
pub struct Plan<'a> {
    study: &'a Study,
    method: Method,
    revolution: bool,
    extremes: bool,
    curves: bool,
    checks: bool,
    remedies: Option<[StatedGear; 2]>,
}

impl<'a> Plan<'a> {
    /// The poses of `study` by `method`.
    pub fn new(study: &'a Study, method: Method) -> Plan<'a> {
        Plan {
            study,
            method,
            revolution: false,
            extremes: false,
            curves: false,
            checks: false,
            remedies: None,
        }
    }

    /// All parts, as in a report.
    pub fn whole(study: &'a Study, method: Method) -> Plan<'a> {
        let plan = Plan::new(study, method);
        plan.with_revolution()
            .with_extremes()
            .with_curves()
            .with_checks()
    }

    /// Adds whole revolutions, if the study's own poses do not cover them.
    pub fn with_revolution(mut self) -> Plan<'a> {
        self.revolution = true;
        self
    }

    /// Adds the extremes of the whole mesh cycle.
    pub fn with_extremes(mut self) -> Plan<'a> {
        self.extremes = true;
        self
    }

    /// Adds curves over the centre distance: of the binding pose, and of the measured matings.
    pub fn with_curves(mut self) -> Plan<'a> {
        self.curves = true;
        self
    }

    /// Adds every check of the pair.
    pub fn with_checks(mut self) -> Plan<'a> {
        self.checks = true;
        self
    }

    /// Adds the single changes that make a failing pair fit, with the extremes; `stated` as of [`remedies::remedies`].
    pub fn with_remedies(mut self, stated: [StatedGear; 2]) -> Plan<'a> {
        self.remedies = Some(stated);
        self.with_extremes()
    }

    /// Poses that are held in memory at once.
    pub fn poses(&self) -> u64 {
        if self.revolution {
            curves::with_revolution_pose_count(self.study)
        } else {
            self.study.pose_count()
        }
    }

    /// Upper limit of the steps of the work, each reported by a tick: poses, and pitches that are searched.
    ///
    /// # Errors
    /// As [`Study::runs`].
    pub fn steps(&self) -> Result<u64, Error> {
        let mut steps = self.poses();
        if self.extremes {
            steps += extremes::run_count(self.study)?;
        }
        if self.curves {
            // The binding teeth and the measured ones.
            let followed = 1 + curves::measured_teeth(self.study).len() as u64;
            steps += followed * curves::over_distance_pose_count(self.study);
        }
        if self.extremes && self.curves {
            steps += face_width::searches(self.study) * extremes::run_count(self.study)?;
        }
        if self.checks || self.extremes {
            steps += diagnosis::pitch_count(&self.study.runs()?) as u64;
        }
        Ok(steps)
    }
}

/// Receives the progress of an analysis.
pub struct Progress<'a> {
    /// Receives the name of each stage.
    pub stage: &'a mut dyn FnMut(&str),
    /// Called as each step begins, from any thread; a break ends the work.
    pub tick: &'a Tick<'a>,
}

/// Results about a pair. Parts outside the plan are empty.
#[derive(Debug, Clone)]
pub struct Analysis<'a> {
    /// The study.
    pub study: &'a Study,
    /// The method that found lost motion.
    pub method: Method,
    /// The poses of the study.
    pub runs: Vec<ComparedRun>,
    /// Whole revolutions at the same centre distances; where the study sweeps, its own poses and those of the left flanks.
    pub revolution: Vec<ComparedRun>,
    /// The revolutions with the additional poses of their curves, as drawn.
    pub curves: Vec<ComparedRun>,
    /// Extremes of the whole mesh cycle.
    pub extremes: CycleExtremes,
    /// Curves over the centre distance: of the binding pose, then of the measured matings.
    pub over_distance: Vec<OverDistance>,
    /// Maps of a drawn pair's backlash over mesh cycle and centre distance, one for each material.
    pub maps: Vec<BacklashMap>,
    /// The extremes over parts of the common face; empty for a pair whose sections are all equal.
    pub widths: Vec<AtWidth>,
    /// The field of action at the binding pose; `None` for a pair whose sections are all equal.
    pub field: Option<Field>,
    /// Measured values with their bands.
    pub measured: Vec<MeasuredMating>,
    /// Every check.
    pub diagnosis: Diagnosis,
    /// The checks that fail. A plan without checks makes only those that the extremes need.
    pub failed_checks: Vec<CheckName>,
    /// Single changes that make the pair fit; empty for a pair that fits.
    pub remedies: Remedies,
}

impl<'a> Analysis<'a> {
    /// Does the work of `plan`.
    ///
    /// A lost contact or a failed certificate leaves its pose unproven.
    ///
    /// # Errors
    /// [`Error::Interrupted`] after a break; a pair that cannot be assembled, for an unchecked study.
    pub fn run(plan: &Plan<'a>, progress: &mut Progress) -> Result<Analysis<'a>, Error> {
        let Plan { study, method, .. } = *plan;
        let tick = progress.tick;
        let [runs, revolution] = if plan.revolution {
            curves::with_revolution(study, method, tick)?
        } else {
            [simulate(study, method, tick)?, Vec::new()]
        };
        let mut analysis = Analysis {
            study,
            method,
            measured: measured_matings(study, &runs),
            runs,
            revolution,
            curves: Vec::new(),
            extremes: CycleExtremes::default(),
            over_distance: Vec::new(),
            maps: Vec::new(),
            widths: Vec::new(),
            field: None,
            diagnosis: Diagnosis::default(),
            failed_checks: Vec::new(),
            remedies: Remedies::default(),
        };
        if plan.extremes {
            (progress.stage)("(mesh cycle)");
            analysis.extremes = extremes::extremes(study, method, tick)?;
        }
        if plan.revolution {
            (progress.stage)("(curves over the teeth)");
            let (turned, cycle) = (&analysis.revolution, &analysis.extremes.each);
            analysis.curves = curves::refined(study, turned, cycle, method, tick)?;
        }
        if plan.curves {
            (progress.stage)("(over the centre distance)");
            let binding = curves::binding(study, analysis.all());
            for followed in curves::followed(study, binding) {
                let cycle = &analysis.extremes.each;
                let curve = curves::over_distance(study, followed, cycle, method, tick)?;
                analysis.over_distance.push(curve);
            }
            analysis.maps = BacklashMap::of_study(study, &analysis.extremes.each, tick)?;
        }
        if plan.curves && plan.extremes && study.varies_along_face() {
            (progress.stage)("(face width)");
            let full = &analysis.extremes.each;
            analysis.widths = face_width::over_widths(study, full, method, tick)?;
            let verdict = Verdict::of_study(study, full, Vec::new());
            analysis.field = verdict
                .worst()
                .and_then(|(_, pair, pose)| Field::of(pair.data()?, &pose.simulated));
        }
        if plan.checks {
            let stage = &mut *progress.stage;
            let mut step = |doing: &str| {
                stage(&format!("({doing})"));
                Ok(())
            };
            let (runs, extremes) = (&analysis.runs, &analysis.extremes);
            analysis.diagnosis = diagnosis::diagnose(study, runs, extremes, &mut step, tick)?;
            analysis.failed_checks = analysis.diagnosis.failed();
        } else if plan.extremes {
            let evidence: Vec<PoseEvidence> =
                analysis.runs.iter().filter_map(PoseEvidence::of).collect();
            analysis.failed_checks = failed_checks(study, &evidence, &analysis.extremes, tick)?;
        }
        if let Some(stated) = plan.remedies {
            (progress.stage)("(remedies)");
            analysis.remedies = remedies::remedies(study, &analysis.verdict(), stated, tick)?;
        }
        Ok(analysis)
    }

    /// Does the work of `plan` without progress reports.
    ///
    /// # Errors
    /// As [`Analysis::run`].
    pub fn silently(plan: &Plan<'a>) -> Result<Analysis<'a>, Error> {
        let mut progress = Progress {
            stage: &mut |_| (),
            tick: &go_on,
        };
        Analysis::run(plan, &mut progress)
    }

    /// Every distinct run: whole revolutions, and the other runs of the study.
    pub fn distinct_runs(&self) -> impl Iterator<Item = &ComparedRun> + Clone {
        let contained = self.study.sweeps() && !self.revolution.is_empty();
        let asked = if contained { &[] } else { &self.runs[..] };
        self.revolution.iter().chain(asked)
    }

    /// These runs, and the extremes of the mesh cycle.
    pub fn all(&self) -> impl Iterator<Item = &ComparedRun> + Clone {
        self.distinct_runs().chain(&self.extremes.runs)
    }

    /// The verdict, which comes first in every output.
    pub fn verdict(&self) -> Verdict<'_> {
        Verdict::of_study(self.study, &self.extremes.each, self.failed_checks.clone())
    }

    /// Agreement of both methods, if both were used.
    pub fn agreement(&self) -> MethodAgreement {
        let poses = self.all().flat_map(|run| &run.poses);
        let of_poses = MethodAgreement::of(poses.map(|pose| &pose.simulated));
        let curves = self.over_distance.iter();
        curves.fold(of_poses, |all, curve| all.and(curve.agreement))
    }

    /// Number of unproven poses, including the ends of the bearing clearance.
    pub fn unproven(&self) -> usize {
        let runs: usize = self.all().map(|run| run.unproven().count()).sum();
        let curves = self.over_distance.iter().map(|curve| curve.unproven);
        runs + curves.sum::<usize>()
    }
}
