//! Flanks of helical gears written out as surfaces in space, searched densely.

use super::helical::{helical, with_pin};
use super::*;
use gearlash::gauge::Seat;
use gearlash::gear::{
    Flank, Hand, MeasuringBody, PinReadings, ProfilePart, Readings, Spans, thickness,
};
use nalgebra::{Point3, Vector3};
use std::f64::consts::TAU;

/// Flanks as surfaces: the section at the measuring plane turned by `−η tan β/r` a mm, every flank where its tooth has it.
pub(super) struct InSpace {
    pub made: Made,
    pub deviations: Deviations,
    base: f64,
    half: f64,
    pub twist: f64,
}

pub(super) const TEETH: u32 = 23;

impl InSpace {
    pub fn new(hand: Hand, face: Face) -> InSpace {
        let design = helical(TEETH, 3.0, 24.0, hand, 0.2);
        let data = design.basic_data;
        let per_tooth = scaled(&made_up(TEETH, 1), 8e-3);
        let (right, left) = (
            scaled(&made_up(TEETH, 2), 12e-3),
            scaled(&made_up(TEETH, 3), 12e-3),
        );
        let base = thickness::base_from_allowance(&data, design.nominal_base_thickness(), -0.06);
        let deviations = Deviations {
            per_tooth: per_tooth.clone(),
            pitch: Some(Pitch::from_cumulative(&right, &left)),
            eccentricity: 0.021,
            high_tooth: 5.25,
            ..Deviations::default()
        };
        let gear = AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap();
        let eta = if hand == Hand::Right { 1.0 } else { -1.0 };
        let beta = 24f64.to_radians();
        InSpace {
            deviations,
            base: data.base_radius(),
            half: base / (2.0 * data.base_radius()),
            twist: -eta * beta.tan() / (1.5 * f64::from(TEETH) / beta.cos()),
            made: Made {
                gear,
                per_tooth,
                right,
                left,
            },
        }
    }

    fn reference(&self) -> f64 {
        1.5 * f64::from(TEETH) / 24f64.to_radians().cos()
    }

    /// Half the arc in the transverse section that a thickness of the normal section adds.
    fn half_arc(&self, tooth: u32) -> f64 {
        0.5 * self.made.per_tooth[tooth as usize - 1] / 24f64.to_radians().cos()
    }

    /// A point of the flank: `ahead` is +1 on own right flanks, which face ascending numbers.
    fn point(&self, own: Flank, tooth: u32, xi: f64, b: f64) -> Point3<f64> {
        let r = self.reference();
        let (list, ahead) = match own {
            Flank::Right => (&self.made.right, 1.0),
            Flank::Left => (&self.made.left, -1.0),
        };
        // The curves go without their mean, which is no pitch deviation.
        let out = list[tooth as usize - 1] + ahead * self.half_arc(tooth);
        let numbers = TAU * f64::from(tooth - 1) / f64::from(TEETH);
        let along = numbers + ahead * (self.half - (xi - xi.atan())) + out / r;
        // Numbers ascend clockwise on the front.
        let angle = match self.made.gear.face() {
            Face::Front => -along,
            Face::Back => along,
        };
        let angle = angle + self.twist * b;
        let radius = self.base * (1.0 + xi * xi).sqrt();
        Point3::new(radius * angle.cos(), radius * angle.sin(), b)
    }

    /// The least `value` of a flank's points, by a grid that is narrowed round its least place.
    pub fn least(&self, own: Flank, tooth: u32, value: impl Fn(&Point3<f64>) -> f64) -> f64 {
        let (mut middle, mut reach) = ([0.5, 0.0], [0.4, 12.0]);
        let mut least = f64::INFINITY;
        for _ in 0..60 {
            let mut at = middle;
            for i in -20..=20 {
                for j in -20..=20 {
                    let xi = middle[0] + reach[0] * f64::from(i) / 20.0;
                    let b = middle[1] + reach[1] * f64::from(j) / 20.0;
                    let here = value(&self.point(own, tooth, xi, b));
                    if here < least {
                        (least, at) = (here, [xi, b]);
                    }
                }
            }
            middle = at;
            reach = reach.map(|reach| 0.7 * reach);
        }
        least
    }

    fn centre(&self, seat: &Seat) -> Point3<f64> {
        Point3::new(seat.centre.x, seat.centre.y, 0.0)
    }
}

/// A ball touches both helicoids of its space and cuts neither; a cylinder of its diameter that lies along the space does so, too.
#[test]
fn balls_and_pins_rest_on_both_flanks_in_space() {
    for (hand, face) in [(Hand::Left, Face::Front), (Hand::Right, Face::Back)] {
        let space = InSpace::new(hand, face);
        let found = measure(&space.made.gear, with_pin(5.5, Some(3)));
        let pins = found.pins.unwrap();
        for seat in pins.seats.iter().step_by(4) {
            let centre = space.centre(seat);
            // Along the helix of the centre.
            let turning = Vector3::new(-centre.y, centre.x, 0.0) * space.twist;
            let axis = (turning + Vector3::z()).normalize();
            let next = seat.tooth % TEETH + 1;
            for (own, tooth) in [(Flank::Right, seat.tooth), (Flank::Left, next)] {
                let ball = space.least(own, tooth, |p| (p - centre).norm());
                assert!((ball - 2.75).abs() < PICOMETRE, "{ball}");
                let pin = space.least(own, tooth, |p| (p - centre).cross(&axis).norm());
                assert!((pin - 2.75).abs() < PICOMETRE, "{pin}");
            }
            // D_M/2 · sin β_b from the measuring plane, to either side.
            let sin = 24f64.to_radians().sin() * 20f64.to_radians().cos();
            assert!((seat.sections[0] + seat.sections[1]).abs() < 1e-5);
            assert!(
                (seat.sections[0].abs() - 2.75 * sin).abs() < 1e-5,
                "{:?}",
                seat.sections
            );
            let involute = seat
                .touched
                .iter()
                .all(|t| t.curve == ProfilePart::Involute);
            assert!(involute);
        }
        // Runout: the ball's centre from the rotation axis, in the measuring plane.
        let offset = space.made.gear.displacement(0.0);
        for ball in &found.runout.unwrap().readings {
            let expected = (ball.seat.centre + offset).coords.norm();
            assert_eq!(ball.radius, expected);
        }
        assert!((found.eccentricity.as_ref().unwrap().amount - 0.021).abs() < PICOMETRE);
        assert!((found.eccentricity.as_ref().unwrap().high_tooth - 5.25).abs() < 1e-8);
    }
}

/// Two parallel planes that lean by the base helix angle, each brought to its helicoid: their distance is the span. By hand
/// `W = cos β_b ((k − 1) p_bt + s_bt + cos α_t (F_R − F_L + (δ + δ')/(2 cos β)))`.
#[test]
fn spans_lie_along_the_normal_of_the_helix() {
    for (hand, face) in [(Hand::Left, Face::Front), (Hand::Right, Face::Back)] {
        let space = InSpace::new(hand, face);
        let found = measure(&space.made.gear, with_pin(5.5, Some(3)));
        let spans = found.spans.unwrap();
        let (beta, alpha) = (24f64.to_radians(), 20f64.to_radians());
        let sin = beta.sin() * alpha.cos();
        let cos = (1.0 - sin * sin).sqrt();
        let cos_t = (alpha.tan() / beta.cos()).atan().cos();
        for span in spans.readings.iter().step_by(5) {
            let last = (span.first_tooth + 1) % TEETH + 1;
            let shift = space.made.right[last as usize - 1]
                - space.made.left[span.first_tooth as usize - 1]
                + space.half_arc(span.first_tooth)
                + space.half_arc(last);
            let pitch = TAU / 2.0 * 3.0 * cos_t / beta.cos();
            let by_hand = cos * (2.0 * pitch + 2.0 * space.half * space.base + cos_t * shift);
            assert!(
                (span.length - by_hand).abs() < PICOMETRE,
                "{} {by_hand}",
                span.length
            );

            // Square to the middle of the teeth, seen along ascending numbers.
            let numbers = TAU * f64::from(span.first_tooth) / f64::from(TEETH);
            let ascending = if face == Face::Front { -1.0 } else { 1.0 };
            let middle = ascending * numbers;
            let tangent = ascending * Vector3::new(-middle.sin(), middle.cos(), 0.0);
            // A helicoid that sections turn along the tangent recedes along the axis.
            let lean = -(space.twist * ascending).signum() * sin;
            let normal = cos * tangent + lean * Vector3::z();
            let ahead = space.least(Flank::Right, last, |p| -normal.dot(&p.coords));
            let behind = space.least(Flank::Left, span.first_tooth, |p| normal.dot(&p.coords));
            let apart = -ahead - behind;
            assert!(
                (span.length - apart).abs() < PICOMETRE,
                "{} {apart}",
                span.length
            );
            let along = span.sections[0] - span.sections[1];
            assert!((along.abs() - span.length * sin).abs() < 1e-6, "{along}");
            assert!((span.touched[0].radius - span.touched[1].radius).abs() < 1e-2);
        }
    }
}

/// Size → thickness: what was read over balls, over pins and as spans goes back to the mean base thickness, and the spans to each tooth's.
#[test]
fn readings_go_back_to_the_thickness() {
    let space = InSpace::new(Hand::Left, Face::Front);
    let data = space.made.gear.gear().basic_data();
    let base = 2.0 * space.half * space.base;
    let found = measure(&space.made.gear, with_pin(5.5, Some(3)));
    let (pins, spans) = (found.pins.unwrap(), found.spans.unwrap());
    for (body, list) in [
        (MeasuringBody::Ball, &pins.two),
        (MeasuringBody::Pin, &pins.lying),
    ] {
        let list: Vec<(u32, f64)> = list.iter().map(|over| (over.tooth, over.length)).collect();
        let readings = PinReadings::new(data, body, 5.5, Readings::new(data, list).unwrap());
        let back = readings.base_thickness(&space.deviations).unwrap();
        assert!((back - base).abs() < PICOMETRE, "{body:?}: {back} {base}");
        for (read, said) in readings.compare(&space.deviations).unwrap() {
            assert!((read - said).abs() < PICOMETRE, "{body:?}");
        }
    }
    let list = spans.readings.iter();
    let list = list.map(|span| (span.first_tooth, span.length)).collect();
    let spans = Spans::new(data, 3, Readings::new(data, list).unwrap()).unwrap();
    let known = Deviations {
        per_tooth: Vec::new(),
        ..space.deviations.clone()
    };
    let mean = space.made.per_tooth.iter().sum::<f64>() / f64::from(TEETH);
    let cos = 20f64.to_radians().cos()
        / (1.0 - (24f64.to_radians().sin() * 20f64.to_radians().cos()).powi(2)).sqrt();
    let back = spans.base_thickness(&known).unwrap();
    assert!((back - base - mean * cos).abs() < PICOMETRE);
    let each = spans.per_tooth(&known).unwrap().unwrap().thickness;
    for (back, made) in each.iter().zip(&space.made.per_tooth) {
        assert!((back - (made - mean)).abs() < PICOMETRE, "{back} {made}");
    }
}

/// Pitch and thickness are read in the measuring plane: what went in comes out, the thickness by tooth `1/cos β` as large on the arc.
#[test]
fn pitch_and_thickness_of_the_measuring_plane() {
    let space = InSpace::new(Hand::Right, Face::Front);
    let found = measure(&space.made.gear, with_pin(5.5, Some(3)));
    let own = found.pitch_own.unwrap();
    let arcs = found.thickness.unwrap();
    for (own_flank, list, ahead) in [
        (Flank::Right, &space.made.right, 1.0),
        (Flank::Left, &space.made.left, -1.0),
    ] {
        let expected: Vec<f64> = (1..=TEETH)
            .map(|tooth| list[tooth as usize - 1] + ahead * space.half_arc(tooth))
            .collect();
        let mean = expected.iter().sum::<f64>() / f64::from(TEETH);
        for (read, expected) in own.cumulative.flank(own_flank).iter().zip(&expected) {
            assert!((read - (expected - mean)).abs() < PICOMETRE);
        }
    }
    let nominal = 3.0 * (TAU / 4.0 + 0.4 * 20f64.to_radians().tan()) - 0.06;
    for tooth in 1..=TEETH {
        let i = tooth as usize - 1;
        let expected =
            nominal / 24f64.to_radians().cos() + 2.0 * space.half_arc(tooth) + space.made.right[i]
                - space.made.left[i];
        assert!((arcs.arcs[i] - expected).abs() < PICOMETRE);
    }
}
