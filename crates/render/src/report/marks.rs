//! Marks for pass, warning, unproven and fail, distinguished by shape, colour and word.

use gearlash::analysis::diagnosis::Verdict;
use maud::{Markup, html};

/// Outline in a box of 16 by 16, and the strokes in it.
fn shape(verdict: Verdict) -> [&'static str; 2] {
    match verdict {
        Verdict::Pass => ["M8 1a7 7 0 1 0 .01 0z", "M4.5 8.2L7 10.7L11.5 5.5"],
        Verdict::Warn => ["M8 1.2L15.4 14.6H.6z", "M8 5.8V10M8 11.6V13"],
        Verdict::Unproven => ["M8 .6L15.4 8L8 15.4L.6 8z", "M5 8H11"],
        Verdict::Fail => ["M1.5 1.5H14.5V14.5H1.5z", "M5 5L11 11M11 5L5 11"],
    }
}

/// The verdict called `word`.
pub(super) fn named(word: &str) -> Option<Verdict> {
    let all = [
        Verdict::Pass,
        Verdict::Warn,
        Verdict::Unproven,
        Verdict::Fail,
    ];
    all.into_iter().find(|verdict| verdict.name() == word)
}

/// The mark of a verdict and its word.
pub(super) fn mark(verdict: Verdict) -> Markup {
    let word = match verdict {
        Verdict::Warn => "warning",
        other => other.name(),
    };
    marked(verdict, word)
}

/// The mark of a verdict before another word.
pub(super) fn marked(verdict: Verdict, word: &str) -> Markup {
    let [outline, strokes] = shape(verdict);
    html! {
        span.mark.(verdict.name()) {
            svg viewBox="0 0 16 16" aria-hidden="true" {
                path d=(outline) fill="currentColor" {}
                path.stroke d=(strokes) {}
            }
            (word)
        }
    }
}
