//! What a command says first: the title, and the verdict below it.

use crate::layout::{Screen, Tone};
use crate::verdict::sentence;
use gearlash::analysis::diagnosis::Verdict as State;
use gearlash::analysis::verdict::Verdict;
use gearlash_files::characters::plain;

/// The title and the verdict, each in a paragraph of its own; on a terminal what it begins with is coloured.
pub(crate) fn first_lines(title: &str, verdict: &Verdict, screen: &Screen) -> String {
    let sentence = sentence(verdict);
    let tone = match verdict.state() {
        State::Pass if verdict.failed_checks.is_empty() => Tone::Good,
        State::Unproven => Tone::Doubtful,
        State::Pass | State::Warn | State::Fail => Tone::Bad,
    };
    heading(title, tone, &sentence, screen)
}

/// The same of any sentence, coloured up to its colon.
pub(super) fn heading(title: &str, tone: Tone, sentence: &str, screen: &Screen) -> String {
    let (first, rest) = sentence.split_once(':').unwrap_or((sentence, ""));
    let colon = if rest.is_empty() { "" } else { ":" };
    format!(
        "{}\n\n{}{colon}{rest}\n\n",
        plain(title),
        screen.toned(tone, first)
    )
}
