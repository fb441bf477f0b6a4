//! Double-flank roll test: the gear rolled without play against a perfect master gear.
//!
//! At each pose the centre distance `a''` is the one at which the exact kernel finds no lost motion,
//! bracketed to 1e-10 mm. Between poses nothing is known: the ranges are those of the poses taken.

use super::Unmeasured;
use super::master::master;
use super::spread::{mean, range};
use crate::analytic::InvolutePair;
use crate::diagnosis::play_free_distance;
use crate::error::Error;
use crate::gear::{AsBuilt, Face, Gear};
use crate::mesh::{ExactKernel, PoseClass};
use crate::pair::{Assembly, Mating, Member, Pose, SweepPlan};
use rayon::prelude::*;
use std::ops::ControlFlow;

/// One pose of the roll test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollPose {
    /// The gear is the wheel, the master the pinion.
    pub mating: Mating,
    /// Rotation of the gear, rad, from the position in which its tooth 1 points at the master.
    pub rotation: f64,
    /// `a''`, mm.
    pub distance: f64,
    /// Bound on its error, mm.
    pub error: f64,
    /// What touched.
    pub class: PoseClass,
}

/// A whole roll test.
#[derive(Debug, Clone, PartialEq)]
pub struct Roll {
    /// The master gear.
    pub master: Gear,
    /// Poses a pitch.
    pub steps_per_pitch: u32,
    /// One revolution of the gear.
    pub poses: Vec<RollPose>,
}

impl Roll {
    /// `F_i''`, mm: range of `a''` over the revolution.
    pub fn total(&self) -> f64 {
        range(self.poses.iter().map(|pose| pose.distance))
    }

    /// `f_i''`, mm: greatest range of `a''` within one pitch (360°/z).
    pub fn tooth_to_tooth(&self) -> f64 {
        let count = self.poses.len();
        let steps = self.steps_per_pitch as usize;
        let window = |first: usize| {
            let within = (first..=first + steps).map(|i| self.poses[i % count].distance);
            range(within)
        };
        (0..count).map(window).fold(0.0, f64::max)
    }

    /// Bound on the error of both ranges, mm, for the poses taken.
    pub fn error(&self) -> f64 {
        2.0 * self.poses.iter().map(|pose| pose.error).fold(0.0, f64::max)
    }

    /// Mean `a''`, mm.
    pub fn mean(&self) -> f64 {
        mean(self.poses.iter().map(|pose| pose.distance))
    }
}

/// Rolls `gear` once round; `tick` is called as each pose begins.
pub(super) fn roll(
    gear: &AsBuilt,
    master_teeth: Option<u32>,
    steps_per_pitch: u32,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<Result<Roll, Unmeasured>, Error> {
    let master = match master(gear, master_teeth) {
        Ok(master) => master,
        Err(reason) => return Ok(Err(reason)),
    };
    let guess = InvolutePair::new(gear.gear(), &master).center_distance(0.0);
    let Some(guess) = guess else {
        return Ok(Err(Unmeasured(
            "the gear is too thin to mesh with a master gear without play".to_owned(),
        )));
    };
    let face = match gear.face() {
        Face::Front => Face::Back,
        Face::Back => Face::Front,
    };
    let mate = AsBuilt::perfect(master.clone(), face);
    let assembly = Assembly::new(gear.clone(), mate, guess, Member::Wheel)?;
    let matings =
        SweepPlan::wheel_revolution(&assembly, steps_per_pitch, (1, 1)).matings(&assembly);
    let poses: Vec<Result<Option<RollPose>, Error>> = matings
        .par_iter()
        .map(|mating| match tick() {
            ControlFlow::Continue(()) => pose(&assembly, guess, mating),
            ControlFlow::Break(()) => Err(Error::Interrupted),
        })
        .collect();
    let poses: Option<Vec<RollPose>> = poses.into_iter().collect::<Result<_, Error>>()?;
    Ok(poses
        .map(|poses| Roll {
            master,
            steps_per_pitch,
            poses,
        })
        .ok_or_else(|| {
            Unmeasured(
                "no centre distance brings the gear and the master together without play"
                    .to_owned(),
            )
        }))
}

fn pose(assembly: &Assembly, guess: f64, mating: &Mating) -> Result<Option<RollPose>, Error> {
    let Some([low, high]) = play_free_distance(assembly, guess, mating)? else {
        return Ok(None);
    };
    let at = assembly.at(high)?;
    let pose = Pose::new(&at, *mating);
    let found = ExactKernel::new(&at).lost_motion(&pose)?;
    // Play changes by 2 sin α_wt a unit of distance; the kernel's own error shifts the zero by as much the other way.
    let slope = 2.0 * at.operating_pressure_angle().sin();
    let play = found.error().unwrap_or(0.0) * at.gear(Member::Pinion).gear().base_radius();
    Ok(Some(RollPose {
        mating: *mating,
        rotation: pose.locked_rotation(),
        distance: 0.5 * (low + high),
        error: 0.5 * (high - low) + play / slope,
        class: PoseClass::of(&at, &found),
    }))
}
