//! `gearlash compare --markdown` and the step summary of a GitHub workflow.

use assert_cmd::Command;
use predicates::prelude::*;
use std::path::Path;

const PAIR: &str = r#"
title = "A|B <script>alert(1)</script> `*x*`"
[wheel]
teeth = 30
module_mm = 2.0
pressure_angle_deg = 20.0
[pinion]
teeth = 20
module_mm = 2.0
pressure_angle_deg = 20.0
reference_face = "back"
[assembly]
center_distance_mm = [50.1, 50.2]
[sweep]
mating = [[1, 1]]
"#;

fn gearlash(folder: &Path, arguments: &[&str]) -> Command {
    std::fs::write(folder.join("pair.toml"), PAIR).unwrap();
    let mut command = Command::cargo_bin("gearlash").unwrap();
    command.current_dir(folder).args(arguments);
    command
}

fn read(folder: &Path, name: &str) -> String {
    std::fs::read_to_string(folder.join(name)).unwrap()
}

#[test]
fn writes_a_table_with_a_row_a_run() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = gearlash(
        folder.path(),
        &["compare", "pair.toml", "--markdown", "sub/out.md"],
    )
    .output()
    .unwrap();
    assert!(outcome.status.success());
    // Standard output stays what it is without the option.
    let plain = gearlash(folder.path(), &["compare", "pair.toml"])
        .output()
        .unwrap();
    assert_eq!(outcome.stdout, plain.stdout);
    insta::assert_snapshot!(
        read(folder.path(), "sub/out.md").replace(env!("CARGO_PKG_VERSION"), "VERSION")
    );
}

/// Every row of a table has as many cells as its heading, whatever the title says.
#[test]
fn a_title_stays_text() {
    let folder = tempfile::tempdir().unwrap();
    gearlash(
        folder.path(),
        &["compare", "pair.toml", "--markdown", "out.md"],
    )
    .assert()
    .success();
    let text = read(folder.path(), "out.md");
    assert!(!text.contains("<script>"));
    assert!(text.contains(r"A\|B &lt;script&gt;alert(1)&lt;/script&gt; \`\*x\*\`"));
    let cells = |line: &str| line.replace(r"\|", "").matches('|').count();
    let rows: Vec<usize> = text
        .lines()
        .filter(|line| line.starts_with('|'))
        .map(cells)
        .collect();
    assert_eq!(rows, [9; 4]);
}

/// Tips on fillets that the pair file does not allow: the reason stands under the table, and the exit code is 1.
#[test]
fn says_why_a_pair_fails() {
    let folder = tempfile::tempdir().unwrap();
    let fixture = include_str!("../../../../fixtures/tip_on_fillet_86x21.toml");
    let strict = fixture.replace(
        "allow_off_line_contact = true",
        "allow_off_line_contact = false",
    );
    assert_ne!(strict, fixture);
    std::fs::write(folder.path().join("strict.toml"), strict).unwrap();
    let arguments = [
        "compare",
        "pair.toml",
        "strict.toml",
        "--markdown",
        "out.md",
    ];
    gearlash(folder.path(), &arguments).assert().code(1);
    let text = read(folder.path(), "out.md");
    assert!(
        text.starts_with(
            "## gearlash compare: ❌ simulated and analytic backlash disagree in 1 of 2 pairs"
        ),
        "{text}"
    );
    assert!(
        text.contains("**a = 160.200 mm, as-measured**: 1118 of 2064 poses: off-line contact"),
        "{text}"
    );
}

/// GitHub hands every step a file to add to; earlier steps' words stay.
#[test]
fn adds_to_the_step_summary() {
    let folder = tempfile::tempdir().unwrap();
    let summary = folder.path().join("summary.md");
    std::fs::write(&summary, "earlier\n").unwrap();
    let arguments = [
        "compare",
        "pair.toml",
        "--format",
        "github",
        "--markdown",
        "out.md",
    ];
    gearlash(folder.path(), &arguments)
        .env("GITHUB_STEP_SUMMARY", &summary)
        .assert()
        .success();
    let table = read(folder.path(), "out.md");
    assert_eq!(
        read(folder.path(), "summary.md"),
        format!("earlier\n{table}")
    );
    // Only a workflow's own format does so.
    gearlash(folder.path(), &["compare", "pair.toml"])
        .env("GITHUB_STEP_SUMMARY", &summary)
        .assert()
        .success();
    assert_eq!(
        read(folder.path(), "summary.md"),
        format!("earlier\n{table}")
    );
}

/// A pair that interferes has a result, and the formula agrees with it; the row says what it is.
#[test]
fn a_row_names_interference() {
    let folder = tempfile::tempdir().unwrap();
    // Nominal gears are free of backlash at m (z_1 + z_2)/2 = 50 mm.
    let tight = PAIR.replace("[50.1, 50.2]", "[49.95, 50.2]");
    std::fs::write(folder.path().join("tight.toml"), tight).unwrap();
    let arguments = ["compare", "tight.toml", "--markdown", "out.md"];
    gearlash(folder.path(), &arguments).assert().success();
    let text = read(folder.path(), "out.md");
    let verdicts: Vec<&str> = text
        .lines()
        .filter(|line| line.starts_with("| a ="))
        .collect();
    assert!(
        verdicts[0].ends_with("| ✅ ok; interference at 2 of 2 poses |"),
        "{text}"
    );
    assert!(verdicts[1].ends_with("| ✅ ok |"), "{text}");
}

/// Out of mesh nothing is compared: no green table.
#[test]
fn a_pair_out_of_mesh_is_not_said_to_agree() {
    let folder = tempfile::tempdir().unwrap();
    // d_a = 64 and 44: tips pass each other above 54 mm.
    let apart = PAIR.replace("[50.1, 50.2]", "54.5");
    std::fs::write(folder.path().join("apart.toml"), apart).unwrap();
    let arguments = ["compare", "apart.toml", "--markdown", "out.md"];
    gearlash(folder.path(), &arguments).assert().code(1);
    let text = read(folder.path(), "out.md");
    assert!(
        text.starts_with("## gearlash compare: ❌ nothing to compare in 1 of 1 pairs\n"),
        "{text}"
    );
    assert!(
        text.contains("❌ FAIL; out of mesh at 2 of 2 poses"),
        "{text}"
    );
    assert!(!text.contains("✅"), "{text}");
}

/// `compare` has no -o: an error names the variable or the option that chose the place.
#[test]
fn a_summary_that_cannot_be_written_names_its_variable() {
    let folder = tempfile::tempdir().unwrap();
    gearlash(
        folder.path(),
        &["compare", "pair.toml", "--format", "github"],
    )
    .env("GITHUB_STEP_SUMMARY", folder.path())
    .assert()
    .code(2)
    .stderr(predicate::str::contains("GITHUB_STEP_SUMMARY"))
    .stderr(predicate::str::contains("-o").not());
}

#[test]
fn a_place_that_cannot_be_written_is_reported_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = gearlash(
        folder.path(),
        &["compare", "pair.toml", "--markdown", "pair.toml/x.md"],
    )
    .output()
    .unwrap();
    assert_eq!(outcome.status.code(), Some(2));
    assert!(outcome.stdout.is_empty());
    let error = String::from_utf8(outcome.stderr).unwrap();
    assert!(
        error.contains("choose another place with --markdown"),
        "{error}"
    );
}
