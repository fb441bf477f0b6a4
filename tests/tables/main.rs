//! Inspection tables in files: each layout gives the study of the same lists written inline, each fault has its line.

mod bombs;
mod faults;
mod formats;
mod good;
mod mutant;
mod mutated_workbooks;
mod mutations;
mod oracle;
mod protocols;
mod readings;
mod sheets;
mod workbooks;

use gearlash::error::{Error, Problem};
use gearlash::input::read;
use gearlash::study::Study;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A pair whose wheel has `teeth` and `keys`.
fn pair(teeth: u32, keys: &str) -> String {
    let gear = format!("teeth = {teeth}\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n");
    let distance = 3.0 * f64::from(teeth) + 0.2;
    format!(
        "[wheel]\n{gear}{keys}\n[pinion]\n{gear}[assembly]\ncenter_distance_mm = {distance:?}\n[sweep]\nmating = [[1, 1]]\n"
    )
}

/// Reads the pair with `table` as the file `name` beside it.
fn read_with(name: &str, table: &[u8], pair: &str) -> Result<Study, Vec<Problem>> {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(name), table).unwrap();
    let path = folder.path().join("pair.toml");
    fs::write(&path, pair).unwrap();
    read_pair(&path)
}

fn read_pair(path: &Path) -> Result<Study, Vec<Problem>> {
    match read(path) {
        Ok(study) => Ok(study),
        Err(Error::Input { problems, .. }) => {
            assert!(!problems.is_empty());
            Err(problems)
        }
        Err(other) => panic!("{other}"),
    }
}

/// The values of a list in the wheel's echo.
fn echoed(study: &Study, table: &str, list: &str) -> Vec<f64> {
    let list = study.echo["wheel"][table][list].as_array().unwrap();
    list.iter().map(|value| value.as_f64().unwrap()).collect()
}
