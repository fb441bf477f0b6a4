//! Whole teeth as solids: at which rotations of the free gear do two outlines overlap?
//!
//! A point is in a tooth when its radius about the gear's centre is below the tip's and its angle lies between the
//! tooth's two flanks there. The outlines' points (lands and the outer flanks, corners among them) of
//! each gear are asked for in the other's teeth, and rotations bisected. Tips only: nothing below `DEPTH`.

use gearlash::contact::LostMotion;
use gearlash::gear::{AsBuilt, Profile, ProfilePart, Side, involute};
use gearlash::pair::{GearPair, Member, Pose};
use nalgebra::{Point2, Rotation2, Vector2};

/// How far down the flanks are looked at, modules.
const DEPTH: f64 = 0.4;

/// Points on each land, and on each flank.
const POINTS: usize = 400;

struct Solid<'a> {
    gear: &'a AsBuilt,
    axis: Point2<f64>,
    tooth_1: f64,
    /// Outlines of the tooth frame without offsets, by side: land from the middle to the corner, then the flank.
    halves: [Vec<Vector2<f64>>; 2],
}

impl<'a> Solid<'a> {
    fn new(assembly: &'a GearPair, member: Member, rotation: f64) -> Solid<'a> {
        let gear = assembly.gear(member);
        let profile = Profile::new(gear.gear());
        let (_, corner) = profile.range(ProfilePart::Tip);
        let (tip_roll, form_roll) = profile.range(ProfilePart::Involute);
        let depth = DEPTH * gear.gear().basic_data().module();
        let inner = gear.gear().tip_radius() - depth;
        let end = involute::roll_at(inner, gear.gear().base_radius()).max(form_roll);
        let halves = Side::BOTH.map(|side| {
            let share = |k: usize| k as f64 / POINTS as f64;
            let land = (0..=POINTS).map(|k| (ProfilePart::Tip, corner * share(k)));
            let flank = (0..=POINTS).map(|k| {
                (
                    ProfilePart::Involute,
                    tip_roll + (end - tip_roll) * share(k),
                )
            });
            land.chain(flank)
                .map(|(curve, t)| profile.point(curve, t, side).coords)
                .collect()
        });
        Solid {
            gear,
            axis: assembly.axis(member),
            tooth_1: assembly.mate_direction(member) + rotation,
            halves,
        }
    }

    fn centre(&self) -> Point2<f64> {
        self.axis + self.gear.displacement(self.tooth_1)
    }

    /// The three teeth nearest to the direction of `place`.
    fn teeth_towards(&self, place: Point2<f64>) -> [u32; 3] {
        let to = place - self.centre();
        let pitch = self.gear.gear().basic_data().angular_pitch();
        let k = ((to.y.atan2(to.x) - self.tooth_1) / pitch).round() as i64;
        [-1, 0, 1].map(|beside| self.gear.counter_clockwise(1, k + beside))
    }

    fn direction(&self, tooth: u32) -> f64 {
        self.tooth_1 + self.gear.tooth_angle(f64::from(tooth))
    }

    fn holds(&self, point: Point2<f64>) -> bool {
        let gear = self.gear.gear();
        let arm = point - self.centre();
        let radius = arm.norm();
        if radius >= gear.tip_radius() {
            return false;
        }
        let half = gear.half_angle_at_roll(involute::roll_at(
            radius.max(gear.base_radius()),
            gear.base_radius(),
        ));
        self.teeth_towards(point).into_iter().any(|tooth| {
            let seen = Rotation2::new(-self.direction(tooth)) * arm;
            let angle = seen.y.atan2(seen.x);
            angle > self.gear.flank_offset(Side::Right, tooth) - half
                && angle < self.gear.flank_offset(Side::Left, tooth) + half
        })
    }

    fn points(&self, towards: Point2<f64>) -> impl Iterator<Item = Point2<f64>> + '_ {
        let centre = self.centre();
        self.teeth_towards(towards)
            .into_iter()
            .flat_map(move |tooth| {
                [0, 1].into_iter().flat_map(move |i| {
                    let offset = self.gear.flank_offset(Side::BOTH[i], tooth);
                    let turn = Rotation2::new(self.direction(tooth) + offset);
                    self.halves[i]
                        .iter()
                        .map(move |point| centre + turn * point)
                })
            })
    }
}

fn overlap(locked: &Solid, free: &Solid) -> bool {
    // Nothing further out reaches the other gear.
    let near = |one: &Solid, other: &Solid| {
        let reach = other.gear.reach();
        one.points(other.axis)
            .any(|point| (point - other.axis).norm() < reach && other.holds(point))
    };
    near(locked, free) || near(free, locked)
}

/// Rotations at which the free gear first overlaps the locked one, clockwise and counter-clockwise. They start from the middle between
/// `found`'s contacts, or from a free position without contacts. Steps are a 200th of a pitch: a shorter overlap can be missed.
pub fn limits(assembly: &GearPair, pose: &Pose, found: &LostMotion) -> [Option<f64>; 2] {
    let free = assembly.free();
    let locked = Solid::new(assembly, assembly.locked(), pose.locked_rotation());
    let pitch = assembly.gear(free).gear().basic_data().angular_pitch();
    let mut turned = Solid::new(assembly, free, 0.0);
    let zero = turned.tooth_1;
    let mut overlaps = |rotation: f64| {
        turned.tooth_1 = zero + rotation;
        overlap(&locked, &turned)
    };
    let middle = match (found.right, found.left) {
        (Some(right), Some(left)) => 0.5 * (right.rotation + left.rotation),
        _ => {
            let steps = (0..200).map(|k| pose.free_rotation() + f64::from(k) * pitch / 200.0);
            steps
                .into_iter()
                .find(|&rotation| !overlaps(rotation))
                .unwrap()
        }
    };
    assert!(!overlaps(middle), "overlap in the middle of the free range");
    [-1.0, 1.0].map(|sense| {
        let at = |k: u32| middle + sense * f64::from(k) * pitch / 200.0;
        let first = (1..=200).find(|&k| overlaps(at(k)))?;
        let (mut apart, mut over) = (at(first - 1), at(first));
        for _ in 0..50 {
            let half = 0.5 * (apart + over);
            if overlaps(half) {
                over = half
            } else {
                apart = half
            }
        }
        Some(over)
    })
}
