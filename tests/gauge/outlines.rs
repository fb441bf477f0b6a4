//! Spans and pins on outlines: against the gauge of gears by their data, and against closed forms where there is no involute.

use super::*;

/// `teeth` times the half of a tooth, its centre line on +y, given from tip to root, and its mirror image.
fn all_round(teeth: u32, half: &[PathSegment]) -> Vec<PathSegment> {
    repeated(teeth, &symmetrical(half))
}

/// An arc about the origin.
fn arc(radius: f64, start: f64, end: f64) -> PathSegment {
    PathSegment::Arc {
        centre: Point2::origin(),
        radius,
        start,
        sweep: end - start,
    }
}

fn over(list: &[OverPins]) -> Vec<(u32, f64, f64)> {
    let each = list.iter();
    each.map(|one| (one.tooth, one.length, one.error)).collect()
}

fn spans_of(list: &[Span]) -> Vec<(u32, f64, f64)> {
    let each = list.iter();
    let each = each.map(|one| (one.first_tooth, one.length, one.error));
    each.collect()
}

/// Source: the gauge of gears by their data, which cuts polygons of the flanks it knows. The outline is once the gear's own curves, once
/// chords of 0.1 µm read as a drawing; perfect gears and such with deviations of every tooth, of either face, with runout, odd and even.
#[test]
fn an_outline_of_a_gear_reads_as_the_gear() {
    const CHORD: f64 = 1e-4;
    let perfect = |teeth, shift| spur(teeth, 3.0).shift(shift).front();
    let made = |teeth, face, e| made(teeth, 0.0, Hand::Right, face, e).gear;
    for gear in [
        perfect(20, 0.0),
        perfect(9, 0.5),
        perfect(61, -0.3),
        made(21, Face::Back, 0.031),
        made(44, Face::Front, 0.0),
        made(32, Face::Back, 0.02),
    ] {
        let expected = measure(&gear, quick());
        let (spans, pins) = (expected.spans.unwrap(), expected.pins.unwrap());
        let teeth = gear.gear().basic_data().teeth();
        let drawn = of_gear(&gear, CHORD);
        for (outline, slack) in [
            (OutlineGear::from(&gear), 1e-9),
            (read(&drawn, gear.face(), Some(teeth), CHORD), 10.0 * CHORD),
        ] {
            let found = gauge_outline(&outline, Some(spans.teeth), Some(pins.diameter));
            let (on, over_pins) = (found.spans.unwrap(), found.pins.unwrap());
            for (what, found, expected) in [
                ("span", spans_of(&on.readings), spans_of(&spans.readings)),
                ("two pins", over(&over_pins.two), over(&pins.two)),
                ("three pins", over(&over_pins.three), over(&pins.three)),
            ] {
                assert_eq!(found.len(), expected.len(), "{what}");
                for ((tooth, length, bound), other) in found.into_iter().zip(expected) {
                    assert_eq!(tooth, other.0, "{what}");
                    near((what, tooth), length, other.1, bound + other.2);
                    assert!(bound <= slack, "{what} at {tooth}: bound {bound}");
                }
            }
            for (seat, data) in over_pins.seats.iter().zip(&pins.seats) {
                for (found, data) in seat.touched.iter().zip(&data.touched) {
                    assert_eq!(found.tooth, data.tooth);
                    // A chord of 0.1 µm is up to 0.1 mm long.
                    let within = 1e-4f64.max(slack * 100.0);
                    near(teeth, found.radius, data.radius, within);
                }
            }
        }
    }
}

/// Straight flanks that lean by `lean` towards the tip, `h` from the centre: their lines; tip and root arcs at the radii given.
fn straight(teeth: u32, lean: f64, h: f64, [root, tip]: [f64; 2]) -> Vec<PathSegment> {
    // On the right flank x cos(lean) + y sin(lean) = h.
    let (sin, cos) = lean.sin_cos();
    let at = |radius: f64| {
        let along = (radius * radius - h * h).sqrt();
        Point2::new(h * cos - along * sin, h * sin + along * cos)
    };
    let angle = |point: Point2<f64>| point.y.atan2(point.x);
    let (top, bottom) = (at(tip), at(root));
    let middle = FRAC_PI_2 - PI / f64::from(teeth);
    let half = [
        arc(tip, FRAC_PI_2, angle(top)),
        PathSegment::Line([top, bottom]),
        arc(root, angle(bottom), middle),
    ];
    all_round(teeth, &half)
}

/// Flanks whose lean β is half the angle between the outer teeth of a span lie flat on the anvils: W_k = 2 h. A pin's centre is at ρ = (h + R)/sin(β + π/z);
/// of odd teeth M = 2 ρ cos(π/2z) + D over two, ρ (1 + cos(π/z)) + D over three pins.
#[test]
fn straight_flanks_by_their_closed_form() {
    for (teeth, k) in [(24u32, 3u32), (17, 2), (16, 2)] {
        let pitch = TAU / f64::from(teeth);
        let lean = 0.5 * f64::from(k - 1) * pitch;
        let (root, tip, diameter) = (9.0, 11.0, 2.0);
        let h = 10.0 * (0.25 * pitch + lean).sin();
        let path = straight(teeth, lean, h, [root, tip]);
        let outline = read(&path, Face::Front, Some(teeth), 0.0);
        let found = gauge_outline(&outline, Some(k), Some(diameter));
        let spans = found.spans.unwrap();
        for span in &spans.readings {
            near(teeth, span.length, 2.0 * h, span.error);
        }
        let [least, greatest] = spans.summary().ends;
        assert!(greatest - least < 1e-12);
        let pins = found.pins.unwrap();
        let rho = (h + 0.5 * diameter) / (lean + 0.5 * pitch).sin();
        let odd = teeth % 2 == 1;
        let two = diameter + 2.0 * rho * if odd { (0.25 * pitch).cos() } else { 1.0 };
        let three = diameter + rho * (1.0 + (0.5 * pitch).cos());
        assert_eq!(pins.three.len(), if odd { teeth as usize } else { 0 });
        for (list, expected) in [(&pins.two, two), (&pins.three, three)] {
            for over in list {
                assert!(over.error < 1e-11, "{over:?}");
                near(teeth, over.length, expected, over.error);
            }
        }
    }
}

/// Parallel flanks `a` from the tooth's centre line under a round head about a centre at the radius `q`: anvils on two heads
/// W = 2 q sin((k − 1) π/z) + 2 a, the greatest as they are rocked; a pin between two heads at ρ = q cos(π/z) + √((a + R)² − q² sin²(π/z)).
#[test]
fn round_heads_by_their_closed_form() {
    let (a, q, root, diameter) = (0.9f64, 10.0f64, 8.0f64, 3.0f64);
    for teeth in [15u32, 14] {
        let foot = (root * root - a * a).sqrt();
        let angle = foot.atan2(a);
        let half = [
            PathSegment::Arc {
                centre: Point2::new(0.0, q),
                radius: a,
                start: FRAC_PI_2,
                sweep: -FRAC_PI_2,
            },
            PathSegment::Line([Point2::new(a, q), Point2::new(a, foot)]),
            arc(root, angle, FRAC_PI_2 - PI / f64::from(teeth)),
        ];
        let outline = read(&all_round(teeth, &half), Face::Back, Some(teeth), 0.0);
        let step = PI / f64::from(teeth);
        for k in [2u32, 3, 5] {
            let spans = gauge_outline(&outline, Some(k), None).spans.unwrap();
            let expected = 2.0 * q * (f64::from(k - 1) * step).sin() + 2.0 * a;
            for span in &spans.readings {
                assert!(span.error < 1e-11, "{span:?}");
                near((teeth, k), span.length, expected, span.error);
                let curves = span.touched.map(|touch| touch.curve);
                assert_eq!(curves, [ToothPlace::Flank; 2]);
            }
        }
        let pins = gauge_outline(&outline, None, Some(diameter)).pins.unwrap();
        let chord = q * step.sin();
        let rho = q * step.cos() + ((a + 0.5 * diameter).powi(2) - chord * chord).sqrt();
        for seat in &pins.seats {
            assert!(seat.error < 1e-11, "{seat:?}");
            near(teeth, seat.centre.coords.norm(), rho, seat.error);
        }
    }
}

/// Source: the polygon of the whole outline, chords of 1 nm: no metal lies within a pin, on flanks that are no circle and no involute, and its two places are
/// touched; no anvil of the reading's direction cuts the teeth it spans.
#[test]
fn pins_and_anvils_touch_the_whole_outline() {
    const CHORD: f64 = 1e-6;
    let teeth = 19u32;
    let middle = FRAC_PI_2 - PI / f64::from(teeth);
    let foot = polar(8.0, middle + 0.01);
    let head = [[0.0, 11.2], [0.5, 11.2], [0.6, 10.6], [0.75, 10.0]].map(Point2::from);
    let [from, by, to] = [[0.75, 10.0], [0.9, 9.4], [0.8, 8.6]].map(Point2::from);
    let half = [
        PathSegment::Cubic(head),
        PathSegment::Cubic([from, by, to, foot]),
        PathSegment::Line([foot, polar(8.0, middle)]),
    ];
    let outline = read(&all_round(teeth, &half), Face::Front, Some(teeth), 0.0);
    let polygon = outline.points(0.0, CHORD);
    let found = gauge_outline(&outline, Some(4), Some(2.4));
    for seat in &found.pins.unwrap().seats {
        let next = polygon.iter().cycle().skip(1);
        let distances = polygon.iter().zip(next).map(|(a, b)| {
            let (chord, to) = (b - a, seat.centre - a);
            let along = (to.dot(&chord) / chord.norm_squared()).clamp(0.0, 1.0);
            (to - along * chord).norm()
        });
        let [least, _] = ends(distances);
        near(seat, least, 1.2, CHORD + seat.error);
    }
    // By symmetry the anvils stand square to the middle of the teeth spanned: the reading is how far these reach along that, above the anvils' ends.
    let depth = outline.tip_radius() - outline.root_radius();
    let reach = outline.root_radius() + depth / 3.0;
    let spans = found.spans.unwrap();
    let along = Rotation2::new(outline.tooth_angle(2.5)) * Vector2::y();
    let spanned = polygon.iter().filter(|point| {
        let aside = along.perp(&point.coords);
        let off = along.dot(&point.coords).atan2(aside.abs());
        point.coords.norm() >= reach && off.abs() < 2.0 * outline.pitch() && aside < 0.0
    });
    let [least, most] = ends(spanned.map(|point| along.dot(&point.coords)));
    let span = &spans.readings[0];
    near("span", most - least, span.length, 2.0 * CHORD + span.error);
}

/// Impossible measurements of an outline: too many teeth, flanks that only an anvil's end touches, pins that sink or rest on the root.
#[test]
fn impossible_measurements_have_a_reason() {
    // Flanks that lean by more than half the angle of two teeth.
    let lean = 1.5 * PI / 24.0;
    let path = straight(24, lean, 10.0 * (PI / 48.0 + lean).sin(), [9.0, 11.0]);
    let outline = read(&path, Face::Front, Some(24), 0.0);
    for (k, pin, reason) in [
        (Some(0), None, "allowed is 1 up to half"),
        (Some(13), None, "allowed is 1 up to half"),
        (Some(2), None, "span more teeth"),
        (None, Some(0.1), "no rest on both flanks"),
        (None, Some(1.0), "does not stand out"),
    ] {
        let found = gauge_outline(&outline, k, pin);
        let spans = found.spans.err().filter(|_| k.is_some());
        let said = spans.or(found.pins.err()).unwrap().to_string();
        assert!(said.contains(reason), "{k:?} {pin:?}: {said}");
    }
}
