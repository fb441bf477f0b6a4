//! The command run on a pair file, and what it ends with.

use assert_cmd::Command;
use std::path::Path;
use tempfile::TempDir;

/// 14 November 2023 in UTC, by GNU date.
pub const SECONDS: &str = "1700000000";

/// A small pair with every kind of deviation, two materials and bearing clearance; its title is to be escaped.
pub const SMALL: &str = r#"
title = "<script>alert(\"1\")</script> & a \u0007bell"

[wheel]
teeth = 12
module_mm = 2.0
pressure_angle_deg = 20.0
profile_shift = 0.3
[wheel.thickness]
allowance_um = { min = -60, max = -40 }
per_tooth_um = [1, -1, 2, 0, 0, -2, 1, 3, -1, 0, -3, 0]
[wheel.runout]
total_um = 8
high_tooth = 3.5

[pinion]
teeth = 9
module_mm = 2.0
pressure_angle_deg = 20.0
profile_shift = 0.5
reference_face = "back"
[pinion.thickness]
allowance_um = -50
[pinion.pitch]
kind = "cumulative"
right_um = [0, 1, 2, 1, 0, -1, -2, -1, 0]
left_um = [1, 2, 1, 0, -1, -2, -1, 0, 0]

[assembly]
center_distance_mm = [22.6, 22.65]
bearing_clearance_mm = 0.004

[sweep]
revolutions = "wheel"
steps_per_pitch = 2
"#;

/// `gearlash` in `folder`, the date fixed.
pub fn gearlash(folder: &TempDir) -> Command {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command
        .current_dir(folder.path())
        .env("SOURCE_DATE_EPOCH", SECONDS);
    command
}

/// A folder with `text` as `pair.toml`.
pub fn folder(text: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    std::fs::write(folder.path().join("pair.toml"), text).unwrap();
    folder
}

/// The page of the pair file `text`, made with `arguments`.
pub fn page_with(text: &str, arguments: &[&str]) -> String {
    let folder = folder(text);
    let output = gearlash(&folder)
        .args(["report", "pair.toml", "-o", "-"])
        .args(arguments)
        .assert()
        .success();
    String::from_utf8(output.get_output().stdout.clone()).unwrap()
}

/// The page of the pair file `text`.
pub fn page(text: &str) -> String {
    page_with(text, &[])
}

/// The page of a pair file in `fixtures/`.
pub fn fixture(name: &str) -> String {
    let folder = TempDir::new().unwrap();
    let pair = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
        .join("fixtures")
        .join(name);
    let output = gearlash(&folder)
        .arg("report")
        .arg(pair)
        .args(["-o", "-"])
        .assert()
        .success();
    String::from_utf8(output.get_output().stdout.clone()).unwrap()
}

#[test]
fn without_the_environment_it_is_today() {
    let folder = folder(SMALL);
    // An empty variable is as good as none.
    for empty in [false, true] {
        let mut command = gearlash(&folder);
        if empty {
            command.env("SOURCE_DATE_EPOCH", "")
        } else {
            command.env_remove("SOURCE_DATE_EPOCH")
        };
        let output = command
            .args(["report", "pair.toml", "-o", "-"])
            .assert()
            .success();
        let page = String::from_utf8(output.get_output().stdout.clone()).unwrap();
        let (_, after) = page.split_once("<dt>Date</dt><dd>").unwrap();
        let year: u32 = after[..4].parse().unwrap();
        assert!((2025..3000).contains(&year) && !after.starts_with("2023-11-14"));
    }
}
