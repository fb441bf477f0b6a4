//! Helical gears: other programs' numbers, and flanks written out here as surfaces in space, searched densely.

use super::helical_dimensions::{PUBLISHED, Published};
use super::*;
use gearlash::analytic::InvolutePair;
use gearlash::gauge::{OverPins, StatedThickness};
use gearlash::gear::{Hand, thickness};
use std::f64::consts::TAU;

pub(super) fn helical(
    teeth: u32,
    module: f64,
    beta_deg: f64,
    hand: Hand,
    shift: f64,
) -> GearDesign {
    let spur = BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap();
    GearDesign {
        basic_data: spur.with_helix(beta_deg.to_radians(), hand).unwrap(),
        profile_shift: shift,
        rack: BasicRack::new(1.0, 1.25, 0.25).unwrap(),
        tip_diameter: None,
    }
}

pub(super) fn with_pin(pin: f64, span_teeth: Option<u32>) -> Settings {
    Settings {
        pin: Some(pin),
        span_teeth,
        ..quick()
    }
}

/// Published: FVA Workbench examples 1-3, over two balls and over two pins of nominal gears. They include the allowances of the dimension
/// over balls for −115 and −165 µm of thickness in the normal section. The measured thickness gives the gear again.
#[test]
fn published_dimensions_over_balls_and_over_pins() {
    for Published {
        teeth,
        module,
        helix_deg,
        shift,
        ball,
        over_balls,
        over_pins,
        allowances,
    } in PUBLISHED
    {
        let cases = [0.0, -0.115, -0.165].into_iter();
        let off = [0.0, allowances[0], allowances[1]];
        for ((allowance, off), hand) in cases.zip(off).zip([Hand::Left, Hand::Right, Hand::Left]) {
            let design = helical(teeth, module, helix_deg, hand, shift);
            let (data, nominal) = (design.basic_data, design.nominal_base_thickness());
            let base = thickness::base_from_allowance(&data, nominal, allowance);
            let part = AsBuilt::perfect(Gear::new(design, base).unwrap(), Face::Front);
            let found = measure(&part, with_pin(ball, None));
            let pins = found.pins.unwrap();
            for (two, lying) in pins.two.iter().zip(&pins.lying) {
                let expected = over_balls + off;
                assert!(
                    (two.length - expected).abs() < PICOMETRE,
                    "{teeth}: {} {expected}",
                    two.length
                );
                // Between balls and pins lies the cosine alone, whatever the thickness.
                let per_ball = match teeth % 2 {
                    0 => 1.0,
                    _ => (TAU / 4.0 / f64::from(teeth)).cos(),
                };
                let expected = (expected - ball) / per_ball + ball;
                assert!((lying.length - expected).abs() < PICOMETRE, "{teeth}");
                assert!(allowance != 0.0 || (lying.length - over_pins).abs() < PICOMETRE);
                assert!((two.length - found.formula.over_two.unwrap()).abs() <= two.error);
            }
            let read = OverPins::mean(&pins.two);
            let back = thickness::base_from_pins(&data, ball, read).unwrap();
            assert!((back - base).abs() < PICOMETRE);
            let read = OverPins::mean(&pins.lying);
            let back = thickness::base_from_helical_pins(&data, ball, read).unwrap();
            assert!((back - base).abs() < PICOMETRE);
            let spans = found.spans.unwrap();
            let back = thickness::base_from_span(&data, spans.teeth, spans.mean());
            assert!((back - base).abs() < PICOMETRE, "{back} {base}");
            // s_n = m_n (π/2 + 2 x tan α_n) + A_sn.
            let arcs = found.thickness.unwrap();
            let normal = module * (TAU / 4.0 + 2.0 * shift * 20f64.to_radians().tan()) + allowance;
            assert!((arcs.mean() * arcs.normal - normal).abs() < PICOMETRE);
            assert!((found.formula.thickness.unwrap() * arcs.normal - normal).abs() < PICOMETRE);
            let stated = found.stated.unwrap();
            assert_eq!(stated, StatedThickness::Spans);
        }
    }
}

/// Closed form: two perfect gears without play have the distance of their involutes, over any face.
#[test]
fn a_perfect_helical_gear_does_not_move_on_the_master() {
    for (teeth, beta, face) in [(23, 24.0, [-10.0, 25.0]), (40, 8.0, [0.0, 0.0])] {
        let gear = Gear::nominal(helical(teeth, 3.0, beta, Hand::Left, 0.2)).unwrap();
        let part = AsBuilt::perfect(gear.clone(), Face::Front);
        let settings = Settings { face, ..quick() };
        let roll = measure(&part, settings).roll.unwrap();
        let expected = InvolutePair::new(&gear, &roll.master);
        let expected = expected.center_distance(0.0).unwrap();
        for pose in &roll.poses {
            let off = (pose.distance - expected).abs();
            assert!(off <= pose.error && pose.error < 2e-10, "{off}");
        }
    }
}

/// Closed form, as for a spur gear: an eccentricity moves the gears equally in every section, `a'' = e cos χ + √(a_0² − e² sin² χ)`.
#[test]
fn an_eccentric_helical_gear_moves_as_a_spur_gear_over_any_face() {
    let deviations = Deviations {
        eccentricity: 0.02,
        high_tooth: 1.0,
        ..Deviations::default()
    };
    let gear = Gear::nominal(helical(40, 3.0, 20.0, Hand::Right, 0.0)).unwrap();
    let part = AsBuilt::new(gear, Face::Front, &deviations).unwrap();
    for face in [[0.0, 0.0], [-5.0, 30.0]] {
        let settings = Settings { face, ..quick() };
        let roll = measure(&part, settings).roll.unwrap();
        let a_0 = InvolutePair::new(part.gear(), &roll.master);
        let a_0 = a_0.center_distance(0.0).unwrap();
        for pose in roll.poses.iter().chain(&roll.between) {
            let (sin, cos) = pose.rotation.sin_cos();
            let expected = 0.02 * cos + (a_0 * a_0 - (0.02 * sin).powi(2)).sqrt();
            assert!(
                (pose.distance - expected).abs() < PICOMETRE,
                "{}",
                pose.distance
            );
        }
    }
}

/// At a helix angle that turns the face's ends by less than a nanometre the readings are the spur gear's.
#[test]
fn a_vanishing_helix_angle_is_a_spur_gear() {
    let read = |beta_deg: f64| {
        let design = helical(23, 3.0, beta_deg, Hand::Right, 0.2);
        let gear = Gear::nominal(design).unwrap();
        let pitch = scaled(&made_up(23, 2), 12e-3);
        let deviations = Deviations {
            pitch: Some(Pitch::from_cumulative(&pitch, &pitch)),
            ..Deviations::default()
        };
        let part = AsBuilt::new(gear, Face::Front, &deviations).unwrap();
        let found = measure(&part, with_pin(5.5, Some(3)));
        let (spans, pins) = (found.spans.unwrap(), found.pins.unwrap());
        let spans = spans.readings.iter().map(|span| span.length);
        let pins = pins.two.iter().map(|over| over.length);
        spans.chain(pins).collect::<Vec<f64>>()
    };
    for (wound, spur) in read(1e-6).into_iter().zip(read(0.0)) {
        assert!((wound - spur).abs() < PICOMETRE, "{wound} {spur}");
    }
}
