//! Ten thousand mutants of XML and of JSON: an error with its place, or exactly what the model says.

use super::mutant::{Choice, count, mutant};
use super::oracle::Model;
use super::*;

/// `good` with one mistake: a flipped bit, another digit, or one of those of tables.
fn mistaken(good: &[u8], choice: &mut Choice) -> Vec<u8> {
    let mut bytes = good.to_vec();
    match choice.below(4) {
        0 => bytes[choice.below(good.len())] ^= 1 << choice.below(8),
        1 => {
            let digits = (0..good.len()).filter(|&at| good[at].is_ascii_digit());
            let digits: Vec<usize> = digits.collect();
            bytes[digits[choice.below(digits.len())]] = b"0123456789"[choice.below(10)];
        }
        _ => return mutant(good, choice),
    }
    bytes
}

fn run(name: &str, model: impl Fn(&str) -> Model) {
    let text = fixture(name);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, &text).unwrap();
    let good = rexs::read(&path).unwrap();
    let (mut errors, mut pairs, mut left_out, mut changed) = (0, 0, 0, 0);
    let mut choice = Choice(text.len() as u64);
    for number in 0..count() {
        let bytes = mistaken(text.as_bytes(), &mut choice);
        std::fs::write(&path, &bytes).unwrap();
        let file = match rexs::read(&path) {
            Ok(file) => file,
            Err(error) => {
                let problem = &error.problems[0];
                let has_place = !problem.key.is_empty() || problem.reason.starts_with("line ");
                assert!(has_place && !problem.help.is_empty(), "{number}: {error}");
                errors += 1;
                continue;
            }
        };
        let mutant = String::from_utf8(bytes).unwrap();
        let model = model(&mutant);
        for stage in &file.stages {
            match &stage.pair {
                Ok(found) => {
                    model.check(stage.id.into(), &pair(&file, stage.id));
                    let same = good
                        .stage(stage.id)
                        .and_then(|good| good.pair.as_ref().ok());
                    changed += usize::from(same.is_none_or(|s| s.pair_file != found.pair_file));
                    pairs += 1;
                }
                Err(why) => {
                    assert!(!why.is_empty());
                    left_out += 1;
                }
            }
        }
    }
    println!("{name}: {errors} errors, {pairs} pairs ({changed} changed), {left_out} left out");
    assert!(6 * errors > count() && 6 * pairs > count() && 70 * changed > count());
}

#[test]
fn garbled_xml() {
    run("gearbox.rexs", Model::of_xml);
}

#[test]
fn garbled_json() {
    run("gearbox.rexsj", Model::of_json);
}
