//! A tolerance on the command line that lets everything pass.

use super::*;

#[test]
fn a_tolerance_that_lets_everything_pass() {
    let folder = empty_folder();
    small(folder.path());
    for (tolerance, warns) in [("150", true), ("100", false)] {
        let output = gearlash(folder.path())
            .args(["compare", "small.toml", "--tolerance-um", tolerance])
            .output()
            .unwrap();
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(
            told.contains("warning: --tolerance-um: 150 µm"),
            warns,
            "{told}"
        );
    }
}
