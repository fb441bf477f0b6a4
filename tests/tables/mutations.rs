//! Garbled tables: an error that says where, or exactly what the rows say. Never a panic, never a silent change.
//!
//! What a mutant says is read by the tests' own [`oracle`]. The mutants are seeded: every run sees the same.

use super::*;
use oracle::{Rows, column, delimited, protocol};

/// Numbers for choosing: Knuth's MMIX linear congruential generator, upper bits.
struct Choice(u64);

impl Choice {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % end.max(1)
    }
}

/// What is typed or lost by mistake, a line end of old Macs, NUL, half of a UTF-8 character and a byte order mark among it.
const GARBAGE: &[&[u8]] = &[
    b"0",
    b"7",
    b"-",
    b"+",
    b".",
    b",",
    b";",
    b"\t",
    b" ",
    b"\"",
    b"\n",
    b"\r",
    b"\0",
    b"e",
    b"x",
    b"nan",
    b"inf",
    b"1e9",
    b"#",
    b"\xc3",
    b"\xff",
    b"\xef\xbb\xbf",
    b"(mm)",
    b"1,234",
    b"1.234.5",
    b"\n\n",
    b"0x1",
    b"1_0",
];

/// `table` with one mistake in it.
fn mutant(table: &[u8], choice: &mut Choice) -> Vec<u8> {
    let mut lines: Vec<&[u8]> = table.split_inclusive(|&byte| byte == b'\n').collect();
    let (a, b) = (choice.below(lines.len()), choice.below(lines.len()));
    let at = choice.below(table.len());
    let garbage = GARBAGE[choice.below(GARBAGE.len())];
    match choice.below(10) {
        0 => {
            lines.remove(a);
        }
        1 => lines.insert(b, lines[a]),
        2 => lines.swap(a, b),
        3 => return table[..at].to_vec(),
        4 => return [&table[..at], garbage, &table[at..]].concat(),
        5 => return [&table[..at], garbage, &table[at + 1..]].concat(),
        6 => return [&table[..at], &table[at + 1..]].concat(),
        7 => {
            let delimiters: Vec<usize> = (0..table.len())
                .filter(|&at| b",;\t".contains(&table[at]))
                .collect();
            let at = *delimiters
                .get(choice.below(delimiters.len()))
                .unwrap_or(&at);
            return [&table[..at], garbage, &table[at + 1..]].concat();
        }
        8 => lines.insert(a, garbage),
        _ => {
            let end = lines.len().min(a + 3);
            lines.drain(a.min(end)..end);
        }
    }
    lines.concat()
}

/// The right data of a table for a number of teeth: a list a column; `None` where it is malformed.
type Oracle = fn(&[u8], u32) -> Option<Vec<Vec<f64>>>;

/// A format: the file's name, the keys that name it, a table of so many teeth, and what its rows say.
struct Format {
    name: &'static str,
    keys: &'static str,
    table: fn(u32) -> Vec<u8>,
    oracle: Oracle,
    /// What gearlash understood, in the same order.
    understood: fn(&Study) -> Vec<Vec<f64>>,
}

/// A deviation of tooth `tooth`, in tenths of a µm.
fn tenths(tooth: u32, wave: u32) -> f64 {
    f64::from((tooth * wave) % 31) / 10.0 - 1.5
}

fn rows(teeth: u32, row: impl Fn(u32) -> String) -> String {
    (1..=teeth).map(row).collect()
}

fn flanks(rows: Rows) -> Vec<Vec<f64>> {
    vec![column(&rows, 0), column(&rows, 1)]
}

fn pitch_lists(study: &Study) -> Vec<Vec<f64>> {
    ["right_um", "left_um"]
        .map(|list| echoed(study, "pitch", list))
        .to_vec()
}

const FORMATS: [Format; 5] = [
    Format {
        name: "pitch.csv",
        keys: "pitch = { kind = \"cumulative\", file = \"pitch.csv\" }",
        table: |teeth| {
            let row = |tooth| format!("{tooth},{:.1},{:.1}\n", tenths(tooth, 7), tenths(tooth, 11));
            format!("tooth,left (µm),right (µm)\n{}", rows(teeth, row)).into_bytes()
        },
        oracle: |bytes, teeth| {
            delimited(bytes, teeth, &[["right", "rechts"], ["left", "links"]]).map(flanks)
        },
        understood: pitch_lists,
    },
    Format {
        name: "german.csv",
        keys: "pitch = { kind = \"cumulative\", file = \"german.csv\" }",
        table: |teeth| {
            let row = |tooth| {
                format!(
                    "{tooth};{:.1};{:.1}\r\n",
                    tenths(tooth, 7),
                    tenths(tooth, 11)
                )
                .replace('.', ",")
            };
            let text = format!("Zahn-Nr.;rechts (µm);links (µm)\r\n{}", rows(teeth, row));
            // Windows-1252 has these letters at their Unicode numbers.
            text.chars().map(|letter| letter as u8).collect()
        },
        oracle: |bytes, teeth| {
            delimited(bytes, teeth, &[["right", "rechts"], ["left", "links"]]).map(flanks)
        },
        understood: pitch_lists,
    },
    Format {
        name: "thickness.csv",
        keys: "thickness.per_tooth_um = { file = \"thickness.csv\" }",
        table: |teeth| {
            let row = |tooth| format!("{:.1}\t{tooth}\n", tenths(tooth, 7));
            format!("\u{feff}thickness\ttooth\n{}", rows(teeth, row)).into_bytes()
        },
        oracle: |bytes, teeth| {
            delimited(bytes, teeth, &[["thickness", "dicke"]]).map(|rows| vec![column(&rows, 0)])
        },
        understood: |study| vec![echoed(study, "thickness", "per_tooth_um")],
    },
    Format {
        name: "runout.csv",
        keys: "runout = { file = \"runout.csv\", at = \"tooth\" }",
        table: |teeth| {
            let row = |tooth| format!("{tooth},{:.1}\n", tenths(tooth, 7));
            format!("tooth,runout (µm)\n{}", rows(teeth, row)).into_bytes()
        },
        oracle: |bytes, teeth| {
            let readings = column(&delimited(bytes, teeth, &[["runout", "rundlauf"]])?, 0);
            let step = std::f64::consts::TAU / f64::from(teeth);
            let sum = |wave: fn(f64) -> f64| -> f64 {
                readings
                    .iter()
                    .enumerate()
                    .map(|(i, reading)| reading * wave(i as f64 * step))
                    .sum()
            };
            // Twice the amplitude of the discrete Fourier transform, to what a sum of 10 000 floats leaves.
            let total = 4.0 / f64::from(teeth) * sum(f64::cos).hypot(sum(f64::sin));
            Some(vec![vec![(total * 1e6).round() / 1e6]])
        },
        understood: |study| {
            let total = study.echo["wheel"]["runout"]["total_um"].as_f64().unwrap();
            vec![vec![(total * 1e6).round() / 1e6]]
        },
    },
    Format {
        name: "protocol.txt",
        keys: "pitch = { kind = \"single\", file = \"protocol.txt\" }",
        table: |teeth| {
            let block = |side: &str, wave: u32| {
                let row = |tooth: u32| {
                    let before = if tooth == 1 { teeth } else { tooth - 1 };
                    let (now, before) = (tenths(tooth, wave), tenths(before, wave));
                    format!(
                        "{tooth:8}{:8.1}{now:8.1}{:8.1}\n",
                        now - before,
                        tenths(tooth, 5)
                    )
                };
                format!(
                    "\n   {side} Zahnflanke\n   Zahn-Nr.   fp   Fp   Fr\n\n{}",
                    rows(teeth, row)
                )
            };
            let header = format!("  21 :Normalmodul....: 3.000\n  22 :Zähnezahl....: {teeth}\n");
            format!("{header}{}{}\n", block("linke", 7), block("rechte", 11)).into_bytes()
        },
        oracle: |bytes, teeth| {
            let [left, right] = protocol(bytes, teeth, 1)?;
            Some(vec![column(&right, 0), column(&left, 0)])
        },
        understood: pitch_lists,
    },
];

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
                assert_eq!(
                    Some((format.understood)(&study)),
                    expected,
                    "{number}: {}",
                    shown()
                );
                right += 1;
            }
            Err(problems) => {
                assert!(number > 0, "{problems:#?}");
                for problem in problems {
                    check(format, &problem, &shown);
                }
                errors += 1;
            }
        }
    }
    (errors, right)
}

/// An error says in which line, or what of the whole file is wrong.
fn check(format: &Format, problem: &Problem, shown: &dyn Fn() -> String) {
    let of_the_file = [
        "is empty",
        "no rows below",
        "has no block",
        "more problems like",
        "not the UTF-",
        "byte order mark",
    ];
    let of_the_gear = [
        "stands",
        "out of range, allowed is below the tooth depth",
        "tooth without a tip",
        "closes",
        "close a tooth space",
        "single pitch",
    ];
    let in_a_line = problem.reason.contains(&format!("{}: line ", format.name));
    let words = |all: &[&str]| all.iter().any(|words| problem.reason.contains(words));
    assert!(
        in_a_line || words(&of_the_file) || words(&of_the_gear),
        "{problem}\n{}",
        shown()
    );
    assert!(!problem.way_out.is_empty(), "{problem}");
}

/// Ten thousand mutants, two thousand of each format.
#[test]
fn garbled_tables() {
    for format in &FORMATS {
        let (errors, right) = run(format, 17, 2000);
        assert_eq!(errors + right, 2001);
        assert!(
            errors > 1000 && right > 50,
            "{}: {errors} errors, {right} right",
            format.name
        );
    }
}

/// The same mistakes among 10 000 lines.
#[test]
fn garbled_tables_of_ten_thousand_lines() {
    for format in &FORMATS {
        let (errors, right) = run(format, 10_000, 20);
        assert!(
            errors > 5 && right > 0,
            "{}: {errors} errors, {right} right",
            format.name
        );
    }
}

/// A zip archive checks itself: garbled bytes are an error, or the data are as before.
#[test]
fn garbled_workbooks() {
    let good = fs::read("fixtures/sheets/pitch.xlsx").unwrap();
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
                let told = |problem: &Problem| problem.reason.contains("p.xlsx: ");
                assert!(problems.iter().all(told), "{number}: {problems:#?}");
            }
        }
    }
    assert!(errors > 1000, "{errors}");
}
