//! Whole gears: whether metal of one is in the other. Points of the outlines, all teeth, both flanks, bodies.

use super::Stood;
use super::half::Half;
use gearlash::contact::LostMotion;
use gearlash::gear::{AsBuilt, Side};
use gearlash::pair::{GearPair, Pose};

/// Distance inside a contact at which whole gears must be clear, rad. Points 1/60 of a curve apart miss no more, and rounding is less.
const INSIDE: f64 = 1e-7;

/// Points per curve.
const POINTS: usize = 60;

/// Rotations of the free gear, all round, that are tested for one without overlap.
const ROTATIONS: u32 = 400;

/// Greatest depth of a point in the other gear's metal, mm, with the free gear at `rotation`; 0 without any.
pub fn overlap(assembly: &GearPair, pose: &Pose, rotation: f64) -> f64 {
    overlap_up_to(assembly, pose, rotation, f64::INFINITY)
}

/// As [`overlap`], but ends at the first point deeper than `enough`.
fn overlap_up_to(assembly: &GearPair, pose: &Pose, rotation: f64, enough: f64) -> f64 {
    let locked = Stood::new(assembly, assembly.locked());
    let free = Stood::new(assembly, assembly.free());
    let stand = [(&locked, pose.locked_rotation()), (&free, rotation)];
    let most = deepest(stand[0], stand[1], enough);
    if most > enough {
        return most;
    }
    most.max(deepest(stand[1], stand[0], enough))
}

/// Metal of whole gears in each other just inside either contact of a clear pose. Half teeth do not show a tooth that
/// reaches the mate's far flank.
pub fn overlap_just_inside(assembly: &GearPair, pose: &Pose, found: &LostMotion) -> Option<String> {
    let play = found.angle().filter(|play| *play > 4.0 * INSIDE)?;
    let (right, left) = (found.right?, found.left?);
    let bound = right.error + left.error;
    if bound > 0.1 * play {
        return None;
    }
    let inside = [
        ("right", right.rotation + right.error + INSIDE),
        ("left", left.rotation - left.error - INSIDE),
    ];
    inside.into_iter().find_map(|(name, rotation)| {
        let deep = overlap(assembly, pose, rotation);
        (deep > 0.0).then(|| format!("{deep:e} mm overlap inside the {name} contact"))
    })
}

/// Whether the gears overlap at every rotation of the free one.
pub fn overlap_everywhere(assembly: &GearPair, pose: &Pose) -> bool {
    let gear = assembly.gear(assembly.free()).gear();
    let pitch = gear.basic_data().angular_pitch();
    (0..ROTATIONS).all(|k| {
        // All round, and everywhere in a pitch.
        let turns = f64::from(k % gear.basic_data().teeth()) + f64::from(k) / f64::from(ROTATIONS);
        let rotation = pose.free_rotation() + pitch * turns;
        overlap_up_to(assembly, pose, rotation, 0.0) > 0.0
    })
}

/// Greatest depth of a point of `one` in the metal of `other`, or the first that is more than `enough`.
fn deepest((one, turned): (&Stood, f64), (other, stands): (&Stood, f64), enough: f64) -> f64 {
    let gear = one.assembly.gear(one.member);
    let axis = other.assembly.axis(other.member);
    let reach = other.assembly.gear(other.member).reach();
    let mut most = 0.0f64;
    for tooth in 1..=gear.gear().basic_data().teeth() {
        for side in Side::BOTH {
            let frame = one.frame(turned, side, tooth);
            let ends = one.ends(side, tooth);
            let half = one.half(side, tooth);
            let (at, spread) = one.circle(&half, ends);
            let at = frame.out([at, 0.0]);
            if (at[0] - axis.x).hypot(at[1] - axis.y) - spread > reach {
                continue;
            }
            for k in 0..=4 * POINTS {
                let point = frame.out(half.along(k as f64 / POINTS as f64, ends));
                most = most.max(depth(other, stands, point));
                if most > enough {
                    return most;
                }
            }
        }
    }
    most
}

/// Depth of a point in the metal of a gear; zero or less outside.
fn depth(stood: &Stood, rotation: f64, point: [f64; 2]) -> f64 {
    let gear: &AsBuilt = stood.assembly.gear(stood.member);
    let half: &Half = &stood.half;
    // The frame of tooth 1 without deviations.
    let first = stood.frame(rotation, Side::Right, 1);
    let [x, y] = first.seen(point);
    let radius = x.hypot(y);
    if radius >= half.tip {
        return half.tip - radius;
    }
    if radius <= half.root {
        return half.root - radius;
    }
    let basic_data = gear.gear().basic_data();
    let angle = y.atan2(x) + gear.flank_offset(Side::Right, 1);
    let nearest = (angle / basic_data.angular_pitch()).round() as i64;
    let in_tooth = (nearest - 1..=nearest + 1).map(|steps| {
        let tooth = gear.counter_clockwise(1, steps);
        let beside = angle - steps as f64 * basic_data.angular_pitch();
        let thick = |side| stood.half(side, tooth).half_angle(radius);
        let from_right = beside - (gear.flank_offset(Side::Right, tooth) - thick(Side::Right));
        let to_left = gear.flank_offset(Side::Left, tooth) + thick(Side::Left) - beside;
        (from_right.min(to_left) * radius).min(half.tip - radius)
    });
    in_tooth.fold(f64::NEG_INFINITY, f64::max)
}
