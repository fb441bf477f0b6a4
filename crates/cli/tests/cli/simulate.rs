//! `simulate`: what it prints and writes.

use super::*;

#[test]
fn the_main_job_prints_tables_5_and_6() {
    let folder = empty_folder();
    let text = output(
        gearlash(folder.path())
            .arg("simulate")
            .arg(fixture("karba_44x44.toml")),
    );
    assert!(text.contains(
        "63 of 72 measured values lie inside the predicted band: 9 below it (↓), 0 above it (↑)."
    ));
    assert!(text.contains("72 of 72 lie inside the simulated band"));
    insta::assert_snapshot!("karba_44x44", text);
    let written = files(&folder.path().join("out/karba_44x44"));
    assert_eq!(written, ["result.csv", "result.json", "worst.svg"]);
}

/// Five centre distances, two materials, least and greatest pose; a run without them takes them away again.
#[test]
fn a_snapshot_of_each_extreme_where_asked_for() {
    let folder = empty_folder();
    let pair = fixture("karba_44x44.toml");
    let results = folder.path().join("out/karba_44x44");
    let mut asked = gearlash(folder.path());
    output(asked.arg("simulate").arg(&pair).arg("--snapshots"));
    let pictures: Vec<_> = files(&results)
        .into_iter()
        .filter(|name| name.ends_with("_min.svg") || name.ends_with("_max.svg"))
        .collect();
    assert_eq!(pictures.len(), 5 * 2 * 2, "{pictures:?}");
    for name in &pictures {
        let svg = std::fs::read_to_string(results.join(name)).unwrap();
        roxmltree::Document::parse(&svg).unwrap();
    }
    output(gearlash(folder.path()).arg("simulate").arg(&pair));
    assert_eq!(files(&results), ["result.csv", "result.json", "worst.svg"]);
}

/// `worst.svg` is the picture that `snapshot --worst` finds by a run of its own.
#[test]
fn the_worst_picture_is_that_of_snapshot() {
    let folder = empty_folder();
    small(folder.path());
    output(gearlash(folder.path()).args(["simulate", "small.toml"]));
    let picture =
        output(gearlash(folder.path()).args(["snapshot", "small.toml", "--worst", "-o", "-"]));
    let worst = std::fs::read_to_string(folder.path().join("out/small/worst.svg")).unwrap();
    assert!(worst.starts_with("<svg") && worst == picture);
}

/// The table alone: nothing written, nothing said of files.
#[test]
fn quiet_and_without_files() {
    let folder = empty_folder();
    small(folder.path());
    let run = |options: &[&str]| {
        let mut command = gearlash(folder.path());
        let assert = command
            .args(["simulate", "small.toml"])
            .args(options)
            .assert();
        let output = assert.success().get_output().clone();
        (
            String::from_utf8(output.stdout).unwrap(),
            String::from_utf8(output.stderr).unwrap(),
        )
    };
    let (bare, _) = run(&["--no-files"]);
    assert_eq!(files(folder.path()), ["small.toml"]);
    let (quiet, told) = run(&["--quiet"]);
    assert_eq!((quiet.as_str(), told.as_str()), (bare.as_str(), ""));
    let (whole, _) = run(&[]);
    let said = "\nWritten to out/small: result.json, result.csv, worst.svg\n";
    assert_eq!(whole, bare + said);
}

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

/// Whatever order a pair file lists them in, runs come by ascending centre distance.
#[test]
fn centre_distances_ascend() {
    let folder = empty_folder();
    let listed = SMALL.replace("[37.3, 37.35]", "[37.35, 37.25, 37.3]");
    std::fs::write(folder.path().join("listed.toml"), listed).unwrap();
    let (_, result) = simulated(folder.path(), &["listed.toml"]);
    let runs = result["runs"].as_array().unwrap().iter();
    let distances: Vec<f64> = runs
        .map(|run| run["center_distance_mm"].as_f64().unwrap())
        .collect();
    assert_eq!(distances, [37.25, 37.25, 37.3, 37.3, 37.35, 37.35]);
}

#[test]
fn table_2_as_text() {
    let folder = empty_folder();
    let text = output(
        gearlash(folder.path())
            .arg("simulate")
            .arg(fixture("karba_86x21.toml")),
    );
    insta::assert_snapshot!("karba_86x21", text);
}

#[test]
fn json_goes_to_standard_output_alone_and_writes_nothing() {
    let folder = empty_folder();
    small(folder.path());
    let (_, result) = simulated(folder.path(), &["small.toml"]);
    assert_eq!(result["gearlash"], env!("CARGO_PKG_VERSION"));
    // Two centre distances and two materials; two matings, two flanks, two fractions.
    assert_eq!(result["runs"].as_array().unwrap().len(), 4);
    assert_eq!(result["runs"][0]["poses"].as_array().unwrap().len(), 8);
    assert_eq!(files(folder.path()), ["small.toml"]);
    insta::assert_snapshot!("small_json", rounded(&result));
}

/// Pretty JSON with every number to 9 significant digits: the last bits are the mathematics library's.
fn rounded(value: &Value) -> String {
    fn round(value: &mut Value) {
        match value {
            Value::Number(number) if number.is_f64() => {
                let short: f64 = format!("{:.8e}", number.as_f64().unwrap()).parse().unwrap();
                *value = Value::from(short);
            }
            Value::Array(values) => values.iter_mut().for_each(round),
            Value::Object(map) => map.values_mut().for_each(round),
            _ => {}
        }
    }
    let mut value = value.clone();
    round(&mut value);
    serde_json::to_string_pretty(&value).unwrap()
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

/// The result file tells the difference as the warning does: W_k states s_b = 6.272528 mm in the middle, M_dK 6.272242 mm.
#[test]
fn the_result_file_tells_the_difference() {
    let folder = tempfile::tempdir().unwrap();
    let gear = "teeth = 44\nmodule_mm = 3\npressure_angle_deg = 20\n";
    let file = format!(
        "[wheel]\n{gear}thickness.span = {{ teeth = 6, min_mm = 50.548, max_mm = 50.561 }}\n\
         thickness.cross_check.over_pins = {{ pin_mm = 5.25, mm = 139.502 }}\n\
         [pinion]\n{gear}[assembly]\ncenter_distance_mm = 132.2\n[sweep]\nmating = [[1, 1]]\n"
    );
    std::fs::write(folder.path().join("pair.toml"), file).unwrap();
    let mut command = gearlash(folder.path());
    let output = command.args(["simulate", "pair.toml", "--format", "json", "--verbose"]);
    let output = output.assert().success().get_output().clone();
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(
        told.contains("note: pair.toml: wheel.thickness.cross_check: ")
            && !told.contains("warning"),
        "{told}"
    );
    let output = output.stdout;
    let result: serde_json::Value = serde_json::from_slice(&output).unwrap();
    let notes = &result["notes"];
    let told = &notes["wheel"]["cross_check"];
    assert!((told["difference_um"].as_f64().unwrap() + 0.286).abs() < 2e-3);
    assert_eq!(told["agree"], true);
    assert!(notes["pinion"].is_null(), "nothing to tell of it");
}

/// 160.470 stood there four times, and 29.9895 mm was shown as 29.989.
#[test]
fn centre_distances_are_told_apart() {
    let folder = empty_folder();
    let listed = SMALL.replace("[37.3, 37.35]", "[37.3, 37.30002, 37.3495]");
    std::fs::write(folder.path().join("near.toml"), listed).unwrap();
    let simulated = ["simulate", "near.toml", "--no-files"];
    let compared = ["compare", "near.toml"];
    let markdown = ["compare", "near.toml", "--format", "markdown"];
    let checked = ["check", "near.toml"];
    let texts = [&simulated[..], &compared, &markdown]
        .map(|words| output(gearlash(folder.path()).args(words)));
    for text in &texts {
        for a in ["37.300 ", "37.30002 ", "37.3495 "] {
            assert!(text.contains(a), "{a} in {text}");
        }
    }
    let check = gearlash(folder.path()).args(checked).output().unwrap();
    let check = String::from_utf8(check.stdout).unwrap();
    assert!(check.contains("37.3495 "), "{check}");
}

/// A band is run at its ends and its nominal distance; by the involute formula backlash grows with the distance, so that the
/// ends of the band are those of the backlash. `--center-distance` takes one distance, and the echo no longer says band.
#[test]
fn a_band_of_centre_distances() {
    let folder = empty_folder();
    let band = SMALL.replace(
        "[37.3, 37.35]",
        "{ nominal_mm = 37.35, upper_um = 20, lower_um = -50 }",
    );
    std::fs::write(folder.path().join("band.toml"), band).unwrap();
    let (_, result) = simulated(folder.path(), &["band.toml"]);
    let runs = result["runs"].as_array().unwrap();
    let distances: Vec<f64> = runs
        .iter()
        .map(|run| run["center_distance_mm"].as_f64().unwrap())
        .collect();
    assert_eq!(distances, [37.3, 37.3, 37.35, 37.35, 37.37, 37.37]);
    let stated = &result["pair"]["assembly"]["center_distance_mm"];
    let written = json!({ "nominal_mm": 37.35, "upper_um": 20.0, "lower_um": -50.0 });
    assert_eq!(*stated, written);
    let least = |run: &Value| run["summary"]["min_j_wt_um"].as_f64().unwrap();
    let most_material: Vec<f64> = runs.iter().step_by(2).map(least).collect();
    assert!(
        most_material.is_sorted_by(|a, b| a < b),
        "{most_material:?}"
    );
    let (_, one) = simulated(folder.path(), &["band.toml", "--center-distance", "37.36"]);
    let stated = &one["pair"]["assembly"]["center_distance_mm"];
    assert_eq!(*stated, json!([37.36]));
}

/// A band that is none is refused with key, value, what is allowed and the way out.
#[test]
fn a_band_with_its_ends_swapped() {
    let folder = empty_folder();
    let band = SMALL.replace(
        "[37.3, 37.35]",
        "{ nominal_mm = 37.35, upper_um = -50, lower_um = 20 }",
    );
    std::fs::write(folder.path().join("band.toml"), band).unwrap();
    gearlash(folder.path())
        .args(["simulate", "band.toml"])
        .assert()
        .code(2)
        .stderr(predicate::str::contains(
            "assembly.center_distance_mm.lower_um = 20: greater than upper_um = -50.0, allowed is up to upper_um; swap the two",
        ));
    assert_eq!(files(folder.path()), ["band.toml"]);
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
