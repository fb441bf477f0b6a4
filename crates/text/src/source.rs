//! From a path to text, and from text to a tree of values.

use super::location::syntax_errors;
use super::node::{LONGEST, Node};
use super::numbers::ascii;
use super::reading::Reading;
use crate::characters::cut;
use crate::error::Problem;
use std::fs::File;
use std::io::{ErrorKind, IsTerminal, Read};
use std::path::Path;
use std::sync::mpsc::sync_channel;
use std::time::Duration;

/// Largest input of any kind, bytes.
pub const MAX_BYTES: u64 = 64 << 20;
/// Largest text of a pair file, gear file or gearbox model: pitch and thickness of two gears of 10 000 teeth need 1 MiB.
const MAX_TEXT: usize = 16 << 20;
/// Longest wait for data of a pipe.
const WAIT: Duration = Duration::from_secs(5);
/// Bytes read at a time (tuned).
const PIECE: usize = 1 << 16;

/// Most marks that begin a key or a value of a TOML file: its parser takes some 150 bytes for each. A list with one value per
/// tooth of the largest gear has 10 000.
const MAX_MARKS: usize = 500_000;
/// Most characters quoted from a parser's message; its own words are shorter.
const LONGEST_MESSAGE: usize = 300;

/// The bytes of the file at `path`.
/// Errors: one problem with an empty key: not there, a folder, over 64 MiB, unreadable, a pipe without data for 5 s.
pub fn bytes(path: &Path) -> Result<Vec<u8>, Problem> {
    let metadata = std::fs::metadata(path).map_err(unreadable)?;
    if metadata.is_dir() {
        return Err(Problem::of_file("is a folder", "name the file in it"));
    }
    if metadata.is_file() {
        if metadata.len() > MAX_BYTES {
            return Err(too_large(metadata.len(), MAX_BYTES));
        }
        return whole(File::open(path).map_err(unreadable)?);
    }
    let path = path.to_owned();
    // Opening a pipe waits for a program that writes to it.
    by_pieces(move || File::open(path))
}

/// The bytes of standard input, up to its end.
/// Errors: as [`bytes`]; a terminal can wait for ever.
pub fn standard_input() -> Result<Vec<u8>, Problem> {
    if std::io::stdin().is_terminal() {
        return whole(std::io::stdin().lock());
    }
    by_pieces(|| Ok(std::io::stdin()))
}

fn whole(input: impl Read) -> Result<Vec<u8>, Problem> {
    let mut bytes = Vec::new();
    let read = input.take(MAX_BYTES + 1).read_to_end(&mut bytes);
    read.map_err(unreadable)?;
    limited(bytes)
}

/// The bytes of an input that can wait for ever. Another thread reads it; this one waits for each piece.
fn by_pieces<R: Read>(
    open: impl FnOnce() -> std::io::Result<R> + Send + 'static,
) -> Result<Vec<u8>, Problem> {
    let (sender, pieces) = sync_channel(1);
    let read = move || {
        let mut input = match open() {
            Ok(input) => input,
            Err(error) => return drop(sender.send(Err(error))),
        };
        loop {
            let mut piece = vec![0; PIECE];
            let read = input.read(&mut piece);
            let is_last = !matches!(read, Ok(length) if length > 0);
            let sent = sender.send(read.map(|length| {
                piece.truncate(length);
                piece
            }));
            if is_last || sent.is_err() {
                return;
            }
        }
    };
    std::thread::Builder::new()
        .spawn(read)
        .map_err(unreadable)?;
    let mut bytes = Vec::new();
    loop {
        let piece = pieces.recv_timeout(WAIT).unwrap_or_else(|_| {
            let reason = format!("no data has come for {} s", WAIT.as_secs());
            Err(std::io::Error::new(ErrorKind::TimedOut, reason))
        });
        let piece = piece.map_err(unreadable)?;
        bytes.extend_from_slice(&piece);
        if piece.is_empty() || bytes.len() as u64 > MAX_BYTES {
            return limited(bytes);
        }
    }
}

/// `bytes`, if they are within the limit.
fn limited(bytes: Vec<u8>) -> Result<Vec<u8>, Problem> {
    if bytes.len() as u64 > MAX_BYTES {
        return Err(Problem::of_file(
            "has more than 64 MiB",
            "check that this is the file you mean",
        ));
    }
    Ok(bytes)
}

fn unreadable(error: std::io::Error) -> Problem {
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

/// The fault of a file of `size` bytes where `most` are allowed.
pub fn too_large(size: u64, most: u64) -> Problem {
    let mebibyte = f64::from(1 << 20);
    Problem::of_file(
        format!(
            "has {} MiB, allowed is up to {} MiB",
            ascii(size as f64 / mebibyte, 1),
            most >> 20
        ),
        "check that this is the file you mean",
    )
}

/// The text of a file of these `bytes`, without byte order mark.
/// Errors: one problem with an empty key: not UTF-8, or over 16 MiB.
pub fn text(bytes: Vec<u8>) -> Result<String, Problem> {
    if bytes.len() > MAX_TEXT {
        return Err(too_large(bytes.len() as u64, MAX_TEXT as u64));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let good = error.utf8_error().valid_up_to();
        let line = 1 + error.as_bytes()[..good]
            .iter()
            .filter(|&&b| b == b'\n')
            .count();
        Problem::of_file(
            format!("line {line}: not UTF-8 text"),
            "save the file as UTF-8",
        )
    })?;
    Ok(text
        .strip_prefix('\u{feff}')
        .map(str::to_owned)
        .unwrap_or(text))
}

/// Whether `text` is read as JSON: by the file's extension, or by its first character where the extension is neither.
pub fn is_json(path: &Path, text: &str) -> bool {
    let extension = path.extension().unwrap_or_default();
    extension.eq_ignore_ascii_case("json")
        || !extension.eq_ignore_ascii_case("toml") && text.trim_start().starts_with('{')
}

/// The keys and values of a pair file: TOML or JSON as [`is_json`] decides.
///
/// Problems have an empty key: every syntax error of TOML, the first of JSON, with line and column.
pub fn parse(path: &Path, text: &str, reading: &Reading) -> Option<Vec<(String, Node)>> {
    let node = if is_json(path, text) {
        reading.keep(of_json(text))?
    } else {
        reading.list("", || of_toml(text, reading))?
    };
    match node {
        Node::Table(entries) => Some(entries),
        other => reading.refuse(Problem::of_file(
            format!("holds {}, allowed is an object of keys", other.kind()),
            "write { \"wheel\": { … }, … }",
        )),
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

fn of_toml(text: &str, reading: &Reading) -> Option<Node> {
    let marks = text.bytes().filter(|b| b"=,[{.".contains(b)).count();
    if marks > MAX_MARKS {
        return reading.refuse(Problem::of_file(
            format!("has some {marks} keys and values, allowed are up to {MAX_MARKS} in TOML"),
            "check that this is the file you mean, or put long lists into files of their own",
        ));
    }
    match toml::from_str(text) {
        Ok(table) => Some(toml::Value::Table(table).into()),
        Err(error) => {
            let mut errors = syntax_errors(text);
            if errors.is_empty() {
                errors.push(error);
            }
            for error in &errors {
                // The line is not computed for a problem that is only counted.
                if !reading.count_if_full() {
                    reading.add(not_toml(text, error));
                }
            }
            None
        }
    }
}

fn not_toml(text: &str, error: &toml::de::Error) -> Problem {
    let span = error.span().unwrap_or_default();
    let start = span.start;
    let (line, column) = line_and_column(text, span.start);
    let named = match text.get(span) {
        Some(key) if error.message() == "duplicate key" => format!(" `{}`", cut(key, LONGEST)),
        _ => String::new(),
    };
    let place = format!("{named} at line {line} column {column}");
    let rest = text.get(start..).unwrap_or_default();
    if is_bare_word(error.message(), rest) {
        let first = rest.trim_start_matches([' ', '\t']).chars().next();
        if first.is_none_or(|first| "\r\n#".contains(first)) {
            let reason = format!("not TOML: a value is missing{place}");
            return Problem::of_file(reason, "write it after the =, or remove the key");
        }
        return Problem::of_file(
            format!("not TOML: a word without quotes{place}"),
            "write a number in digits, text in quotes",
        );
    }
    Problem::of_file(
        format!("not TOML: {}{place}", cut(error.message(), LONGEST_MESSAGE)),
        "fix it there (use a decimal point, quote strings), or give JSON a name that ends in .json",
    )
}

/// Whether the parser's `message` is about a word in place of a value, with which `rest` begins. A word like `true` or `inf` is taken
/// for a mistyped one of these.
fn is_bare_word(message: &str, rest: &str) -> bool {
    let is_begun = ["invalid boolean", "invalid float"]
        .iter()
        .any(|of| message.starts_with(of));
    let is_word = rest
        .trim_start_matches(['+', '-'])
        .starts_with(|c: char| c.is_alphabetic());
    message.starts_with("string values must be quoted") || is_begun && is_word
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
