//! Helical gears: other programs' numbers, and flanks written out here as surfaces in space, searched densely.

use super::*;
use gearlash::analytic::InvolutePair;
use gearlash::gauge::{OverPins, Seat, StatedThickness};
use gearlash::gear::{
    Flank, Hand, MeasuringBody, PinReadings, ProfilePart, Readings, Spans, thickness,
};
use nalgebra::{Point3, Vector3};
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

fn with_pin(pin: f64, span_teeth: Option<u32>) -> Settings {
    Settings {
        pin: Some(pin),
        span_teeth,
        ..quick()
    }
}

/// Published: FVA Workbench examples 1-3 over two balls and over two pins of nominal gears, and the allowances of the dimension over balls
/// that −115 and −165 µm of thickness in the normal section come to. The thickness that the gauge reads states the gear again.
#[test]
fn published_dimensions_over_balls_and_over_pins() {
    for (teeth, module, beta, shift, ball, over_balls, over_pins, allowances) in [
        (
            27,
            4.5,
            21.0,
            0.3,
            9.0,
            147.07716569057362,
            147.3111662932581,
            [-0.23885299485385758, -0.34313756843801],
        ),
        (
            51,
            4.5,
            21.0,
            0.1628301985916763,
            8.0,
            258.8158215092951,
            258.9348349547439,
            [-0.28157221563412804, -0.4044946722594318],
        ),
        (
            23,
            6.5,
            10.0,
            0.3,
            12.0,
            172.6420925797242,
            173.01746144670994,
            [-0.23468449671668168, -0.3371109063772053],
        ),
        (
            34,
            6.5,
            10.0,
            0.0014790906759136746,
            12.0,
            242.8440796716534,
            242.8440796716534,
            [-0.2675679628538603, -0.3843866614119804],
        ),
    ] {
        let cases = [0.0, -0.115, -0.165].into_iter();
        let off = [0.0, allowances[0], allowances[1]];
        for ((allowance, off), hand) in cases.zip(off).zip([Hand::Left, Hand::Right, Hand::Left]) {
            let design = helical(teeth, module, beta, hand, shift);
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
            assert!((found.formula.thickness * arcs.normal - normal).abs() < PICOMETRE);
            let stated = found.stated.unwrap();
            assert_eq!(stated, StatedThickness::Spans);
        }
    }
}

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
        assert!((found.eccentricity.amount - 0.021).abs() < PICOMETRE);
        assert!((found.eccentricity.high_tooth - 5.25).abs() < 1e-8);
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
        for (read, said) in readings.beside(&space.deviations).unwrap() {
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

/// Closed form: two perfect gears without play stand at the distance of their involutes, over any face.
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

/// Closed form, as of a spur gear: between involutes an eccentricity moves the gears alike in every section, `a'' = e cos χ + √(a_0² − e² sin² χ)`.
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
