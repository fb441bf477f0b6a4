//! `gearlash compare --markdown` and the step summary of a GitHub workflow.

use assert_cmd::Command;
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
    let fixture = include_str!("../fixtures/tip_on_fillet_86x21.toml");
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

#[test]
fn a_place_that_cannot_be_written_is_told_before_the_work() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = gearlash(
        folder.path(),
        &["compare", "pair.toml", "--markdown", "pair.toml/x.md"],
    )
    .output()
    .unwrap();
    assert_eq!(outcome.status.code(), Some(2));
    assert!(outcome.stdout.is_empty());
}
