//! Good pair files: the content as read is the content as written, in either format.

mod deviations;
mod helical;
mod leads;
mod mutations;
mod poses;
mod published;
mod shafts;
mod stated;
mod thickness;

use crate::{echo, is_same};
use gearlash::analysis::extremes::{CycleExtremes, extremes};
use gearlash::analysis::study::{Material, Study};
use gearlash::contact::Method;
use gearlash::pair::Member;
use gearlash::population::{OutcomeKind, Tally};
use gearlash_files::tolerance::{ToleranceResult, ToleranceRun, read_tolerance};
use gearlash_files::{InputError, PairFile, read};
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A pair with a table for every key, to be cut and changed.
const PAIR: &str = include_str!("pair.toml");

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

fn go() -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Least and greatest backlash of the whole cycle.
fn of_study(study: &Study) -> CycleExtremes {
    extremes(study, Method::Exact { certify: false }, &go).unwrap()
}

/// A folder with files of these names and texts.
fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

/// All assemblies of a pair file with tolerances, none of which jams.
fn drawn_from(path: &Path) -> Result<ToleranceResult, InputError> {
    let file = read_tolerance(path)?;
    let run = ToleranceRun::new(&file, path, None, None).unwrap();
    let count = run.assemblies();
    let mut tally = Tally::default();
    for row in run.rows(1..count + 1, &go).unwrap() {
        assert_eq!(row.kind, OutcomeKind::Clear);
        tally.count(&row, count).unwrap();
    }
    Ok(run.result(tally, &go).unwrap())
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

/// JSON with the same keys is the same study, and so is the echo, a pair file of its own with every f64 the same.
#[test]
fn every_fixture_is_good_in_either_format() {
    assert!(fixtures().len() >= 20);
    for path in fixtures() {
        let study = read(&path).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(study.warnings, [""; 0], "{path:?}");
        assert!(!study.study.runs().unwrap().is_empty());
        let text = fs::read_to_string(&path).unwrap();
        let value: toml::Table = toml::from_str(&text).unwrap();
        let json = serde_json::to_string_pretty(&value).unwrap();
        // Without a telling extension the content decides; a byte order mark does not matter.
        for (extension, text) in [
            ("json", echo(&study).to_string()),
            ("json", json.clone()),
            ("pair", format!("\u{feff}\n{json}")),
            ("pair", format!("\u{feff}{text}")),
        ] {
            let again = read_as(&file_name(&path, extension), text);
            assert!(is_same(&again, &study), "{path:?}");
        }
    }
}

/// `tests/sessions/defaults.txt` has them as they are echoed.
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

/// Prose says centre, keys say center. `tests/sessions/along_face.txt` has both together.
#[test]
fn either_spelling_of_the_centre_distance() {
    let british = study(&PAIR.replace("center_distance_mm", "centre_distance_mm"));
    assert!(is_same(&british, &study(PAIR)));
}
