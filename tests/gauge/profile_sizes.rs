//! Sizes over flanks whose profiles deviate: what was stated or read is read back.

use super::profile::{design, profile, sides};
use super::{measure, quick};
use gearlash::gauge::{Gauged, Settings};
use gearlash::gear::{Face, Flank, MeasuringBody, Modification, Pitch, Trace};
use gearlash::metrology::{
    Measurements, PitchKind, PitchSense, PitchStatement, ThicknessStatement, Toleranced,
};

fn stated(
    teeth: u32,
    thickness: ThicknessStatement,
    profiles: &[Modification; 2],
    face: Face,
) -> Gauged {
    let measurements = Measurements {
        thickness,
        profiles: profiles.clone(),
        ..Measurements::nominal(design(teeth), face)
    };
    let gear = measurements.measure().unwrap();
    let (span_teeth, pin) = match &measurements.thickness {
        ThicknessStatement::Span { teeth, .. } | ThicknessStatement::SpanReadings { teeth, .. } => {
            (Some(*teeth), None)
        }
        ThicknessStatement::OverPins { pin_mm, .. }
        | ThicknessStatement::PinReadings { pin_mm, .. } => (None, Some(*pin_mm)),
        _ => (None, None),
    };
    measure(
        gear.as_built.most(),
        Settings {
            span_teeth,
            pin,
            ..quick()
        },
    )
}

/// Source: the statement itself. Every span of the gear is the one that was stated.
#[test]
fn a_stated_span_is_read_back() {
    for which in 0..7 {
        for (index, profiles) in sides(&profile(20, which)).into_iter().enumerate() {
            // 23.01 mm over 3 teeth is nominal; over 2 and 4 by base pitches.
            let pitch = design(20).basic_data.base_pitch();
            let k = 2 + (which + index) as u32 % 2;
            let mm = 23.1 + (f64::from(k) - 3.0) * pitch;
            let face = [Face::Front, Face::Back][which % 2];
            let statement = ThicknessStatement::Span {
                teeth: k,
                mm: Toleranced::Single(mm),
            };
            let read = stated(20, statement, &profiles, face);
            let spans = read.spans.unwrap();
            for span in &spans.readings {
                let off = (span.length - mm).abs();
                assert!(off <= span.error, "{which} {k}: {off:e} {:e}", span.error);
            }
        }
    }
}

/// The same over pins, in an even and an odd number of spaces.
#[test]
fn a_stated_dimension_over_pins_is_read_back() {
    for teeth in [20, 17] {
        for which in 0..7 {
            for profiles in sides(&profile(teeth, which)) {
                let pin_mm = 5.25;
                let mm = f64::from(teeth) * 3.0 + 8.1;
                let statement = ThicknessStatement::OverPins {
                    body: MeasuringBody::Pin,
                    pin_mm,
                    mm: Toleranced::Single(mm),
                };
                let read = stated(teeth, statement, &profiles, Face::Front);
                let pins = read.pins.unwrap();
                for over in &pins.two {
                    let off = (over.length - mm).abs();
                    assert!(
                        off <= over.error,
                        "{teeth} {which}: {off:e} {:e}",
                        over.error
                    );
                }
            }
        }
    }
}

/// Spans and pins all round, pitch of both flanks, traces of single teeth: each reading is read back. The flanks turn by what the readings say
/// of each tooth, and touches
/// it elsewhere; the square of that turn is left out of the mean thickness, 0.1 nm.
#[test]
fn readings_of_each_tooth_are_read_back() {
    let teeth = 21;
    let wave = |amount: f64, order: f64| -> Vec<f64> {
        let angle = std::f64::consts::TAU / f64::from(teeth);
        let at = |i| amount * (order * angle * f64::from(i) + 0.3).sin();
        (0..teeth).map(at).collect()
    };
    let trace = |tooth: u32| Trace {
        tooth: Some(tooth),
        points: (0..12)
            .map(|k| {
                (
                    0.05 + 0.1 * f64::from(k),
                    0.002 * (f64::from(tooth) + f64::from(k)).sin(),
                )
            })
            .collect(),
    };
    let mut profiles = sides(&profile(teeth, 6))[0].clone();
    profiles[0].traces = vec![trace(3), trace(8), trace(17)];
    profiles[1].traces = vec![trace(5)];
    let (right, left) = (wave(6.0, 2.0), wave(5.0, 3.0));
    let spans: Vec<(u32, f64)> = (1..)
        .zip(wave(0.004, 4.0))
        .map(|(i, w)| (i, 23.2 + w))
        .collect();
    for face in [Face::Front, Face::Back] {
        let measurements = Measurements {
            thickness: ThicknessStatement::SpanReadings {
                teeth: 3,
                readings: spans.clone(),
                per_tooth: true,
            },
            pitch: Some(PitchStatement {
                kind: PitchKind::Cumulative,
                axis: gearlash::gear::PitchAxis::Own,
                sense: PitchSense::Numbers,
                eccentricity: None,
                right_um: right.clone(),
                left_um: left.clone(),
            }),
            profiles: profiles.clone(),
            ..Measurements::nominal(design(teeth), face)
        };
        let gear = measurements.measure().unwrap();
        let read = measure(
            gear.as_built.most(),
            Settings {
                span_teeth: Some(3),
                ..quick()
            },
        );
        for (span, (first, mm)) in read.spans.unwrap().readings.iter().zip(&spans) {
            assert_eq!(span.first_tooth, *first);
            let off = (span.length - mm).abs();
            assert!(off <= 1e-7, "{face:?} at {first}: {off:e}");
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
            let pairs = pitch
                .cumulative
                .flank(flank)
                .iter()
                .zip(stated.flank(flank));
            for (read, um) in pairs {
                assert!((read - um / 1000.0).abs() <= pitch.error, "{read} {um}");
            }
        }
    }
}
