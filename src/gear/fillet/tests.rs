use super::*;
use crate::gear::Hand;
use std::f64::consts::TAU;

/// A gear of module 2: teeth, pressure angle and helix angle.
type Basic = (u32, f64, f64);

fn basic((teeth, alpha_deg, helix_deg): Basic) -> BasicGearData {
    let data = BasicGearData::new(teeth, 2.0, alpha_deg.to_radians()).unwrap();
    data.with_helix(helix_deg.to_radians(), Hand::Left).unwrap()
}

/// The fillet that a tool with this addendum, dedendum and round cuts at `x_e`.
fn fillet(
    gear: Basic,
    [addendum, dedendum, round]: [f64; 3],
    x_e: f64,
) -> Result<Fillet, GearError> {
    let rack = BasicRack::new(addendum, dedendum, round).unwrap();
    Fillet::new(&basic(gear), &rack, x_e)
}

/// Source: the greatest polar angle of 20 000 points of each fillet.
#[test]
fn the_neck_is_where_the_fillets_are_nearest() {
    let mut crossing = 0;
    let tools = [
        [1.0, 1.25, 0.38],
        [1.0, 1.0, 0.0],
        [1.0, 1.5, 0.25],
        [1.0, 0.9, 0.1],
    ];
    for (teeth, helix, x_e, tool) in [3, 4, 5, 7, 12, 17, 40]
        .into_iter()
        .flat_map(|teeth| [0.0, 20.0, 40.0].map(|helix| (teeth, helix)))
        .flat_map(|(teeth, helix)| [-0.6, -0.3, 0.0, 0.4, 0.9].map(|x_e| (teeth, helix, x_e)))
        .flat_map(|(teeth, helix, x_e)| tools.map(|tool| (teeth, helix, x_e, tool)))
    {
        let Ok(fillet) = fillet((teeth, 20.0, helix), tool, x_e) else {
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
        let over = fillet.neck() - greatest;
        assert!(
            (-1e-15..=1e-6).contains(&over),
            "z {teeth}, x {x_e}: {over}"
        );
        crossing += u32::from(fillet.neck() >= 0.0);
    }
    assert!(crossing > 0);
}

/// A trochoid that turns back towards the centre has a cusp and is refused. Source: the distances of 5000 of its points.
///
/// The least shift without a cusp, to the last bit, is the least shift at which `S` is nowhere negative. Source: `S` at 200 000 places of
/// that fillet.
#[test]
fn a_fillet_that_turns_back_is_refused() {
    let mut borders = 0;
    for (helix, round) in [0.3, 0.5, 0.6, 0.7]
        .into_iter()
        .flat_map(|round| [0.0, 8.0, 16.0].map(|helix| (helix, round)))
    {
        let at = |x_e: f64| fillet((3, 5.0, helix), [0.1, 0.8, round], x_e);
        let data = basic((3, 5.0, helix));
        // The tool's round reaches as far as this; undercut removes the rest.
        let end = FRAC_PI_2 - data.transverse_pressure_angle();
        let is_cusp = |x_e: f64| matches!(at(x_e), Err(GearError::FilletCusp { .. }));
        let mut last = None;
        for x_e in (0..40).map(|k| 0.75 - round + 0.005 * f64::from(k)) {
            let trochoid = Fillet {
                radius: data.reference_radius(),
                depth: (0.8 - round - x_e) * 2.0,
                tip_round: 2.0 * round,
                lean: data.helix_angle().tan().powi(2),
                root_angle: 0.0,
                end,
                form_roll: 0.0,
            };
            let distances = (0..=5000).map(|k| {
                let gamma = trochoid.end * f64::from(k) / 5e3;
                trochoid.point(gamma).coords.norm()
            });
            let distances: Vec<f64> = distances.collect();
            let turns_back = distances.windows(2).any(|pair| pair[1] < pair[0] - 1e-12);
            assert_eq!(is_cusp(x_e), turns_back, "ρ {round}, x {x_e}");
            last = turns_back.then_some(x_e).or(last);
        }
        let Some(low) = last else { continue };
        let border = bisect(low, low + 0.005, 0.0, is_cusp)[1];
        let fillet = at(border).unwrap();
        let speeds = (0..=200_000).map(|k| fillet.speed(end * f64::from(k) / 2e5));
        let least = speeds.fold(f64::INFINITY, f64::min);
        assert!((0.0..1e-6).contains(&least), "{helix} {round}: {least:e}");
        borders += 1;
    }
    assert!(borders > 5, "{borders}");
}

/// Fillets as a tool cuts them, spur gears first: ordinary, undercut, centre of the round outside the pitch line, steep, few teeth
/// with convex fillets, large gears, a sharp tool.
pub(in crate::gear) fn cut() -> [Fillet; 13] {
    [
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
    ]
    .map(|(teeth, helix, x_e, dedendum, round)| {
        fillet((teeth, 20.0, helix), [1.0, dedendum, round], x_e).unwrap()
    })
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

/// Bounds of a tiny stretch are speed and turn there. (Those of longer ones: `gear::part`.) Source: differences of points and
/// normals, which `tests/models/rack_positions.rs` compares with the tool.
#[test]
fn bounds_of_a_tiny_stretch_are_tight() {
    for (which, fillet) in cut().into_iter().enumerate() {
        for gamma in (0..=240).map(|k| fillet.end * f64::from(k) / 240.0) {
            let (s, q) = differences(&fillet, gamma);
            let room = 2e-7 * (1.0 + fillet.radius.abs() + s.abs() + q.abs());
            let low = gamma.min(fillet.end - 1e-9);
            let high = low + 1e-9;
            let over = fillet.between(low, high);
            for ([least, most], v) in [(over.speed(), s), (over.turn(), q)] {
                let is_tight = (least - v).abs() < room && (most - v).abs() < room;
                assert!(least <= most && is_tight, "{which} {gamma}");
            }
            // A spur gear's spread uses |h_0|.
            let exact = fillet.is_elliptic() || fillet.depth >= 0.0;
            let (d, w) = fillet.spread(low, high);
            let half = 0.5 * (high - low);
            let off = [d / half - s, w / half - q.abs()];
            let is_tight = off.iter().all(|off| off.abs() < room);
            assert!(!exact || is_tight, "{which}");
            match fillet.convexity(low, high) {
                Some((least, most)) => {
                    assert!(least <= most && q > -room && s > -room);
                    let hollow = -q / s;
                    let room = 2.0 * room * (1.0 + hollow.abs()) / s;
                    assert!((least - hollow).abs() < room && (most - hollow).abs() < room);
                }
                None => assert!(!exact || q < room || s < room, "{which} {gamma}: {q} {s}"),
            }
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
            let hollow = fillet.greatest_hollow(start);
            if least_turn < 0.0 {
                assert_eq!(hollow, f64::INFINITY, "{which} {from}");
                bulging += 1;
            } else if least_turn > 0.2 {
                let most = flattest * (1.0 + 1.0 / 16.0) + 1e-6;
                let is_near = hollow > flattest - 1e-6 && hollow < most;
                assert!(is_near, "{which} {from}: {hollow} {flattest}");
            }
            let over = fillet.steepest(start) - steepest;
            assert!(over > -1e-9 && over < 0.06, "{which} {from}: {over}");
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
        let straight = Fillet {
            lean: 0.0,
            ..fillet
        };
        for fillet in [fillet, turned, straight] {
            for gamma in (0..=10).map(|k| fillet.end() * f64::from(k) / 10.0) {
                let pitch = fillet.point(gamma) + fillet.normal(gamma) * fillet.reach(gamma);
                let size = fillet.radius;
                assert!((pitch.coords.norm() - size).abs() < 1e-13 * size);
                let angle = pitch.y.atan2(pitch.x) - fillet.pitch_angle(gamma);
                let angle = angle - TAU * (angle / TAU).round();
                assert!(angle.abs() < 1e-13, "{angle}");
            }
        }
    }
}
