//! The same question by brute force: polar gap on densely sampled curves, refined by golden section.
//!
//! Shares with the kernel the curves of `gear::Profile` and the pairing rule of
//! `Pose::facing_tooth`; nothing of its search, its frame or its mirror.

use gearlash::gear::{AsBuilt, Curve, Profile, Side};
use gearlash::pair::{Assembly, Member, Pose};
use nalgebra::{Point2, Rotation2};
use std::f64::consts::TAU;

/// Samples a curve.
const SAMPLES: usize = 160;

/// One half tooth, put where the pose puts it, in polar coordinates about the free axis.
struct Half<'a> {
    profile: Profile<'a>,
    side: Side,
    /// Rotation of the tooth's centre line, and place of the outline's centre from the free axis.
    turn: Rotation2<f64>,
    centre: Point2<f64>,
    samples: Vec<Node>,
}

#[derive(Clone, Copy)]
struct Node {
    curve: Curve,
    t: f64,
    rho: f64,
    theta: f64,
}

impl<'a> Half<'a> {
    fn new(gear: &'a AsBuilt, side: Side, tooth: u32, tooth_1: f64, axis: Point2<f64>) -> Half<'a> {
        let angle = tooth_1 + gear.tooth_angle(f64::from(tooth)) + gear.flank_offset(side, tooth);
        let mut half = Half {
            profile: Profile::new(gear.gear()),
            side,
            turn: Rotation2::new(angle),
            centre: axis + gear.displacement(tooth_1),
            samples: Vec::new(),
        };
        for curve in Curve::ALL {
            let (mut from, to) = half.profile.range(curve);
            if curve == Curve::Tip {
                // The whole land, to where the tooth's other flank begins.
                let widening =
                    gear.flank_offset(Side::Left, tooth) - gear.flank_offset(Side::Right, tooth);
                from = (-to - widening).min(0.0);
            }
            for k in 0..=SAMPLES {
                let t = from + (to - from) * k as f64 / SAMPLES as f64;
                half.samples.push(half.node(curve, t));
            }
        }
        half
    }

    fn node(&self, curve: Curve, t: f64) -> Node {
        let point = self.centre + self.turn * self.profile.point(curve, t, self.side).coords;
        Node {
            curve,
            t,
            rho: point.coords.norm(),
            theta: point.y.atan2(point.x),
        }
    }

    /// Polar angles at which the half tooth has the radius `rho`, relative to `near`.
    fn angles(&self, rho: f64, near: f64) -> Vec<f64> {
        let mut found = Vec::new();
        for pair in self.samples.windows(2) {
            let (mut a, mut b) = (pair[0], pair[1]);
            if a.curve != b.curve || (a.rho - rho) * (b.rho - rho) > 0.0 {
                continue;
            }
            for _ in 0..56 {
                let middle = self.node(a.curve, 0.5 * (a.t + b.t));
                if (a.rho - rho) * (middle.rho - rho) <= 0.0 {
                    b = middle;
                } else {
                    a = middle;
                }
            }
            found.push(near + wrap(a.theta - near));
        }
        found
    }
}

fn wrap(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// Greatest `sign · (θ_locked − θ_free)` over all facing pairs of `side`, the free gear at its nominal
/// rotation; `sign` is + on the right, − on the left.
fn greatest_gap(assembly: &Assembly, pose: &Pose, side: Side) -> Option<f64> {
    let (locked, free) = (assembly.locked(), assembly.free());
    let axis = assembly.axis(locked) - assembly.axis(free).coords;
    let locked_1 = assembly.mate_direction(locked) + pose.locked_rotation();
    let free_1 = assembly.mate_direction(free) + pose.free_rotation();
    let gear = assembly.gear(locked);
    let pitch = gear.gear().toothing().angular_pitch();
    let mating = f64::from(pose.mating().tooth(locked));
    let ahead = pose.locked_rotation() + gear.tooth_angle(mating);
    let near = -(ahead / pitch).round() as i64;
    let round = i64::from(gear.gear().toothing().teeth()) / 2;
    let reach = assembly.gear(free).reach();
    // Right: greatest θ_locked − θ_free; left: least.
    let sign = -side.sense();
    let mut best: Option<f64> = None;
    let margin = 0.01 * assembly.gear(free).gear().toothing().angular_pitch();
    for beyond in -round.min(60)..=round.min(60) {
        let steps = near + beyond;
        let tooth = gear.counter_clockwise(pose.mating().tooth(locked), steps);
        // Far teeth cannot reach: cheap test first.
        let direction = axis
            + Rotation2::new(locked_1 + gear.tooth_angle(f64::from(tooth)))
                * nalgebra::Vector2::new(gear.gear().tip_radius(), 0.0);
        if direction.coords.norm()
            > reach + gear.eccentricity() + 4.0 * gear.gear().toothing().module()
        {
            continue;
        }
        let ours = Half::new(gear, side, tooth, locked_1, axis);
        let facing = pose.facing_tooth(assembly, side, steps);
        let theirs = Half::new(assembly.gear(free), side, facing, free_1, Point2::origin());
        climb(&ours, &theirs, sign, margin, &mut best);
        climb(&theirs, &ours, -sign, margin, &mut best);
    }
    best
}

/// Runs along `one`'s samples; the other is met at equal radius. `sign` counts `θ_one − θ_other`.
///
/// Local maxima within `margin` of the top are refined: the interpolation error of the samples is far below it.
fn climb(one: &Half, other: &Half, sign: f64, margin: f64, best: &mut Option<f64>) {
    let gap = |node: &Node| -> f64 {
        let angles = other.angles(node.rho, node.theta);
        let gaps = angles.iter().map(|theta| sign * (node.theta - theta));
        gaps.fold(f64::NEG_INFINITY, f64::max)
    };
    let mut offer = |value: f64| {
        if value > f64::NEG_INFINITY {
            *best = Some(best.map_or(value, |best| best.max(value)));
        }
        best.unwrap_or(f64::NEG_INFINITY)
    };
    let coarse: Vec<f64> = one
        .samples
        .iter()
        .map(|node| coarse_gap(node, other, sign))
        .collect();
    let top = coarse.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if top == f64::NEG_INFINITY {
        return;
    }
    let top = top.max(offer(f64::NEG_INFINITY));
    for k in 0..one.samples.len() {
        let before = if k > 0 {
            coarse[k - 1]
        } else {
            f64::NEG_INFINITY
        };
        let after = coarse.get(k + 1).copied().unwrap_or(f64::NEG_INFINITY);
        if !(coarse[k] >= before && coarse[k] >= after && coarse[k] >= top - margin) {
            continue;
        }
        offer(gap(&one.samples[k]));
        for pair in [k.checked_sub(1).map(|j| (j, k)), Some((k, k + 1))] {
            let Some((i, j)) = pair.filter(|&(_, j)| j < one.samples.len()) else {
                continue;
            };
            let (a, b) = (one.samples[i], one.samples[j]);
            if a.curve != b.curve {
                continue;
            }
            let (mut low, mut high) = (a.t, b.t);
            let ratio = 0.5 * (5f64.sqrt() - 1.0);
            for _ in 0..50 {
                let (c, d) = (high - ratio * (high - low), low + ratio * (high - low));
                let (c, d) = (one.node(a.curve, c), one.node(a.curve, d));
                let (at_c, at_d) = (gap(&c), gap(&d));
                offer(at_c);
                offer(at_d);
                // Out of reach counts as lower; where both are, sample k is not.
                let lost = at_d == f64::NEG_INFINITY && at_c == f64::NEG_INFINITY;
                if at_c > at_d || (lost && k == i) {
                    high = d.t;
                } else {
                    low = c.t;
                }
            }
        }
    }
}

/// The gap with the other curve taken as a polyline in polar coordinates.
fn coarse_gap(node: &Node, other: &Half, sign: f64) -> f64 {
    let mut most = f64::NEG_INFINITY;
    for pair in other.samples.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        if a.curve != b.curve || (a.rho - node.rho) * (b.rho - node.rho) > 0.0 {
            continue;
        }
        let share = if a.rho == b.rho {
            0.0
        } else {
            (node.rho - a.rho) / (b.rho - a.rho)
        };
        let theta = a.theta + share * wrap(b.theta - a.theta);
        most = most.max(sign * wrap(node.theta - theta));
    }
    most
}

/// The free gear's rotations at right- and left-flank contact, from its nominal rotation, rad.
pub fn rotations(assembly: &Assembly, pose: &Pose) -> [Option<f64>; 2] {
    [
        greatest_gap(assembly, pose, Side::Right),
        greatest_gap(assembly, pose, Side::Left).map(|gap| -gap),
    ]
}

/// Which member is which, for messages.
pub fn describe(assembly: &Assembly) -> String {
    [Member::Wheel, Member::Pinion]
        .map(|member| {
            let gear = assembly.gear(member);
            format!(
                "{} z {} m {} x {} xE {} e {} form {} tip {}",
                member.name(),
                gear.gear().toothing().teeth(),
                gear.gear().toothing().module(),
                gear.gear().blank().profile_shift,
                gear.gear().generating_shift(),
                gear.eccentricity(),
                gear.gear().form_roll(),
                gear.gear().tip_roll(),
            )
        })
        .join("; ")
}
