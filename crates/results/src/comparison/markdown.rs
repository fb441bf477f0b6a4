//! The outcome of `compare` as GitHub-flavoured Markdown: a table for reviewers.

use super::{PairOutcome, failure, outcome, run_name, trouble};
use crate::ComparedPair;
use crate::layout::where_it_is;
use crate::verdict::sentence;
use gearlash::analysis::compare::{ComparedPose, Verdict};
use gearlash::analysis::tally::RunTally;
use gearlash::analysis::verdict::Requirement;
use gearlash_files::characters::plain;
use gearlash_files::numbers::{NONE, power, um_ascii};
use std::fmt::Write;

const HEADINGS: [&str; 8] = [
    "run",
    "poses",
    "least j_wt µm",
    "greatest j_wt µm",
    "off model 2 µm",
    "off model 3 µm",
    "touch off the line of action",
    "verdict",
];

/// A heading with the verdict, and for each pair a table with a row a run; what failed in words below it.
pub fn markdown(pairs: &[ComparedPair]) -> String {
    let count = |of: PairOutcome| {
        let pairs = pairs.iter();
        pairs.filter(|pair| outcome(pair) == of).count()
    };
    let all = pairs.len();
    let mut failing = Vec::new();
    match count(PairOutcome::Disagrees) {
        0 => {}
        pairs => failing.push(format!(
            "simulated and analytic backlash disagree in {pairs} of {all} pairs"
        )),
    }
    match count(PairOutcome::Unproven) {
        0 => {}
        pairs => failing.push(format!("unproven poses in {pairs} of {all} pairs")),
    }
    match count(PairOutcome::Nothing) {
        0 => {}
        pairs => failing.push(format!("nothing to compare in {pairs} of {all} pairs")),
    }
    let unmet = pairs
        .iter()
        .filter(|pair| pair.verdict().requirement == Requirement::NotMet);
    match unmet.count() {
        0 => {}
        pairs => failing.push(format!(
            "a requirement is not met in {pairs} of {all} pairs"
        )),
    }
    let verdict = match failing.is_empty() {
        true => format!("✅ simulated and analytic backlash agree ({all} of {all} pairs)"),
        false => format!("❌ {}", failing.join("; ")),
    };
    let mut text = format!("## gearlash compare: {verdict}\n");
    for pair in pairs {
        let _ = write!(
            text,
            "\n### {} {}\n\n{}\n\n{} · tolerance {} µm + error bound",
            mark(pair.passes()),
            escape(&pair.title),
            escape(&sentence(&pair.verdict())),
            escape(&pair.file),
            pair.tolerance_um,
        );
        text += match pair.allow_off_line {
            true => " · contact off the line of action allowed\n\n",
            false => "\n\n",
        };
        let _ = writeln!(text, "| {} |", HEADINGS.join(" | "));
        text += "| :-- | --: | --: | --: | --: | --: | --: | :-- |\n";
        for run in &pair.runs {
            let _ = writeln!(text, "| {} |", row(pair, run).join(" | "));
        }
        for run in &pair.runs {
            if let Some(reason) = failure(pair, run) {
                let _ = writeln!(text, "\n**{}**: {}", run_name(run), escape(&reason));
            }
        }
    }
    let _ = writeln!(
        text,
        "\nBacklash `j_wt` at the operating pitch circle, at its mating; negative: interference. Off model 2 and 3: \
         largest difference to the involute and to the line-of-action formula; model 3 gates. gearlash {}.",
        env!("CARGO_PKG_VERSION")
    );
    text
}

fn row(pair: &ComparedPair, run: &RunTally) -> Vec<String> {
    let summary = run.summary();
    let (least, greatest) = run.extremes().unzip();
    let at = |length, pose: Option<&ComparedPose>| match pose {
        Some(pose) => format!("{} at {}", um_ascii(length, 3), where_it_is(pose)),
        None => NONE.to_owned(),
    };
    let passes = run.passes(pair.allow_off_line);
    let verdict = format!("{} {}", mark(passes), if passes { "ok" } else { "FAIL" });
    vec![
        run_name(run),
        run.poses.to_string(),
        at(summary.min, least),
        at(summary.max, greatest),
        um_ascii(summary.off_involute, 3),
        match summary.off_line_of_action {
            // Rounding alone: its size, rather than 0.000.
            Some(length) if length < 1e-6 => power(length * 1e3, 1),
            length => um_ascii(length, 3),
        },
        run.count(Verdict::OffLine).to_string(),
        match trouble(run) {
            Some(what) => format!("{verdict}; {what}"),
            None => verdict,
        },
    ]
}

pub(crate) fn mark(passes: bool) -> &'static str {
    if passes { "✅" } else { "❌" }
}

/// Text that Markdown takes as nothing but text, on one line.
pub(crate) fn escape(text: &str) -> String {
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
    // Text becomes a link by these two alone.
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
