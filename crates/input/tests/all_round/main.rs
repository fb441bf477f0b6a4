//! Thickness from readings all round, eccentricity from pitch, and data that contradict what the file says of them.

#[allow(dead_code)] // campaigns use the rest
#[path = "../../../../tests/common/campaign/random.rs"]
mod random;
#[allow(dead_code)] // the other property tests use the rest
#[path = "../../../../tests/common/random_pair.rs"]
mod random_pair;

mod contradictions;
mod datum;
mod pins;
mod reversed_flanks;
mod runout;
mod spans;

use crate::{echo, is_same};
use gearlash::gear::{AsBuilt, Flank, Side};
use gearlash_input::PairFile;
use gearlash_input::read;
use gearlash_text::InputError;
use std::fs;
use tempfile::TempDir;

/// A pair whose wheel has `keys`; `spans.csv` beside it holds `table`.
fn pair_beside(keys: &str, table: &str) -> Result<PairFile, InputError> {
    let gear = "pressure_angle_deg = 20.0\nmodule_mm = ";
    let module = keys
        .lines()
        .find_map(|line| line.strip_prefix("module_mm = "))
        .unwrap();
    let teeth: f64 = keys
        .lines()
        .find_map(|line| line.strip_prefix("teeth = "))
        .unwrap()
        .parse()
        .unwrap();
    // Little beyond the sum of the reference radii: no warning is of the distance.
    let a = module.parse::<f64>().unwrap() * ((teeth + 30.0) / 2.0 + 0.1);
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("spans.csv"), table).unwrap();
    let path = folder.path().join("pair.toml");
    let text = format!(
        "[pinion]\nteeth = 30\n{gear}{module}\n[assembly]\ncenter_distance_mm = {a}\n[sweep]\nmating = [[1, 1]]\n[wheel]\npressure_angle_deg = 20.0\n{keys}\n"
    );
    fs::write(&path, text).unwrap();
    let study = read(&path)?;
    // The echo is the same study.
    let again = folder.path().join("pair.json");
    fs::write(&again, echo(&study).to_string()).unwrap();
    let again = read(&again).unwrap_or_else(|error| panic!("{error}"));
    assert!(is_same(&again, &study), "{:#?}", study.spec);
    Ok(study)
}

fn pair(keys: &str) -> PairFile {
    pair_beside(keys, "").unwrap_or_else(|error| panic!("{error}"))
}

fn wheel(study: &PairFile) -> &AsBuilt {
    &study.study.materials[0].1
}

/// The actual place of a flank on the base circle from its tooth's undisturbed centre line, as an arc, mm, counter-clockwise.
fn place(gear: &AsBuilt, side: Side, tooth: u32) -> f64 {
    let angle = side.sense() * gear.gear().half_base_angle() + gear.flank_offset(side, tooth);
    gear.gear().base_radius() * angle
}
