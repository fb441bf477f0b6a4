//! Transverse sections of a pair at a pose, also where axes lean.
//!
//! A gear whose toothing leans by `α` (mm per mm, in the picture at its rotation) shows in the section at `b` its own section at the height
//!
//! ```text
//! h = b k + α·(P − C)/k,        k = √(1 + α²),
//! ```
//!
//! stretched by `k` along `α`, where `C` is the place of its toothing's axis. Twist and lead are those at `h`, not at `b`. At the point `P` of a
//! flank with the normal `n`, they and the stretch act as a turn of the flank about the gear's own centre. `s` is its [`Side::sense`]:
//!
//! ```text
//! τ(h) − τ(b) + s (δ(h) − δ(b))/r_b + s (1 − 1/k)/α² (α·q)(n·α)/r_b,        q = P − C.
//! ```
//!
//! `P` is taken where the teeth touch on the line of action, or at the corner that touches beyond it. A flank whose height `h` lies beyond the
//! ends of its gear's teeth is not in the section: it is turned back out of the way. Centre and lean of the free gear are those at the rotation
//! at which the pair of the flank touches.
//!
//! The point of contact moves along the flank because `h` changes along it, with the slope `g = tan β_b (α_2 − α_1)·τ̂`. Each side is tighter
//! by `½ g² ρ` along the base tangent, with `ρ ≤ T/4`: [`GearPair::section_error_bound`].

use super::{GearPair, Member, Pose, overlap_half_angle};
use crate::gear::Side;
use crate::numeric::wrap_angle;
use nalgebra::{Rotation2, Vector2};
use std::f64::consts::PI;

/// Distance beyond the end of its teeth at which a flank is still in a section, mm: above the effect of flank deviations on the place of the
/// contact. [`beyond_ends_bound`] bounds its effect.
const AT_END: f64 = 1e-5;

/// Turn back of a flank that is not in a section, as a part of a pitch.
const TURNED_BACK: f64 = 0.05;

/// The transverse section of `assembly` at `b`, mm along the axis, as a plane pair, and `pose` in it.
///
/// Where axes are not parallel, the picture is turned so that the section's line of centres is the x axis. Flanks and centres of both
/// gears are turned with it, and rotations stay.
pub fn section_at(assembly: &GearPair, pose: &Pose, b: f64) -> (GearPair, Pose) {
    let (pair, here) = (assembly.section(b), pose.in_section(assembly, b));
    if !assembly.leans() {
        return (pair, here);
    }
    let leaning = Leaning::new(assembly, pose, &here, b);
    let between = leaning.between();
    let pair = pair.with_axes_turned(between.norm(), -between.y.atan2(between.x));
    (pair.with_flanks_turned(leaning.turns()), here)
}

/// Bound on what flanks that a section of `assembly` keeps beyond the ends of their teeth add to a contact, mm along the base tangent.
pub(crate) fn beyond_ends_bound(assembly: &GearPair) -> f64 {
    AT_END * (assembly.steepest_leads() + assembly.lean_bound())
}

/// Both gears in a section of leaning axes, in the picture of the measuring plane.
#[derive(Clone, Copy)]
pub(crate) struct Leaning<'a> {
    assembly: &'a GearPair,
    /// The pose in the section.
    pose: &'a Pose,
    /// The section, mm from the measuring plane.
    b: f64,
    /// Dimensions of both gears, wheel first.
    gears: [Dimensions; 2],
    /// Places of both axes, mm, wheel first.
    axes: [Vector2<f64>; 2],
    /// Lean of each shaft and of each toothing, mm per mm.
    shafts: [Vector2<f64>; 2],
    leans: [Vector2<f64>; 2],
    /// Centre of each outline, mm.
    centres: [Vector2<f64>; 2],
    /// Both ends of the teeth of each gear, mm from this section.
    faces: [[f64; 2]; 2],
}

/// Dimensions of a gear.
#[derive(Clone, Copy)]
struct Dimensions {
    /// `r_b`, mm, and `ψ_b`, rad.
    base: f64,
    half_base: f64,
    /// `τ`, rad, and twist, rad/mm.
    pitch: f64,
    twist: f64,
}

/// Turns of the right and left flanks of every tooth, rad, counter-clockwise, tooth 1 first.
type Turns = [Vec<f64>; 2];

impl<'a> Leaning<'a> {
    /// The section of `assembly` at `b`, mm. The pose is `in_plane` in the measuring plane and `pose` in the section.
    pub fn new(assembly: &'a GearPair, in_plane: &Pose, pose: &'a Pose, b: f64) -> Leaning<'a> {
        let lean = Vector2::from(assembly.lean());
        let shafts = [Vector2::zeros(), lean];
        let axes = Member::BOTH.map(|member| assembly.axis(member).coords);
        let axes = [axes[0], axes[1] + b * lean];
        let tooth_1 =
            |member| in_plane.rotation(assembly, member) + assembly.mate_direction(member);
        let own = Member::BOTH.map(|member| assembly.gear(member).lean(tooth_1(member)));
        let centres = Member::BOTH.map(|member| {
            let plane = assembly.gear(member).displacement(tooth_1(member));
            axes[member as usize] + plane + b * own[member as usize]
        });
        Leaning {
            assembly,
            pose,
            b,
            gears: Member::BOTH.map(|member| {
                let gear = assembly.gear(member).gear();
                Dimensions {
                    base: gear.base_radius(),
                    half_base: gear.half_base_angle(),
                    pitch: gear.basic_data().angular_pitch(),
                    twist: gear.basic_data().twist(),
                }
            }),
            axes,
            shafts,
            leans: [0, 1].map(|k| shafts[k] + own[k]),
            centres,
            faces: Member::BOTH.map(|member| assembly.own_face(member).map(|end| end - b)),
        }
    }

    /// From the wheel's axis to the pinion's, mm.
    pub fn between(&self) -> Vector2<f64> {
        self.axes[1] - self.axes[0]
    }

    /// From its axis to the centre of a gear's outline, mm.
    pub fn displacement(&self, member: Member) -> Vector2<f64> {
        self.centres[member as usize] - self.axes[member as usize]
    }

    /// Turns of the flanks of the wheel and of the pinion.
    fn turns(&self) -> [Turns; 2] {
        let mut turns = Member::BOTH.map(|member| {
            let teeth = self.assembly.teeth(member) as usize;
            [vec![0.0; teeth], vec![0.0; teeth]]
        });
        let (pair, pose) = (self.assembly, self.pose);
        let members = [pair.locked(), pair.free()];
        let teeth = members.map(|member| pair.teeth(member));
        let most_steps = (i64::from(teeth[0].max(teeth[1])) / 2).min(self.steps_in_reach());
        for side in Side::BOTH {
            let touching = self.touching(side);
            // From the line of centres outwards: the first facing of a tooth is the one that can touch.
            let mut is_turned = teeth.map(|teeth| vec![false; teeth as usize]);
            let steps = (0..=2 * most_steps).map(|k| if k % 2 == 0 { k / 2 } else { -(k + 1) / 2 });
            for step in steps.map(|step| touching.nearest + step) {
                let numbers = [
                    pose.locked_tooth(pair, step),
                    pose.facing_tooth(pair, side, step),
                ];
                let turned = touching.turns(step);
                for k in [0, 1] {
                    let place = numbers[k] as usize - 1;
                    if !std::mem::replace(&mut is_turned[k][place], true) {
                        turns[members[k] as usize][side.index()][place] = turned[k];
                    }
                }
            }
        }
        turns
    }

    /// Steps from the pair nearest to the line of centres to the last that can reach each other.
    fn steps_in_reach(&self) -> i64 {
        let distance = self.between().norm();
        let reach = Member::BOTH.map(|member| {
            let tip = self.assembly.gear(member).gear().tip_radius();
            tip + self.displacement(member).norm()
        });
        let steps = Member::BOTH.map(|member| {
            let [own, mate] = [reach[member as usize], reach[1 - member as usize]];
            let half = overlap_half_angle(own, mate, distance).unwrap_or(0.0);
            (half / self.gears[member as usize].pitch).ceil() as i64
        });
        // The flank and the far corner of a tooth are less than a pitch apart.
        steps[0].max(steps[1]) + 2
    }

    /// Direction of a flank in this section without its lean, less that of its tooth's undisturbed centre line, rad.
    fn flank(&self, member: Member, side: Side, tooth: u32) -> f64 {
        let (gear, own) = (self.assembly.gear(member), &self.gears[member as usize]);
        let lead = gear.lead_change(side, tooth, [0.0, self.b]);
        gear.flank_offset(side, tooth) + side.sense() * (lead / own.base + own.half_base)
    }

    /// The teeth of `side` on the line of action, with the free gear where the pair nearest to the line of centres touches.
    pub fn touching(&self, side: Side) -> LeaningSide<'a> {
        let (pair, pose) = (self.assembly, self.pose);
        let (locked, free) = (pair.locked(), pair.free());
        let gears = [locked, free].map(|member| pair.gear(member).gear());
        let mating = pose.mating().tooth(locked);
        let from_line = pose.locked_rotation() + pair.gear(locked).tooth_angle(f64::from(mating));
        let pitch = self.gears[locked as usize].pitch;
        let mut touching = LeaningSide {
            leaning: *self,
            side,
            bases: [locked, free].map(|member| self.gears[member as usize].base),
            rolls: gears.map(|gear| [gear.form_roll(), gear.tip_roll()]),
            length: 0.0,
            tangent: 0.0,
            direction: Vector2::zeros(),
            nearest: -(from_line / pitch).round() as i64,
            mating_at: pair.mate_direction(locked) + from_line,
            free_turned: 0.0,
            free_moves: self.displacement(free) != Vector2::zeros()
                || self.leans[free as usize] != self.shafts[free as usize],
        };
        touching.update_line_of_action();
        if touching.free_moves {
            touching.turn_free();
            touching.update_line_of_action();
        }
        touching
    }
}

/// The teeth of one side in a section of leaning axes, on the line of action.
pub(crate) struct LeaningSide<'a> {
    leaning: Leaning<'a>,
    side: Side,
    /// Base radii and ends of the involutes of the locked and the free gear, mm and rad.
    bases: [f64; 2],
    rolls: [[f64; 2]; 2],
    /// `T`, mm.
    length: f64,
    /// Direction of its tangent point on the locked base circle, rad, and as a vector.
    tangent: f64,
    direction: Vector2<f64>,
    /// Step from the mating's locked tooth to that nearest to the line of centres.
    nearest: i64,
    /// Direction of the mating's locked tooth without deviations, rad.
    mating_at: f64,
    /// Rotation of the free gear from nominal to where the nearest pair touches, rad.
    free_turned: f64,
    /// Whether the free outline is off its axis, or leans on its shaft.
    free_moves: bool,
}

impl LeaningSide<'_> {
    fn members(&self) -> [Member; 2] {
        [self.leaning.assembly.locked(), self.leaning.assembly.free()]
    }

    fn update_line_of_action(&mut self) {
        let [locked, free] = self
            .members()
            .map(|member| self.leaning.centres[member as usize]);
        let (between, sum) = (free - locked, self.bases[0] + self.bases[1]);
        let square = between.norm_squared();
        self.length = (square - sum * sum).max(0.0).sqrt();
        let beside = -self.side.sense() * self.length;
        self.tangent = between.y.atan2(between.x) + beside.atan2(sum);
        let turned = Vector2::new(
            between.x * sum - between.y * beside,
            between.y * sum + between.x * beside,
        );
        self.direction = turned / square;
    }

    /// Turns the free gear to where the pair nearest to the line of centres touches.
    fn turn_free(&mut self) {
        let roll = self.roll(self.nearest);
        self.free_turned = self.free_turn(self.nearest, roll);
        let (leaning, turned) = (&mut self.leaning, Rotation2::new(self.free_turned));
        let free = leaning.assembly.free() as usize;
        let off = leaning.centres[free] - leaning.axes[free];
        leaning.centres[free] = leaning.axes[free] + turned * off;
        leaning.leans[free] =
            leaning.shafts[free] + turned * (leaning.leans[free] - leaning.shafts[free]);
    }

    /// Roll of the locked flank of a step on the line, rad.
    fn roll(&self, step: i64) -> f64 {
        let (leaning, s) = (&self.leaning, self.side.sense());
        let (pair, locked) = (leaning.assembly, leaning.assembly.locked());
        let pitch = leaning.gears[locked as usize].pitch;
        let tooth = leaning.pose.locked_tooth(pair, step);
        let flank = leaning.flank(locked, self.side, tooth);
        -s * wrap_angle(self.tangent - (self.mating_at + step as f64 * pitch + flank))
    }

    /// Roll of the free flank on the line, rad, whose mate has the roll `roll`.
    fn mate_roll(&self, roll: f64) -> f64 {
        (self.length - self.bases[0] * roll) / self.bases[1]
    }

    /// Rotation of the free gear from nominal to where the pair of a step touches, rad; `roll` is that of its locked flank.
    fn free_turn(&self, step: i64, roll: f64) -> f64 {
        let leaning = &self.leaning;
        let (pair, free) = (leaning.assembly, leaning.assembly.free());
        let facing = leaning.pose.facing_tooth(pair, self.side, step);
        let flank = pair.mate_direction(free)
            + leaning.pose.rotation(pair, free)
            + pair.gear(free).tooth_angle(f64::from(facing))
            + leaning.flank(free, self.side, facing);
        // θ_T = θ_0 − s ξ on either gear.
        let wanted = self.tangent + PI + self.side.sense() * self.mate_roll(roll);
        wrap_angle(wanted - flank)
    }

    /// Turns of the locked and the free flank of a step from the mating's locked tooth, rad.
    pub fn turns(&self, step: i64) -> [f64; 2] {
        let (mut leaning, s, side) = (self.leaning, self.side.sense(), self.side);
        let (pair, bases, rolls) = (leaning.assembly, self.bases, self.rolls);
        let [locked, free] = self.members();
        let numbers = [
            leaning.pose.locked_tooth(pair, step),
            leaning.pose.facing_tooth(pair, side, step),
        ];
        let roll = self.roll(step);
        let mate_roll = self.mate_roll(roll);
        if self.free_moves {
            // Pairs touch at rotations that differ by deviations.
            leaning.turn_free_slightly(self.free_turn(step, roll) - self.free_turned);
        }
        let mates = rolls[1].map(|roll| (self.length - bases[1] * roll) / bases[0]);
        let (least, most) = (rolls[0][0].max(mates[1]), rolls[0][1].min(mates[0]));
        let normal = s * Vector2::new(-self.direction.y, self.direction.x);
        // P = C + r_b E (1 ± iξ); a corner lies on its own tangent, turned back by what its roll is beyond it.
        let at = |member: Member, k: usize, beyond: f64, roll: f64| {
            let sense = if k == 0 { 1.0 } else { -1.0 };
            let point = bases[k] * sense * (self.direction + roll * normal);
            let point = if beyond == 0.0 {
                point
            } else {
                Rotation2::new(s * beyond) * point
            };
            leaning.centres[member as usize] + point
        };
        let point = match corner(roll, [least, most], rolls) {
            None => at(locked, 0, 0.0, roll),
            Some((0, end)) => at(locked, 0, roll - end, end),
            Some((_, end)) => at(free, 1, mate_roll - end, end),
        };
        [
            leaning.turn_of(locked, side, numbers[0], point, normal),
            leaning.turn_of(free, side, numbers[1], point, -normal),
        ]
    }
}

impl Leaning<'_> {
    /// Turns the free gear by a slight angle, rad.
    fn turn_free_slightly(&mut self, angle: f64) {
        let free = self.assembly.free() as usize;
        let across = |v: Vector2<f64>| angle * Vector2::new(-v.y, v.x);
        self.leans[free] += across(self.leans[free] - self.shafts[free]);
        self.centres[free] += across(self.centres[free] - self.axes[free]);
    }

    /// Turn of a tooth's flank that touches at `point` with the outward `normal`.
    fn turn_of(
        &self,
        member: Member,
        side: Side,
        tooth: u32,
        point: Vector2<f64>,
        normal: Vector2<f64>,
    ) -> f64 {
        let (gear, lean) = (self.assembly.gear(member), self.leans[member as usize]);
        let from_axis = point - self.centres[member as usize];
        let square = lean.norm_squared();
        let (s, own) = (side.sense(), &self.gears[member as usize]);
        let k = (1.0 + square).sqrt();
        let along = lean.dot(&from_axis);
        // Over this section.
        let height = self.b * (k - 1.0) + along / k;
        let [from, to] = self.faces[member as usize];
        if height < from - AT_END || height > to + AT_END {
            return -s * TURNED_BACK * own.pitch;
        }
        if square == 0.0 {
            return 0.0;
        }
        let lead = gear.lead_change(side, tooth, [self.b, self.b + height]);
        let stretch = (1.0 - 1.0 / k) / square * along * normal.dot(&lean);
        height * own.twist + s * (lead + stretch) / own.base
    }
}

/// The gear (0 locked, 1 free) whose corner touches, and the corner's roll, where the rolls on the line are not between `least` and `most`
/// of the locked one.
fn corner(roll: f64, [least, most]: [f64; 2], ends: [[f64; 2]; 2]) -> Option<(usize, f64)> {
    if roll < least {
        Some(if least > ends[0][0] {
            (1, ends[1][1])
        } else {
            (0, ends[0][0])
        })
    } else if roll > most {
        Some(if most < ends[0][1] {
            (1, ends[1][0])
        } else {
            (0, ends[0][1])
        })
    } else {
        None
    }
}
