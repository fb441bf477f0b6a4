//! Files, streams and signals, through the built binary: nothing lost, nothing half done, whatever happens to it.

#![cfg(target_os = "linux")]

mod failures;
mod kills;
mod signals;
#[path = "../../../../tests/common/skip.rs"]
mod skip;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn gearlash(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gearlash"));
    command.current_dir(folder).stdin(Stdio::null());
    command
}

/// Runs the program with words separated by blanks.
fn run(folder: &Path, words: &str) -> Output {
    gearlash(folder)
        .args(words.split_whitespace())
        .output()
        .unwrap()
}

fn stderr_of(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A pair of 20 and 17 teeth at `distances` mm that runs in no time.
fn pair(distances: &str) -> String {
    format!(
        "title = \"small\"\n\
         [wheel]\nteeth = 20\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nrunout = {{ total_um = 12.0, high_tooth = 3.5 }}\n\
         [pinion]\nteeth = 17\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nreference_face = \"back\"\n\
         [assembly]\ncenter_distance_mm = {distances}\n[sweep]\nmating = [[1, 1]]\n"
    )
}

/// A temporary folder with `p.toml`, the pair of two distances.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("p.toml"), pair("[37.1, 37.2]")).unwrap();
    folder
}

/// Everything below `folder`; what a living run takes away meanwhile may be missing.
fn paths(folder: &Path) -> Vec<(PathBuf, std::fs::FileType)> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        let entries = match std::fs::read_dir(&next) {
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => continue,
            entries => entries.unwrap(),
        };
        for entry in entries.map(Result::unwrap) {
            let (path, kind) = (entry.path(), entry.file_type().unwrap());
            if kind.is_dir() {
                open.push(path.clone());
            }
            found.push((path, kind));
        }
    }
    found
}

/// Everything below `folder`: by path, the content of files, where links lead, nothing of folders.
fn contents(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let content = |path: &Path, kind: &std::fs::FileType| match (kind.is_dir(), kind.is_symlink()) {
        (true, _) => b"folder".to_vec(),
        (_, true) => std::fs::read_link(path)
            .unwrap()
            .into_os_string()
            .into_encoded_bytes(),
        _ if kind.is_file() => std::fs::read(path).unwrap(),
        _ => b"special".to_vec(),
    };
    let below = |path: &Path| path.strip_prefix(folder).unwrap().to_path_buf();
    let found = paths(folder).into_iter();
    found
        .map(|(path, kind)| (below(&path), content(&path, &kind)))
        .collect()
}

/// The temporary files that a run left below `folder`.
fn temporary(folder: &Path) -> Vec<PathBuf> {
    let below = |path: PathBuf| path.strip_prefix(folder).unwrap().to_path_buf();
    let found = paths(folder).into_iter().map(|(path, _)| below(path));
    found.filter(|path| is_temporary(path)).collect()
}

fn is_temporary(path: &Path) -> bool {
    let mut parts = path.iter().map(|part| part.to_string_lossy());
    parts.any(|part| part.starts_with(".gearlash-") || part.starts_with(".tmp"))
}
