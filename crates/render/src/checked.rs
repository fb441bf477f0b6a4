//! The outcome of `check` over several files: JUnit XML, GitHub annotations, Markdown. The verdict comes first in each.

use crate::comparison::{escape, escape_property};
use crate::text::check::{governing, measured, unit};
use gearlash::analysis::diagnosis::{Check, Diagnosis, Verdict};
use gearlash_files::characters::plain;
use gearlash_files::numbers::fixed;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, Event};
use std::fmt::Write;
use std::io;

/// A pair that was checked.
#[derive(Debug)]
pub struct CheckedPair {
    /// The file as named on the command line.
    pub file: String,
    /// Its title.
    pub title: String,
    /// The verdict in a sentence.
    pub sentence: String,
    /// Every check.
    pub diagnosis: Diagnosis,
    /// Whether all is well: exit code 0.
    pub passes: bool,
}

/// Of each check the one that governs, with what it says.
fn told(pair: &CheckedPair) -> Vec<(&Check, String)> {
    let each = governing(&pair.diagnosis).into_iter();
    each.map(|(_, check)| {
        let value = |value: Option<f64>| fixed(value, 4);
        let text = format!(
            "{}: formula {}, outlines {}, limit {} {}",
            check.title,
            value(check.analytic),
            measured(check, value),
            value(check.limit),
            unit(check.unit)
        );
        let text = text.trim_end().to_owned();
        let note = match check.note.is_empty() {
            true => String::new(),
            false => format!("; {}", check.note),
        };
        (check, text + &note)
    })
    .collect()
}

/// GitHub workflow commands: an error for a pair that does not pass and for each check that fails, a notice for one that does.
pub fn github(pairs: &[CheckedPair]) -> String {
    let mut text = String::new();
    for pair in pairs {
        let mut line = |kind: &str, title: &str, words: &str| {
            let _ = writeln!(
                text,
                "::{kind} file={},title={}::{}",
                escape_property(&pair.file),
                escape_property(title),
                escape(words)
            );
        };
        let kind = if pair.passes { "notice" } else { "error" };
        line(kind, "gearlash check", &pair.sentence);
        for (check, words) in told(pair) {
            match check.verdict {
                Verdict::Pass => (),
                Verdict::Warn => line("warning", "gearlash check", &words),
                Verdict::Unproven | Verdict::Fail => line("error", "gearlash check", &words),
            }
        }
    }
    text
}

/// Markdown: a heading, and for each pair its verdict and the checks that do not pass.
pub fn markdown(pairs: &[CheckedPair]) -> String {
    let failing = pairs.iter().filter(|pair| !pair.passes).count();
    let heading = match failing {
        0 => format!("✅ {} of {} pairs pass", pairs.len(), pairs.len()),
        some => format!("❌ {some} of {} pairs fail", pairs.len()),
    };
    let mut text = format!("## gearlash check: {heading}\n");
    for pair in pairs {
        let mark = if pair.passes { "✅" } else { "❌" };
        let title = crate::comparison::markdown_text(&pair.title);
        let sentence = crate::comparison::markdown_text(&pair.sentence);
        let file = crate::comparison::markdown_text(&pair.file);
        let _ = write!(text, "\n### {mark} {title}\n\n{sentence}\n\n{file}\n\n");
        for (check, words) in told(pair) {
            if check.verdict != Verdict::Pass {
                let words = crate::comparison::markdown_text(&words);
                let _ = writeln!(text, "- **{}** {words}", check.verdict.name());
            }
        }
    }
    text
}

/// JUnit XML: a suite a file, the verdict its first case, then a case a check.
///
/// # Errors
/// None: it is written to memory.
pub fn junit(pairs: &[CheckedPair]) -> io::Result<String> {
    let mut xml = Writer::new_with_indent(Vec::new(), b' ', 4);
    xml.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
    let mut all = BytesStart::new("testsuites");
    all.push_attribute(("name", "gearlash check"));
    xml.write_event(Event::Start(all))?;
    for pair in pairs {
        let cases = told(pair);
        let fails = |check: &Check| check.verdict >= Verdict::Unproven;
        let failing = cases.iter().filter(|(check, _)| fails(check)).count();
        let mut suite = BytesStart::new("testsuite");
        suite.push_attribute(("name", plain(&pair.file).as_str()));
        suite.push_attribute(("tests", (1 + cases.len()).to_string().as_str()));
        suite.push_attribute(("skipped", "0"));
        suite.push_attribute(("errors", "0"));
        let failures = failing + usize::from(!pair.passes);
        suite.push_attribute(("failures", failures.to_string().as_str()));
        xml.write_event(Event::Start(suite))?;
        let title = plain(&pair.title);
        case(
            &mut xml,
            &title,
            &pair.sentence,
            (!pair.passes).then_some(&pair.sentence),
        )?;
        for (check, words) in &cases {
            let name = match check.gear {
                Some(gear) => format!("{} ({})", check.title, gear.name()),
                None => check.title.to_owned(),
            };
            case(&mut xml, &title, &name, fails(check).then_some(words))?;
        }
        xml.write_event(Event::End(BytesEnd::new("testsuite")))?;
    }
    xml.write_event(Event::End(BytesEnd::new("testsuites")))?;
    Ok(String::from_utf8_lossy(&xml.into_inner()).into_owned() + "\n")
}

fn case(
    xml: &mut Writer<Vec<u8>>,
    class: &str,
    name: &str,
    failure: Option<&String>,
) -> io::Result<()> {
    let mut tag = BytesStart::new("testcase");
    tag.push_attribute(("name", plain(name).as_str()));
    tag.push_attribute(("classname", class));
    let Some(reason) = failure else {
        return xml.write_event(Event::Empty(tag));
    };
    xml.write_event(Event::Start(tag))?;
    let mut failure = BytesStart::new("failure");
    failure.push_attribute(("message", plain(reason).as_str()));
    xml.write_event(Event::Empty(failure))?;
    xml.write_event(Event::End(BytesEnd::new("testcase")))
}
