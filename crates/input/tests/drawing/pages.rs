//! SVG pages against svgpathtools 1.8.0 (`parse_path(d)[i].point(t)`) and closed forms.

use super::*;
use made::svg;

/// Checks that these points lie on the loop, y reversed.
fn check_mirrored(one: &DrawnPath, points: &[Vec<[f64; 2]>]) {
    let below = points.concat().into_iter().map(|[x, y]| [x, -y]);
    check_through(one, &below.collect::<Vec<_>>());
}

/// svgpathtools 1.8.0: segment, parameters 0, 1/4, 1/2, 3/4. y is reversed here.
#[test]
fn path_data_is_that_of_svgpathtools() {
    let points = [
        "10.0 20.0, 12.5625 17.125, 15.25 16.5, 18.0625 18.125",
        "21.0 22.0, 23.6875 25.9375, 25.75 27.75, 27.1875 27.4375",
        "28.0 25.0, 33.59619407771256 26.489592359914347, 36.5 31.5, 35.01040764008565 37.09619407771256",
        "30.0 40.0, 21.746098043640053 35.5494435314814, 14.812501285056515 35.170428776180955, 13.260816669401486 39.08497743741414",
        "18.0 45.0, 16.453125 44.625, 13.125 42.75, 9.984375 38.25",
        "9.0 30.0, 9.25 27.5, 9.5 25.0, 9.75 22.5",
    ]
    .map(points);
    let data = "M10,20 q 5,-8 11,2 t 7,3 A 6 6 0 0 1 30 40 a 9 4 30 1 0 -12 5 S 8,44 9,30 Z";
    let one = loop_of("svg", &svg(&format!("<path id=\"p\" d=\"{data}\"/>")));
    assert_eq!(one.name, "p");
    check_mirrored(&one, &points);
    // The curves and the round arc are what they were: parameter for parameter.
    for (segment, points) in one.segments.iter().zip(&points[..3]) {
        for (step, [x, y]) in points.iter().enumerate() {
            let off = segment.at(step as f64 / 4.0) - Point2::new(*x, -*y);
            assert!(off.norm() < 1e-12, "{off}");
        }
    }
    assert!(matches!(one.segments[2], PathSegment::Arc { .. }));
    assert!(one.bound_mm > 0.0 && one.bound_mm <= 1e-5);
}

/// A circle under turns, even scales and mirrors stays an arc; under a stretch it is an ellipse of known axes.
#[test]
fn transforms_keep_circles_where_they_are_round() {
    let page = svg(
        "<g transform=\"translate(3 4)\"><g transform=\"rotate(30) scale(-2 2)\"><circle cx=\"1\" cy=\"0.5\" r=\"1.5\"/></g></g>",
    );
    let one = loop_of("svg", &page);
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    // (1, 0.5) scaled is (-2, 1), turned and moved, y reversed.
    let centre = Point2::new(3.0 - 2.0 * cos - sin, -(4.0 - 2.0 * sin + cos));
    assert_eq!(one.segments.len(), 2);
    let is_round = |segment: &PathSegment| {
        matches!(segment, PathSegment::Arc { centre: found, radius, .. }
            if (found - centre).norm() < 1e-14 && (radius - 3.0).abs() < 1e-14)
    };
    assert!(one.segments.iter().all(is_round), "{one:?}");
    let page = svg("<circle transform=\"scale(3 1)\" cx=\"1\" cy=\"2\" r=\"2\"/>");
    let one = loop_of("svg", &page);
    let ellipse = points("9 -2, 3 0, -3 -2");
    check_through(&one, &ellipse);
    check_through(&one, &[[3.0 + 6.0 * 0.6, -2.0 - 2.0 * 0.8]]);
    assert!(one.bound_mm > 0.0);
}

/// The unit by width over the width of the view box; the area of a square by hand.
#[test]
fn the_page_states_the_unit() {
    let page = |size: &str| {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" {size}><rect width=\"3\" height=\"3\"/></svg>"
        )
    };
    for (width, view, mm) in [
        ("40mm", 40.0, 1.0),
        ("2in", 50.8, 1.0),
        ("4cm", 20.0, 2.0),
        ("72pt", 254.0, 0.1),
        ("6pc", 25.4, 1.0),
    ] {
        let size = format!("width=\"{width}\" height=\"{width}\" viewBox=\"0 0 {view} {view}\"");
        let drawing = drawn("svg", &page(&size), &Options::default()).unwrap();
        let corner = drawing.loops[0].segments[1].end();
        let off = corner - Point2::new(3.0 * mm, -3.0 * mm);
        assert!(off.norm() < 1e-12, "{corner}");
    }
    let pixels = "width=\"40\" height=\"40\" viewBox=\"0 0 40 40\"";
    for (words, given) in [
        (pixels, Unit::Inch),
        ("", Unit::Cm),
        ("width=\"40mm\" height=\"40mm\"", Unit::Um),
    ] {
        let text = page(words);
        let unstated = drawn("svg", &text, &Options::default()).unwrap_err();
        let words = "the unit is not stated";
        assert!(unstated.reason.starts_with(words), "{unstated}");
        let drawing = drawn("svg", &text, &stated_in(given)).unwrap();
        assert_eq!(drawing.loops[0].segments[0].length(), 3.0 * given.mm());
    }
}

/// Undrawn and hidden elements and text are left out; `id` selects an element or a group.
#[test]
fn what_is_no_outline_is_left_out() {
    let page = svg(concat!(
        "<defs><circle r=\"1\"/></defs><g style=\"display: none\"><circle r=\"2\"/></g><text>z=8</text>",
        "<g id=\"a\"><circle id=\"b\" r=\"3\"/><circle r=\"4\"/></g><circle visibility=\"hidden\" r=\"5\"/>",
        "<inkscape:path xmlns:inkscape=\"http://x\" d=\"M 0 0\"/>"
    ));
    let radii = |select: Option<&str>| {
        let options = Options {
            select: select.map(str::to_owned),
            ..Options::default()
        };
        let drawing = drawn("svg", &page, &options).unwrap();
        let radius = |one: &DrawnPath| one.segments[0].length() / std::f64::consts::PI;
        let radii: Vec<f64> = drawing.loops.iter().map(radius).collect();
        (radii, drawing.remarks.len())
    };
    assert_eq!(radii(None), (vec![3.0, 4.0], 2));
    assert_eq!(radii(Some("a")), (vec![3.0, 4.0], 0));
    assert_eq!(radii(Some("b")), (vec![3.0], 0));
    let mixed = drawn("svg", &made::mixed_svg(), &Options::default()).unwrap();
    assert_eq!((mixed.loops.len(), mixed.remarks.len()), (4, 0));
}
