//! Files through the built binary: nothing lost, nothing half done, whatever happens to it. `tests/sessions/{links,results_replaced,signals,streams}.txt`
//! hold what a shell can do.

#![cfg(target_os = "linux")]

mod failures;
mod kills;
#[path = "../../../../tests/common/skip.rs"]
mod skip;

use skip::skip;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

type Set = BTreeMap<PathBuf, Vec<u8>>;

/// The options of every run, behind its pair file.
const OPTIONS: [&str; 4] = ["--snapshots", "-o", "results", "--format=csv"];

/// Two pairs whose runs write files of the same names, and these files.
struct Sets {
    folder: tempfile::TempDir,
    old: Set,
    new: Set,
}

impl Sets {
    fn new() -> Sets {
        let folder = tempfile::tempdir().unwrap();
        for (name, total) in [("old", "12.0"), ("new", "20.0")] {
            let text = format!(
                "[wheel]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nrunout = {{ total_um = {total}, high_tooth = 3.5 }}\n\
                 [pinion]\nteeth = 17\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nreference_face = \"back\"\n\
                 [assembly]\ncenter_distance_mm = [37.1, 37.15, 37.2, 37.25, 37.3, 37.35]\n[sweep]\nmating = [[1, 1]]\n"
            );
            std::fs::write(folder.path().join(format!("{name}.toml")), text).unwrap();
        }
        std::fs::create_dir(folder.path().join("results")).unwrap();
        std::fs::write(folder.path().join("results/mine"), "mine").unwrap();
        let mut sets = Sets {
            folder,
            old: Set::new(),
            new: Set::new(),
        };
        sets.write("new.toml");
        sets.new = sets.in_place();
        sets.write("old.toml");
        sets.old = sets.in_place();
        assert!(sets.old.len() == 16 && sets.old.keys().eq(sets.new.keys()));
        sets
    }

    /// The command that writes the files of a pair; `before` is what runs it.
    fn command(&self, before: &[&str], pair: &str) -> Command {
        let words = [before, &[env!("CARGO_BIN_EXE_gearlash"), "simulate", pair]].concat();
        let mut command = Command::new(words[0]);
        command.args(&words[1..]).args(OPTIONS);
        command.current_dir(self.folder.path()).stdin(Stdio::null());
        command
    }

    fn write(&self, pair: &str) {
        let output = self.command(&[], pair).output().unwrap();
        assert!(output.status.success(), "{}", stderr_of(&output));
    }

    /// The files of the old run, after whatever happened.
    fn restore(&self) {
        self.write("old.toml");
        assert!(self.in_place() == self.old);
    }

    /// The program under strace, with something done to one system call.
    fn injected(&self, injection: &str) -> Output {
        let injection = format!("inject={injection}");
        let strace = ["strace", "-f", "-qq", "-o", "/dev/null", "-e", &injection];
        self.command(&strace, "new.toml").output().unwrap()
    }

    /// The files but for temporary ones.
    fn in_place(&self) -> Set {
        let mut found = contents(&self.folder.path().join("results"));
        found.retain(|path, _| !is_temporary(path));
        found
    }

    /// Every file is the old one or the new one; `result.json` is new only where all are.
    fn check(&self, when: &str) {
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

fn stderr_of(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Every file below `folder`, by path.
fn contents(folder: &Path) -> Set {
    let mut found = Set::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        for entry in std::fs::read_dir(&next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap().to_path_buf();
                found.insert(name, std::fs::read(&path).unwrap());
            }
        }
    }
    found
}

fn is_temporary(path: &Path) -> bool {
    let mut parts = path.iter().map(|part| part.to_string_lossy());
    parts.any(|part| part.starts_with(".gearlash-") || part.starts_with(".tmp"))
}

/// Whether strace is there and may trace; says so where not.
fn traces() -> bool {
    let traced = Command::new("strace")
        .args(["-f", "-o", "/dev/null", "true"])
        .output();
    let traces = traced.is_ok_and(|output| output.status.success());
    if !traces {
        skip("needs strace and the right to trace");
    }
    traces
}
