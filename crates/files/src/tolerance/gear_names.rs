//! The files that names of measured gears stand for: what stands among them and is none is told, never passed over.

use glob::MatchOptions;
use std::collections::{BTreeMap, HashSet};
use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// What a name stands for.
#[derive(Debug, Default)]
pub struct Named {
    /// Files, in the order of their names.
    pub files: Vec<PathBuf>,
    /// What is left out, and why.
    pub left_out: Vec<String>,
    /// What cannot be read, and why.
    pub faults: Vec<String>,
}

/// The files that `name` stands for, relative to `folder`. `*`, `?` and `[` stand for letters of a file's name, as capital as they are.
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
    let text = folder.to_string_lossy();
    let pattern = match (text.as_ref(), Path::new(name).is_absolute()) {
        ("", _) | (_, true) => name.to_owned(),
        (folder, false) => format!("{}/{name}", glob::Pattern::escape(folder)),
    };
    let as_written = match glob::glob(&pattern) {
        Ok(found) => found,
        Err(error) => {
            named.faults.push(format!("{name:?}: {}", error.msg));
            return named;
        }
    };
    let mut all = HashSet::new();
    for found in as_written {
        match found {
            Ok(path) => {
                all.insert(path.clone());
                named.add(path, true);
            }
            Err(error) => {
                let (path, reason) = (error.path().display(), error.error());
                named.faults.push(format!("{path}: {reason}"));
            }
        }
    }
    let either = MatchOptions {
        case_sensitive: false,
        ..MatchOptions::new()
    };
    // What cannot be read was told.
    let others = glob::glob_with(&pattern, either).into_iter().flatten();
    for path in others.flatten().filter(|path| !all.contains(path)) {
        named.left_out.push(format!(
            "{}: is as {name:?} but for capital letters, and is left out",
            path.display()
        ));
    }
    named
}

impl Named {
    /// The file at `path`; one of several that a pattern stands for may be a folder.
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

/// Files of one folder and one name that differ in their endings, such as `p1.toml` and `p1.json`: which of them is the gear?
pub fn doubled(files: &[PathBuf]) -> Vec<String> {
    let mut first: BTreeMap<(PathBuf, OsString), &PathBuf> = BTreeMap::new();
    let mut doubled = Vec::new();
    for path in files {
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        let stem = path.file_stem().unwrap_or_default().to_os_string();
        let before = *first.entry((folder, stem)).or_insert(path);
        if before != path {
            doubled.push(format!(
                "{} and {}: two files of one gear",
                before.display(),
                path.display()
            ));
        }
    }
    doubled
}
