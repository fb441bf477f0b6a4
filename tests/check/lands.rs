//! Radial clearance as built, beside the nearest of many points of tip lands and root lands at many rotations. The crate defines a pose, the position
//! of a tooth and the corner of a tip; the ends of root lands follow from the drawing.

use super::*;

/// A gear of the pair at a pose: its outline's centre, and the lands of each tooth, from one direction to another.
struct Lands {
    centre: [f64; 2],
    /// Radius of the tips, and ends of each, tooth 1 first.
    tip: f64,
    tips: Vec<[f64; 2]>,
    /// Radius of the roots, and the ends of each; its number is that of the tooth clockwise of it.
    root: f64,
    roots: Vec<[f64; 2]>,
}

fn lands(pair: &GearPair, member: Member, mating: Mating) -> Lands {
    let built = pair.gear(member);
    let (gear, design) = (built.gear(), built.gear().design());
    let (data, rack) = (&design.basic_data, &design.rack);
    // In the middle of the mean teeth's backlash: a right flank touches at the clockwise end.
    let pose = Pose::new(pair, mating);
    let free = pair.free();
    let play = InvolutePair::of(pair).circumferential_backlash(pair.center_distance());
    let half_play = 0.5 * play.unwrap() / pair.operating_pitch_radius(free);
    let ahead = if member == free { half_play } else { 0.0 };
    let middle = -mating.flank.sense() * ahead;
    let tooth_1 = pair.mate_direction(member) + pose.rotation(pair, member) + middle;
    let centre = pair.axis(member) + built.displacement(tooth_1);
    let direction = |tooth: u32| tooth_1 + built.tooth_angle(f64::from(tooth));
    let z = data.teeth();
    let half_tip = gear.half_angle_at_roll(gear.tip_roll());
    let tips = (1..=z).map(|tooth| {
        let [right, left] = [Side::Right, Side::Left].map(|side| built.flank_offset(side, tooth));
        let middle = direction(tooth);
        [middle + right - half_tip, middle + left + half_tip]
    });
    // Half the flat of the tool's tip.
    let (round, alpha) = (rack.root_radius(), data.pressure_angle());
    let flat = FRAC_PI_4 - (rack.dedendum() - round) * alpha.tan() - round / alpha.cos();
    let half_root = PI / f64::from(z) - 2.0 * flat / f64::from(z);
    let roots = (1..=z).map(|tooth| {
        let next = built.counter_clockwise(tooth, 1);
        let middle = direction(tooth);
        let start = middle + built.flank_offset(Side::Left, tooth) + half_root;
        let pitch = 2.0 * PI / f64::from(z);
        let end = middle + pitch + built.flank_offset(Side::Right, next) - half_root;
        if start <= end {
            [start, end]
        } else {
            [0.5 * (start + end); 2]
        }
    });
    Lands {
        centre: [centre.x, centre.y],
        tip: gear.tip_radius(),
        tips: tips.collect(),
        root: gear.root_radius(),
        roots: roots.collect(),
    }
}

/// Distance of a point from an arc about `centre`.
fn from_arc(point: [f64; 2], centre: [f64; 2], radius: f64, [start, end]: [f64; 2]) -> f64 {
    let (x, y) = (point[0] - centre[0], point[1] - centre[1]);
    let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
    let off = y.atan2(x) - middle;
    let off = off - 2.0 * PI * (off / (2.0 * PI)).round();
    let nearest = middle + off.clamp(-half, half);
    (x - radius * nearest.cos()).hypot(y - radius * nearest.sin())
}

/// The least distance of a tip of `member` from a root of its mate at a mating, by `points` of each tip: negative below the root circle.
/// It is taken over all teeth, or for the tip and the root named.
fn nearest(
    pair: &GearPair,
    member: Member,
    mating: Mating,
    points: u32,
    named: Option<[u32; 2]>,
) -> f64 {
    let tips = lands(pair, member, mating);
    let roots = lands(pair, member.mate(), mating);
    let counts = |k: usize, tooth: u32| named.is_none_or(|named| named[k] == tooth);
    let mut least = f64::INFINITY;
    for (_, [start, end]) in (1..).zip(&tips.tips).filter(|(tip, _)| counts(0, *tip)) {
        for k in 0..=points {
            let at = start + (end - start) * f64::from(k) / f64::from(points);
            let point = [
                tips.centre[0] + tips.tip * at.cos(),
                tips.centre[1] + tips.tip * at.sin(),
            ];
            let deep = (point[0] - roots.centre[0]).hypot(point[1] - roots.centre[1]) - roots.root;
            if deep > least {
                continue;
            }
            // In the root circle all is metal.
            if deep <= 0.0 {
                least = deep;
                continue;
            }
            for (_, ends) in (1..).zip(&roots.roots).filter(|(root, _)| counts(1, *root)) {
                least = least.min(from_arc(point, roots.centre, roots.root, *ends));
            }
        }
    }
    least
}

fn built(teeth: u32, [shift, round, eccentricity, pitch]: [f64; 4], thick: f64) -> Make {
    let list = |of: &dyn Fn(u32) -> u32, by: f64| -> Vec<f64> {
        (0..teeth).map(|k| by * f64::from(of(k))).collect()
    };
    let wave = |start: u32| list(&|k| (k * 7919 + start) % 1000, pitch);
    let gear = spur(teeth, 2.0).shift(shift).rack(1.0, 1.25, round);
    let gear = gear.runout(eccentricity, 2.7).pitch(&wave(17), &wave(443));
    gear.per_tooth(list(&|k| k * 7 % 5, thick))
}

/// Source: 60 points of each tip at any rotation looked at are no nearer, and 4000 points at the mating that is named are as near.
#[test]
fn no_points_of_lands_are_nearer_than_the_radial_clearance() {
    let alpha = 20f64.to_radians();
    let full = (FRAC_PI_4 - 1.25 * alpha.tan()) / (1.0 / alpha.cos() - alpha.tan());
    let (wheel, pinion) = (Member::Wheel, Member::Pinion);
    for (case, (teeth, more, distance, locked)) in [
        ([13, 9], [0.3, 0.38, 0.1, 4e-5], 22.9, wheel),
        ([11, 15], [0.0, 0.25, 0.3, 1e-4], 26.9, pinion),
        ([12, 8], [0.2, full, 0.06, 2e-5], 20.9, wheel),
        // Tips are in roots.
        ([12, 9], [0.1, 0.3, 0.2, 3e-5], 20.3, pinion),
        // Without runout the same distance recurs at each pitch, except for the offsets of flanks.
        ([9, 12], [0.2, 0.2, 0.0, 5e-5], 22.1, wheel),
    ]
    .into_iter()
    .enumerate()
    {
        let thick = if case == 2 { 0.02 } else { 0.0 };
        let less = [more[0], more[1], 0.6 * more[2], more[3]];
        let (first, second) = (built(teeth[0], more, thick), built(teeth[1], less, thick));
        let pair = kit::locked(&first, &second, distance, locked);
        for (member, flank) in [(wheel, Side::Right), (pinion, Side::Left)] {
            let what = (case, member);
            let start = Mating::at(2, 3, flank);
            let found = radial_clearance(&pair, member, &[start]).unwrap();
            // At 120 rotations of each pitch, and between those beside the nearest.
            let at = |pitches: f64| {
                let mating = start.onward(&pair, pitches);
                nearest(&pair, member, mating, 60, None)
            };
            let nearest_of = |all: Vec<f64>| {
                let each = all.into_iter().map(|pitches| (at(pitches), pitches));
                each.min_by(|one, other| one.0.total_cmp(&other.0))
                    .unwrap()
                    .1
            };
            let all = (0..pair.teeth(locked) * 120).map(|k| f64::from(k) / 120.0);
            let (mut best, mut step) = (nearest_of(all.collect()), 1.0 / 120.0);
            for _ in 0..6 {
                let beside = (-10..=10).map(|k| best + 0.1 * step * f64::from(k));
                best = nearest_of(beside.collect());
                step *= 0.1;
            }
            let off = at(best) - found.distance;
            assert!(off > -1e-9 && off < 1e-3, "{what:?}: {off:e}, {found:?}");
            let phased = kit::at_flank(2, 3, flank, 0.4);
            assert_eq!(radial_clearance(&pair, member, &[phased]), Some(found));
            // The teeth that are named have it.
            for named in [None, Some([found.tip_tooth, found.root_tooth])] {
                let there = nearest(&pair, member, found.mating, 4000, named);
                near(what, there, found.distance, 1e-6);
            }
        }
    }
}
