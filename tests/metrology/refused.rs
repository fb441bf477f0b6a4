//! Measurements that no gear has: all that is wrong with them, as values.

use super::*;
use gearlash::metrology::MeasurementError as Wrong;

const TEETH: u32 = 21;

fn design() -> GearDesign {
    spur(TEETH, 3.0).tip_diameter(69.0).design
}

fn total(total_um: f64, high_tooth: f64) -> RunoutStatement {
    RunoutStatement::Total(Runout {
        total_um,
        high_tooth: Some(high_tooth),
    })
}

/// A perfect gear by spans over three teeth all round, pitch about its own axis, and runout by a fork.
fn measurements() -> Measurements {
    let base = design().nominal_base_thickness();
    let span = thickness::span_from_base(&design().basic_data, 3, base);
    let none = || vec![0.0; TEETH as usize];
    Measurements {
        thickness: ThicknessStatement::SpanReadings {
            teeth: 3,
            readings: (1..=TEETH).map(|tooth| (tooth, span)).collect(),
            per_tooth: true,
        },
        pitch: Some(PitchStatement {
            kind: PitchKind::Cumulative,
            axis: PitchAxis::Own,
            sense: PitchSense::Numbers,
            eccentricity: None,
            right_um: none(),
            left_um: none(),
        }),
        runout: RunoutStatement::Readings(ProbeReadings {
            um: none(),
            with: ReadWith::Fork,
        }),
        ..Measurements::nominal(design(), Face::Front)
    }
}

fn errors(measurements: &Measurements) -> Vec<MeasurementError> {
    measurements.measure().err().unwrap_or_default()
}

/// The errors of good measurements after a change.
fn after(change: impl Fn(&mut Measurements)) -> Vec<MeasurementError> {
    let mut measurements = measurements();
    assert_eq!(errors(&measurements), []);
    change(&mut measurements);
    errors(&measurements)
}

#[test]
fn every_list_must_have_one_number_a_tooth() {
    let is_short = |error: &MeasurementError| {
        let (Wrong::Pitch(error) | Wrong::PerTooth(error) | Wrong::Runout(error)) = error else {
            return false;
        };
        matches!(error, GearError::WrongLength { found: 20, .. })
    };
    let changes: [fn(&mut Measurements); 3] = [
        |all| all.pitch.as_mut().unwrap().left_um.truncate(20),
        |all| all.per_tooth_um = vec![0.0; 20],
        |all| {
            if let RunoutStatement::Readings(readings) = &mut all.runout {
                readings.um.truncate(20);
            }
        },
    ];
    for (k, change) in changes.into_iter().enumerate() {
        let errors = after(change);
        assert!(errors.len() == 1 && is_short(&errors[0]), "{k}: {errors:?}");
    }
}

#[test]
fn what_is_no_number_or_no_range_is_refused() {
    let nan = f64::NAN;
    assert!(!after(|all| all.pitch.as_mut().unwrap().right_um[3] = nan).is_empty());
    assert!(!after(|all| all.per_tooth_um = vec![nan; 21]).is_empty());
    for runout in [total(nan, 1.0), total(5.0, 22.0)] {
        assert!(!after(|all| all.runout = runout.clone()).is_empty());
    }
    let upside_down = Toleranced::Band {
        least: -20.0,
        most: -60.0,
    };
    for statement in [
        ThicknessStatement::BaseThickness(Toleranced::Single(nan)),
        ThicknessStatement::AllowanceUm(Toleranced::Single(nan)),
        ThicknessStatement::AllowanceUm(upside_down),
        ThicknessStatement::Span {
            teeth: 0,
            mm: Toleranced::Single(23.0),
        },
        ThicknessStatement::SpanReadings {
            teeth: 3,
            readings: vec![(1, nan)],
            per_tooth: true,
        },
        ThicknessStatement::PinReadings {
            body: MeasuringBody::Pin,
            pin_mm: 5.25,
            readings: Vec::new(),
        },
    ] {
        let errors = after(|all| all.thickness = statement.clone());
        assert!(!errors.is_empty(), "{statement:?}");
    }
}

/// All at once: a runout above the tooth depth (6.75 mm) and a cross-check over pins that lie deep in their spaces.
#[test]
fn several_errors_come_together() {
    let base = design().nominal_base_thickness();
    let over = thickness::pins_from_base(&design().basic_data, 0.5, base);
    let statement = ThicknessStatement::OverPins {
        body: MeasuringBody::Pin,
        pin_mm: 0.5,
        mm: Toleranced::Single(over),
    };
    let errors = errors(&Measurements {
        runout: total(9000.0, 1.0),
        cross_check: Some(CrossCheck {
            statement,
            tolerance_um: 3.0,
        }),
        ..Measurements::nominal(design(), Face::Front)
    });
    let [
        Wrong::RunoutBeyondDepth { depth_um },
        Wrong::OffInvolute {
            role: StatementRole::CrossCheck,
            fits: Fits::Pin(Some(pin)),
            ..
        },
    ] = &errors[..]
    else {
        panic!("{errors:?}");
    };
    near("depth", *depth_um, 6750.0, 1e-6);
    assert!((4.0..8.0).contains(pin), "{pin}");
}

/// A span that was read 7 mm too large, most of a pitch: no tooth is that thick, and the reading is named.
#[test]
fn deviations_that_close_a_space_name_the_reading() {
    let errors = after(|all| {
        if let ThicknessStatement::SpanReadings { readings, .. } = &mut all.thickness {
            readings[11].1 += 7.0;
        }
    });
    let [
        Wrong::Deviations {
            cause, suspects, ..
        },
    ] = &errors[..]
    else {
        panic!("{errors:?}");
    };
    let Some(Outlier::Reading(outlier)) = suspects.first() else {
        panic!("{suspects:?}")
    };
    assert_eq!((*cause, outlier.place), (DeviationCause::Spans, 12));
}
