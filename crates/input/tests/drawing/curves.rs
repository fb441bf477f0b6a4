//! Arcs, bulges and ellipses of a DXF against closed forms and against ezdxf 1.4.5 (`bulge_to_arc`, `ConstructionEllipse`, `path`).

use super::*;
use made::{dxf, in_units, line, polyline};
use std::f64::consts::{PI, TAU};

/// The one arc of a loop.
fn arc(one: &DrawnPath) -> ([f64; 2], f64, f64) {
    let mut arcs = one.segments.iter().filter_map(|segment| match *segment {
        PathSegment::Arc {
            centre,
            radius,
            sweep,
            ..
        } => Some(([centre.x, centre.y], radius, sweep)),
        _ => None,
    });
    match (arcs.next(), arcs.next()) {
        (Some(arc), None) => arc,
        _ => panic!("{one:?}"),
    }
}

/// ezdxf 1.4.5, `ezdxf.math.bulge_to_arc`; sweeps: 4 atan(bulge), the definition.
#[test]
fn bulges_are_the_arcs_of_ezdxf() {
    for (ends, bulge, centre, radius) in [
        (
            "1 2, 6 3",
            0.6,
            "3.233333333333333 3.833333333333333",
            2.889444391035911,
        ),
        (
            "1 2, 6 3",
            -1.8,
            "3.1888888888888887 4.055555555555556",
            3.002755935782418,
        ),
        ("0 0, 10 0", 0.02, "5 124.95", 125.05),
    ] {
        let (ends, centre) = (points(ends), points(centre)[0]);
        let [x, y] = ends[0];
        let [u, v] = ends[1];
        let text = dxf(&[polyline(true, &[[x, y, bulge], [u, v, 0.0]], "")]);
        let one = loop_of("dxf", &text);
        let (found, found_radius, sweep) = arc(&one);
        let off = (Point2::from(found) - Point2::from(centre)).norm();
        assert!(off < 1e-12, "{found:?}");
        assert!((found_radius - radius).abs() < 1e-12, "{found_radius}");
        assert_eq!(sweep, 4.0 * f64::atan(bulge));
        assert_eq!(one.bound_mm, 0.0);
        assert_eq!((one.segments.len(), one.name.as_str()), (2, "TEETH"));
    }
}

/// Sagitta = bulge × half the chord, whatever the radius: the definition of the bulge.
#[test]
fn flat_bulges_keep_their_ends_and_their_sagitta() {
    for bulge in [1e-12, 1e-9, 1e-6, 9.99e-4, 1e-3, 1.001e-3, 0.01] {
        for sign in [-1.0, 1.0] {
            let vertices = [[3.0, 1.0, sign * bulge], [43.0, 1.0, 0.0], [3.0, -9.0, 0.0]];
            let one = loop_of("dxf", &dxf(&[polyline(true, &vertices, "")]));
            // A bulge is positive where the arc turns left: it lies right of its chord.
            let sagitta = 1.0 - one.segments[0].at(0.5).y;
            // The rounding of a point at this distance from the centre: 10 / bulge, where it is an arc.
            let round = 20.0 / bulge * f64::EPSILON;
            let rounding = if bulge < 1e-3 { 2e-14 } else { round };
            let is_near = (sagitta - sign * bulge * 20.0).abs() <= one.bound_mm + rounding;
            assert!(is_near, "{bulge}: {sagitta}");
            assert!(one.bound_mm < 1e-9 && (bulge < 1e-6 || one.bound_mm < 1e-14));
        }
    }
}

/// ezdxf 1.4.5, `ConstructionEllipse.vertices`; between them the equation of the ellipse.
#[test]
fn ellipses_lie_within_their_bound() {
    let points = [
        [5.422058197634422, 5.457049880699497],
        [2.6917463475712227, 5.303848887220211],
        [-3.7238846506594165, 0.7935134415671123],
        [-1.3600551099485454, -1.4745358532066921],
    ];
    let text = dxf(&[
        "ELLIPSE 8 TEETH 10 1 20 2 11 5 21 3 40 0.4 41 0.3 42 4".to_owned(),
        line(points[0], points[3]),
    ]);
    let one = loop_of("dxf", &text);
    let bound = one.bound_mm;
    assert!(bound > 1e-9 && bound <= 1e-5, "{bound}");
    check_through(&one, &points);
    let mut worst = 0.0_f64;
    for segment in &one.segments {
        let PathSegment::Cubic(_) = segment else {
            continue;
        };
        for step in 0..=50 {
            let ray = segment.at(f64::from(step) / 50.0) - Point2::new(1.0, 2.0);
            let (a, b) = (34_f64.sqrt(), 0.4 * 34_f64.sqrt());
            let (x, y) = (
                (5.0 * ray.x + 3.0 * ray.y) / a / a,
                (5.0 * ray.y - 3.0 * ray.x) / a / b,
            );
            // Off by no more than this times the greatest half axis.
            worst = worst.max((x.hypot(y) - 1.0).abs() * a);
        }
    }
    // The bound is attained to a third.
    let is_used = worst <= bound && worst > 0.3 * bound;
    assert!(is_used, "{worst:e} of {bound:e}");
}

/// A circle is two half arcs, and so is an ellipse with equal axes; area π r², length τ r.
#[test]
fn circles_stay_circles() {
    for entity in [
        "CIRCLE 10 3 20 2 40 1.5",
        "ELLIPSE 10 3 20 2 11 0.9 21 1.2 40 1 41 0 42 6.283185307179586",
        "ARC 10 3 20 2 40 1.5 50 0 51 360",
    ] {
        let one = loop_of("dxf", &dxf(&[entity.to_owned()]));
        assert_eq!((one.segments.len(), one.name.as_str()), (2, "0"));
        let length: f64 = one.segments.iter().map(PathSegment::length).sum();
        assert!((length - TAU * 1.5).abs() < 1e-12);
        let is_half = |segment: &PathSegment| matches!(segment, PathSegment::Arc { sweep, .. } if (sweep.abs() - PI).abs() < 1e-12);
        assert!(one.segments.iter().all(is_half));
    }
}

/// The code of the unit by the DXF reference; a circle of radius 2 units.
#[test]
fn units_are_those_of_the_header_or_stated() {
    let circle = ["CIRCLE 10 0 20 0 40 2".to_owned()];
    for (code, unit, mm) in [
        (1, Unit::Inch, 25.4),
        (4, Unit::Mm, 1.0),
        (5, Unit::Cm, 10.0),
        (6, Unit::M, 1000.0),
        (13, Unit::Um, 0.001),
    ] {
        let stated = drawn("dxf", &in_units(Some(code), &circle), &Options::default()).unwrap();
        let given = stated_in(unit);
        for drawing in [
            drawn("dxf", &in_units(Some(code), &circle), &given).unwrap(),
            drawn("dxf", &in_units(None, &circle), &given).unwrap(),
            drawn("dxf", &in_units(Some(0), &circle), &given).unwrap(),
        ] {
            assert_eq!(drawing.loops[0].segments, stated.loops[0].segments);
        }
        let PathSegment::Arc { radius, .. } = stated.loops[0].segments[0] else {
            panic!("{stated:?}");
        };
        assert_eq!(radius, 2.0 * mm);
    }
}

/// The whole file with every kind of entity: its corners, which are typed there.
#[test]
fn a_mixed_outline_and_its_bore() {
    let drawing = drawn("dxf", &made::mixed_dxf(), &Options::default()).unwrap();
    let [teeth, bore] = &drawing.loops[..] else {
        panic!("{drawing:?}")
    };
    assert_eq!((teeth.name.as_str(), bore.name.as_str()), ("TEETH", "BORE"));
    let places = "10.0 0.0, 12.0 1.0, 14.0 3.0, 9.0 8.0, 5.0 9.0, 0.0 8.0, -5.0 0.0, 2.5 -3.75";
    check_through(teeth, &points(places));
    let note = "left out: TEXT (1, the first in line 219: entity 10 (TEXT on layer \"NOTES\"))";
    assert_eq!(drawing.remarks, [note]);
    let one = Options {
        select: Some("bore".to_owned()),
        ..Options::default()
    };
    let only = drawn("dxf", &made::mixed_dxf(), &one).unwrap();
    assert_eq!(only.loops[..], drawing.loops[1..]);
    assert_eq!(only.remarks, [""; 0]);
}
