//! A folder of results is one set: the old or the new, and nobody else's files are touched.

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
    // File by file, too: a folder in it cannot be taken along.
    change(folder.path(), "[37.1, 37.2]");
    std::fs::create_dir(folder.path().join("results/mine")).unwrap();
    assert!(simulate(folder.path(), "results").status.success());
    change(folder.path(), "[37.3]");
    assert!(simulate(folder.path(), "results").status.success());
    let mut results = at("results");
    assert!(results.remove(Path::new("mine")).is_some());
    assert!(results.remove(Path::new("gearlash.sha256")).is_some());
    assert!(results == at("fresh"));
}

/// What others keep in the folder stays: the same files, not copies of them.
#[test]
fn files_of_others_stay_through_an_exchange() {
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
    let numbers = || {
        ["c.svg", "a note.txt", "a_note_min.svg"]
            .map(|name| std::fs::metadata(at(name)).unwrap().ino())
    };
    let (before, of_folder) = (numbers(), std::fs::metadata(at(".")).unwrap().ino());
    assert!(simulate(folder.path(), "results").status.success());
    assert_eq!(numbers(), before);
    assert_ne!(
        std::fs::metadata(at(".")).unwrap().ino(),
        of_folder,
        "exchanged"
    );
    assert!(!at("gearlash.sha256").exists());
    assert!(temporary(folder.path()).is_empty());
}

/// The folder one stands in must stay the same folder: a shell would be left in the old one.
#[test]
fn the_working_folder_stays_and_has_a_manifest() {
    let folder = folder();
    let here = folder.path().join("here");
    std::fs::create_dir(&here).unwrap();
    let number = std::fs::metadata(&here).unwrap().ino();
    for distances in ["[37.1]", "[37.2, 37.3]"] {
        change(folder.path(), distances);
        assert!(run(&here, "simulate ../p.toml -o .").status.success());
        assert!(run(&here, "check ../p.toml --map -o .").status.code() != Some(2));
        assert_eq!(std::fs::metadata(&here).unwrap().ino(), number);
        let check = Command::new("sha256sum")
            .args(["--check", "--strict", "gearlash.sha256"])
            .current_dir(&here)
            .output()
            .unwrap();
        assert!(check.status.success(), "{}", told(&check));
        // Every file but the manifest, of both commands.
        let lines = String::from_utf8(check.stdout).unwrap().lines().count();
        assert_eq!(lines, contents(&here).len() - 1);
    }
}

/// A folder of a result's name: it is reported before any file is replaced.
#[test]
fn a_folder_in_the_place_of_a_file_leaves_the_old_set() {
    let folder = folder();
    assert!(simulate(folder.path(), "results").status.success());
    let csv = folder.path().join("results/result.csv");
    std::fs::remove_file(&csv).unwrap();
    std::fs::create_dir(&csv).unwrap();
    let before = contents(&folder.path().join("results"));
    change(folder.path(), "[37.3]");
    let output = simulate(folder.path(), "results");
    assert_eq!(output.status.code(), Some(2));
    assert!(told(&output).contains("results/result.csv: cannot be written: is a directory"));
    assert!(contents(&folder.path().join("results")) == before);
}

/// Two runs at once: the second is refused by name as long as the first one runs, before it computes anything.
#[test]
fn a_second_run_into_the_same_folder_is_refused() {
    let folder = folder();
    let pipe = folder.path().join("out.pipe");
    assert!(
        Command::new("mkfifo")
            .arg(&pipe)
            .status()
            .unwrap()
            .success()
    );
    // The first one's table is more than a pipe takes at once: it waits, the folder in its hands.
    let many: Vec<String> = (0..400)
        .map(|i| format!("{:.3}", 37.1 + 0.001 * f64::from(i)))
        .collect();
    std::fs::write(
        folder.path().join("many.toml"),
        pair(&format!("[{}]", many.join(", "))),
    )
    .unwrap();
    let script = format!(
        "exec {} simulate many.toml --format json -o results > out.pipe",
        env!("CARGO_BIN_EXE_gearlash")
    );
    let mut first = Command::new("sh")
        .current_dir(folder.path())
        .args(["-c", &script])
        .spawn()
        .unwrap();
    let reader = std::fs::File::open(&pipe).unwrap();
    let results = folder.path().join("results");
    while !results.exists() {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    std::thread::sleep(std::time::Duration::from_millis(300));
    let second = simulate(folder.path(), "results");
    assert_eq!(second.status.code(), Some(2));
    let said = told(&second);
    assert!(
        said.contains("results: another run of gearlash writes to this folder"),
        "{said}"
    );
    // Files of their own are another matter.
    assert!(
        run(folder.path(), "report p.toml -o results/page.html")
            .status
            .success()
    );
    std::io::copy(&mut &reader, &mut std::io::sink()).unwrap();
    assert!(first.wait().unwrap().success());
    assert!(results.join("result.json").is_file() && results.join("page.html").is_file());
    assert!(temporary(folder.path()).is_empty());
}

/// Many runs at once: each whole or refused, and the folder holds the set of one.
#[test]
fn of_many_runs_at_once_one_wins_whole() {
    let folder = folder();
    let mut sets = Vec::new();
    for i in 0..4 {
        let name = format!("p{i}.toml");
        let distances = format!("[37.{i}5, 37.{i}6]");
        std::fs::write(folder.path().join(&name), pair(&distances)).unwrap();
        assert!(
            run(folder.path(), &format!("simulate {name} -o set{i}"))
                .status
                .success()
        );
        sets.push(contents(&folder.path().join(format!("set{i}"))));
    }
    for round in 0..20 {
        if round % 2 == 0 && round > 0 {
            // Those that are refused may have made the folder that another one took.
            std::fs::remove_dir_all(folder.path().join("shared")).unwrap();
        }
        let children: Vec<_> = (0..4)
            .map(|i| {
                let mut command = gearlash(folder.path());
                command.args(["simulate", &format!("p{i}.toml"), "-o", "shared"]);
                command
                    .stdout(Stdio::null())
                    .stderr(Stdio::null())
                    .spawn()
                    .unwrap()
            })
            .collect();
        let codes: Vec<_> = children
            .into_iter()
            .map(|mut child| child.wait().unwrap().code())
            .collect();
        assert!(
            codes.iter().all(|code| matches!(code, Some(0 | 2))),
            "{codes:?}"
        );
        assert!(codes.contains(&Some(0)), "{codes:?}");
        let found = contents(&folder.path().join("shared"));
        assert!(
            sets.contains(&found),
            "round {round}, {codes:?}: {:?}",
            found.keys()
        );
        assert!(temporary(folder.path()).is_empty());
    }
}
