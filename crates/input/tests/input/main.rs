//! Good pair files: the content as read is the content as written, in either format.

mod mutations;
mod poses;
mod published;

use crate::{echo, is_same};
use gearlash::analysis::study::Material;
use gearlash::pair::Member;
use gearlash_input::{PairFile, read};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A pair with a table for every key, to be cut and changed.
const PAIR: &str = include_str!("pair.toml");

/// Reads `text` as a file called `name`; the tables of fixtures lie beside it.
fn read_as(name: &str, text: impl AsRef<[u8]>) -> PairFile {
    let folder = TempDir::new().unwrap();
    for table in ["karba_tables_5_6.csv", "profiled_44x44_trace.csv"] {
        let from = format!("../../fixtures/{table}");
        fs::copy(from, folder.path().join(table)).unwrap();
    }
    let path = folder.path().join(name);
    fs::write(&path, text).unwrap();
    read(&path).unwrap_or_else(|error| panic!("{error}"))
}

fn study(text: &str) -> PairFile {
    read_as("pair.toml", text)
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
            let name = path.with_extension(extension);
            let again = read_as(name.file_name().unwrap().to_str().unwrap(), text);
            assert!(is_same(&again, &study), "{path:?}");
        }
    }
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
    assert_eq!(study.study.chordal_error, 0.1);
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
