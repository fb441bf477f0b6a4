//! A perfect gear reads what the formulas say.

use super::*;
use gearlash::gauge::{Unmeasured, usual_pin, usual_span};
use gearlash::gear::{Curve, thickness};
use std::f64::consts::PI;

fn perfect(blank: Blank, thinner: f64) -> AsBuilt {
    let gear = Gear::new(blank, blank.nominal_base_thickness() - thinner).unwrap();
    AsBuilt::perfect(gear, Face::Front)
}

/// W_k = (k − 1) p_b + s_b, 2 r_K + D_M or 2 r_K cos(π/2z) + D_M (ISO 21771), r_K (1 + cos(π/z)) + D_M over
/// three pins (the two stand π/z beside the opposite direction), F_r = 0, s = r (s_b/r_b − 2 inv α).
#[test]
fn reads_the_formulas() {
    let gears = [
        (blank(44, 3.0, 20.0, 0.0), 0.0),
        (blank(21, 3.0, 20.0, 0.0), 0.02),
        (blank(86, 3.0, 20.0, 0.0), 0.0167),
        (blank(17, 1.0, 20.0, 0.4), 0.01),
        (blank(9, 2.0, 20.0, 0.3), 0.0),
        (blank(33, 0.2, 14.5, 0.0), 0.0),
        (blank(60, 12.0, 22.5, -0.2), 0.1),
        (blank(201, 5.0, 20.0, 0.0), 0.05),
    ];
    for (blank, thinner) in gears {
        let part = perfect(blank, thinner);
        let (gear, toothing) = (part.gear(), &blank.toothing);
        let teeth = toothing.teeth();
        let name = format!("z {teeth}");
        let s_b = gear.base_thickness();
        let found = measure(&part, quick());
        // The greatest gear has a radius of half a metre: 1e-9 mm is 2e-12 of it.
        let near = |read: f64, formula: f64| (read - formula).abs() < PICOMETRE;

        let spans = found.spans.unwrap();
        assert_eq!(spans.teeth, usual_span(gear));
        assert_eq!(spans.readings.len(), teeth as usize);
        let formula = thickness::span_from_base(toothing, spans.teeth, s_b);
        for span in &spans.readings {
            assert!(
                near(span.length, formula),
                "{name}: {} {formula}",
                span.length
            );
            assert!(
                (span.length - formula).abs() <= span.error,
                "{name}: {}",
                span.error
            );
            assert!(
                span.touched
                    .iter()
                    .all(|touch| touch.curve == Curve::Involute)
            );
            // The middle of the plateau: both contacts on one circle.
            assert!(
                (span.touched[0].radius - span.touched[1].radius).abs() < 1e-3 * toothing.module()
            );
        }

        let pins = found.pins.unwrap();
        assert_eq!(pins.diameter, usual_pin(gear));
        assert!(thickness::check_pins(gear, pins.diameter).is_ok(), "{name}");
        let formula = thickness::pins_from_base(toothing, pins.diameter, s_b);
        for over in &pins.two {
            assert!(
                near(over.length, formula),
                "{name}: {} {formula}",
                over.length
            );
            assert!(
                (over.length - formula).abs() <= over.error,
                "{name}: {}",
                over.error
            );
        }
        let centre = thickness::pin_centre_radius(toothing, pins.diameter, s_b);
        let formula = centre * (1.0 + (PI / f64::from(teeth)).cos()) + pins.diameter;
        assert_eq!(
            pins.three.len(),
            if teeth % 2 == 1 { teeth as usize } else { 0 }
        );
        for over in &pins.three {
            assert!(
                near(over.length, formula),
                "{name}: {} {formula}",
                over.length
            );
            assert!(
                (over.length - formula).abs() <= over.error,
                "{name}: {}",
                over.error
            );
        }

        let runout = found.runout.unwrap();
        assert!(runout.total() <= runout.error().min(PICOMETRE), "{name}");
        assert!(near(runout.mean(), centre));
        assert_eq!(found.eccentricity.amount, 0.0);

        let allowance =
            thickness::allowance_from_base(toothing, blank.nominal_base_thickness(), s_b);
        let alpha = toothing.pressure_angle();
        let nominal = toothing.module() * (PI / 2.0 + 2.0 * blank.profile_shift * alpha.tan());
        match found.thickness {
            Ok(read) => {
                for arc in read.arcs {
                    assert!(near(arc, nominal + allowance), "{name}: {arc}");
                }
            }
            Err(reason) => panic!("{name}: {reason}"),
        }
        for pitch in [found.pitch_own.unwrap(), found.pitch_datum.unwrap()] {
            for side in gearlash::gear::Side::BOTH {
                assert!(pitch.total(side) < PICOMETRE && pitch.greatest_single(side) < PICOMETRE);
            }
        }
    }
}

/// Table 1 of the study (AGMA Gear Rating Suite, KISSsoft): M_dK 265.530 and 70.171 mm over pins of 5.25 mm at z 86 and 21;
/// allowances −17.830833 and −22.195630 µm at the reference circle make the thickness.
#[test]
fn reads_table_1_over_pins() {
    for (teeth, allowance, published) in [(86, -17.830833e-3, 265.530), (21, -22.195630e-3, 70.171)]
    {
        let blank = blank(teeth, 3.0, 20.0, 0.0);
        let nominal = blank.nominal_base_thickness();
        let s_b = thickness::base_from_allowance(&blank.toothing, nominal, allowance);
        let part = AsBuilt::perfect(Gear::new(blank, s_b).unwrap(), Face::Front);
        let settings = Settings {
            pin: Some(5.25),
            ..quick()
        };
        let pins = measure(&part, settings).pins.unwrap();
        for over in pins.two {
            // The allowances are printed to 1e-6 µm, and M_dK changes 2 to 3 times as much.
            assert!((over.length - published).abs() < 3e-9, "{}", over.length);
        }
    }
}

/// Off the involute the gauge says what it touched: the tip corner, the root, the end of the involute.
#[test]
fn names_what_it_touches_off_the_involute() {
    let part = perfect(blank(44, 3.0, 20.0, 0.0), 0.0);
    let gear = part.gear();
    let curves = |settings: Settings| {
        let found = measure(&part, settings);
        let ball = found
            .runout
            .map(|runout| runout.readings[0].seat.touched[0].curve);
        let span = found
            .spans
            .map(|spans| (spans.readings[0].touched[0].curve, spans.readings[0].length));
        (ball, span)
    };
    let ball = |ball| {
        curves(Settings {
            ball: Some(ball),
            ..quick()
        })
        .0
    };
    assert_eq!(ball(1.0), Ok(Curve::Root));
    assert_eq!(ball(5.25), Ok(Curve::Involute));
    assert_eq!(ball(12.0), Ok(Curve::Tip));
    // On two tip corners: r_K = r_a cos β + √(R² − r_a² sin² β), β half the angle between them.
    let found = measure(
        &part,
        Settings {
            ball: Some(12.0),
            ..quick()
        },
    )
    .runout
    .unwrap();
    let beta = PI / 44.0 - gear.half_angle_at_roll(gear.tip_roll());
    let (r_a, half) = (gear.tip_radius(), gear.tip_radius() * beta.sin());
    let expected = r_a * beta.cos() + (36.0 - half * half).sqrt();
    assert!(
        (found.mean() - expected).abs() < PICOMETRE,
        "{} {expected}",
        found.mean()
    );
    // On the root land: r_f + R.
    let found = measure(
        &part,
        Settings {
            ball: Some(1.0),
            ..quick()
        },
    )
    .runout
    .unwrap();
    assert!((found.mean() - (gear.root_radius() + 0.5)).abs() < PICOMETRE);

    let span = |k| {
        curves(Settings {
            span_teeth: Some(k),
            ..quick()
        })
        .1
    };
    assert_eq!(span(5).map(|s| s.0), Ok(Curve::Involute));
    let (curve, length) = span(9).unwrap();
    assert_eq!(curve, Curve::Tip);
    // Both anvils on tip corners: their chord.
    let corners = 8.0 * PI / 44.0 + gear.half_angle_at_roll(gear.tip_roll());
    let chord = 2.0 * r_a * corners.sin();
    assert!((length - chord).abs() < PICOMETRE, "{length} {chord}");
    assert!(length < thickness::span_from_base(gear.toothing(), 9, gear.base_thickness()));
    assert!(matches!(span(23), Err(Unmeasured(_))));
    assert!(matches!(
        measure(
            &part,
            Settings {
                pin: Some(1.0),
                ..quick()
            }
        )
        .pins,
        Err(Unmeasured(_))
    ));
}
