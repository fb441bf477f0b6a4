//! The common part of `check` and `compare`: several files, some of which cannot be read; output formats; the step summary of a
//! workflow.

use crate::console::{print, print_error_text};
use crate::error::{Error, exit_code};
use crate::explain::explain;
use crate::input::{check_stdin_once, reported};
use crate::options::ScreenArgs;
use crate::output::check_not_input;
use clap::ValueEnum;
use gearlash_input::PairFile;
use gearlash_results::judged::{FileProblem, JudgedFile, Judgement, Outcome};
use gearlash_text::{InputError, Sources};
use std::io::Write;
use std::iter;
use std::path::{Path, PathBuf};

/// The output formats for pair files.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum JudgedFormat {
    /// One file in full; of several a line for each that passes
    Text,
    /// One object with a list of files, of one file as of several
    Json,
    /// JUnit XML: one suite per file, one case per check
    Junit,
    /// GitHub annotations; the Markdown goes to the step summary ($GITHUB_STEP_SUMMARY)
    Github,
    /// Markdown for reviewers
    Markdown,
}

/// A file and its content, or the error of reading it.
pub(super) type ReadFile = (PathBuf, Result<PairFile, Error>);

/// Reads each of `paths`; a file that cannot be read does not stop the others.
pub(super) fn read(
    paths: &[PathBuf],
    read: impl Fn(&Path) -> Result<PairFile, InputError>,
) -> Result<Vec<ReadFile>, Error> {
    check_stdin_once(paths)?;
    let files = paths.iter();
    let files = files.map(|path| (path.clone(), reported(path, read(path))));
    Ok(files.collect())
}

/// The outcome of `command` for `files`, each judged by `judge`, and the step summary for it.
pub(super) fn outcome(
    command: &'static str,
    files: Vec<ReadFile>,
    format: JudgedFormat,
    mut judge: impl FnMut(&Path, &PairFile) -> Result<Judgement, Error>,
) -> Result<(Outcome, Option<PathBuf>), Error> {
    let mut sources = Sources::default();
    for file in files.iter().filter_map(|(_, file)| file.as_ref().ok()) {
        sources.extend(&file.sources);
    }
    let summary = step_summary(format, &sources)?;
    let is_text = format == JudgedFormat::Text;
    let is_alone = files.len() == 1;
    let mut judged_files = Vec::new();
    for (path, file) in files {
        let judged = file.and_then(|file| judge(&path, &file));
        judged_files.push(if is_text && is_alone {
            JudgedFile::Judged(Box::new(judged?))
        } else {
            judged_file(&path, judged, is_text)?
        });
    }
    let files = judged_files;
    Ok((Outcome { command, files }, summary))
}

/// The outcome of a file: judged, or the problems that prevent it. Standard error lists these, too, unless `is_shown`.
fn judged_file(
    path: &Path,
    judged: Result<Judgement, Error>,
    is_shown: bool,
) -> Result<JudgedFile, Error> {
    use gearlash::error::Error as Run;
    let error = match judged {
        Ok(judged) => return Ok(JudgedFile::Judged(Box::new(judged))),
        Err(error) => error,
    };
    match error {
        Error::Input(_) | Error::Several(_) | Error::Usage(_) => {}
        Error::Run(ref reason) if !matches!(reason, Run::Interrupted) => {}
        ends_all => return Err(ends_all),
    }
    if !is_shown {
        print_error_text(&explain(&error));
    }
    let lines = match &error {
        Error::Input(error) => error.lines_of_problems(),
        _ => Vec::new(),
    };
    let lines = lines.into_iter().chain(iter::repeat(None));
    let problems = error.lines().into_iter().zip(lines);
    let problems = problems.map(|(message, line)| FileProblem { message, line });
    Ok(JudgedFile::Unreadable {
        file: path.display().to_string(),
        problems: problems.collect(),
    })
}

/// The step summary of a GitHub workflow, if `format` writes one; never one of `sources`.
fn step_summary(format: JudgedFormat, sources: &Sources) -> Result<Option<PathBuf>, Error> {
    let named = std::env::var_os("GITHUB_STEP_SUMMARY").filter(|name| !name.is_empty());
    let summary = named.map(PathBuf::from);
    let summary = summary.filter(|_| format == JudgedFormat::Github);
    if let Some(summary) = &summary {
        check_not_input(sources, summary)?;
    }
    Ok(summary)
}

/// Adds `text` to the step `summary`; text of earlier steps stays.
fn append(summary: &Path, text: &str) -> Result<(), Error> {
    let mut options = std::fs::OpenOptions::new();
    let file = options.append(true).create(true).open(summary);
    let written = file.and_then(|mut file| file.write_all(text.as_bytes()));
    written.map_err(|source| {
        Error::Usage(format!(
            "GITHUB_STEP_SUMMARY={}: cannot be written: {source}; unset the variable, or use --format markdown",
            summary.display()
        ))
    })
}

/// Prints `outcome` in `format`; the exit code.
pub(super) fn print_outcome(
    outcome: &Outcome,
    format: JudgedFormat,
    screen: &ScreenArgs,
    summary: Option<&Path>,
) -> Result<u8, Error> {
    print(&match format {
        JudgedFormat::Text => outcome.text(&screen.screen()),
        JudgedFormat::Json => outcome.json(),
        JudgedFormat::Junit => outcome.junit().map_err(Error::unwritable("the outcome"))?,
        JudgedFormat::Github => {
            // A pipe has been read already.
            outcome.github(|file| {
                if Path::new(file).is_file() {
                    std::fs::read_to_string(file).unwrap_or_default()
                } else {
                    String::new()
                }
            })
        }
        JudgedFormat::Markdown => outcome.markdown(),
    })?;
    if let Some(summary) = summary {
        append(summary, &outcome.markdown())?;
    }
    Ok(match outcome.unreadable() {
        0 => exit_code(outcome.passes()),
        _ => 2,
    })
}
