//! Two outlines of one gear whose deviations have a closed form.

use gearlash::gear::Face;
use gearlash::outline::{OutlineDifference, OutlineGear, OutlineReading, PathSegment};
use nalgebra::{Point2, Rotation2, Vector2};
use std::f64::consts::TAU;

const Z: u32 = 12;

/// Corners of straight-sided teeth, tooth 1 up, clockwise; `top(k)` are those of the tip of tooth k + 1: radius, and pitches from its
/// middle.
fn corners(top: impl Fn(u32) -> Vec<[f64; 2]>) -> Vec<Point2<f64>> {
    let tooth = |k: u32| {
        let top = top(k).into_iter();
        let all = [[10.0, -0.3]].into_iter().chain(top).chain([[10.0, 0.3]]);
        all.map(move |[radius, pitches]| {
            let (sin, cos) = (0.25 * TAU - (f64::from(k) + pitches) * TAU / f64::from(Z)).sin_cos();
            Point2::new(radius * cos, radius * sin)
        })
    };
    (0..Z).flat_map(tooth).collect()
}

fn flat(_: u32) -> Vec<[f64; 2]> {
    vec![[13.0, -0.1], [13.0, 0.1]]
}

fn gear(corners: &[Point2<f64>]) -> OutlineGear {
    let next = corners.iter().cycle().skip(1);
    let lines = corners
        .iter()
        .zip(next)
        .map(|(a, b)| PathSegment::Line([*a, *b]));
    read(&lines.collect::<Vec<_>>())
}

fn read(path: &[PathSegment]) -> OutlineGear {
    let reading = OutlineReading {
        centre: Point2::origin(),
        face: Face::Front,
        teeth: Some(Z),
        first_tooth: None,
        bound: 0.0,
    };
    OutlineGear::new(path, &reading).unwrap()
}

/// Chords within 1e-6 mm: greatest and least may be off by as much.
fn difference(a: &[Point2<f64>], b: &[Point2<f64>]) -> OutlineDifference {
    OutlineDifference::new(&gear(a), &gear(b), 1e-6).unwrap()
}

fn turned(corners: &[Point2<f64>], turn: f64) -> Vec<Point2<f64>> {
    let turned = corners.iter().map(|corner| Rotation2::new(turn) * corner);
    turned.collect()
}

#[track_caller]
fn near(found: f64, expected: f64, within: f64) {
    assert!(
        (found - expected).abs() <= within,
        "{found}, not {expected}"
    );
}

#[test]
fn an_outline_does_not_differ_from_itself() {
    let same = difference(&corners(flat), &corners(flat));
    let found = [
        same.rotation,
        same.mean,
        same.root_mean_square,
        same.greatest.beyond,
        same.least.beyond,
    ];
    for value in found {
        near(value, 0.0, 1e-12);
    }
    // All teeth are equal.
    assert_eq!((same.tooth, same.alike), (1, Z));
}

/// Every side moved out by d: the deviation is d, but at corners, where the nearest place is the corner of the other outline, up to
/// d / cos(half the angle by which it turns there); the other way round the same with the other sign.
#[test]
fn sides_that_are_moved_out() {
    let d = 0.01;
    let inner = corners(flat);
    let count = inner.len();
    let sides: Vec<(Point2<f64>, Vector2<f64>)> = (0..count)
        .map(|k| {
            let along = (inner[(k + 1) % count] - inner[k]).normalize();
            // Clockwise: out of the metal is on the left.
            (inner[k] + d * Vector2::new(-along.y, along.x), along)
        })
        .collect();
    let mut turns = Vec::new();
    let outer: Vec<Point2<f64>> = (0..count)
        .map(|k| {
            let ((a, u), (b, v)) = (sides[(k + count - 1) % count], sides[k]);
            turns.push(u.perp(&v).atan2(u.dot(&v)));
            a + u * ((b - a).perp(&v) / u.perp(&v))
        })
        .collect();
    let most = |sign: f64| {
        let turns = turns.iter().map(|turn| sign * turn);
        d / (0.5 * turns.fold(0.0, f64::max)).cos()
    };
    let out = difference(&inner, &outer);
    near(out.least.beyond, d, 1e-12);
    // Counter-clockwise turns of a clockwise path are its roots.
    near(out.greatest.beyond, most(1.0), 1e-6);
    assert!(out.greatest.point.coords.norm() < 10.1);
    near(out.mean, d, 1e-2 * d);
    assert!(out.mean > d && out.root_mean_square >= out.mean);
    let back = difference(&outer, &inner);
    near(back.greatest.beyond, -d, 1e-12);
    near(back.least.beyond, -most(-1.0), 1e-6);
    assert!(back.least.point.coords.norm() > 12.9);
    near(back.rotation, 0.0, 1e-9);
}

/// A tip with a bump that no other has: drawn turned by three teeth and a bit it is found there.
#[test]
fn the_tooth_that_lies_on_tooth_1_is_found() {
    let top = |k: u32| match k {
        4 => vec![[13.0, -0.1], [13.1, 0.02], [13.0, 0.1]],
        _ => flat(k),
    };
    let drawn = corners(top);
    let pitch = TAU / f64::from(Z);
    for (teeth, more) in [(3.0, 0.01), (-5.0, -0.02), (6.0, 0.03)] {
        let by = teeth * pitch + more;
        let found = difference(&drawn, &turned(&drawn, by));
        near((found.rotation + by).sin(), 0.0, 1e-12);
        near((found.rotation + by).cos(), 1.0, 1e-12);
        near(found.root_mean_square, 0.0, 1e-12);
        near(found.greatest.beyond, 0.0, 1e-12);
        assert_eq!(found.alike, 1);
        // Teeth count clockwise: what was turned counter-clockwise by three has the number 1 − 3.
        let expected = (-teeth as i32).rem_euclid(Z as i32) as u32 + 1;
        assert_eq!(found.tooth, expected, "{teeth}");
    }
}

/// A triangle of height h and width w on the tip of tooth 8: below its top the distance from its sides is h cos(slope), which falls
/// evenly to both ends; mean and mean square are its integrals, w/2 and w/3 times, over the length of the outline.
#[test]
fn a_bump_of_known_size() {
    let half = 13.0 * (0.1 * TAU / f64::from(Z)).sin();
    let tip = 13.0 * (0.1 * TAU / f64::from(Z)).cos();
    let (h, w) = (0.05, 2.0 * half);
    let with_bump = |k: u32| match k {
        7 => vec![[13.0, -0.1], [tip + h, 0.0], [13.0, 0.1]],
        _ => flat(k),
    };
    let plain = corners(flat);
    let found = difference(&plain, &corners(with_bump));
    let most = h * (2.0 * h / w).atan().cos();
    near(found.greatest.beyond, most, 1e-6);
    near(found.least.beyond, 0.0, 1e-12);
    assert_eq!(found.greatest.tooth, 8);
    near(found.greatest.point.coords.norm(), tip, 1e-3);
    let length = polygon_length(&plain);
    near(found.mean, 0.5 * most * w / length, 2e-4 * found.mean);
    near(
        found.root_mean_square,
        (most * most * w / 3.0 / length).sqrt(),
        1e-3 * found.root_mean_square,
    );
    // Every tooth of the plain one could have it: the least turn is taken.
    assert_eq!((found.alike, found.tooth), (Z, 1));
}

fn polygon_length(corners: &[Point2<f64>]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| (b - a).norm()).sum()
}

/// Flanks that are arcs of radius 9 mm and of 12 mm between the same corners: in their middle they lie apart by the difference of the two
/// heights above the chord, R − √(R² − (chord/2)²).
#[test]
fn arcs_between_the_same_corners() {
    let ends = corners(flat);
    let drawn = |radius: f64| {
        let path: Vec<PathSegment> = (0..ends.len())
            .map(|k| {
                let (from, to) = (ends[k], ends[(k + 1) % ends.len()]);
                if k % 2 == 1 {
                    return PathSegment::Line([from, to]);
                }
                let along = to - from;
                let half = (0.5 * along.norm() / radius).asin();
                // Clockwise of the path's direction, about a centre on its right.
                let aside = Vector2::new(along.y, -along.x).normalize() * (radius * half.cos());
                let centre = from + 0.5 * along + aside;
                PathSegment::Arc {
                    centre,
                    radius,
                    start: (from.y - centre.y).atan2(from.x - centre.x),
                    sweep: -2.0 * half,
                }
            })
            .collect();
        read(&path)
    };
    let [flatter, fuller] = [12.0, 9.0].map(drawn);
    let chord = (ends[1] - ends[0]).norm();
    let height = |radius: f64| radius - (radius * radius - 0.25 * chord * chord).sqrt();
    let known = height(9.0) - height(12.0);
    for (a, b, sign) in [(&flatter, &fuller, 1.0), (&fuller, &flatter, -1.0)] {
        let found = OutlineDifference::new(a, b, 1e-6).unwrap();
        let (far, near_by) = if sign > 0.0 {
            (found.greatest.beyond, found.least.beyond)
        } else {
            (found.least.beyond, found.greatest.beyond)
        };
        near(far, sign * known, found.bound);
        near(near_by, 0.0, found.bound);
        near(found.rotation, 0.0, 1e-9);
    }
}
