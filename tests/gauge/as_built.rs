//! Each reading against the deviations of the model, computed here from the input lists.

use super::*;
use gearlash::gear::Flank;

fn worst(found: impl IntoIterator<Item = f64>, expected: impl IntoIterator<Item = f64>) -> f64 {
    let (found, expected): (Vec<f64>, Vec<f64>) =
        (found.into_iter().collect(), expected.into_iter().collect());
    assert_eq!(found.len(), expected.len());
    let off = found.iter().zip(&expected).map(|(a, b)| (a - b).abs());
    off.fold(0.0, f64::max)
}

/// The two flanks that bound a span move by (F_right,last − F_left,first) cos α and by half the
/// thickness of their teeth, cos α times: a flank turned by δ/r moves δ cos α along its normal.
#[test]
fn spans_pitch_and_thickness() {
    for (teeth, face, e) in [
        (44, Face::Front, 0.0),
        (21, Face::Back, 0.031),
        (60, Face::Back, 0.0),
    ] {
        let made = made(teeth, face, e);
        let gear = made.gear.gear();
        let basic_data = gear.basic_data();
        let cos = basic_data.pressure_angle().cos();
        let found = measure(&made.gear, quick());
        let z = teeth as usize;

        let spans = found.spans.unwrap();
        let k = spans.teeth as usize;
        assert!(k > 2);
        let expected = (0..z).map(|i| {
            let last = (i + k - 1) % z;
            (k - 1) as f64 * basic_data.base_pitch()
                + gear.base_thickness()
                + cos * (made.right[last] - made.left[i])
                + cos * (made.per_tooth[i] + made.per_tooth[last]) / 2.0
        });
        let off = worst(spans.readings.iter().map(|s| s.length), expected);
        assert!(off < PICOMETRE, "{off}");

        // A flank's place: pitch deviation, and half the thickness outwards (ahead on own right flanks).
        let own = found.pitch_own.unwrap();
        for (side, curve, ahead) in [
            (Flank::Right, &made.right, 0.5),
            (Flank::Left, &made.left, -0.5),
        ] {
            let expected = (0..z).map(|i| curve[i] + ahead * made.per_tooth[i]);
            let off = worst(own.cumulative.flank(side).to_vec(), expected);
            assert!(off < PICOMETRE, "{off}");
            let single = (0..z).map(|i| {
                let before = (i + z - 1) % z;
                curve[i] - curve[before] + ahead * (made.per_tooth[i] - made.per_tooth[before])
            });
            let off = worst(own.single(side), single);
            assert!(off < PICOMETRE, "{off}");
        }

        let thickness = found.thickness.unwrap();
        let mean = gear.base_thickness() / cos
            - 2.0
                * basic_data.reference_radius()
                * (basic_data.pressure_angle().tan() - basic_data.pressure_angle());
        let expected = (0..z).map(|i| mean + made.per_tooth[i] + made.right[i] - made.left[i]);
        let off = worst(thickness.arcs, expected);
        assert!(off < PICOMETRE, "{off}");

        assert!((found.eccentricity.as_ref().unwrap().amount - e).abs() < 1e-11);
        if e > 0.0 {
            assert!((found.eccentricity.as_ref().unwrap().high_tooth - 5.25).abs() < 1e-9);
        }
    }
}

/// A machine on the datum axis reads own pitch and eccentricity together; taking the eccentricity out again,
/// by the code that reads such sheets, gives both back. The own pitch here has no first harmonic, as that asks.
#[test]
fn datum_axis_pitch_separates_again() {
    let teeth = 44;
    let design = design(teeth, 3.0, 20.0, 0.0);
    let wave = |phase: f64| -> Vec<f64> {
        let at = |i: u32| {
            0.006 * (4.0 * std::f64::consts::TAU * f64::from(i) / f64::from(teeth) + phase).sin()
        };
        (0..teeth).map(at).collect()
    };
    let deviations = Deviations {
        pitch: Some(Pitch::from_cumulative(&wave(0.0), &wave(1.0))),
        eccentricity: 0.04,
        high_tooth: 17.5,
        ..Deviations::default()
    };
    let part = AsBuilt::new(Gear::nominal(design).unwrap(), Face::Back, &deviations).unwrap();
    let found = measure(&part, quick());
    let datum = found.pitch_datum.unwrap();
    // To first order the sine of amplitude e/cos α is in F_p.
    assert!(datum.total(Flank::Right) > 2.0 * 0.04 / 20f64.to_radians().cos() * 0.9);
    let separated = datum.cumulative.separate_eccentricity(part.gear()).unwrap();
    assert!(
        (separated.eccentricity - 0.04).abs() < PICOMETRE,
        "{}",
        separated.eccentricity
    );
    assert!((separated.high_tooth - 17.5).abs() < 1e-6);
    let own = found.pitch_own.unwrap();
    for side in Flank::BOTH {
        let off = worst(
            separated.pitch.flank(side).to_vec(),
            own.cumulative.flank(side).to_vec(),
        );
        assert!(off < PICOMETRE, "{off}");
    }
}

/// F_r of a pure eccentricity. Ball i is at |r_K u_i + e| = r_K + e cos χ_i + e² sin² χ_i/(2 r_K) + …, with its angle
/// χ_i from the high tooth. With spaces at χ = 0 and π (high tooth 1.5, even z) the sine vanishes at both, and F_r = 2
/// e without a second order. With spaces at ±δ beside (odd z: δ = π/z at the low end) F_r = e (1 + cos δ) − e² sin²
/// δ/(2 r_K): the difference from the first order falls fourfold as e halves.
#[test]
fn runout_of_a_pure_eccentricity() {
    let runout = |teeth: u32, high_tooth: f64, eccentricity: f64| {
        let deviations = Deviations {
            eccentricity,
            high_tooth,
            ..Deviations::default()
        };
        let gear = Gear::nominal(design(teeth, 3.0, 20.0, 0.0)).unwrap();
        let part = AsBuilt::new(gear, Face::Front, &deviations).unwrap();
        let found = measure(&part, quick());
        let radius = found.pins.unwrap().seats[0].centre.coords.norm();
        (found.runout.unwrap().total(), radius)
    };
    for e in [0.005, 0.05, 0.5] {
        let (total, _) = runout(44, 1.5, e);
        assert!((total - 2.0 * e).abs() < PICOMETRE, "{e}: {total}");
    }
    let delta = std::f64::consts::PI / 21.0;
    let beyond = |e: f64| {
        let (total, radius) = runout(21, 1.5, e);
        (e * (1.0 + delta.cos()) - total, radius)
    };
    let (one, radius) = beyond(0.4);
    let second = 0.4f64.powi(2) * delta.sin().powi(2) / (2.0 * radius);
    assert!((one / second - 1.0).abs() < 0.02, "{one} {second}");
    let ratio = one / beyond(0.2).0;
    assert!((ratio - 4.0).abs() < 0.05, "{ratio}");
}
