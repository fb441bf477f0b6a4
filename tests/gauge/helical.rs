//! Helical gears: other programs' numbers, and flanks written out as surfaces in space, searched densely.

use super::*;

/// Published: FVA Workbench examples 1-3, over two balls and over two pins of nominal gears. They include the allowances of the dimension
/// over balls for −115 and −165 µm of thickness in the normal section. The measured thickness gives the gear again.
#[test]
fn published_dimensions_over_balls_and_over_pins() {
    for row in rows::<[f64; 9]>(include_str!("data/published_helical.csv")) {
        let [teeth, module, helix_deg, shift, ball, sizes @ ..] = row;
        let [over_balls, over_pins, first, second] = sizes;
        for (allowance, off, hand) in [
            (0.0, 0.0, Hand::Left),
            (-0.115, first, Hand::Right),
            (-0.165, second, Hand::Left),
        ] {
            let make = spur(teeth as u32, module)
                .rack(1.0, 1.25, 0.25)
                .shift(shift);
            let make = make.helix(helix_deg, hand).allowance(allowance);
            let (data, base) = (make.design.basic_data, make.gear().base_thickness());
            let found = measure(&make.front(), with_pin(ball, None));
            let pins = found.pins.unwrap();
            // Between balls and pins lies the cosine alone, whatever the thickness.
            let per_ball = match teeth as u32 % 2 {
                0 => 1.0,
                _ => (TAU / 4.0 / teeth).cos(),
            };
            let expected = over_balls + off;
            let over = (expected - ball) / per_ball + ball;
            assert!(allowance != 0.0 || (over - over_pins).abs() < PICOMETRE);
            let formula = found.formula;
            for (list, expected, formula) in [
                (&pins.two, expected, formula.over_two),
                (&pins.lying, over, formula.over_lying),
            ] {
                for reading in list {
                    near(teeth, reading.length, expected, PICOMETRE);
                    near(teeth, reading.length, formula.unwrap(), reading.error);
                }
            }
            let (two, lying) = (
                Pins::summary(&pins.two).mean,
                Pins::summary(&pins.lying).mean,
            );
            let spans = found.spans.unwrap();
            for back in [
                thickness::base_from_pins(&data, ball, two).unwrap(),
                thickness::base_from_over(&data, MeasuringBody::Pin, ball, lying).unwrap(),
                thickness::base_from_span(&data, spans.teeth, spans.summary().mean),
            ] {
                near(teeth, back, base, PICOMETRE);
            }
            // s_n = m_n (π/2 + 2 x tan α_n) + A_sn.
            let arcs = found.thickness.unwrap();
            let normal = module * (TAU / 4.0 + 2.0 * shift * ALPHA.tan()) + allowance;
            for arc in [arcs.summary().mean, formula.thickness.unwrap()] {
                near(teeth, arc * arcs.normal, normal, PICOMETRE);
            }
            assert_eq!(found.stated.unwrap(), StatedThickness::Spans);
        }
    }
}

fn centre(seat: &Seat) -> Point3<f64> {
    Point3::new(seat.centre.x, seat.centre.y, 0.0)
}

/// A ball touches both helicoids of its space and cuts neither; a cylinder of its diameter that lies along the space does so, too.
#[test]
fn balls_and_pins_rest_on_both_flanks_in_space() {
    for space in in_space() {
        let found = measure(&space.gear, with_pin(5.5, Some(3)));
        let pins = found.pins.unwrap();
        for seat in pins.seats.iter().step_by(4) {
            let centre = centre(seat);
            // Along the helix of the centre.
            let turning = Vector3::new(-centre.y, centre.x, 0.0) * space.twist;
            let axis = (turning + Vector3::z()).normalize();
            let next = seat.tooth % space.teeth + 1;
            for (own, tooth) in [(Flank::Right, seat.tooth), (Flank::Left, next)] {
                let ball = space.least(own, tooth, |p| (p - centre).norm());
                near("ball", ball, 2.75, PICOMETRE);
                let pin = space.least(own, tooth, |p| (p - centre).cross(&axis).norm());
                near("pin", pin, 2.75, PICOMETRE);
            }
            // D_M/2 · sin β_b from the measuring plane, to either side.
            let [one, other] = seat.sections;
            near("sections", one, -other, 1e-5);
            near("section", one.abs(), 2.75 * space.base_sin(), 1e-5);
            let curves = seat.touched.map(|touched| touched.curve);
            assert_eq!(curves, [ToothPlace::Involute; 2]);
        }
        // Runout: the ball's centre from the rotation axis, in the measuring plane.
        let offset = space.gear.displacement(0.0);
        for ball in &found.runout.unwrap().readings {
            let expected = (ball.seat.centre + offset).coords.norm();
            assert_eq!(ball.radius, expected);
        }
    }
}

/// Size → thickness: what was read over balls, over pins and as spans goes back to the mean base thickness, and the spans to each tooth's.
#[test]
fn readings_go_back_to_the_thickness() {
    let [space, _] = in_space();
    let data = space.gear.gear().basic_data();
    let base = 2.0 * space.half * space.base;
    let found = measure(&space.gear, with_pin(5.5, Some(3)));
    let (pins, spans) = (found.pins.unwrap(), found.spans.unwrap());
    for (body, list) in [
        (MeasuringBody::Ball, &pins.two),
        (MeasuringBody::Pin, &pins.lying),
    ] {
        let list: Vec<(u32, f64)> = list.iter().map(|over| (over.tooth, over.length)).collect();
        let readings = PinReadings::new(data, body, 5.5, Readings::new(data, list).unwrap());
        let back = readings.base_thickness(&space.deviations).unwrap();
        near(body, back, base, PICOMETRE);
        for (read, said) in readings.compare(&space.deviations).unwrap() {
            near(body, read, said, PICOMETRE);
        }
    }
    let list = spans.readings.iter();
    let list = list.map(|span| (span.first_tooth, span.length)).collect();
    let spans = Spans::new(data, 3, Readings::new(data, list).unwrap()).unwrap();
    let known = Deviations {
        per_tooth: Vec::new(),
        ..space.deviations.clone()
    };
    let mean = space.per_tooth.iter().sum::<f64>() / f64::from(space.teeth);
    let back = spans.base_thickness(&known).unwrap();
    let more = mean * ALPHA.cos() / space.base_cos();
    near("by spans", back, base + more, PICOMETRE);
    let each = spans.per_tooth(&known).unwrap().unwrap().thickness;
    for (back, made) in each.iter().zip(&space.per_tooth) {
        near("tooth", *back, made - mean, PICOMETRE);
    }
}

/// The virtual gauge's readings of a gear with deviations of every kind give the eccentricity that was put in.
#[test]
fn readings_of_the_virtual_ball_give_the_eccentricity_back() {
    for space in in_space() {
        for ball in [5.0, 5.5] {
            let read = measure(&space.gear, with_ball(ball)).runout.unwrap();
            let mm = read.readings.iter().map(|reading| reading.radius).collect();
            let probe = Probe::Ball(ball);
            let readings = RunoutReadings { probe, mm };
            let fit = readings.fit(space.gear.gear(), &space.deviations).unwrap();
            near(ball, fit.eccentricity, 0.021, PICOMETRE);
            near(ball, fit.high_tooth, 5.25, 1e-6);
            near(ball, fit.range, fit.known_range, PICOMETRE);
            for (read, said) in fit.rest {
                near(ball, read, said, PICOMETRE);
            }
        }
    }
}

/// A fork of two plane faces, each at `α_n` to its axis in the normal section and inclined at the helix angle. It
/// slides towards the axis of the gear, which turns until both faces touch: each face meets its helicoid in space.
#[test]
fn a_fork_rides_on_helical_teeth_as_its_closed_form_says() {
    for space in in_space() {
        let (sin, cos, alpha_t) = (space.base_sin(), space.base_cos(), space.alpha_t());
        // `sin α_n = sin α_t cos β_b`: the inclination in the normal section.
        near("sin α_n", alpha_t.sin() * cos, ALPHA.sin(), 1e-15);
        let ascending = space.ascending();
        let offset = space.gear.displacement(0.0);
        let offset = Vector3::new(offset.x, offset.y, 0.0);
        let apex = |tooth: u32, own: Flank, turn: f64| {
            let ahead = if own == Flank::Right { 1.0 } else { -1.0 };
            // The fork turns the other way about the gear.
            let middle = ascending * space.pitches(tooth - 1) - turn;
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
        let mm = (1..=space.teeth).map(read).collect();
        let probe = Probe::Fork;
        let readings = RunoutReadings { probe, mm };
        let fit = readings.fit(space.gear.gear(), &space.deviations).unwrap();
        near("eccentricity", fit.eccentricity, 0.021, 10.0 * PICOMETRE);
        near("high tooth", fit.high_tooth, 5.25, 1e-5);
    }
}
