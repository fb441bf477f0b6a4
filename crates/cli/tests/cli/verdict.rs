//! Verdicts that the corpus holds. `tests/sessions/verdicts.txt` has them in every command.

use std::path::Path;

/// The corpus holds the verdicts of some sixty pairs: spur, helical, drawn, jammed, out of mesh.
#[test]
fn every_verdict_of_the_corpus_has_six_short_lines_at_most() {
    let expected = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/expected");
    let mut count = 0;
    for entry in std::fs::read_dir(expected).unwrap() {
        let path = entry.unwrap().path();
        let Ok(stored) = std::fs::read_to_string(&path) else {
            continue;
        };
        for line in stored.lines() {
            let Some((_, verdict)) = line.split_once("verdict.text = ") else {
                continue;
            };
            let verdict: String = serde_json::from_str(verdict).unwrap();
            count += 1;
            assert!(verdict.lines().count() <= 6, "{path:?}: {verdict}");
            for line in verdict.lines() {
                assert!(line.chars().count() <= 80, "{path:?}: {line}");
            }
        }
    }
    assert!(count >= 60, "{count}");
}
