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
    // Five centre distances, two materials, least and greatest pose; JSON and CSV.
    assert_eq!(written.len(), 5 * 2 * 2 + 2, "{written:?}");
    for name in written.iter().filter(|name| name.ends_with(".svg")) {
        let svg =
            std::fs::read_to_string(folder.path().join("out/karba_44x44").join(name)).unwrap();
        roxmltree::Document::parse(&svg).unwrap();
    }
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
    let output = command.args(["simulate", "pair.toml", "--format", "json"]);
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
