//! The deviations of a model are found again: mean thickness, each flank's place, eccentricity.

use super::{ECCENTRICITY, HIGH_TOOTH, SPANNED, TEETH, Truth, measured, only};
use gearlash::gear::Side;
use gearlash::metrology::{EccentricitySource, Finding, FlankKnowledge, MeasuredGear};

/// Closed form: a flank turns by `x/r`, against the numbers' sense on the front face.
fn check_flanks(gear: &MeasuredGear, truth: &Truth, within: f64) {
    let built = gear.as_built.most();
    let base = built.gear().base_thickness();
    assert!((base - truth.base_thickness).abs() < within, "{base}");
    let r = built.gear().basic_data().reference_radius();
    for tooth in 1..=TEETH {
        let (right, left) = truth.flanks(tooth - 1, 0);
        for (side, stands) in [(Side::Right, right), (Side::Left, left)] {
            let found = -r * built.flank_offset(side, tooth);
            assert!(
                (found - stands).abs() < within,
                "{tooth} {side:?}: {found}, {stands}"
            );
        }
    }
}

/// Spans and pitch are exact; a fork's closed form lacks terms of `e²/r`, 0.013 µm.
#[test]
fn spans_pitch_and_fork_give_the_gear_that_was_put_in() {
    let truth = Truth::new();
    let gear = measured(&truth.measurements());
    check_flanks(&gear, &truth, 1e-12);
    assert!((gear.deviations.eccentricity - ECCENTRICITY).abs() < 2e-5);
    assert!((gear.deviations.high_tooth - HIGH_TOOTH).abs() < 0.01);
    assert_eq!(
        gear.runout.total_um,
        2000.0 * gear.as_built.most().eccentricity()
    );
    let readings = only(&gear, |finding| match finding {
        Finding::RunoutReadings(readings) => Some(*readings),
        _ => None,
    });
    assert_eq!(readings.knowledge, FlankKnowledge::Pitch);
    assert!(readings.flanks_taken_out && readings.left_um < 0.05);
    assert_eq!(
        readings.eccentricity.um,
        1000.0 * gear.deviations.eccentricity
    );
    // Spans over 3 of 21 teeth close to one cycle of 21.
    let growth = only(&gear, |finding| match finding {
        Finding::SpansGiveEachTooth {
            spanned: SPANNED,
            teeth: TEETH,
            amplification,
            with_pitch: true,
        } => Some(*amplification),
        _ => None,
    });
    assert_eq!(growth, 21);
    assert_eq!(gear.findings.len(), 2, "{:#?}", gear.findings);
}

/// The closed form of the datum pitch lacks terms of `e²/r`, 0.013 µm; spans carry them into the teeth 21-fold at worst.
#[test]
fn mean_thickness_and_eccentricity_of_datum_pitch_settle_together() {
    let truth = Truth::new();
    for counts in [EccentricitySource::Pitch, EccentricitySource::Runout] {
        let gear = measured(&truth.about_datum(counts));
        check_flanks(&gear, &truth, 1e-4);
        let note = gear.notes.eccentricity.unwrap();
        assert!((note.in_pitch.um - 1000.0 * ECCENTRICITY).abs() < 0.02);
        assert!((note.in_pitch.high_tooth - HIGH_TOOTH).abs() < 0.01);
        assert!(note.difference_um.unwrap() < 0.05);
        let said = only(&gear, |finding| match finding {
            Finding::EccentricityInPitch(note) => Some(*note),
            _ => None,
        });
        assert_eq!(said, note);
        let counted = gear.deviations.eccentricity;
        match counts {
            EccentricitySource::Pitch => assert_eq!(counted, note.in_pitch.um / 1000.0),
            EccentricitySource::Runout => assert_eq!(counted, ECCENTRICITY),
        }
    }
}
