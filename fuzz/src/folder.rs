//! Files in memory: the library reads pair files and tables from paths.

use gearlash::error::Error;
use gearlash_files as input;
use gearlash::study::Study;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A folder in memory where there is one, with the pair file `pair` and beside it `others`, until it is dropped.
pub struct Folder(TempDir);

impl Folder {
    pub fn new(pair: &str, others: &[(&str, &[u8])]) -> Folder {
        let folder = Folder(
            TempDir::new_in("/dev/shm")
                .or_else(|_| TempDir::new())
                .unwrap(),
        );
        folder.write("pair", pair.as_bytes());
        for (name, bytes) in others {
            folder.write(name, bytes);
        }
        folder
    }

    fn write(&self, name: &str, bytes: &[u8]) {
        fs::write(self.0.path().join(name), bytes).unwrap();
    }

    /// The study of the pair file; `None` where the file is wrong and every problem says so as it must.
    pub fn read(&self) -> Option<Study> {
        read(&self.0.path().join("pair"))
    }

    /// The same, and what was understood of a good file reads again as the same.
    pub fn read_twice(&self) -> Option<Study> {
        let study = self.read()?;
        self.write("echo.json", study.echo.to_string().as_bytes());
        let again = read(&self.0.path().join("echo.json")).expect("the echo is no good pair file");
        assert!(again.materials == study.materials, "{}", study.echo);
        assert_eq!(again.echo, study.echo);
        Some(study)
    }
}

fn read(path: &Path) -> Option<Study> {
    let error = match input::read(path) {
        Ok(study) => return Some(study),
        Err(error) => error,
    };
    let Error::Input { problems, .. } = &error else {
        panic!("{error}");
    };
    assert!(!problems.is_empty());
    for problem in problems {
        assert!(
            !problem.reason.is_empty() && !problem.help.is_empty(),
            "{problem}"
        );
    }
    for line in error.lines() {
        assert!(!line.contains(char::is_control), "{line:?}");
    }
    None
}
