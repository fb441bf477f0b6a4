//! The gear files of a folder.

use crate::error::{InputError, Problem};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};

/// The gear files of `folder`, those with the ending `.toml` or `.json`, in the order of their names.
///
/// An entry that cannot be read, is no file, or has the name of another gear becomes one of `errors`.
pub fn gear_files(folder: &Path, errors: &mut Vec<InputError>) -> Vec<PathBuf> {
    let unreadable = |reason: &io::Error| {
        problem(
            folder,
            &format!("cannot be read: {reason}"),
            "name a folder of gear files",
        )
    };
    let entries = std::fs::read_dir(folder).and_then(Iterator::collect::<io::Result<Vec<_>>>);
    let entries = match entries {
        Ok(entries) => entries,
        Err(reason) => {
            errors.push(unreadable(&reason));
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
    files.retain(|path| match no_file(path) {
        Some(reason) => {
            let help = "correct it, or remove it from the folder";
            errors.push(problem(path, &reason, help));
            false
        }
        None => true,
    });
    errors.extend(same_names(&files));
    files
}

fn is_named_as_one(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str());
    ending.is_some_and(|ending| {
        ["toml", "json"]
            .iter()
            .any(|known| ending.eq_ignore_ascii_case(known))
    })
}

/// The reason why the file at `path` is not read. Reading a pipe or other special file might never end.
fn no_file(path: &Path) -> Option<String> {
    match std::fs::metadata(path) {
        Err(reason) => Some(format!("cannot be read: {reason}")),
        Ok(found) => (!found.is_file()).then(|| "is no file".to_owned()),
    }
}

/// The errors of files whose gears have equal names.
fn same_names(files: &[PathBuf]) -> Vec<InputError> {
    let mut names: BTreeMap<OsString, &Path> = BTreeMap::new();
    let mut errors = Vec::new();
    for path in files {
        let name = path.file_stem().unwrap_or_default().to_os_string();
        let file = |path: &Path| path.file_name().unwrap_or_default().display().to_string();
        match names.get(&name) {
            Some(first) => errors.push(problem(
                path,
                &format!("{} is a gear of the same name", file(first)),
                "rename one of them, or remove it: a gear has the name of its file without the ending",
            )),
            None => {
                names.insert(name, path);
            }
        }
    }
    errors
}

fn problem(path: &Path, reason: &str, help: &str) -> InputError {
    InputError::of(path, vec![Problem::of_file(reason, help)])
}
