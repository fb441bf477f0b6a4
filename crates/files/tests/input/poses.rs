//! Which poses are run, and where they stand.

use super::*;
use gearlash::pair::{Pose, SweepPlan};
use serde_json::Value;
use std::f64::consts::TAU;

/// The 126 poses of the reference data, in their order, and the wheel's rotation at each (1e-12 rad):
/// it takes teeth, face, thickness and centre distance to get it right.
#[test]
fn matings_of_the_reference_poses() {
    let mut poses = 0;
    for path in fixtures() {
        let Ok(text) = fs::read_to_string(path.with_extension("json")) else {
            continue;
        };
        let reference: Vec<Value> = serde_json::from_str(&text).unwrap();
        let runs = read(&path).unwrap().study.runs().unwrap();
        let ours = runs
            .iter()
            .flat_map(|run| run.matings.iter().map(move |mating| (run, *mating)));
        assert_eq!(ours.clone().count(), reference.len());
        for ((run, mating), reference) in ours.zip(&reference) {
            let distance = run.run.assembly.center_distance();
            assert_eq!(distance, reference["center_distance_mm"]);
            assert_eq!(run.run.material.name(), reference["material"]);
            assert_eq!(mating.wheel_tooth, reference["wheel_tooth"]);
            assert_eq!(mating.pinion_tooth, reference["pinion_tooth"]);
            assert_eq!(mating.flank.name(), reference["flank"]);
            assert_eq!(mating.fraction, reference["fraction"]);
            let rotation = Pose::new(run.run.assembly.data().unwrap(), mating).locked_rotation();
            let expected = reference["wheel_rotation_rad"].as_f64().unwrap();
            let turns = (rotation - expected) / TAU;
            assert!(
                (turns - turns.round()).abs() * TAU < 1e-12,
                "{}",
                path.display()
            );
            poses += 1;
        }
    }
    assert_eq!(poses, 126);
}

/// One wheel revolution without [sweep], or as asked: lcm(20, 30) = 60.
#[test]
fn revolutions_as_asked() {
    let keys = "[sweep]\nrevolutions = \"hunting\"\nsteps_per_pitch = 2\nstart = [20, 30]";
    for (keys, pitches, steps_per_pitch, start) in [("", 20, 16, (1, 1)), (keys, 60, 2, (20, 30))] {
        let study = study(&format!("{PAIR}{keys}")).study;
        let expected = SweepPlan::Revolution {
            pitches,
            steps_per_pitch,
            start,
        };
        assert_eq!(study.sweep, Some(expected));
        let matings = &study.runs().unwrap()[0].matings;
        assert_eq!(matings.len() as u64, pitches * u64::from(steps_per_pitch));
        assert_eq!((matings[0].wheel_tooth, matings[0].pinion_tooth), start);
        let second = (matings[1].wheel_tooth, matings[1].fraction);
        assert_eq!(second, (start.0, 1.0 / f64::from(steps_per_pitch)));
    }
}

/// Without [sweep] the measured rows say where: other centre distances, or a band of them, are not run, and said to be not.
#[test]
fn centre_distances_beside_measured_rows() {
    let text = fs::read_to_string("../../fixtures/karba_44x44.toml").unwrap();
    let with = |stated: &str, more: &str| {
        let keys = format!("[assembly]\ncenter_distance_mm = {stated}");
        study(&(text.replace("[assembly]", &keys) + more))
    };
    let rows = [132.04, 132.09, 132.1, 132.15, 132.21];
    for (stated, is_used) in [
        ("[132.21, 132.15, 132.09, 132.04, 132.1]", true),
        ("132.21", false),
        ("{ nominal_mm = 132.1, tolerance_um = 60 }", false),
    ] {
        let file = with(stated, "");
        assert_eq!(file.study.center_distances, rows, "{stated}");
        assert_eq!(file.study.band, None);
        let unused = "assembly.center_distance_mm is not used";
        let is_said = |warning: &String| warning.starts_with(unused);
        assert_eq!(file.warnings.len(), usize::from(!is_used), "{stated}");
        assert!(file.warnings.iter().all(is_said), "{:?}", file.warnings);
    }
    let swept = with("[132.5]", "[sweep]\nmating = [[1, 2]]\n");
    assert_eq!(swept.study.center_distances, [132.5]);
    assert_eq!(swept.study.measured.len(), 36);
    assert_eq!(swept.study.runs().unwrap()[0].matings.len(), 2);
    assert_eq!(swept.warnings, [""; 0]);
}

/// A spreadsheet's CSV: columns in another order, carriage returns, quotes, blank lines; a German one; one without the sources.
#[test]
fn measured_columns_in_any_order() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("pair.toml");
    let text = PAIR.replace("center_distance_mm = 75.2", "") + "[measured]\nfile = \"rig.csv\"";
    fs::write(&path, text).unwrap();
    let csv = "\u{feff}source, predicted_max_um ,predicted_min_um,measured_left_um,measured_right_um,\
               pinion_tooth,wheel_tooth,center_distance_mm\r\n\r\n\"rig, 2nd\",171.7,149.3,155,159,12,11,75.2\r\n";
    let one = csv.replace("rig, 2nd", "rig");
    let german = one.replace(',', ";").replace('.', ",");
    let without = one.replace("source,", "").replace("\"rig\",", "");
    for (csv, source) in [(csv, "rig, 2nd"), (&german, "rig"), (&without, "")] {
        fs::write(folder.path().join("rig.csv"), csv).unwrap();
        let study = read(&path).unwrap_or_else(|error| panic!("{error}"));
        let [row] = &study.study.measured[..] else {
            panic!("one row");
        };
        let teeth = (row.wheel_tooth, row.pinion_tooth);
        assert_eq!((row.center_distance, teeth), (75.2, (11, 12)));
        assert_eq!((row.right_um, row.left_um), (159.0, 155.0));
        let predicted = (row.predicted_min_um, row.predicted_max_um);
        assert_eq!((predicted, &row.source[..]), ((149.3, 171.7), source));
    }
}

/// The least, the nominal and the greatest distance, in f64 what one would write; a nominal outside its band is not in it.
#[test]
fn a_band_of_centre_distances() {
    let with = |value: &str| study(&PAIR.replace("mm = 75.2", &format!("mm = {value}")));
    for (value, distances) in [
        (
            "{ nominal_mm = 75.2, tolerance_um = 50 }",
            &[75.15, 75.2, 75.25][..],
        ),
        (
            "{ nominal_mm = 75.2, upper_um = 30.0, lower_um = -10 }",
            &[75.19, 75.2, 75.23],
        ),
        (
            "{ nominal_mm = 75.2, upper_um = 0, lower_um = -10 }",
            &[75.19, 75.2],
        ),
        (
            "{ nominal_mm = 75.2, upper_um = 30, lower_um = 10 }",
            &[75.21, 75.23],
        ),
        ("{ nominal_mm = 75.2, tolerance_um = 0 }", &[75.2]),
    ] {
        let file = with(value);
        assert_eq!(file.study.center_distances, distances, "{value}");
        let band = [distances[0], distances[distances.len() - 1]];
        assert_eq!(file.study.band, Some(band), "{value}");
        // The echo keeps what was written, and reads back as the same.
        let written: toml::Table = toml::from_str(&format!("band = {value}")).unwrap();
        let written = written["band"].as_table().unwrap().iter();
        let number = |value: &toml::Value| value.to_string().parse::<f64>().unwrap();
        let written: serde_json::Map<String, Value> = written
            .map(|(key, value)| (key.clone(), number(value).into()))
            .collect();
        let echo = echo(&file);
        let stated = |echo: &Value| echo["assembly"]["center_distance_mm"].clone();
        assert_eq!(stated(&echo), Value::Object(written));
        let again = read_as("pair.json", echo.to_string());
        assert!(is_same(&again, &file), "{value}");
        let other = file.at(vec![75.3]).unwrap();
        assert_eq!(other.study.band, None);
        assert_eq!(stated(&super::echo(&other)), serde_json::json!([75.3]));
    }
    assert_eq!(with("[75.15, 75.25]").study.band, None);
}
