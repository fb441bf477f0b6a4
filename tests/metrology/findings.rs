//! Findings and their numbers. Source of each: what was done to the data before.

use super::*;

#[test]
fn left_flanks_that_were_read_as_material_are_found_reversed() {
    let mut measurements = Truth::new().measurements();
    let pitch = measurements.pitch.as_mut().unwrap();
    pitch.left_um.iter_mut().for_each(|um| *um = -*um);
    let gear = measured(&measurements);
    let eccentricity = only(&gear, |finding| match finding {
        Finding::LeftFlankReversed { eccentricity_um } => Some(*eccentricity_um),
        _ => None,
    });
    // About its own axis it holds none.
    assert_eq!(eccentricity, None);
}

/// A pitch value of tooth 9 typed 150 µm off, whose neighbours' mean has nothing of it; a thimble line of 10 µm at the span
/// of tooth 5.
#[test]
fn outliers_are_named_with_their_distance() {
    let mut measurements = Truth::new().measurements();
    let pitch = measurements.pitch.as_mut().unwrap();
    let (before, at, after) = (pitch.right_um[7], pitch.right_um[8], pitch.right_um[9]);
    pitch.right_um[8] += 150.0;
    let gear = measured(&measurements);
    let outlier = only(&gear, |finding| match finding {
        Finding::Outlier(Outlier::Pitch(outlier)) => Some(*outlier),
        _ => None,
    });
    assert_eq!((outlier.flank, outlier.tooth), (Flank::Right, 9));
    assert!(outlier.from_neighbours && outlier.um == at + 150.0);
    let off = at + 150.0 - (before + after) / 2.0;
    near("off", outlier.off_um, off, 1e-9);

    // Without the pitch the spans vary by some ten µm themselves: judged among equal ones.
    let ThicknessStatement::SpanReadings { readings, .. } = &mut measurements.thickness else {
        unreachable!()
    };
    for (tooth, mm) in readings.iter_mut() {
        *mm = if *tooth == 5 { 23.010 } else { 23.0 };
    }
    let alone = Measurements {
        pitch: None,
        runout: RunoutStatement::None,
        ..measurements
    };
    let outlier = only(&measured(&alone), |finding| match finding {
        Finding::Outlier(Outlier::Reading(outlier)) => Some(*outlier),
        _ => None,
    });
    assert_eq!((outlier.place, outlier.readings), (5, 21));
    near("off", outlier.off_um, 10.0, 1e-6);
    assert_eq!(outlier.median_mm, 23.0);
    assert!(!outlier.flanks_taken_out && !outlier.over_pins);
}

/// Two base thicknesses of one gear, 5 µm apart; an allowance of 0.04 where −40 µm was meant.
#[test]
fn a_thickness_stated_twice_is_compared() {
    let truth = Truth::new();
    let cross = |statement: ThicknessStatement| Measurements {
        cross_check: Some(CrossCheck {
            statement,
            tolerance_um: CrossCheck::TOLERANCE_UM,
        }),
        ..truth.measurements()
    };
    for (more, is_in_order) in [(0.005, false), (0.002, true)] {
        let mm = Toleranced::Single(truth.base_thickness + more);
        let gear = measured(&cross(ThicknessStatement::BaseThickness(mm)));
        let (compared, in_order) = only(&gear, |finding| match finding {
            Finding::ThicknessStatedTwice(compared) => Some((*compared, finding.is_in_order())),
            _ => None,
        });
        near(more, compared.difference_um, 1e3 * more, 1e-6);
        assert_eq!(in_order, is_in_order);
    }

    let ThicknessStatement::SpanReadings { readings, .. } = truth.spans() else {
        unreachable!()
    };
    let mean = readings.iter().map(|(_, mm)| mm).sum::<f64>() / 21.0;
    let span = ThicknessStatement::Span {
        teeth: 3,
        mm: Toleranced::Single(mean),
    };
    let kind = only(&measured(&cross(span)), |finding| match finding {
        Finding::CrossCheckOfSameKind(kind) => Some(*kind),
        _ => None,
    });
    assert_eq!(kind, SameKind::Span);
}

#[test]
fn an_allowance_of_the_other_sign_is_doubted() {
    let stated = ThicknessStatement::AllowanceUm(Toleranced::Single(0.04));
    let gear = measured(&with_thickness(stated));
    assert_eq!(gear.findings, [Finding::AllowanceThickens { um: 0.04 }]);
}

/// Δs = F_R − F_L (design section 6), stated as per-tooth thickness beside the pitch it comes from.
#[test]
fn thickness_that_the_pitch_states_too_is_found_twice() {
    let mut measurements = Truth::new().measurements();
    let pitch = measurements.pitch.as_ref().unwrap();
    let both = pitch.right_um.iter().zip(&pitch.left_um);
    measurements.per_tooth_um = both.map(|(right, left)| right - left).collect();
    for expected in [ThicknessBesidePitch::Same, ThicknessBesidePitch::TakenBack] {
        let twice = only(&measured(&measurements), |finding| match finding {
            Finding::ThicknessBesidePitch(twice) => Some(*twice),
            _ => None,
        });
        assert_eq!(twice, expected);
        let each = measurements.per_tooth_um.iter_mut();
        each.for_each(|um| *um *= -1.0);
    }
}

/// Datum-axis pitch declared as own-axis, with its runout; and own-axis pitch declared as datum-axis, with 30 µm more
/// of a first harmonic on both flanks.
#[test]
fn the_first_harmonic_of_pitch_tells_its_axis() {
    let truth = Truth::new();
    let mut own = truth.about_datum(EccentricitySource::Pitch);
    let pitch = own.pitch.as_mut().unwrap();
    (pitch.axis, pitch.eccentricity) = (PitchAxis::Own, None);
    let (in_pitch, runout) = only(&measured(&own), |finding| match finding {
        Finding::OwnPitchHoldsEccentricity {
            in_pitch, runout, ..
        } => Some((*in_pitch, *runout)),
        _ => None,
    });
    near("in pitch", in_pitch.um, 20.0, 0.05);
    assert_eq!(runout, RunoutSource::Total);

    let mut alike = truth.measurements();
    alike.runout = RunoutStatement::None;
    let pitch = alike.pitch.as_mut().unwrap();
    pitch.axis = PitchAxis::Datum;
    for list in [&mut pitch.right_um, &mut pitch.left_um] {
        for (index, um) in list.iter_mut().enumerate() {
            *um += 30.0 * (TAU * index as f64 / 21.0).cos();
        }
    }
    let (left, alike) = only(&measured(&alike), |finding| match finding {
        Finding::FirstHarmonicNotEccentricity { left_um, alike, .. } => Some((*left_um, *alike)),
        _ => None,
    });
    // A wave that moves both flanks equally leaves sin (α − s/d) of its amplitude, s/d = π/(2 z) less the allowance.
    let basic_data = design().basic_data;
    let alpha = basic_data.pressure_angle();
    let half = truth.base_thickness / (2.0 * basic_data.base_radius()) - inv(alpha);
    near("left", left, 30.0 * (alpha - half).sin(), 0.05);
    assert!(alike);
}
