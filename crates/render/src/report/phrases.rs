//! Phrases and symbols that sections share: bands, symbols and the user's words.

use crate::pose_name::{phase_name, pose_name};
use gearlash::analysis::outcome::PoseOfRun;
use gearlash::analysis::requirement::Requirements;
use gearlash::gear::Side;
pub(super) use gearlash_text::characters::plain;
use gearlash_text::numbers::{NONE, rounded, shortest, um, unit_of};
use maud::{Markup, html};

/// `least … greatest`, in µm.
pub(super) fn band(ends: [Option<f64>; 2], decimals: usize) -> String {
    match ends {
        [None, None] => NONE.to_owned(),
        [least, greatest] => format!("{} … {}", um(least, decimals), um(greatest, decimals)),
    }
}

/// The limits of each `required` quantity, such as `j_wt 80 … 200 µm`.
pub(super) fn limits(required: &Requirements) -> Vec<String> {
    let mut words = Vec::new();
    for (quantity, limits) in required {
        let (name, unit, per, _) = unit_of(*quantity);
        let [min, max] = [limits.min, limits.max].map(|end| Some(shortest(rounded(end? * per, 9))));
        words.push(match (min, max) {
            (Some(min), Some(max)) => format!("{name} {min} … {max} {unit}"),
            (Some(min), None) => format!("{name} ≥ {min} {unit}"),
            (None, max) => format!("{name} ≤ {} {unit}", max.unwrap_or_default()),
        });
    }
    words
}

/// `words` with a full stop, or unchanged if a question.
pub(super) fn sentence(words: &str) -> String {
    if words.ends_with('?') {
        words.to_owned()
    } else {
        format!("{words}.")
    }
}

pub(super) fn j_wt() -> Markup {
    symbol("j", "wt")
}

pub(super) fn symbol(letter: &str, index: &str) -> Markup {
    html! { @if !letter.is_empty() { i { (letter) } } @if !index.is_empty() { sub { (index) } } }
}

/// `text` with its backlash symbols, such as `j_wt`, set as symbols.
pub(super) fn with_symbols(text: &str) -> Markup {
    let mut pieces = text.split("j_");
    html! {
        (pieces.next().unwrap_or_default())
        @for piece in pieces {
            @let end = piece.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(piece.len());
            (symbol("j", &piece[..end])) (&piece[end..])
        }
    }
}

/// The note that explains “K (8)”: the cited study.
pub(super) fn study() -> Markup {
    html! {
        p.note {
            "K (n): equation n of Karba, Yıldırım, Erdoğan, Vardar: "
            cite { "A study on prediction & validation of meshing gear pair backlash under various manufacturing and assembly errors" }
            "; model 1 below is its linear formula, named as there."
        }
    }
}

/// The teeth in contact: right flanks, left flanks; wheel and pinion tooth each.
pub(super) fn touching(found: Option<PoseOfRun>) -> [String; 2] {
    let lost_motion = found.and_then(|found| found.pose.simulated.proven());
    Side::BOTH.map(|side| {
        let contact = lost_motion.and_then(|lost_motion| lost_motion.on(side));
        contact.map_or(NONE.to_owned(), |contact| {
            format!("{}·{}", contact.wheel.tooth, contact.pinion.tooth)
        })
    })
}

/// A pose in words: mating, flank, fraction.
pub(super) fn pose(found: PoseOfRun) -> String {
    pose_name(found.pose.simulated.pose.mating()) + &phase_name(found.run.run.phase)
}

#[cfg(test)]
mod tests {
    use super::sentence;

    /// A note on a centre distance ended in `the file?.`
    #[test]
    fn a_question_has_no_full_stop() {
        assert_eq!(sentence("forgotten in the file?"), "forgotten in the file?");
        assert_eq!(sentence("it is 0.2 mm off"), "it is 0.2 mm off.");
    }
}
