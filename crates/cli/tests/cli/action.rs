//! The script of `action.yml`, without GitHub.

use super::{empty_folder, fixture};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// `.ci/action` in `folder`; the program is the built one.
fn act(folder: &Path, command: &str, files: &str, changed_only: bool, base: &str) -> Output {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/../../.ci/action");
    Command::new("bash")
        .arg(script)
        .arg(env!("CARGO_BIN_EXE_gearlash"))
        .current_dir(folder)
        .envs([
            ("COMMAND", command),
            ("FILES", files),
            ("ARGUMENTS", ""),
            ("BASE", base),
        ])
        .env("CHANGED_ONLY", changed_only.to_string())
        .output()
        .unwrap()
}

fn git(folder: &Path, arguments: &[&str]) -> String {
    let identity = ["-c", "user.name=test", "-c", "user.email=test@example.org"];
    let output = Command::new("git")
        .args(identity)
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap();
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).unwrap().trim().to_owned()
}

/// Commits everything in `folder`, and returns the commit.
fn commit(folder: &Path) -> String {
    git(folder, &["init", "--quiet"]);
    git(folder, &["add", "."]);
    git(folder, &["commit", "--quiet", "-m", "next"]);
    git(folder, &["rev-parse", "HEAD"])
}

#[test]
fn the_action_gates_on_pair_files() {
    let folder = empty_folder();
    let pairs = folder.path().join("pairs");
    fs::create_dir(&pairs).unwrap();
    for (docs, name) in [
        ("drawing.toml", "good one.toml"),
        ("printed.toml", "bad.toml"),
    ] {
        fs::copy(fixture("../docs/files").join(docs), pairs.join(name)).unwrap();
    }
    let code = |output: Output| output.status.code();
    let at = folder.path();
    assert_eq!(
        code(act(at, "check", "pairs/good*.toml", false, "")),
        Some(0)
    );
    let both = act(at, "check", "pairs/*.toml", false, "");
    let message = String::from_utf8(both.stdout.clone()).unwrap();
    assert_eq!(both.status.code(), Some(1));
    assert!(message.contains("::error file=pairs/bad.toml"), "{message}");
    assert!(
        !message.contains("good one.toml") && !message.contains("::notice"),
        "{message}"
    );
    // A missing file or an unknown command is reported in the log.
    assert_eq!(code(act(at, "check", "none/*.toml", false, "")), Some(2));
    assert_eq!(code(act(at, "rm", "pairs/*.toml", false, "")), Some(2));

    let base = commit(at);
    let unchanged = act(at, "check", "pairs/*.toml", true, &base);
    assert_eq!(unchanged.stdout, b"No pair file has changed.\n");
    assert_eq!(unchanged.status.code(), Some(0));
    fs::write(at.join("pairs/readme.md"), "1\n").unwrap();
    commit(at);
    let unchanged = act(at, "check", "pairs/*.toml", true, &base);
    assert_eq!(unchanged.stdout, b"No pair file has changed.\n");
    // Only the changed file is checked.
    let good = fs::read_to_string(pairs.join("good one.toml")).unwrap();
    fs::write(pairs.join("good one.toml"), good + "# changed\n").unwrap();
    commit(at);
    let found = act(at, "check", "pairs/*.toml", true, &base);
    assert_eq!(found.status.code(), Some(0), "{found:?}");
    let message = String::from_utf8(found.stdout).unwrap();
    assert!(!message.contains("bad.toml"), "{message}");
}

/// A pair with a changed table is checked, whatever the table is called; others are not.
#[test]
fn a_changed_table_is_looked_at() {
    for table in ["WHEEL.CSV", "wheel.dat", "a b.txt"] {
        let folder = empty_folder();
        let at = folder.path();
        fs::create_dir(at.join("pairs")).unwrap();
        let docs = fixture("../docs/files").join("drawing.toml");
        fs::copy(docs, at.join("pairs/other.toml")).unwrap();
        let keys = format!("pitch = {{ kind = \"single\", file = \"../{table}\" }}");
        fs::write(
            at.join("pairs/pair.toml"),
            super::pair_with_table::pair(9, &keys),
        )
        .unwrap();
        let rows = |first: u32| {
            let rows = (1..=9).map(|tooth| format!("{tooth},{first},0\n"));
            "tooth,left,right\n".to_owned() + &rows.collect::<String>()
        };
        fs::write(at.join(table), rows(0)).unwrap();
        let base = commit(at);
        fs::write(at.join(table), rows(1)).unwrap();
        commit(at);
        let found = act(at, "check", "pairs/*.toml", true, &base);
        let message = String::from_utf8(found.stdout).unwrap();
        assert!(message.contains("pairs/pair.toml"), "{table}: {message}");
        assert!(!message.contains("other.toml"), "{table}: {message}");
        // A table that is gone.
        git(at, &["rm", "--quiet", table]);
        commit(at);
        let found = act(at, "check", "pairs/*.toml", true, &base);
        assert_eq!(found.status.code(), Some(2), "{table}");
    }
}

/// A tag may move to other code, a commit does not.
#[test]
fn actions_of_others_are_named_by_commit() {
    let root = fixture("..");
    let mut files = vec![root.join("action.yml")];
    let workflows = fs::read_dir(root.join(".github/workflows")).unwrap();
    files.extend(workflows.map(|entry| entry.unwrap().path()));
    let mut count = 0;
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        for line in text.lines() {
            let Some((_, action)) = line.split_once("uses: ") else {
                continue;
            };
            let commit = action.split_once('@').unwrap().1;
            let commit = commit.split_whitespace().next().unwrap();
            let is_hash = commit.len() == 40 && commit.bytes().all(|c| c.is_ascii_hexdigit());
            assert!(is_hash, "{}: {line}", file.display());
            count += 1;
        }
    }
    assert!(count >= 6);
}
