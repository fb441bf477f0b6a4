//! The poses of a simulation.

use super::{Mating, Member, ToothNumbers};
use crate::gear::Side;
use crate::numeric::{gcd, lcm};

/// The poses of a simulation.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum SweepPlan {
    /// A right-flank and a left-flank pose of each mating at each fraction of a pitch.
    Matings {
        /// Wheel and pinion tooth of each mating.
        matings: Vec<(u32, u32)>,
        /// Fractions of a pitch.
        fractions: Vec<f64>,
    },
    /// Equal steps over a whole number of pitches.
    Revolution {
        /// Number of pitches: `z_1`, or lcm(z_1, z_2) for a hunting cycle.
        pitches: u64,
        /// Poses per pitch.
        steps_per_pitch: u32,
        /// Mating (right flank) of the first pose.
        start: (u32, u32),
    },
    /// Every assembly phase, each over its full period of lcm(z_1, z_2) pitches.
    Phases {
        /// Poses per pitch.
        steps_per_pitch: u32,
        /// `z_1` and `z_2`.
        teeth: (u32, u32),
    },
}

impl SweepPlan {
    /// One wheel revolution.
    pub fn wheel_revolution(
        assembly: &impl ToothNumbers,
        steps_per_pitch: u32,
        start: (u32, u32),
    ) -> SweepPlan {
        SweepPlan::Revolution {
            pitches: u64::from(assembly.teeth(Member::Wheel)),
            steps_per_pitch,
            start,
        }
    }

    /// A full period until the same teeth meet again: lcm(z_1, z_2) pitches.
    pub fn hunting_cycle(
        assembly: &impl ToothNumbers,
        steps_per_pitch: u32,
        start: (u32, u32),
    ) -> SweepPlan {
        SweepPlan::Revolution {
            pitches: assembly.hunting_pitches(),
            steps_per_pitch,
            start,
        }
    }

    /// Number of assembly phases of two gears: gcd(z_1, z_2).
    pub fn phase_count(wheel_teeth: u32, pinion_teeth: u32) -> u32 {
        gcd(wheel_teeth, pinion_teeth).max(1)
    }

    /// Pitches of a hunting cycle: lcm(z_1, z_2).
    pub fn hunting_pitches(wheel_teeth: u32, pinion_teeth: u32) -> u64 {
        lcm(wheel_teeth, pinion_teeth)
    }

    /// The runs of this plan for one pair: one run, or one run per phase, named by its mating teeth.
    ///
    /// The phases are (1, 1), (1, 2), … (1, gcd): tooth 1 of the wheel meets every gcd-th pinion tooth.
    pub fn parts(&self) -> Vec<(Option<(u32, u32)>, SweepPlan)> {
        let &SweepPlan::Phases {
            steps_per_pitch,
            teeth,
        } = self
        else {
            return vec![(None, self.clone())];
        };
        let phase = |pinion_tooth| {
            let start = (1, pinion_tooth);
            let period = SweepPlan::Revolution {
                pitches: SweepPlan::hunting_pitches(teeth.0, teeth.1),
                steps_per_pitch,
                start,
            };
            (Some(start), period)
        };
        (1..=SweepPlan::phase_count(teeth.0, teeth.1))
            .map(phase)
            .collect()
    }

    /// Number of poses of one pair.
    pub fn poses(&self) -> u64 {
        match self {
            SweepPlan::Matings { matings, fractions } => {
                2 * matings.len() as u64 * fractions.len() as u64
            }
            SweepPlan::Revolution {
                pitches,
                steps_per_pitch,
                ..
            } => pitches * u64::from(*steps_per_pitch),
            SweepPlan::Phases {
                steps_per_pitch,
                teeth,
            } => u64::from(teeth.0) * u64::from(teeth.1) * u64::from(*steps_per_pitch),
        }
    }

    /// The matings in order. In a revolution each has the teeth of the last whole pitch and the fraction beyond it.
    pub fn matings(&self, assembly: &impl ToothNumbers) -> Vec<Mating> {
        match self {
            SweepPlan::Matings { matings, fractions } => {
                let flanks = |&(wheel, pinion): &(u32, u32)| {
                    Side::BOTH.map(|flank| Mating::at(wheel, pinion, flank))
                };
                let whole = matings.iter().flat_map(flanks);
                let of_one = |mating: Mating| {
                    let each = fractions.iter();
                    each.map(move |&fraction| Mating { fraction, ..mating })
                };
                whole.flat_map(of_one).collect()
            }
            &SweepPlan::Revolution {
                pitches,
                steps_per_pitch,
                start,
            } => {
                let steps = u64::from(steps_per_pitch);
                let first = Mating::at(start.0, start.1, Side::Right);
                (0..pitches * steps)
                    .map(|step| Mating {
                        fraction: (step % steps) as f64 / steps as f64,
                        ..first.onward(assembly, (step / steps) as f64)
                    })
                    .collect()
            }
            SweepPlan::Phases { .. } => {
                let parts = self.parts().into_iter();
                parts.flat_map(|(_, part)| part.matings(assembly)).collect()
            }
        }
    }
}
