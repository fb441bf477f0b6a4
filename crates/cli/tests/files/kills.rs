//! Runs that are killed: every file is the old one or the new one, and a later run clears what was left.
//!
//! By default a part of the kills; all of them: `GEARLASH_KILLS=200 cargo test --release --test files kills`

use super::*;
use crate::skip::skip;
use std::time::{Duration, Instant, SystemTime};

type Set = BTreeMap<PathBuf, Vec<u8>>;

/// Two pairs whose runs write files of the same names, and these files.
pub struct Sets {
    pub folder: tempfile::TempDir,
    pub old: Set,
    pub new: Set,
}

pub const RESULTS: &str = "results";

impl Sets {
    pub fn new() -> Sets {
        let folder = tempfile::tempdir().unwrap();
        for (name, total) in [("old", "12.0"), ("new", "20.0")] {
            let text = pair("[37.1, 37.15, 37.2, 37.25, 37.3, 37.35]").replace("12.0", total);
            std::fs::write(folder.path().join(format!("{name}.toml")), text).unwrap();
        }
        let results = folder.path().join(RESULTS);
        std::fs::create_dir(&results).unwrap();
        std::fs::write(results.join("mine"), "mine").unwrap();
        let mut sets = Sets {
            folder,
            old: Set::new(),
            new: Set::new(),
        };
        sets.write("new");
        sets.new = sets.in_place();
        sets.write("old");
        sets.old = sets.in_place();
        assert!(sets.old.len() == 16 && sets.old.keys().eq(sets.new.keys()));
        sets
    }

    pub fn words(&self, name: &str) -> [String; 6] {
        let file = format!("{name}.toml");
        let words = [
            "simulate",
            &file,
            "--snapshots",
            "-o",
            RESULTS,
            "--format=csv",
        ];
        words.map(str::to_owned)
    }

    pub fn write(&self, name: &str) {
        let output = gearlash(self.folder.path())
            .args(self.words(name))
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", stderr_of(&output));
    }

    /// The files but for temporary ones.
    pub fn in_place(&self) -> Set {
        let mut found = contents(&self.folder.path().join(RESULTS));
        found.retain(|path, _| !is_temporary(path));
        found
    }

    /// Every file is the old one or the new one; `result.json` is new only where all are.
    pub fn check(&self, when: &str) {
        let found = self.in_place();
        assert!(found.keys().eq(self.old.keys()), "{when}");
        for (path, content) in &found {
            let is_whole = *content == self.old[path] || *content == self.new[path];
            assert!(is_whole, "{when}: {}", path.display());
        }
        let result = Path::new("result.json");
        if found[result] == self.new[result] {
            assert!(found == self.new, "{when}");
        }
    }
}

fn kills() -> u64 {
    let number = std::env::var("GEARLASH_KILLS");
    number.map_or(30, |number| number.parse().unwrap())
}

/// Kills anywhere from the start of a run to its end.
#[test]
fn random_kills_leave_whole_files() {
    let sets = Sets::new();
    let begun = Instant::now();
    sets.write("old");
    let usual = begun.elapsed();
    // Knuth's multiplicative generator (MMIX): any sequence will do.
    let mut state = 1_u64;
    let mut killed = 0;
    for i in 0..kills() {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        let part = (state >> 40) as f64 / f64::from(1 << 24);
        let mut command = gearlash(sets.folder.path());
        command.args(sets.words("new"));
        let mut child = command.stdout(Stdio::null()).spawn().unwrap();
        // Rather late than early: that is where files are written.
        std::thread::sleep(usual.mul_f64(1.1 * part.sqrt()));
        child.kill().unwrap();
        killed += u64::from(!child.wait().unwrap().success());
        sets.check(&format!("kill {i}, after {part} of a run"));
        sets.write("old");
        assert!(sets.in_place() == sets.old);
    }
    assert!(killed > 0);
}

/// Whether strace is there and may trace; says so where not.
pub fn traces() -> bool {
    let traced = Command::new("strace")
        .args(["-f", "-o", "/dev/null", "true"])
        .output();
    let traces = traced.is_ok_and(|output| output.status.success());
    if !traces {
        skip("needs strace and the right to trace");
    }
    traces
}

/// The program under strace, with something done to one system call.
pub fn injected(sets: &Sets, injection: &str) -> Output {
    let mut command = Command::new("strace");
    command.args(["-f", "-qq", "-o", "/dev/null"]);
    command.args(["-e", &format!("inject={injection}")]);
    command.arg(env!("CARGO_BIN_EXE_gearlash"));
    command
        .args(sets.words("new"))
        .current_dir(sets.folder.path());
    command.stdin(Stdio::null()).output().unwrap()
}

/// Every rename there is, and the one after the last.
#[test]
fn kills_at_each_rename_leave_whole_files() {
    if !traces() {
        return;
    }
    let sets = Sets::new();
    let mut killed = 0;
    for when in 1..=16 {
        let output = injected(&sets, &format!("rename:signal=SIGKILL:when={when}"));
        killed += u32::from(!output.status.success());
        sets.check(&format!("rename {when}"));
        sets.write("old");
    }
    assert_eq!(killed, 15);
}

/// The lock of a killed run's file is free, that of a living run's is not.
#[test]
fn files_of_dead_runs_are_cleared_and_of_living_ones_are_not() {
    let folder = folder();
    let results = folder.path().join(RESULTS);
    std::fs::create_dir(&results).unwrap();
    let make = |name: &str, age: u64| {
        let file = std::fs::File::create(results.join(name)).unwrap();
        let then = SystemTime::now() - Duration::from_secs(age);
        file.set_modified(then).unwrap();
        file
    };
    let living = make(".gearlash-living.tmp", 3600);
    living.lock().unwrap();
    drop(make(".gearlash-dead.tmp", 3600));
    drop(make(".gearlash-young.tmp", 0));
    assert!(
        run(folder.path(), "simulate p.toml -o results")
            .status
            .success()
    );
    let left = temporary(&results);
    let names = [".gearlash-living.tmp", ".gearlash-young.tmp"];
    assert_eq!(left.len(), 2, "{left:?}");
    assert!(names.iter().all(|name| left.contains(&PathBuf::from(name))));
}
