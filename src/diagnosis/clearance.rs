//! Radial clearance as built: the least distance from a tip land to a root land over the rotation.
//!
//! Both gears roll on together, the free one in the middle of the mean teeth's
//! backlash. Lands are arcs about the displaced centres, tooth by tooth; their
//! distance is that of two arcs that curve away from each other, or the depth to which a tip
//! reaches below the root circle, all of which is metal.

use crate::analytic::InvolutePair;
use crate::gear::{Placed, Side};
use crate::pair::{Assembly, Mating, Member, Pose};
use std::collections::HashSet;
use std::f64::consts::{PI, TAU};

/// Steps in a pitch among which the least distance is looked for before it is refined (tuned: a root land
/// takes part in a twentieth of a pitch, and off it the distance grows steadily).
const STEPS: u32 = 32;
/// Width to which the rotation is found, pitches. The distance changes by up to a module a pitch
/// at a land's end: 1e-9 of that.
const PITCHES: f64 = 1e-9;

/// Where a tip comes nearest to a root.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RadialClearance {
    /// Least distance, mm; negative when the tip stands in the root.
    pub distance: f64,
    /// Tooth whose tip it is.
    pub tip_tooth: u32,
    /// The mate's tooth clockwise of the space whose root it is.
    pub root_tooth: u32,
    /// Where the gears stand.
    pub mating: Mating,
}

/// The least distance between `member`'s tips and its mate's roots: one revolution of the locked gear on
/// from each of `matings`, as far as it leads to teeth not met before.
///
/// `None` without matings.
pub fn radial_clearance(
    assembly: &Assembly,
    member: Member,
    matings: &[Mating],
) -> Option<RadialClearance> {
    let pitches = assembly.gear(assembly.locked()).gear().toothing().teeth();
    let mut met = HashSet::new();
    let mut least: Option<RadialClearance> = None;
    for start in matings {
        let start = Mating {
            fraction: 0.0,
            ..*start
        };
        for pitch in 0..pitches {
            let mating = start.onward(assembly, f64::from(pitch));
            if !met.insert((mating.wheel_tooth, mating.pinion_tooth)) {
                break;
            }
            let found = within_pitch(assembly, member, mating);
            if least.is_none_or(|least| found.distance < least.distance) {
                least = Some(found);
            }
        }
    }
    least
}

/// The least over one pitch on from `mating`.
fn within_pitch(assembly: &Assembly, member: Member, mating: Mating) -> RadialClearance {
    let at = |pitches: f64| nearest_lands(assembly, member, mating.onward(assembly, pitches));
    let step = 1.0 / f64::from(STEPS);
    let mut best = (at(0.0), 0.0);
    for i in 1..STEPS {
        let pitches = f64::from(i) * step;
        let found = at(pitches);
        if found.distance < best.0.distance {
            best = (found, pitches);
        }
    }
    // Thirds: the distance falls towards the least and rises from it.
    let (mut low, mut high) = (best.1 - step, best.1 + step);
    while high - low > PITCHES {
        let third = (high - low) / 3.0;
        let (left, right) = (at(low + third), at(high - third));
        for found in [left, right] {
            if found.distance < best.0.distance {
                best.0 = found;
            }
        }
        if left.distance <= right.distance {
            high -= third;
        } else {
            low += third;
        }
    }
    best.0
}

/// The nearest tip of `member` and root of its mate at `mating`.
fn nearest_lands(assembly: &Assembly, member: Member, mating: Mating) -> RadialClearance {
    let pose = Pose::new(assembly, mating);
    let play = InvolutePair::of(assembly)
        .normal_backlash(assembly.center_distance())
        .unwrap_or(0.0);
    let free = assembly.gear(assembly.free()).gear().base_radius();
    // Right-flank contact is the clockwise end of the backlash.
    let half = -mating.flank.sense() * 0.5 * play / free;
    let place = |member| {
        let rotation = match member == assembly.locked() {
            true => pose.locked_rotation(),
            false => pose.free_rotation() + half,
        };
        Placed::new(
            assembly.gear(member),
            assembly.axis(member),
            assembly.mate_direction(member) + rotation,
        )
    };
    let (tips, roots) = (place(member), place(member.mate()));
    let between = roots.centre() - tips.centre();
    let distance = between.norm();
    let towards = between.y.atan2(between.x);
    let (tip_radius, root_radius) = (
        tips.as_built().gear().tip_radius(),
        roots.as_built().gear().root_radius(),
    );
    let mut least = RadialClearance {
        distance: f64::INFINITY,
        tip_tooth: 0,
        root_tooth: 0,
        mating,
    };
    let spaces = near(&roots, towards + PI, 0.5);
    for tip_tooth in near(&tips, towards, 0.0) {
        let tip = tip_land(&tips, tip_tooth, towards);
        for root_tooth in spaces {
            let root = root_land(&roots, root_tooth, towards + PI);
            let apart = between_lands(distance, (tip_radius, tip), (root_radius, root));
            if apart < least.distance {
                least.distance = apart;
                least.tip_tooth = tip_tooth;
                least.root_tooth = root_tooth;
            }
        }
    }
    least
}

/// The three teeth nearest to `direction`, or, half a pitch `beyond` them counter-clockwise, the spaces.
fn near(placed: &Placed, direction: f64, beyond: f64) -> [u32; 3] {
    let gear = placed.as_built();
    let pitch = gear.gear().toothing().angular_pitch();
    let steps = ((direction - placed.direction(1)) / pitch - beyond).round() as i64;
    [-1, 0, 1].map(|beside| gear.counter_clockwise(1, steps + beside))
}

/// Ends of a tip land, clockwise first, as angles from `line`.
fn tip_land(placed: &Placed, tooth: u32, line: f64) -> [f64; 2] {
    let (as_built, gear) = (placed.as_built(), placed.as_built().gear());
    let half = gear.half_angle_at_roll(gear.tip_roll());
    let centre = from(line, placed.direction(tooth));
    Side::BOTH.map(|side| centre + as_built.flank_offset(side, tooth) + side.sense() * half)
}

/// Ends of the root land counter-clockwise of a tooth, as angles from `line`.
fn root_land(placed: &Placed, tooth: u32, line: f64) -> [f64; 2] {
    let (as_built, gear) = (placed.as_built(), placed.as_built().gear());
    let pitch = gear.toothing().angular_pitch();
    let from_centre = -gear.fillet().root_angle();
    let centre = from(line, placed.direction(tooth) + 0.5 * pitch) - 0.5 * pitch;
    let next = as_built.counter_clockwise(tooth, 1);
    let start = centre + as_built.flank_offset(Side::Left, tooth) + from_centre;
    let end = centre + pitch + as_built.flank_offset(Side::Right, next) - from_centre;
    // Deviations may leave a full tip round a land of less than no length: its middle then.
    match start <= end {
        true => [start, end],
        false => [0.5 * (start + end); 2],
    }
}

/// `direction` counted from `line`, in [−π, π].
fn from(line: f64, direction: f64) -> f64 {
    let angle = direction - line;
    angle - TAU * (angle / TAU).round()
}

/// Least distance of a tip land and a root land whose centres stand `distance` apart; angles count from each
/// centre's direction to the other. Negative where the tip reaches below the root circle: by its depth there.
///
/// On one circle the point nearest to the other centre is that nearest to the line of centres. If that point of the
/// tip is outside the root circle, so is all of the tip, and no point of the root land is nearer than what follows:
/// going to the nearest point of each arc in turn descends to the least distance, and ends when neither moves.
/// (A point's nearest on an arc is that nearest in direction, seen from the arc's centre.)
fn between_lands(distance: f64, tip: (f64, [f64; 2]), root: (f64, [f64; 2])) -> f64 {
    let (radius, [start, end]) = tip;
    let (mate_radius, [mate_start, mate_end]) = root;
    let mut angle = 0f64.clamp(start, end);
    let mut mate = 0f64.clamp(mate_start, mate_end);
    let deepest = (radius * angle.sin()).hypot(distance - radius * angle.cos());
    if deepest <= mate_radius || (angle == 0.0 && mate == 0.0) {
        return deepest - mate_radius;
    }
    // Direction from one centre to a point at `angle` on the other's circle, which stands opposite.
    let seen =
        |radius: f64, angle: f64| (-radius * angle.sin()).atan2(distance - radius * angle.cos());
    for _ in 0..100 {
        let next_mate = seen(radius, angle).clamp(mate_start, mate_end);
        let next = seen(mate_radius, next_mate).clamp(start, end);
        let still = next == angle && next_mate == mate;
        (angle, mate) = (next, next_mate);
        if still {
            break;
        }
    }
    let across = radius * angle.sin() + mate_radius * mate.sin();
    let along = distance - radius * angle.cos() - mate_radius * mate.cos();
    across.hypot(along)
}
