use super::*;
use crate::gear::{AsBuilt, Deviations, Face, Gear, GearDesign, Hand, Modification, Relief, Trace};

/// Undercut, ordinary and with `h_0 < 0`.
fn gears(helix_deg: f64) -> [(String, Gear); 3] {
    let gears = [(9, -0.1), (44, 0.0), (200, 1.2)].map(|(teeth, shift)| {
        let plain = GearDesign::plain(teeth, 2.0);
        let design = GearDesign {
            profile_shift: shift,
            basic_data: plain
                .basic_data
                .with_helix(helix_deg.to_radians(), Hand::Right)
                .unwrap(),
            ..plain
        };
        (
            format!("{teeth} at {helix_deg}°"),
            Gear::nominal(design).unwrap(),
        )
    });
    assert!(gears.each_ref().map(|(_, gear)| gear.is_undercut()) == [true, false, false]);
    gears
}

/// All kinds of curves, those of helical gears and a straight flank included.
fn parts() -> Vec<(String, Part)> {
    let gears = [0.0, 15.0, 33.0].map(gears);
    let straight = gears[0][1].1.with_straight_flanks(0.02, 0.05).unwrap();
    let straight = ("straight".to_owned(), straight);
    let all = gears.into_iter().flatten().chain([straight]);
    let parts = all.flat_map(|(which, gear)| {
        ProfilePart::ALL.map(|part| (format!("{which} {}", part.name()), gear.part(part).clone()))
    });
    let modified = gears_with_profiles().into_iter().flat_map(|(what, built)| {
        let flank = built.profile(crate::gear::Side::Right, 1);
        let flank = flank.part(ProfilePart::Involute).clone();
        let stretch = |(k, ends): (usize, (f64, f64))| {
            let part = Part {
                ends: [ends.1, ends.0],
                ..flank.clone()
            };
            (format!("{what}, stretch {k}"), part)
        };
        flank
            .stretches()
            .enumerate()
            .map(stretch)
            .collect::<Vec<_>>()
    });
    let part = |what: &str, curve, ends| {
        (
            what.to_owned(),
            Part {
                curve,
                ends,
                corners: [true; 2],
            },
        )
    };
    let bent = [[30.0, 1.0], [32.0, 0.5], [31.0, 3.0], [35.0, 2.0]];
    let bent = bent.map(|[x, y]| Point2::new(x, y));
    let drawn = [
        part(
            "convex arc",
            PartCurve::Circle(Circle::new(Point2::new(30.0, 2.0), 4.0, true)),
            [0.3, 1.4],
        ),
        part(
            "concave arc",
            PartCurve::Circle(Circle::new(Point2::new(30.0, 2.0), 4.0, false)),
            [3.0, 2.0],
        ),
        part("cubic", PartCurve::Cubic(Cubic::new(bent)), [1.0, 0.0]),
        part(
            "end of a cubic",
            PartCurve::Cubic(Cubic::new(bent)),
            [1.0, 0.8],
        ),
    ];
    let parts = parts.chain(drawn).chain(modified);
    parts
        .filter(|(_, part)| part.ends[0] != part.ends[1])
        .collect()
}

/// Every kind of profile deviation.
fn gears_with_profiles() -> Vec<(&'static str, AsBuilt)> {
    let relief = |from, parabolic| {
        Some(Relief {
            amount: 0.02,
            from,
            parabolic,
        })
    };
    let wave = |k: i32| (0.2 + 0.02 * f64::from(k), 0.004 * f64::from(k * k % 5));
    let none = Modification::default;
    let all = [
        (
            "slope",
            Modification {
                slope: 0.05,
                ..none()
            },
        ),
        (
            "crowning",
            Modification {
                crowning: 0.03,
                ..none()
            },
        ),
        (
            "straight relief",
            Modification {
                tip_relief: relief(45.2, false),
                ..none()
            },
        ),
        (
            "parabolic relief",
            Modification {
                tip_relief: relief(45.2, true),
                ..none()
            },
        ),
        (
            "root relief",
            Modification {
                root_relief: relief(43.2, false),
                ..none()
            },
        ),
        (
            "trace",
            Modification {
                traces: vec![Trace {
                    tooth: None,
                    points: (0..20).map(wave).collect(),
                }],
                ..none()
            },
        ),
    ];
    let built = |(what, profile): (&'static str, Modification)| {
        let deviations = Deviations {
            profiles: [profile.clone(), profile],
            ..Deviations::default()
        };
        let gear = Gear::nominal(GearDesign::plain(44, 2.0)).unwrap();
        (what, AsBuilt::new(gear, Face::Front, &deviations).unwrap())
    };
    all.into_iter().map(built).collect()
}

/// The values of every curve agree with differences of its points.
#[test]
fn curves_are_as_they_say() {
    for (what, part) in parts() {
        let (curve, (low, high)) = (&part.curve, part.range());
        let (reach, turn) = curve.spread(low, high);
        let middle = curve.at(0.5 * (low + high));
        let size = middle.0.coords.norm();
        let step = 1e-5;
        for k in 0..=10 {
            let t = low + step + (high - low - 2.0 * step) * f64::from(k) / 10.0;
            let (point, normal) = curve.at(t);
            assert!((point - curve.point(t)).norm() < 1e-13 * size, "{what} {t}");
            assert!((normal - curve.normal(t)).norm() < 1e-13, "{what} {t}");
            assert!((curve.radius(t) - point.coords.norm()).abs() < 1e-13 * size);
            // dP/dt = i n · speed.
            let rise = (curve.point(t + step) - curve.point(t - step)) / (2.0 * step);
            let along = Vector2::new(-normal.y, normal.x) * curve.speed(t);
            assert!(
                (rise - along).norm() < 1e-6 * size,
                "{what} {t}: {rise} {along}"
            );
            assert!(
                (point - middle.0).norm() <= reach * (1.0 + 1e-12),
                "{what} {t}"
            );
            let turned = middle.1.perp(&normal).atan2(middle.1.dot(&normal)).abs();
            assert!(turned <= turn * (1.0 + 1e-12) + 1e-15, "{what} {t}");
        }
    }
}

/// The bend bounds the distance of every point from its chord, and the curvature, if known, bounds the turn of every normal.
#[test]
fn bend_and_curvature_bound_the_curve() {
    for (what, part) in parts() {
        let (curve, (low, high)) = (&part.curve, part.range());
        for k in 0..8 {
            let (from, to) = (0.125 * f64::from(k), 0.125 * f64::from(k + 1));
            let [from, to] = [from, to].map(|place| low + (high - low) * place);
            let (a, b) = curve.bend(to);
            let bound = (a + b * (to - from)) * (to - from) * (to - from) / 8.0;
            let ends = [from, to].map(|t| curve.point(t));
            let along = (ends[1] - ends[0]).normalize();
            let points: Vec<Point2<f64>> = (0..=50)
                .map(|i| curve.point(from + (to - from) * f64::from(i) / 50.0))
                .collect();
            let off = points
                .iter()
                .map(|point| along.perp(&(point - ends[0])).abs());
            let off = off.fold(0.0, f64::max);
            assert!(
                off <= bound * (1.0 + 1e-9) + 1e-15 * curve.radius(to),
                "{what}: {off} {bound}"
            );
            if let Some((least, most)) = curve.convexity(from, to) {
                for i in 0..50 {
                    let t = from + (to - from) * (f64::from(i) + 0.5) / 50.0;
                    let step = 1e-4 * (to - from);
                    let [before, after] = [t - step, t + step].map(|t| curve.normal(t));
                    let turned = before.perp(&after).atan2(before.dot(&after));
                    let found = turned / (2.0 * step * curve.speed(t));
                    let rounding = 1e-6 * (1.0 + found.abs());
                    assert!(
                        found > least - rounding && found < most + rounding,
                        "{what}"
                    );
                }
            }
            if let Some(curvature) = curve.curvature(from, to) {
                let length: f64 = points
                    .windows(2)
                    .map(|pair| (pair[1] - pair[0]).norm())
                    .sum();
                let [start, end] = [from, to].map(|t| curve.normal(t));
                let turned = start.perp(&end).atan2(start.dot(&end)).abs();
                // The points' polygon is shorter than the curve by far less than a thousandth.
                assert!(turned <= curvature * length * 1.001 + 1e-15, "{what}");
            }
        }
    }
}

/// The spread of a circle's stretch is half its arc, and half the angle it turns by. Source: length and curvature of an arc.
#[test]
fn a_circle_spreads_by_half_its_arc() {
    for convex in [true, false] {
        let circle = Circle::new(Point2::new(30.0, 2.0), 4.0, convex);
        for (low, high) in [(0.3, 1.4), (-2.0, 0.7), (1.0, 1.0)] {
            let (reach, turn) = circle.spread(low, high);
            assert!((turn - 0.5 * (high - low)).abs() < 1e-15);
            assert!((reach - 2.0 * (high - low)).abs() < 1e-14);
            // The normal turns by 1 on a length of 4, along the way that has the metal on its left.
            let bulges = if convex { 0.25 } else { -0.25 };
            assert_eq!(circle.convexity(low, high), Some((bulges, bulges)));
            assert_eq!(circle.curvature(low, high), Some(0.25));
        }
    }
}
