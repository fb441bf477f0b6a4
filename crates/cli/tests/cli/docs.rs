//! README and the pages of `docs/`: every `gearlash` command runs, and prints what stands below it.

use super::gearlash;
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")
}

/// Language and text of each fenced block.
fn blocks(page: &str) -> Vec<(&str, &str)> {
    let fenced = page.split("```").skip(1).step_by(2);
    fenced.filter_map(|block| block.split_once('\n')).collect()
}

fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A folder with a copy of the files that the commands of `page` read.
fn copy(page: &Path) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let read = folder.path().join(if page.starts_with(docs()) {
        "files"
    } else {
        "docs/files"
    });
    fs::create_dir_all(read.parent().unwrap()).unwrap();
    copied(&docs().join("files"), &read);
    folder
}

fn copied(from: &Path, to: &Path) {
    fs::create_dir(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let from = entry.unwrap().path();
        let to = to.join(from.file_name().unwrap());
        match from.is_dir() {
            true => copied(&from, &to),
            false => drop(fs::copy(&from, to).unwrap()),
        }
    }
}

/// Runs the commands of a page, each ending with `# exit N` where it is not 0; a block of text shows parts of what the last ones print, `…` for the rest.
fn check(page: &Path) -> usize {
    let text = fs::read_to_string(page).unwrap();
    let folder = copy(page);
    let (mut ran, mut printed) = (0, String::new());
    for (language, block) in blocks(&text) {
        match language {
            "sh" => {
                printed.clear();
                for line in block.lines().filter(|line| !line.starts_with("cargo ")) {
                    let (command, exit) = line.split_once(" # exit ").unwrap_or((line, "0"));
                    let words: Vec<&str> = command.split_whitespace().collect();
                    assert_eq!(words[0], "gearlash", "{page:?}: {line}");
                    let output = gearlash(folder.path()).args(&words[1..]).output().unwrap();
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
            "toml" | "yaml" | "python" | "bash" | "rust" => {}
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
    let pages = fs::read_dir(docs()).unwrap();
    let pages = pages.map(|entry| entry.unwrap().path());
    let mut pages: Vec<PathBuf> = pages
        .filter(|path| path.extension().is_some_and(|ending| ending == "md"))
        .collect();
    assert!(pages.len() > 6);
    pages.push(docs().join("../README.md").canonicalize().unwrap());
    let ran: usize = pages.par_iter().map(|page| check(page)).sum();
    assert!(ran > 15, "{ran}");
}

/// The index links every page, and only those.
#[test]
fn the_index_has_every_page() {
    let index = fs::read_to_string(docs().join("README.md")).unwrap();
    for entry in fs::read_dir(docs()).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if name.ends_with(".md") && name != "README.md" {
            assert!(index.contains(&format!("({name})")), "{name}");
        }
    }
    for link in index.split("](").skip(1) {
        let target = link.split(')').next().unwrap();
        assert!(docs().join(target).exists(), "{target}");
    }
}
