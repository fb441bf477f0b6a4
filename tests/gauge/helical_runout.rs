//! Runout readings on helical teeth, by a ball and by a fork: those of the virtual gauge, closed forms, planes brought to surfaces in space.

use super::helical::helical;
use super::helical_in_space::{InSpace, TEETH};
use super::*;
use gearlash::gear::{Flank, Hand, Probe, RunoutReadings, thickness};
use nalgebra::{Point3, Vector3};
use std::f64::consts::TAU;

const ALPHA: f64 = std::f64::consts::PI / 9.0;

fn cases() -> [InSpace; 2] {
    [(Hand::Left, Face::Front), (Hand::Right, Face::Back)]
        .map(|(hand, face)| InSpace::new(hand, face))
}

/// The virtual gauge's readings of a gear with deviations of every kind give the eccentricity that was put in.
#[test]
fn readings_of_the_virtual_ball_give_the_eccentricity_back() {
    for space in cases() {
        let gear = &space.made.gear;
        for ball in [5.0, 5.5] {
            let settings = Settings {
                ball: Some(ball),
                ..quick()
            };
            let read = measure(gear, settings).runout.unwrap();
            let mm = read.readings.iter().map(|reading| reading.radius).collect();
            let probe = Probe::Ball(ball);
            let readings = RunoutReadings { probe, mm };
            let fit = readings.fit(gear.gear(), &space.deviations).unwrap();
            assert!((fit.eccentricity - 0.021).abs() < PICOMETRE);
            assert!((fit.high_tooth - 5.25).abs() < 1e-6, "{}", fit.high_tooth);
            assert!((fit.range - fit.known_range).abs() < PICOMETRE);
            for (read, said) in fit.rest {
                assert!((read - said).abs() < PICOMETRE, "{read} {said}");
            }
        }
    }
}

/// Closed form of a pure eccentricity: `√(r_K² + e² + 2 e r_K cos χ)`, with `inv α_K = inv α_t + D_M/(2 r_b cos β_b) − π/z + s_t/(2 r)` (ISO 21771)
/// by bisection.
#[test]
fn a_pure_eccentricity_is_read_in_closed_form() {
    let (beta, ball, e) = (24f64.to_radians(), 5.5, 0.03);
    let alpha_t = (ALPHA.tan() / beta.cos()).atan();
    let cos_b = (1.0 - (beta.sin() * ALPHA.cos()).powi(2)).sqrt();
    let design = helical(TEETH, 3.0, 24.0, Hand::Right, 0.2);
    let r = 1.5 * f64::from(TEETH) / beta.cos();
    let thick = 3.0 * (TAU / 4.0 + 0.4 * ALPHA.tan()) / beta.cos();
    let inv = alpha_t.tan() - alpha_t + ball / (2.0 * r * alpha_t.cos() * cos_b)
        - TAU / 2.0 / f64::from(TEETH)
        + thick / (2.0 * r);
    let (mut low, mut high) = (0.1f64, 1.0f64);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if middle.tan() - middle < inv {
            low = middle
        } else {
            high = middle
        }
    }
    let radius = r * alpha_t.cos() / low.cos();
    let deviations = Deviations {
        eccentricity: e,
        high_tooth: 9.5,
        ..Deviations::default()
    };
    let gear = Gear::nominal(design).unwrap();
    let part = AsBuilt::new(gear, Face::Front, &deviations).unwrap();
    let settings = Settings {
        ball: Some(ball),
        ..quick()
    };
    let found = measure(&part, settings).runout.unwrap();
    let expected: Vec<f64> = (1..=TEETH)
        .map(|tooth| {
            let chi = (f64::from(tooth) + 0.5 - 9.5) * TAU / f64::from(TEETH);
            (radius * radius + e * e + 2.0 * e * radius * chi.cos()).sqrt()
        })
        .collect();
    for (read, expected) in found.readings.iter().zip(&expected) {
        assert!((read.radius - expected).abs() < PICOMETRE);
    }
    let readings = RunoutReadings {
        probe: Probe::Ball(ball),
        mm: expected,
    };
    let fit = readings.fit(part.gear(), &Deviations::default()).unwrap();
    assert!((fit.eccentricity - e).abs() < 1e-11, "{}", fit.eccentricity);
    assert!((fit.high_tooth - 9.5).abs() < 1e-9);
}

/// A fork of two plane faces, each at `α_n` to its axis in the normal section and inclined at the helix angle. It
/// slides towards the axis of the gear, which turns until both faces touch: each face meets its helicoid in space.
#[test]
fn a_fork_rides_on_helical_teeth_as_its_closed_form_says() {
    for space in cases() {
        let gear = &space.made.gear;
        let alpha_t = (ALPHA.tan() / 24f64.to_radians().cos()).atan();
        let sin = 24f64.to_radians().sin() * ALPHA.cos();
        let cos = (1.0 - sin * sin).sqrt();
        // `sin α_n = sin α_t cos β_b`: the inclination in the normal section.
        assert!((alpha_t.sin() * cos - ALPHA.sin()).abs() < 1e-15);
        let ascending = match gear.face() {
            Face::Front => -1.0,
            Face::Back => 1.0,
        };
        let offset = gear.displacement(0.0);
        let offset = Vector3::new(offset.x, offset.y, 0.0);
        let apex = |tooth: u32, own: Flank, turn: f64| {
            let ahead = if own == Flank::Right { 1.0 } else { -1.0 };
            // The fork turns the other way about the gear.
            let middle = ascending * TAU * f64::from(tooth - 1) / f64::from(TEETH) - turn;
            let out = Vector3::new(middle.cos(), middle.sin(), 0.0);
            let along = ahead * ascending * Vector3::new(-middle.sin(), middle.cos(), 0.0);
            let lean = -(space.twist * ahead * ascending).signum() * sin;
            let normal = cos * (alpha_t.sin() * out + alpha_t.cos() * along) + lean * Vector3::z();
            let reach = |p: &Point3<f64>| -normal.dot(&(p.coords + offset));
            -space.least(own, tooth, reach) / (alpha_t.sin() * cos)
        };
        let read = |tooth: u32| {
            let gap = |turn: f64| {
                let [one, other] = Flank::BOTH.map(|own| apex(tooth, own, turn));
                (one - other, 0.5 * (one + other))
            };
            let (mut from, mut to) = (0.0, 1e-3);
            let (mut last, mut here) = (gap(from), gap(to));
            for _ in 0..2 {
                let next = to - here.0 * (to - from) / (here.0 - last.0);
                (from, last) = (to, here);
                (to, here) = (next, gap(next));
            }
            here.1
        };
        let mm = (1..=TEETH).map(read).collect();
        let probe = Probe::Fork;
        let readings = RunoutReadings { probe, mm };
        let fit = readings.fit(gear.gear(), &space.deviations).unwrap();
        assert!((fit.eccentricity - 0.021).abs() < 10.0 * PICOMETRE);
        assert!((fit.high_tooth - 5.25).abs() < 1e-5, "{}", fit.high_tooth);
    }
}

/// The ball that is to touch at a roll does so where it lies, off the plane of its centre.
#[test]
fn a_ball_touches_where_it_was_chosen_to() {
    for (hand, beta) in [(Hand::Left, 8.0), (Hand::Right, 30.0)] {
        let gear = Gear::nominal(helical(40, 3.0, beta, hand, 0.1)).unwrap();
        let data = *gear.basic_data();
        let roll = data.transverse_pressure_angle().tan();
        let ball = thickness::pin_touching(&data, roll, gear.base_thickness());
        let settings = Settings {
            ball: Some(ball),
            ..quick()
        };
        let part = AsBuilt::perfect(gear, Face::Front);
        let read = measure(&part, settings).runout.unwrap();
        for touch in read.readings[0].seat.touched {
            let off = touch.radius - data.reference_radius();
            // The place along the face is found to the root of the distance's error.
            assert!(off.abs() < 1e-4, "{off}");
        }
    }
}
