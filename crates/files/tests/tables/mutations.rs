//! Garbled tables: an error that says where, or exactly what the rows say. Never a panic, never a silent change.
//!
//! The tests' own [`oracle`] reads the mutants. They are seeded: every run sees the same ones.

use super::*;
use formats::{FORMATS, Format, pitch_lists};
use mutant::{Choice, count, mutant};
use rayon::prelude::*;

/// Reads `count` mutants of a table of `teeth` teeth; the numbers of errors and of right data.
fn run(format: &Format, teeth: u32, count: usize) -> (usize, usize) {
    let good = (format.table)(teeth);
    let text = pair(teeth, format.keys);
    let folder = TempDir::new().unwrap();
    let (table, path) = (
        folder.path().join(format.name),
        folder.path().join("pair.toml"),
    );
    fs::write(&path, text).unwrap();
    let mut choice = Choice(u64::from(teeth));
    let (mut errors, mut right) = (0, 0);
    for number in 0..=count {
        let bytes = if number == 0 {
            good.clone()
        } else {
            mutant(&good, &mut choice)
        };
        fs::write(&table, &bytes).unwrap();
        let shown = || String::from_utf8_lossy(&bytes[..bytes.len().min(2000)]).into_owned();
        match read_pair(&path) {
            Ok(study) => {
                let expected = (format.oracle)(&bytes, teeth);
                let agrees = expected
                    .as_ref()
                    .is_some_and(|expected| format.agrees(&study, expected, teeth));
                assert!(agrees, "{number}: not {expected:?} of {}", shown());
                right += 1;
            }
            Err(problems) => {
                assert!(number > 0, "{problems:#?}");
                let right = (format.oracle)(&bytes, teeth).is_some();
                for problem in problems {
                    check(format.name, OF_THE_FILE, &problem, right);
                }
                errors += 1;
            }
        }
    }
    (errors, right)
}

/// Faults of a whole text file; every other fault is in a line.
const OF_THE_FILE: &[&str] = &[
    "no line names the columns ",
    "is empty",
    "no rows below the header",
    "has no block linke Zahnflanke",
    "has no block rechte Zahnflanke",
];

/// Faults of a workbook: the container, its sheets.
pub const OF_THE_WORKBOOK: &[&str] = &[
    "no line names the columns ",
    "cannot be read as an .xlsx workbook: ",
    "no rows below the header",
    "is empty",
];

/// A table that is read right may still be of a gear that cannot be: `right` says whether it was.
pub fn check(name: &str, of_the_file: &[&str], problem: &Problem, right: bool) {
    assert!(!problem.help.is_empty(), "{problem}");
    let Some((_, message)) = problem.reason.split_once(&format!("{name}: ")) else {
        let rest = problem.reason.ends_with(" more problems like the last one");
        assert!(rest || right, "{problem}");
        return;
    };
    let line = message.strip_prefix("line ").and_then(|rest| {
        let (line, reason) = rest.split_once(": ")?;
        (!reason.is_empty()).then(|| line.parse::<u64>().ok())?
    });
    assert!(
        line.is_some_and(|line| line > 0)
            || of_the_file.iter().any(|words| message.starts_with(words)),
        "{problem}"
    );
}

/// Mutants of each format.
#[test]
fn garbled_tables() {
    FORMATS.par_iter().for_each(|format| {
        let (errors, right) = run(format, 17, count());
        assert_eq!(errors + right, count() + 1);
        assert!(
            5 * errors > 2 * count() && 60 * right > count(),
            "{}: {errors} errors, {right} right",
            format.name
        );
    });
}

/// The same mistakes among 10 000 lines.
#[test]
fn garbled_tables_of_ten_thousand_lines() {
    FORMATS.par_iter().for_each(|format| {
        let (errors, right) = run(format, 10_000, 60);
        assert!(
            errors > 15 && right > 1,
            "{}: {errors} errors, {right} right",
            format.name
        );
    });
}

/// A zip archive checks itself: garbled bytes are an error, or the data are as before.
#[test]
fn garbled_workbooks() {
    let good = fs::read("../../fixtures/sheets/pitch.xlsx").unwrap();
    let text = pair(44, "pitch = { kind = \"cumulative\", file = \"p.xlsx\" }");
    let expected = pitch_lists(&read_with("p.xlsx", &good, &text).unwrap());
    let mut choice = Choice(44);
    let mut errors = 0;
    for number in 0..2000 {
        let bytes = mutant(&good, &mut choice);
        match read_with("p.xlsx", &bytes, &text) {
            Ok(study) => assert_eq!(pitch_lists(&study), expected, "{number}"),
            Err(problems) => {
                errors += 1;
                for problem in problems {
                    check("p.xlsx", OF_THE_WORKBOOK, &problem, false);
                }
            }
        }
    }
    assert!(errors > 1000, "{errors}");
}
