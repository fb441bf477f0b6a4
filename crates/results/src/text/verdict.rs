//! The head of a command's text: the title, and the verdict below it.

use crate::layout::{Screen, Tone};
use crate::verdict::VerdictLines;
use gearlash::analysis::diagnosis::Verdict;
use gearlash_files::characters::plain;

/// The title, and below it the verdict; its first line is coloured on a terminal.
pub(crate) fn heading(title: &str, lines: &VerdictLines, screen: &Screen) -> String {
    let tone = match lines.state {
        Verdict::Pass => Tone::Good,
        Verdict::Warn | Verdict::Unproven => Tone::Doubtful,
        Verdict::Fail => Tone::Bad,
    };
    let mut lines = lines.lines();
    lines[0] = screen.toned(tone, &lines[0]);
    format!("{}\n\n{}\n\n", plain(title), lines.join("\n"))
}
