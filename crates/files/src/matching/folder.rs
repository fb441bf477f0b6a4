//! The gear files of a folder.

use crate::error::{InputError, Problem};
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};

/// The gear files of `folder`, those with the ending `.toml` or `.json`, in the order of their names.
///
/// An entry that cannot be read, is no file, or has the name of another gear becomes one of `errors`.
pub fn gear_files(folder: &Path, errors: &mut Vec<InputError>) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).and_then(Iterator::collect::<io::Result<Vec<_>>>);
    let entries = match entries {
        Ok(entries) => entries,
        Err(reason) => {
            let reason = format!("cannot be read: {reason}");
            errors.push(problem(folder, &reason, "name a folder of gear files"));
            return Vec::new();
        }
    };
    let mut files: Vec<PathBuf> = entries.into_iter().map(|entry| entry.path()).collect();
    files.retain(|path| is_named_as_one(path));
    files.sort();
    if files.is_empty() {
        errors.push(problem(
            folder,
            "holds no gear file (.toml, .json)",
            "name a folder of gear files, one a gear",
        ));
    }
    files.retain(|path| {
        // Reading a pipe or other special file might never end.
        let reason = match std::fs::metadata(path) {
            Ok(found) if found.is_file() => return true,
            Ok(_) => "is no file".to_owned(),
            Err(reason) => format!("cannot be read: {reason}"),
        };
        let help = "correct it, or remove it from the folder";
        errors.push(problem(path, &reason, help));
        false
    });
    let mut names: BTreeMap<&OsStr, &Path> = BTreeMap::new();
    for path in &files {
        let name = path.file_stem().unwrap_or_default();
        let first = *names.entry(name).or_insert(path);
        if first != path {
            let first = first.file_name().unwrap_or_default().display();
            let reason = format!("{first} is a gear of the same name");
            let help = "rename one of them, or remove it: a gear has the name of its file without the ending";
            errors.push(problem(path, &reason, help));
        }
    }
    files
}

fn is_named_as_one(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default();
    let mut known = ["toml", "json"].into_iter();
    known.any(|known| ending.eq_ignore_ascii_case(known))
}

fn problem(path: &Path, reason: &str, help: &str) -> InputError {
    InputError::of(path, vec![Problem::of_file(reason, help)])
}
