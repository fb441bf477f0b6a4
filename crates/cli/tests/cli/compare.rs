//! `compare`: verdicts and their formats.

use super::*;

#[test]
fn compare_agrees_on_both_fixtures() {
    let folder = empty_folder();
    let pairs = [fixture("karba_44x44.toml"), fixture("karba_86x21.toml")];
    gearlash(folder.path())
        .arg("compare")
        .args(&pairs)
        .assert()
        .code(0)
        .stdout(predicate::str::ends_with("\n2 files pass\n"));
    for pair in &pairs {
        let within =
            "\n\nSimulated and analytic backlash agree within 0.1 µm + error bound.\n\nAssembles ";
        gearlash(folder.path())
            .arg("compare")
            .arg(pair)
            .assert()
            .code(0)
            .stdout(predicate::str::contains(within));
    }
    assert!(files(folder.path()).is_empty());
}

#[test]
fn compare_fails_on_contact_off_the_line_unless_allowed() {
    let folder = empty_folder();
    let file = folder.path().join("fillet.toml");
    std::fs::write(&file, ON_THE_FILLET).unwrap();
    gearlash(folder.path())
        .args(["compare", "fillet.toml"])
        .assert()
        .code(1)
        .stdout(predicate::str::contains("off-line contact"));
    std::fs::write(
        &file,
        format!("{ON_THE_FILLET}[compare]\nallow_off_line_contact = true\n"),
    )
    .unwrap();
    gearlash(folder.path())
        .args(["compare", "fillet.toml"])
        .assert()
        .code(0)
        .stdout(predicate::str::contains("allowed by the pair file"));
}

#[test]
fn compare_speaks_json_junit_and_github() {
    let folder = empty_folder();
    std::fs::write(folder.path().join("fillet.toml"), ON_THE_FILLET).unwrap();
    small(folder.path());
    let run = |format: &str| {
        let assert = gearlash(folder.path())
            .args(["compare", "small.toml", "fillet.toml", "--format", format])
            .assert()
            .code(1);
        String::from_utf8(assert.get_output().stdout.clone()).unwrap()
    };
    let json: Value = serde_json::from_str(&run("json")).unwrap();
    assert_eq!(json["passed"], false);
    assert_eq!(json["files"][0]["passed"], true);
    assert_eq!(json["files"][1]["passed"], false);
    for key in ["file", "pair", "verdict", "extremes", "compare", "runs"] {
        assert!(!json["files"][0][key].is_null(), "{key}");
    }
    let junit = run("junit");
    let document = roxmltree::Document::parse(&junit).unwrap();
    let count = |name: &str| {
        document
            .descendants()
            .filter(|node| node.has_tag_name(name))
            .count()
    };
    assert_eq!(
        (count("testsuite"), count("testcase"), count("failure")),
        // The formulas and the verdict, of each file.
        (2, 4, 1)
    );
    let github = run("github");
    assert!(!github.contains("small.toml") && !github.contains("::notice"));
    assert!(github.contains(
        "::error file=fillet.toml,title=gearlash compare%3A formulas::Simulated and analytic backlash do not agree"
    ));
    assert!(github.contains("%0Aa = 160.200 mm, as-measured: "));
}

#[test]
fn a_tolerance_on_the_command_line_wins() {
    let folder = empty_folder();
    std::fs::write(folder.path().join("fillet.toml"), ON_THE_FILLET).unwrap();
    gearlash(folder.path())
        .args(["compare", "fillet.toml", "--tolerance-um", "100"])
        .assert()
        .code(0);
    gearlash(folder.path())
        .args(["compare", "fillet.toml", "--tolerance-um", "-1"])
        .assert()
        .code(2);
}

/// d_a = 44: two gears of 20 teeth and module 2 are out of mesh above a = 44 mm, jammed below 39.5. Nothing was compared
/// there; that is no agreement, whatever the pair file allows.
#[test]
fn compare_does_not_pass_what_it_could_not_compare() {
    let folder = empty_folder();
    let gear = "teeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\n";
    for (a, reason) in [
        ("44.5", "nothing to compare: out of mesh at 2 of 2 poses\n"),
        ("39.0", "nothing to compare: jammed at 2 of 2 poses\n"),
        (
            "[40.2, 44.5]",
            "nothing to compare: out of mesh at 2 of 2 poses\n",
        ),
    ] {
        let text = format!(
            "[wheel]\n{gear}[pinion]\n{gear}[assembly]\ncenter_distance_mm = {a}\n[sweep]\nmating = [[1, 1]]\n\
             [compare]\nallow_off_line_contact = true\n"
        );
        std::fs::write(folder.path().join("apart.toml"), text).unwrap();
        gearlash(folder.path())
            .args(["compare", "apart.toml"])
            .assert()
            .code(1)
            .stdout(predicate::str::contains(format!("FAIL  {reason}")))
            .stdout(predicate::str::contains(
                "\nNothing to compare at some centre distance.\n",
            ))
            .stdout(predicate::str::contains("agree within").not());
        gearlash(folder.path())
            .args(["compare", "apart.toml", "--format", "github"])
            .assert()
            .code(1)
            .stdout(predicate::str::contains("::error file=apart.toml"))
            .stdout(predicate::str::contains("::notice").not());
    }
}

/// "FAIL … off-line contact; largest difference -0.0000 µm": model 3 has no value where it failed, and agrees everywhere else.
#[test]
fn a_failure_says_what_failed() {
    let folder = empty_folder();
    std::fs::write(folder.path().join("undercut.toml"), UNDERCUT).unwrap();
    let (_, result) = simulated(folder.path(), &["undercut.toml"]);
    let poses = result["runs"][0]["poses"].as_array().unwrap();
    let alone = |pose: &&Value| {
        pose["analytic"]["line_of_action_um"].is_null() && !pose["j_wt_um"].is_null()
    };
    let alone = poses.iter().filter(alone).count();
    assert!(alone > 0);
    let mut compare = gearlash(folder.path());
    let assert = compare.args(["compare", "undercut.toml"]).assert().code(1);
    let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    let failed = format!(
        "FAIL  {alone} of {} poses: off-line contact where model 3 has no value\n",
        poses.len()
    );
    assert!(text.contains(&failed), "{text}");
    assert!(
        !text.contains("largest difference") && !text.contains("-0.0000"),
        "{text}"
    );
    // The same of the note below the table: where model 3 has no value there is no less than it says.
    let table = output(gearlash(folder.path()).args(["simulate", "--no-files", "undercut.toml"]));
    assert!(!table.contains("less backlash"), "{table}");
    assert!(
        table.contains(&format!(
            "In {alone} of {} poses no two involutes reach each other",
            poses.len()
        )),
        "{table}"
    );
}
