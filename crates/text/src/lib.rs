//! Text of files, and what is said about it: characters that may be shown, numbers for people, problems with their place and remedy.
//!
//! A file becomes text (`source`) and a tree of values (`node`) with paths (`table`). One [`Reading`] collects the problems and remarks
//! of a file and of those that it names. Every package that reads files imports this one. It computes nothing about gears.

pub mod characters;
pub mod encoding;
mod error;
pub mod file_numbers;
mod inches;
mod location;
pub mod node;
pub mod numbers;
mod reading;
pub mod source;
mod sources;
mod table;
pub mod xml;

pub use error::{InputError, Problem};
pub use inches::MM_PER_INCH;
pub use location::{below, lines_of_keys};
pub use node::Node;
pub use reading::{Problems, Reading};
pub use source::{MAX_BYTES, too_large};
pub use sources::{Files, Sources};
use std::path::Path;
pub use table::Table;

/// The path that stands for standard input.
pub const STANDARD_INPUT: &str = "-";

/// The name of the file at `path` in messages: `stdin` for `-`, which is standard input.
pub fn display_path(path: &Path) -> &Path {
    if path == Path::new(STANDARD_INPUT) {
        Path::new("stdin")
    } else {
        path
    }
}

/// Whether the name of the file at `path` has one of these extensions, in lower case or not.
pub fn has_extension(path: &Path, any: &[&str]) -> bool {
    let extension = path.extension().map(|text| text.to_ascii_lowercase());
    extension.is_some_and(|extension| any.iter().any(|one| extension == *one))
}

/// `bytes` without the byte order mark of UTF-8.
pub fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

/// The bytes of the file at `path`; `-` is standard input.
///
/// # Errors
/// [`Problem`] of the whole file: it cannot be read, or is too large.
pub fn bytes(path: &Path) -> Result<Vec<u8>, Problem> {
    if path == Path::new(STANDARD_INPUT) {
        source::standard_input()
    } else {
        source::bytes(path)
    }
}
