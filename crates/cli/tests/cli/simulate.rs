//! `simulate`: what it prints and writes.

use super::*;

/// `-`: the same result as from the file, its tables beside the working folder, its place named after standard input.
#[test]
fn a_pair_file_from_standard_input() {
    let folder = empty_folder();
    let text = SMALL.replacen("title = \"small\"\n", "", 1);
    std::fs::write(folder.path().join("stdin.toml"), &text).unwrap();
    let (of_file, _) = simulated(folder.path(), &["stdin.toml"]);
    let mut piped = gearlash(folder.path());
    let piped = output(
        piped
            .args(["simulate", "-", "--format", "json"])
            .write_stdin(text.clone()),
    );
    assert_eq!(piped, of_file);
    output(
        gearlash(folder.path())
            .args(["simulate", "-q", "-"])
            .write_stdin(text.clone()),
    );
    assert_eq!(files(&folder.path().join("out")), ["stdin"]);
    // A table is looked for beside the working folder; what is wrong names standard input.
    let with_table = text.replacen(
        "[wheel]\nteeth",
        "[wheel]\npitch = { file = \"none.csv\", kind = \"cumulative\" }\nteeth",
        1,
    );
    let mut wrong = gearlash(folder.path());
    let wrong = wrong
        .args(["simulate", "-"])
        .write_stdin(with_table)
        .assert()
        .code(2);
    wrong.stderr(
        predicate::str::contains("stdin: wheel.pitch").and(predicate::str::contains("none.csv")),
    );
    // No more than a pair file may have.
    let mut large = gearlash(folder.path());
    let large = large
        .args(["check", "-"])
        .write_stdin("#".repeat((16 << 20) + 1))
        .assert()
        .code(2);
    large.stderr(predicate::str::contains(
        "stdin: has 16.0 MiB, allowed is up to 16 MiB",
    ));
}

#[test]
fn csv_has_a_row_a_pose() {
    let folder = empty_folder();
    small(folder.path());
    let (_, result) = simulated(folder.path(), &["small.toml"]);
    for run in result["runs"].as_array().unwrap() {
        let a = run["center_distance_mm"].as_f64().unwrap();
        for pose in run["poses"].as_array().unwrap() {
            let number = |key: &str| pose[key].as_f64().unwrap();
            let phi = number("lost_motion_rad");
            assert!((number("left_rad") - number("right_rad") - phi).abs() < 1e-15);
            assert!((-std::f64::consts::PI..=std::f64::consts::PI).contains(&number("right_rad")));
            let reference = 17.0; // m z / 2 of the pinion
            assert!((number("j_t_um") - phi * reference * 1e3).abs() < 1e-9);
            let base = reference * 20f64.to_radians().cos();
            assert!((number("j_bn_um") - phi * base * 1e3).abs() < 1e-9);
            // r_w2 = a z_2/(z_1 + z_2).
            assert!((number("j_wt_um") - phi * a * 17.0 / 37.0 * 1e3).abs() < 1e-9);
            let range = pose["j_wt_range_um"].as_array().unwrap();
            assert!(range[0].as_f64().unwrap() < number("j_wt_um"));
            assert!(range[1].as_f64().unwrap() > number("j_wt_um"));
        }
    }
}

#[test]
fn the_same_bytes_on_one_and_on_many_threads() {
    let folder = empty_folder();
    let file = small(folder.path());
    let with = |threads: &str| {
        output(
            gearlash(folder.path())
                .env("RAYON_NUM_THREADS", threads)
                .arg("simulate")
                .arg(&file)
                .args(["--format", "json"]),
        )
    };
    assert_eq!(with("1"), with("7"));
}

/// Source: model 3, which asks pair by pair which stretch of the face it touches over, and polygons section by section; widths as
/// [`a_wider_face_never_has_more_play`](../../../tests/exact/helical.rs) in the library.
#[test]
fn helical_gears_have_the_backlash_of_their_face() {
    let folder = empty_folder();
    let text = std::fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/files/helical.toml"),
    );
    let pitch = "runout = { total_um = 30, high_tooth = 4 }";
    let list: Vec<String> = (0..27)
        .map(|k| format!("{}", 4 * ((k * 7) % 5) - 8))
        .collect();
    let list = list.join(", ");
    let with = format!(
        "{pitch}\npitch = {{ kind = \"cumulative\", right_um = [{list}], left_um = [{list}] }}"
    );
    let text = text.unwrap().replace(pitch, &with);
    let mut last = f64::INFINITY;
    for width in [1, 12, 48] {
        let text = text
            .replace("face_width_mm = 50", &format!("face_width_mm = {width}"))
            .replace("face_width_mm = 48", &format!("face_width_mm = {width}"));
        std::fs::write(folder.path().join("pair.toml"), text).unwrap();
        let (_, result) = simulated(folder.path(), &["pair.toml", "--method", "both"]);
        let run = &result["runs"][0];
        let (mut mean, mut compared) = (0.0, 0);
        let poses = run["poses"].as_array().unwrap();
        for pose in poses {
            let found = pose["j_wt_um"].as_f64().unwrap();
            let model = pose["analytic"]["line_of_action_um"].as_f64().unwrap();
            // A tip that touches before its pair comes to the line of action leaves less room than the model has.
            let on_line = ["right", "left"]
                .iter()
                .all(|side| pose[side]["class"] == "involute-involute");
            let less = model - found;
            assert!(less > -1e-6 && (less < 1e-6 || !on_line), "{found} {model}");
            compared += u32::from(on_line);
            let section = pose["right"]["section_mm"].as_f64().unwrap();
            assert!(section.abs() <= 0.5 * f64::from(width));
            mean += found / poses.len() as f64;
        }
        assert!(compared > 100, "{compared}");
        assert!(mean < last - 0.1, "{width}: {mean} {last}");
        last = mean;
        let text = result["verdict"]["text"].as_str().unwrap();
        assert!(text.contains(" Proven"), "{text}");
    }
}
