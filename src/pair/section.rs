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
//! by `½ g² ρ` along the base tangent, with `ρ ≤ T/4`: [`GearPair::left_out`].

use super::{GearPair, Member, Pose, lens_half};
use crate::gear::{AsBuilt, Side};
use nalgebra::{Rotation2, Vector2};
use std::f64::consts::PI;

/// Distance beyond the end of its teeth at which a flank is still in a section, mm: above the effect of flank deviations on the place of the
/// contact. [`GearPair::beyond_ends`] bounds its effect.
const AT_END: f64 = 1e-5;

/// Turn back of a flank that is not in a section, as a part of a pitch.
const TURNED_BACK: f64 = 0.05;

impl Pose {
    /// The transverse section of `assembly` at `b`, mm along the axis, as a plane pair, and this pose in it.
    ///
    /// Where axes are not parallel, the picture is turned so that the section's line of centres is the x axis. Flanks and centres of both
    /// gears are turned with it, and rotations stay.
    pub fn section(&self, assembly: &GearPair, b: f64) -> (GearPair, Pose) {
        let (pair, pose) = (assembly.section(b), self.in_section(assembly, b));
        if !assembly.leans() {
            return (pair, pose);
        }
        let [x, y] = assembly.lean().map(|rate| rate * b);
        let between = Vector2::new(assembly.center_distance() + x, y);
        let turned = between.y.atan2(between.x);
        let pair = pair.with_axes_turned(between.norm(), -turned);
        let leaning = Leaning::new(assembly, self, &pair, &pose, (b, turned));
        let [wheel, pinion] = leaning.turns();
        (pair.with_flanks_turned(wheel, pinion), pose)
    }
}

impl GearPair {
    /// Bound on what flanks that a section keeps beyond the ends of their teeth add to a contact, mm along the base tangent.
    pub(crate) fn beyond_ends(&self) -> f64 {
        let height = self.most_height();
        let [from, to] = self.face();
        let rate = |member| {
            self.gear(member)
                .steepest_lead([from - height, to + height])
        };
        AT_END * (rate(Member::Wheel) + rate(Member::Pinion) + self.most_lean())
    }
}

/// The line of action of one side in a section.
struct LineOfAction<'a> {
    /// The locked gear.
    gear: &'a AsBuilt,
    side: Side,
    /// Base radii of the locked and the free gear, mm.
    bases: [f64; 2],
    /// `T`, mm.
    length: f64,
    /// Direction of its tangent point on the locked base circle, rad.
    tangent: f64,
    /// Step from the mating's locked tooth to that nearest to the line of centres.
    nearest: i64,
    /// The mating's locked tooth, and its direction without deviations, rad.
    mating: u32,
    mating_at: f64,
}

impl LineOfAction<'_> {
    /// Roll of the locked tooth of a step on the line, rad.
    fn roll(&self, step: i64) -> f64 {
        let (gear, s) = (self.gear, self.side.sense());
        let tooth = gear.counter_clockwise(self.mating, step);
        let centre = self.mating_at + step as f64 * gear.gear().basic_data().angular_pitch();
        let flank =
            centre + gear.flank_offset(self.side, tooth) + s * gear.gear().half_base_angle();
        -s * reduced(self.tangent - flank)
    }
}

/// Both gears in a section of leaning axes.
#[derive(Clone, Copy)]
struct Leaning<'a> {
    pair: &'a GearPair,
    pose: &'a Pose,
    /// Lean of each shaft and of each toothing in the picture of the section, mm per mm, wheel first.
    axes: [Vector2<f64>; 2],
    leans: [Vector2<f64>; 2],
    /// Centre of each outline, mm, wheel first.
    centres: [Vector2<f64>; 2],
    /// Both ends of the teeth of each gear, mm from this section.
    faces: [[f64; 2]; 2],
    /// The section, mm from the measuring plane.
    b: f64,
}

/// Turns of the right and left flanks of every tooth, rad, counter-clockwise, tooth 1 first.
type Turns = [Vec<f64>; 2];

impl<'a> Leaning<'a> {
    fn new(
        assembly: &GearPair,
        whole: &Pose,
        pair: &'a GearPair,
        pose: &'a Pose,
        (b, turned): (f64, f64),
    ) -> Leaning<'a> {
        let back = Rotation2::new(-turned);
        let axes = [Vector2::zeros(), back * Vector2::from(assembly.lean())];
        let leans = Member::BOTH.map(|member| {
            let tooth_1 = whole.rotation(assembly, member) + assembly.mate_direction(member);
            axes[member as usize] + back * assembly.gear(member).lean(tooth_1)
        });
        let centres = Member::BOTH.map(|member| {
            let tooth_1 = pose.rotation(pair, member) + pair.mate_direction(member);
            pair.axis(member).coords + pair.gear(member).displacement(tooth_1)
        });
        Leaning {
            pair,
            pose,
            axes,
            leans,
            centres,
            faces: Member::BOTH.map(|member| assembly.own_face(member).map(|end| end - b)),
            b,
        }
    }

    /// Turns of the flanks of the wheel and of the pinion.
    fn turns(&self) -> [Turns; 2] {
        let [mut wheel, mut pinion] = Member::BOTH.map(|member| {
            let teeth = self.pair.teeth(member) as usize;
            [vec![0.0; teeth], vec![0.0; teeth]]
        });
        for side in Side::BOTH {
            let index = side.index();
            self.turn(side, [&mut wheel[index], &mut pinion[index]]);
        }
        [wheel, pinion]
    }

    /// These gears with the free one where the pair of a step touches on `line`.
    fn at_contact(&self, line: &LineOfAction, step: i64) -> Leaning<'a> {
        let (pair, free, side) = (self.pair, self.pair.free(), line.side);
        let mate = (line.length - line.bases[0] * line.roll(step)) / line.bases[1];
        // θ_T = θ_0 − s ξ on either gear.
        let wanted = line.tangent + PI + side.sense() * mate;
        let facing = self.pose.facing_tooth(pair, side, step);
        let gear = pair.gear(free);
        let tooth_1 = pair.mate_direction(free) + self.pose.rotation(pair, free);
        let flank = tooth_1
            + gear.tooth_angle(f64::from(facing))
            + gear.flank_offset(side, facing)
            + side.sense() * gear.gear().half_base_angle();
        let beyond = reduced(wanted - flank);
        let index = free as usize;
        let mut here = *self;
        here.centres[index] = pair.axis(free).coords + gear.displacement(tooth_1 + beyond);
        here.leans[index] =
            self.axes[index] + Rotation2::new(beyond) * (self.leans[index] - self.axes[index]);
        here
    }

    /// The line of action of `side`.
    fn line(&self, side: Side) -> LineOfAction<'_> {
        let (pair, pose) = (self.pair, self.pose);
        let (locked, free) = (pair.locked(), pair.free());
        let bases = [locked, free].map(|member| pair.gear(member).gear().base_radius());
        let sum = bases[0] + bases[1];
        let between = self.centre(free) - self.centre(locked);
        let length = (between.norm_squared() - sum * sum).max(0.0).sqrt();
        let gear = pair.gear(locked);
        let mating = pose.mating().tooth(locked);
        let from_line = pose.locked_rotation() + gear.tooth_angle(f64::from(mating));
        let pitch = gear.gear().basic_data().angular_pitch();
        LineOfAction {
            gear,
            side,
            bases,
            length,
            tangent: between.y.atan2(between.x) - side.sense() * length.atan2(sum),
            nearest: -(from_line / pitch).round() as i64,
            mating,
            mating_at: pair.mate_direction(locked) + from_line,
        }
    }

    /// Adds the turns of the flanks of `side` of both gears.
    fn turn(&self, side: Side, turns: [&mut Vec<f64>; 2]) {
        let (pair, pose) = (self.pair, self.pose);
        let (locked, free) = (pair.locked(), pair.free());
        let gears = [locked, free].map(|member| pair.gear(member));
        let pose_line = self.line(side);
        let (bases, nearest, mating) = (pose_line.bases, pose_line.nearest, pose_line.mating);
        let s = side.sense();
        let [locked_turns, free_turns] = match locked {
            Member::Wheel => turns,
            Member::Pinion => {
                let [wheel, pinion] = turns;
                [pinion, wheel]
            }
        };
        let rolls = gears.map(|gear| [gear.gear().form_roll(), gear.gear().tip_roll()]);
        let teeth = gears.map(|gear| gear.gear().basic_data().teeth());
        let most_steps = (i64::from(teeth[0].max(teeth[1])) / 2).min(self.steps_in_reach());
        // From the line of centres outwards: the first facing of a tooth is the one that can touch.
        let mut is_turned = teeth.map(|teeth| vec![false; teeth as usize]);
        let steps = (0..=2 * most_steps).map(|k| if k % 2 == 0 { k / 2 } else { -(k + 1) / 2 });
        for step in steps.map(|step| nearest + step) {
            let tooth = gears[0].counter_clockwise(mating, step);
            let facing = pose.facing_tooth(pair, side, step);
            let here = self.at_contact(&pose_line, step);
            let line = here.line(side);
            let length = line.length;
            let direction = Vector2::new(line.tangent.cos(), line.tangent.sin());
            let normal = s * Vector2::new(-direction.y, direction.x);
            let mates = rolls[1].map(|roll| (length - bases[1] * roll) / bases[0]);
            let (least, most) = (rolls[0][0].max(mates[1]), rolls[0][1].min(mates[0]));
            let roll = line.roll(step);
            let mate = (length - bases[0] * roll) / bases[1];
            let corner = corner(roll, [least, most], rolls);
            // P = C + r_b E (1 ± iξ); a corner lies on its own tangent, turned back by what its roll is beyond it.
            let at = |member: Member, k: usize, from: Vector2<f64>, beyond: f64, roll: f64| {
                let turn = Rotation2::new(s * beyond);
                let (direction, normal) = (turn * from, turn * normal);
                let outward = if k == 0 { normal } else { -normal };
                here.centre(member) + bases[k] * (direction + roll * outward)
            };
            let point = match corner {
                None => at(locked, 0, direction, 0.0, roll),
                Some((0, end)) => at(locked, 0, direction, roll - end, end),
                Some((_, end)) => at(free, 1, -direction, mate - end, end),
            };
            let own = [(locked, tooth, normal), (free, facing, -normal)];
            for (k, (member, tooth, normal)) in own.into_iter().enumerate() {
                let place = tooth as usize - 1;
                if !std::mem::replace(&mut is_turned[k][place], true) {
                    let turned = here.turn_of(member, side, tooth, point, normal);
                    if k == 0 {
                        locked_turns[place] = turned;
                    } else {
                        free_turns[place] = turned;
                    }
                }
            }
        }
    }

    /// Steps from the pair nearest to the line of centres to the last that can reach each other.
    fn steps_in_reach(&self) -> i64 {
        let distance = self.pair.center_distance();
        let reach = Member::BOTH.map(|member| self.pair.gear(member).reach());
        let steps = Member::BOTH.map(|member| {
            let [own, mate] = [reach[member as usize], reach[1 - member as usize]];
            let pitch = self.pair.gear(member).gear().basic_data().angular_pitch();
            let half = lens_half(own, mate, distance).unwrap_or(0.0);
            (half / pitch).ceil() as i64
        });
        // The flank and the far corner of a tooth are less than a pitch apart.
        steps[0].max(steps[1]) + 2
    }

    fn centre(&self, member: Member) -> Vector2<f64> {
        self.centres[member as usize]
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
        let (gear, lean) = (self.pair.gear(member), self.leans[member as usize]);
        let from_axis = point - self.centre(member);
        let square = lean.norm_squared();
        let (s, base) = (side.sense(), gear.gear().base_radius());
        let k = (1.0 + square).sqrt();
        let along = lean.dot(&from_axis);
        // Over this section.
        let height = self.b * (k - 1.0) + along / k;
        let [from, to] = self.faces[member as usize];
        if height < from - AT_END || height > to + AT_END {
            return -s * TURNED_BACK * gear.gear().basic_data().angular_pitch();
        }
        if square == 0.0 {
            return 0.0;
        }
        let lead = gear.lead(side, tooth, height) - gear.lead(side, tooth, 0.0);
        let stretch = (1.0 - 1.0 / k) / square * along * normal.dot(&lean);
        height * gear.gear().basic_data().twist() + s * (lead + stretch) / base
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

/// `angle` within ±π.
fn reduced(angle: f64) -> f64 {
    angle - 2.0 * PI * (angle / (2.0 * PI)).round()
}
