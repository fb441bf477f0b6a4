//! `gearlash match` in parts: the same bytes however the matrix is cut or stopped.

use super::matching::{MATCH, gear, pair};
use super::*;
use std::fs;
use std::path::Path;

/// Wheels and pinions of which each has a thickness and a runout of its own, and their pair.
fn many(here: &Path) {
    for (kind, count) in [("w", 5u32), ("p", 4)] {
        for k in 0..count {
            let (less, runout) = (40.0 + 9.0 * f64::from(k), 7.0 * f64::from(k % 3));
            gear(&here.join(kind), &format!("g{k}.toml"), less, runout);
        }
    }
    pair(here, "[require]\nj_wt_um = { min = 100, max = 130 }\n");
}

fn run(here: &Path, words: &str) -> (Option<i32>, String, String) {
    let output = gearlash(here)
        .args(words.split_whitespace())
        .output()
        .unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

fn written(folder: &Path) -> Vec<(std::ffi::OsString, Vec<u8>)> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let mut files: Vec<_> = entries
        .map(|one| (one.file_name(), fs::read(one.path()).unwrap()))
        .collect();
    files.sort();
    files
}

/// However the matrix is cut, in more parts than it has places too, and on any number of threads.
#[test]
fn parts_of_a_matching_come_to_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    many(here);
    let whole = run(here, &format!("{MATCH} -o whole"));
    assert_eq!(whole.0, Some(0), "{}", whole.2);
    let wanted = written(&here.join("whole"));
    assert_eq!(wanted.len(), 3);
    for parts in [1, 3, 7, 64] {
        let mut names = String::new();
        for k in (1..=parts).rev() {
            let mut part = gearlash(here);
            part.env("RAYON_NUM_THREADS", ["1", "2", "7"][k % 3]);
            part.args(MATCH.split(' '));
            let shard = format!("{k}/{parts}");
            part.args(["--shard", &shard, "-o", "parts"]);
            part.assert().success();
            names += &format!("parts/part_{k}_of_{parts}.json ");
        }
        let merged = run(here, &format!("merge {names} -o merged"));
        assert_eq!(merged.0, Some(0), "{}", merged.2);
        assert!(written(&here.join("merged")) == wanted, "{parts}");
        assert_eq!(merged.1.replace("merged", "whole"), whole.1);
        for format in ["json", "csv"] {
            let told = run(here, &format!("merge {names} --format {format}"));
            assert_eq!(told.1, run(here, &format!("{MATCH} --format {format}")).1);
        }
    }
    for threads in ["1", "2", "7"] {
        let mut command = gearlash(here);
        command.env("RAYON_NUM_THREADS", threads);
        command.args(MATCH.split(' ')).args(["-o", "threads"]);
        command.assert().success();
        assert!(written(&here.join("threads")) == wanted, "{threads}");
    }
}

/// What is missing, given twice, unfinished, edited or of another matching, or of a population, is named; nothing is written.
#[test]
fn parts_that_make_no_matching_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    many(here);
    let part = |words: &str| {
        let done = run(here, &format!("match pair.toml --pinions p {words}"));
        assert_eq!(done.0, Some(0), "{}", done.2);
    };
    for k in 1..=3 {
        part(&format!("--wheels w --shard {k}/3 -o parts"));
    }
    part("--wheels w --shard 2/3 -o target --target-um 110");
    part("--wheels w --shard 2/4 -o four");
    fs::create_dir(here.join("fewer")).unwrap();
    for k in 0..4 {
        fs::copy(
            here.join(format!("w/g{k}.toml")),
            here.join(format!("fewer/g{k}.toml")),
        )
        .unwrap();
    }
    part("--wheels fewer --shard 2/3 -o others");
    let text = fs::read_to_string(here.join("parts/part_2_of_3.json")).unwrap();
    let edited = |name: &str, from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        fs::write(here.join(name), text.replacen(from, to, 1)).unwrap();
    };
    let version = format!("\"gearlash\":\"{}\"", env!("CARGO_PKG_VERSION"));
    edited("old.json", &version, "\"gearlash\":\"0.0.1\"");
    edited("tooth.json", "\"cells\":[[", "\"cells\":[[99");
    let first = text.find("\"cells\":[").unwrap() + "\"cells\":[".len();
    let end = text[first..].find(']').unwrap() + first + 2;
    fs::write(
        here.join("less.json"),
        format!("{}{}", &text[..first], &text[end..]),
    )
    .unwrap();
    fs::write(
        here.join("more.json"),
        format!("{}{}{}", &text[..end], &text[first..end], &text[end..]),
    )
    .unwrap();
    for (second, wanted) in [
        ("", "1 part of 3 missing: 2"),
        (
            "parts/part_3_of_3.json",
            "parts/part_3_of_3.json: is named twice",
        ),
        (
            "target/part_2_of_3.json",
            "of another run than parts/part_1_of_3.json: input",
        ),
        ("four/part_2_of_4.json", "number of parts 4, not 3"),
        (
            "others/part_2_of_3.json",
            "of another run than parts/part_1_of_3.json: input",
        ),
        ("old.json", "version of gearlash 0.0.1"),
        ("tooth.json", "it has a pair that no gears make"),
        ("less.json", "less.json: part 2 was interrupted"),
        ("more.json", "it says that more is done than it is to do"),
        ("pair.toml", "pair.toml: this is no part of a run"),
        ("nothing.json", "nothing.json: this is no part of a run"),
    ] {
        let words = format!("merge parts/part_1_of_3.json parts/part_3_of_3.json {second} -o m");
        let (code, printed, told) = run(here, &words);
        assert_eq!((code, printed.as_str()), (Some(2), ""), "{second}: {told}");
        assert!(told.contains(wanted), "{second}: {told}");
        assert!(
            !here.join("m").exists() || written(&here.join("m")).is_empty(),
            "{second}"
        );
    }
}

/// What is done is kept, and the same command goes on from it: a part file of which the first pairs are done.
#[test]
fn an_interrupted_matching_goes_on_and_gives_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    many(here);
    assert_eq!(run(here, &format!("{MATCH} -o whole")).0, Some(0));
    assert_eq!(
        run(here, &format!("{MATCH} --shard 1/1 -o parts")).0,
        Some(0)
    );
    let text = fs::read_to_string(here.join("parts/part_1_of_1.json")).unwrap();
    let first = text.find("\"cells\":[").unwrap() + "\"cells\":[".len();
    let third = text[first..].match_indices("],[").nth(2).unwrap().0 + first + 1;
    fs::create_dir(here.join("out")).unwrap();
    fs::write(
        here.join("out/part.json"),
        format!("{}]}}\n", &text[..third]),
    )
    .unwrap();
    let gone_on = run(here, &format!("{MATCH} -o out"));
    assert_eq!(gone_on.0, Some(0), "{}", gone_on.2);
    assert!(
        gone_on.2.contains("out/part.json: goes on after 3 pairs"),
        "{}",
        gone_on.2
    );
    assert!(written(&here.join("out")) == written(&here.join("whole")));
    fs::write(here.join("out/part.json"), "{}").unwrap();
    let anew = run(here, &format!("{MATCH} -o out"));
    assert!(
        anew.2.contains("cannot be gone on from, and is done again"),
        "{}",
        anew.2
    );
    assert!(written(&here.join("out")) == written(&here.join("whole")));
}
