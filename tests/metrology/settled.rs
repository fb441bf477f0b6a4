//! The deviations of a model are found again: mean thickness, each flank's place, eccentricity; and through a pair file the same gear, bit by bit.

use super::*;
use std::fmt::Write;

/// Closed form: a flank turns by `x/r`, against the numbers' sense on the front face.
fn check_flanks(gear: &MeasuredGear, truth: &Truth, within: f64) {
    let built = gear.as_built.most();
    let base = built.gear().base_thickness();
    near("base", base, truth.base_thickness, within);
    let r = built.gear().basic_data().reference_radius();
    for tooth in 1..=TEETH {
        let (right, left) = truth.flanks(tooth - 1, 0);
        for (side, stands) in [(Side::Right, right), (Side::Left, left)] {
            let found = -r * built.flank_offset(side, tooth);
            near((tooth, side), found, stands, within);
        }
    }
}

/// Spans and pitch are exact; a fork's closed form lacks terms of `e²/r`, 0.013 µm.
#[test]
fn spans_pitch_and_fork_give_the_gear_that_was_put_in() {
    let truth = Truth::new();
    let gear = measured(&truth.measurements());
    check_flanks(&gear, &truth, 1e-12);
    let deviations = &gear.deviations;
    near("e", deviations.eccentricity, ECCENTRICITY, 2e-5);
    near("high tooth", deviations.high_tooth, HIGH_TOOTH, 0.01);
    let e = gear.as_built.most().eccentricity();
    assert_eq!(gear.runout.total_um, 2000.0 * e);
    let readings = only(&gear, |finding| match finding {
        Finding::RunoutReadings(readings) => Some(*readings),
        _ => None,
    });
    assert_eq!(readings.knowledge, FlankKnowledge::Pitch);
    assert!(readings.flanks_taken_out && readings.left_um < 0.05);
    assert_eq!(readings.eccentricity.um, 1000.0 * deviations.eccentricity);
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
        near("e", note.in_pitch.um, 1000.0 * ECCENTRICITY, 0.02);
        near("high tooth", note.in_pitch.high_tooth, HIGH_TOOTH, 0.01);
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

/// The wheel of a pair file with `measurements`, its notes, and how many warnings and remarks it has.
fn through_a_file(measurements: &Measurements) -> (AsBuilt, GearNotes, usize) {
    let gear = "teeth = 21\nmodule_mm = 3.0\npressure_angle_deg = 20.0\ntip_diameter_mm = 69.0\n";
    let folder = tempfile::TempDir::new().unwrap();
    let mut wheel = gear.to_owned();
    let ThicknessStatement::SpanReadings { readings, .. } = &measurements.thickness else {
        unreachable!()
    };
    let mm: Vec<f64> = readings.iter().map(|(_, mm)| *mm).collect();
    let um = &measurements.per_tooth_um;
    let spans = format!("[wheel.thickness]\nspan.teeth = {SPANNED}\nspan.mm = {mm:?}");
    writeln!(wheel, "{spans}\nper_tooth_um = {um:?}").unwrap();
    let pitch = measurements.pitch.as_ref().unwrap();
    let axis = match (pitch.axis, pitch.eccentricity) {
        (PitchAxis::Own, _) => "axis = \"own\"",
        (_, Some(EccentricitySource::Pitch)) => "axis = \"datum\"\neccentricity = \"pitch\"",
        _ => "axis = \"datum\"\neccentricity = \"runout\"",
    };
    let (right, left) = (&pitch.right_um, &pitch.left_um);
    writeln!(wheel, "[wheel.pitch]\nkind = \"cumulative\"\n{axis}").unwrap();
    writeln!(
        wheel,
        "right_um = {right:?}\nleft_um = {left:?}\n[wheel.runout]"
    )
    .unwrap();
    match &measurements.runout {
        RunoutStatement::Readings(readings) => {
            let rows = (1..).zip(&readings.um);
            let rows: Vec<String> = rows.map(|(tooth, um)| format!("{tooth},{um:?}")).collect();
            let table = format!("tooth,runout (um)\n{}\n", rows.join("\n"));
            std::fs::write(folder.path().join("runout.csv"), table).unwrap();
            wheel += "file = \"runout.csv\"\nat = \"tooth\"\n";
        }
        RunoutStatement::Total {
            total_um,
            high_tooth: Some(high),
        } => writeln!(wheel, "total_um = {total_um:?}\nhigh_tooth = {high:?}").unwrap(),
        other => panic!("{other:?}"),
    }
    let path = folder.path().join("pair.toml");
    let rest = "[assembly]\ncenter_distance_mm = 63.2\n[sweep]\nmating = [[1, 1]]\n";
    std::fs::write(&path, format!("[wheel]\n{wheel}[pinion]\n{gear}{rest}")).unwrap();
    let file = gearlash_files::read(&path).unwrap_or_else(|error| panic!("{error}"));
    let told = file.warnings.len() + file.remarks.len();
    let (_, wheel, _) = file.study.materials[0].clone();
    (wheel, file.study.notes[0].clone(), told)
}

#[test]
fn a_pair_file_gives_the_same_gear_and_as_many_findings() {
    let truth = Truth::new();
    let per_tooth = Measurements {
        per_tooth_um: (0..21).map(|i| 0.5 * f64::from(i % 4)).collect(),
        ..truth.measurements()
    };
    let elsewhere = Measurements {
        runout: total(33.3, HIGH_TOOTH + 2.0),
        ..truth.about_datum(EccentricitySource::Runout)
    };
    for measurements in [
        truth.measurements(),
        per_tooth,
        truth.about_datum(EccentricitySource::Pitch),
        truth.about_datum(EccentricitySource::Runout),
        elsewhere,
    ] {
        let gear = measured(&measurements);
        let (built, notes, told) = through_a_file(&measurements);
        assert_eq!(gear.as_built.most(), &built);
        assert_eq!(gear.notes, notes);
        assert_eq!(gear.findings.len(), told, "{:#?}", gear.findings);
        assert!(!gear.findings.iter().any(Finding::is_in_order));
    }
}
