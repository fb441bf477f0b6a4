//! Files in memory: the library reads pair files and tables from paths.

use gearlash::analysis::study::Study;
use gearlash_input::PairFile;
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

    /// The study of the pair file; `None` for a file with well-formed problems.
    pub fn read(&self) -> Option<Study> {
        self.file().map(|file| file.study)
    }

    fn file(&self) -> Option<PairFile> {
        read(&self.0.path().join("pair"))
    }

    /// The study of the pair file. The echo of a good file must read as the same study.
    pub fn read_twice(&self) -> Option<Study> {
        let file = self.file()?;
        self.write("echo.json", serde_json::to_string(&file.spec).expect("the spec is no JSON").as_bytes());
        let again = read(&self.0.path().join("echo.json")).expect("the echo is no good pair file");
        assert!(
            again.study.materials == file.study.materials,
            "{:#?}",
            file.spec
        );
        assert_eq!(again.spec, file.spec);
        Some(file.study)
    }
}

fn read(path: &Path) -> Option<PairFile> {
    let error = match gearlash_input::read(path) {
        Ok(file) => return Some(file),
        Err(error) => error,
    };
    assert!(!error.problems.is_empty());
    for problem in &error.problems {
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
