//! Which poses a simulation takes.

use super::{Assembly, Mating, Member};
use crate::gear::Side;

/// The poses of a simulation.
#[derive(Debug, Clone, PartialEq)]
pub enum SweepPlan {
    /// A right-flank and a left-flank pose of each mating, at each fraction of a pitch beyond.
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
        /// Poses a pitch.
        steps_per_pitch: u32,
        /// Mating (right flank) of the first pose.
        start: (u32, u32),
    },
}

impl SweepPlan {
    /// One wheel revolution.
    pub fn wheel_revolution(
        assembly: &Assembly,
        steps_per_pitch: u32,
        start: (u32, u32),
    ) -> SweepPlan {
        SweepPlan::Revolution {
            pitches: u64::from(teeth(assembly, Member::Wheel)),
            steps_per_pitch,
            start,
        }
    }

    /// Until the same teeth meet again: lcm(z_1, z_2) pitches.
    pub fn hunting_cycle(
        assembly: &Assembly,
        steps_per_pitch: u32,
        start: (u32, u32),
    ) -> SweepPlan {
        SweepPlan::Revolution {
            pitches: SweepPlan::hunting_pitches(
                teeth(assembly, Member::Wheel),
                teeth(assembly, Member::Pinion),
            ),
            steps_per_pitch,
            start,
        }
    }

    /// Pitches of a hunting cycle: lcm(z_1, z_2).
    pub fn hunting_pitches(wheel_teeth: u32, pinion_teeth: u32) -> u64 {
        let (wheel, pinion) = (u64::from(wheel_teeth), u64::from(pinion_teeth));
        let (mut a, mut b) = (wheel, pinion);
        while b != 0 {
            (a, b) = (b, a % b);
        }
        wheel / a.max(1) * pinion
    }

    /// Number of poses of one run.
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
        }
    }

    /// The matings in order. In a revolution each names the pair of the last whole step and the fraction beyond it.
    pub fn matings(&self, assembly: &Assembly) -> Vec<Mating> {
        match self {
            SweepPlan::Matings { matings, fractions } => {
                let mut list = Vec::with_capacity(2 * matings.len() * fractions.len());
                for &(wheel_tooth, pinion_tooth) in matings {
                    for flank in Side::BOTH {
                        for &fraction in fractions {
                            list.push(Mating {
                                wheel_tooth,
                                pinion_tooth,
                                flank,
                                fraction,
                            });
                        }
                    }
                }
                list
            }
            &SweepPlan::Revolution {
                pitches,
                steps_per_pitch,
                start,
            } => {
                let steps = u64::from(steps_per_pitch);
                (0..pitches * steps)
                    .map(|step| {
                        let (whole, part) = (step / steps, step % steps);
                        let (wheel_tooth, pinion_tooth) = onward(assembly, start, whole);
                        Mating {
                            wheel_tooth,
                            pinion_tooth,
                            flank: Side::Right,
                            fraction: part as f64 / steps as f64,
                        }
                    })
                    .collect()
            }
        }
    }
}

fn teeth(assembly: &Assembly, member: Member) -> u32 {
    assembly.gear(member).gear().toothing().teeth()
}

/// The mating `pitches` after `start`, the locked gear's teeth ascending.
fn onward(assembly: &Assembly, start: (u32, u32), pitches: u64) -> (u32, u32) {
    let locked = assembly.gear(assembly.locked());
    let cycle =
        u64::from(teeth(assembly, Member::Wheel)) * u64::from(teeth(assembly, Member::Pinion));
    let pitches = (pitches % cycle) as i64;
    // Ascending numbers stand counter-clockwise on a gear that shows its back.
    let steps = locked.face().ascending() as i64 * pitches;
    let (wheel_steps, pinion_steps) = match assembly.locked() {
        Member::Wheel => (steps, -steps),
        Member::Pinion => (-steps, steps),
    };
    (
        assembly
            .gear(Member::Wheel)
            .counter_clockwise(start.0, wheel_steps),
        assembly
            .gear(Member::Pinion)
            .counter_clockwise(start.1, pinion_steps),
    )
}
