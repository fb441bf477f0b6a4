//! From a path to text, and from text to a tree of values.

use super::location::syntax_errors;
use super::node::{LONGEST, Node};
use super::numbers::ascii;
use super::problems::Problems;
use crate::characters::cut;
use crate::error::Problem;
use std::fs::{File, Metadata};
use std::io::{ErrorKind, Read};
use std::path::Path;
use std::time::{Duration, Instant};

/// Largest file read: 16 MiB. Pitch and thickness of two gears of 10 000 teeth need one.
const MOST_BYTES: u64 = 16 << 20;
/// How long a pipe may wait for a program to write to it: one that is started beside needs a moment.
const WAIT: Duration = Duration::from_secs(5);

/// Most signs that begin a key or a value of a TOML file: its parser takes some 150 bytes for each. A list of one value a tooth
/// for the largest gear has 10 000.
const MOST_MARKS: usize = 500_000;
/// Characters of what a parser says; its own words are shorter.
const LONGEST_MESSAGE: usize = 300;

/// The bytes of the file at `path`.
///
/// # Errors
/// One problem, its key empty: not there, a folder, over 16 MiB, unreadable.
pub fn bytes(path: &Path) -> Result<Vec<u8>, Problem> {
    let metadata = std::fs::metadata(path).map_err(cannot)?;
    if metadata.is_dir() {
        return Err(Problem::of_file("is a folder", "name the file in it"));
    }
    if metadata.len() > MOST_BYTES {
        let mebibytes = metadata.len() as f64 / f64::from(1 << 20);
        return Err(too_large(format!("has {} MiB", ascii(mebibytes, 1))));
    }
    // A pipe has no length beforehand.
    let mut bytes = Vec::new();
    let file = match is_pipe(&metadata) {
        true => written_pipe(path, &mut bytes).map_err(cannot)?,
        false => File::open(path).map_err(cannot)?,
    };
    rest(file, &mut bytes)?;
    Ok(bytes)
}

#[cfg(unix)]
fn is_pipe(metadata: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt;
    metadata.file_type().is_fifo()
}

#[cfg(not(unix))]
fn is_pipe(_: &Metadata) -> bool {
    false
}

/// The pipe at `path`, once a program has it open to write; what has been read of it is added to `bytes`.
///
/// Opened without waiting, a pipe that nobody writes reads as if it had ended, one that has a writer as not ready.
#[cfg(unix)]
fn written_pipe(path: &Path, bytes: &mut Vec<u8>) -> std::io::Result<File> {
    use std::os::unix::fs::OpenOptionsExt;
    let mut options = File::options();
    options
        .read(true)
        .custom_flags(rustix::fs::OFlags::NONBLOCK.bits() as i32);
    let mut file = options.open(path)?;
    let begun = Instant::now();
    let mut first = [0; 4096];
    loop {
        match file.read(&mut first) {
            Ok(0) if begun.elapsed() > WAIT => {
                return Err(std::io::Error::new(
                    ErrorKind::TimedOut,
                    format!(
                        "it is a pipe, and no program has written to it for {} s",
                        WAIT.as_secs()
                    ),
                ));
            }
            Ok(0) => std::thread::sleep(Duration::from_millis(10)),
            Ok(length) => {
                bytes.extend_from_slice(&first[..length]);
                break;
            }
            Err(error) if error.kind() == ErrorKind::WouldBlock => break,
            Err(error) => return Err(error),
        }
    }
    rustix::io::ioctl_fionbio(&file, false)?;
    Ok(file)
}

#[cfg(not(unix))]
fn written_pipe(path: &Path, _: &mut Vec<u8>) -> std::io::Result<File> {
    File::open(path)
}

/// The bytes of standard input, up to its end.
///
/// # Errors
/// One problem, its key empty: over 16 MiB, unreadable.
pub fn standard_input() -> Result<Vec<u8>, Problem> {
    let mut bytes = Vec::new();
    rest(std::io::stdin().lock(), &mut bytes)?;
    Ok(bytes)
}

/// Adds what is left of `file` to `bytes`.
fn rest(file: impl Read, bytes: &mut Vec<u8>) -> Result<(), Problem> {
    let rest = MOST_BYTES + 1 - bytes.len() as u64;
    file.take(rest).read_to_end(bytes).map_err(cannot)?;
    match bytes.len() as u64 > MOST_BYTES {
        true => Err(too_large("has more than 16 MiB".to_owned())),
        false => Ok(()),
    }
}

fn cannot(error: std::io::Error) -> Problem {
    match error.kind() {
        ErrorKind::NotFound => Problem::of_file("there is no such file", "check name and folder"),
        ErrorKind::TimedOut => Problem::of_file(
            format!("cannot be read: {error}"),
            "start the program that writes to it, or name a file",
        ),
        _ => Problem::of_file(
            format!("cannot be read: {error}"),
            "make it a file you may read",
        ),
    }
}

fn too_large(size: String) -> Problem {
    Problem::of_file(
        format!("{size}, allowed is up to 16 MiB"),
        "check that this is the file you mean",
    )
}

/// The text of a file of these `bytes`, without byte order mark.
///
/// # Errors
/// One problem, its key empty: not UTF-8.
pub fn text(bytes: Vec<u8>) -> Result<String, Problem> {
    let text = text_with_mark(bytes)?;
    Ok(match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_owned(),
        None => text,
    })
}

/// The same with the byte order mark, where there is one.
///
/// # Errors
/// As [`text`].
pub fn text_with_mark(bytes: Vec<u8>) -> Result<String, Problem> {
    String::from_utf8(bytes).map_err(|error| {
        let good = error.utf8_error().valid_up_to();
        let line = 1 + error.as_bytes()[..good]
            .iter()
            .filter(|&&b| b == b'\n')
            .count();
        Problem::of_file(
            format!("line {line}: not UTF-8 text"),
            "save the file as UTF-8",
        )
    })
}

/// Whether `text` is read as JSON: by the file's extension, by its first character when that says neither.
pub fn is_json(path: &Path, text: &str) -> bool {
    let extension = path.extension().unwrap_or_default();
    extension.eq_ignore_ascii_case("json")
        || !extension.eq_ignore_ascii_case("toml") && text.trim_start().starts_with('{')
}

/// The keys and values of a pair file: TOML or JSON by its extension, by its first character when that says neither.
///
/// What is wrong is added to `problems`, under an empty key: every syntax error of TOML, the first of JSON, with line and column.
pub fn parse(path: &Path, text: &str, problems: &mut Problems) -> Option<Vec<(String, Node)>> {
    let node = match is_json(path, text) {
        true => problems.keep(of_json(text))?,
        false => problems.of_list_at("", |bad| of_toml(text, bad))?,
    };
    match node {
        Node::Table(entries) => Some(entries),
        other => {
            problems.add(Problem::of_file(
                format!("holds {}, allowed is an object of keys", other.kind()),
                "write { \"wheel\": { … }, … }",
            ));
            None
        }
    }
}

fn of_json(text: &str) -> Result<Node, Problem> {
    serde_json::from_str(text).map_err(|error| {
        Problem::of_file(
            format!("not JSON: {}", cut(&error.to_string(), LONGEST_MESSAGE)),
            "fix it there, or give TOML a name that ends in .toml",
        )
    })
}

fn of_toml(text: &str, problems: &mut Problems) -> Option<Node> {
    let marks = text.bytes().filter(|b| b"=,[{.".contains(b)).count();
    if marks > MOST_MARKS {
        problems.add(Problem::of_file(
            format!("has some {marks} keys and values, allowed are up to {MOST_MARKS} in TOML"),
            "check that this is the file you mean, or put long lists into files of their own",
        ));
        return None;
    }
    match toml::from_str(text) {
        Ok(table) => Some(toml::Value::Table(table).into()),
        Err(error) => {
            let mut errors = syntax_errors(text);
            if errors.is_empty() {
                errors.push(error);
            }
            for error in &errors {
                match problems.is_full() {
                    // Its line would be counted from the start of the text again.
                    true => problems.count_one(),
                    false => problems.add(not_toml(text, error)),
                }
            }
            None
        }
    }
}

fn not_toml(text: &str, error: &toml::de::Error) -> Problem {
    let span = error.span().unwrap_or_default();
    let (line, column) = line_and_column(text, span.start);
    let named = match text.get(span) {
        Some(key) if error.message() == "duplicate key" => format!(" `{}`", cut(key, LONGEST)),
        _ => String::new(),
    };
    Problem::of_file(
        format!(
            "not TOML: {}{named} at line {line} column {column}",
            cut(error.message(), LONGEST_MESSAGE)
        ),
        "fix it there (use a decimal point, quote strings), or give JSON a name that ends in .json",
    )
}

/// Line and column, from 1, of the byte `offset` of `text`.
pub fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before: &[u8] = text.as_bytes().get(..offset).unwrap_or(text.as_bytes());
    let line_start = before
        .iter()
        .rposition(|&b| b == b'\n')
        .map_or(0, |at| at + 1);
    let line = 1 + before.iter().filter(|&&b| b == b'\n').count();
    let column = 1 + String::from_utf8_lossy(&before[line_start..])
        .chars()
        .count();
    (line, column)
}
