//! Rectangles compared with the points in them.

use super::*;

fn rectangle(angle: f64, centre: C, half: [f64; 2]) -> Rectangle {
    let along = C::cis(angle);
    Rectangle {
        along,
        middle: along.conj() * centre,
        half,
    }
}

/// Its corners, and points between them.
fn points(it: &Rectangle) -> Vec<C> {
    let part = |k: i32, half: f64| f64::from(k) / 4.0 * half;
    let each = (-4..=4).flat_map(|i| (-4..=4).map(move |j| (i, j)));
    let inside = each.map(|(i, j)| C::new(part(i, it.half[0]), part(j, it.half[1])));
    inside.map(|off| it.along * (it.middle + off)).collect()
}

fn holds(it: &Rectangle, point: C) -> bool {
    let off = it.along.conj() * point - it.middle;
    off.re.abs() <= it.half[0] + 1e-12 && off.im.abs() <= it.half[1] + 1e-12
}

/// Rectangles, long and short, in sequence along a bent path.
fn some() -> Vec<Rectangle> {
    (0..40)
        .map(|k| {
            let k = f64::from(k);
            let centre = C::from_polar(20.0 + (1.3 * k).sin(), 0.3 * (0.37 * k).sin());
            rectangle(0.7 * k, centre, [0.5 + 0.4 * (2.1 * k).cos(), 0.15])
        })
        .collect()
}

/// The rectangle around two contains both and touches them on all sides: for two in a row it is the row, for two side
/// by side their envelope.
#[test]
fn one_round_two_is_as_small_as_its_direction_allows() {
    let row = [3.0, 7.0].map(|x| rectangle(0.0, C::new(x, 1.0), [2.0, 0.5]));
    let round = Rectangle::round(&row[0], &row[1]);
    assert!((round.length() - 8.0).abs() < 1e-12 && (round.half[1] - 0.5).abs() < 1e-12);
    assert!((round.along * round.middle - C::new(5.0, 1.0)).norm() < 1e-12);
    let [small, great] =
        [(5.0, 0.2), (5.5, 3.0)].map(|(x, length)| rectangle(0.0, C::new(x, 0.0), [length, 0.5]));
    assert!((Rectangle::round(&small, &great).length() - 6.0).abs() < 1e-12);
    for pair in some().windows(2) {
        let round = Rectangle::round(&pair[0], &pair[1]);
        let all = [points(&pair[0]), points(&pair[1])].concat();
        assert!(all.iter().all(|point| holds(&round, *point)));
        let off = all
            .iter()
            .map(|point| round.along.conj() * point - round.middle);
        for axis in [|off: &C| off.re, |off: &C| off.im] {
            let along: Vec<f64> = off.clone().map(|off| axis(&off)).collect();
            let half = [
                along.iter().copied().fold(f64::MIN, f64::max),
                -along.iter().copied().fold(f64::MAX, f64::min),
            ];
            let own = if axis(&C::new(1.0, 0.0)) == 1.0 {
                round.half[0]
            } else {
                round.half[1]
            };
            assert!(half.iter().all(|half| (half - own).abs() < 1e-12));
        }
    }
}

/// Bounds of squares hold for all points. For a rectangle whose length points at the origin they are those of its ends.
#[test]
fn no_point_is_nearer_or_farther_than_the_bounds() {
    let radial = rectangle(0.4, C::from_polar(10.0, 0.4), [2.0, 0.0]);
    let (low, high) = radial.squares();
    assert!((low - 60.0).abs() < 1e-12 && (high - 144.0).abs() < 1e-12);
    for it in some() {
        let (low, high) = it.squares();
        for point in points(&it) {
            let square = point.norm_sqr();
            assert!(low <= square + 1e-12 && square <= high + 1e-12);
        }
    }
}

/// Penetration of one into the other across a line in the direction `line`, and whether neither extends back over the axis.
fn across(line: C, locked: &[C], free: &[C], sign: f64, room: f64) -> (f64, bool) {
    let along = |points: &[C]| -> Vec<C> {
        let each = points.iter().map(|point| line.conj() * point * sign);
        each.collect()
    };
    let (locked, free) = (along(locked), along(free));
    let most = locked.iter().map(|p| p.im).fold(f64::MIN, f64::max);
    let least = free.iter().map(|q| q.im).fold(f64::MAX, f64::min);
    let outward = locked.iter().chain(&free).all(|p| p.re > 0.0);
    (most - least + room, outward)
}

/// The line along the locked one counts where it divides, else that along the free one, else the lesser penetration.
/// Source: the corners, one by one.
#[test]
fn penetration_is_measured_across_the_better_line() {
    let (mut by, mut not_above) = ([0; 5], 0);
    for one in some() {
        for other in some() {
            for (turn, room) in [(-0.1, 0.0), (0.05, 0.3), (0.12, 0.0), (0.4, 0.2)] {
                let turned = C::cis(turn);
                let free: Vec<C> = points(&other).iter().map(|p| turned * p).collect();
                let locked = points(&one);
                let centre = one.along * one.middle;
                let lines = [one.along, turned * other.along].map(|line| {
                    let sign = 1f64.copysign((line.conj() * centre).re);
                    across(line, &locked, &free, sign, room)
                });
                let (expected, case) = match lines {
                    [(over, true), _] if over <= 0.0 => (over, 0),
                    [_, (over, true)] if over <= 0.0 => (over, 1),
                    [(one, _), (other, _)] if one > 0.0 && other > 0.0 => (one.min(other), 2),
                    [(one, _), (other, _)] if one.max(other) > 0.0 => (one.max(other), 3),
                    _ => (f64::INFINITY, 4),
                };
                let found = one.beyond(&other, turned, room);
                assert!(
                    found == expected || (found - expected).abs() < 1e-12,
                    "{one:?} {other:?} {turn} {room}: {found} {expected}"
                );
                by[case] += 1;
                not_above += i32::from(found <= 0.0);
            }
        }
    }
    assert!(by.iter().all(|count| *count > 5), "{by:?}");
    assert_eq!(not_above, by[0] + by[1]);
}

/// A rectangle found to be behind is so at every radius. One divided with room to spare along one of them is found to be behind.
#[test]
fn a_rectangle_behind_is_clockwise_at_every_radius() {
    let (mut behind, mut not) = (0, 0);
    for one in some() {
        for other in some() {
            for turn in [-0.1, 0.0, 0.05, 0.12, 0.4] {
                let turned = C::cis(turn);
                assert!(one.is_near(&other, turned));
                let free: Vec<C> = points(&other).iter().map(|p| turned * p).collect();
                let locked = points(&one);
                let is_behind = one.beyond(&other, turned, 0.0) <= 0.0;
                if is_behind {
                    behind += 1;
                    for p in &locked {
                        for q in free.iter().filter(|q| (q.norm() - p.norm()).abs() < 1e-3) {
                            assert!((q * p.conj()).im > -1e-3 * 21.0, "{p} {q}");
                        }
                    }
                } else {
                    not += 1;
                    // No line along the locked one divides the two.
                    let (least, most) = (
                        free.iter()
                            .map(|q| (one.along.conj() * q).im)
                            .fold((f64::MAX, f64::MIN), |(l, m), v| (l.min(v), m.max(v))),
                        (one.middle.im - one.half[1], one.middle.im + one.half[1]),
                    );
                    let sign = 1f64.copysign(one.middle.re);
                    let divided = if sign > 0.0 {
                        least.0 > most.1 + 1e-9
                    } else {
                        least.1 < most.0 - 1e-9
                    };
                    let outward = free
                        .iter()
                        .chain(&locked)
                        .all(|p| sign * (one.along.conj() * p).re > 1e-9);
                    assert!(!(divided && outward));
                }
            }
        }
    }
    assert!(behind > 1000 && not > 1000, "{behind} {not}");
    let [a, b] = [0.0, 3.0].map(|turn| rectangle(0.0, C::new(20.0, turn), [1.0, 0.5]));
    assert!((a.beyond(&b, C::ONE, 0.5) + 1.5).abs() < 1e-12);
    assert!(!a.is_near(&b, C::cis(2.0)));
    let wide = rectangle(0.0, C::new(20.0, 0.0), [6.0, 0.0]);
    assert!(!a.is_near(&wide, C::ONE));
}
