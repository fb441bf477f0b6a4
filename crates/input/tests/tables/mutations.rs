//! Garbled tables: an error that says where, or exactly what the rows say. Never a panic, never a silent change.
//!
//! The tests' own [`oracle`] reads the mutants. They are seeded: every run sees the same ones.

use super::*;
use formats::{FORMATS, Format, Lists, pitch_lists};
use mutant::{Choice, count, mutant};
use rayon::prelude::*;

/// A table `name` of a gear, which these `keys` name, and its mutants.
pub struct Garbled<'a> {
    pub name: &'a str,
    pub keys: &'a str,
    pub teeth: u32,
    pub count: usize,
    /// Starts of messages about the whole file; every other one is about a line.
    pub of_the_file: &'a [&'a str],
}

impl Garbled<'_> {
    /// Reads the files that `file` makes, the first a good one, each with its right data and whether they may be of a gear that cannot be.
    /// Returns the numbers of errors and of right data.
    pub fn run(
        &self,
        mut file: impl FnMut(usize) -> (Vec<u8>, Option<Lists>, bool),
        agree: impl Fn(&PairFile, &Lists) -> bool,
    ) -> (usize, usize) {
        let folder = TempDir::new().unwrap();
        let path = folder.path().join("pair.toml");
        fs::write(&path, pair(self.teeth, self.keys)).unwrap();
        let (mut errors, mut right) = (0, 0);
        for number in 0..=self.count {
            let (bytes, expected, may_be_refused) = file(number);
            fs::write(folder.path().join(self.name), &bytes).unwrap();
            match read_pair(&path) {
                Ok(study) => {
                    let agrees = expected.as_ref().is_some_and(|right| agree(&study, right));
                    let shown = String::from_utf8_lossy(&bytes[..bytes.len().min(2000)]);
                    assert!(agrees, "{number}: not {expected:?} of {shown}");
                    right += 1;
                }
                Err(problems) => {
                    assert!(number > 0, "{problems:#?}");
                    for problem in problems {
                        self.check(&problem, may_be_refused);
                    }
                    errors += 1;
                }
            }
        }
        (errors, right)
    }

    fn check(&self, problem: &Problem, may_be_refused: bool) {
        assert!(!problem.help.is_empty(), "{problem}");
        let Some((_, message)) = problem.reason.split_once(&format!("{}: ", self.name)) else {
            let rest = problem.reason.ends_with(" more problems like the last one");
            assert!(rest || may_be_refused, "{problem}");
            return;
        };
        let line = message.strip_prefix("line ").and_then(|rest| {
            let (line, reason) = rest.split_once(": ")?;
            (!reason.is_empty()).then(|| line.parse::<u64>().ok())?
        });
        let is_of_the_file = || self.of_the_file.iter().any(|of| message.starts_with(of));
        let has_line = line.is_some_and(|line| line > 0) || is_of_the_file();
        assert!(has_line, "{problem}");
    }
}

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

fn garbled(format: &Format, teeth: u32, count: usize) -> (usize, usize) {
    let good = (format.table)(teeth);
    let mut choice = Choice(u64::from(teeth));
    let Format { name, keys, .. } = *format;
    let garbled = Garbled {
        name,
        keys,
        teeth,
        count,
        of_the_file: OF_THE_FILE,
    };
    let file = |number| {
        let bytes = match number {
            0 => good.clone(),
            _ => mutant(&good, &mut choice),
        };
        let expected = (format.oracle)(&bytes, teeth);
        let is_right = expected.is_some();
        (bytes, expected, is_right)
    };
    garbled.run(file, |study, right| format.agrees(study, right, teeth))
}

/// Mutants of each format, and the same mistakes among 2000 lines.
#[test]
fn garbled_tables() {
    FORMATS.par_iter().for_each(|format| {
        let (errors, right) = garbled(format, 17, count());
        let is_mixed = 5 * errors > 2 * count() && 60 * right > count();
        assert!(is_mixed, "{}: {errors} errors, {right} right", format.name);
        let (errors, right) = garbled(format, 2000, 12);
        let is_mixed = errors > 2 && right > 0;
        assert!(is_mixed, "{}: {errors} errors, {right} right", format.name);
    });
}

/// A zip archive checks itself: garbled bytes are an error, or the data are as before.
#[test]
fn garbled_workbooks() {
    let good = fs::read("../../fixtures/sheets/pitch.xlsx").unwrap();
    let keys = "pitch = { kind = \"cumulative\", file = \"p.xlsx\" }";
    let expected = pitch_lists(&read_with("p.xlsx", &good, &pair(44, keys)).unwrap());
    let garbled = Garbled {
        name: "p.xlsx",
        keys,
        teeth: 44,
        count: 2000,
        of_the_file: OF_THE_WORKBOOK,
    };
    let mut choice = Choice(44);
    let file = |number| {
        let bytes = match number {
            0 => good.clone(),
            _ => mutant(&good, &mut choice),
        };
        (bytes, Some(expected.clone()), false)
    };
    let (errors, _) = garbled.run(file, |study, right| pitch_lists(study) == *right);
    assert!(errors > 1000, "{errors}");
}
