//! Lists of points: separators, units, and the smooth curve.

use super::*;

/// The same three points in every way to write them.
#[test]
fn a_list_is_read_as_it_is_written() {
    let expected = loop_of("csv", "0.5,1\n7.25,2\n3,9.125\n");
    assert_eq!(expected.segments.len(), 3);
    for text in [
        "x,y\n0.5,1\n7.25,2\n3,9.125\n",
        "X (mm);Y (mm)\n0,5;1\n7,25;2\n3;9,125\n",
        "\u{feff}# unit: mm\r\n0.5\t1\r\n7.25\t2\r\n\r\n3\t9.125\r\n",
        "# units = \"mm\"\nx_mm,y_mm\n0.5, 1\n7.25, 2\n7.25, 2\n3, 9.125\n0.5, 1\n",
        "# unit: cm\n0.05,0.1\n0.725,0.2\n0.3,0.9125\n",
    ] {
        let options = match text.starts_with("x,") {
            true => in_mm(),
            false => Options::default(),
        };
        let drawing = drawn("csv", text, &options).unwrap();
        assert_eq!(drawing.loops.len(), 1);
        for (found, expected) in drawing.loops[0].segments.iter().zip(&expected.segments) {
            assert!((found.end() - expected.end()).norm() < 1e-14, "{text}");
        }
        let repeats = text.contains("7.25, 2\n7.25");
        assert_eq!(drawing.remarks.len(), usize::from(repeats));
    }
}

/// Both derivatives are continuous at every point, the last and the first included: the definition of the spline.
#[test]
fn the_smooth_curve_has_no_kink_and_no_jump_of_curvature() {
    let points = points("9 1, 5 7, -1 8, -7.5 2, -3 -6, -2.9 -6.2, 4 -7");
    let text: String = points.iter().map(|[x, y]| format!("{x},{y}\n")).collect();
    let segments = smooth(&text);
    assert_eq!(segments.len(), points.len());
    // Three are enough.
    assert_eq!(smooth("0,0\n5,0\n0,5\n").len(), 3);
    for index in 0..points.len() {
        let (PathSegment::Cubic(a), PathSegment::Cubic(b)) =
            (segments[index], segments[(index + 1) % points.len()])
        else {
            panic!("{segments:?}");
        };
        assert_eq!(a[0], Point2::from(points[index]));
        let (h, k) = ((a[3] - a[0]).norm(), (b[3] - b[0]).norm());
        let first = (a[3] - a[2]) / h - (b[1] - b[0]) / k;
        let second =
            ((a[3] - a[2]) - (a[2] - a[1])) / h / h - ((b[2] - b[1]) - (b[1] - b[0])) / k / k;
        let off = (first.norm(), second.norm());
        assert!(off.0 < 1e-13 && off.1 < 1e-11, "{off:?}");
    }
}

/// Points on a circle of radius 20: the periodic spline is off by r h⁴/384 or so (de Boor, ch. V), h the step in rad.
#[test]
fn the_smooth_curve_through_a_circle_is_round() {
    let off = |count: u32| {
        let angle = |index: u32| std::f64::consts::TAU * f64::from(index) / f64::from(count);
        let at = |(sin, cos): (f64, f64)| format!("{:.15},{:.15}\n", 20.0 * cos, 20.0 * sin);
        let text: String = (0..count).map(|index| at(angle(index).sin_cos())).collect();
        let at = |segment: &PathSegment| (segment.at(0.5).coords.norm() - 20.0).abs();
        smooth(&text).iter().map(at).fold(0.0, f64::max)
    };
    let (coarse, fine) = (off(40), off(80));
    assert!((coarse / fine - 16.0).abs() < 0.5, "{coarse:e} {fine:e}");
    let step: f64 = std::f64::consts::TAU / 40.0;
    assert!(coarse < 20.0 * step.powi(4) / 100.0, "{coarse:e}");
}
