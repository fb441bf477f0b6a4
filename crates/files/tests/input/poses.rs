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
            assert_eq!(
                run.assembly.center_distance(),
                reference["center_distance_mm"]
            );
            assert_eq!(run.material.name(), reference["material"]);
            assert_eq!(mating.wheel_tooth, reference["wheel_tooth"]);
            assert_eq!(mating.pinion_tooth, reference["pinion_tooth"]);
            assert_eq!(mating.flank.name(), reference["flank"]);
            assert_eq!(mating.fraction, reference["fraction"]);
            let rotation = Pose::new(run.assembly.data().unwrap(), mating).locked_rotation();
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

#[test]
fn without_sweep_and_measured_one_wheel_revolution() {
    let study = study(PAIR);
    let expected = SweepPlan::Revolution {
        pitches: 20,
        steps_per_pitch: 16,
        start: (1, 1),
    };
    assert_eq!(study.study.sweep, Some(expected));
    assert_eq!(study.study.runs().unwrap()[0].matings.len(), 320);
}

/// lcm(20, 30) = 60.
#[test]
fn revolutions_as_asked() {
    let keys = "[sweep]\nrevolutions = \"hunting\"\nsteps_per_pitch = 2\nstart = [20, 30]";
    let expected = SweepPlan::Revolution {
        pitches: 60,
        steps_per_pitch: 2,
        start: (20, 30),
    };
    let study = study(&format!("{PAIR}{keys}"));
    assert_eq!(study.study.sweep, Some(expected));
    let matings = &study.study.runs().unwrap()[0].matings;
    assert_eq!(matings.len(), 120);
    assert_eq!((matings[0].wheel_tooth, matings[0].pinion_tooth), (20, 30));
    assert_eq!((matings[1].wheel_tooth, matings[1].fraction), (20, 0.5));
}

#[test]
fn a_sweep_beside_measured_rows_wins() {
    let text = fs::read_to_string("../../fixtures/karba_44x44.toml").unwrap();
    let text = text.replace("[assembly]", "[assembly]\ncenter_distance_mm = [132.5]")
        + "[sweep]\nmating = [[1, 2]]\n";
    let study = study(&text);
    assert_eq!(study.study.center_distances, [132.5]);
    assert_eq!(study.study.measured.len(), 36);
    assert_eq!(study.study.runs().unwrap()[0].matings.len(), 2);
    assert_eq!(study.warnings, [""; 0]);
}

/// Without [sweep] the measured rows say where: other centre distances are not run, and said to be not.
#[test]
fn centre_distances_beside_measured_rows() {
    let text = fs::read_to_string("../../fixtures/karba_44x44.toml").unwrap();
    let with = |list: &str| {
        study(&text.replace(
            "[assembly]",
            &format!("[assembly]\ncenter_distance_mm = {list}"),
        ))
    };
    let rows = [132.04, 132.09, 132.1, 132.15, 132.21];
    let same = with("[132.21, 132.15, 132.09, 132.04, 132.1]");
    assert_eq!(same.study.center_distances, rows);
    assert_eq!(same.warnings, [""; 0]);
    let other = with("132.21");
    assert_eq!(other.study.center_distances, rows);
    assert_eq!(other.warnings.len(), 1);
    assert!(other.warnings[0].starts_with("assembly.center_distance_mm is not used"));
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
        let echo = echo(&file);
        let echoed = echo["assembly"]["center_distance_mm"].as_object().unwrap();
        let written = written["band"].as_table().unwrap();
        assert_eq!(echoed.len(), written.len(), "{value}");
        for (key, value) in written {
            let number = value.as_float().or(value.as_integer().map(|i| i as f64));
            assert_eq!(echoed[key].as_f64(), number, "{key}");
        }
        assert!(
            is_same(&read_as("pair.json", echo.to_string()), &file),
            "{value}"
        );
        let other = file.at(vec![75.3]).unwrap();
        assert_eq!(other.study.band, None);
        let echo = super::echo(&other);
        assert_eq!(
            echo["assembly"]["center_distance_mm"],
            serde_json::json!([75.3])
        );
    }
    assert_eq!(with("[75.15, 75.25]").study.band, None);
}

/// Measured rows without [sweep] are run at their distances, not at those of a band.
#[test]
fn a_band_beside_measured_rows() {
    let text = fs::read_to_string("../../fixtures/karba_44x44.toml").unwrap();
    let band = "[assembly]\ncenter_distance_mm = { nominal_mm = 132.1, tolerance_um = 60 }";
    let study = study(&text.replace("[assembly]", band));
    assert_eq!(study.study.center_distances.len(), 5);
    assert_eq!(study.study.band, None);
    assert!(study.warnings[0].starts_with("assembly.center_distance_mm is not used"));
}
