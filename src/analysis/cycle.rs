//! The whole hunting cycle of a pair: what the matings that are simulated leave out.
//!
//! Tooth numbers of 17 and 100 meet in 1700 pairs, of which one wheel revolution brings 17. Whether the pair
//! assembles, all of them have to say. So the others are gone through on the exact curves, and the poses with the
//! least and the greatest backlash are then simulated as all the rest is, certificate and formula beside it.
//!
//! What differs repeats sooner where one gear has no deviations: after a revolution of its mate.

use crate::analysis::compare::{ComparedRun, compare};
use crate::analysis::curves::swept;
use crate::analysis::simulate::simulate_plans;
use crate::analysis::study::{RunPlan, Study};
use crate::contact::{ExactKernel, LostMotion, Method, Status, first_least};
use crate::error::Error;
use crate::gear::{AsBuilt, Inspection};
use crate::pair::{GearPair, Mating, Member, Pose, SweepPlan};
use crate::parallel;
use std::ops::{ControlFlow, Range};

/// Poses gone through in all, at most (tuned: one takes a microsecond or a few, so some seconds; a hunting cycle of
/// 101 and 100 teeth in two materials has 323 200 at 16 poses a pitch).
const MOST: u64 = 1_000_000;

/// The matings of one assembly, and which of them were gone through.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Cycle {
    /// Matings that differ, until the same teeth meet again.
    pub matings: u64,
    /// Those of the revolution that is simulated.
    pub simulated: u64,
    /// What became of the others.
    pub others: RemainingMatings,
    /// Of each centre distance and material the poses that the others are worst, least and greatest at, simulated.
    pub extremes: Vec<ComparedRun>,
    /// Poses of the others at which the contact was lost; the first of each centre distance and material is among the
    /// extremes, as unproven.
    pub lost: u64,
}

/// The matings that no revolution simulated meets.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum RemainingMatings {
    /// There are none.
    #[default]
    None,
    /// All were gone through at so many poses a pitch.
    Seen {
        /// Poses a pitch.
        steps_per_pitch: u32,
        /// Poses in all, every centre distance and material.
        poses: u64,
    },
    /// They are too many, even at one pose a pitch.
    TooMany {
        /// Poses allowed.
        most: u64,
    },
}

/// What one look through poses comes to, in steps.
struct Look {
    /// Where they are worst, least, greatest and out of mesh, each once.
    extremes: Vec<u64>,
    /// Where the contact was lost first, and how often it was.
    first_lost: Option<u64>,
    lost: u64,
}

/// One run of a study, and the pitches beyond it.
struct RemainingRun {
    /// Its matings left out.
    plan: RunPlan,
    first: Mating,
    steps_per_pitch: u32,
    simulated: u64,
    matings: u64,
}

impl RemainingRun {
    fn new(plan: RunPlan) -> Option<RemainingRun> {
        let first = *plan.matings.first()?;
        let steps = plan.matings.iter().take_while(|mating| {
            (mating.wheel_tooth, mating.pinion_tooth) == (first.wheel_tooth, first.pinion_tooth)
        });
        let steps = steps.count().max(1);
        Some(RemainingRun {
            first,
            steps_per_pitch: u32::try_from(steps).ok()?,
            simulated: (plan.matings.len() / steps) as u64,
            matings: matings(&plan.assembly),
            plan: RunPlan {
                matings: Vec::new(),
                ..plan
            },
        })
    }

    /// Pitches that were not simulated.
    fn pitches(&self) -> u64 {
        self.matings.saturating_sub(self.simulated)
    }

    /// The mating `step` steps of a pitch beyond the first pose.
    fn mating(&self, step: u64, steps_per_pitch: u32) -> Mating {
        let steps = u64::from(steps_per_pitch);
        Mating {
            fraction: (step % steps) as f64 / steps as f64,
            ..self
                .first
                .onward(&self.plan.assembly, (step / steps) as f64)
        }
    }

    /// The poses that are worst, least, greatest, out of mesh and lost beyond what was simulated, and how many are lost.
    fn extremes(
        &self,
        steps_per_pitch: u32,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<(Vec<Mating>, u64), Error> {
        let steps = u64::from(steps_per_pitch);
        let coarse = self.look(
            steps_per_pitch,
            self.simulated * steps..self.matings * steps,
            tick,
        )?;
        let lost = coarse.first_lost.into_iter();
        if steps_per_pitch == self.steps_per_pitch {
            let found = coarse.extremes.into_iter().chain(lost);
            let matings = found.map(|step| self.mating(step, steps_per_pitch));
            return Ok((matings.collect(), coarse.lost));
        }
        // As finely as the revolution, within a pitch of what was found.
        let fine = u64::from(self.steps_per_pitch);
        let lost = lost.map(|step| self.mating(step, steps_per_pitch));
        let mut matings: Vec<Mating> = lost.collect();
        for step in coarse.extremes {
            let pitch = step / steps;
            let near = pitch.saturating_sub(1) * fine..(pitch + 2) * fine;
            let found = self.look(self.steps_per_pitch, near, tick)?;
            matings.extend(
                found
                    .extremes
                    .iter()
                    .map(|step| self.mating(*step, self.steps_per_pitch)),
            );
        }
        Ok((matings, coarse.lost))
    }

    /// Goes through `range`, counted in steps; the steps of the extremes, each once.
    fn look(
        &self,
        steps_per_pitch: u32,
        range: Range<u64>,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<Look, Error> {
        let assembly = &self.plan.assembly;
        let kernel = ExactKernel::new(assembly);
        let from = range.start;
        let found = parallel::map(range, |step| {
            if tick().is_break() {
                return Err(Error::Interrupted);
            }
            let pose = Pose::new(assembly, self.mating(step, steps_per_pitch));
            match kernel.lost_motion(&pose) {
                Ok(found) => Ok(Seen::new(&found)),
                Err(error) if error.of_one_pose().is_some() => Ok(Seen::LOST),
                Err(error) => Err(error),
            }
        });
        let found = found.into_iter().collect::<Result<Vec<Seen>, Error>>()?;
        let steps = || (from..).zip(&found);
        let first = |status: Status| {
            let mut of_status = steps().filter(move |(_, seen)| seen.status == status);
            of_status.next().map(|(step, _)| step)
        };
        let extreme = |sign: f64| {
            first_least(steps().filter_map(|(step, seen)| {
                let (angle, error) = seen.angle?;
                Some((step, sign * angle, error))
            }))
        };
        let mut extremes: Vec<u64> = [
            first(Status::Jammed),
            extreme(1.0),
            extreme(-1.0),
            first(Status::NoContact),
        ]
        .into_iter()
        .flatten()
        .collect();
        extremes.sort_unstable();
        extremes.dedup();
        let lost = found.iter().filter(|seen| seen.status == Status::Unproven);
        Ok(Look {
            extremes,
            first_lost: first(Status::Unproven),
            lost: lost.count() as u64,
        })
    }
}

/// What is kept of a pose.
struct Seen {
    status: Status,
    /// Lost motion and the bound on its error, rad.
    angle: Option<(f64, f64)>,
}

impl Seen {
    /// Of a contact that was lost.
    const LOST: Seen = Seen {
        status: Status::Unproven,
        angle: None,
    };

    fn new(lost_motion: &LostMotion) -> Seen {
        Seen {
            status: lost_motion.status(),
            angle: lost_motion.angle().zip(lost_motion.error()),
        }
    }
}

/// Goes through the hunting cycle of `study`'s revolutions, beyond what they meet themselves.
///
/// `method` finds the extremes once more; `tick` is called as each pose begins, from any thread.
///
/// # Errors
/// As [`crate::analysis::simulate::simulate`].
pub fn cycle(
    study: &Study,
    method: Method,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Cycle, Error> {
    let rests = rests(study)?;
    let others = others(&rests);
    let (mut plans, mut lost) = (Vec::new(), 0);
    if let RemainingMatings::Seen {
        steps_per_pitch, ..
    } = others
    {
        for rest in &rests {
            let (matings, lost_here) =
                rest.extremes(steps_per_pitch.min(rest.steps_per_pitch), tick)?;
            lost += lost_here;
            plans.push(RunPlan {
                matings,
                ..rest.plan.clone()
            });
        }
    }
    let extremes = simulate_plans(study, plans, method, &|| ControlFlow::Continue(()))?;
    Ok(Cycle {
        matings: rests.iter().map(|rest| rest.matings).max().unwrap_or(0),
        simulated: rests.iter().map(|rest| rest.simulated).min().unwrap_or(0),
        others,
        extremes: compare(extremes, study.tolerance_um),
        lost,
    })
}

/// How many poses [`cycle`] goes through.
///
/// # Errors
/// As [`Study::runs`].
pub fn pose_count(study: &Study) -> Result<u64, Error> {
    Ok(match others(&rests(study)?) {
        RemainingMatings::Seen { poses, .. } => poses,
        RemainingMatings::None | RemainingMatings::TooMany { .. } => 0,
    })
}

/// Matings of one assembly that differ, in pitches: after them every deviation of both gears is where it was.
fn matings(assembly: &GearPair) -> u64 {
    let gear = |member| assembly.gear(member);
    let teeth = |member| gear(member).gear().basic_data().teeth();
    let (wheel, pinion) = (teeth(Member::Wheel), teeth(Member::Pinion));
    let deviates = |gear: &AsBuilt| Inspection::of(gear).deviates();
    match [Member::Wheel, Member::Pinion].map(|member| deviates(gear(member))) {
        [true, true] => SweepPlan::hunting_pitches(wheel, pinion),
        [true, false] => u64::from(wheel),
        [false, true] => u64::from(pinion),
        [false, false] => 1,
    }
}

/// Phases are run over their full period already: their plans leave nothing.
fn rests(study: &Study) -> Result<Vec<RemainingRun>, Error> {
    let plans = swept(study.clone()).runs()?;
    Ok(plans.into_iter().filter_map(RemainingRun::new).collect())
}

fn others(rests: &[RemainingRun]) -> RemainingMatings {
    let pitches: u64 = rests.iter().map(RemainingRun::pitches).sum();
    let steps = rests.iter().map(|rest| rest.steps_per_pitch).max();
    let mut steps_per_pitch = steps.unwrap_or(1);
    if pitches == 0 {
        return RemainingMatings::None;
    }
    while pitches.saturating_mul(u64::from(steps_per_pitch)) > MOST {
        if steps_per_pitch == 1 {
            return RemainingMatings::TooMany { most: MOST };
        }
        steps_per_pitch /= 2;
    }
    RemainingMatings::Seen {
        steps_per_pitch,
        poses: pitches * u64::from(steps_per_pitch),
    }
}
