//! Tip lands and root lands about the line of centres, and their least distance.

use crate::gear::{Placed, Side};
use std::f64::consts::TAU;

/// The three teeth nearest to `direction`, or the spaces half a pitch `beyond` them counter-clockwise.
pub(super) fn near(placed: &Placed, direction: f64, beyond: f64) -> [u32; 3] {
    let gear = placed.as_built();
    let pitch = gear.gear().basic_data().angular_pitch();
    let steps = ((direction - placed.direction(1)) / pitch - beyond).round() as i64;
    [-1, 0, 1].map(|beside| gear.counter_clockwise(1, steps + beside))
}

/// Ends of a tip land, `half` to either side in a mean tooth, clockwise first, as angles from `line`.
pub(super) fn tip_land(placed: &Placed, half: f64, tooth: u32, line: f64) -> [f64; 2] {
    let as_built = placed.as_built();
    let centre = from(line, placed.direction(tooth));
    Side::BOTH.map(|side| centre + as_built.flank_offset(side, tooth) + side.sense() * half)
}

/// Ends of the root land counter-clockwise of a tooth, as angles from `line`.
pub(super) fn root_land(placed: &Placed, tooth: u32, line: f64) -> [f64; 2] {
    let (as_built, gear) = (placed.as_built(), placed.as_built().gear());
    let pitch = gear.basic_data().angular_pitch();
    let from_centre = -gear.fillet().root_angle();
    let centre = from(line, placed.direction(tooth) + 0.5 * pitch) - 0.5 * pitch;
    let next = as_built.counter_clockwise(tooth, 1);
    let start = centre + as_built.flank_offset(Side::Left, tooth) + from_centre;
    let end = centre + pitch + as_built.flank_offset(Side::Right, next) - from_centre;
    // Deviations can give the land of a full tip radius a negative length: use its middle then.
    if start <= end {
        [start, end]
    } else {
        [0.5 * (start + end); 2]
    }
}

/// `direction` counted from `line`, in [−π, π].
fn from(line: f64, direction: f64) -> f64 {
    let angle = direction - line;
    angle - TAU * (angle / TAU).round()
}

/// A land; angles count from its centre's direction to the other centre.
#[derive(Clone, Copy)]
pub(super) struct Land {
    radius: f64,
    ends: [f64; 2],
    /// Angle at which it is nearest to the other centre.
    nearest: f64,
    /// Its least distance from the other centre, mm.
    pub reach: f64,
}

impl Land {
    /// The land of `radius` between `ends`, with the other centre `distance` away.
    pub fn new(distance: f64, radius: f64, ends: [f64; 2]) -> Land {
        let nearest = 0f64.clamp(ends[0], ends[1]);
        Land {
            radius,
            ends,
            nearest,
            reach: (radius * nearest.sin()).hypot(distance - radius * nearest.cos()),
        }
    }
}

/// Least distance of a tip land and a root land whose centres are `distance` apart. It is negative by the depth of the
/// tip if the tip reaches below the root circle.
///
/// The point of a circle nearest to the other centre is the one nearest to the line of centres. If that point of the
/// tip is outside the root circle, so is the whole tip, and no point of the root land is nearer than the following
/// result. Going to the nearest point of each arc in turn descends to the least distance. (The nearest point of an arc is the one nearest in
/// direction, from the arc's centre.)
///
/// One turn suffices. Take a root point inside its land. It is on the ray from its centre to the tip's point, and nearer to that centre. The
/// tip's centre sees it nearer to the line of centres than the tip's point, which is already the nearest of its land to that line and stays. A
/// tip's point that moves to the inside of its land sees the end of the root land in the same way.
pub(super) fn between_lands(distance: f64, tip: &Land, root: &Land) -> f64 {
    let (radius, [start, end]) = (tip.radius, tip.ends);
    let (mate_radius, [mate_start, mate_end]) = (root.radius, root.ends);
    if tip.reach <= mate_radius || (tip.nearest == 0.0 && root.nearest == 0.0) {
        return tip.reach - mate_radius;
    }
    // Direction from one centre to a point at `angle` on the other's opposite circle.
    let seen =
        |radius: f64, angle: f64| (-radius * angle.sin()).atan2(distance - radius * angle.cos());
    let mate = seen(radius, tip.nearest).clamp(mate_start, mate_end);
    let angle = seen(mate_radius, mate).clamp(start, end);
    let across = radius * angle.sin() + mate_radius * mate.sin();
    let along = distance - radius * angle.cos() - mate_radius * mate.cos();
    across.hypot(along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{Deviations, Face, GearDesign};

    /// Source: all teeth, and all spaces half a pitch further, sorted by their angle from the given direction.
    #[test]
    fn the_nearest_three_are_those_of_all() {
        for face in [Face::Front, Face::Back] {
            let built = GearDesign::plain(11, 2.0).built(face, &Deviations::default());
            for k in 0..40 {
                let (turned, direction) = (0.83 * f64::from(k) - 9.0, 0.37 * f64::from(k) - 5.0);
                let placed = Placed::new(&built, Default::default(), turned);
                for beyond in [0.0, 0.5] {
                    let off = |tooth: &u32| {
                        let there = placed.direction(*tooth) + beyond * TAU / 11.0;
                        (there - direction).cos()
                    };
                    let mut all: Vec<u32> = (1..=11).collect();
                    all.sort_by(|a, b| off(b).total_cmp(&off(a)));
                    let mut found = near(&placed, direction, beyond);
                    // In order, counter-clockwise.
                    assert_eq!(found[1], all[0], "{face:?} {k} {beyond}");
                    assert_eq!(found[1], built.counter_clockwise(found[0], 1));
                    assert_eq!(found[2], built.counter_clockwise(found[1], 1));
                    found.sort_unstable();
                    all.truncate(3);
                    all.sort_unstable();
                    assert_eq!(found[..], all[..], "{face:?} {k} {beyond}");
                }
            }
        }
    }

    /// Source: the least distance of 201 points of each land, of lands on either side of the line of centres.
    #[test]
    fn lands_are_as_far_apart_as_their_nearest_points() {
        for k in 0..60 {
            let part = |step: f64| (step * f64::from(k)).fract();
            let (radius, mate) = (6.0 + 4.0 * part(0.61), 5.0 + 5.0 * part(0.37));
            let distance = radius + mate + 0.02 + 0.5 * part(0.83);
            let ends = |step: f64| {
                let middle = 1.2 * (part(step) - 0.5);
                [middle - 0.1, middle + 0.1]
            };
            let [tip, root] = [(radius, ends(0.29)), (mate, ends(0.71))];
            let [tip_land, root_land] =
                [tip, root].map(|(radius, ends)| Land::new(distance, radius, ends));
            let points = |(radius, [start, end]): (f64, [f64; 2])| {
                let angles = (0..=200).map(move |i| start + (end - start) * f64::from(i) / 200.0);
                angles.map(move |angle| (radius * angle.cos(), radius * angle.sin()))
            };
            let pairs = points(tip).flat_map(|p| points(root).map(move |q| (p, q)));
            let apart = pairs.map(|((x, y), (u, v))| (y + v).hypot(distance - x - u));
            let sampled = apart.fold(f64::INFINITY, f64::min);
            let found = between_lands(distance, &tip_land, &root_land);
            assert!(
                found <= sampled + 1e-12 && sampled <= found + 1e-3,
                "{k}: {found} {sampled}"
            );
        }
    }
}
