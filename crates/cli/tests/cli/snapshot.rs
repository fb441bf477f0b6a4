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

/// 8 and 24 teeth, the pinion undercut: among others its edge touches, and no root.
#[test]
fn the_greatest_pose_and_the_least_of_a_kind_of_contact() {
    let folder = empty_folder();
    let pair = fixture("../tests/corpus/pairs/undercut.toml");
    let draw = |option: &str| {
        let pair = pair.to_str().unwrap();
        run(folder.path(), &["snapshot", pair, option, "-o", "-"])
    };
    let (code, worst, _) = draw("--worst");
    assert_eq!(code, Some(0));
    let (code, greatest, _) = draw("--greatest");
    assert_eq!(code, Some(0));
    // The greatest of the mesh cycle, as `check` has it.
    assert!(greatest.contains("156.38") && !worst.contains("156.38"));
    let (code, edge, _) = draw("--worst=undercut-edge");
    assert!(code == Some(0) && edge != worst);
    let (code, _, message) = draw("--worst=root");
    assert_eq!(code, Some(2));
    assert!(
        message.contains("no pose of the pair file has such a contact"),
        "{message}"
    );
    let (code, _, message) = draw("--worst=corner");
    assert!(
        code == Some(2) && message.contains("undercut-edge"),
        "{message}"
    );
}
