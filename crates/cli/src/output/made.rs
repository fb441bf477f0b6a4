//! Folders that are made for results, and removed again unless they are kept.

use super::{failed, unfinished};
use crate::error::Error;
use std::path::{Path, PathBuf};

/// Folders made for results, removed when dropped.
pub(super) struct Made {
    /// Innermost last.
    folders: Vec<PathBuf>,
}

impl Made {
    /// None.
    pub fn none() -> Made {
        Made {
            folders: Vec::new(),
        }
    }

    /// Makes the folder at `path` and those above it that are missing.
    pub fn folder(path: &Path) -> Result<Made, Error> {
        let missing = path
            .ancestors()
            .take_while(|p| !p.as_os_str().is_empty() && !p.exists());
        let mut folders: Vec<PathBuf> = missing.map(Path::to_path_buf).collect();
        folders.reverse();
        let mut list = unfinished();
        list.made.extend(folders.iter().cloned());
        let made = Made { folders };
        let result = std::fs::create_dir_all(path).map_err(failed(path));
        drop(list);
        result.map(|()| made)
    }

    /// Keeps them.
    pub fn keep(&mut self) {
        let mut list = unfinished();
        list.made.retain(|other| !self.folders.contains(other));
        self.folders.clear();
    }
}

impl Drop for Made {
    fn drop(&mut self) {
        let mut list = unfinished();
        for folder in self.folders.iter().rev() {
            // Fails if the folder is not empty, as it should.
            let _ = std::fs::remove_dir(folder);
        }
        list.made.retain(|other| !self.folders.contains(other));
    }
}
