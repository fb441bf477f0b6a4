//! Where a pair file lies, and what has been read from there.

use crate::sources::Sources;
use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// The folder that the relative paths of a pair file start from. Every file that is read is kept in mind: no result may be
/// written over it.
#[derive(Debug)]
pub struct Place {
    folder: PathBuf,
    read: RefCell<Sources>,
    remarks: RefCell<Vec<String>>,
}

impl Place {
    /// That of the file at `path`, which is itself the first to be read.
    pub fn of(path: &Path) -> Place {
        let mut read = Sources::new();
        read.add(path);
        Place {
            folder: path.parent().unwrap_or(Path::new("")).to_path_buf(),
            read: RefCell::new(read),
            remarks: RefCell::default(),
        }
    }

    /// That of standard input: the working folder.
    pub fn of_standard_input() -> Place {
        let mut read = Sources::new();
        // A link to what it is, on Unix.
        read.add(Path::new("/dev/stdin"));
        Place {
            folder: PathBuf::new(),
            read: RefCell::new(read),
            remarks: RefCell::default(),
        }
    }

    /// The working folder, of names on a command line.
    pub fn of_working_folder() -> Place {
        Place {
            folder: PathBuf::new(),
            read: RefCell::new(Sources::new()),
            remarks: RefCell::default(),
        }
    }

    /// The folder of the pair file.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Where the file called `name` is. It will be read.
    pub fn file(&self, name: &str) -> PathBuf {
        let path = self.folder.join(name);
        self.read.borrow_mut().add(&path);
        path
    }

    /// `others` were read as well.
    pub fn read_too(&self, others: &Sources) {
        self.read.borrow_mut().extend(others);
    }

    /// Keeps a remark on a file.
    pub fn add_remark(&self, remark: Option<String>) {
        self.remarks.borrow_mut().extend(remark);
    }

    /// What was reported since the last time.
    pub fn take_remarks(&self) -> Vec<String> {
        self.remarks.take()
    }

    /// All that was read.
    pub fn sources(&self) -> Sources {
        self.read.borrow().clone()
    }
}
