//! `snapshot`: one contact as a picture.

use super::*;

#[test]
fn snapshot_of_a_named_mating() {
    let folder = empty_folder();
    let draw = |extra: &[&str]| {
        let mut command = gearlash(folder.path());
        command.arg("snapshot").arg(fixture("karba_44x44.toml"));
        output(
            command
                .args(["--mating", "11,11", "--flank", "right"])
                .args(extra),
        )
    };
    let printed = draw(&[]);
    let svg = std::fs::read_to_string(folder.path().join(printed.trim())).unwrap();
    roxmltree::Document::parse(&svg).unwrap();
    for words in ["Test rig pair 44/44", "132.040", "right", "11"] {
        assert!(svg.contains(words), "{words}");
    }
    // To a file of one's own, and to standard output.
    draw(&["-o", "mine.svg"]);
    assert_eq!(
        std::fs::read_to_string(folder.path().join("mine.svg")).unwrap(),
        svg
    );
    assert_eq!(draw(&["-o", "-"]), svg);
    assert_ne!(
        draw(&[
            "-o",
            "-",
            "--material",
            "least",
            "--center-distance",
            "132.21"
        ]),
        svg
    );
}
