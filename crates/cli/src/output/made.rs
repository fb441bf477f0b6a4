//! Folders that are created for results, and removed again unless they are kept.

use super::{failed, unfinished};
use crate::error::Error;
use std::path::{Path, PathBuf};

/// Folders created for results, removed when dropped.
#[derive(Default)]
pub(super) struct CreatedFolders {
    /// Innermost last.
    folders: Vec<PathBuf>,
}

impl CreatedFolders {
    /// Creates the folder at `path` and the missing ones above it.
    pub fn folder(path: &Path) -> Result<CreatedFolders, Error> {
        let missing = path
            .ancestors()
            .take_while(|p| !p.as_os_str().is_empty() && !p.exists());
        let mut folders: Vec<PathBuf> = missing.map(Path::to_path_buf).collect();
        folders.reverse();
        let mut list = unfinished();
        list.made.extend(folders.iter().cloned());
        let made = CreatedFolders { folders };
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

impl Drop for CreatedFolders {
    fn drop(&mut self) {
        let mut list = unfinished();
        for folder in self.folders.iter().rev() {
            // Fails for a folder with files, which must stay.
            let _ = std::fs::remove_dir(folder);
        }
        list.made.retain(|other| !self.folders.contains(other));
    }
}
