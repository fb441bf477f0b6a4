//! The outcome of `check` and `compare` over files, as text, JSON, JUnit XML, GitHub annotations and Markdown.
//!
//! Both commands judge a file by named cases. Failures come first in text and Markdown. Names of cases contain no numbers, so
//! that a CI system recognises them in every run.

use crate::column::json_text;
use crate::layout::{Screen, Tone};
use crate::verdict::{VerdictLines, in_short};
use gearlash::analysis::diagnosis::CheckVerdict;
use gearlash_text::characters::plain;
use gearlash_text::lines_of_keys;
use quick_xml::events::{BytesDecl, BytesText, Event};
use quick_xml::{ElementWriter, Writer};
use serde_json::{Value, json};
use std::fmt::Write;
use std::io;
use std::iter;

/// The outcome for a file that was judged.
#[derive(Debug)]
pub struct Judgement {
    /// The file as named on the command line.
    pub file: String,
    /// Its title.
    pub title: String,
    /// Whether every case passes.
    pub passes: bool,
    /// The verdict on the pair.
    pub verdict: VerdictLines,
    /// Whether a value misses a limit of `[require]`, or is not proven to keep it.
    pub misses_limit: bool,
    /// The judged cases.
    pub cases: Vec<Case>,
    /// Ambiguities in the file.
    pub warnings: Vec<String>,
    /// Notes on it.
    pub remarks: Vec<String>,
    /// The command that shows how to mend the pair, where one is known.
    pub hint: Option<String>,
    /// The outcome as text for a terminal, if it is the only file.
    pub text: String,
    /// A table for Markdown; may be empty.
    pub markdown: String,
    /// The outcome as a JSON object.
    pub json: Value,
}

impl Judgement {
    /// Warnings and notes on the file, each with its kind.
    fn notes(&self) -> Vec<(&'static str, &String)> {
        let warnings = self.warnings.iter().map(|words| ("warning", words));
        let remarks = self.remarks.iter().map(|words| ("note", words));
        warnings.chain(remarks).collect()
    }

    /// The cases without the verdict, whose lines are shown separately.
    fn cases_without_verdict(&self) -> impl Iterator<Item = &Case> {
        self.cases.iter().filter(|case| case.name != VERDICT)
    }
}

/// One judged property of a file.
#[derive(Debug, Clone)]
pub struct Case {
    /// Its name, without numbers.
    pub name: String,
    /// The outcome.
    pub verdict: CheckVerdict,
    /// Its numbers in words; several lines for the verdict.
    pub message: String,
}

impl Case {
    pub(crate) fn new(name: &str, verdict: CheckVerdict, message: String) -> Case {
        Case {
            name: name.to_owned(),
            verdict,
            message,
        }
    }

    fn fails(&self) -> bool {
        self.verdict >= CheckVerdict::Unproven
    }
}

/// A file with an outcome, or its problems.
#[derive(Debug)]
pub enum JudgedFile {
    /// The file was judged.
    Judged(Box<Judgement>),
    /// The file cannot be read, or its pair cannot be judged.
    Unreadable {
        /// The file as named on the command line.
        file: String,
        /// All its problems.
        problems: Vec<FileProblem>,
    },
}

/// A problem of a file.
#[derive(Debug)]
pub struct FileProblem {
    /// In words, on one line.
    pub message: String,
    /// Its line in the file, from 1, where one is known.
    pub line: Option<usize>,
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

/// Most files named in the last line.
const MAX_NAMED: usize = 5;

impl Outcome {
    /// Whether every file passes.
    pub fn passes(&self) -> bool {
        self.files.iter().all(JudgedFile::passes)
    }

    /// The number of files that cannot be read.
    pub fn unreadable(&self) -> usize {
        let is_unreadable = |file: &&JudgedFile| matches!(file, JudgedFile::Unreadable { .. });
        self.files.iter().filter(is_unreadable).count()
    }

    /// The files that do not pass, then the others.
    fn failures_first(&self) -> impl Iterator<Item = &JudgedFile> {
        let failing = self.files.iter().filter(|file| !file.passes());
        failing.chain(self.files.iter().filter(|file| file.passes()))
    }

    /// The number of files that pass; or of those that do not, with their names.
    pub fn summary(&self) -> String {
        let failing = self.files.iter().filter(|file| !file.passes());
        let bad: Vec<&str> = failing.map(JudgedFile::name).collect();
        let (all, unreadable) = (self.files.len(), self.unreadable());
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
        let named: Vec<String> = bad.iter().take(MAX_NAMED).map(|file| plain(file)).collect();
        let more = if bad.len() > MAX_NAMED { ", …" } else { "" };
        format!("{counts}, of {all}: {}{more}", named.join(", "))
    }

    /// Text on `screen`. A single file is shown in full. Among several files, failing ones come first, and passing ones take a line
    /// each.
    pub fn text(&self, screen: &Screen) -> String {
        if let [JudgedFile::Judged(only)] = &self.files[..] {
            return only.text.clone();
        }
        let files = self.files.iter();
        let names = files.map(|file| plain(file.name()).chars().count());
        let width = names.max().unwrap_or(0);
        let mut text = String::new();
        for file in self.failures_first() {
            let name = plain(file.name());
            match file {
                JudgedFile::Unreadable { problems, .. } => {
                    let _ = writeln!(text, "{}  {name}", screen.toned(Tone::Bad, "error"));
                    for problem in problems {
                        let _ = writeln!(text, "  {}", plain(&problem.message));
                    }
                    text.push('\n');
                }
                JudgedFile::Judged(judged) if judged.passes => {
                    let ok = screen.toned(Tone::Good, "ok");
                    let extremes = in_short(&judged.verdict.extremes);
                    let line = format!("{ok}     {name:<width$}  {extremes}");
                    let _ = writeln!(text, "{}", line.trim_end());
                }
                JudgedFile::Judged(judged) => {
                    let _ = writeln!(text, "{}   {name}", screen.toned(Tone::Bad, "FAIL"));
                    for line in judged.verdict.lines() {
                        let _ = writeln!(text, "  {line}");
                    }
                    for case in judged.cases_without_verdict().filter(|case| case.fails()) {
                        let (verdict, name) = (case.verdict.name(), &case.name);
                        let message = case.message.replace('\n', "\n    ");
                        let _ = writeln!(text, "  {verdict}: {name}: {message}");
                    }
                    if let Some(hint) = &judged.hint {
                        let _ = writeln!(text, "  {}", plain(hint));
                    }
                    text.push('\n');
                }
            }
        }
        let _ = writeln!(text, "{}", self.summary());
        screen.fold(&text)
    }

    /// One JSON object for one or several files, with a line end.
    pub fn json(&self) -> String {
        let files = self.files.iter().map(|file| match file {
            JudgedFile::Judged(judged) => judged.json.clone(),
            JudgedFile::Unreadable { file, problems, .. } => {
                json!({ "file": file, "passed": false, "error": joined(problems) })
            }
        });
        json_text(&json!({
            "gearlash": env!("CARGO_PKG_VERSION"),
            "passed": self.passes(),
            "files": files.collect::<Vec<Value>>(),
        }))
    }

    /// GitHub workflow commands: errors and warnings, at their line in the `text_of` a file; nothing for passing cases.
    pub fn github(&self, text_of: impl Fn(&str) -> String) -> String {
        // GitHub shows some ten errors of a step: what decides a file comes first.
        let mut lines: [String; 2] = Default::default();
        let mut line = |decides: bool, kind: &str, place: &str, title: &str, words: &str| {
            let _ = writeln!(
                lines[usize::from(!decides)],
                "::{kind} file={place},title={}::{}",
                escape_property(&format!("gearlash {}: {title}", self.command)),
                escape(words)
            );
        };
        for file in &self.files {
            match file {
                JudgedFile::Unreadable { file, problems } => {
                    for problem in problems {
                        let place = place(file, problem.line);
                        line(true, "error", &place, "cannot be read", &problem.message);
                    }
                }
                JudgedFile::Judged(judged) => {
                    let warnings = judged.warnings.iter();
                    let keys = warnings.filter_map(|words| words.split(": ").next());
                    let keys = iter::once("require").chain(keys);
                    let lines = lines_of_keys(&text_of(&judged.file), keys);
                    let (of_limits, of_warnings) = (lines[0], &lines[1..]);
                    for case in &judged.cases {
                        let kind = match case.verdict {
                            CheckVerdict::Pass => continue,
                            CheckVerdict::Warn => "warning",
                            CheckVerdict::Unproven | CheckVerdict::Fail => "error",
                        };
                        let decides = case.name == VERDICT;
                        let at = of_limits.filter(|_| decides && judged.misses_limit);
                        let place = place(&judged.file, at);
                        line(decides, kind, &place, &case.name, &case.message);
                    }
                    for (warning, at) in judged.warnings.iter().zip(of_warnings) {
                        let place = place(&judged.file, *at);
                        line(false, "warning", &place, "input", warning);
                    }
                }
            }
        }
        lines.concat()
    }

    /// Markdown: a heading, and for each file its verdict, a table, and the cases that do not pass.
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
                        let _ = writeln!(text, "- **error** {}", escape_markdown(&problem.message));
                    }
                }
                JudgedFile::Judged(judged) => {
                    let title = escape_markdown(&judged.title);
                    // The message of a verdict that fails has the changes that help, too.
                    let mut cases = judged.cases.iter();
                    let failed = cases.find(|case| case.name == VERDICT && case.fails());
                    let lines =
                        failed.map_or(judged.verdict.to_string(), |case| case.message.clone());
                    let _ = writeln!(
                        text,
                        "\n### {} {title}\n\n{name}\n\n```text\n{lines}\n```\n",
                        mark(judged.passes),
                    );
                    text += &judged.markdown;
                    let mut note = |kind: &str, words: &str| {
                        let _ = writeln!(text, "- **{kind}** {}", escape_markdown(words));
                    };
                    let cases = judged.cases_without_verdict();
                    for case in cases.filter(|case| case.verdict != CheckVerdict::Pass) {
                        let words = format!("{}: {}", case.name, case.message);
                        note(case.verdict.name(), &words);
                    }
                    for (kind, words) in judged.notes() {
                        note(kind, words);
                    }
                }
            }
        }
        text
    }

    /// JUnit XML: one suite per file, one case per judged property.
    pub fn junit(&self) -> io::Result<String> {
        let mut xml = Writer::new_with_indent(Vec::new(), b' ', 4);
        xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
        let cases: Vec<TestCase> = self.files.iter().flat_map(JudgedFile::test_cases).collect();
        let name = format!("gearlash {}", self.command);
        suite_element(&mut xml, "testsuites", &name, &cases).write_inner_content(|xml| {
            let mut files = self.files.iter();
            files.try_for_each(|file| file.write_suite(xml))
        })?;
        Ok(String::from_utf8_lossy(&xml.into_inner()).into_owned() + "\n")
    }
}

/// `file` and the line in it as properties of a workflow command.
fn place(file: &str, line: Option<usize>) -> String {
    let line = line.map_or(String::new(), |line| format!(",line={line}"));
    escape_property(file) + &line
}

/// The messages of `problems`, one per line.
fn joined(problems: &[FileProblem]) -> String {
    let messages = problems.iter().map(|problem| &problem.message[..]);
    messages.collect::<Vec<_>>().join("\n")
}

type Xml = Writer<Vec<u8>>;

/// The name of a judged property, and why it fails (`failure`) or cannot be judged (`error`).
type TestCase<'a> = (&'a str, Option<(&'static str, String)>);

impl JudgedFile {
    fn test_cases(&self) -> Vec<TestCase<'_>> {
        match self {
            JudgedFile::Unreadable { problems, .. } => {
                vec![("read", Some(("error", joined(problems))))]
            }
            JudgedFile::Judged(judged) => {
                let cases = judged.cases.iter().map(|case| {
                    let failure = || ("failure", case.message.clone());
                    (&case.name[..], case.fails().then(failure))
                });
                cases.collect()
            }
        }
    }

    /// Writes the suite of a file, with its verdict, and warnings and notes on it, as its output.
    fn write_suite(&self, xml: &mut Xml) -> io::Result<()> {
        let file = plain(self.name());
        let cases = self.test_cases();
        let output = match self {
            JudgedFile::Unreadable { .. } => Vec::new(),
            JudgedFile::Judged(judged) => {
                let notes = judged.notes().into_iter();
                let notes = notes.map(|(kind, words)| format!("{kind}: {words}"));
                let lines = judged.verdict.lines().into_iter().chain(notes);
                lines.map(|line| plain(&line)).collect()
            }
        };
        suite_element(xml, "testsuite", &file, &cases).write_inner_content(|xml| {
            for (name, reason) in cases {
                let tag = xml.create_element("testcase");
                let tag = tag.with_attributes([("name", &plain(name)[..]), ("classname", &file)]);
                let Some((kind, reason)) = reason else {
                    tag.write_empty()?;
                    continue;
                };
                let lines: Vec<String> = reason.lines().map(plain).collect();
                tag.write_inner_content(|xml| {
                    let first = lines.first().map_or("", String::as_str);
                    let tag = xml.create_element(kind).with_attribute(("message", first));
                    tag.write_text_content(BytesText::new(&lines.join("\n")))?;
                    Ok(())
                })?;
            }
            if !output.is_empty() {
                let tag = xml.create_element("system-out");
                tag.write_text_content(BytesText::new(&output.join("\n")))?;
            }
            Ok(())
        })?;
        Ok(())
    }
}

/// A suite with its name and the numbers of `cases`, of failures and of errors. No case is skipped.
fn suite_element<'x>(
    xml: &'x mut Xml,
    tag: &'static str,
    name: &str,
    cases: &[TestCase],
) -> ElementWriter<'x, Vec<u8>> {
    let count = |kind: &str| {
        let reasons = cases.iter().filter_map(|(_, reason)| reason.as_ref());
        reasons.filter(|(of, _)| *of == kind).count()
    };
    let tag = xml.create_element(tag).with_attribute(("name", name));
    let counts = [
        ("tests", cases.len()),
        ("skipped", 0),
        ("failures", count("failure")),
        ("errors", count("error")),
    ];
    counts.into_iter().fold(tag, |tag, (name, count)| {
        tag.with_attribute((name, &count.to_string()[..]))
    })
}

/// The name of the verdict's case.
pub const VERDICT: &str = "verdict";

/// Escapes text as GitHub's workflow commands require.
fn escape(text: &str) -> String {
    let lines = text.lines().map(|line| plain(line).replace('%', "%25"));
    lines.collect::<Vec<_>>().join("%0A")
}

/// Escapes a property of a workflow command.
fn escape_property(text: &str) -> String {
    escape(text).replace(':', "%3A").replace(',', "%2C")
}

/// ✅ or ❌.
pub(crate) fn mark(passes: bool) -> &'static str {
    if passes { "✅" } else { "❌" }
}

/// Text escaped for Markdown, on one line.
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
    // Only these two turn text into a link.
    escaped = escaped.replace("://", "\\://").replace("www.", "www\\.");
    // At the beginning of a line these start a list or a heading.
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
