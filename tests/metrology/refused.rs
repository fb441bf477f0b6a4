//! Measurements that no gear has: all that is wrong with them, as values.

use super::{Truth, design};
use gearlash::error::GearError;
use gearlash::gear::{Face, MeasuringBody, thickness};
use gearlash::metrology::{
    CrossCheck, DeviationCause, EccentricitySource, Fits, MeasurementError, Measurements, Outlier,
    RunoutStatement, StatementRole, ThicknessStatement, Toleranced,
};

fn errors(measurements: &Measurements) -> Vec<MeasurementError> {
    measurements.measure().err().unwrap_or_default()
}

#[test]
fn every_list_must_have_one_number_a_tooth() {
    let wrong_length = |error: &MeasurementError| {
        matches!(
            error,
            MeasurementError::Pitch(GearError::WrongLength { found: 20, .. })
                | MeasurementError::PerTooth(GearError::WrongLength { found: 20, .. })
                | MeasurementError::Runout(GearError::WrongLength { found: 20, .. })
        )
    };
    let mut pitch = Truth::new().measurements();
    pitch.pitch.as_mut().unwrap().left_um.pop();
    let per_tooth = Measurements {
        per_tooth_um: vec![0.0; 20],
        ..Truth::new().measurements()
    };
    let mut runout = Truth::new().measurements();
    let RunoutStatement::Readings(readings) = &mut runout.runout else {
        unreachable!()
    };
    readings.um.pop();
    for measurements in [pitch, per_tooth, runout] {
        let errors = errors(&measurements);
        assert!(
            matches!(&errors[..], [one] if wrong_length(one)),
            "{errors:?}"
        );
    }
}

#[test]
fn what_is_no_number_or_no_range_is_refused() {
    let truth = Truth::new();
    let with = |change: &dyn Fn(&mut Measurements)| {
        let mut measurements = truth.measurements();
        change(&mut measurements);
        errors(&measurements)
    };
    let nan = f64::NAN;
    assert!(!with(&|m| m.pitch.as_mut().unwrap().right_um[3] = nan).is_empty());
    assert!(!with(&|m| m.per_tooth_um = vec![nan; 21]).is_empty());
    assert!(
        !with(&|m| {
            m.runout = RunoutStatement::Total {
                total_um: nan,
                high_tooth: Some(1.0),
            };
        })
        .is_empty()
    );
    assert!(
        !with(&|m| {
            m.runout = RunoutStatement::Total {
                total_um: 5.0,
                high_tooth: Some(22.0),
            };
        })
        .is_empty()
    );
    for statement in [
        ThicknessStatement::BaseThickness(Toleranced::Single(nan)),
        ThicknessStatement::AllowanceUm(Toleranced::Single(nan)),
        ThicknessStatement::AllowanceUm(Toleranced::Band {
            least: -20.0,
            most: -60.0,
        }),
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
        assert!(
            !with(&|m| m.thickness = statement.clone()).is_empty(),
            "{statement:?}"
        );
    }
}

/// All at once: a runout above the tooth depth (6.75 mm) and a cross-check over pins that lie deep in their spaces.
#[test]
fn several_errors_come_together() {
    let base = design().nominal_base_thickness();
    let over = thickness::pins_from_base(&design().basic_data, 0.5, base);
    let errors = errors(&Measurements {
        runout: RunoutStatement::Total {
            total_um: 9000.0,
            high_tooth: Some(1.0),
        },
        cross_check: Some(CrossCheck {
            statement: ThicknessStatement::OverPins {
                body: MeasuringBody::Pin,
                pin_mm: 0.5,
                mm: Toleranced::Single(over),
            },
            tolerance_um: 3.0,
        }),
        ..Measurements::nominal(design(), Face::Front)
    });
    match &errors[..] {
        [
            MeasurementError::RunoutBeyondDepth { depth_um },
            MeasurementError::OffInvolute {
                role: StatementRole::CrossCheck,
                fits: Fits::Pin(Some(pin)),
                ..
            },
        ] => {
            assert!((depth_um - 6750.0).abs() < 1e-6);
            assert!((4.0..8.0).contains(pin), "{pin}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_eccentricity_counts_once() {
    let truth = Truth::new();
    let mut twice = truth.about_datum(EccentricitySource::Pitch);
    twice.pitch.as_mut().unwrap().eccentricity = None;
    assert_eq!(errors(&twice), [MeasurementError::EccentricityTwice]);
    let mut none = truth.about_datum(EccentricitySource::Runout);
    none.runout = RunoutStatement::None;
    assert_eq!(errors(&none), [MeasurementError::NoRunout]);
    let mut own = truth.measurements();
    own.pitch.as_mut().unwrap().eccentricity = Some(EccentricitySource::Pitch);
    assert_eq!(errors(&own), [MeasurementError::NoEccentricityInOwnPitch]);
}

/// A span that was read 7 mm too large, most of a pitch: no tooth is that thick, and the reading is named.
#[test]
fn deviations_that_close_a_space_name_the_reading() {
    let mut measurements = Truth::new().measurements();
    let ThicknessStatement::SpanReadings { readings, .. } = &mut measurements.thickness else {
        unreachable!()
    };
    readings[11].1 += 7.0;
    match &errors(&measurements)[..] {
        [
            MeasurementError::Deviations {
                cause: DeviationCause::Spans,
                suspects,
                ..
            },
        ] => {
            let Some(Outlier::Reading(outlier)) = suspects.first() else {
                panic!("{suspects:?}")
            };
            assert_eq!(outlier.place, 12);
        }
        other => panic!("{other:?}"),
    }
}
