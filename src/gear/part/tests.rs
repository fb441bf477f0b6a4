use super::*;
use crate::gear::{AsBuilt, Deviations, Face, GearDesign, Hand, Modification, Relief, Side, Trace};

/// All kinds of curves, those of helical gears and a straight line included.
fn parts() -> Vec<(String, Part)> {
    let mut parts = Vec::new();
    let mut gears = Vec::new();
    for (helix, (teeth, shift)) in [0.0, 15.0, 33.0]
        .into_iter()
        .flat_map(|helix| [(9, -0.1), (44, 0.0), (200, 1.2)].map(|gear| (helix, gear)))
    {
        let design = GearDesign::plain(teeth, 2.0).helical(helix, Hand::Right);
        let gear = design.shifted(shift).gear();
        // Undercut, ordinary and with `h_0 < 0`.
        assert_eq!(gear.is_undercut(), teeth == 9);
        gears.push((format!("{teeth} at {helix}°"), gear));
    }
    for (which, gear) in &gears {
        let all = ProfilePart::ALL.into_iter();
        parts.extend(all.map(|part| (format!("{which} {}", part.name()), gear.part(part).clone())));
    }
    let circle = |convex| PartCurve::Circle(Circle::new(Point2::new(30.0, 2.0), 4.0, convex));
    let cubic = |points: [[f64; 2]; 4]| PartCurve::Cubic(Cubic::new(points.map(Point2::from)));
    let line = Line::new(Point2::new(39.5, -2.0), Point2::new(46.0, -0.9));
    for (what, curve, ends) in [
        ("line", PartCurve::Line(line), [6.5, 0.0]),
        ("convex arc", circle(true), [0.3, 1.4]),
        ("concave arc", circle(false), [3.0, 2.0]),
        (
            "cubic",
            cubic([[30.0, 1.0], [32.0, 0.5], [31.0, 3.0], [35.0, 2.0]]),
            [1.0, 0.0],
        ),
        (
            "cubic of a flank",
            cubic([[50.0, 3.0], [51.0, 2.6], [52.2, 2.3], [53.0, 1.6]]),
            [1.0, 0.0],
        ),
        (
            "cubic of a root",
            cubic([[46.0, 4.0], [45.1, 4.1], [44.8, 4.9], [44.9, 5.6]]),
            [1.0, 0.0],
        ),
        (
            "cubic that turns by more than half a turn",
            cubic([[40.0, 0.0], [47.0, 3.0], [35.0, 3.5], [41.0, -1.0]]),
            [1.0, 0.0],
        ),
        (
            "S of a cubic",
            cubic([[40.0, 0.0], [41.0, 1.5], [42.0, -1.2], [43.0, 0.4]]),
            [1.0, 0.0],
        ),
    ] {
        let part = Part {
            curve,
            ends,
            corners: [true; 2],
        };
        parts.push((what.to_owned(), part));
    }
    for (which, fillet) in crate::gear::fillet::tests::cut().into_iter().enumerate() {
        let part = Part {
            ends: [fillet.end(), 0.0],
            curve: PartCurve::Trochoid(fillet),
            corners: [true; 2],
        };
        parts.push((format!("fillet {which}"), part));
    }
    for (what, built) in gears_with_profiles() {
        let flank = built.profile(Side::Right, 1);
        let flank = flank.part(ProfilePart::Involute);
        for (k, ends) in flank.stretches().enumerate() {
            let part = Part {
                ends: [ends.1, ends.0],
                ..flank.clone()
            };
            parts.push((format!("{what}, stretch {k}"), part));
        }
    }
    parts.retain(|(_, part)| part.ends[0] != part.ends[1]);
    parts
}

/// Every kind of profile deviation.
fn gears_with_profiles() -> Vec<(&'static str, AsBuilt)> {
    let with = |change: &dyn Fn(&mut Modification)| {
        let mut profile = Modification::default();
        change(&mut profile);
        profile
    };
    let relief = |from, parabolic| {
        Some(Relief {
            amount: 0.02,
            from,
            parabolic,
        })
    };
    let wave = |k: i32| (0.2 + 0.02 * f64::from(k), 0.004 * f64::from(k * k % 5));
    let trace = Trace {
        tooth: None,
        points: (0..20).map(wave).collect(),
    };
    let tip = |parabolic| with(&|profile| profile.tip_relief = relief(45.2, parabolic));
    let all = [
        ("slope", with(&|profile| profile.slope = 0.05)),
        ("crowning", with(&|profile| profile.crowning = 0.03)),
        ("straight relief", tip(false)),
        ("parabolic relief", tip(true)),
        (
            "root relief",
            with(&|profile| profile.root_relief = relief(43.2, false)),
        ),
        (
            "trace",
            with(&|profile| profile.traces = vec![trace.clone()]),
        ),
    ];
    let built = |(what, profile): (&'static str, Modification)| {
        let deviations = Deviations {
            profiles: [profile.clone(), profile],
            ..Deviations::default()
        };
        let design = GearDesign::plain(44, 2.0);
        (what, design.built(Face::Front, &deviations))
    };
    all.into_iter().map(built).collect()
}

/// The values of every curve agree with differences of its points: `dP/dt = i n · speed`.
#[test]
fn curves_are_as_they_say() {
    for (what, part) in parts() {
        let (curve, (low, high)) = (&part.curve, part.range());
        let size = curve.at(0.5 * (low + high)).0.coords.norm();
        let step = 1e-5;
        for k in 0..=10 {
            let t = low + step + (high - low - 2.0 * step) * f64::from(k) / 10.0;
            let (point, normal) = curve.at(t);
            assert!((point - curve.point(t)).norm() < 1e-13 * size, "{what} {t}");
            assert!((normal - curve.normal(t)).norm() < 1e-13, "{what} {t}");
            assert!((curve.radius(t) - point.coords.norm()).abs() < 1e-13 * size);
            let rise = (curve.point(t + step) - curve.point(t - step)) / (2.0 * step);
            let along = Vector2::new(-normal.y, normal.x) * curve.speed(t);
            let off = (rise - along).norm();
            assert!(off < 1e-6 * size, "{what} {t}: {rise} {along}");
        }
    }
}

/// Reach and turn from the middle of a stretch, bend and curvature hold at every place. For a short stretch of a cubic curve they are tight.
///
/// The bend bounds the distance of every point from its chord, and the curvature, if known, the turn of every normal. Source: points, and
/// differences of normals.
#[test]
fn bounds_of_a_stretch_hold_at_every_place() {
    let eighths = (0..8).map(|k| [0.125 * f64::from(k), 0.125 * f64::from(k + 1)]);
    let stretches = eighths.chain([[0.0, 1.0], [0.5, 0.52], [0.95, 0.96]]);
    let stretches: Vec<[f64; 2]> = stretches.collect();
    let turned = |one: Vector2<f64>, other: Vector2<f64>| one.perp(&other).atan2(one.dot(&other));
    for (what, part, stretch) in parts()
        .iter()
        .flat_map(|(what, part)| stretches.iter().map(move |at| (what, part, at)))
    {
        let (curve, (low, high)) = (&part.curve, part.range());
        let [from, to] = stretch.map(|share| low + (high - low) * share);
        let width = to - from;
        let places: Vec<f64> = (0..=50)
            .map(|k| from + width * f64::from(k) / 50.0)
            .collect();
        let points: Vec<Point2<f64>> = places.iter().map(|t| curve.point(*t)).collect();
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
        let case = format!("{what} {stretch:?}");

        let (reach, turn) = curve.spread(from, to);
        let (middle, normal) = curve.at(0.5 * (from + to));
        let far = most(&mut points.iter().map(|point| (point - middle).norm()));
        let turns = places
            .iter()
            .map(|t| turned(normal, curve.normal(*t)).abs());
        let bent = most(&mut turns.into_iter());
        assert!(far <= reach * (1.0 + 1e-12), "{case}: {far} {reach}");
        assert!(
            bent <= turn * (1.0 + 1e-12) + 1e-12,
            "{case}: {bent} {turn}"
        );

        let (a, b) = curve.bend(to);
        let bound = (a + b * width) * width * width / 8.0;
        let along = (points[50] - points[0]).normalize();
        let off = most(
            &mut points
                .iter()
                .map(|point| along.perp(&(point - points[0])).abs()),
        );
        let rounding = 1e-15 * curve.radius(to);
        assert!(
            off <= bound * (1.0 + 1e-9) + rounding,
            "{case}: {off} {bound}"
        );

        let convexity = curve.convexity(from, to);
        let is_short = what.contains("cubic") && stretch[1] - stretch[0] < 0.05;
        if is_short {
            assert!(reach < 1.02 * far && turn < 1.1 * bent, "{case}");
            assert!(convexity.is_some(), "{case}");
        }
        if let Some((least, most)) = convexity {
            let step = 1e-5 * width;
            let all = places[1..50].iter().map(|t| {
                let [before, after] = [t - step, t + step].map(|t| curve.normal(t));
                turned(before, after) / (2.0 * step * curve.speed(*t))
            });
            let (low, high) = all.fold((f64::MAX, f64::MIN), |(low, high), found| {
                (low.min(found), high.max(found))
            });
            let size = low.abs().max(high.abs());
            let rounding = 1e-6 * (1.0 + size);
            let is_within = low > least - rounding && high < most + rounding;
            assert!(is_within, "{case}: {low} {high} {least} {most}");
            let is_tight = low < least + 0.2 * size && high > most - 0.2 * size;
            assert!(!is_short || is_tight, "{case}: {low} {high} {least} {most}");
        }
        if let Some(curvature) = curve.curvature(from, to) {
            let length: f64 = points
                .windows(2)
                .map(|pair| (pair[1] - pair[0]).norm())
                .sum();
            let turned = turned(curve.normal(from), curve.normal(to)).abs();
            // The points' polygon is shorter than the curve by far less than a thousandth.
            assert!(turned <= curvature * length * 1.001 + 1e-15, "{case}");
        }
    }
}

/// The spread of a circle's stretch is half its arc, and half the angle it turns by. Source: length and curvature of an arc.
#[test]
fn a_circle_spreads_by_half_its_arc() {
    for (convex, bulges) in [(true, 0.25), (false, -0.25)] {
        let circle = Circle::new(Point2::new(30.0, 2.0), 4.0, convex);
        for (low, high) in [(0.3, 1.4), (-2.0, 0.7), (1.0, 1.0)] {
            let (reach, turn) = circle.spread(low, high);
            assert!((turn - 0.5 * (high - low)).abs() < 1e-15);
            assert!((reach - 2.0 * (high - low)).abs() < 1e-14);
            // The normal turns by 1 on a length of 4, along the way that has the metal on its left.
            assert_eq!(circle.convexity(low, high), Some((bulges, bulges)));
            assert_eq!(circle.curvature(low, high), Some(0.25));
        }
    }
}
