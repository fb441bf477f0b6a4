//! Bad usage, bad files, folders that take nothing.

use super::*;

#[test]
fn bad_usage_ends_with_2_and_writes_nothing() {
    let folder = empty_folder();
    let pair = fixture("karba_86x21.toml");
    let pair = pair.to_str().unwrap();
    for (arguments, says) in [
        ("snapshot PAIR --mating 87,1 --flank right", "1 … 86"),
        ("snapshot PAIR --mating 1 --flank right", "wheel,pinion"),
        ("snapshot PAIR --mating 1,1 --flank top", "right"),
        (
            "snapshot PAIR --mating 1,1 --flank left --material most",
            "--material",
        ),
        (
            "snapshot PAIR --mating 1,1 --flank left --center-distance 100",
            "base circles",
        ),
        (
            "snapshot PAIR --mating 1,1 --flank left --fraction nan",
            "--fraction",
        ),
        ("simulate nowhere.toml", "nowhere.toml"),
        ("simulate", "PAIR"),
        ("compare", "PAIRS"),
        ("measure", "measure"),
    ] {
        let words = arguments.split(' ').map(|word| match word {
            "PAIR" => pair,
            word => word,
        });
        gearlash(folder.path())
            .args(words)
            .assert()
            .code(2)
            .stdout(predicate::str::is_empty())
            .stderr(predicate::str::contains(says));
        assert!(files(folder.path()).is_empty(), "{arguments}");
    }
}

#[test]
fn all_problems_of_a_file_come_at_once_and_nothing_is_written() {
    let folder = empty_folder();
    let bad = SMALL
        .replace("teeth = 20", "teeth = 2")
        .replace("total_um = 12.0", "totl_um = 12.0");
    std::fs::write(folder.path().join("bad.toml"), bad).unwrap();
    gearlash(folder.path())
        .args(["simulate", "bad.toml"])
        .assert()
        .code(2)
        .stdout(predicate::str::is_empty())
        .stderr(predicate::str::contains("wheel.teeth"))
        .stderr(predicate::str::contains("total_um"));
    assert_eq!(files(folder.path()), ["bad.toml"]);
}

/// Found out before the simulation: a file stands where the folder should be.
#[test]
fn an_output_folder_that_cannot_be_written() {
    let folder = empty_folder();
    small(folder.path());
    std::fs::write(folder.path().join("taken"), "mine").unwrap();
    gearlash(folder.path())
        .args(["simulate", "small.toml", "-o", "taken/results"])
        .assert()
        .code(2)
        .stdout(predicate::str::is_empty())
        .stderr(predicate::str::contains("cannot be written").and(predicate::str::contains("-o")));
    assert_eq!(
        std::fs::read_to_string(folder.path().join("taken")).unwrap(),
        "mine"
    );
    assert_eq!(files(folder.path()), ["small.toml", "taken"]);
}

/// A failed run leaves earlier results alone, and no empty folder of its own.
#[test]
fn a_failed_run_overwrites_nothing() {
    let folder = empty_folder();
    small(folder.path());
    output(gearlash(folder.path()).args(["simulate", "small.toml", "-o", "results"]));
    let before = std::fs::read_to_string(folder.path().join("results/result.json")).unwrap();
    std::fs::write(
        folder.path().join("small.toml"),
        SMALL.replace("teeth = 17", "teeth = -17"),
    )
    .unwrap();
    gearlash(folder.path())
        .args(["simulate", "small.toml", "-o", "results"])
        .assert()
        .code(2);
    let after = std::fs::read_to_string(folder.path().join("results/result.json")).unwrap();
    assert_eq!(before, after);
    gearlash(folder.path())
        .args(["simulate", "small.toml", "-o", "new/results"])
        .assert()
        .code(2);
    assert!(!folder.path().join("new").exists());
}

/// `-o` that names a folder is reported before the work, not after it.
#[test]
fn a_folder_where_a_file_is_needed() {
    let folder = empty_folder();
    small(folder.path());
    std::fs::create_dir(folder.path().join("d")).unwrap();
    for command in ["report", "snapshot", "chart"] {
        let mut run = gearlash(folder.path());
        run.args([command, "small.toml", "-o", "d"]);
        match command {
            "snapshot" => run.arg("--worst"),
            "chart" => run.args(["--kind", "revolution"]),
            _ => &mut run,
        };
        run.assert().code(2).stderr(predicate::str::contains(
            "d: this is a folder, name a file in it",
        ));
    }
    assert_eq!(files(folder.path()), ["d", "small.toml"]);
}

/// An option with its FILE forgotten took the first pair file for it, wrote over it, and exit 0 said so.
#[test]
fn no_output_takes_the_place_of_an_input() {
    let folder = empty_folder();
    for (name, copy) in [
        ("karba_86x21.toml", "a.toml"),
        ("karba_86x21.toml", "b.toml"),
        ("karba_86x21.toml", "pair"),
        ("karba_tables_5_6.csv", "rig.csv"),
    ] {
        std::fs::copy(fixture(name), folder.path().join(copy)).unwrap();
    }
    let contents = || -> Vec<(std::ffi::OsString, Vec<u8>)> {
        let entries = std::fs::read_dir(folder.path()).unwrap();
        let entries = entries.map(|entry| entry.unwrap());
        let read =
            |entry: std::fs::DirEntry| (entry.file_name(), std::fs::read(entry.path()).unwrap());
        let mut files: Vec<_> = entries.map(read).collect();
        files.sort();
        files
    };
    let before = contents();
    for arguments in [
        "report a.toml -o a.toml",
        "report a.toml -o rig.csv",
        "report pair -o pair",
        "chart a.toml --kind revolution -o A.TOML",
        "chart pair --kind inspection -o ./pair",
        "snapshot a.toml --worst -o b.toml",
        "init a.toml",
    ] {
        let mut command = gearlash(folder.path());
        let run = command.args(arguments.split(' ')).assert();
        let run = run.code(2).stdout("");
        let told = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
        assert!(told.contains("name another"), "{arguments}: {told}");
        assert_eq!(contents(), before, "{arguments}");
    }
}
