//! Gears whose profiles deviate: a stated thickness is that of the flanks where the measurement touches them.

use super::*;

/// Shifted by 0.1 of a module of 3 mm.
fn shifted(teeth: u32) -> Make {
    spur(teeth, 3.0).shift(0.1)
}

/// Slope, crowning, both reliefs and a wavy trace of all teeth, one of them or together.
fn profile(teeth: u32, which: usize) -> Modification {
    let r = shifted(teeth).design.basic_data.reference_radius();
    let relief = |amount, from, parabolic| Relief {
        amount,
        from,
        parabolic,
    };
    let is = |number: usize| which == number || which > 5;
    let rolls = (0..40).map(|k| 0.1 + 0.02 * f64::from(k));
    let wavy = trace(None, rolls.map(|roll| (roll, 0.003 * (9.0 * roll).sin())));
    let of = |number: usize, amount: f64| if is(number) { amount } else { 0.0 };
    Modification {
        range: Some([r - 1.2, r + 3.0]),
        slope: of(0, 0.012),
        crowning: if which == 5 { -0.01 } else { of(1, 0.008) },
        tip_relief: is(2).then(|| relief(0.02, r + 0.6, false)),
        root_relief: is(3).then(|| relief(0.015, r - 0.4, true)),
        traces: Vec::from_iter(is(4).then_some(wavy)),
    }
}

fn trace(tooth: Option<u32>, points: impl IntoIterator<Item = (f64, f64)>) -> Trace {
    Trace {
        tooth,
        points: points.into_iter().collect(),
    }
}

/// The profiles of both flanks: on both, or on one.
fn sides(one: &Modification) -> [[Modification; 2]; 3] {
    let none = Modification::default;
    [
        [one.clone(), one.clone()],
        [one.clone(), none()],
        [none(), one.clone()],
    ]
}

/// A gear of nominal thickness with these profiles, gauged over the range that they state.
fn gauged(profiles: &[Modification; 2], face: Face) -> ProfileReadings {
    let measurements = Measurements {
        profiles: profiles.clone(),
        ..Measurements::nominal(shifted(20).design, face)
    };
    let gear = measurements.measure().unwrap();
    let settings = Settings {
        evaluation: profiles.each_ref().map(|profile| profile.range),
        ..quick()
    };
    measure(gear.as_built.most(), settings).profile.unwrap()
}

/// Slope and crowning come out as they went in, of each flank its own, on either face. Source: ISO 1328-1, by which a straight line has a slope alone
/// and a parabola of no slope the form `C` and the total `C`. Positive crowning stands out in the middle.
#[test]
fn slope_and_crowning_come_out_as_they_went_in() {
    for face in [Face::Front, Face::Back] {
        let [sloped, crowned] = [profile(20, 0), profile(20, 1)];
        let read = gauged(&[sloped.clone(), crowned.clone()], face);
        let bound = 10.0 * read.error;
        let [right, left] = [read.flank(Flank::Right), read.flank(Flank::Left)];
        assert_eq!((right.shapes.len(), left.shapes.len()), (1, 1));
        let (right, left_shape) = (&right.shapes[0], &left.shapes[0]);
        for (what, value, expected) in [
            ("slope", right.slope, sloped.slope),
            ("form", right.form, 0.0),
            ("total", right.total, sloped.slope),
            ("left slope", left_shape.slope, 0.0),
            ("left form", left_shape.form, crowned.crowning),
            ("left total", left_shape.total, crowned.crowning),
        ] {
            near((face, what), value, expected, bound);
        }
        let middle = left.evaluated.iter().sum::<f64>() / 2.0;
        let is_near = |point: &&(f64, f64)| (point.0 - middle).abs() < 0.2;
        let standing = left_shape.points.iter().find(is_near).unwrap().1;
        near(face, standing, crowned.crowning, 0.01 * crowned.crowning);
    }
}

/// A straight tip relief over the last part `q` of the evaluation range, to the amount `C` at its end. Source: least squares of the
/// ramp by hand, over the range from 0 to 1: slope `−12 C (q²/3 + (1/2 − q) q/2)`.
#[test]
fn a_ramp_has_the_slope_of_its_mean_line() {
    let mut ramp = profile(20, 2);
    let gear = shifted(20).gear();
    ramp.range = Some([
        gear.basic_data().reference_radius() - 1.2,
        gear.tip_radius(),
    ]);
    let relief = ramp.tip_relief.unwrap();
    let roll = |radius| involute::roll_at(radius, gear.base_radius());
    let [start, end] = ramp.evaluated(&gear);
    let q = (end - roll(relief.from)) / (end - start);
    let expected = -12.0 * relief.amount * (q * q / 3.0 + (0.5 - q) * q / 2.0);
    let read = gauged(&[ramp.clone(), ramp], Face::Front);
    let shape = &read.flank(Flank::Left).shapes[0];
    // The edge lies between two of 201 points.
    near("slope", shape.slope, expected, 1e-4 * relief.amount);
    near("total", shape.total, relief.amount, 10.0 * read.error);
}

/// A trace comes out at its own points, on the tooth it was measured on, and the mean on others.
#[test]
fn traces_come_out_as_they_went_in() {
    let trace = |tooth, sign: f64| {
        let place = |k| (0.15 + 0.07 * f64::from(k), sign * 0.003 * f64::from(k % 3));
        trace(Some(tooth), (0..9).map(place))
    };
    let traced = Modification {
        traces: vec![trace(4, 1.0), trace(9, 3.0)],
        ..Modification::default()
    };
    let base = shifted(20).design.basic_data.base_radius();
    let read = gauged(&[traced.clone(), Modification::default()], Face::Front);
    for (tooth, times) in [(4, 1.0), (9, 3.0), (1, 2.0)] {
        let found = &read.flank(Flank::Right).tooth(tooth).points;
        for (roll, mm) in &trace(1, times).points {
            let length = base * roll;
            let mut pairs = found.windows(2);
            let Some(pair) = pairs.find(|w| w[0].0 <= length && length <= w[1].0) else {
                continue;
            };
            let part = (length - pair[0].0) / (pair[1].0 - pair[0].0);
            let there = pair[0].1 + part * (pair[1].1 - pair[0].1);
            // Between two of 201 points of a curve that bends by 9 µm in 0.07 rad.
            near((tooth, roll), there, *mm, 1e-4);
        }
        // 0, 3 and 6 µm by turns.
        let total = read.flank(Flank::Right).tooth(tooth).total;
        near(tooth, total, times * 0.006, 1e-5);
    }
    assert_eq!(read.flank(Flank::Right).worst_tooth(), 9);
    assert!(read.flank(Flank::Left).shapes[0].total < 10.0 * read.error);
}

/// Runout read with a ball on flanks of which each tooth has its own profile: what these do is no eccentricity, and alone reads as more than 0.1 µm of it.
/// Source: the eccentricity put in, 10 µm towards tooth 6.25. The trace of tooth 5 is 1e-19 mm, below the rounding of a roll, and no reason to refuse it.
#[test]
fn profiles_of_single_teeth_are_no_eccentricity() {
    let teeth = 20;
    let flat = |tooth: u32| {
        let mm = 0.002 * (f64::from(tooth) * TAU / 20.0).cos();
        trace(Some(tooth), [(0.1, mm), (0.4, 1.2 * mm), (0.8, mm)])
    };
    let traced = Modification {
        traces: (1..=teeth).map(flat).collect(),
        ..Modification::default()
    };
    let with = |runout| Measurements {
        profiles: [traced.clone(), traced.clone()],
        runout,
        ..Measurements::nominal(shifted(teeth).design, Face::Front)
    };
    let put_in = with(RunoutStatement::Total(Runout {
        total_um: 20.0,
        high_tooth: Some(6.25),
    }));
    let gear = put_in.measure().unwrap();
    let read = measure(gear.as_built.most(), with_ball(5.25));
    let read = read.runout.unwrap();
    let um: Vec<f64> = read.deviations().iter().map(|mm| 1e3 * mm).collect();
    let readings = |profiles: bool| {
        let mut measurements = with(RunoutStatement::Readings(ProbeReadings {
            um: um.clone(),
            with: ReadWith::Ball(5.25),
        }));
        if !profiles {
            measurements.profiles = Default::default();
        }
        measurements.measure().unwrap().deviations
    };
    let found = readings(true);
    near("eccentricity", found.eccentricity, 0.01, 1e-8);
    near("high tooth", found.high_tooth, 6.25, 1e-5);
    let off = readings(false).eccentricity - 0.01;
    assert!(off.abs() > 1e-4, "{off}");
}

/// Source: the statement itself. Every span of the gear, and every dimension over pins in an even and an odd number of spaces, is as stated.
#[test]
fn a_stated_size_is_read_back() {
    let read = |teeth, thickness, profiles: &[Modification; 2], face, settings| {
        let measurements = Measurements {
            thickness,
            profiles: profiles.clone(),
            ..Measurements::nominal(shifted(teeth).design, face)
        };
        let gear = measurements.measure().unwrap();
        measure(gear.as_built.most(), settings)
    };
    for which in 0..7 {
        for (index, profiles) in sides(&profile(20, which)).into_iter().enumerate() {
            // 23.01 mm over 3 teeth is nominal; over 2 and 4 by base pitches.
            let pitch = shifted(20).design.basic_data.base_pitch();
            let k = 2 + (which + index) as u32 % 2;
            let mm = 23.1 + (f64::from(k) - 3.0) * pitch;
            let face = [Face::Front, Face::Back][which % 2];
            let statement = ThicknessStatement::Span {
                teeth: k,
                mm: Toleranced::Single(mm),
            };
            let found = read(20, statement, &profiles, face, with_span(k));
            for span in &found.spans.unwrap().readings {
                near((which, k), span.length, mm, span.error);
            }
        }
        for teeth in [20, 17] {
            for profiles in sides(&profile(teeth, which)) {
                let mm = f64::from(teeth) * 3.0 + 8.1;
                let statement = ThicknessStatement::OverPins {
                    body: MeasuringBody::Pin,
                    pin_mm: 5.25,
                    mm: Toleranced::Single(mm),
                };
                let settings = with_pin(5.25, None);
                let found = read(teeth, statement, &profiles, Face::Front, settings);
                for over in &found.pins.unwrap().two {
                    near((teeth, which), over.length, mm, over.error);
                }
            }
        }
    }
}

/// Spans all round, pitch of both flanks, traces of single teeth: each reading is read back. The flanks turn by what the readings say of each tooth;
/// the square of that turn is left out of the mean thickness, 0.1 nm.
#[test]
fn readings_of_each_tooth_are_read_back() {
    let teeth = 21;
    let wave = |amount: f64, order: f64| -> Vec<f64> {
        let angle = TAU / f64::from(teeth);
        let at = |i| amount * (order * angle * f64::from(i) + 0.3).sin();
        (0..teeth).map(at).collect()
    };
    let trace = |tooth: u32| {
        let each = (0..12).map(f64::from);
        let off = |k: f64| 0.002 * (f64::from(tooth) + k).sin();
        trace(Some(tooth), each.map(|k| (0.05 + 0.1 * k, off(k))))
    };
    let mut profiles = sides(&profile(teeth, 6))[0].clone();
    profiles[0].traces = vec![trace(3), trace(8), trace(17)];
    profiles[1].traces = vec![trace(5)];
    let (right, left) = (wave(6.0, 2.0), wave(5.0, 3.0));
    let spans = wave(0.004, 4.0).into_iter().map(|w| 23.2 + w);
    let spans: Vec<(u32, f64)> = (1..).zip(spans).collect();
    for face in [Face::Front, Face::Back] {
        let measurements = Measurements {
            thickness: ThicknessStatement::SpanReadings {
                teeth: 3,
                readings: spans.clone(),
                per_tooth: true,
            },
            pitch: Some(own_pitch(right.clone(), left.clone())),
            profiles: profiles.clone(),
            ..Measurements::nominal(shifted(teeth).design, face)
        };
        let gear = measurements.measure().unwrap();
        let read = measure(gear.as_built.most(), with_span(3));
        for (span, (first, mm)) in read.spans.unwrap().readings.iter().zip(&spans) {
            assert_eq!(span.first_tooth, *first);
            near((face, first), span.length, *mm, 1e-7);
        }
        // The same without thickness by tooth: then the pitch is read back.
        let even = Measurements {
            thickness: ThicknessStatement::Nominal,
            ..measurements
        };
        let gear = even.measure().unwrap();
        let pitch = measure(gear.as_built.most(), quick()).pitch_own.unwrap();
        let stated = Pitch::from_cumulative(&right, &left);
        for flank in Flank::BOTH {
            let read = pitch.cumulative.flank(flank).iter();
            for (read, um) in read.zip(stated.flank(flank)) {
                near(flank, *read, um / 1000.0, pitch.error);
            }
        }
    }
}
