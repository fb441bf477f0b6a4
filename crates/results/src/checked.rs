//! The outcome of `check` over several files: JUnit XML, GitHub annotations, Markdown. The verdict comes first in each.

use crate::comparison::{escape, escape_property};
use crate::junit::{self, Case, Suite};
use crate::text::check::{governing, measured, unit};
use gearlash::analysis::diagnosis::{Check, Diagnosis, Verdict};
use gearlash_files::numbers::fixed;
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
    /// What of its files may be meant otherwise.
    pub warnings: Vec<String>,
    /// What else was noticed of them.
    pub remarks: Vec<String>,
    /// Every check.
    pub diagnosis: Diagnosis,
    /// Whether all is well: exit code 0.
    pub passes: bool,
}

/// Of each check the one that governs, with what it says.
fn described(pair: &CheckedPair) -> Vec<(&Check, String)> {
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

/// GitHub workflow commands: an error for a pair that does not pass and for each check that fails, a notice for one that does; warnings and
/// remarks of its files as such.
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
        for warning in &pair.warnings {
            line("warning", "gearlash check", warning);
        }
        for remark in &pair.remarks {
            line("notice", "gearlash check", remark);
        }
        for (check, words) in described(pair) {
            match check.verdict {
                Verdict::Pass => (),
                Verdict::Warn => line("warning", "gearlash check", &words),
                Verdict::Unproven | Verdict::Fail => line("error", "gearlash check", &words),
            }
        }
    }
    text
}

/// Markdown: a heading, and for each pair its verdict, the checks that do not pass, and what was noticed of its files.
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
        for (check, words) in described(pair) {
            if check.verdict != Verdict::Pass {
                let words = crate::comparison::markdown_text(&words);
                let _ = writeln!(text, "- **{}** {words}", check.verdict.name());
            }
        }
        for (kind, described) in [("warning", &pair.warnings), ("note", &pair.remarks)] {
            for words in described {
                let words = crate::comparison::markdown_text(words);
                let _ = writeln!(text, "- **{kind}** {words}");
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
    let suite = |pair: &CheckedPair| {
        let first = Case {
            name: pair.sentence.clone(),
            failure: (!pair.passes).then(|| pair.sentence.clone()),
        };
        let checks = described(pair).into_iter().map(|(check, words)| Case {
            name: match check.gear {
                Some(gear) => format!("{} ({})", check.title, gear.name()),
                None => check.title.to_owned(),
            },
            failure: (check.verdict >= Verdict::Unproven).then_some(words),
        });
        Suite {
            file: pair.file.clone(),
            title: pair.title.clone(),
            cases: std::iter::once(first).chain(checks).collect(),
            said: [("warning", &pair.warnings), ("note", &pair.remarks)]
                .into_iter()
                .flat_map(|(kind, described)| {
                    described
                        .iter()
                        .map(move |words| format!("{kind}: {words}"))
                })
                .collect(),
        }
    };
    let suites: Vec<Suite> = pairs.iter().map(suite).collect();
    junit::junit("gearlash check", &suites)
}
