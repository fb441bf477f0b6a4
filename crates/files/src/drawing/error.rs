//! Why a drawing cannot be read: what, where, and what helps.

use super::Unit;
use super::limits::{MOST_NAMED, SAME_MM};
use crate::characters::cut;
use crate::numbers::{ascii, rounded};
use nalgebra::Point2;
use std::path::PathBuf;

/// Below this gap ends were probably meant to meet, mm.
const MEANT_TO_MEET_MM: f64 = 10.0;
/// Characters of a name that a message shows.
pub const LONGEST_NAME: usize = 60;

/// What is wrong with a drawing. Points are in mm.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DrawingError {
    /// The ending of the name is of no format that is read.
    #[error("{}: unknown kind of drawing, expected a name that ends in .dxf, .svg, .csv or .txt", .0.display())]
    Ending(PathBuf),
    /// More than a gear needs.
    #[error("has more than {most} {what}")]
    TooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How many are allowed.
        most: usize,
    },
    /// Not of the format, or not whole.
    #[error("{place}: {reason}")]
    Syntax {
        /// Where in the file.
        place: String,
        /// What is wrong and what was expected.
        reason: String,
        /// What helps.
        help: String,
    },
    /// Neither the file nor the user states the unit.
    #[error("the unit is not stated: {why}")]
    NoUnit {
        /// What the file does not say.
        why: String,
    },
    /// The unit of the file is another than the one given.
    #[error("the file states {stated}, the pair file \"{given}\"")]
    OtherUnit {
        /// As the file states it.
        stated: String,
        /// As given.
        given: Unit,
    },
    /// Something that this reader does not support.
    #[error("{place}: not supported: {kind}")]
    Refused {
        /// Where in the file.
        place: String,
        /// What it is.
        kind: String,
        /// What helps.
        help: String,
    },
    /// A number that is not finite, or that no gear has.
    #[error("{place}: {reason}")]
    Number {
        /// Where in the file.
        place: String,
        /// Which number, and what is allowed.
        reason: String,
    },
    /// A path whose ends do not meet.
    #[error("{place}: the path from {} to {}, of {elements} drawn elements, is open: from its {end} the nearest other end is {} mm away, at {}",
        at(&ends[0]), at(&ends[1]), ascii(*gap_mm, 6), at(nearest))]
    Open {
        /// Where in the file it begins.
        place: String,
        /// How many elements of the file it has.
        elements: usize,
        /// Its ends.
        ends: [Point2<f64>; 2],
        /// From which end the nearest other is measured: `start` or `end`.
        end: &'static str,
        /// That other end.
        nearest: Point2<f64>,
        /// How far it is away, mm.
        gap_mm: f64,
    },
    /// A point where more than two ends meet.
    #[error("{place}: more than two ends meet at {}", at(point))]
    Branch {
        /// Where in the file one of them is.
        place: String,
        /// The point.
        point: Point2<f64>,
    },
    /// Nothing closed is drawn.
    #[error("no closed loop: {reason}")]
    NoLoop {
        /// What there is instead.
        reason: String,
    },
    /// A layer or id that the file does not have.
    #[error("has no {what} \"{}\", {}", cut(name, LONGEST_NAME), has(known))]
    NotThere {
        /// `layer` or `id`.
        what: &'static str,
        /// The one asked for.
        name: String,
        /// Those with something drawn.
        known: Vec<String>,
    },
}

impl DrawingError {
    /// [`DrawingError::Syntax`].
    pub(super) fn syntax(
        place: impl Into<String>,
        reason: impl Into<String>,
        help: &str,
    ) -> DrawingError {
        DrawingError::Syntax {
            place: place.into(),
            reason: reason.into(),
            help: help.to_owned(),
        }
    }

    /// [`DrawingError::Refused`].
    pub(super) fn refused(
        place: impl Into<String>,
        kind: impl Into<String>,
        help: &str,
    ) -> DrawingError {
        DrawingError::Refused {
            place: place.into(),
            kind: kind.into(),
            help: help.to_owned(),
        }
    }

    /// What helps.
    pub fn help(&self) -> String {
        match self {
            DrawingError::Ending(_) => "export the outline as DXF, SVG or CSV".to_owned(),
            DrawingError::TooLarge { .. } => "export one gear alone, with a coarser tolerance".to_owned(),
            DrawingError::Syntax { help, .. } | DrawingError::Refused { help, .. } => help.clone(),
            DrawingError::NoUnit { .. } => {
                let names = Unit::NAMED.map(|(name, _)| format!("\"{name}\""));
                format!("state the length of a unit of the drawing: units = {}", names.join(" | "))
            }
            DrawingError::OtherUnit { .. } => "correct `units`, or leave it out".to_owned(),
            DrawingError::Number { .. } => "correct the number, or export the drawing again".to_owned(),
            &DrawingError::Open { gap_mm, .. } if gap_mm < MEANT_TO_MEET_MM => format!(
                "close the gap in the drawing, or state that ends so near are one point: join_mm = {}",
                above(gap_mm)
            ),
            DrawingError::Open { .. } => {
                "close the path, delete it, or name the `layer` or `id` of the outline alone".to_owned()
            }
            DrawingError::Branch { .. } => {
                "delete what is drawn twice and what is not outline, name the `layer` or `id` of the outline alone, or give a smaller join_mm"
                    .to_owned()
            }
            DrawingError::NoLoop { .. } => "draw the outline as one closed path".to_owned(),
            DrawingError::NotThere { .. } => "give one of these, or leave it out".to_owned(),
        }
    }
}

/// A point in a message.
pub fn at(point: &Point2<f64>) -> String {
    format!("({}, {}) mm", ascii(point.x, 6), ascii(point.y, 6))
}

/// The names there are.
fn has(known: &[String]) -> String {
    if known.is_empty() {
        return "and no other".to_owned();
    }
    let named: Vec<String> = known
        .iter()
        .take(MOST_NAMED)
        .map(|name| format!("\"{}\"", cut(name, LONGEST_NAME)))
        .collect();
    let more = match known.len() - named.len() {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    format!("those there are: {}{more}", named.join(", "))
}

/// A number of two digits above `gap`.
fn above(gap: f64) -> f64 {
    let unit = 10f64.powi(gap.max(SAME_MM).log10().floor() as i32 - 1);
    let above = ((gap / unit).floor() + 1.0) * unit;
    // The shortest decimal of it.
    rounded(above, 12)
}
