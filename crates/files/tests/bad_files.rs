//! Faults of a pair file before its first line, and a measured file in other notations. `tests/corpus/bad` holds the other bad
//! files.

use gearlash_files::read;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// The only problem of the file at `path`.
fn problem(path: &Path) -> String {
    let error = read(path).unwrap_err();
    assert_eq!(error.problems.len(), 1, "{error}");
    error.to_string()
}

#[test]
fn what_is_no_text_is_refused() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("pair.toml");
    assert!(problem(&path).ends_with("there is no such file; check name and folder"));
    assert!(problem(folder.path()).ends_with("is a folder; name the file in it"));
    fs::write(&path, b"title = \"a\"\ntitle = \"\xe4\"\n").unwrap();
    assert!(problem(&path).ends_with("line 2: not UTF-8 text; save the file as UTF-8"));
    let file = fs::File::create(&path).unwrap();
    file.set_len((16 << 20) + 1).unwrap();
    let found = problem(&path);
    assert!(
        found.contains("has 16.0 MiB, allowed is up to 16 MiB"),
        "{found}"
    );
}

/// Sources may be left out; a German Excel writes semicolons and commas.
#[test]
fn measured_rows_may_be_written_in_other_ways() {
    const ROWS: &str = "center_distance_mm,wheel_tooth,pinion_tooth,measured_right_um,\
measured_left_um,predicted_min_um,predicted_max_um,source\n75.2,1,1,150,155,140,160,rig\n";
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("pair.toml");
    let gear = |teeth| format!("teeth = {teeth}\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n");
    let (wheel, pinion) = (gear(20), gear(30));
    let text = format!("[wheel]\n{wheel}[pinion]\n{pinion}[measured]\nfile = \"rig.csv\"\n");
    fs::write(&path, text).unwrap();
    let columns = |row: &str| row.rsplit_once(',').unwrap().0.to_owned() + "\n";
    let without: String = ROWS.lines().map(columns).collect();
    let german = ROWS.replace(',', ";").replace('.', ",");
    for rows in [ROWS, &without, &german] {
        fs::write(folder.path().join("rig.csv"), rows).unwrap();
        assert_eq!(read(&path).unwrap().study.measured.len(), 1, "{rows}");
    }
}
