//! The first way: a new folder changes places with the old one.
//!
//! The new folder gets a second name (a hard link) of every file in the old one that is not the command's own; then
//! one call of the system (`renameat2` with `RENAME_EXCHANGE`, Linux) swaps the two. It is not taken for a folder
//! that holds other folders, links or a file that was read, that is or holds the working folder (a shell would be left standing in the
//! old one), that is a mount point, or whose owner or attributes a new folder would not have.

use super::failed;
use super::temporary::Temporary;
use crate::error::Error;
use gearlash_files::Sources;
use std::collections::HashMap;
use std::ffi::{OsStr, OsString};
use std::path::Path;

/// Files of others that are given a second name; a folder with more is somebody's archive.
const MOST_FOREIGN: usize = 10_000;

/// A new folder beside the old one.
pub(super) struct Exchange {
    temporary: Temporary,
    /// Every file of the old folder: `None` for the command's own, the inode of any other.
    #[cfg(target_os = "linux")]
    listed: HashMap<OsString, Option<u64>>,
}

#[cfg(not(target_os = "linux"))]
impl Exchange {
    /// No such call is known here.
    pub fn begin(_: &Path, _: &dyn Fn(&OsStr) -> bool, _: &Sources, _: &Path) -> Option<Exchange> {
        None
    }

    /// Where the files go.
    pub fn temporary(&self) -> &Temporary {
        &self.temporary
    }

    /// Never called.
    pub fn finish(self, _: &Path) -> Result<(), Error> {
        Ok(())
    }
}

#[cfg(target_os = "linux")]
impl Exchange {
    /// A new folder for `folder` with everything in it that is not `own`; `None` where this way is not open. The files to come stand
    /// `beside` the others, in a folder that is gone before both change places.
    pub fn begin(
        folder: &Path,
        own: &dyn Fn(&OsStr) -> bool,
        sources: &Sources,
        beside: &Path,
    ) -> Option<Exchange> {
        use super::ending::unfinished;
        use std::os::unix::fs::{DirEntryExt, MetadataExt};

        let parent = folder.parent()?;
        let is = std::fs::metadata(folder).ok()?;
        let working = std::env::current_dir().ok()?;
        let mounted = std::fs::metadata(parent).ok()?.dev() != is.dev();
        if working.starts_with(folder) || mounted || !plain(folder) {
            return None;
        }
        let temporary = Temporary::new_in(parent).ok()?;
        std::fs::set_permissions(temporary.path(), is.permissions()).ok()?;
        let would_be = std::fs::metadata(temporary.path()).ok()?;
        if (would_be.uid(), would_be.gid()) != (is.uid(), is.gid())
            || would_be.dev() != is.dev()
            || !exchangeable(parent, &temporary)
        {
            return None;
        }
        let mut listed = HashMap::new();
        let mut foreign = 0;
        for entry in std::fs::read_dir(folder).ok()? {
            let entry = entry.ok()?;
            let name = entry.file_name();
            if Some(name.as_os_str()) == beside.file_name() {
                continue;
            }
            if !entry.file_type().ok()?.is_file() || sources.named(&entry.path()).is_some() {
                return None;
            }
            if !own(&name) {
                foreign += 1;
                let _list = unfinished();
                std::fs::hard_link(entry.path(), temporary.path().join(&name)).ok()?;
            }
            let inode = (!own(&name)).then(|| entry.ino());
            listed.insert(name, inode);
            if foreign > MOST_FOREIGN {
                return None;
            }
        }
        Some(Exchange { temporary, listed })
    }

    /// Where the files go.
    pub fn temporary(&self) -> &Temporary {
        &self.temporary
    }

    /// Swaps both folders and removes the old one.
    pub fn finish(self, folder: &Path) -> Result<(), Error> {
        use super::ending::unfinished;
        use super::temporary::sync_folder;

        let path = self.temporary.path();
        sync_folder(path).map_err(failed(folder))?;
        let mut list = unfinished();
        swap(path, folder).map_err(failed(folder))?;
        list.set_written();
        if let Some(parent) = folder.parent() {
            // The set is whole; a disk that fails now takes nothing from it.
            let _ = sync_folder(parent);
        }
        // What stands at `path` now is the old folder. Files that others put there since it was listed come along.
        if self.take_along(folder).is_none() {
            // It still holds some: kept, and none of ours any more.
            list.drop_temporary(path);
            let kept = path.with_file_name(format!(
                "{}-kept",
                folder.file_name().unwrap_or_default().to_string_lossy()
            ));
            let _ = std::fs::rename(path, kept);
        }
        Ok(())
    }

    /// Moves what is new or has been changed in the old folder to the new one.
    fn take_along(&self, folder: &Path) -> Option<()> {
        use std::os::unix::fs::DirEntryExt;
        for entry in std::fs::read_dir(self.temporary.path()).ok()? {
            let entry = entry.ok()?;
            let name = entry.file_name();
            let target = folder.join(&name);
            let changed = match self.listed.get(&name) {
                Some(before) => before.is_some_and(|inode| inode != entry.ino()),
                None => !target.exists(),
            };
            if changed {
                std::fs::rename(entry.path(), target).ok()?;
            }
        }
        Some(())
    }
}

#[cfg(target_os = "linux")]
fn swap(one: &Path, other: &Path) -> std::io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    Ok(renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE)?)
}

/// Whether this file system can: tried on two folders of our own.
#[cfg(target_os = "linux")]
fn exchangeable(parent: &Path, temporary: &Temporary) -> bool {
    Temporary::new_in(parent).is_ok_and(|other| {
        let _list = super::ending::unfinished();
        let (one, other) = (temporary.path(), other.path());
        // Twice: each has its own lock again.
        swap(one, other).is_ok() && swap(one, other).is_ok()
    })
}

/// Whether the folder has no access lists or attributes of its user, which a new one would not have.
#[cfg(target_os = "linux")]
fn plain(folder: &Path) -> bool {
    let mut names = [0u8; 4096];
    let Ok(length) = rustix::fs::listxattr(folder, &mut names) else {
        // A file system without attributes.
        return true;
    };
    let mut names = names[..length].split(|byte| *byte == 0);
    names.all(|name| name.is_empty() || name.starts_with(b"security."))
}
