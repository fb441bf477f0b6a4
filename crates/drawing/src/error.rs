//! Why a drawing cannot be read: what, where, and what helps.

use super::limits::{MAX_NAMED, SAME_MM};
use gearlash_text::characters::{cut, first_of};
use gearlash_text::numbers::{ascii, rounded};
use nalgebra::Point2;
use std::fmt::Display;

/// Below this gap ends were probably meant to meet, mm.
const MEANT_TO_MEET_MM: f64 = 10.0;
/// Characters of a name that a message shows.
pub const LONGEST_NAME: usize = 60;

/// A fault of a drawing, in words. Points are in mm.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{reason}")]
pub struct DrawingError {
    /// Its place in the file, what is wrong, and what was expected.
    pub reason: String,
    /// The remedy.
    pub help: String,
    /// Whether the drawing needs a unit, as it states none.
    pub lacks_unit: bool,
}

impl DrawingError {
    /// A fault without a place in the file.
    pub(super) fn new(reason: impl Display, help: impl Display) -> DrawingError {
        DrawingError {
            reason: reason.to_string(),
            help: help.to_string(),
            lacks_unit: false,
        }
    }

    /// A fault at `place`.
    pub(super) fn at(place: impl Display, reason: impl Display, help: &str) -> DrawingError {
        DrawingError::new(format!("{place}: {reason}"), help)
    }

    /// Something at `place` that is not supported.
    pub(super) fn refused(place: impl Display, kind: impl Display, help: &str) -> DrawingError {
        DrawingError::at(place, format!("not supported: {kind}"), help)
    }

    pub(super) fn too_large(what: &str, most: usize) -> DrawingError {
        let help = "export one gear alone, with a coarser tolerance";
        DrawingError::new(format!("has more than {most} {what}"), help)
    }

    /// A number that is not finite, or that no gear has.
    pub(super) fn number(place: &str, reason: String) -> DrawingError {
        let help = "correct the number, or export the drawing again";
        DrawingError::at(place, reason, help)
    }

    /// The drawing has no closed path.
    pub(super) fn no_loop(reason: String) -> DrawingError {
        let help = "draw the outline as one closed path";
        DrawingError::new(format!("no closed loop: {reason}"), help)
    }

    /// A layer or id (`what`) that the file does not have; `known` are those that it has.
    pub(super) fn not_there(what: &str, name: &str, known: &[String]) -> DrawingError {
        let name = cut(name, LONGEST_NAME);
        let reason = format!("has no {what} \"{name}\", {}", available_names(known));
        DrawingError::new(reason, "give one of these, or leave it out")
    }

    /// A point where more than two ends meet.
    pub(super) fn branch(place: &str, point: &Point2<f64>) -> DrawingError {
        DrawingError::at(
            place,
            format!("more than two ends meet at {}", at(point)),
            "delete what is drawn twice and what is not outline; name the `layer` or `id` of the outline alone, or give a smaller join_mm",
        )
    }

    /// A path whose ends do not meet, `gap_mm` apart where they come nearest.
    pub(super) fn open(reason: String, gap_mm: f64) -> DrawingError {
        let help = if gap_mm < MEANT_TO_MEET_MM {
            format!(
                "close the gap in the drawing, or state that ends so near are one point: join_mm = {}",
                rounded_above(gap_mm)
            )
        } else {
            "close the path, delete it, or name the `layer` or `id` of the outline alone".to_owned()
        };
        DrawingError::new(reason, help)
    }
}

pub fn at(point: &Point2<f64>) -> String {
    format!("({}, {}) mm", ascii(point.x, 6), ascii(point.y, 6))
}

fn available_names(known: &[String]) -> String {
    if known.is_empty() {
        return "and no other".to_owned();
    }
    let named = known
        .iter()
        .map(|name| format!("\"{}\"", cut(name, LONGEST_NAME)));
    format!("those there are: {}", first_of(named, MAX_NAMED))
}

/// A number of two digits above `gap`.
fn rounded_above(gap: f64) -> f64 {
    let unit = 10f64.powi(gap.max(SAME_MM).log10().floor() as i32 - 1);
    let above = ((gap / unit).floor() + 1.0) * unit;
    // The shortest decimal of it.
    rounded(above, 12)
}
