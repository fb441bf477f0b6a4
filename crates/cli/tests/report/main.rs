//! `gearlash report`: a page that parsers accept, that says what it should, of bounded size.

mod page;
mod size;

use assert_cmd::Command;
use std::path::Path;

/// A small pair with every kind of deviation, two materials and bearing clearance; its title is to be escaped.
const SMALL: &str = r#"
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

/// The page of the pair file `text`, made with `arguments`.
fn page(text: &str, arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pair.toml");
    std::fs::write(&file, text).unwrap();
    page_of(&file, arguments)
}

/// The page of a pair file.
fn page_of(file: &Path, arguments: &[&str]) -> String {
    let mut command = Command::cargo_bin("gearlash").unwrap();
    // 14 November 2023 in UTC, by GNU date.
    command.env("SOURCE_DATE_EPOCH", "1700000000");
    command.arg("report").arg(file).args(["-o", "-"]);
    let output = command.args(arguments).assert().success();
    String::from_utf8(output.get_output().stdout.clone()).unwrap()
}
