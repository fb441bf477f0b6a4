//! Splines against de Boor's algorithm, written here, and ezdxf 1.4.5 (`BSpline.point`).

use super::*;
use made::{dxf, line, polyline, spline};

const POINTS: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [4.0, 6.0],
    [9.0, 5.0],
    [12.0, -2.0],
    [7.0, -6.0],
    [1.0, -4.0],
];

/// A point of a rational spline (de Boor 1972).
fn de_boor(degree: usize, knots: &[f64], points: &[[f64; 2]], weights: &[f64], t: f64) -> [f64; 2] {
    let span = (degree..points.len())
        .rfind(|&span| knots[span] <= t && knots[span] < knots[span + 1])
        .unwrap();
    let mut row: Vec<[f64; 3]> = (span - degree..=span)
        .map(|index| {
            let weight = weights.get(index).copied().unwrap_or(1.0);
            [points[index][0] * weight, points[index][1] * weight, weight]
        })
        .collect();
    for round in 1..=degree {
        for index in (round..=degree).rev() {
            let low = knots[span - degree + index];
            let share = (t - low) / (knots[span + 1 + index - round] - low);
            let before = row[index - 1];
            let blend = |axis: usize| (1.0 - share) * before[axis] + share * row[index][axis];
            row[index] = [blend(0), blend(1), blend(2)];
        }
    }
    [
        row[degree][0] / row[degree][2],
        row[degree][1] / row[degree][2],
    ]
}

/// A spline, closed by a straight line, as the loop of its drawing.
fn closed(degree: usize, knots: &[f64], points: &[[f64; 2]], weights: &[f64]) -> DrawnPath {
    let domain = [knots[degree], knots[points.len()]];
    let ends = domain.map(|t| de_boor(degree, knots, points, weights, t));
    let mut entities = vec![spline(degree, knots, points, weights)];
    if ends[0] != ends[1] {
        entities.push(line(ends[0], ends[1]));
    }
    loop_of("dxf", &dxf(&entities))
}

fn check(degree: usize, knots: &[f64], points: &[[f64; 2]], weights: &[f64]) -> DrawnPath {
    let one = closed(degree, knots, points, weights);
    let domain = [knots[degree], knots[points.len()]];
    let on: Vec<[f64; 2]> = (0..=100)
        .map(|step| domain[0] + (domain[1] - domain[0]) * f64::from(step) / 100.0)
        .map(|t| de_boor(degree, knots, points, weights, t))
        .collect();
    check_through(&one, &on);
    one
}

/// Degrees 1 to 3, clamped, not clamped, with a double and a triple knot: exact, a cubic curve or line for each span.
#[test]
fn splines_without_weights_are_exact() {
    for (degree, knots, spans) in [
        (1, &[0.0, 0.0, 1.0, 2.0, 3.5, 4.0, 5.0, 5.0][..], 5),
        (2, &[0.0, 0.0, 0.0, 1.0, 2.5, 3.0, 4.0, 4.0, 4.0], 4),
        (2, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0], 4),
        (3, &[0.0, 0.0, 0.0, 0.0, 1.0, 2.5, 3.0, 3.0, 3.0, 3.0], 3),
        (3, &[-2.0, 0.0, 0.5, 1.0, 2.0, 2.0, 3.0, 3.5, 4.0, 7.0], 2),
        (3, &[0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0], 2),
    ] {
        let one = check(degree, knots, &POINTS, &[]);
        assert_eq!(one.bound_mm, 0.0);
        assert_eq!(one.segments.len(), spans + 1);
        let same = check(degree, knots, &POINTS, &[2.5; 6]);
        assert_eq!(same.segments[..spans], one.segments[..spans]);
    }
}

/// Points of ezdxf 1.4.5: `BSpline(points, order, knots, weights).point(t)`.
#[test]
fn splines_go_through_the_points_of_ezdxf() {
    let uniform: Vec<f64> = (0..10).map(f64::from).collect();
    let one = closed(3, &uniform, &POINTS, &[]);
    check_through(
        &one,
        &points(
            "4.166666666666666 4.833333333333333, 6.014666666666667 5.284, 10.291666666666666 1.4374999999999998, 8.158854166666666 -4.5703125, 6.833333333333333 -5.0",
        ),
    );
    let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 2.5, 3.0, 3.0, 3.0, 3.0];
    let one = closed(3, &knots, &POINTS, &[1.0, 2.0, 0.5, 1.5, 1.0, 0.8]);
    check_through(
        &one,
        &points(
            "2.98564997186269 4.252110298255488, 6.443181818181818 4.420454545454545, 10.51475919212843 -0.397909702933007, 7.45921676228486 -4.957844849089549",
        ),
    );
    let one = closed(
        5,
        &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
        &POINTS,
        &[],
    );
    check_through(
        &one,
        &points(
            "2.068660000000001 2.313860000000001, 7.079236181199999 2.6761128602, 8.3125 0.8125, 3.83634 -4.432860000000001",
        ),
    );
}

/// Weights and degrees above 3: within the bound, which is below 10 nm and not zero.
#[test]
fn other_splines_lie_within_their_bound() {
    let weights = [1.0, 2.0, 0.5, 1.5, 1.0, 0.8];
    for (degree, knots, weights) in [
        (
            2,
            &[0.0, 0.0, 0.0, 1.0, 2.5, 3.0, 4.0, 4.0, 4.0][..],
            &weights[..],
        ),
        (
            3,
            &[0.0, 0.0, 0.0, 0.0, 1.0, 2.5, 3.0, 3.0, 3.0, 3.0],
            &weights,
        ),
        (
            5,
            &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
            &[],
        ),
        (
            4,
            &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0],
            &weights,
        ),
    ] {
        let one = check(degree, knots, &POINTS, weights);
        assert!(
            one.bound_mm > 0.0 && one.bound_mm <= 1e-5,
            "{}",
            one.bound_mm
        );
    }
}

/// A quarter of a circle as the rational parabola with the weight 1/√2 (Piegl, Tiller: The NURBS Book, 7.3).
#[test]
fn a_rational_circle_is_round() {
    let half = 0.5_f64.sqrt();
    let points = [
        [5.0, 0.0],
        [5.0, 5.0],
        [0.0, 5.0],
        [-5.0, 5.0],
        [-5.0, 0.0],
        [-5.0, -5.0],
        [0.0, -5.0],
        [5.0, -5.0],
        [5.0, 0.0],
    ];
    let knots = [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0];
    let one = closed(
        2,
        &knots,
        &points,
        &[1.0, half, 1.0, half, 1.0, half, 1.0, half, 1.0],
    );
    for segment in &one.segments {
        for step in 0..=20 {
            let off = segment.at(f64::from(step) / 20.0).coords.norm() - 5.0;
            assert!(off.abs() <= one.bound_mm + 1e-14, "{off:e}");
        }
    }
    assert!(
        one.bound_mm < 1e-5 && one.segments.len() < 100,
        "{}",
        one.segments.len()
    );
}

/// Some programs write no z of flat splines.
#[test]
fn splines_without_z_are_the_same() {
    let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 2.5, 3.0, 3.0, 3.0, 3.0];
    let entities = [spline(3, &knots, &POINTS, &[]), line(POINTS[5], POINTS[0])];
    let flat = entities.clone().map(|entity| entity.replace(" 30 0", ""));
    assert_eq!(
        loop_of("dxf", &dxf(&flat)).segments,
        loop_of("dxf", &dxf(&entities)).segments
    );
}

/// Inkscape and OpenJSCAD write a z at each vertex of a light polyline; others leave noise in it.
#[test]
fn light_polylines_with_z_are_the_same() {
    let flat = polyline(
        true,
        &[[9.0, 0.0, 0.4], [0.0, 9.0, 0.0], [-9.0, 0.0, 0.2]],
        "",
    );
    let expected = loop_of("dxf", &dxf(std::slice::from_ref(&flat)));
    for z in ["0", "1e-9"] {
        let with_z = flat.replacen(" 42 ", " 30 0 42 ", 1);
        let (first, rest) = with_z.split_at(with_z.find(" 42 ").unwrap() + 4);
        let with_z = first.to_owned() + &rest.replace(" 42 ", &format!(" 30 {z} 42 "));
        assert_eq!(with_z.matches(" 30 ").count(), 3);
        let found = loop_of("dxf", &dxf(&[with_z]));
        assert_eq!(found.segments, expected.segments);
    }
    let high = flat.replace(" 42 0.4", " 30 1 42 0.4");
    let error = drawn("dxf", &dxf(&[high]), &in_mm()).unwrap_err();
    assert!(
        error.to_string().contains("a point of another z"),
        "{error}"
    );
}

/// A periodic spline, its first three points repeated behind, closes by itself.
#[test]
fn a_periodic_spline_is_a_loop() {
    let points: Vec<[f64; 2]> = POINTS.iter().chain(&POINTS[..3]).copied().collect();
    let knots: Vec<f64> = (0..13).map(f64::from).collect();
    let one = loop_of("dxf", &dxf(&[spline(3, &knots, &points, &[])]));
    assert_eq!((one.segments.len(), one.bound_mm), (6, 0.0));
}
