//! One reading of a file: the folder of its files, the files read, problems and remarks.

use crate::error::Problem;
use crate::inches::Inches;
use crate::node::Node;
use crate::sources::{Files, Sources};
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// Problems of one list that are reported one by one; the others are counted. Tuned: they fit a screen beside others.
const MAX_OF_A_LIST: usize = 12;

/// The reading of a file and of the files that it names.
#[derive(Debug, Default)]
pub struct Reading {
    /// Its name in messages.
    name: PathBuf,
    /// Empty: the working folder.
    folder: PathBuf,
    /// The files that it names, where they are given by name and bytes.
    files: Option<Rc<Files>>,
    /// Whether the user names the file itself: its text is shown wherever it is.
    is_named: bool,
    /// No result may be written over these.
    sources: RefCell<Sources>,
    remarks: RefCell<Vec<String>>,
    inches: RefCell<Inches>,
    problems: RefCell<Problems>,
    /// Keys whose values do not fit the schema, and the keys that mistyped ones mean.
    bad_keys: RefCell<Vec<String>>,
}

impl Reading {
    /// The reading of the file at `path`, which is itself the first source. Standard input has the working folder.
    pub fn of(path: &Path) -> Reading {
        let reading = Reading::default();
        let standard_input = path == Path::new(crate::STANDARD_INPUT);
        // A link to the file behind standard input, on Unix.
        let source = if standard_input {
            Path::new("/dev/stdin")
        } else {
            path
        };
        reading.sources.borrow_mut().add(source);
        Reading {
            folder: path.parent().unwrap_or(Path::new("")).to_path_buf(),
            ..reading
        }
    }

    /// The reading of a text whose files are among `files`.
    pub fn of_files(files: Rc<Files>) -> Reading {
        Reading {
            files: Some(files),
            ..Reading::default()
        }
    }

    /// The reading of a file that the user names.
    pub fn of_named() -> Reading {
        Reading {
            is_named: true,
            ..Reading::default()
        }
    }

    /// This reading of a file that messages call `name`.
    pub fn called(self, name: &Path) -> Reading {
        Reading {
            name: name.to_path_buf(),
            ..self
        }
    }

    /// The file's name in messages.
    pub fn name(&self) -> &Path {
        &self.name
    }

    /// The files that it names, where they are given by name and bytes.
    pub fn files(&self) -> Option<&Files> {
        self.files.as_deref()
    }

    /// Whether the real place of `path`, links followed, is not below its folder. A file that does not exist is outside.
    pub fn is_outside(&self, path: &Path) -> bool {
        if self.is_named || self.files.is_some() {
            return false;
        }
        let folder = if self.folder.as_os_str().is_empty() {
            Path::new(".")
        } else {
            &self.folder
        };
        match (path.canonicalize(), folder.canonicalize()) {
            (Ok(path), Ok(folder)) => !path.starts_with(folder),
            _ => true,
        }
    }

    /// The folder that relative paths start from.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Resolves `name` and records it as a source.
    pub fn file(&self, name: &str) -> PathBuf {
        let path = self.folder.join(name);
        if self.files.is_none() {
            self.sources.borrow_mut().add(&path);
        }
        path
    }

    /// Adds files that were read.
    pub fn read_too(&self, others: &Sources) {
        self.sources.borrow_mut().extend(others);
    }

    /// The files that were read.
    pub fn sources(&self) -> Sources {
        self.sources.borrow().clone()
    }

    /// Adds a remark.
    pub fn add_remark(&self, remark: Option<String>) {
        self.remarks.borrow_mut().extend(remark);
    }

    /// The remarks since the last call.
    pub fn take_remarks(&self) -> Vec<String> {
        self.remarks.take()
    }

    /// Turns all lengths of the file into mm.
    pub fn to_mm(&self, entries: &mut Vec<(String, Node)>) {
        let mut inches = Inches::to_mm(entries);
        let problems = inches.in_both_units.drain(..);
        problems.for_each(|problem| self.add(problem));
        self.inches.replace(inches);
    }

    /// Adds a problem.
    pub fn add(&self, problem: Problem) {
        self.problems.borrow_mut().add(problem);
    }

    /// Adds a problem; always `None`.
    pub fn refuse<T>(&self, problem: Problem) -> Option<T> {
        self.add(problem);
        None
    }

    /// The value, or `None` with its problem added.
    pub fn keep<T>(&self, result: Result<T, Problem>) -> Option<T> {
        result.map_err(|problem| self.add(problem)).ok()
    }

    /// The result of `read` for the list at `key`; `None` where it adds a problem. Only the first dozen are reported.
    pub fn list<T>(&self, key: &str, read: impl FnOnce() -> Option<T>) -> Option<T> {
        let (read, problems) = self.capture_problems(read);
        let is_good = problems.is_empty();
        self.add_list(key, problems);
        read.filter(|_| is_good)
    }

    /// The result of `read`, and the problems of one list that it adds.
    pub fn capture_problems<T>(&self, read: impl FnOnce() -> T) -> (T, Problems) {
        let inner = Problems {
            is_list: true,
            ..Problems::default()
        };
        let outer = self.problems.replace(inner);
        let read = read();
        (read, self.problems.replace(outer))
    }

    /// Adds the problems of the list at `key`.
    pub fn add_list(&self, key: &str, list: Problems) {
        let mut problems = self.problems.borrow_mut();
        problems.listed.extend(list.listed);
        if list.more > 0 {
            let reason = format!("{} more problems like the last one", list.more);
            let more = Problem::at(key, reason, "fix those first");
            problems.listed.push(more);
        }
    }

    /// Counts a problem beyond the reported ones; whether it did so.
    pub fn count_if_full(&self) -> bool {
        let mut problems = self.problems.borrow_mut();
        let is_full = problems.is_full();
        problems.more += usize::from(is_full);
        is_full
    }

    /// Whether the list has its maximum of reported problems.
    pub fn is_full(&self) -> bool {
        self.problems.borrow().is_full()
    }

    /// Whether no problem was added.
    pub fn is_good(&self) -> bool {
        self.problems.borrow().is_empty()
    }

    /// Marks the value at `key` as one that cannot be read.
    pub fn mark_bad(&self, key: String) {
        let mut bad = self.bad_keys.borrow_mut();
        if bad.last() != Some(&key) {
            bad.push(key);
        }
    }

    /// Whether `such` holds for a marked key.
    pub(crate) fn has_bad(&self, such: impl Fn(&str) -> bool) -> bool {
        self.bad_keys.borrow().iter().any(|key| such(key))
    }

    /// All problems since the last call.
    pub fn take_problems(&self) -> Vec<Problem> {
        let mut problems = self.problems.take().listed;
        for problem in &mut problems {
            self.inches.borrow().restore(problem);
        }
        problems
    }
}

/// Problems in the order in which they were found.
#[derive(Debug, Default)]
pub struct Problems {
    listed: Vec<Problem>,
    is_list: bool,
    /// Problems of a list beyond those that are reported.
    more: usize,
}

impl Problems {
    fn add(&mut self, problem: Problem) {
        if self.is_full() {
            self.more += 1;
        } else {
            self.listed.push(problem);
        }
    }

    fn is_full(&self) -> bool {
        self.is_list && self.listed.len() >= MAX_OF_A_LIST
    }

    /// Whether no problem was added.
    pub fn is_empty(&self) -> bool {
        self.listed.is_empty()
    }

    /// The reported problems.
    pub fn into_list(self) -> Vec<Problem> {
        self.listed
    }
}
