//! Sessions: the built program over the files of `tests/sessions/`. Each holds inputs, commands, and the stored outcome of each command.
//!
//! | line | meaning |
//! |---|---|
//! | `# TEXT` | the statement, and the source of its numbers |
//! | `+ FILE` | writes FILE; its lines follow, each after four spaces |
//! | `@ SOURCE [FILE]` | copies a file of the repository, or the files of a folder |
//! | `~ FILE: FROM => TO` | replaces the first FROM by TO for the next command alone; an empty FROM is the end of the file |
//! | `^ LINK TARGET` | makes a symbolic link |
//! | `& LINK TARGET` | makes a hard link |
//! | `$ ARGUMENTS` | runs gearlash; `NAME=VALUE` before the command sets a variable; `cat FILE` prints a file |
//! | `$ ARGUMENTS ? KEY…` | stores of printed JSON the values below these keys; of a picture or page the texts, of a table the lines that hold one of them, `_` for a blank |
//! | `$! ARGUMENTS` | stores no standard output |
//! | `% SCRIPT` | runs SCRIPT by `sh`, for which `gearlash` is the program |
//!
//! An outcome is the exit code (`=`), standard output (`|`), standard error (`!`), and each file that is new, changed or gone (`*`).
//! `GEARLASH_SESSIONS=write` stores the outcomes of today; `GEARLASH_SESSIONS_CASES=word` selects files by name.

// On other platforms last digits differ.
#![cfg(all(target_os = "linux", target_arch = "x86_64"))]

use rayon::prelude::*;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};
use tempfile::TempDir;

const PROGRAM: &str = env!("CARGO_BIN_EXE_gearlash");
/// Lines that are stored of standard output; the others are counted.
const MAX_LINES: usize = 40;
/// More new, changed or gone files are counted.
const MAX_FILES: usize = 6;
/// A longer line or text that holds a key is data.
const MAX_PIECE: usize = 400;

fn root() -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).to_owned()
}

/// Every file below `folder`, by its path from there.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(&next).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() && !path.ends_with(".git") {
                folders.push(path);
            } else {
                let name = path.strip_prefix(folder).unwrap().as_os_str();
                let name = name.as_encoded_bytes().escape_ascii().to_string();
                // A link may lead nowhere, and a pipe has no end.
                let is_file = path.is_file();
                let content = is_file.then(|| fs::read(&path).unwrap());
                found.insert(name, content.unwrap_or_default());
            }
        }
    }
    found
}

/// One line for each value of `value` whose path begins with a key of `keys`.
fn values(value: &Value, path: &str, keys: &[&str], out: &mut String) {
    match value {
        Value::Object(map) if !map.is_empty() => {
            for (key, value) in map {
                values(value, &format!("{path}.{key}"), keys, out);
            }
        }
        Value::Array(list) if !list.is_empty() => {
            for (index, value) in list.iter().enumerate() {
                values(value, &format!("{path}[{index}]"), keys, out);
            }
        }
        scalar => {
            let path = path.trim_start_matches('.');
            if keys.iter().any(|key| path.starts_with(key)) {
                writeln!(out, "{path} = {scalar}").unwrap();
            }
        }
    }
}

/// The part of `text` that is stored: all of it where no key is named.
fn selected(text: &str, keys: &[&str]) -> String {
    if keys.is_empty() {
        return text.to_owned();
    }
    if let Ok(json) = serde_json::from_str::<Value>(text) {
        let mut lines = String::new();
        // A list of one file is shown as that file.
        let only = json["files"].as_array().filter(|files| files.len() == 1);
        values(only.map_or(&json, |files| &files[0]), "", keys, &mut lines);
        return lines;
    }
    let pieces: Vec<String> = if text.starts_with('<') {
        let texts = text.split('<').filter_map(|tag| tag.split_once('>'));
        let words = |(_, text): (&str, &str)| text.split_whitespace().collect::<Vec<_>>().join(" ");
        texts.map(words).collect()
    } else {
        text.lines().map(str::to_owned).collect()
    };
    let mut found: Vec<&String> = Vec::new();
    for piece in &pieces {
        let mut held = keys.iter();
        let holds = held.any(|key| piece.contains(key) || piece.contains(&key.replace('_', " ")));
        if holds && piece.len() <= MAX_PIECE && !found.contains(&piece) {
            found.push(piece);
        }
    }
    found.iter().map(|piece| format!("{piece}\n")).collect()
}

struct Session {
    folder: TempDir,
    /// The files as they were before the edits of the next command.
    before_edits: BTreeMap<String, String>,
}

impl Session {
    fn at(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        let path = self.at(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }

    fn copy(&self, words: &str) {
        let (source, name) = words.split_once(' ').unwrap_or((words, ""));
        let path = root().join(source);
        if path.is_dir() {
            for (inner, content) in contents(&path) {
                self.write(&Path::new(name).join(inner).display().to_string(), content);
            }
        } else {
            let own = path.file_name().unwrap().to_str().unwrap();
            let name = if name.is_empty() { own } else { name };
            self.write(name, fs::read(&path).expect(source));
        }
    }

    fn edit(&mut self, words: &str) {
        let (name, change) = words.split_once(": ").expect(words);
        let (from, to) = change.split_once("=>").expect(words);
        let escapes = [("\\n", "\n"), ("\\r", "\r"), ("\\t", "\t"), ("\\0", "\0")];
        let unescaped = |text: &str| {
            let replaced = |text: String, (from, to): (&str, &str)| text.replace(from, to);
            escapes.into_iter().fold(text.to_owned(), replaced)
        };
        let from = unescaped(from.strip_suffix(' ').unwrap_or(from));
        let to = unescaped(to.strip_prefix(' ').unwrap_or(to));
        let old = fs::read_to_string(self.at(name)).expect(words);
        let new = if from.is_empty() {
            format!("{old}{to}\n")
        } else {
            assert!(old.contains(&from), "{words}: FROM is not in the file");
            old.replacen(&from, &to, 1)
        };
        self.write(name, new);
        self.before_edits.entry(name.to_owned()).or_insert(old);
    }

    /// Runs a command of gearlash and returns its outcome.
    fn run(&mut self, words: &str, with_output: bool) -> String {
        let (words, keys) = words.split_once(" ? ").unwrap_or((words, ""));
        let keys: Vec<&str> = keys.split_whitespace().collect();
        if let Some(name) = words.strip_prefix("cat ") {
            let text = fs::read_to_string(self.at(name)).expect(words);
            return prefixed("|", &selected(&text, &keys));
        }
        let mut command = Command::new(PROGRAM);
        command
            .env("RAYON_NUM_THREADS", "1")
            .env("SOURCE_DATE_EPOCH", "0");
        let mut words = words.split_whitespace().peekable();
        while let Some((name, value)) = words.peek().and_then(|word| word.split_once('=')) {
            command.env(name, value);
            words.next();
        }
        self.outcome(command.args(words), &keys, with_output)
    }

    /// Runs a script of the shell and returns its outcome.
    fn run_script(&mut self, script: &str) -> String {
        let mut folders = vec![Path::new(PROGRAM).parent().unwrap().to_owned()];
        folders.extend(env::split_paths(&env::var_os("PATH").unwrap()));
        let mut command = Command::new("sh");
        command
            .args(["-c", script])
            .env("SOURCE_DATE_EPOCH", "0")
            .env("PATH", env::join_paths(folders).unwrap());
        self.outcome(&mut command, &[], true)
    }

    fn outcome(&mut self, command: &mut Command, keys: &[&str], with_output: bool) -> String {
        let before = contents(self.folder.path());
        let found = command.current_dir(self.folder.path()).output().unwrap();
        let after = contents(self.folder.path());
        let text = |bytes: &[u8]| {
            let folder = self.folder.path().to_str().unwrap();
            String::from_utf8_lossy(bytes).replace(folder, "FOLDER")
        };
        let mut out = format!("= {}\n", found.status.code().unwrap());
        let printed = text(&found.stdout);
        if with_output {
            out += &prefixed("|", &selected(&printed, keys));
        }
        let messages = text(&found.stderr);
        let messages: Vec<&str> = messages.lines().filter(|line| !is_excerpt(line)).collect();
        out += &prefixed("!", &messages.join("\n"));
        let is_new = |name: &&String| !before.contains_key(*name);
        let is_changed = |name: &&String| before.get(*name).is_some_and(|old| *old != after[*name]);
        let is_gone = |name: &&String| !after.contains_key(*name);
        out += &listed("new", after.keys().filter(is_new).collect());
        out += &listed("changed", after.keys().filter(is_changed).collect());
        out += &listed("gone", before.keys().filter(is_gone).collect());
        for (name, old) in std::mem::take(&mut self.before_edits) {
            self.write(&name, old);
        }
        out
    }
}

/// Whether a line of standard error shows the input: the corpus holds how.
fn is_excerpt(line: &str) -> bool {
    let rest = line.trim_start_matches(|c: char| c == ' ' || c.is_ascii_digit());
    rest.starts_with('|') || rest.starts_with("--> ")
}

/// Files that are new, changed or gone: many as the first and their number.
fn listed(what: &str, names: Vec<&String>) -> String {
    match names[..] {
        [first, .., _] if names.len() > MAX_FILES => {
            format!("* {what} {first} and {} more\n", names.len() - 1)
        }
        _ => names
            .iter()
            .map(|name| format!("* {what} {name}\n"))
            .collect(),
    }
}

fn prefixed(sign: &str, text: &str) -> String {
    let mut out = String::new();
    for line in text.lines().take(MAX_LINES) {
        out += format!("{sign} {line}").trim_end();
        out.push('\n');
    }
    let more = text.lines().count().saturating_sub(MAX_LINES);
    if more > 0 {
        writeln!(out, "{sign} … {more} lines more").unwrap();
    }
    out
}

/// The session with the outcomes of today.
fn played(text: &str) -> String {
    let mut session = Session {
        folder: TempDir::new().unwrap(),
        before_edits: BTreeMap::new(),
    };
    let mut out = String::new();
    let mut file: Option<(&str, String)> = None;
    for line in text.lines().chain([""]) {
        if let (Some((_, content)), Some(inner)) = (&mut file, line.strip_prefix("    ")) {
            writeln!(content, "{inner}").unwrap();
            writeln!(out, "{line}").unwrap();
            continue;
        }
        if let Some((name, content)) = file.take() {
            session.write(name, content);
        }
        let (sign, words) = line.split_once(' ').unwrap_or((line, ""));
        if matches!(sign, "=" | "|" | "!" | "*") {
            continue;
        }
        writeln!(out, "{line}").unwrap();
        match sign {
            "" | "#" => {}
            "+" => file = Some((words, String::new())),
            "@" => session.copy(words),
            "~" => session.edit(words),
            "^" => {
                let (link, target) = words.split_once(' ').expect(line);
                symlink(target, session.at(link)).unwrap();
            }
            "&" => {
                let (link, target) = words.split_once(' ').expect(line);
                fs::hard_link(session.at(target), session.at(link)).unwrap();
            }
            "$" => out += &session.run(words, true),
            "$!" => out += &session.run(words, false),
            "%" => out += &session.run_script(words),
            _ => panic!("{line:?}: no line of a session begins so"),
        }
    }
    out.trim_end().to_owned() + "\n"
}

#[test]
fn every_session_ends_as_stored() {
    let only = env::var("GEARLASH_SESSIONS_CASES").unwrap_or_default();
    let is_write = env::var("GEARLASH_SESSIONS").is_ok_and(|word| word == "write");
    let entries = fs::read_dir(root().join("tests/sessions")).unwrap();
    let files = entries.map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> = files
        .filter(|path| path.to_str().unwrap().contains(&only))
        .collect();
    files.sort();
    let check = |path: &PathBuf| {
        let stored = fs::read_to_string(path).unwrap();
        let actual = played(&stored);
        if is_write {
            fs::write(path, &actual).unwrap();
            return String::new();
        }
        let lines = stored.lines().zip(actual.lines()).enumerate();
        let (number, (old, new)) = lines
            .into_iter()
            .find(|(_, (old, new))| old != new)
            .unwrap_or((stored.lines().count(), ("", "")));
        if stored == actual {
            return String::new();
        }
        format!("{}:{}\n  - {old}\n  + {new}\n", path.display(), number + 1)
    };
    let differences: String = files.par_iter().map(check).collect();
    let store = "GEARLASH_SESSIONS=write stores the outcomes; review the difference as code";
    assert!(differences.is_empty(), "{differences}{store}");
}

/// Words of a sentence of a message; what stands before it (file, key and value) is not counted.
const MOST_WORDS: usize = 25;

/// All stored errors, warnings and notes, sorted by file: `-- --nocapture` prints them for a review.
#[test]
fn messages_are_short_sentences() {
    let mut all = BTreeMap::new();
    for folder in ["tests/sessions", "tests/corpus/expected/bad"] {
        for (name, content) in contents(&root().join(folder)) {
            for line in String::from_utf8_lossy(&content).lines() {
                let stored = line
                    .strip_prefix("! ")
                    .or_else(|| line.split_once(" = ").map(|it| it.1));
                let kinds = ["error: ", "warning: ", "note: "];
                let Some(message) =
                    stored.filter(|it| kinds.iter().any(|kind| it.starts_with(kind)))
                else {
                    continue;
                };
                all.entry(message.to_owned()).or_insert(name.clone());
            }
        }
    }
    assert!(all.len() > 1000, "{}", all.len());
    let mut by_file: Vec<(String, String)> = all
        .into_iter()
        .map(|(message, file)| (file, message))
        .collect();
    by_file.sort();
    let mut long = String::new();
    for (file, message) in &by_file {
        println!("{file}: {message}");
        // "error: FILE: KEY = VALUE: WORDS"
        let words = message.splitn(4, ": ").last().unwrap();
        let sentences = words.split([';', ':', '?']).flat_map(|it| it.split(". "));
        for sentence in sentences.filter(|it| it.trim().split(' ').count() > MOST_WORDS) {
            let _ = writeln!(long, "{file}: {sentence}");
        }
    }
    assert!(long.is_empty(), "{long}");
}
