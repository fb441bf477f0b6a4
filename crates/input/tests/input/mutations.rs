//! Garbled files end in a study or in problems, never in a panic.

use super::*;
use crate::mutant::{Choice, count, mutant};
use gearlash_text::InputError;

/// Values that programs stumble over, between bars.
const NASTY: &str = "|0|-1|1|2|3|0.0|-0.0|1e-300|1e308|-1e308|1e16|nan|-inf|inf|9223372036854775807|-9223372036854775808|1e999|[]|{}|[[]]|[[1, 1]]|[0]|true|\"\"|\
\"wheel\"|\"single\"|\"datum\"|\"..\"|\"hunting\"|1979-05-27|null|{ teeth = 1 }|{ min = 1, max = 2 }|{ nominal_mm = 75, tolerance_um = 5 }|\
{ nominal_mm = 75, upper_um = -1e308, lower_um = 1 }|\"\u{0}\"|🦷";

/// `bytes` with one mistake: another value of a line, its first number in another size, or a mistake of those of tables.
fn mistaken(bytes: Vec<u8>, choice: &mut Choice) -> Vec<u8> {
    let kind = choice.below(6);
    if bytes.is_empty() {
        return bytes;
    }
    if kind > 1 {
        return mutant(&bytes, choice);
    }
    let text = String::from_utf8_lossy(&bytes);
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let at = choice.below(lines.len());
    let Some((key, old)) = lines[at].split_once(['=', ':']) else {
        return bytes;
    };
    let sign = &lines[at][key.len()..key.len() + 1];
    let value = if kind == 0 {
        let nasty: Vec<&str> = NASTY.split('|').collect();
        let rest = &old[old.trim_end_matches(',').len()..];
        nasty[choice.below(nasty.len())].to_owned() + rest
    } else {
        let number = old.trim_start_matches(|c: char| !c.is_ascii_digit());
        let length = number.find(|c: char| !c.is_ascii_digit() && c != '.');
        let number = &number[..length.unwrap_or(number.len())];
        let factor = 10f64.powf(choice.below(600) as f64 / 100.0 - 3.0);
        match number.parse::<f64>() {
            Ok(value) => old.replacen(number, &format!("{:?}", value * factor), 1),
            Err(_) => old.to_owned(),
        }
    };
    lines[at] = format!("{key}{sign} {value}");
    lines.join("\n").into_bytes()
}

/// Reads the pair file at `path`; whatever comes out is complete.
fn check(path: &Path) {
    match read(path) {
        Ok(study) => {
            let runs = study.study.runs().unwrap();
            assert!(runs.iter().any(|run| !run.matings.is_empty()));
            // The understood content is a good pair file.
            let echo = path.with_file_name("echo.json");
            fs::write(&echo, super::echo(&study).to_string()).unwrap();
            let again = read(&echo).unwrap_or_else(|error| panic!("{error}"));
            let is_same = again.study.materials == study.study.materials;
            assert!(is_same, "{:#?}", study.spec);
            assert_eq!(again.spec, study.spec);
        }
        Err(InputError { problems, .. }) => {
            assert!(!problems.is_empty());
            let is_whole = |problem: &gearlash_text::Problem| {
                !problem.reason.is_empty() && !problem.help.is_empty()
            };
            assert!(problems.iter().all(is_whole), "{problems:#?}");
        }
    }
}

/// Both fixtures, a short file, one with every deviation, two of them as JSON, and the measured rows of a fixture, up to three mistakes in each.
#[test]
fn garbled_files() {
    const MEASURED: &str = "karba_tables_5_6.csv";
    let text = |path: &str| fs::read_to_string(format!("../../fixtures/{path}")).unwrap();
    let (rig, everything) = (
        text("karba_44x44.toml"),
        text("reference/lost_motion/everything_1.toml"),
    );
    let value: toml::Table = toml::from_str(&everything).unwrap();
    let good = [
        ("pair.toml", rig.clone()),
        ("pair.toml", text("karba_86x21.toml")),
        ("pair.toml", PAIR.to_owned()),
        ("pair.toml", everything),
        ("pair.json", serde_json::to_string_pretty(&value).unwrap()),
        ("pair.json", format!("{:#}", echo(&study(PAIR)))),
        (MEASURED, text(MEASURED)),
    ];
    let mut choice = Choice(7);
    for _ in 0..count() / 12 {
        for (name, text) in &good {
            let mut bytes = text.clone().into_bytes();
            for _ in 0..=choice.below(3) {
                bytes = mistaken(bytes, &mut choice);
            }
            let folder = TempDir::new().unwrap();
            for (name, bytes) in [
                (MEASURED, good[6].1.as_bytes()),
                ("pair.toml", rig.as_bytes()),
                (name, &bytes),
            ] {
                fs::write(folder.path().join(name), bytes).unwrap();
            }
            let is_pair = name.starts_with("pair");
            check(&folder.path().join(if is_pair { name } else { "pair.toml" }));
        }
    }
}
