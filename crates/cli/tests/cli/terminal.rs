//! Output on a terminal: tables that fit it, verdicts in colour. `script` makes the terminal.

use super::*;
use unicode_width::UnicodeWidthStr;

/// The output of `gearlash WORDS` on a terminal of `columns` columns, with `variables` as for `env`.
fn on_terminal(folder: &Path, columns: u32, words: &str, variables: &str) -> Option<String> {
    let program = env!("CARGO_BIN_EXE_gearlash");
    let line = format!("stty cols {columns} rows 40; env {variables} {program} --quiet {words}");
    let shown = std::process::Command::new("script")
        .current_dir(folder)
        .args(["-qec", &line, "/dev/null"])
        .stdin(std::process::Stdio::null())
        .output();
    let Ok(shown) = shown else {
        skip::skip("there is no script (util-linux)");
        return None;
    };
    Some(
        String::from_utf8(shown.stdout)
            .unwrap()
            .replace("\r\n", "\n"),
    )
}

/// `text` without colours.
fn plain(text: &str) -> String {
    let mut parts = text.split("\u{1b}[");
    let first = parts.next().unwrap().to_owned();
    parts.fold(first, |plain, part| plain + part.split_once('m').unwrap().1)
}

const COMMANDS: [&str; 8] = [
    "simulate --no-files karba_44x44.toml",
    "simulate --no-files karba_86x21.toml",
    "simulate --no-files small.toml",
    "simulate --no-files hunting.toml",
    "check tip_on_fillet_86x21.toml",
    "compare karba_44x44.toml tip_on_fillet_86x21.toml small.toml",
    "gauge --no-files --gear wheel --steps-per-pitch 2 karba_44x44_pitch.toml",
    "gauge --span 12 --pin-mm 3.525 wheel_20.dxf",
];

fn folder() -> tempfile::TempDir {
    let folder = empty_folder();
    small(folder.path());
    // Long tooth numbers, fractions and words in every column.
    let hunting = SMALL
        .replace("teeth = 20", "teeth = 123")
        .replace("teeth = 17", "teeth = 117");
    let hunting = hunting.replace("[37.3, 37.35]", "[240.300125, 240.5]");
    let (hunting, _) = hunting.split_once("[sweep]").unwrap();
    std::fs::write(folder.path().join("hunting.toml"), hunting).unwrap();
    for name in [
        "karba_44x44",
        "karba_44x44_pitch",
        "karba_86x21",
        "tip_on_fillet_86x21",
    ] {
        let name = format!("{name}.toml");
        std::fs::copy(fixture(&name), folder.path().join(&name)).unwrap();
    }
    let drawing = fixture("outlines/wheel_20.dxf");
    std::fs::copy(drawing, folder.path().join("wheel_20.dxf")).unwrap();
    let table = "karba_tables_5_6.csv";
    std::fs::copy(fixture(table), folder.path().join(table)).unwrap();
    folder
}

/// Every row of `simulate` wrapped at 80 columns.
#[test]
fn no_line_is_wider_than_the_terminal() {
    let folder = folder();
    for words in COMMANDS {
        for columns in [80, 100] {
            let Some(shown) = on_terminal(folder.path(), columns, words, "") else {
                return;
            };
            let shown = plain(&shown);
            assert!(shown.lines().count() > 3, "{words}: {shown}");
            for line in shown.lines() {
                assert!(
                    line.width() <= columns as usize,
                    "{words} at {columns}: {line}"
                );
            }
        }
    }
}

/// `--wide` prints on a terminal the tables of a pipe, and a wide terminal does so without it.
#[test]
fn wide_tables_are_those_of_a_pipe() {
    let folder = folder();
    for words in COMMANDS {
        let mut piped = gearlash(folder.path());
        let piped = piped
            .arg("--quiet")
            .args(words.split(' '))
            .output()
            .unwrap();
        let piped = String::from_utf8(piped.stdout).unwrap();
        for (columns, wide) in [(80, "--wide"), (4000, "")] {
            let Some(shown) = on_terminal(folder.path(), columns, &format!("{words} {wide}"), "")
            else {
                return;
            };
            assert_eq!(plain(&shown), piped, "{words}");
        }
    }
}

/// A narrow table lists the columns it leaves out; the columns that identify a row stay.
#[test]
fn a_narrow_table_says_what_it_leaves_out() {
    let folder = folder();
    let Some(shown) = on_terminal(
        folder.path(),
        80,
        "simulate --no-files karba_44x44.toml",
        "",
    ) else {
        return;
    };
    assert!(
        shown.contains(
            " mating     a mm  predicted (printed)      simulated  measured right   left\n"
        ),
        "{shown}"
    );
    assert!(
        shown.contains("Not shown: analytic; --wide shows all.\n"),
        "{shown}"
    );
    assert!(shown.contains("  a ± clearance\n"), "{shown}");
}

/// Red, yellow and green on a terminal alone, and not where NO_COLOR says so (no-color.org: set and not empty).
#[test]
fn verdicts_have_colours_on_a_terminal_alone() {
    let folder = folder();
    let check = "check tip_on_fillet_86x21.toml";
    let Some(shown) = on_terminal(folder.path(), 80, check, "NO_COLOR=") else {
        return;
    };
    for word in [
        "\u{1b}[31mfail\u{1b}[0m",
        "\u{1b}[33mwarn\u{1b}[0m",
        "\u{1b}[32mpass\u{1b}[0m",
    ] {
        assert!(shown.contains(word), "{word:?} in {shown:?}");
    }
    let without = on_terminal(folder.path(), 80, check, "NO_COLOR=1").unwrap();
    assert!(!without.contains('\u{1b}') && without == plain(&shown));
    let mut piped = gearlash(folder.path());
    let piped = piped.args(check.split(' ')).output().unwrap();
    assert!(!piped.stdout.contains(&0x1b));
}
