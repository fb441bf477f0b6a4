//! Files of measured gears by names and patterns. Matches that are no such file are reported.

use glob::{MatchOptions, Pattern};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};

/// Most files and folders that are compared with a pattern: twice the gears that a list can have.
const MAX_VISITED: usize = 200_000;

#[derive(Debug, Default)]
pub struct Named {
    /// Files, in the order of their names.
    pub files: Vec<PathBuf>,
    /// Matches that are ignored, and why.
    pub left_out: Vec<String>,
    /// Matches that cannot be read, and why.
    pub faults: Vec<String>,
}

/// The files that `name` stands for, relative to `folder`. `*`, `?` and `[` match letters within one path component. Case
/// matters.
pub fn named(folder: &Path, name: &str) -> Named {
    let mut named = Named::default();
    if !name.contains(['*', '?', '[']) {
        let path = folder.join(name);
        match path.symlink_metadata() {
            Err(error) if error.kind() == ErrorKind::NotFound => (),
            _ => named.add(path, false),
        }
        return named;
    }
    let found = found(folder, name, &mut named.faults).unwrap_or_else(|error| {
        named.faults.push(format!("{name:?}: {error}"));
        Vec::new()
    });
    for (path, is_as_written) in found {
        if is_as_written {
            named.add(path, true)
        } else {
            named.left_out.push(format!(
                "{}: is as {name:?} but for capital letters, and is left out",
                path.display()
            ))
        }
    }
    named
}

/// Every path that matches the pattern `name`, in the order of the names, and whether case matched. Read errors are added to `faults`.
///
/// File names need not be UTF-8: an invalid byte counts as one letter.
fn found(
    folder: &Path,
    name: &str,
    faults: &mut Vec<String>,
) -> Result<Vec<(PathBuf, bool)>, String> {
    if name.contains("**") {
        return Err("`**` is not allowed, name each folder".to_owned());
    }
    let mut found = vec![(folder.to_path_buf(), true)];
    let mut visited = 0;
    for part in Path::new(name).components() {
        let text = part.as_os_str().to_string_lossy();
        if part == Component::CurDir {
            continue;
        }
        if !text.contains(['*', '?', '[']) {
            found.iter_mut().for_each(|(path, _)| path.push(part));
            found.retain(|(path, _)| path.symlink_metadata().is_ok());
            continue;
        }
        let pattern = Pattern::new(&text).map_err(|error| error.msg.to_owned())?;
        let mut next = Vec::new();
        for (path, is_as_written) in found {
            let inner = entries(&path, faults);
            visited += inner.len();
            if visited > MAX_VISITED {
                let reason = format!("a pattern meets more than {MAX_VISITED} files and folders");
                faults.push(reason);
                return Ok(Vec::new());
            }
            for path in inner {
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                let is_same = is_as_written && pattern.matches(&name);
                if pattern.matches_with(&name, IGNORE_CASE) {
                    next.push((path, is_same));
                }
            }
        }
        found = next;
    }
    Ok(found)
}

/// Matches names without regard to case.
const IGNORE_CASE: MatchOptions = MatchOptions {
    case_sensitive: false,
    require_literal_separator: false,
    require_literal_leading_dot: false,
};

/// The entries of `folder` by name; empty where it is no folder.
fn entries(folder: &Path, faults: &mut Vec<String>) -> Vec<PathBuf> {
    let at = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    if !at.is_dir() {
        return Vec::new();
    }
    let names = std::fs::read_dir(at).and_then(|entries| {
        let names = entries.map(|entry| Ok(entry?.file_name()));
        names.collect::<std::io::Result<Vec<OsString>>>()
    });
    match names {
        Ok(mut names) => {
            names.sort();
            names.into_iter().map(|name| folder.join(name)).collect()
        }
        Err(error) => {
            faults.push(format!("{}: {error}", folder.display()));
            Vec::new()
        }
    }
}

impl Named {
    /// Adds the file at `path`. A folder is ignored where a pattern matched it.
    fn add(&mut self, path: PathBuf, is_of_pattern: bool) {
        let name = path.display();
        match path.metadata() {
            Ok(found) if found.is_file() => self.files.push(path),
            Ok(found) if found.is_dir() && is_of_pattern => {
                let reason = "is a folder, and is left out";
                self.left_out.push(format!("{name}: {reason}"));
            }
            Ok(_) => self.faults.push(format!("{name}: this is no file")),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                let reason = "this is a link to a file that is not there";
                self.faults.push(format!("{name}: {reason}"));
            }
            Err(error) => self.faults.push(format!("{name}: {error}")),
        }
    }
}

/// Files of one folder whose names differ only in the extension, such as `p1.toml` and `p1.json`: the gear is ambiguous.
pub fn duplicates(files: &[PathBuf]) -> Vec<String> {
    let mut first: BTreeMap<(PathBuf, OsString), &PathBuf> = BTreeMap::new();
    let mut duplicates = Vec::new();
    for path in files {
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        let stem = path.file_stem().unwrap_or_default().to_os_string();
        let before = *first.entry((folder, stem)).or_insert(path);
        if before != path {
            duplicates.push(format!(
                "{} and {}: two files of one gear",
                before.display(),
                path.display()
            ));
        }
    }
    duplicates
}
