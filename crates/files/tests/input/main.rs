//! Good pair files: the content as read is the content as written, in either format.

mod deviations;
mod helical;
mod leads;
mod measured_gears;
mod mutations;
mod poses;
mod published;
mod scatter_along_face;
mod shafts;
mod stated;
mod thickness;

use gearlash::analysis::study::Material;
use gearlash::pair::Member;
use gearlash_files::PairFile;
use gearlash_files::read;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A pair with a table for every key, to be cut and changed.
const PAIR: &str = r#"
title = "A pair"
[wheel]
teeth = 20
module_mm = 3.0
pressure_angle_deg = 20.0
[pinion]
teeth = 30
module_mm = 3.0
pressure_angle_deg = 20.0
[assembly]
center_distance_mm = 75.2
"#;

/// Reads `text` as a file called `name`; the rig's measured rows and the traces of a fixture lie beside it.
fn read_as(name: &str, text: impl AsRef<[u8]>) -> PairFile {
    let folder = TempDir::new().unwrap();
    for table in ["reference/karba_tables_5_6.csv", "profiled_44x44_trace.csv"] {
        let name = table.rsplit('/').next().unwrap();
        let table = format!("../../fixtures/{table}");
        fs::copy(table, folder.path().join(name)).unwrap();
    }
    let path = folder.path().join(name);
    fs::write(&path, text).unwrap();
    read(&path).unwrap_or_else(|error| panic!("{error}"))
}

fn study(text: &str) -> PairFile {
    read_as("pair.toml", text)
}

/// `PAIR` with `keys` added to `[wheel]`.
fn wheel(keys: &str) -> PairFile {
    study(&PAIR.replace("teeth = 20\n", &format!("teeth = 20\n{keys}\n")))
}

/// Every pair file of the repository.
fn fixtures() -> Vec<PathBuf> {
    let mut files = Vec::new();
    for folder in ["../../fixtures", "../../fixtures/reference/lost_motion"] {
        let entries = fs::read_dir(folder).unwrap();
        files.extend(
            entries
                .map(|entry| entry.unwrap().path())
                .filter(|path| path.extension().is_some_and(|e| e == "toml")),
        );
    }
    files.sort();
    files
}

fn file_name(path: &Path, extension: &str) -> String {
    let stem = path.file_stem().unwrap().to_str().unwrap();
    format!("{stem}.{extension}")
}

#[test]
fn every_fixture_is_good_and_gives_no_warning() {
    assert!(fixtures().len() >= 20);
    for path in fixtures() {
        let study = read(&path).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(study.warnings, [""; 0], "{}", path.display());
        assert!(!study.study.runs().unwrap().is_empty());
    }
}

#[test]
fn json_with_the_same_keys_gives_the_same_study() {
    for path in fixtures() {
        let text = fs::read_to_string(&path).unwrap();
        let value: toml::Table = toml::from_str(&text).unwrap();
        let json = serde_json::to_string_pretty(&value).unwrap();
        let from_toml = read(&path).unwrap();
        assert_eq!(read_as(&file_name(&path, "json"), &json), from_toml);
        // Without a telling extension the content decides; a byte order mark does not matter.
        let name = file_name(&path, "pair");
        assert_eq!(read_as(&name, format!("\u{feff}\n{json}")), from_toml);
        assert_eq!(read_as(&name, format!("\u{feff}{text}")), from_toml);
    }
}

/// The echo is a pair file of its own, every f64 the same.
#[test]
fn the_echo_read_back_gives_the_same_study() {
    for path in fixtures() {
        let study = read(&path).unwrap();
        let echo = serde_json::to_string(&study.spec).unwrap();
        let again = read_as(&file_name(&path, "json"), echo);
        assert!(again == study, "{}", path.display());
    }
}

#[test]
fn defaults_are_filled_in() {
    let study = study(&PAIR.replace("title = \"A pair\"\n", ""));
    assert_eq!(
        (study.study.title.as_str(), study.stem.as_str()),
        ("pair", "pair")
    );
    assert_eq!(study.study.locked, Member::Wheel);
    assert_eq!(study.study.center_distances, [75.2]);
    assert_eq!(study.study.bearing_clearance, 0.0);
    assert_eq!(study.study.chord, 0.01 / 1000.0);
    assert_eq!(study.study.tolerance_um, 0.1);
    assert!(!study.study.allow_off_line_contact);
    assert!(study.study.measured.is_empty());
    let materials: Vec<Material> = study.study.materials.iter().map(|m| m.0).collect();
    assert_eq!(materials, [Material::AsMeasured]);
    let expected = serde_json::json!({
        "title": "pair",
        "wheel": {
            "teeth": 20, "module_mm": 3.0, "pressure_angle_deg": 20.0, "profile_shift": 0.0,
            "reference_face": "front", "tip_diameter_mm": 66.0,
            "rack": { "addendum": 1.0, "dedendum": 1.25, "root_radius": 0.38 },
            "thickness": { "allowance_um": 0.0, "per_tooth_um": [] },
            "runout": { "total_um": 0.0 },
        },
        "pinion": {
            "teeth": 30, "module_mm": 3.0, "pressure_angle_deg": 20.0, "profile_shift": 0.0,
            "reference_face": "front", "tip_diameter_mm": 96.0,
            "rack": { "addendum": 1.0, "dedendum": 1.25, "root_radius": 0.38 },
            "thickness": { "allowance_um": 0.0, "per_tooth_um": [] },
            "runout": { "total_um": 0.0 },
        },
        "assembly": {
            "center_distance_mm": [75.2], "locked": "wheel",
            "bearing_clearance_mm": { "wheel": 0.0, "pinion": 0.0 },
        },
        "sweep": {
            "revolutions": "wheel", "extremes": "all_phases", "steps_per_pitch": 16, "start": [1, 1],
        },
        "accuracy": { "chord_um": 0.01 },
        "compare": { "tolerance_um": 0.1, "allow_off_line_contact": false },
    });
    assert_eq!(serde_json::to_value(&study.spec).unwrap(), expected);
}

#[test]
fn the_ends_of_every_range_are_good() {
    let gear = |teeth: u32, module: f64, angle: f64| {
        format!(
            "teeth = {teeth}\nmodule_mm = {module:?}\npressure_angle_deg = {angle:?}\n\
             rack = {{ addendum = 0.4, dedendum = 0.5, root_radius = 0.0 }}\nprofile_shift = 0.1\n"
        )
    };
    for (teeth, module, angle) in [(3, 0.01, 45.0), (10_000, 1000.0, 5.0), (3, 1000.0, 45.0)] {
        let gear = gear(teeth, module, angle);
        let distance = module * (f64::from(teeth) + 0.5);
        let study = study(&format!(
            "[wheel]\n{gear}[pinion]\n{gear}[assembly]\ncenter_distance_mm = {distance:?}\n\
             [sweep]\nmating = [[{teeth}, 1]]\nfraction = [-1000, 1000]\n\
             [accuracy]\nchord_um = 1e-5\n[compare]\ntolerance_um = 0\n"
        ));
        assert_eq!(study.study.runs().unwrap()[0].matings.len(), 4);
    }
    let steps =
        "[accuracy]\nchord_um = 100\n[sweep]\nrevolutions = \"hunting\"\nsteps_per_pitch = 1000";
    let study = study(&format!("{PAIR}{steps}"));
    assert_eq!(study.study.runs().unwrap()[0].matings.len(), 60_000);
    assert_eq!(study.study.chord, 0.1);
}

#[test]
fn every_other_key_is_taken_over() {
    let study = study(
        &(PAIR
            .replace(
                "[pinion]",
                "reference_face = \"back\"\ntip_diameter_mm = 65.5\nprofile_shift = 0.1\n[pinion]",
            )
            .replace(
                "75.2",
                "[75.3, 75.2]\nlocked = \"pinion\"\nbearing_clearance_mm = 0.01",
            )
            + "[accuracy]\nchord_um = 1\n[compare]\ntolerance_um = 0.5\nallow_off_line_contact = true"),
    );
    let (_, wheel, pinion) = &study.study.materials[0];
    assert_eq!(wheel.face(), gearlash::gear::Face::Back);
    assert_eq!(pinion.face(), gearlash::gear::Face::Front);
    assert_eq!(wheel.gear().tip_radius(), 32.75);
    assert_eq!(wheel.gear().design().profile_shift, 0.1);
    assert_eq!(study.study.locked, Member::Pinion);
    assert_eq!(study.study.center_distances, [75.2, 75.3]);
    assert_eq!(study.study.bearing_clearance, 0.02);
    assert_eq!(study.study.title, "A pair");
    assert_eq!(study.study.chord, 0.001);
    assert_eq!(study.study.tolerance_um, 0.5);
    assert!(study.study.allow_off_line_contact);
}

/// The pair file that docs/reference/pair-file.md shows.
#[test]
fn the_pair_file_of_the_docs_is_one() {
    let page = fs::read_to_string("../../docs/reference/pair-file.md").unwrap();
    let text = page
        .split("```toml")
        .skip(1)
        .find(|block| block.contains("[assembly]"))
        .unwrap()
        .split("```")
        .next()
        .unwrap();
    let study = study(text);
    assert_eq!(study.study.title, "My pair");
    assert_eq!(study.study.center_distances, [132.15, 132.21]);
    assert_eq!(study.study.materials.len(), 2);
    let is_slip =
        |warning: &String| warning.contains("meant") || warning.contains("check its sign");
    assert!(!study.warnings.iter().any(is_slip), "{:?}", study.warnings);
}

/// Prose says centre, keys say center: either spelling is read, but not both together.
#[test]
fn either_spelling_of_the_centre_distance() {
    let american = study(PAIR);
    let british = study(&PAIR.replace("center_distance_mm", "centre_distance_mm"));
    assert_eq!(american.study, british.study);
    assert_eq!(american.spec, british.spec);
    let both = PAIR.replace(
        "center_distance_mm",
        "centre_distance_mm = 75.2\ncenter_distance_mm",
    );
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pair.toml");
    fs::write(&file, both).unwrap();
    let error = gearlash_files::read(&file).unwrap_err().to_string();
    assert!(
        error
            .contains("assembly.center_distance_mm = 75.2: given together with centre_distance_mm"),
        "{error}"
    );
    let close = PAIR.replace("center_distance_mm = 75.2", "centre_distance_mm = 7.52");
    fs::write(&file, close).unwrap();
    let error = gearlash_files::read(&file).unwrap_err().to_string();
    assert!(
        error.contains("assembly.centre_distance_mm = 7.52"),
        "{error}"
    );
}
