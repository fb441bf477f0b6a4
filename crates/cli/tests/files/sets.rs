//! The files of a run replace those of an earlier run; other files in the folder stay. `tests/sessions/inputs_kept.txt` holds
//! what is refused.

use super::*;
use std::os::unix::fs::MetadataExt;

fn simulate(folder: &Path, output: &str) -> Output {
    run(folder, &format!("simulate p.toml --snapshots -o {output}"))
}

fn change(folder: &Path, distances: &str) {
    std::fs::write(folder.join("p.toml"), pair(distances)).unwrap();
}

/// Pictures of distances that the new run has not stayed beside its result.
#[test]
fn a_new_set_replaces_the_whole_old_one() {
    let folder = folder();
    assert!(simulate(folder.path(), "results").status.success());
    change(folder.path(), "[37.3]");
    assert!(simulate(folder.path(), "fresh").status.success());
    assert!(simulate(folder.path(), "results").status.success());
    let at = |name: &str| contents(&folder.path().join(name));
    assert!(at("results") == at("fresh"));
}

/// Files of others stay: the files themselves, not copies.
#[test]
fn files_of_others_stay() {
    let folder = folder();
    assert!(simulate(folder.path(), "results").status.success());
    let at = |name: &str| folder.path().join("results").join(name);
    assert!(
        run(
            folder.path(),
            "chart p.toml --kind inspection -o results/c.svg"
        )
        .status
        .success()
    );
    std::fs::write(at("a note.txt"), "mine").unwrap();
    std::fs::write(at("a_note_min.svg"), "mine").unwrap();
    std::fs::create_dir(at("mine")).unwrap();
    let numbers = || {
        ["c.svg", "a note.txt", "a_note_min.svg"]
            .map(|name| std::fs::metadata(at(name)).unwrap().ino())
    };
    let before = numbers();
    assert!(simulate(folder.path(), "results").status.success());
    assert_eq!(numbers(), before);
    assert!(at("mine").is_dir());
    assert!(temporary(folder.path()).is_empty());
}

/// Many runs at once: every file is whole and of one of them.
#[test]
fn runs_at_once_write_whole_files() {
    let folder = folder();
    let mut sets = Vec::new();
    for i in 0..4 {
        let name = format!("p{i}.toml");
        let distances = format!("[37.{i}5, 37.{i}6]");
        std::fs::write(folder.path().join(&name), pair(&distances)).unwrap();
        let words = format!("simulate {name} -o set{i}");
        assert!(run(folder.path(), &words).status.success());
        sets.push(contents(&folder.path().join(format!("set{i}"))));
    }
    for round in 0..5 {
        let children: Vec<_> = (0..4)
            .map(|i| {
                let mut command = gearlash(folder.path());
                command.args(["simulate", &format!("p{i}.toml"), "-o", "shared"]);
                let command = command.stdout(Stdio::null()).stderr(Stdio::null());
                command.spawn().unwrap()
            })
            .collect();
        for mut child in children {
            assert!(child.wait().unwrap().success(), "round {round}");
        }
        let found = contents(&folder.path().join("shared"));
        assert_eq!(found.len(), sets[0].len());
        for (path, content) in &found {
            let of = |set: &BTreeMap<PathBuf, Vec<u8>>| set.get(path) == Some(content);
            assert!(sets.iter().any(of), "round {round}: {}", path.display());
        }
    }
}
