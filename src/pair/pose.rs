//! Mating teeth, and the rotations of both gears that follow.

use super::{GearPair, Member};
use crate::gear::{Face, Side};
use crate::numeric::{gcd, lcm};

/// A pair of mating teeth (w, p) at a flank, and a fraction of a pitch beyond it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Mating {
    /// Wheel tooth, `1..=z_1`.
    pub wheel_tooth: u32,
    /// Pinion tooth, `1..=z_2`.
    pub pinion_tooth: u32,
    /// The flank, seen from the front, that passes through the operating pitch point.
    pub flank: Side,
    /// Pitches beyond that pose, towards ascending teeth of the locked gear.
    pub fraction: f64,
}

impl Mating {
    /// Tooth 1 of both gears on right flanks, at the operating pitch point.
    pub const FIRST: Mating = Mating {
        wheel_tooth: 1,
        pinion_tooth: 1,
        flank: Side::Right,
        fraction: 0.0,
    };

    /// These teeth with their `flank` at the operating pitch point.
    pub fn at(wheel_tooth: u32, pinion_tooth: u32, flank: Side) -> Mating {
        Mating {
            wheel_tooth,
            pinion_tooth,
            flank,
            fraction: 0.0,
        }
    }

    /// The mating's tooth on one gear.
    pub fn tooth(&self, member: Member) -> u32 {
        match member {
            Member::Wheel => self.wheel_tooth,
            Member::Pinion => self.pinion_tooth,
        }
    }

    /// The mating of the same wheel tooth at `flank`, in the same assembly phase.
    pub fn at_flank(&self, pair: &impl ToothNumbers, flank: Side) -> Mating {
        let steps = self.steps_to(flank);
        Mating {
            pinion_tooth: pair.counter_clockwise(Member::Pinion, self.pinion_tooth, steps),
            flank,
            ..*self
        }
    }

    /// Steps, counter-clockwise, from the tooth that faces `flank` to the tooth that faces the `other` flank of the same tooth.
    pub(crate) fn steps_between(&self, flank: Side, other: Side) -> i64 {
        self.steps_to(other) - self.steps_to(flank)
    }

    /// Steps, counter-clockwise, from the tooth that faces this mating's flank to the tooth that faces `flank` of the same tooth.
    ///
    /// The tooth facing a front-left flank is clockwise of the tooth facing the front-right flank.
    fn steps_to(&self, flank: Side) -> i64 {
        i64::from(self.flank == Side::Left) - i64::from(flank == Side::Left)
    }

    /// The mating of wheel tooth 1 at its right flank, in the same assembly phase.
    pub fn of_wheel_tooth_1(&self, pair: &impl ToothNumbers) -> Mating {
        let right = self.at_flank(pair, Side::Right);
        let ascending = pair.shown_face(Member::Wheel).ascending();
        let steps = ascending as i64 * (i64::from(self.wheel_tooth) - 1);
        Mating {
            pinion_tooth: pair.counter_clockwise(Member::Pinion, right.pinion_tooth, steps),
            ..Mating::FIRST
        }
    }

    /// The mating `pitches` later (earlier if negative), named by the teeth of the last whole pitch: `0 ≤ fraction < 1`.
    pub fn onward(&self, pair: &impl ToothNumbers, pitches: f64) -> Mating {
        let beyond = self.fraction + pitches;
        let whole = beyond.floor();
        // Numbers ascend counter-clockwise on a gear that shows its back.
        let steps = (pair.shown_face(pair.locked()).ascending() * whole) as i64;
        let (wheel_steps, pinion_steps) = match pair.locked() {
            Member::Wheel => (steps, -steps),
            Member::Pinion => (-steps, steps),
        };
        Mating {
            wheel_tooth: pair.counter_clockwise(Member::Wheel, self.wheel_tooth, wheel_steps),
            pinion_tooth: pair.counter_clockwise(Member::Pinion, self.pinion_tooth, pinion_steps),
            flank: self.flank,
            fraction: beyond - whole,
        }
    }
}

/// The tooth numbers of a pair.
pub trait ToothNumbers {
    /// Teeth of one of the gears.
    fn teeth(&self, member: Member) -> u32;
    /// The face of a gear towards the viewer.
    fn shown_face(&self, member: Member) -> Face;
    /// The locked gear.
    fn locked(&self) -> Member;

    /// Number of assembly phases: gcd(z_1, z_2).
    fn phase_count(&self) -> u32 {
        gcd(self.teeth(Member::Wheel), self.teeth(Member::Pinion)).max(1)
    }

    /// Pitches of a hunting cycle: lcm(z_1, z_2).
    fn hunting_pitches(&self) -> u64 {
        lcm(self.teeth(Member::Wheel), self.teeth(Member::Pinion))
    }

    /// The tooth of a gear `steps` places counter-clockwise of `tooth`.
    fn counter_clockwise(&self, member: Member, tooth: u32, steps: i64) -> u32 {
        let teeth = self.teeth(member);
        self.shown_face(member)
            .counter_clockwise(teeth, tooth, steps)
    }
}

impl ToothNumbers for GearPair {
    fn teeth(&self, member: Member) -> u32 {
        GearPair::teeth(self, member)
    }

    fn shown_face(&self, member: Member) -> Face {
        self.gear(member).face()
    }

    fn locked(&self) -> Member {
        GearPair::locked(self)
    }
}

/// A pose: the rotations of both gears, and the teeth that mate there.
///
/// Rotations count from tooth 1 pointing at the mate, rad, counter-clockwise.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Pose {
    mating: Mating,
    locked_rotation: f64,
    free_rotation: f64,
}

impl Pose {
    /// The pose of `mating` with the gears at these rotations, rad; that of the free gear is nominal.
    pub(crate) fn at(mating: Mating, locked_rotation: f64, free_rotation: f64) -> Pose {
        Pose {
            mating,
            locked_rotation,
            free_rotation,
        }
    }

    /// The pose of `mating` on `assembly`.
    ///
    /// The locked gear's undisturbed flank passes through the operating pitch point: its tooth's centre is half an operating tooth
    /// thickness off the line of centres. At the free gear's nominal rotation the flank of the facing tooth passes through it too. A
    /// fraction rolls both gears further.
    pub fn new(assembly: &GearPair, mating: Mating) -> Pose {
        let at_pitch_point = |member: Member| {
            let tooth = f64::from(mating.tooth(member));
            -mating.flank.sense() * assembly.operating_half_angle(member)
                - assembly.gear(member).tooth_angle(tooth)
        };
        let locked = assembly.gear(assembly.locked());
        let free = assembly.gear(assembly.free());
        let onward = -locked.face().ascending() * mating.fraction;
        Pose {
            mating,
            locked_rotation: at_pitch_point(assembly.locked())
                + onward * locked.gear().basic_data().angular_pitch(),
            free_rotation: at_pitch_point(assembly.free())
                - onward * free.gear().basic_data().angular_pitch(),
        }
    }

    /// This pose in the section of `assembly` at `b`, mm along the axis: a pose of [`GearPair::section`].
    ///
    /// The teeth of both gears roll by their twist and get new numbers. Helices of mating gears wind as the gears roll:
    /// `r_b1 τ_1 + r_b2 τ_2 = 0`. With unequal base pitches, the free gear's teeth follow its own twist instead of the locked gear's
    /// pitches.
    pub fn in_section(&self, assembly: &GearPair, b: f64) -> Pose {
        // A section is its own measuring plane. Where axes lean, its distance gives other nominal rotations than this pose has. Teeth of spur
        // gears do not wind.
        if b == 0.0 || !assembly.is_helical() {
            return *self;
        }
        let locked = assembly.gear(assembly.locked());
        let twist = assembly.twist(assembly.locked(), b);
        let onward = -locked.face().ascending() * twist;
        let pitches = onward / locked.gear().basic_data().angular_pitch();
        let pose = Pose::new(assembly, self.mating.onward(assembly, pitches));
        let free = assembly.gear(assembly.free()).gear().basic_data();
        // Helix and pressure angles are equal, and so are the base pitches.
        if free.module() == locked.gear().basic_data().module() {
            return pose;
        }
        // `pose` has rolled the free gear by as many pitches as the locked gear: replace that by its twist, and keep this pose's own offset.
        let by_pitches = -twist * free.angular_pitch() / locked.gear().basic_data().angular_pitch();
        let own = self.free_rotation - Pose::new(assembly, self.mating).free_rotation;
        Pose {
            free_rotation: pose.free_rotation
                + (own + assembly.twist(assembly.free(), b) - by_pitches),
            ..pose
        }
    }

    /// The mating of this pose.
    pub fn mating(&self) -> &Mating {
        &self.mating
    }

    /// Rotation of the locked gear, rad.
    pub fn locked_rotation(&self) -> f64 {
        self.locked_rotation
    }

    /// Nominal rotation of the free gear, rad: undisturbed flanks of the mating meet in the operating pitch point, then roll by the
    /// fraction.
    pub fn free_rotation(&self) -> f64 {
        self.free_rotation
    }

    /// Rotation of one of the gears of `assembly`, rad; that of the free gear is nominal.
    pub fn rotation(&self, assembly: &impl ToothNumbers, member: Member) -> f64 {
        if member == assembly.locked() {
            self.locked_rotation
        } else {
            self.free_rotation
        }
    }

    /// The locked gear's tooth `steps` counter-clockwise of the mating's tooth.
    pub(crate) fn locked_tooth(&self, assembly: &GearPair, steps: i64) -> u32 {
        let locked = assembly.locked();
        let tooth = self.mating.tooth(locked);
        assembly.gear(locked).counter_clockwise(tooth, steps)
    }

    /// The free gear's tooth that faces flank `side` of the locked tooth `steps` counter-clockwise of the mating's tooth.
    ///
    /// Counter-clockwise on one gear is clockwise on the other.
    pub fn facing_tooth(&self, assembly: &GearPair, side: Side, steps: i64) -> u32 {
        let free = assembly.free();
        let steps = self.mating.steps_to(side) - steps;
        assembly
            .gear(free)
            .counter_clockwise(self.mating.tooth(free), steps)
    }
}
