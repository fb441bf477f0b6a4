//! Files by name and bytes, for a caller without a file system.

use crate::error::Problem;
use std::collections::BTreeMap;
use std::path::{Component, Path};

/// Files by name and bytes, in place of a folder. A name is relative to that folder, such as `wheel.csv` or `data/wheel.csv`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Files(BTreeMap<String, Vec<u8>>);

impl Files {
    /// No files.
    pub fn new() -> Files {
        Files::default()
    }

    /// Adds a file, in place of one with the same name.
    pub fn add(&mut self, name: &str, bytes: Vec<u8>) {
        self.0.insert(plain_name(Path::new(name)), bytes);
    }

    /// Takes a file out; whether there was one.
    pub fn remove(&mut self, name: &str) -> bool {
        self.0.remove(&plain_name(Path::new(name))).is_some()
    }

    /// The bytes of the file with this name.
    pub fn get(&self, name: &str) -> Option<&[u8]> {
        let bytes = self.0.get(&plain_name(Path::new(name)));
        bytes.map(Vec::as_slice)
    }

    /// The names, sorted.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// The bytes of the file called `path`. A file that was given without its folder counts where only one has its name.
    /// Errors: a problem where there is no such file.
    pub(crate) fn bytes(&self, path: &Path) -> Result<Vec<u8>, Problem> {
        let name = plain_name(path);
        let found = self.0.get(&name).or_else(|| {
            let last = path.file_name()?.to_str()?;
            self.0.get(last)
        });
        found.cloned().ok_or_else(|| {
            Problem::of_file(
                "is not among the files given",
                format!("add the file {}", name.rsplit('/').next().unwrap_or(&name)),
            )
        })
    }
}

/// `path` with `/` between its parts and without `.`.
fn plain_name(path: &Path) -> String {
    let text = path.to_string_lossy().replace('\\', "/");
    let parts = Path::new(&text)
        .components()
        .filter(|part| !matches!(part, Component::CurDir | Component::RootDir));
    let parts = parts.map(|part| part.as_os_str().to_string_lossy().into_owned());
    parts.collect::<Vec<_>>().join("/")
}
