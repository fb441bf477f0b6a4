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

/// The rectangle around two touches both on all sides: for two in a row it is the row.
#[test]
fn one_round_two_is_as_small_as_its_direction_allows() {
    let row = [3.0, 7.0].map(|x| rectangle(0.0, C::new(x, 1.0), [2.0, 0.5]));
    let round = Rectangle::round(&row[0], &row[1]);
    assert!((round.length() - 8.0).abs() < 1e-12 && (round.half[1] - 0.5).abs() < 1e-12);
    for pair in some().windows(2) {
        let round = Rectangle::round(&pair[0], &pair[1]);
        let all = [points(&pair[0]), points(&pair[1])].concat();
        let (mut most, mut least) = ([f64::MIN; 2], [f64::MAX; 2]);
        for point in all {
            let off = round.along.conj() * point - round.middle;
            for (k, off) in [off.re, off.im].into_iter().enumerate() {
                (most[k], least[k]) = (most[k].max(off), least[k].min(off));
            }
        }
        for k in 0..2 {
            let ends = [most[k], -least[k]];
            assert!(ends.iter().all(|end| (end - round.half[k]).abs() < 1e-12));
        }
    }
}

/// Bounds of squares hold for all points. For a rectangle whose length points at the origin they are those of its ends.
#[test]
fn no_point_is_nearer_or_farther_than_the_bounds() {
    let radial = rectangle(0.4, C::from_polar(10.0, 0.4), [2.0, 0.0]);
    let (low, high) = radial.squares();
    assert!((low - 64.0).abs() < 1e-12 && (high - 144.0).abs() < 1e-12);
    for it in some() {
        let (low, high) = it.squares();
        for point in points(&it) {
            assert!((low - 1e-12..=high + 1e-12).contains(&point.norm_sqr()));
        }
    }
}

/// A rectangle found to be behind is so at every radius, and one behind with room to spare is found to be. The penetration is that
/// of the corners.
#[test]
fn a_rectangle_behind_is_clockwise_at_every_radius() {
    let (mut behind, mut not) = (0, 0);
    for (one, other) in some()
        .iter()
        .flat_map(|one| some().into_iter().map(move |other| (one, other)))
    {
        for turn in [-0.1, 0.0, 0.05, 0.12, 0.4] {
            let turned = C::cis(turn);
            assert!(one.is_near(&other, turned));
            let free: Vec<C> = points(&other).iter().map(|p| turned * p).collect();
            let locked = points(one);
            if one.beyond(&other, turned, 0.0) <= 0.0 {
                behind += 1;
                for p in &locked {
                    for q in free.iter().filter(|q| (q.norm() - p.norm()).abs() < 1e-3) {
                        assert!((q * p.conj()).im > -1e-3 * 21.0, "{p} {q}");
                    }
                }
            } else {
                not += 1;
                // No line along the locked one divides the two.
                let sign = 1f64.copysign(one.middle.re);
                let across = |points: &[C]| -> Vec<C> {
                    let each = points.iter().map(|p| one.along.conj() * p * sign);
                    each.collect()
                };
                let (own, mate) = (across(&locked), across(&free));
                let most = own.iter().map(|p| p.im).fold(f64::MIN, f64::max);
                let least = mate.iter().map(|q| q.im).fold(f64::MAX, f64::min);
                let outward = own.iter().chain(&mate).all(|p| p.re > 1e-9);
                assert!(!outward || least <= most + 1e-9);
            }
        }
    }
    assert!(behind > 1000 && not > 1000, "{behind} {not}");
    let [a, b] = [0.0, 3.0].map(|y| rectangle(0.0, C::new(20.0, y), [1.0, 0.5]));
    for (one, other, room, expected) in [(&a, &b, 0.5, -1.5), (&b, &a, 0.0, 4.0)] {
        assert!((one.beyond(other, C::ONE, room) - expected).abs() < 1e-12);
    }
    let wide = rectangle(0.0, C::new(20.0, 0.0), [6.0, 0.0]);
    assert!(!a.is_near(&b, C::cis(2.0)) && !a.is_near(&wide, C::ONE));
}

/// A rectangle is behind another one across a line exactly if the line divides their points, and then at every radius.
#[test]
fn a_rectangle_behind_a_line_is_clockwise_at_every_radius() {
    let (mut behind, mut not) = (0, 0);
    for (one, other) in some()
        .iter()
        .flat_map(|one| some().into_iter().map(move |other| (one, other)))
    {
        for (turn, normal) in [(0.0, 1.2), (0.05, 1.6), (0.3, 2.0)] {
            let [turned, normal] = [turn, normal].map(C::cis);
            let free: Vec<C> = points(&other).iter().map(|p| turned * p).collect();
            let locked = points(one);
            let reach = |points: &[C]| points.iter().map(|p| dot(*p, normal)).collect::<Vec<f64>>();
            let most = reach(&locked).into_iter().fold(f64::MIN, f64::max);
            let least = reach(&free).into_iter().fold(f64::MAX, f64::min);
            let is_behind = one.is_behind(&other, turned, normal, 1e-9);
            assert_eq!(is_behind, most + 1e-9 <= least, "{most} {least}");
            if !is_behind {
                not += 1;
                continue;
            }
            behind += 1;
            for p in &locked {
                for q in free.iter().filter(|q| (q.norm() - p.norm()).abs() < 1e-3) {
                    assert!((q * p.conj()).im > -1e-3 * 21.0, "{p} {q}");
                }
            }
        }
    }
    assert!(behind > 1000 && not > 1000, "{behind} {not}");
    // Nothing is known of points far aside of the line's direction.
    let [a, b] = [0.0, 3.0].map(|y| rectangle(0.0, C::new(20.0, y), [1.0, 0.5]));
    assert!(a.is_behind(&b, C::ONE, C::i(), 0.0) && !b.is_behind(&a, C::ONE, C::i(), 0.0));
    let aside = C::cis(1.2);
    let [a, b] = [a, b].map(|it| it.placed(C::ZERO, aside));
    assert!(!a.is_behind(&b, C::ONE, C::i(), 0.0));
}
