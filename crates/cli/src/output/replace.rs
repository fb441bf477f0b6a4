//! The second way: file by file, in a folder that cannot change places as a whole.
//!
//! In the temporary folder stand `new/` (the files to come), `old/` (those that had to make room) and, while the folder is neither
//! old nor new, `.gearlash-plan`: a line `put NAME` or `drop NAME` a file. A failure, or the next run after a kill, undoes the
//! plan. The manifest is the last file of it: as long as its hashes do not fit, the set is not whole.

use super::ending::unfinished;
use super::failed;
use super::temporary::{Lock, PIECE, Temporary, is_temporary, lock, sync_folder};
use crate::error::Error;
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::fs::File;
use std::io::{BufRead, BufReader, ErrorKind};
use std::path::Path;

/// What has still to be undone after a kill.
const PLAN: &str = ".gearlash-plan";
/// Name and form are those that `sha256sum --check` reads.
pub(super) const MANIFEST: &str = "gearlash.sha256";

/// Files of a set that is to come.
pub(super) struct New {
    /// Where they stand.
    pub temporary: Temporary,
    /// In order.
    pub names: Vec<String>,
}

/// Puts the files that are `to_come` into `folder` and removes those called `stale`; after an error everything is as it was.
pub(super) fn replace(folder: &Path, to_come: &New, stale: &[String]) -> Result<(), Error> {
    let temporary = Temporary::new_in(folder).map_err(failed(folder))?;
    let of_folder = |error| failed(folder)(error);
    let new = temporary.add_folder("new").map_err(of_folder)?;
    temporary.add_folder("old").map_err(of_folder)?;
    let put = || to_come.names.iter().map(String::as_str).chain([MANIFEST]);
    for name in put() {
        let target = folder.join(name);
        if target.symlink_metadata().is_ok_and(|found| found.is_dir()) {
            return Err(failed(&target)(ErrorKind::IsADirectory.into()));
        }
    }
    for name in &to_come.names {
        let target = folder.join(name);
        let moved = temporary.take(&to_come.temporary, name, "new");
        moved.map_err(failed(&target))?;
    }
    let target = folder.join(MANIFEST);
    let of_manifest = failed(&target);
    let manifest = manifest(folder, &new, &to_come.names, stale).map_err(&of_manifest)?;
    let written = temporary.write(Path::new("new").join(MANIFEST), manifest.as_bytes());
    written.map_err(&of_manifest)?;
    let mut plan = String::new();
    for name in stale {
        plan += &format!("drop {name}\n");
    }
    for name in put() {
        plan += &format!("put {name}\n");
    }
    let planned = temporary.write("planned", plan.as_bytes());
    planned.map_err(of_folder)?;
    sync_folder(&new).map_err(of_folder)?;

    // From here on the folder is neither old nor new.
    let mut list = unfinished();
    let path = temporary.path();
    let done = std::fs::rename(path.join("planned"), path.join(PLAN))
        .map_err(of_folder)
        .and_then(|()| {
            for (action, name) in lines(&plan) {
                swap(folder, path, action, name).map_err(failed(&folder.join(name)))?;
            }
            sync_folder(folder).map_err(of_folder)?;
            std::fs::remove_file(path.join(PLAN)).map_err(of_folder)
        });
    match done {
        Ok(()) => {
            list.set_written();
            Ok(())
        }
        Err(error) => match undo(path) {
            Ok(()) => Err(error),
            Err(source) => {
                // The next run may be able to: the plan stays.
                list.drop_temporary(path);
                drop(list);
                std::mem::forget(temporary);
                Err(Error::HalfWritten {
                    folder: folder.to_path_buf(),
                    reason: error.to_string(),
                    source,
                })
            }
        },
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Action {
    Put,
    Drop,
}

fn lines(plan: &str) -> impl Iterator<Item = (Action, &str)> {
    plan.lines().filter_map(|line| {
        let (action, name) = line.split_once(' ')?;
        match action {
            "put" => Some((Action::Put, name)),
            "drop" => Some((Action::Drop, name)),
            _ => None,
        }
    })
}

/// One line of the plan: the old file makes room, the new one comes.
fn swap(folder: &Path, temporary: &Path, action: Action, name: &str) -> std::io::Result<()> {
    let [target, new] = [folder.join(name), temporary.join("new").join(name)];
    let old = temporary.join("old").join(name);
    if target.symlink_metadata().is_ok() {
        // A second name, so that the first one is never without a file; or a new one where the file system has no such names.
        let linked = action == Action::Put && std::fs::hard_link(&target, &old).is_ok();
        if !linked {
            std::fs::rename(&target, &old)?;
        }
    }
    match action {
        Action::Put => std::fs::rename(new, target),
        Action::Drop => Ok(()),
    }
}

/// Undoes the plan of the temporary folder at `path`, where there is one; its folder is that in which it stands.
pub(super) fn undo(path: &Path) -> std::io::Result<()> {
    let plan = match std::fs::read_to_string(path.join(PLAN)) {
        Ok(plan) => plan,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
        Err(error) => return Err(error),
    };
    let folder = path.parent().unwrap_or(Path::new("."));
    for (action, name) in lines(&plan) {
        let [target, new] = [folder.join(name), path.join("new").join(name)];
        let old = path.join("old").join(name);
        if old.symlink_metadata().is_ok() {
            std::fs::rename(old, target)?;
        } else if action == Action::Put && new.symlink_metadata().is_err() {
            // It came, and nothing had to make room. Undone twice, it is gone already.
            match std::fs::remove_file(target) {
                Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
                _ => {}
            }
        }
    }
    sync_folder(folder)?;
    std::fs::remove_file(path.join(PLAN))
}

/// Removes from `folder` what killed runs left there, and undoes what they had begun to replace.
pub(super) fn clear_dead(folder: &Path) {
    let Ok(entries) = std::fs::read_dir(folder) else {
        return;
    };
    for entry in entries.flatten() {
        let ours = is_temporary(&entry.file_name());
        if !ours || !entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            continue;
        }
        let path = entry.path();
        if let Lock::Held(_lock) = lock(&path) {
            // A folder that cannot be put right is kept, for a run that can.
            if undo(&path).is_ok() {
                let _ = std::fs::remove_dir_all(&path);
            }
        }
    }
}

/// The hash of each of `names` in the folder `new`, and the lines of other commands' files that the manifest of `folder` has.
fn manifest(
    folder: &Path,
    new: &Path,
    names: &[String],
    stale: &[String],
) -> std::io::Result<String> {
    let before = std::fs::read_to_string(folder.join(MANIFEST)).unwrap_or_default();
    let mut text = String::new();
    for line in before.lines() {
        let Some((_, name)) = line.split_once("  ") else {
            continue;
        };
        let ours = stale.iter().chain(names).any(|other| other == name);
        if !ours && folder.join(name).is_file() {
            text += &format!("{line}\n");
        }
    }
    for name in names {
        let mut hash = Sha256::new();
        let mut content = BufReader::with_capacity(PIECE, File::open(new.join(name))?);
        loop {
            let piece = content.fill_buf()?;
            if piece.is_empty() {
                break;
            }
            hash.update(piece);
            let read = piece.len();
            content.consume(read);
        }
        for byte in hash.finalize() {
            // Into a string: it cannot fail.
            let _ = write!(text, "{byte:02x}");
        }
        text += &format!("  {name}\n");
    }
    Ok(text)
}
