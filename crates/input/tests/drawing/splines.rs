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
const WEIGHTS: [f64; 6] = [1.0, 2.0, 0.5, 1.5, 1.0, 0.8];
const CLAMPED: &str = "0 0 0 0 1 2.5 3 3 3 3";

fn numbers(text: &str) -> Vec<f64> {
    text.split(' ').map(|word| word.parse().unwrap()).collect()
}

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
    let [x, y, weight] = row[degree];
    [x / weight, y / weight]
}

/// A spline, closed by a straight line, as the loop of its drawing, which goes through its points.
fn check(degree: usize, knots: &str, points: &[[f64; 2]], weights: &[f64]) -> DrawnPath {
    let knots = numbers(knots);
    let domain = [knots[degree], knots[points.len()]];
    let at = |t: f64| de_boor(degree, &knots, points, weights, t);
    let mut entities = vec![spline(degree, &knots, points, weights)];
    let ends = domain.map(at);
    if ends[0] != ends[1] {
        entities.push(line(ends[0], ends[1]));
    }
    let one = loop_of("dxf", &dxf(&entities));
    let steps = (0..=100).map(|step| f64::from(step) / 100.0);
    let on = steps.map(|share| at(domain[0] + (domain[1] - domain[0]) * share));
    check_through(&one, &on.collect::<Vec<_>>());
    one
}

/// Degrees 1 to 3, clamped, not clamped, with a double and a triple knot: exact, a cubic curve or line for each span.
#[test]
fn splines_without_weights_are_exact() {
    for (degree, knots, spans) in [
        (1, "0 0 1 2 3.5 4 5 5", 5),
        (2, "0 0 0 1 2.5 3 4 4 4", 4),
        (2, "0 1 2 3 4 5 6 7 8", 4),
        (3, CLAMPED, 3),
        (3, "-2 0 0.5 1 2 2 3 3.5 4 7", 2),
        (3, "0 0 0 0 1 1 2 2 2 2", 2),
    ] {
        let one = check(degree, knots, &POINTS, &[]);
        assert_eq!((one.bound_mm, one.segments.len()), (0.0, spans + 1));
        let same = check(degree, knots, &POINTS, &[2.5; 6]);
        assert_eq!(same.segments[..spans], one.segments[..spans]);
    }
}

/// Points of ezdxf 1.4.5: `BSpline(points, order, knots, weights).point(t)`.
#[test]
fn splines_go_through_the_points_of_ezdxf() {
    for (degree, knots, weights, on) in [
        (
            3,
            "0 1 2 3 4 5 6 7 8 9",
            &[][..],
            "4.166666666666666 4.833333333333333, 6.014666666666667 5.284, 10.291666666666666 1.4374999999999998, 8.158854166666666 -4.5703125, 6.833333333333333 -5.0",
        ),
        (
            3,
            CLAMPED,
            &WEIGHTS,
            "2.98564997186269 4.252110298255488, 6.443181818181818 4.420454545454545, 10.51475919212843 -0.397909702933007, 7.45921676228486 -4.957844849089549",
        ),
        (
            5,
            "0 0 0 0 0 0 1 1 1 1 1 1",
            &[],
            "2.068660000000001 2.313860000000001, 7.079236181199999 2.6761128602, 8.3125 0.8125, 3.83634 -4.432860000000001",
        ),
    ] {
        check_through(&check(degree, knots, &POINTS, weights), &points(on));
    }
}

/// Weights and degrees above 3: within the bound, which is below 10 nm and not zero.
#[test]
fn other_splines_lie_within_their_bound() {
    for (degree, knots, weights) in [
        (2, "0 0 0 1 2.5 3 4 4 4", &WEIGHTS[..]),
        (3, CLAMPED, &WEIGHTS),
        (5, "0 0 0 0 0 0 1 1 1 1 1 1", &[]),
        (4, "0 1 2 3 4 5 6 7 8 9 10", &WEIGHTS),
    ] {
        let bound = check(degree, knots, &POINTS, weights).bound_mm;
        assert!(bound > 0.0 && bound <= 1e-5, "{bound}");
    }
}

/// A quarter of a circle as the rational parabola with the weight 1/√2 (Piegl, Tiller: The NURBS Book, 7.3).
#[test]
fn a_rational_circle_is_round() {
    let half = 0.5_f64.sqrt();
    let points = points("5 0, 5 5, 0 5, -5 5, -5 0, -5 -5, 0 -5, 5 -5, 5 0");
    let weights = [1.0, half, 1.0, half, 1.0, half, 1.0, half, 1.0];
    let one = check(2, "0 0 0 1 1 2 2 3 3 4 4 4", &points, &weights);
    for segment in &one.segments {
        for step in 0..=20 {
            let off = segment.at(f64::from(step) / 20.0).coords.norm() - 5.0;
            assert!(off.abs() <= one.bound_mm + 1e-14, "{off:e}");
        }
    }
    assert!(one.bound_mm < 1e-5 && one.segments.len() < 100, "{one:?}");
}

/// Some programs write no z of flat splines.
#[test]
fn splines_without_z_are_the_same() {
    let spline = spline(3, &numbers(CLAMPED), &POINTS, &[]);
    let entities = [spline, line(POINTS[5], POINTS[0])];
    let flat = entities.clone().map(|entity| entity.replace(" 30 0", ""));
    let [flat, entities] = [flat, entities].map(|each| loop_of("dxf", &dxf(&each)).segments);
    assert_eq!(flat, entities);
}

/// Inkscape and OpenJSCAD write a z at each vertex of a light polyline; others leave noise in it.
#[test]
fn light_polylines_with_z_are_the_same() {
    let vertices = [[9.0, 0.0, 0.4], [0.0, 9.0, 0.0], [-9.0, 0.0, 0.2]];
    let flat = polyline(true, &vertices, "");
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
    let words = "a point of another z";
    assert!(error.to_string().contains(words), "{error}");
}

/// A periodic spline, its first three points repeated behind, closes by itself.
#[test]
fn a_periodic_spline_is_a_loop() {
    let points: Vec<[f64; 2]> = POINTS.iter().chain(&POINTS[..3]).copied().collect();
    let knots: Vec<f64> = (0..13).map(f64::from).collect();
    let one = loop_of("dxf", &dxf(&[spline(3, &knots, &points, &[])]));
    assert_eq!((one.segments.len(), one.bound_mm), (6, 0.0));
}
