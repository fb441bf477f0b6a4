//! Keys without a suggestion, and limits of time and threads.

use super::*;
use std::fs;

/// The beginning of a long key may be near a known one; the key is not.
#[test]
fn a_key_of_ten_thousand_characters_gets_no_suggestion() {
    let folder = empty_folder();
    for (key, suggested) in [
        ("teeth".repeat(2000), false),
        ("t".repeat(10_000), false),
        ("theet".to_owned(), true),
    ] {
        let text = SMALL.replace("teeth = 17\n", &format!("teeth = 17\n{key} = 1\n"));
        fs::write(folder.path().join("pair.toml"), text).unwrap();
        let output = gearlash(folder.path())
            .args(["check", "pair.toml"])
            .output()
            .unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(message.contains("unknown key"), "{message}");
        assert_eq!(message.contains("did you mean"), suggested, "{message}");
        assert!(!message.contains("nearest known"), "{message}");
    }
}

/// The shell that starts it limits its time on the processor, so that a busy machine changes nothing.
#[cfg(unix)]
#[test]
fn a_million_unknown_keys_are_refused_at_once() {
    let folder = empty_folder();
    let toml: String = (0..1_200_000).map(|i| format!("k{i}=1\n")).collect();
    let json: String = (0..1_200_000).map(|i| format!("\"k{i}\":1,")).collect();
    let json = format!("{{{json}\"z\":1}}");
    for (name, text) in [("pair.toml", toml), ("pair.json", json)] {
        fs::write(folder.path().join(name), text).unwrap();
        let output = std::process::Command::new("sh")
            .args(["-c", "ulimit -t 1; exec \"$0\" check \"$1\""])
            .arg(assert_cmd::cargo::cargo_bin("gearlash"))
            .arg(name)
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(output.stderr.len() < 1000);
    }
}

#[test]
fn a_hundred_thousand_threads_are_not_started() {
    let folder = empty_folder();
    small(folder.path());
    let run = |threads: &str| {
        let mut command = gearlash(folder.path());
        command.args(["simulate", "small.toml", "--format", "json"]);
        command.env("RAYON_NUM_THREADS", threads).output().unwrap()
    };
    let (one, many) = (run("1"), run("100000"));
    assert!(many.status.success());
    assert_eq!(one.stdout, many.stdout);
    let message = String::from_utf8(many.stderr).unwrap();
    assert!(
        message.contains("note: RAYON_NUM_THREADS=100000: "),
        "{message}"
    );
    assert!(one.stderr.is_empty());
}
