//! The least and the greatest backlash of every run of a study, over its whole mesh cycle and every rotation.
//!
//! Tooth numbers of 17 and 100 meet in 1700 pairs, of which one wheel revolution brings 17. Whether the pair assembles, all of them have
//! to say, and every rotation between two poses: [`ExactKernel::extremes`] proves what bounds them. What it found is simulated as every
//! other pose is, certificate and formulas beside it.

use super::assembles_from::AssemblesFrom;
use super::compare::{ComparedPose, ComparedRun, compare};
use super::phases::phase;
use super::simulate::simulate_plans;
use super::study::{Material, RunPlan, Study};
use crate::contact::{Doubt, ExactKernel, Extreme, Extremes, Method, Status};
use crate::error::Error;
use crate::gear::{AsBuilt, Inspection, Side};
use crate::pair::{GearPair, Mating, Member, SweepPlan};
use crate::parallel;
use std::ops::ControlFlow;

/// Width of a proven bracket of `j_wt`, mm: a nanometre, a hundredth of what any gear is measured to.
pub const WIDTH: f64 = 1e-6;

/// One centre distance, material and assembly phase.
#[derive(Debug, Clone)]
pub struct RunExtremes {
    /// Which thickness.
    pub material: Material,
    /// As assembled.
    pub assembly: GearPair,
    /// Wheel and pinion tooth that name the assembly phase, where the study has several.
    pub phase: Option<(u32, u32)>,
    /// Matings of the cycle: lcm(z_1, z_2).
    pub matings: u64,
    /// How the worst of its poses ends.
    pub status: Status,
    /// The least `j_wt`; `None` where a pose is jammed.
    pub least: Option<RunExtreme>,
    /// The greatest; `None` where a pose is out of mesh.
    pub greatest: Option<RunExtreme>,
    /// A pose that is jammed or out of mesh.
    pub lost: Option<ComparedPose>,
    /// Where the pair does not assemble: from which centre distance it does; `None` where none was found between this one and tips that
    /// pass each other.
    pub assembles_from: Option<AssemblesFrom>,
}

/// The extremes of a study.
#[derive(Debug, Clone, Default)]
pub struct CycleExtremes {
    /// Each centre distance, material and assembly phase.
    pub each: Vec<RunExtremes>,
    /// Their poses, run by run: least, greatest, lost.
    pub runs: Vec<ComparedRun>,
}

/// An extreme and the pose that attains it.
#[derive(Debug, Clone)]
pub struct RunExtreme {
    /// `j_wt`, mm: no less than this.
    pub low: f64,
    /// No more than this.
    pub high: f64,
    /// Why that is not proven.
    pub doubt: Option<Doubt>,
    /// The pose, simulated.
    pub pose: ComparedPose,
}

impl RunExtreme {
    /// Whether no rotation of the cycle lies beyond, and something vouches for the pose itself.
    pub fn is_proven(&self) -> bool {
        self.doubt.is_none() && self.pose.swept.found.is_ok()
    }

    /// What was found, mm: the end of the bracket that the pose attains.
    pub fn found(&self) -> f64 {
        self.pose
            .swept
            .backlash
            .unwrap_or(0.5 * (self.low + self.high))
    }
}

impl RunExtremes {
    /// Whether the pair assembles over the whole cycle; `None` where that is not proven.
    pub fn assembles(&self) -> Option<bool> {
        match (self.status, &self.least) {
            (Status::Jammed | Status::NoContact, _) => Some(false),
            (_, Some(least)) if least.high < 0.0 => Some(false),
            (_, Some(least)) if least.low >= -WIDTH && least.is_proven() => Some(true),
            _ => None,
        }
    }

    /// Whether all that is said of it is proven.
    pub fn is_proven(&self) -> bool {
        let both = self.least.iter().chain(&self.greatest);
        both.into_iter().all(RunExtreme::is_proven)
    }
}

/// The extremes of every run of `study`, in the order of [`Study::runs`], their poses found once more by `method`.
///
/// A study of single matings has the assembly phases that these belong to. `tick` is called as each run begins, from any thread.
///
/// # Errors
/// As [`super::simulate::simulate`].
pub fn extremes(
    study: &Study,
    method: Method,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<CycleExtremes, Error> {
    let plans = plans(study)?;
    let found = parallel::map(0..plans.len() as u64, |index| {
        if tick().is_break() {
            return Err(Error::Interrupted);
        }
        let Planned { run, first, .. } = &plans[index as usize];
        let kernel = ExactKernel::new(&run.assembly);
        let found = kernel.extremes(&run.assembly, *first, distinct(&run.assembly), WIDTH)?;
        let from = match found.least {
            Some(least) if least.low >= 0.0 => None,
            _ if found.status == Status::NoContact => None,
            least => {
                let least = least.map(|least| least.low);
                let matings = distinct(&run.assembly);
                AssemblesFrom::new(&run.assembly, *first, matings, least, 0.1 * WIDTH)?
            }
        };
        Ok((found, from))
    });
    let found = found.into_iter().collect::<Result<Vec<_>, Error>>()?;
    let poses = plans
        .iter()
        .zip(&found)
        .map(|(planned, (found, _))| RunPlan {
            matings: matings(found).collect(),
            ..planned.run.clone()
        });
    let runs = simulate_plans(
        study,
        poses.collect(),
        method,
        &|| ControlFlow::Continue(()),
    )?;
    let runs = compare(runs, study.tolerance_um);
    let all = plans.iter().zip(found).zip(&runs);
    let each = all.map(|((planned, (found, from)), run)| planned.extremes(&found, from, run));
    Ok(CycleExtremes {
        each: each.collect(),
        runs,
    })
}

/// How many runs [`extremes`] has: its ticks.
///
/// # Errors
/// As [`Study::runs`].
pub fn run_count(study: &Study) -> Result<u64, Error> {
    Ok(plans(study)?.len() as u64)
}

/// A run and where its cycle begins.
struct Planned {
    run: RunPlan,
    first: Mating,
    phase: Option<(u32, u32)>,
}

impl Planned {
    fn extremes(
        &self,
        found: &Extremes,
        from: Option<AssemblesFrom>,
        run: &ComparedRun,
    ) -> RunExtremes {
        let mut poses = run.poses.iter().cloned();
        let mut one = |extreme: Option<Extreme>| {
            extreme.and_then(|extreme| {
                Some(RunExtreme {
                    low: extreme.low,
                    high: extreme.high,
                    doubt: extreme.doubt,
                    pose: poses.next()?,
                })
            })
        };
        let (least, greatest) = (one(found.least), one(found.greatest));
        RunExtremes {
            material: self.run.material,
            assembly: self.run.assembly.clone(),
            phase: self.phase,
            matings: hunting_pitches(&self.run.assembly),
            status: found.status,
            least,
            greatest,
            lost: poses.next(),
            assembles_from: from,
        }
    }
}

/// The poses of what was found, in the order in which they are taken up again.
fn matings(found: &Extremes) -> impl Iterator<Item = Mating> {
    let extremes = [found.least, found.greatest].into_iter().flatten();
    let matings: Vec<Mating> = extremes.map(|extreme| extreme.mating).collect();
    matings.into_iter().chain(found.lost)
}

/// Every centre distance and material, each in the phases that the study is about.
fn plans(study: &Study) -> Result<Vec<Planned>, Error> {
    let runs = study.runs()?;
    let mut plans: Vec<Planned> = Vec::new();
    for run in runs {
        let mut firsts: Vec<Mating> = Vec::new();
        for mating in &run.matings {
            let first = first_of_phase(&run.assembly, mating);
            if !firsts.contains(&first) {
                firsts.push(first);
            }
        }
        // Against perfect teeth it does not matter which are met.
        if distinct(&run.assembly) < hunting_pitches(&run.assembly) {
            firsts.truncate(1);
        }
        let several = firsts.len() > 1;
        firsts.sort_by_key(|first| first.pinion_tooth);
        for first in firsts {
            let own = several.then_some((first.wheel_tooth, first.pinion_tooth));
            plans.push(Planned {
                phase: run.phase.or(own),
                run: RunPlan {
                    matings: Vec::new(),
                    ..run.clone()
                },
                first,
            });
        }
    }
    Ok(plans)
}

/// The mating of wheel tooth 1 that names the assembly phase of `mating`.
fn first_of_phase(assembly: &GearPair, mating: &Mating) -> Mating {
    Mating {
        wheel_tooth: 1,
        pinion_tooth: phase(assembly, mating),
        flank: Side::Right,
        fraction: 0.0,
    }
}

/// lcm(z_1, z_2).
fn hunting_pitches(assembly: &GearPair) -> u64 {
    let teeth = |member| assembly.gear(member).gear().basic_data().teeth();
    SweepPlan::hunting_pitches(teeth(Member::Wheel), teeth(Member::Pinion))
}

/// Matings that differ: after them every deviation of both gears is where it was.
fn distinct(assembly: &GearPair) -> u64 {
    let gear = |member| assembly.gear(member);
    let teeth = |member| gear(member).gear().basic_data().teeth();
    let (wheel, pinion) = (teeth(Member::Wheel), teeth(Member::Pinion));
    let deviates = |gear: &AsBuilt| Inspection::of(gear).deviates();
    match [Member::Wheel, Member::Pinion].map(|member| deviates(gear(member))) {
        [true, true] => hunting_pitches(assembly),
        [true, false] => u64::from(wheel),
        [false, true] => u64::from(pinion),
        [false, false] => 1,
    }
}
