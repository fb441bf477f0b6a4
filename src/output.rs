//! Writing results: whole files or none.
//!
//! A folder is tried before the work begins, so that hours of it are not lost to
//! a typing mistake. Files are written beside their place under a temporary
//! name and renamed when all of them are complete; a failed run leaves what was there.

use crate::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// A folder that can be written to.
#[derive(Debug)]
pub struct OutputFolder {
    path: PathBuf,
    /// Folders made for it, innermost last: taken away again when nothing is written.
    made: Vec<PathBuf>,
}

impl OutputFolder {
    /// Makes the folder where it is missing and tries to write in it.
    ///
    /// # Errors
    /// [`Error::Output`] with the system's reason.
    pub fn prepare(path: &Path) -> Result<OutputFolder, Error> {
        let missing = path
            .ancestors()
            .take_while(|p| !p.as_os_str().is_empty() && !p.exists());
        let mut made: Vec<PathBuf> = missing.map(Path::to_path_buf).collect();
        made.reverse();
        let folder = OutputFolder {
            path: path.to_path_buf(),
            made,
        };
        std::fs::create_dir_all(path).map_err(|source| folder.failed(path, source))?;
        NamedTempFile::new_in(path).map_err(|source| folder.failed(path, source))?;
        Ok(folder)
    }

    /// Writes all `files` (name and content), each in one piece.
    ///
    /// # Errors
    /// [`Error::Output`]; nothing is renamed before everything is written.
    pub fn write(self, files: &[(String, String)]) -> Result<PathBuf, Error> {
        self.write_instead(files, &[])
    }

    /// [`OutputFolder::write`], and when all of them are in place removes the ordinary files named `stale`, where there are
    /// such. Folders and links of these names stay.
    ///
    /// # Errors
    /// As [`OutputFolder::write`]; a stale file that cannot be removed.
    pub fn write_instead(
        mut self,
        files: &[(String, String)],
        stale: &[String],
    ) -> Result<PathBuf, Error> {
        let mut written = Vec::new();
        for (name, content) in files {
            let target = self.path.join(name);
            let mut file = self
                .temporary()
                .map_err(|source| self.failed(&target, source))?;
            file.write_all(content.as_bytes())
                .and_then(|()| file.as_file().sync_all())
                .map_err(|source| self.failed(&target, source))?;
            written.push((file, target));
        }
        for (file, target) in written {
            file.persist(&target)
                .map_err(|error| self.failed(&target, error.error))?;
        }
        self.made.clear();
        for name in stale {
            let path = self.path.join(name);
            let ordinary = std::fs::symlink_metadata(&path).is_ok_and(|found| found.is_file());
            if ordinary {
                std::fs::remove_file(&path).map_err(|source| self.failed(&path, source))?;
            }
        }
        Ok(self.path.clone())
    }

    /// A temporary file with the permissions of an ordinary one.
    fn temporary(&self) -> std::io::Result<NamedTempFile> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(".gearlash-");
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // The process's umask still applies.
            builder.permissions(std::fs::Permissions::from_mode(0o666));
        }
        builder.tempfile_in(&self.path)
    }

    fn failed(&self, path: &Path, source: std::io::Error) -> Error {
        Error::Output {
            path: path.to_path_buf(),
            source,
        }
    }
}

impl Drop for OutputFolder {
    fn drop(&mut self) {
        for folder in self.made.iter().rev() {
            // Fails, rightly, where something else has come to stand in it.
            let _ = std::fs::remove_dir(folder);
        }
    }
}
