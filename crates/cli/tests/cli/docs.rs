//! README and the pages of `docs/`: every `gearlash` command runs, and prints what stands below it.

use super::gearlash;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

pub(super) fn docs() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    root.canonicalize().unwrap().join("docs")
}

/// README and every page of `docs/`.
fn pages() -> Vec<PathBuf> {
    let mut pages = vec![docs().join("../README.md")];
    let mut folders = vec![docs()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "md") {
                pages.push(path);
            }
        }
    }
    pages
}

/// Language and text of each fenced block.
fn blocks(page: &str) -> Vec<(&str, &str)> {
    let fenced = page.split("```").skip(1).step_by(2);
    fenced.filter_map(|block| block.split_once('\n')).collect()
}

fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A folder with copies of `docs/files` and `fixtures`, which commands read.
fn copy() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for name in ["docs/files", "fixtures"] {
        let to = folder.path().join(name);
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        copied(&docs().join("..").join(name), &to);
    }
    folder
}

fn copied(from: &Path, to: &Path) {
    fs::create_dir(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let from = entry.unwrap().path();
        let to = to.join(from.file_name().unwrap());
        if from.is_dir() {
            copied(&from, &to);
        } else {
            fs::copy(&from, to).unwrap();
        }
    }
}

/// Runs the commands of a page, each ending with `# exit N` where it is not 0; a block of text shows parts of what the last ones print, `…` for the rest.
fn check(page: &Path) -> usize {
    let text = fs::read_to_string(page).unwrap();
    let copy = copy();
    let folder = if page.parent().is_some_and(|folder| folder.ends_with("..")) {
        copy.path().to_owned()
    } else {
        copy.path().join("docs")
    };
    let (mut ran, mut printed) = (0, String::new());
    for (language, block) in blocks(&text) {
        match language {
            "sh" => {
                printed.clear();
                for line in block.lines().filter(|line| !line.starts_with("cargo ")) {
                    let (command, exit) = line.split_once(" # exit ").unwrap_or((line, "0"));
                    let words: Vec<&str> = command.split_whitespace().collect();
                    assert_eq!(words[0], "gearlash", "{page:?}: {line}");
                    let output = gearlash(&folder).args(&words[1..]).output().unwrap();
                    let all = [output.stdout, output.stderr].concat();
                    printed += &words_of(&all);
                    let code = output.status.code().unwrap().to_string();
                    assert_eq!(code, exit, "{page:?}: {line}\n{printed}");
                    ran += 1;
                }
            }
            "text" => {
                let mut rest = printed.as_str();
                for part in block.split('…').map(words).filter(|part| !part.is_empty()) {
                    let found = rest.find(&part);
                    let at = found.unwrap_or_else(|| panic!("{page:?}: {part}\n{rest}"));
                    rest = &rest[at + part.len()..];
                }
            }
            // Python is run by crates/python/tests; what schedulers start was tried by hand.
            "toml" | "yaml" | "python" | "bash" | "rust" | "console" => {}
            other => panic!("{page:?}: a block of {other}"),
        }
    }
    ran
}

fn words_of(output: &[u8]) -> String {
    words(&String::from_utf8_lossy(output)) + " "
}

#[test]
fn every_page_runs_as_written() {
    let ran: usize = pages().par_iter().map(|page| check(page)).sum();
    assert!(ran > 60, "{ran}");
}

/// The files that the links of a page name.
fn links(page: &Path) -> Vec<PathBuf> {
    let text = fs::read_to_string(page).unwrap();
    let targets = text
        .split("](")
        .skip(1)
        .map(|link| link.split(')').next().unwrap());
    let files = targets.filter(|target| !target.starts_with("http"));
    files
        .map(|target| page.with_file_name(target.split('#').next().unwrap()))
        .collect()
}

#[test]
fn every_link_leads_to_a_file() {
    for page in pages() {
        for file in links(&page) {
            assert!(file.exists(), "{page:?}: {file:?}");
        }
    }
}

/// mdBook renders the pages of the summary alone.
#[test]
fn the_summary_has_every_page() {
    let summary = docs().join("SUMMARY.md");
    let linked: BTreeSet<PathBuf> = links(&summary).into_iter().collect();
    let pages = pages().into_iter().skip(1).filter(|page| *page != summary);
    assert_eq!(linked, pages.collect::<BTreeSet<_>>());
}

/// A tag may move to other code, a commit does not.
#[test]
fn actions_of_others_are_named_by_commit() {
    let root = docs().join("..");
    let mut files = vec![root.join("action.yml")];
    let workflows = fs::read_dir(root.join(".github/workflows")).unwrap();
    files.extend(workflows.map(|entry| entry.unwrap().path()));
    let mut count = 0;
    for file in files {
        let text = fs::read_to_string(&file).unwrap();
        for line in text.lines() {
            let Some((_, action)) = line.split_once("uses: ") else {
                continue;
            };
            let commit = action.split_once('@').unwrap().1;
            let commit = commit.split_whitespace().next().unwrap();
            let is_hash = commit.len() == 40 && commit.bytes().all(|c| c.is_ascii_hexdigit());
            assert!(is_hash, "{}: {line}", file.display());
            count += 1;
        }
    }
    assert!(count >= 6);
}
