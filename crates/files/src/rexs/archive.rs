//! The zip archive that a `.rexsz` file is: one REXS file, and files that it refers to.

use super::document::shown;
use crate::error::Problem;
use std::io::{Cursor, Read};
use zip::ZipArchive;

/// Largest unpacked size: 16 MiB, as for a file that is not zipped.
const MAX_BYTES: u64 = 16 << 20;
const PLACE: &str = "the archive";

/// The one REXS file in the archive.
/// Errors: no archive, none or several such files in it, too large, damaged.
pub fn unpacked(bytes: &[u8]) -> Result<Vec<u8>, Problem> {
    let damaged = |error: &dyn std::error::Error| {
        let reason = format!("not a whole zip archive: {}", shown(&error.to_string()));
        Problem::at(
            PLACE,
            reason,
            "pack it again, or unpack it and name the .rexs file",
        )
    };
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| damaged(&error))?;
    let mut found = Vec::new();
    for index in 0..archive.len() {
        let part = archive.by_index(index).map_err(|error| damaged(&error))?;
        let name = part
            .name()
            .map_err(|error| damaged(&error))?
            .to_ascii_lowercase();
        // Copies of names by macOS's Finder are not files.
        let is_rexs = [".rexs", ".rexsj"]
            .iter()
            .any(|ending| name.ends_with(ending));
        if is_rexs && !name.starts_with("__macosx/") {
            found.push(index);
        }
    }
    let [index] = found[..] else {
        let reason = format!("holds {} files .rexs or .rexsj, expected one", found.len());
        return Err(Problem::at(PLACE, reason, "unpack it and name the file"));
    };
    let part = archive.by_index(index).map_err(|error| damaged(&error))?;
    let mut content = Vec::new();
    part.take(MAX_BYTES + 1)
        .read_to_end(&mut content)
        .map_err(|error| damaged(&error))?;
    if content.len() as u64 > MAX_BYTES {
        Err(Problem::at(
            PLACE,
            "its file has more than 16 MiB",
            "check that this is the file you mean",
        ))
    } else {
        Ok(content)
    }
}
