//! `gearlash tolerance` in parts: the same bytes however the run is cut or stopped.

use super::tolerance::{PAIR, pair, tolerance};
use super::*;

/// Names and bytes of all files of a folder.
fn bytes(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let names = files(folder).into_iter();
    let each = names.map(|name| (name.clone(), std::fs::read(folder.join(name)).unwrap()));
    each.collect()
}

#[test]
fn any_number_of_parts_gives_the_same_bytes() {
    let folder = empty_folder();
    pair(folder.path());
    let whole = tolerance(folder.path(), "tolerance pair.toml -o whole");
    assert_eq!(whole.0, Some(0), "{}", whole.2);
    let wanted = bytes(&folder.path().join("whole"));
    assert!(wanted.iter().any(|(name, _)| name == "worst_10.toml"));
    for parts in [3, 7, 64] {
        let mut names = Vec::new();
        for k in (1..=parts).rev() {
            let part = format!("tolerance pair.toml --shard {k}/{parts} -o parts");
            let part = tolerance(folder.path(), &part);
            assert_eq!(part.0, Some(0), "{}", part.2);
            names.push(format!("parts/part_{k}_of_{parts}.json"));
        }
        let merged = format!("merge {} -o merged", names.join(" "));
        let merged = tolerance(folder.path(), &merged);
        assert_eq!(merged.0, Some(0), "{}", merged.2);
        assert!(bytes(&folder.path().join("merged")) == wanted, "{parts}");
        assert_eq!(merged.1.replace("merged", "whole"), whole.1);
    }
    for threads in ["1", "2", "7"] {
        let mut command = gearlash(folder.path());
        command.env("RAYON_NUM_THREADS", threads);
        command.env("SOURCE_DATE_EPOCH", "1700000000");
        command.args(["tolerance", "pair.toml", "-o", "threads"]);
        command.assert().success();
        assert!(bytes(&folder.path().join("threads")) == wanted, "{threads}");
    }
}

#[test]
fn parts_that_make_no_run_are_named() {
    let folder = empty_folder();
    pair(folder.path());
    let part = |args: &str| {
        let done = tolerance(folder.path(), &format!("tolerance pair.toml {args}"));
        assert_eq!(done.0, Some(0), "{}", done.2);
    };
    for k in 1..=3 {
        part(&format!("--shard {k}/3 -o p"));
    }
    part("--shard 2/3 -o seed --seed 8");
    part("--shard 2/3 -o more --assemblies 301");
    part("--shard 2/4 -o four");
    std::fs::write(
        folder.path().join("other.toml"),
        PAIR.replace("50.1", "50.2"),
    )
    .unwrap();
    let other = tolerance(folder.path(), "tolerance other.toml --shard 2/3 -o other");
    assert_eq!(other.0, Some(0));
    let text = std::fs::read_to_string(folder.path().join("p/part_2_of_3.json")).unwrap();
    std::fs::create_dir(folder.path().join("old")).unwrap();
    let version = format!("\"gearlash\":\"{}\"", env!("CARGO_PKG_VERSION"));
    assert!(text.contains(&version));
    let old = text.replace(&version, "\"gearlash\":\"0.0.1\"");
    std::fs::write(folder.path().join("old/part_2_of_3.json"), old).unwrap();
    std::fs::write(folder.path().join("cut.json"), &text[..text.len() / 2]).unwrap();
    let unfinished = text.replace(
        "\"done\":{\"assemblies\":100,",
        "\"done\":{\"assemblies\":99,",
    );
    std::fs::write(folder.path().join("less.json"), unfinished).unwrap();
    for (second, wanted) in [
        ("", "1 part of 3 missing: 2"),
        ("p/part_3_of_3.json", "p/part_3_of_3.json: is named twice"),
        ("seed/part_2_of_3.json", "seed 8, not 7"),
        ("more/part_2_of_3.json", "assemblies 301, not 300"),
        ("four/part_2_of_4.json", "number of parts 4, not 3"),
        (
            "other/part_2_of_3.json",
            "of another run than p/part_1_of_3.json: input",
        ),
        ("old/part_2_of_3.json", "version of gearlash 0.0.1"),
        ("cut.json", "cut.json: this is no part of a run"),
        (
            "less.json",
            "its sums are not over the assemblies that it says are done",
        ),
        ("pair.toml", "pair.toml: this is no part of a run"),
        ("nothing.json", "nothing.json: this is no part of a run"),
    ] {
        let parts = format!("merge p/part_1_of_3.json p/part_3_of_3.json {second} -o m");
        let (code, printed, told) = tolerance(folder.path(), &parts);
        assert_eq!((code, printed.as_str()), (Some(2), ""), "{second}: {told}");
        assert!(told.contains(wanted), "{second}: {told}");
        assert!(files(&folder.path().join("m")).is_empty(), "{second}");
    }
}

/// What is done of a run is kept, and the same command goes on: from a part that says that some blocks are done.
#[test]
fn an_interrupted_run_goes_on_and_gives_the_same_bytes() {
    let folder = empty_folder();
    pair(folder.path());
    let args = "tolerance pair.toml --assemblies 5000 -o";
    assert_eq!(
        tolerance(folder.path(), &format!("{args} whole")).0,
        Some(0)
    );
    // The first block, as a run of its own has it.
    let path = folder.path();
    let block = "tolerance pair.toml --assemblies 5000 --shard 1/1 -o kept";
    assert_eq!(tolerance(path, block).0, Some(0));
    let kept = path.join("kept/part_1_of_1.json");
    let text = std::fs::read_to_string(&kept).unwrap();
    std::fs::create_dir(path.join("resumed")).unwrap();
    // All but the worst pair files, which come last.
    let begun = text
        .split("\"worst\":[{\"number\"")
        .next()
        .unwrap()
        .to_owned()
        + "\"worst\":[]}\n";
    std::fs::write(path.join("resumed/part.json"), begun).unwrap();
    let (code, _, told) = tolerance(path, &format!("{args} resumed"));
    assert_eq!(code, Some(0));
    assert!(told.contains("goes on after 5000 assemblies"), "{told}");
    assert!(bytes(&path.join("resumed")) == bytes(&path.join("whole")));
    // That of another run is no beginning.
    std::fs::write(path.join("resumed/part.json"), text).unwrap();
    let (code, _, told) = tolerance(path, "tolerance pair.toml --seed 9 -o resumed");
    assert_eq!(code, Some(0));
    assert!(told.contains("is of another run"), "{told}");
    assert!(!files(&path.join("resumed")).contains(&"part.json".to_owned()));
}
