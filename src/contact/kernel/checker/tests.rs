//! Proofs that hold, and proofs that a change breaks.

use super::*;
use crate::gear::{Deviations, Face, GearDesign};

/// 14 on 23 teeth; the free gear of 14 teeth has this eccentricity, mm, towards `high_tooth`.
fn eccentric(eccentricity: f64, high_tooth: f64) -> GearPair {
    let gear = |teeth, face, deviations| GearDesign::plain(teeth, 2.0).built(face, &deviations);
    let wheel = gear(23, Face::Front, Deviations::off_axis(0.03, 2.0));
    let pinion = gear(
        14,
        Face::Back,
        Deviations::off_axis(eccentricity, high_tooth),
    );
    GearPair::new(wheel, pinion, 37.3).unwrap()
}

fn pieces(half: &Half) -> [(Piece, Vec<ProfilePart>); 3] {
    let (low, high) = half.range(ProfilePart::Fillet);
    let part = [0.7 * low + 0.3 * high, high];
    [
        (Piece::Top, vec![ProfilePart::Involute, ProfilePart::Tip]),
        (Piece::Fillet(part), vec![ProfilePart::Fillet]),
        (Piece::Root, vec![ProfilePart::Root]),
    ]
}

/// Points of a piece, 2000 of each curve.
fn points(half: &Half, piece: Piece, parts: &[ProfilePart]) -> Vec<Point2<f64>> {
    let mut points = Vec::new();
    for part in parts {
        let (low, high) = match piece {
            Piece::Fillet([low, high]) => (low, high),
            _ => half.range(*part),
        };
        let at = |k: u32| low + (high - low) * f64::from(k) / 2000.0;
        points.extend((0..=2000).map(|k| half.at(*part, at(k)).0));
    }
    points
}

fn directions() -> impl Iterator<Item = Vector2<f64>> {
    (0..360).map(|k| {
        let angle = (0.3 + f64::from(k)).to_radians();
        Vector2::new(angle.cos(), angle.sin())
    })
}

/// The locked tooth 3 and a free half tooth, with this play.
fn pair<'a>(assembly: &'a GearPair, free: Half<'a>, play: f64) -> Pair<'a> {
    let [near, far] = Side::BOTH.map(|side| Half::new(assembly, assembly.locked(), 0.0, side, 3));
    Pair {
        locked: Tooth { near, far },
        free,
        axis: assembly.axis(assembly.free()),
        play,
    }
}

/// A locked top and a free piece apart by a direction.
fn apart(free: Piece, normal: Vector2<f64>) -> Separation {
    Separation {
        locked_tooth: 3,
        free_tooth: 5,
        locked: Piece::Top,
        free,
        by: Reason::Direction,
        normal,
    }
}

/// Source: dense points of the outline, for a tooth of both its halves, and of the sector between its ends.
#[test]
fn reaches_and_distances_are_those_of_dense_points() {
    let assembly = eccentric(0.05, 2.0);
    let farthest = |points: &[Point2<f64>], n: Vector2<f64>| {
        let reaches = points.iter().map(|point| point.coords.dot(&n));
        reaches.fold(f64::MIN, f64::max)
    };
    for (member, rotation) in [(Member::Wheel, 0.3), (Member::Pinion, -2.1)] {
        let halves = Side::BOTH.map(|side| Half::new(&assembly, member, rotation, side, 5));
        let mut tops = Vec::new();
        for half in &halves {
            let pieces = pieces(half).map(|(piece, parts)| (piece, points(half, piece, &parts)));
            tops.extend_from_slice(&pieces[0].1);
            for ((piece, points), n) in pieces
                .iter()
                .flat_map(|piece| directions().map(move |n| (piece, n)))
            {
                let (reach, at) = half.reach(*piece, n);
                let over = reach - farthest(points, n);
                assert!((-1e-12..1e-6).contains(&over), "{piece:?} {n}: {over:e}");
                assert!((at.coords.dot(&n) - reach).abs() < 1e-12);
            }
            let (far_corner, _) = half.range(ProfilePart::Tip);
            let (_, root_end) = half.range(ProfilePart::Root);
            for k in 0..24 {
                let at = UnitComplex::new(0.26 * f64::from(k)) * Vector2::new(0.4, 0.0);
                let axis = half.centre + at * 1.9f64.powi(k % 8);
                // Free axes are within the root circle.
                let is_inside = (axis - half.centre).norm() < half.gear.gear().root_radius();
                let mut all = 0.0f64;
                for (piece, points) in pieces.iter().filter(|_| is_inside) {
                    let distances = points.iter().map(|point| (point - axis).norm());
                    let farthest = distances.fold(0.0, f64::max);
                    all = all.max(farthest);
                    let over = half.piece_about(*piece, axis) - farthest;
                    // The piece of the top is the whole half tooth.
                    let most = if *piece == Piece::Top { f64::MAX } else { 1e-5 };
                    assert!((-1e-12..=most).contains(&over), "{piece:?}: {over:e}");
                }
                let over = half.reach_about(axis) - all;
                assert!(!is_inside || (-1e-12..0.2).contains(&over), "{over}");
                let mut nearest = f64::MAX;
                for (i, j) in (0..=400).flat_map(|i| (0..=100).map(move |j| (i, j))) {
                    let t = root_end + (far_corner - root_end) * f64::from(i) / 400.0;
                    let radius = half.gear.gear().tip_radius() * f64::from(j) / 100.0;
                    let own = radius * Vector2::new(t.cos(), -half.side.sense() * -t.sin());
                    let point = half.centre + half.turned * own;
                    nearest = nearest.min((point - axis).norm());
                }
                let distance = half.distance(axis);
                assert!((nearest - distance).abs() < 0.2, "{distance} {nearest}");
            }
        }
        let [near, far] = halves;
        let tooth = Tooth { near, far };
        for n in directions() {
            let over = tooth.reach(Piece::Tooth, n).0 - farthest(&tops, n);
            assert!((-1e-12..1e-6).contains(&over), "{n}: {over:e}");
        }
    }
}

/// A pair that a direction holds apart loses no more than its arm and the turn allow as the free gear turns further. Source: the reach of
/// the turned piece.
#[test]
fn what_holds_stays_apart_as_the_free_gear_turns() {
    let assembly = eccentric(0.05, 2.0);
    let free = assembly.free();
    let mut held = 0;
    for side in Side::BOTH {
        let half = |rotation| Half::new(&assembly, free, rotation, side, 5);
        let radius = assembly.gear(free).eccentricity() + half(0.0).gear.gear().tip_radius();
        for (piece, _) in pieces(&half(0.2)) {
            for (n, play) in directions().flat_map(|n| [0.002, 0.02].map(|play| (n, play))) {
                let mut pair = pair(&assembly, half(0.2), play);
                for room in [0.05, 0.3, 0.9].map(|share| share * radius * play) {
                    let reach = pair.locked.reach(Piece::Top, n).0;
                    let off = -pair.free.reach(piece, -n).0 - reach - room;
                    pair.locked.near.centre += n * off;
                    if !pair.holds(&apart(piece, n), true) {
                        continue;
                    }
                    held += 1;
                    let reach = pair.locked.reach(Piece::Top, n).0;
                    for share in [0.3, 1.0] {
                        let turned = half(0.2 - side.sense() * share * play);
                        let room = -turned.reach(piece, -n).0 - reach;
                        let least = -radius * (share * play).powi(2) - 1e-12;
                        assert!(room > least, "{side:?} {piece:?} {n} {play}: {room}");
                    }
                }
            }
        }
    }
    assert!(held > 1000, "{held}");
}

/// A tip land of an eccentric gear, whose arm may change sign on its way, stays apart where it holds. Source: the reach of the turned piece.
#[test]
fn a_land_that_holds_stays_apart() {
    let (mut held, mut changed) = (0, 0);
    // Tooth 12 is opposite to tooth 5.
    for high_tooth in (-20..=20).map(|k| 12.0 + 0.01 * f64::from(k)) {
        let assembly = eccentric(0.8, high_tooth);
        let free = assembly.free();
        // Tooth 5 points at the mate.
        let facing = -assembly.gear(free).tooth_angle(5.0);
        for (side, k) in (-100..=100).flat_map(|k| Side::BOTH.map(|side| (side, k))) {
            let half = |by: f64| Half::new(&assembly, free, facing - side.sense() * by, side, 5);
            let angle = 0.001 * f64::from(k);
            let n = Vector2::new(f64::cos(angle), f64::sin(angle));
            let mut pair = pair(&assembly, half(0.0), 0.3);
            let room = |pair: &Pair, free: &Half| {
                -free.reach(Piece::Top, -n).0 - pair.locked.reach(Piece::Top, n).0
            };
            pair.locked.near.centre += n * (room(&pair, &pair.free) - 1e-9);
            let Some(land) = pair.free.land_ahead(Piece::Top, -n) else {
                continue;
            };
            if !(land.is_here && pair.holds(&apart(Piece::Top, n), true)) {
                continue;
            }
            held += 1;
            let at_end = half(land.turn).centre;
            changed += usize::from(-side.sense() * turns(pair.axis, at_end, n) < 0.0);
            let first = room(&pair, &half(0.0));
            let turns = (1..=60).map(|k| 0.001 * f64::from(k)).chain([0.15, 0.3]);
            let least = turns.map(|by| room(&pair, &half(by)));
            let least = least.fold(f64::INFINITY, f64::min);
            let case = format!("{high_tooth} {side:?} {angle}: {least:e}");
            assert!(least > first - 1e-12, "{case}");
        }
    }
    assert!(held > 1000 && changed > 100, "{held} {changed}");
}

/// Without a limit of the play, a distance must have an arm above 0.
#[test]
fn a_distance_without_an_arm_may_fall() {
    let assembly = eccentric(0.05, 2.0);
    let half = Half::new(&assembly, assembly.free(), 0.0, Side::Right, 5);
    let pair = pair(&assembly, half, f64::INFINITY);
    assert!(pair.stays(1e-9, 1e-9) && !pair.stays(1e-9, 0.0) && !pair.stays(0.0, 1.0));
}
