//! The outcome of `check` and `compare` over files, as text, JSON, JUnit XML, GitHub annotations and Markdown.
//!
//! Both commands judge a file by named cases. Failures come first in text and Markdown. Names of cases hold no numbers, so that a
//! CI system recognises them from run to run.

use crate::junit::{self, Suite, TestCase};
use crate::layout::{Screen, Tone};
use crate::verdict::VerdictLines;
use gearlash::analysis::diagnosis::Verdict;
use gearlash_files::characters::{self, plain};
use serde_json::{Value, json};
use std::fmt::Write;
use std::io;

/// A file that was judged.
#[derive(Debug)]
pub struct Judged {
    /// The file as named on the command line.
    pub file: String,
    /// Its title.
    pub title: String,
    /// Whether all is well.
    pub passes: bool,
    /// The verdict on the pair.
    pub verdict: VerdictLines,
    /// Each thing that was judged.
    pub cases: Vec<Case>,
    /// Ambiguities in the file.
    pub warnings: Vec<String>,
    /// Notes on it.
    pub remarks: Vec<String>,
    /// The outcome as text for a terminal, of a file alone.
    pub text: String,
    /// A table for Markdown; empty where there is none.
    pub markdown: String,
    /// The outcome as a JSON object.
    pub json: Value,
}

impl Judged {
    /// The cases but the verdict, whose lines are shown by themselves.
    fn beside_the_verdict(&self) -> impl Iterator<Item = &Case> {
        self.cases.iter().filter(|case| case.name != VERDICT)
    }
}

/// One thing that was judged of a file.
#[derive(Debug, Clone)]
pub struct Case {
    /// Its name, without numbers.
    pub name: String,
    /// The outcome.
    pub verdict: Verdict,
    /// Its numbers in words; several lines where they are the verdict's.
    pub message: String,
}

impl Case {
    fn fails(&self) -> bool {
        self.verdict >= Verdict::Unproven
    }
}

/// A file with an outcome, or what is wrong with it.
#[derive(Debug)]
pub enum JudgedFile {
    /// The file was judged.
    Judged(Box<Judged>),
    /// The file cannot be read, or its pair not be judged.
    Unreadable {
        /// The file as named on the command line.
        file: String,
        /// All its problems.
        problems: Vec<String>,
    },
}

impl JudgedFile {
    fn name(&self) -> &str {
        match self {
            JudgedFile::Judged(judged) => &judged.file,
            JudgedFile::Unreadable { file, .. } => file,
        }
    }

    fn passes(&self) -> bool {
        matches!(self, JudgedFile::Judged(judged) if judged.passes)
    }
}

/// The outcome of a command over files.
#[derive(Debug)]
pub struct Outcome {
    /// `check` or `compare`.
    pub command: &'static str,
    /// The files, in the order of the command line.
    pub files: Vec<JudgedFile>,
}

/// Files named in the last line, at most.
const NAMED: usize = 5;

impl Outcome {
    /// Whether every file passes.
    pub fn passes(&self) -> bool {
        self.files.iter().all(JudgedFile::passes)
    }

    /// Whether some file cannot be read.
    pub fn has_unreadable(&self) -> bool {
        self.files
            .iter()
            .any(|file| matches!(file, JudgedFile::Unreadable { .. }))
    }

    /// The files that do not pass, then the others.
    fn failures_first(&self) -> impl Iterator<Item = &JudgedFile> {
        let failing = self.files.iter().filter(|file| !file.passes());
        failing.chain(self.files.iter().filter(|file| file.passes()))
    }

    /// How many files pass, or how many do not and which.
    pub fn summary(&self) -> String {
        let bad: Vec<&str> = self
            .files
            .iter()
            .filter(|file| !file.passes())
            .map(JudgedFile::name)
            .collect();
        let all = self.files.len();
        let unreadable = self
            .files
            .iter()
            .filter(|file| matches!(file, JudgedFile::Unreadable { .. }))
            .count();
        let verb = |count: usize| if count == 1 { "fails" } else { "fail" };
        let counts = match (bad.len() - unreadable, unreadable) {
            (0, 0) if all == 1 => return "1 file passes".to_owned(),
            (0, 0) => return format!("{all} files pass"),
            (failing, 0) => format!("{failing} {}", verb(failing)),
            (0, unreadable) => format!("{unreadable} cannot be read"),
            (failing, unreadable) => {
                format!("{failing} {}, {unreadable} cannot be read", verb(failing))
            }
        };
        let named: Vec<String> = bad.iter().take(NAMED).map(|file| plain(file)).collect();
        let more = if bad.len() > NAMED { ", …" } else { "" };
        format!("{counts}, of {all}: {}{more}", named.join(", "))
    }

    /// Text on `screen`. A file alone is shown in full; of several those that fail come first, and those that pass take a line each.
    pub fn text(&self, screen: &Screen) -> String {
        if let [JudgedFile::Judged(only)] = &self.files[..] {
            return only.text.clone();
        }
        let names = self
            .files
            .iter()
            .map(|file| plain(file.name()).chars().count());
        let width = names.max().unwrap_or(0);
        let mut text = String::new();
        for file in self.failures_first() {
            let name = plain(file.name());
            match file {
                JudgedFile::Unreadable { problems, .. } => {
                    let _ = writeln!(text, "{}  {name}", screen.toned(Tone::Bad, "error"));
                    for problem in problems {
                        let _ = writeln!(text, "  {}", plain(problem));
                    }
                    text.push('\n');
                }
                JudgedFile::Judged(judged) if judged.passes => {
                    let rows = judged.verdict.rows.iter();
                    let rows: Vec<String> = rows
                        .map(|row| format!("{} {}", row.name, row.value))
                        .collect();
                    let line = format!(
                        "{}     {name:<width$}  {}",
                        screen.toned(Tone::Good, "ok"),
                        rows.join(", ")
                    );
                    let _ = writeln!(text, "{}", line.trim_end());
                }
                JudgedFile::Judged(judged) => {
                    let _ = writeln!(text, "{}   {name}", screen.toned(Tone::Bad, "FAIL"));
                    for line in judged.verdict.lines() {
                        let _ = writeln!(text, "  {line}");
                    }
                    for case in judged.beside_the_verdict().filter(|case| case.fails()) {
                        let message = case.message.replace('\n', "\n    ");
                        let _ =
                            writeln!(text, "  {}: {}: {message}", case.verdict.name(), case.name);
                    }
                    text.push('\n');
                }
            }
        }
        let _ = writeln!(text, "{}", self.summary());
        screen.fold(&text)
    }

    /// One JSON object, of one file as of several, with a line end.
    ///
    /// # Errors
    /// None for an outcome; a number that JSON cannot hold otherwise.
    pub fn json(&self) -> serde_json::Result<String> {
        let files = self.files.iter().map(|file| match file {
            JudgedFile::Judged(judged) => judged.json.clone(),
            JudgedFile::Unreadable { file, problems } => {
                json!({ "file": file, "error": problems.join("\n") })
            }
        });
        characters::json_of(&json!({
            "gearlash": env!("CARGO_PKG_VERSION"),
            "passed": self.passes(),
            "files": files.collect::<Vec<Value>>(),
        }))
    }

    /// GitHub workflow commands: errors and warnings, nothing for what passes.
    pub fn github(&self) -> String {
        let mut text = String::new();
        let mut line = |kind: &str, file: &str, title: &str, words: &str| {
            let _ = writeln!(
                text,
                "::{kind} file={},title={}::{}",
                escape_property(file),
                escape_property(&format!("gearlash {}: {title}", self.command)),
                escape(words)
            );
        };
        for file in &self.files {
            match file {
                JudgedFile::Unreadable { file, problems } => {
                    for problem in problems {
                        line("error", file, "cannot be read", problem);
                    }
                }
                JudgedFile::Judged(judged) => {
                    for case in &judged.cases {
                        let kind = match case.verdict {
                            Verdict::Pass => continue,
                            Verdict::Warn => "warning",
                            Verdict::Unproven | Verdict::Fail => "error",
                        };
                        line(kind, &judged.file, &case.name, &case.message);
                    }
                    for warning in &judged.warnings {
                        line("warning", &judged.file, "input", warning);
                    }
                }
            }
        }
        text
    }

    /// Markdown: a heading, and for each file its verdict, a table, and what does not pass.
    pub fn markdown(&self) -> String {
        let mut text = format!(
            "## gearlash {}: {} {}\n",
            self.command,
            mark(self.passes()),
            escape_markdown(&self.summary())
        );
        for file in self.failures_first() {
            let name = escape_markdown(file.name());
            match file {
                JudgedFile::Unreadable { problems, .. } => {
                    let _ = writeln!(text, "\n### {} {name}\n", mark(false));
                    for problem in problems {
                        let _ = writeln!(text, "- **error** {}", escape_markdown(problem));
                    }
                }
                JudgedFile::Judged(judged) => {
                    let title = escape_markdown(&judged.title);
                    let _ = writeln!(
                        text,
                        "\n### {} {title}\n\n{name}\n\n```text\n{}\n```\n",
                        mark(judged.passes),
                        judged.verdict
                    );
                    text += &judged.markdown;
                    let cases = judged.beside_the_verdict();
                    let told = cases.filter(|case| case.verdict != Verdict::Pass);
                    let told = told.map(|case| {
                        (
                            case.verdict.name(),
                            format!("{}: {}", case.name, case.message),
                        )
                    });
                    let warnings = judged
                        .warnings
                        .iter()
                        .map(|words| ("warning", words.clone()));
                    let remarks = judged.remarks.iter().map(|words| ("note", words.clone()));
                    for (kind, words) in told.chain(warnings).chain(remarks) {
                        let _ = writeln!(text, "- **{kind}** {}", escape_markdown(&words));
                    }
                }
            }
        }
        text
    }

    /// JUnit XML: a suite a file, a case each of what was judged.
    ///
    /// # Errors
    /// None: it is written to memory.
    pub fn junit(&self) -> io::Result<String> {
        let suite = |file: &JudgedFile| match file {
            JudgedFile::Unreadable { file, problems } => Suite {
                file: file.clone(),
                cases: vec![TestCase {
                    name: "read".to_owned(),
                    failure: None,
                    error: Some(problems.join("\n")),
                }],
                output: Vec::new(),
            },
            JudgedFile::Judged(judged) => Suite {
                file: judged.file.clone(),
                cases: judged.cases.iter().map(test_case).collect(),
                output: [("warning", &judged.warnings), ("note", &judged.remarks)]
                    .into_iter()
                    .flat_map(|(kind, words)| {
                        words.iter().map(move |words| format!("{kind}: {words}"))
                    })
                    .collect(),
            },
        };
        let suites: Vec<Suite> = self.files.iter().map(suite).collect();
        junit::junit(&format!("gearlash {}", self.command), &suites)
    }
}

/// The name of the case that is the verdict.
pub const VERDICT: &str = "verdict";

fn test_case(case: &Case) -> TestCase {
    TestCase {
        name: case.name.clone(),
        failure: case.fails().then(|| case.message.clone()),
        error: None,
    }
}

/// Escapes as GitHub's workflow commands ask for.
fn escape(text: &str) -> String {
    let lines: Vec<String> = text
        .lines()
        .map(|line| plain(line).replace('%', "%25"))
        .collect();
    lines.join("%0A")
}

/// Escapes a property of a workflow command.
fn escape_property(text: &str) -> String {
    escape(text).replace(':', "%3A").replace(',', "%2C")
}

/// ✅ or ❌.
pub(crate) fn mark(passes: bool) -> &'static str {
    if passes { "✅" } else { "❌" }
}

/// Text that Markdown takes as nothing but text, on one line.
pub(crate) fn escape_markdown(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in plain(text).trim().chars() {
        match c {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            '\\' | '`' | '*' | '_' | '[' | ']' | '|' | '~' | '#' | '!' | '@' | '$' => {
                escaped.push('\\');
                escaped.push(c);
            }
            c => escaped.push(c),
        }
    }
    // These two alone make a link of text.
    escaped = escaped.replace("://", "\\://").replace("www.", "www\\.");
    // At the beginning of a line these make a list or a heading.
    let digits = escaped.bytes().take_while(u8::is_ascii_digit).count();
    let mark = match escaped.as_bytes().get(digits) {
        Some(b'.' | b')') => digits > 0,
        Some(b'-' | b'+' | b'=') => digits == 0,
        _ => false,
    };
    if mark {
        escaped.insert(digits, '\\');
    }
    escaped
}
