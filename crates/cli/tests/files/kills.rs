//! Runs that are killed: the folder holds one set, and the next run clears what was left.
//!
//! By default a part of the kills; all of them: `GEARLASH_KILLS=200 cargo test --release --test files kills`

use super::*;
use crate::skip::skip;
use std::time::{Duration, Instant};

type Set = BTreeMap<PathBuf, Vec<u8>>;

/// Two gears whose gauges write three dozen files of the same names, and their sets.
pub struct Sets {
    pub folder: tempfile::TempDir,
    pub old: Set,
    pub new: Set,
}

pub const RESULTS: &str = "results";

impl Sets {
    /// In a folder that is exchanged, or file by file (a folder in it keeps it from being exchanged).
    pub fn new(exchanged: bool) -> Sets {
        let folder = tempfile::tempdir().unwrap();
        for (name, total) in [("old", 10.0), ("new", 20.0)] {
            let gear = format!(
                "title = \"{name}\"\n[gear]\nteeth = 12\nmodule_mm = 2\npressure_angle_deg = 20\nprofile_shift = 0.3\nrunout = {{ total_um = {total}, high_tooth = 2 }}\nthickness.allowance_um = {{ min = -60, max = -40 }}\npitch = {{ kind = \"cumulative\", right_um = {:?}, left_um = {:?} }}\n",
                [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3],
                [0, 2, 1, 0, 2, 1, 0, 2, 1, 0, 2, 1]
            );
            std::fs::write(folder.path().join(format!("{name}.toml")), gear).unwrap();
        }
        let results = folder.path().join(RESULTS);
        std::fs::create_dir(&results).unwrap();
        std::fs::write(results.join("mine"), "mine").unwrap();
        if !exchanged {
            std::fs::create_dir(results.join("folder")).unwrap();
        }
        let mut sets = Sets {
            folder,
            old: Set::new(),
            new: Set::new(),
        };
        sets.write("new");
        sets.new = sets.found();
        sets.write("old");
        sets.old = sets.found();
        assert!(sets.old.len() > 30 && sets.old != sets.new);
        sets
    }

    pub fn found(&self) -> Set {
        contents(&self.folder.path().join(RESULTS))
    }

    pub fn words(&self, name: &str) -> [String; 7] {
        let file = format!("{name}.toml");
        let words = [
            "gauge",
            &file,
            "--steps-per-pitch",
            "1",
            "-o",
            RESULTS,
            "--format=json",
        ];
        words.map(str::to_owned)
    }

    pub fn write(&self, name: &str) {
        let output = gearlash(self.folder.path())
            .args(self.words(name))
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", told(&output));
    }

    /// What is found but for what is temporary.
    pub fn in_place(&self) -> Set {
        let mut found = self.found();
        found.retain(|path, _| !is_temporary(path));
        found
    }

    /// After a kill: one set whole, at the latest when the next run, whatever it does there, has begun.
    pub fn check(&self, exchanged: bool, when: &str) {
        let whole = |found: Set| found == self.old || found == self.new;
        if !whole(self.in_place()) {
            assert!(!exchanged, "{when}");
            // A reader can tell: the manifest does not fit.
            let mut check = Command::new("sha256sum");
            check.current_dir(self.folder.path().join(RESULTS));
            let check = check.args(["--check", "--status", "gearlash.sha256"]);
            assert!(!check.status().unwrap().success(), "{when}");
        }
        let next = run(self.folder.path(), &format!("init {RESULTS}/next.toml"));
        assert!(next.status.success(), "{when}: {}", told(&next));
        std::fs::remove_file(self.folder.path().join(RESULTS).join("next.toml")).unwrap();
        assert!(whole(self.found()), "{when}");
        self.write("old");
        assert!(self.found() == self.old, "{when}");
        let left = temporary(self.folder.path());
        assert!(left.is_empty(), "{when}: {left:?}");
    }
}

fn kills() -> u64 {
    let number = std::env::var("GEARLASH_KILLS");
    number.map_or(30, |number| number.parse().unwrap())
}

/// Kills anywhere from the start of a run to its end.
fn random_kills(exchanged: bool) {
    let sets = Sets::new(exchanged);
    let begun = Instant::now();
    sets.write("old");
    let usual = begun.elapsed();
    // Knuth's multiplicative generator (MMIX): any sequence will do.
    let mut state = 1_u64;
    let (mut killed, mut replaced) = (0, 0);
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
        let status = child.wait().unwrap();
        killed += u64::from(!status.success());
        replaced += u64::from(sets.in_place() == sets.new);
        sets.check(exchanged, &format!("kill {i}, after {part} of a run"));
    }
    println!(
        "{killed} of {} runs killed, {replaced} with the new set in place",
        kills()
    );
    assert!(killed > 0);
}

#[test]
fn random_kills_of_an_exchange_leave_one_set() {
    random_kills(true);
}

#[test]
fn random_kills_file_by_file_leave_one_set_to_the_next_run() {
    random_kills(false);
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
    command.args([
        "-f",
        "-qq",
        "-o",
        "/dev/null",
        "-e",
        &format!("inject={injection}"),
    ]);
    command.arg(env!("CARGO_BIN_EXE_gearlash"));
    command
        .args(sets.words("new"))
        .current_dir(sets.folder.path());
    command.stdin(Stdio::null()).output().unwrap()
}

/// 54 kills as a call that changes names begins: every exchange, link, removal and renaming there is, and the one after the last.
#[test]
fn kills_at_chosen_renames_leave_one_set() {
    if !traces() {
        return;
    }
    for (exchanged, call, times) in [
        (true, "renameat2", 4),
        (true, "linkat", 2),
        (true, "unlinkat,unlink", 4),
        (false, "rename", 40),
        (false, "unlinkat,unlink", 4),
    ] {
        let sets = Sets::new(exchanged);
        let mut killed = 0;
        for when in 1..=times {
            let output = injected(&sets, &format!("{call}:signal=SIGKILL:when={when}"));
            killed += u32::from(!output.status.success());
            sets.check(exchanged, &format!("exchanged {exchanged}, {call} {when}"));
        }
        assert!(killed > 0, "{call}: nothing was killed");
        println!("exchanged {exchanged}: {killed} of {times} killed at {call}");
    }
}

/// A killed run's lock is free, a living one's is not: nobody clears what is still being written.
#[test]
fn what_a_living_run_writes_is_not_cleared() {
    if !traces() {
        return;
    }
    let sets = Sets::new(true);
    let mut slow = Command::new("strace");
    slow.args([
        "-f",
        "-qq",
        "-o",
        "/dev/null",
        "-e",
        "inject=fdatasync:delay_enter=100000",
    ]);
    slow.arg(env!("CARGO_BIN_EXE_gearlash"))
        .args(sets.words("new"));
    slow.current_dir(sets.folder.path()).stdout(Stdio::null());
    let mut slow = slow.spawn().unwrap();
    let begun = Instant::now();
    while temporary(sets.folder.path()).is_empty() && begun.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(5));
    }
    for _ in 0..10 {
        let other = run(sets.folder.path(), "init beside.toml");
        assert!(other.status.success());
        std::fs::remove_file(sets.folder.path().join("beside.toml")).unwrap();
    }
    assert!(slow.wait().unwrap().success());
    assert!(sets.found() == sets.new);
}
