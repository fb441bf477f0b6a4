//! Which runs `simulate` makes, and what their poses come to.

use super::*;

/// Issue 3: a scan over centre distance; without play the backlash rises by 2 tan α_wt a millimetre and more.
#[test]
fn a_scan_over_centre_distance() {
    let folder = empty_folder();
    small(folder.path());
    let mut command = gearlash(folder.path());
    command.args(["simulate", "small.toml", "--format", "json"]);
    let text = output(command.args(["--center-distance", "37.3..37.4:0.05"]));
    let result: Value = serde_json::from_str(&text).unwrap();
    let runs = result["runs"].as_array().unwrap();
    let distances: Vec<f64> = runs
        .iter()
        .map(|run| run["center_distance_mm"].as_f64().unwrap())
        .collect();
    assert_eq!(distances, [37.3, 37.3, 37.35, 37.35, 37.4, 37.4]);
    let least = |i: usize| runs[i]["summary"]["min_j_wt_um"].as_f64().unwrap();
    assert!(least(0) < least(2) && least(2) < least(4));
    assert_eq!(
        result["pair"]["assembly"]["center_distance_mm"],
        serde_json::json!([37.3, 37.35, 37.4])
    );
    // Measured rows have distances of their own; base circles must stay apart.
    gearlash(folder.path())
        .arg("simulate")
        .arg(fixture("karba_44x44.toml"))
        .args(["--center-distance", "132.0..132.1:0.1"])
        .assert()
        .code(2)
        .stderr(predicate::str::contains("--center-distance"));
    gearlash(folder.path())
        .args(["simulate", "small.toml", "--center-distance", "30..40:1"])
        .assert()
        .code(2)
        .stderr(predicate::str::contains("base circles"));
    assert_eq!(files(folder.path()), ["small.toml"]);
}

/// Design section 6: gcd(z_1, z_2) assembly phases; coprime pairs have one.
#[test]
fn assembly_phases_are_run_apart() {
    let folder = empty_folder();
    let phases = |wheel: u32, pinion: u32| {
        let text = format!(
            "[wheel]\nteeth = {wheel}\nmodule_mm = 2\npressure_angle_deg = 20\nrunout = {{ total_um = 30, high_tooth = 2 }}\n\
             [pinion]\nteeth = {pinion}\nmodule_mm = 2\npressure_angle_deg = 20\nrunout = {{ total_um = 20, high_tooth = 5 }}\n\
             [assembly]\ncenter_distance_mm = {}\n[sweep]\nphases = \"all\"\nsteps_per_pitch = 2\n",
            f64::from(wheel + pinion) + 0.1
        );
        std::fs::write(folder.path().join("phases.toml"), text).unwrap();
        let text = output(gearlash(folder.path()).args(["simulate", "phases.toml", "--snapshots"]));
        let json =
            output(gearlash(folder.path()).args(["simulate", "phases.toml", "--format", "json"]));
        (text, serde_json::from_str::<Value>(&json).unwrap())
    };
    let (text, result) = phases(18, 12);
    let runs = result["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 6);
    for (i, run) in runs.iter().enumerate() {
        assert_eq!(run["phase"]["pinion_tooth"], i + 1);
        // lcm(18, 12) pitches of two steps.
        assert_eq!(run["poses"].as_array().unwrap().len(), 72);
    }
    assert!(
        text.contains("Best phase 1,") && text.contains("mark wheel tooth 1 and pinion tooth"),
        "{text}"
    );
    // JSON, CSV, the worst pose, and two snapshots a phase.
    assert_eq!(files(&folder.path().join("out/phases")).len(), 15);
    let (text, result) = phases(18, 13);
    assert_eq!(result["runs"].as_array().unwrap().len(), 1);
    assert!(text.contains("only one assembly phase"), "{text}");
}
