use super::*;
use crate::gear::Hand;
use std::f64::consts::TAU;

fn basic(teeth: u32, alpha: f64, helix_deg: f64) -> BasicGearData {
    let data = BasicGearData::new(teeth, 2.0, alpha).unwrap();
    data.with_helix(helix_deg.to_radians(), Hand::Left).unwrap()
}

/// Source: the greatest polar angle of 20 000 points of each fillet.
#[test]
fn the_neck_is_where_the_fillets_are_nearest() {
    let mut crossing = 0;
    for (teeth, helix) in [3, 4, 5, 7, 12, 17, 40]
        .into_iter()
        .flat_map(|teeth| [0.0, 20.0, 40.0].map(|helix| (teeth, helix)))
    {
        for x_e in [-0.6, -0.3, 0.0, 0.4, 0.9] {
            for (dedendum, round) in [(1.25, 0.38), (1.0, 0.0), (1.5, 0.25), (0.9, 0.1)] {
                let basic_data = basic(teeth, 20f64.to_radians(), helix);
                let rack = BasicRack::new(1.0, dedendum, round).unwrap();
                let Ok(fillet) = Fillet::new(&basic_data, &rack, x_e) else {
                    continue;
                };
                // No gear: the root would lie beyond the centre.
                if fillet.radius <= fillet.depth + fillet.tip_round {
                    continue;
                }
                let angles = (0..=20_000).map(|k| {
                    let point = fillet.point(fillet.end * f64::from(k) / 2e4);
                    point.y.atan2(point.x)
                });
                let greatest = angles.fold(f64::NEG_INFINITY, f64::max);
                let neck = fillet.neck();
                assert!(
                    neck >= greatest - 1e-15 && neck <= greatest + 1e-6,
                    "z {teeth}, x {x_e}: {neck} for {greatest}"
                );
                crossing += u32::from(neck >= 0.0);
            }
        }
    }
    assert!(crossing > 0);
}

/// A trochoid that turns back towards the centre has a cusp and is refused. Source: the distances of 5000 of its points.
#[test]
fn a_fillet_that_turns_back_is_refused() {
    let mut refused = [0; 3];
    for (which, round) in [0.3, 0.5, 0.6, 0.7]
        .into_iter()
        .flat_map(|round| [0, 1, 2].map(|which| (which, round)))
    {
        let basic_data = basic(3, 5f64.to_radians(), [0.0, 8.0, 16.0][which]);
        let rack = BasicRack::new(0.1, 0.8, round).unwrap();
        for k in 0..40 {
            let x_e = 0.8 - round - 0.05 + 0.005 * f64::from(k);
            let trochoid = Fillet {
                radius: basic_data.reference_radius(),
                depth: (0.8 - round - x_e) * 2.0,
                tip_round: 2.0 * round,
                lean: basic_data.helix_angle().tan().powi(2),
                root_angle: 0.0,
                end: FRAC_PI_2 - basic_data.transverse_pressure_angle(),
                form_roll: 0.0,
            };
            let distances = (0..=5000).map(|k| {
                let gamma = trochoid.end * f64::from(k) / 5e3;
                trochoid.point(gamma).coords.norm()
            });
            let distances: Vec<f64> = distances.collect();
            let turns_back = distances.windows(2).any(|pair| pair[1] < pair[0] - 1e-12);
            let found = Fillet::new(&basic_data, &rack, x_e);
            let is_cusp = matches!(found, Err(GearError::FilletCusp { .. }));
            assert_eq!(is_cusp, turns_back, "ρ {round}, x {x_e}");
            refused[which] += u32::from(is_cusp);
        }
    }
    assert!(refused.iter().all(|count| *count > 5), "{refused:?}");
}

/// The least shift without a cusp, to the last bit, is the least shift at which `S` is nowhere negative. Source: `S` at 200 000
/// places of that fillet.
#[test]
fn the_border_of_turning_back_is_where_the_speed_is_next_to_none() {
    for helix in [0.0, 8.0] {
        let basic_data = basic(3, 5f64.to_radians(), helix);
        let rack = BasicRack::new(0.1, 0.8, 0.6).unwrap();
        let at = |x_e: f64| Fillet::new(&basic_data, &rack, x_e);
        // Refused at one end, and not at the other.
        let places = (0..40).map(|k| 0.15 + 0.005 * f64::from(k));
        let refused = places.into_iter().filter(|x_e| at(*x_e).is_err());
        let low = refused.fold(f64::NEG_INFINITY, f64::max);
        let border = bisect(low, low + 0.005, 0.0, |x_e| at(x_e).is_err())[1];
        let fillet = at(border).unwrap();
        // The tool's round reaches as far as this; undercut removes the rest.
        let end = FRAC_PI_2 - basic_data.transverse_pressure_angle();
        let speeds = (0..=200_000).map(|k| fillet.speed(end * f64::from(k) / 2e5));
        let least = speeds.fold(f64::INFINITY, f64::min);
        assert!((0.0..1e-6).contains(&least), "{helix}: {least:e}");
    }
}

/// Fillets as a tool cuts them, spur gears first: ordinary, undercut, centre of the round outside the pitch line, steep, few teeth
/// with convex fillets, large gears, a sharp tool.
fn cut() -> Vec<Fillet> {
    let mut fillets = Vec::new();
    for (teeth, helix, x_e, dedendum, round) in [
        (27, 0.0, 0.1, 1.25, 0.38),
        (9, 0.0, 0.0, 1.25, 0.3),
        (200, 0.0, 1.2, 1.25, 0.38),
        (4, 0.0, 1.1, 1.25, 0.4),
        (27, 10.0, 0.0, 1.25, 0.38),
        (9, 25.0, -0.1, 1.25, 0.38),
        (200, 33.0, 1.2, 1.25, 0.38),
        (4000, 6.0, 0.87, 1.25, 0.38),
        (4000, 45.0, 0.87, 1.25, 0.38),
        (40, 45.0, 0.3, 1.25, 0.3),
        (3, 12.0, 1.2, 1.25, 0.3),
        (4, 20.0, 1.1, 1.25, 0.4),
        (12, 20.0, 0.4, 1.0, 0.0),
    ] {
        let basic_data = basic(teeth, 20f64.to_radians(), helix);
        let rack = BasicRack::new(1.0, dedendum, round).unwrap();
        fillets.push(Fillet::new(&basic_data, &rack, x_e).unwrap());
    }
    fillets
}

/// `S` and `q` by differences of points and normals, also beyond the fillet's ends.
fn differences(fillet: &Fillet, gamma: f64) -> (f64, f64) {
    const STEP: f64 = 1e-5;
    let [before, after] = [gamma - STEP, gamma + STEP];
    let normal = fillet.normal(gamma);
    let way = fillet.point(after) - fillet.point(before);
    let [one, other] = [before, after].map(|gamma| fillet.normal(gamma));
    let along = Vector2::new(-normal.y, normal.x).dot(&way);
    let turned = -one.perp(&other).atan2(one.dot(&other));
    (along / (2.0 * STEP), turned / (2.0 * STEP))
}

/// Bounds of a stretch enclose speed and turn at its points; for a narrow stretch they are tight. Source: differences of points and
/// normals, which `tests/models/rack_positions.rs` compares with the tool.
#[test]
fn speed_and_turn_of_a_stretch_are_enclosed() {
    for (which, fillet) in cut().into_iter().enumerate() {
        let at = |k: u32, n: u32| fillet.end * f64::from(k) / f64::from(n);
        for k in 0..12 {
            let (low, high) = (at(k, 12), at(k + 1, 12));
            let over = fillet.over(low, high);
            let (speed, turn) = (over.speed(), over.turn());
            let spread = fillet.spread(low, high);
            for i in 0..=20 {
                let gamma = low + (high - low) * f64::from(i) / 20.0;
                let (s, q) = differences(&fillet, gamma);
                let room = 1e-7 * (1.0 + fillet.radius.abs() + s.abs() + q.abs());
                let within = |[least, most]: [f64; 2], v: f64| v > least - room && v < most + room;
                assert!(within(speed, s), "{which} {gamma}: {s} {speed:?}");
                assert!(within(turn, q), "{which} {gamma}: {q} {turn:?}");
                assert!((fillet.speed(gamma) - s).abs() < room, "{which} {gamma}");
                assert!(spread.0 + room > s.abs() * 0.5 * (high - low));
                assert!(spread.1 + room > q.abs() * 0.5 * (high - low));
                // Over a tiny stretch the bounds agree.
                let near = (
                    gamma.min(fillet.end - 1e-9),
                    gamma.min(fillet.end - 1e-9) + 1e-9,
                );
                let over = fillet.over(near.0, near.1);
                for ([least, most], v) in [(over.speed(), s), (over.turn(), q)] {
                    assert!(
                        least <= most && (least - v).abs() < 2.0 * room,
                        "{which} {gamma}"
                    );
                    assert!((most - v).abs() < 2.0 * room, "{which} {gamma}");
                }
                let (d, w) = fillet.spread(near.0, near.1);
                let half = 0.5 * (near.1 - near.0);
                // A spur gear's spread uses |h_0|.
                let exact = fillet.is_elliptic() || fillet.depth >= 0.0;
                let off = [d / half - s, w / half - q.abs()];
                assert!(
                    !exact || off.iter().all(|off| off.abs() < 2.0 * room),
                    "{which}"
                );
                match fillet.convexity(near.0, near.1) {
                    Some((least, most)) => {
                        assert!(least <= most && q > -room && s > -room);
                        let hollow = -q / s;
                        let room = 4.0 * room * (1.0 + hollow.abs()) / s;
                        assert!((least - hollow).abs() < room && (most - hollow).abs() < room);
                    }
                    None => assert!(!exact || q < room || s < room, "{which} {gamma}: {q} {s}"),
                }
            }
        }
    }
}

/// The bend at `γ` bounds the second derivative across and along the tangent from 0 to `γ`. A tiny helix angle gives the bend
/// of the circle. Source: differences.
#[test]
fn the_bend_of_a_fillet_is_enough() {
    for (which, fillet) in cut().into_iter().enumerate() {
        let at = |k: u32| fillet.end * f64::from(k) / 40.0;
        let (mut across, mut along) = (0f64, 0f64);
        for k in 0..=40 {
            let (s, q) = differences(&fillet, at(k));
            let [before, after] = [-1e-4, 1e-4].map(|off| fillet.speed(at(k) + off));
            across = across.max(s * q.abs());
            along = along.max((after - before).abs() / 2e-4 * q.abs());
            let (a, b) = fillet.bend(at(k));
            let room = 1e-6 * (1.0 + fillet.radius);
            assert!(a > across - room, "{which} {k}: {a} {across}");
            assert!(b > along - room * (1.0 + along), "{which} {k}: {b} {along}");
            let [spur, nearly] = [0.0, 1e-13].map(|lean| Fillet { lean, ..fillet }.bend(at(k)));
            assert!((spur.0 - nearly.0).abs() < 1e-9 * spur.0, "{which} {k}");
            assert!(
                (spur.1 - nearly.1).abs() < 1e-9 * (1.0 + spur.1),
                "{which} {k}"
            );
        }
    }
}

/// The greatest radius of curvature and the greatest angle to the radius are at most a 16th above the values at 2000 points. The
/// radius is ∞ where a fillet is convex.
#[test]
fn the_greatest_of_a_fillet_are_those_of_its_points() {
    let mut bulging = 0;
    for (which, fillet) in cut().into_iter().enumerate() {
        for from in [0.0, 0.3, 0.8] {
            let start = from * fillet.end;
            let all = (0..=2000).map(|k| start + (fillet.end - start) * f64::from(k) / 2e3);
            let (mut flattest, mut least_turn, mut steepest) = (0f64, f64::INFINITY, 0f64);
            for gamma in all {
                let (s, q) = differences(&fillet, gamma);
                (flattest, least_turn) = (flattest.max(s / q), least_turn.min(q));
                let (point, normal) = (fillet.point(gamma), fillet.normal(gamma));
                let across = normal.dot(&point.coords).abs();
                steepest = steepest.max(across.atan2(normal.perp(&point.coords).abs()));
            }
            let (hollow, steep) = (fillet.greatest_hollow(start), fillet.steepest(start));
            if least_turn < 0.0 {
                assert_eq!(hollow, f64::INFINITY, "{which} {from}");
                bulging += 1;
            } else if least_turn > 0.2 {
                let most = flattest * (1.0 + 1.0 / 16.0) + 1e-6;
                assert!(
                    hollow > flattest - 1e-6 && hollow < most,
                    "{which} {from}: {hollow} {flattest}"
                );
            }
            assert!(
                steep > steepest - 1e-9 && steep < steepest + 0.06,
                "{which} {from}: {steep} {steepest}"
            );
        }
    }
    assert!(bulging > 0);
}

/// The pitch point lies at the distance `L` along the normal from the point. Source: point and normal.
#[test]
fn the_normal_passes_through_the_pitch_point() {
    for fillet in cut() {
        let turned = fillet.turned(0.3);
        let way = UnitComplex::new(0.3) * fillet.point(0.2) - turned.point(0.2);
        assert!(way.norm() < 1e-13 * fillet.radius);
        for fillet in [
            fillet,
            turned,
            Fillet {
                lean: 0.0,
                ..fillet
            },
        ] {
            for k in 0..=10 {
                let gamma = fillet.end() * f64::from(k) / 10.0;
                let pitch = fillet.point(gamma) + fillet.normal(gamma) * fillet.reach(gamma);
                let size = fillet.radius;
                assert!((pitch.coords.norm() - size).abs() < 1e-13 * size);
                let angle = pitch.y.atan2(pitch.x) - fillet.pitch_angle(gamma);
                assert!(
                    (angle - TAU * (angle / TAU).round()).abs() < 1e-13,
                    "{angle}"
                );
            }
        }
    }
}
