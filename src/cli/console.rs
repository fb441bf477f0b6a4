//! Standard output and standard error: the only file that writes to either.
//!
//! What does not reach standard output is an error, as a disk that is full would otherwise leave a result cut short; only a
//! reader that has gone away (`| head`) is none. What does not reach standard error is lost: nobody is left to tell.

use crate::characters::plain;
use crate::error::Error;
use crate::sources::Sources;
use std::io::{ErrorKind, Write};
use std::path::Path;

/// Prints to standard output, down to the last byte.
///
/// # Errors
/// [`Error::Printing`] with the system's reason.
pub(super) fn print(text: &str) -> Result<(), Error> {
    let mut output = std::io::stdout().lock();
    printed(
        output
            .write_all(text.as_bytes())
            .and_then(|()| output.flush()),
    )
}

/// Whether something was printed: a closed pipe is as good.
pub(super) fn printed(result: std::io::Result<()>) -> Result<(), Error> {
    match result {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Error::Printing(error)),
        _ => Ok(()),
    }
}

/// Writes a line to standard error, whatever the texts from files in it.
pub(super) fn tell(line: &str) {
    let text = plain(line);
    let mut output = std::io::stderr().lock();
    let _ = output
        .write_all(text.as_bytes())
        .and_then(|()| output.write_all(b"\n"));
}

/// Tells what the user should know, and what was found to be in order.
pub(super) fn warn(file: &Path, warnings: &[String], remarks: &[String]) {
    for (kind, list) in [("warning", warnings), ("note", remarks)] {
        for told in list {
            tell(&format!("{kind}: {}: {told}", file.display()));
        }
    }
}

/// An error where standard output or standard error is one of `sources`, as after `>> pair.toml`.
pub(super) fn guard(sources: &Sources) -> Result<(), Error> {
    for (name, file) in streams() {
        let name = Path::new(name);
        if let Some(input) = file.and_then(|file| sources.named_open(name, &file)) {
            return Err(Error::OverInput {
                output: name.to_path_buf(),
                input: input.to_path_buf(),
            });
        }
    }
    Ok(())
}

#[cfg(unix)]
fn streams() -> [(&'static str, Option<std::fs::File>); 2] {
    use std::os::fd::AsFd;
    let open = |stream: std::io::Result<std::os::fd::OwnedFd>| stream.ok().map(Into::into);
    [
        (
            "standard output",
            open(std::io::stdout().as_fd().try_clone_to_owned()),
        ),
        (
            "standard error",
            open(std::io::stderr().as_fd().try_clone_to_owned()),
        ),
    ]
}

#[cfg(not(unix))]
fn streams() -> [(&'static str, Option<std::fs::File>); 0] {
    []
}
