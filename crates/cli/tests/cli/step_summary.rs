//! Markdown of `gearlash compare` and `check`, and the step summary of a GitHub workflow.

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

/// What the command prints.
fn printed(folder: &Path, arguments: &[&str]) -> String {
    let output = gearlash(folder, arguments).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn writes_a_table_with_a_row_a_run() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["compare", "pair.toml", "--format", "markdown"];
    insta::assert_snapshot!(printed(folder.path(), &arguments));
}

/// Every row of a table has as many cells as its heading, whatever the title says.
#[test]
fn a_title_stays_text() {
    let folder = tempfile::tempdir().unwrap();
    let text = printed(
        folder.path(),
        &["compare", "pair.toml", "--format", "markdown"],
    );
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
        "--format",
        "markdown",
    ];
    gearlash(folder.path(), &arguments).assert().code(1);
    let text = printed(folder.path(), &arguments);
    assert!(
        text.starts_with("## gearlash compare: ❌ 1 fails, of 2: strict.toml\n"),
        "{text}"
    );
    assert!(
        text.contains("a = 160.200 mm, as-measured: 1118 of 2064 poses: off-line contact"),
        "{text}"
    );
}

/// GitHub hands every step a file to add to; earlier steps' words stay.
#[test]
fn adds_to_the_step_summary() {
    for command in ["compare", "check"] {
        let folder = tempfile::tempdir().unwrap();
        let summary = folder.path().join("summary.md");
        std::fs::write(&summary, "earlier\n").unwrap();
        let table = printed(
            folder.path(),
            &[command, "pair.toml", "--format", "markdown"],
        );
        // Only a workflow's own format does so.
        for format in ["github", "text"] {
            gearlash(folder.path(), &[command, "pair.toml", "--format", format])
                .env("GITHUB_STEP_SUMMARY", &summary)
                .output()
                .unwrap();
            let written = std::fs::read_to_string(&summary).unwrap();
            assert_eq!(written, format!("earlier\n{table}"));
        }
    }
}

/// A pair that interferes has a result, and the formula agrees with it; the row says what it is.
#[test]
fn a_row_names_interference() {
    let folder = tempfile::tempdir().unwrap();
    // Nominal gears are free of backlash at m (z_1 + z_2)/2 = 50 mm.
    let tight = PAIR.replace("[50.1, 50.2]", "[49.95, 50.2]");
    std::fs::write(folder.path().join("tight.toml"), tight).unwrap();
    let text = printed(
        folder.path(),
        &["compare", "tight.toml", "--format", "markdown"],
    );
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
    let text = printed(
        folder.path(),
        &["compare", "apart.toml", "--format", "markdown"],
    );
    assert!(
        text.starts_with("## gearlash compare: ❌ 1 fails, of 1: apart.toml\n"),
        "{text}"
    );
    assert!(text.contains("Nothing to compare"), "{text}");
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
    .stderr(predicate::str::contains(" -o").not());
}

#[test]
fn the_former_option_names_its_successor() {
    let folder = tempfile::tempdir().unwrap();
    gearlash(
        folder.path(),
        &["compare", "pair.toml", "--markdown", "out.md"],
    )
    .assert()
    .code(2)
    .stderr(predicate::str::contains("use --format markdown"));
}
