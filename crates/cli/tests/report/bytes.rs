//! Same input, same bytes.

use crate::command::{SMALL, folder, gearlash};

#[test]
fn twice_and_with_any_number_of_threads() {
    let folder = folder(SMALL);
    let made = |threads: &str| {
        let output = gearlash(&folder)
            .env("RAYON_NUM_THREADS", threads)
            .args(["report", "pair.toml", "-o", "-"])
            .assert()
            .success();
        output.get_output().stdout.clone()
    };
    let first = made("1");
    assert!(first == made("1") && first == made("2"));
}
