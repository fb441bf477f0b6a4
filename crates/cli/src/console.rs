//! Standard output and standard error: the only file that writes to either, and the terminals behind them.
//!
//! A failed write to standard output is an error: a full disk would otherwise leave a result cut short. A reader that has gone
//! away (`| head`) is no error. A failed write to standard error is ignored: nobody is left to read it.

use crate::error::Error;
use gearlash::analysis::verdict::Verdict;
use gearlash_results::text::Screen;
use gearlash_results::verdict::lines;
use gearlash_text::Sources;
use gearlash_text::characters::plain;
use std::fs::File;
use std::io::{BufWriter, ErrorKind, IsTerminal, Write};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

/// Bytes written to standard output at a time (tuned).
const PIECE: usize = 1 << 16;

/// Whether only results, warnings and errors are printed.
static QUIET: AtomicBool = AtomicBool::new(false);

/// Whether notes are printed.
static VERBOSE: AtomicBool = AtomicBool::new(false);

/// Sets for this command whether only results, warnings and errors are printed (`quiet`), and whether notes are (`verbose`).
pub(super) fn set(quiet: bool, verbose: bool) {
    QUIET.store(quiet, Ordering::Relaxed);
    VERBOSE.store(verbose, Ordering::Relaxed);
}

/// Whether only results, warnings and errors are printed.
pub(super) fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// Prints to standard output where files are, which is no result.
pub(super) fn print_note(text: &str) -> Result<(), Error> {
    if is_quiet() { Ok(()) } else { print(text) }
}

/// Prints to standard output, down to the last byte; a closed pipe counts as printed.
pub(super) fn print(text: &str) -> Result<(), Error> {
    let mut output = std::io::stdout().lock();
    let written = output.write_all(text.as_bytes());
    match written.and_then(|()| output.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Error::Printing(error)),
        _ => Ok(()),
    }
}

/// Standard output for a result that grows piece by piece; [`std::io::Write::flush`] ends it.
///
/// When the reader has gone away, the rest is dropped. The work still runs to its end, for the exit code.
pub(super) struct Printer {
    /// Buffers large pieces: Rust's own standard output writes line by line.
    output: BufWriter<std::io::Stdout>,
    /// Whether there is a reader.
    read: bool,
}

impl Printer {
    pub(super) fn new() -> Printer {
        Printer {
            output: BufWriter::with_capacity(PIECE, std::io::stdout()),
            read: true,
        }
    }

    fn ignore_closed_pipe<T>(
        &mut self,
        nothing: T,
        write: impl FnOnce(&mut BufWriter<std::io::Stdout>) -> std::io::Result<T>,
    ) -> std::io::Result<T> {
        if !self.read {
            return Ok(nothing);
        }
        match write(&mut self.output) {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => {
                self.read = false;
                Ok(nothing)
            }
            other => other,
        }
    }
}

impl Write for Printer {
    fn write(&mut self, content: &[u8]) -> std::io::Result<usize> {
        self.ignore_closed_pipe(content.len(), |output| output.write(content))
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.ignore_closed_pipe((), |output| output.flush())
    }
}

/// Writes a note, or what else `--quiet` leaves out, to standard error, as [`print_error_line`] does.
pub(super) fn print_note_line(line: &str) {
    if !is_quiet() {
        print_error_line(line);
    }
}

/// Writes a warning or error to standard error, in lines that fit a terminal. Texts from files in it are made harmless.
pub(super) fn print_error_line(line: &str) {
    let size = ::console::Term::stderr().size_checked();
    let screen = Screen {
        width: size.map(|(_, columns)| columns.into()),
        colour: false,
    };
    print_error_text(&screen.fold(&(plain(line) + "\n")));
}

/// Writes the verdict to standard error.
pub(super) fn print_verdict_lines(verdict: &Verdict) {
    for line in lines(verdict).lines() {
        print_note_line(&line);
    }
}

/// Writes lines to standard error that are already harmless.
pub(super) fn print_error_text(lines: &str) {
    let _ = std::io::stderr().lock().write_all(lines.as_bytes());
}

/// Prints warnings, and with `--verbose` notes.
pub(super) fn warn(file: &Path, warnings: &[String], remarks: &[String]) {
    let file = gearlash_text::display_path(file).display();
    let named = |list: &[String]| {
        let named = list.iter().map(|message| format!("{file}: {message}"));
        named.collect::<Vec<String>>()
    };
    warn_of_files(&named(warnings), &named(remarks));
}

/// [`warn`] with messages that name their files.
pub(super) fn warn_of_files(warnings: &[String], remarks: &[String]) {
    let remarks = if VERBOSE.load(Ordering::Relaxed) {
        remarks
    } else {
        &[]
    };
    for (kind, list) in [("warning", warnings), ("note", remarks)] {
        for message in list {
            print_error_line(&format!("{kind}: {message}"));
        }
    }
}

/// An error where standard output or standard error is one of `sources`, as after `>> pair.toml`.
pub(super) fn check_streams_not_input(sources: &Sources) -> Result<(), Error> {
    for (name, stream) in streams() {
        let name = Path::new(name);
        let input = stream.ok().map(Into::into);
        let input = input.and_then(|file: File| sources.file_read_as(name, &file));
        if let Some(input) = input {
            return Err(Error::over_input(name, input));
        }
    }
    Ok(())
}

#[cfg(unix)]
fn streams() -> [(&'static str, std::io::Result<std::os::fd::OwnedFd>); 2] {
    use std::os::fd::AsFd;
    let output = std::io::stdout().as_fd().try_clone_to_owned();
    let errors = std::io::stderr().as_fd().try_clone_to_owned();
    [("standard output", output), ("standard error", errors)]
}

#[cfg(not(unix))]
fn streams() -> [(&'static str, std::io::Result<std::fs::File>); 0] {
    []
}

/// Whether `stream` shows colours and they are wanted (<https://no-color.org>).
pub(super) fn has_colours(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|no| no.is_empty())
}
