//! Ten thousand mutants of XML and of JSON: an error with its place, or exactly what the model says.

use super::mutant::{Choice, mutant};
use super::oracle::Model;
use super::*;

/// `good` with one mistake: a flipped bit, or one of those of tables.
fn mistaken(good: &[u8], choice: &mut Choice) -> Vec<u8> {
    if choice.below(3) > 0 {
        return mutant(good, choice);
    }
    let mut bytes = good.to_vec();
    bytes[choice.below(good.len())] ^= 1 << choice.below(8);
    bytes
}

fn run(name: &str, model: impl Fn(&str) -> Model) {
    let text = fixture(name);
    let good = read(&text).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    let (mut errors, mut pairs, mut left_out, mut changed) = (0, 0, 0, 0);
    let mut choice = Choice(text.len() as u64);
    for number in 0..10_000 {
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
    assert!(errors > 2000 && pairs > 2000 && changed > 100);
}

#[test]
fn garbled_xml() {
    run("gearbox.rexs", Model::of_xml);
}

#[test]
fn garbled_json() {
    run("gearbox.rexsj", Model::of_json);
}
