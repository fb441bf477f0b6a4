//! Files with one mistake each.

use super::made::{MEW, Made};
use super::mutant::{Choice, count, mutant};
use crate::tables::formats::Lists;
use crate::tables::mutations::Garbled;
use gearlash_input::PairFile;
use gearlash_input::spec::FlankProfileSpec;

/// The pitch and profile values of a file, read leniently.
fn values_of(bytes: &[u8]) -> Option<Lists> {
    let text = String::from_utf8_lossy(bytes);
    let mut lists = vec![Vec::new(), Vec::new(), Vec::new(), Vec::new()];
    // The numbers for missing values, by their digits: that of the preamble, and the known ones.
    let preamble = text.lines().take_while(|line| !line.contains(':'));
    let mut undefined = vec![-2147483.648, -9999.0];
    for line in preamble.filter(|line| line.starts_with("UNDEFINED ")) {
        let word = line.split_whitespace().nth(1);
        undefined.extend(word.and_then(|word| word.parse::<f64>().ok()));
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
    let values = |list: Vec<(u32, f64)>| list.into_iter().map(|row| row.1).collect();
    Some(lists.into_iter().map(values).collect())
}

/// The same values as understood.
fn understood(study: &PairFile) -> Lists {
    let wheel = study.spec.wheel.data().unwrap().clone();
    let (pitch, profile) = (wheel.pitch.unwrap(), wheel.profile.unwrap());
    let trace = |flank: Option<FlankProfileSpec>| {
        let flank = flank.unwrap_or_else(|| profile.both.clone());
        let first = flank.traces().first().cloned();
        first
            .and_then(|trace| trace.deviation_um)
            .unwrap_or_default()
    };
    vec![
        pitch.right_um.unwrap(),
        pitch.left_um.unwrap(),
        trace(profile.right.clone()),
        trace(profile.left.clone()),
    ]
}

/// An error that says where, or exactly what the file says; no value file is read.
#[test]
fn garbled_curve_files() {
    let garbled = Garbled {
        name: "gear.mka",
        keys: "pitch = { kind = \"single\", file = \"gear.mka\" }\nprofile = { trace = { file = \"gear.mka\" } }",
        teeth: 17,
        count: count(),
        of_the_file: &[
            "is empty",
            "is a protocol of pitch",
            "has no block ",
            "has no profile trace",
            "is a value file (.mew)",
            "no rows below the header",
            // A changed first line makes it a table of cells.
            "no line names the columns",
        ],
    };
    let curves = Made::new(17).text();
    for (name, good) in [("mka", &curves[..]), ("mew", MEW)] {
        let mut choice = Choice(17);
        let file = |number| {
            let bytes = match number {
                0 => curves.clone().into_bytes(),
                _ => mutant(good.as_bytes(), &mut choice),
            };
            let values = values_of(&bytes);
            (bytes, values, true)
        };
        let (errors, right) = garbled.run(file, |study, right| understood(study) == *right);
        let is_mixed = name == "mew" && right == 1 || 4 * errors > count() && 60 * right > count();
        assert!(is_mixed, "{name}: {errors} errors, {right} right");
    }
}
