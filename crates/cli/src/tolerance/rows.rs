//! Files of rows: the one that a run writes, and those for statistics.

use super::is_own;
use crate::error::Error;
use crate::output::folder_of;
use crate::signals;
use gearlash::population::{Row, Tally};
use gearlash_input::tolerance::{RowsHead, RowsTally, ToleranceRun, matching_files, row_line};
use gearlash_text::characters::shell_word;
use gearlash_text::has_extension;
use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A new file of rows, which grows block by block.
pub(super) struct RowsFile<'a> {
    path: PathBuf,
    file: File,
    /// Whether it is an ordinary file, no pipe or device.
    is_file: bool,
    /// Bytes of whole rows.
    length: u64,
    /// The assemblies still to be written.
    left: Range<u64>,
    run: &'a ToleranceRun<'a>,
    /// Whether statistics of these rows follow.
    is_whole: bool,
}

fn wrong(path: &Path, reason: impl std::fmt::Display) -> Error {
    Error::Usage(format!("--rows {}: {reason}", path.display()))
}

impl<'a> RowsFile<'a> {
    /// Begins the file at `path` with the header of the assemblies `numbers`.
    pub fn begin(
        path: &Path,
        run: &'a ToleranceRun<'a>,
        numbers: Range<u64>,
        is_whole: bool,
    ) -> Result<RowsFile<'a>, Error> {
        if has_extension(path, &["parquet"]) {
            return Err(wrong(
                path,
                "Parquet is gone: rows are CSV, which pandas, polars and DuckDB convert; name a file that ends in .csv",
            ));
        }
        let found = std::fs::metadata(path).ok();
        let is_file = found.as_ref().is_none_or(|found| found.is_file());
        if found.is_some_and(|found| found.is_dir()) {
            return Err(wrong(path, "this is a folder; name a file in it"));
        }
        let opened = if is_file {
            let folder = path.parent().filter(|one| !one.as_os_str().is_empty());
            let made = folder.map_or(Ok(()), std::fs::create_dir_all);
            made.and_then(|()| OpenOptions::new().write(true).create_new(true).open(path))
        } else {
            OpenOptions::new().write(true).open(path)
        };
        let file = opened.map_err(|error| match error.kind() {
            ErrorKind::AlreadyExists => wrong(
                path,
                "there is such a file, and rows never replace one; name a new file",
            ),
            _ => wrong(path, format!("cannot be written: {error}")),
        })?;
        let head = RowsHead::of(run, numbers.start, numbers.end - numbers.start);
        let mut rows = RowsFile {
            path: path.to_path_buf(),
            file,
            is_file,
            length: 0,
            left: numbers,
            run,
            is_whole,
        };
        rows.append(&head.lines(), 0)?;
        Ok(rows)
    }

    /// Appends `rows`, the next assemblies.
    pub fn write(&mut self, rows: &[Row]) -> Result<(), Error> {
        let text: String = rows.iter().map(row_line).collect();
        self.append(&text, rows.len() as u64)
    }

    /// Appends `text`, the rows of `count` assemblies. A signal waits for its end, and then prints how to go on.
    fn append(&mut self, text: &str, count: u64) -> Result<(), Error> {
        signals::keep(|| {
            let written = self.file.write_all(text.as_bytes());
            written.map_err(|error| self.failed(&error))?;
            self.length += text.len() as u64;
            self.left.start += count;
            Ok(self.is_file.then(|| self.resume_instructions()))
        })
    }

    /// Writes the file to the disk.
    pub fn finish(self) -> Result<(), Error> {
        let done = if self.is_file {
            self.file.sync_all()
        } else {
            Ok(())
        };
        done.map_err(|error| self.failed(&error))
    }

    /// Removes the file.
    pub fn remove(self) {
        if self.is_file {
            // A file that cannot be removed still ends with whole rows.
            let _ = std::fs::remove_file(&self.path);
        }
    }

    /// The error of a failed write; whole rows are kept.
    fn failed(&self, error: &std::io::Error) -> Error {
        let reason = format!("cannot be written: {error}");
        if self.length == 0 || !self.is_file {
            if self.is_file {
                let _ = std::fs::remove_file(&self.path);
            }
            return wrong(&self.path, format!("{reason}; name a file on another disk"));
        }
        let _ = self.file.set_len(self.length);
        wrong(
            &self.path,
            format!("{reason}; {}", self.resume_instructions()),
        )
    }

    /// The rows of the file, and the commands that compute the rest.
    fn resume_instructions(&self) -> String {
        let path = shell_word(&self.path);
        let next = self.left.start;
        let from = |files: &str| format!("`{}`", self.run.statistics_command(files));
        if self.left.is_empty() {
            let all = format!("all rows are in {path}");
            return if self.is_whole {
                format!("{all}: {} gives their statistics", from(&path))
            } else {
                all
            };
        }
        let stem = self.path.file_stem().unwrap_or_default().to_string_lossy();
        let rest = self.path.with_file_name(format!("{stem}_{next}.csv"));
        let command = self.run.rows_command(self.left.clone(), &rest);
        let mut text =
            format!("the rows before assembly {next} are in {path}: go on with `{command}`");
        if self.is_whole {
            text += &format!(", then {}", from(&format!("{path} {}", shell_word(&rest))));
        }
        text
    }
}

/// An error where rows at `path` would replace a result in `folder`.
pub(super) fn check_not_result(path: &Path, folder: &Path) -> Result<(), Error> {
    let parent = folder_of(path);
    let real = |path: &Path| path.canonicalize().ok();
    // Some file systems ignore case.
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if is_own(&name.to_ascii_lowercase()) && real(parent).is_some_and(|at| Some(at) == real(folder))
    {
        return Err(wrong(
            path,
            format!("the results themselves have a file called {name} there; take another name"),
        ));
    }
    Ok(())
}

/// The files that `names` stand for.
pub(super) fn expanded(names: &[PathBuf]) -> Result<Vec<PathBuf>, Error> {
    let (mut files, mut errors) = (Vec::new(), Vec::new());
    for name in names {
        // A name with a star can be that of a file.
        if name.is_file() {
            files.push(name.clone());
            continue;
        }
        let found = matching_files(Path::new(""), &name.to_string_lossy());
        let faults = found.faults.iter();
        errors.extend(faults.map(|fault| Error::Usage(format!("--from-rows {fault}"))));
        if found.faults.is_empty() && found.files.is_empty() {
            errors.push(Error::Usage(format!(
                "--from-rows {}: no such file; name files that gearlash tolerance --rows wrote",
                name.display()
            )));
        }
        files.extend(found.files);
    }
    one_or_several(errors).map(|()| files)
}

fn one_or_several(mut errors: Vec<Error>) -> Result<(), Error> {
    match errors.len() {
        0 => Ok(()),
        1 => Err(errors.remove(0)),
        _ => Err(Error::Several(errors)),
    }
}

/// The sums over the rows in `files`, which must have every assembly of `run` once.
pub(super) fn read(run: &ToleranceRun, files: &[PathBuf]) -> Result<Tally, Error> {
    let mut rows = RowsTally::new(run);
    let added = files.iter().map(|path| rows.add_file(path));
    one_or_several(added.filter_map(Result::err).map(Error::Input).collect())?;
    Ok(rows.finish()?)
}
