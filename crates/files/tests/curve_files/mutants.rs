//! Ten thousand files with one mistake each.

use super::made::{MEW, Made};
use super::mutant::{Choice, count, mutant};
use super::pair;
use gearlash_files::read;
use std::fs;
use tempfile::TempDir;

/// The pitch and profile values of a file, read leniently.
fn values_of(bytes: &[u8]) -> Option<Vec<Vec<f64>>> {
    let text = String::from_utf8_lossy(bytes);
    let mut lists = vec![Vec::new(), Vec::new(), Vec::new(), Vec::new()];
    // The numbers for missing values, by their digits: that of the preamble, and the known ones.
    let preamble = text.lines().take_while(|line| !line.contains(':'));
    let mut undefined = vec![-2147483.648, -9999.0];
    for line in preamble.filter(|line| line.starts_with("UNDEFINED ")) {
        undefined.extend(
            line.split_whitespace()
                .nth(1)
                .and_then(|word| word.parse::<f64>().ok()),
        );
    }
    let is_hole = |word: &str, value: f64| {
        let digits = word.split_once('.').map_or(0, |(_, digits)| digits.len());
        let rounding = 0.5 * 10f64.powi(-(digits as i32));
        undefined
            .iter()
            .any(|number: &f64| (value - number).abs() <= rounding)
    };
    let mut list = None;
    for line in text.lines().map(str::trim) {
        let number = |word: &str| word.parse::<f64>().ok();
        if line.starts_with("Profil:") || line.ends_with(':') && line != "Teilung:" {
            list = line.starts_with("Profil:").then_some(9);
        }
        let line = line.trim_start_matches("Profil:").trim();
        if line.starts_with("Zahn-Nr.:") && list.is_some_and(|list| list >= 2) {
            list = Some(if line.contains("links") { 3 } else { 2 });
        } else if line.to_lowercase().ends_with("e zahnflanke") {
            list = Some(usize::from(line.to_lowercase().starts_with("linke")));
        } else if line.starts_with(char::is_alphabetic) && !line.starts_with("Zahn-Nr.") {
            list = None;
        } else if let (Some(place @ 0..2), Some(_)) =
            (list, line.split_whitespace().next().and_then(number))
        {
            let words: Vec<f64> = line.split_whitespace().map(number).collect::<Option<_>>()?;
            lists[place].push((words[0] as u32, *words.get(1)?));
        } else if let Some(place @ 2..4) = list {
            for word in line.split_whitespace() {
                let value = number(word)?;
                lists[place].extend((!is_hole(word, value)).then_some((0, value)));
            }
        }
    }
    for list in &mut lists[..2] {
        list.sort_by_key(|row| row.0);
    }
    Some(
        lists
            .into_iter()
            .map(|list| list.into_iter().map(|row| row.1).collect())
            .collect(),
    )
}

/// An error that says where, or exactly what the file says.
#[test]
fn ten_thousand_mutants_of_each() {
    let keys = "pitch = { kind = \"single\", file = \"gear.mka\" }\nprofile = { trace = { file = \"gear.mka\" } }";
    let of_the_file = [
        "is empty",
        "is a protocol of pitch",
        "has no block ",
        "has no profile trace",
        "is a value file (.mew)",
        "no rows below the header",
        // A changed first line makes it a table of cells.
        "no line names the columns",
    ];
    for (name, good) in [("mka", Made::new(17).text()), ("mew", MEW.to_owned())] {
        let folder = TempDir::new().unwrap();
        let path = folder.path().join("pair.toml");
        fs::write(&path, pair(17, keys)).unwrap();
        let mut choice = Choice(17);
        let (mut errors, mut right) = (0, 0);
        for number in 0..=count() {
            let bytes = match number {
                0 => good.clone().into_bytes(),
                _ => mutant(good.as_bytes(), &mut choice),
            };
            fs::write(folder.path().join("gear.mka"), &bytes).unwrap();
            match read(&path) {
                Ok(study) => {
                    let wheel = study.spec.wheel.data().unwrap().clone();
                    let (pitch, profile) = (wheel.pitch.unwrap(), wheel.profile.unwrap());
                    let trace = |flank: Option<gearlash_files::spec::FlankProfileSpec>| {
                        let flank = flank.unwrap_or_else(|| profile.both.clone());
                        let first = flank.traces().first().cloned();
                        first
                            .and_then(|trace| trace.deviation_um)
                            .unwrap_or_default()
                    };
                    let found = vec![
                        pitch.right_um.unwrap(),
                        pitch.left_um.unwrap(),
                        trace(profile.right.clone()),
                        trace(profile.left.clone()),
                    ];
                    assert_eq!(
                        Some(found),
                        values_of(&bytes),
                        "{name} {number}: {}",
                        String::from_utf8_lossy(&bytes)
                    );
                    right += 1;
                }
                Err(error) => {
                    assert!(number > 0 || name == "mew", "{:#?}", error.problems);
                    for problem in error.problems {
                        let Some((_, message)) = problem.reason.split_once("gear.mka: ") else {
                            continue;
                        };
                        let has_line = message
                            .strip_prefix("line ")
                            .is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
                        assert!(
                            has_line || of_the_file.iter().any(|words| message.starts_with(words)),
                            "{name} {number}: {problem}"
                        );
                    }
                    errors += 1;
                }
            }
        }
        println!("{name}: {errors} errors, {right} right");
        assert!(
            name == "mew" && right == 0 || 4 * errors > count() && 60 * right > count(),
            "{name}: {errors} errors, {right} right"
        );
    }
}
