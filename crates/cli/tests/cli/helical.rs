//! Pictures and pages of helical pairs.

use super::{empty_folder, files, run};
use std::path::Path;

/// The pair of docs/helical-gears.md in a folder of its own: common face −24 … 24 mm.
fn folder() -> tempfile::TempDir {
    let folder = empty_folder();
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/files/helical.toml");
    std::fs::copy(from, folder.path().join("pair.toml")).unwrap();
    folder
}

fn drawn(folder: &Path, args: &[&str]) -> String {
    let (code, picture, told) = run(folder, args);
    assert_eq!(code, Some(0), "{told}");
    picture
}

fn refused(folder: &Path, args: &[&str], why: &str) {
    let (code, _, told) = run(folder, args);
    assert_eq!(code, Some(2), "{told}");
    assert!(told.contains(why), "{told}");
}

const POSE: [&str; 6] = [
    "snapshot",
    "pair.toml",
    "--mating",
    "4,16",
    "--flank",
    "right",
];

fn section(folder: &Path, at: &[&str]) -> String {
    drawn(folder, &[&POSE[..], at, &["-o", "-"]].concat())
}

/// Teeth wind by b tan β/r: over 24 mm by 24 tan 21°/65.0720 rad, 0.6084 of a pitch of the 27 teeth. Eccentricities alone leave the backlash the
/// same in every section, so that the flanks touch wherever the picture is of.
#[test]
fn a_snapshot_is_of_a_section() {
    let folder = folder();
    let at = |z: &str| section(folder.path(), &["--section", z]);
    let [near, middle, far] = ["-24", "0", "24"].map(at);
    for (picture, z) in [(&near, "−24"), (&middle, "0"), (&far, "24")] {
        assert!(picture.contains(&format!("section at z = {z} mm")), "{z}");
        assert!(picture.contains("wheel 4 with pinion 16 at the right flank"));
        assert!(picture.contains("over the face −24 … 24 mm"));
        assert!(picture.contains("Right flanks touch"));
    }
    assert!(near != middle && middle != far);
    // By default where the flank touches.
    let own = section(folder.path(), &[]);
    assert!(own.contains("section at z = ") && own.contains("Right flanks touch"));
}

#[test]
fn what_is_no_section_is_refused() {
    let folder = folder();
    for z in ["24.001", "-25", "nan"] {
        let args = [&POSE[..], &["--section", z]].concat();
        refused(
            folder.path(),
            &args,
            "the common face runs from -24 to 24 mm",
        );
    }
    refused(
        folder.path(),
        &[&POSE[..], &["--animate"]].concat(),
        "--animate turns spur gears",
    );
    let spur = std::fs::read_to_string(folder.path().join("pair.toml")).unwrap();
    let spur = spur.replace("helix_angle_deg = 21", "helix_angle_deg = 0");
    let spur = spur.replace("\"190 js7\"", "\"178 js7\"");
    std::fs::write(folder.path().join("pair.toml"), spur).unwrap();
    refused(
        folder.path(),
        &[&POSE[..], &["--section", "1"]].concat(),
        "--section is for helical gears",
    );
    assert_eq!(files(folder.path()), ["pair.toml"]);
}

#[test]
fn simulate_draws_sections() {
    let folder = folder();
    drawn(
        folder.path(),
        &["simulate", "pair.toml", "--snapshots", "-o", "out"],
    );
    let pictures = files(&folder.path().join("out"));
    let pictures: Vec<&String> = pictures
        .iter()
        .filter(|name| name.ends_with(".svg"))
        .collect();
    // The worst, and two a run: three distances, two materials.
    assert_eq!(pictures.len(), 1 + 12);
    for name in pictures {
        let picture = std::fs::read_to_string(folder.path().join("out").join(name)).unwrap();
        assert!(picture.contains("section at z = "), "{name}");
    }
}
