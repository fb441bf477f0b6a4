//! Faults of a pair file before its first line. `tests/corpus/bad` holds the other bad files.

use gearlash_files::read;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// The only problem of the file at `path`.
fn problem(path: &Path) -> String {
    let error = read(path).unwrap_err();
    assert_eq!(error.problems.len(), 1, "{error}");
    error.to_string()
}

#[test]
fn what_is_no_text_is_refused() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("pair.toml");
    assert!(problem(&path).ends_with("there is no such file; check name and folder"));
    assert!(problem(folder.path()).ends_with("is a folder; name the file in it"));
    fs::write(&path, b"title = \"a\"\ntitle = \"\xe4\"\n").unwrap();
    assert!(problem(&path).ends_with("line 2: not UTF-8 text; save the file as UTF-8"));
    let file = fs::File::create(&path).unwrap();
    file.set_len((16 << 20) + 1).unwrap();
    let found = problem(&path);
    assert!(
        found.contains("has 16.0 MiB, allowed is up to 16 MiB"),
        "{found}"
    );
}
