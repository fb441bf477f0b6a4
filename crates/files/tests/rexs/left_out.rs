//! Stages that become no pair, and faults of a file.

use super::*;

/// One line for each stage that `text` reads differently from `good`, or the error of the file.
fn outcome(good: &RexsFile, text: &str) -> String {
    let file = match read(text) {
        Ok(file) => file,
        Err(error) => {
            return error
                .problems
                .iter()
                .map(|one| format!("error: {one}\n"))
                .collect();
        }
    };
    let mut lines = String::new();
    for (stage, before) in file.stages.iter().zip(&good.stages) {
        match (&stage.pair, &before.pair) {
            (Err(why), Err(before)) if why == before => {}
            (Err(why), _) => lines += &format!("stage {}: {why}\n", stage.id),
            (Ok(pair), Ok(before)) => assert_eq!(pair.pair_file, before.pair_file),
            (Ok(_), Err(_)) => panic!("stage {} is read", stage.id),
        }
    }
    lines
}

/// Each line of `changes` replaces one text of the model by another.
fn outcomes(good: &str, changes: &str) -> String {
    let whole = read(good).unwrap();
    let mut outcomes = String::new();
    for line in changes.lines() {
        outcomes += &format!("{line}\n");
        if let Some((from, to)) = line.split_once(" ⇒ ") {
            let text = good.replacen(from, to, 1);
            assert_ne!(text, good, "{from}");
            let outcome = outcome(&whole, &text);
            assert!(!outcome.is_empty(), "{line}");
            outcomes += &format!("{outcome}\n");
        }
    }
    outcomes
}

#[test]
fn a_fault_has_its_place_and_concerns_its_stage_alone() {
    let xml = outcomes(&fixture("gearbox.rexs"), include_str!("changes.txt"));
    insta::assert_snapshot!(xml);
    let json = fixture("gearbox.rexsj");
    insta::assert_snapshot!(outcomes(&json, include_str!("changes_json.txt")));
    let error = read("tooth;fp\n1;2\n").unwrap_err().to_string();
    assert!(error.contains("neither XML nor JSON"), "{error}");
}
