//! The same data through a pair file: the same gear, bit by bit.

use super::{HIGH_TOOTH, Truth, measured};
use gearlash::gear::{AsBuilt, PitchAxis};
use gearlash::metrology::{
    EccentricitySource, Finding, GearNotes, Measurements, RunoutStatement, ThicknessStatement,
};
use std::fmt::Write;
use tempfile::TempDir;

/// The wheel of a pair file with `measurements`, its notes, and how many warnings and remarks it has.
fn through_a_file(measurements: &Measurements) -> (AsBuilt, GearNotes, usize) {
    let gear = "teeth = 21\nmodule_mm = 3.0\npressure_angle_deg = 20.0\ntip_diameter_mm = 69.0\n";
    let folder = TempDir::new().unwrap();
    let mut wheel = gear.to_owned();
    if let ThicknessStatement::SpanReadings {
        teeth, readings, ..
    } = &measurements.thickness
    {
        let mm: Vec<f64> = readings.iter().map(|(_, mm)| *mm).collect();
        writeln!(
            wheel,
            "[wheel.thickness]\nspan.teeth = {teeth}\nspan.mm = {mm:?}"
        )
        .unwrap();
        let um = &measurements.per_tooth_um;
        if !um.is_empty() {
            writeln!(wheel, "per_tooth_um = {um:?}").unwrap();
        }
    }
    if let Some(pitch) = &measurements.pitch {
        let axis = match pitch.axis {
            PitchAxis::Own => "own",
            PitchAxis::Datum => "datum",
        };
        writeln!(
            wheel,
            "[wheel.pitch]\nkind = \"cumulative\"\naxis = {axis:?}"
        )
        .unwrap();
        writeln!(
            wheel,
            "right_um = {:?}\nleft_um = {:?}",
            pitch.right_um, pitch.left_um
        )
        .unwrap();
        let counts = match pitch.eccentricity {
            Some(EccentricitySource::Pitch) => "eccentricity = \"pitch\"\n",
            Some(EccentricitySource::Runout) => "eccentricity = \"runout\"\n",
            None => "",
        };
        wheel += counts;
    }
    wheel += "[wheel.runout]\n";
    match &measurements.runout {
        RunoutStatement::None => {}
        RunoutStatement::Total {
            total_um,
            high_tooth,
        } => {
            writeln!(wheel, "total_um = {total_um:?}").unwrap();
            if let Some(high_tooth) = high_tooth {
                writeln!(wheel, "high_tooth = {high_tooth:?}").unwrap();
            }
        }
        RunoutStatement::Readings(readings) => {
            let mut table = "tooth,runout (um)\n".to_owned();
            for (tooth, um) in (1..).zip(&readings.um) {
                writeln!(table, "{tooth},{um:?}").unwrap();
            }
            std::fs::write(folder.path().join("runout.csv"), table).unwrap();
            wheel += "file = \"runout.csv\"\nat = \"tooth\"\n";
        }
    }
    let path = folder.path().join("pair.toml");
    let text = format!(
        "[wheel]\n{wheel}[pinion]\n{gear}[assembly]\ncenter_distance_mm = 63.2\n[sweep]\nmating = [[1, 1]]\n"
    );
    std::fs::write(&path, text).unwrap();
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
        runout: RunoutStatement::Total {
            total_um: 33.3,
            high_tooth: Some(HIGH_TOOTH + 2.0),
        },
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
