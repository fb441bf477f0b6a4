//! The columns a table may have: their names, units and limits.

use super::heading::{Meaning, Quantity};
use crate::entry::Limits;
use gearlash::gear::Side;
use gearlash::metrology::PitchKind;
use std::ops::Bound::{Excluded, Included};

/// A column of values beside the tooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Column {
    /// Pitch deviation of the right flank, µm.
    Right(PitchKind),
    /// Pitch deviation of the left flank, µm.
    Left(PitchKind),
    /// What the tooth is thicker than the mean, µm.
    Thickness,
    /// Radial runout reading, µm.
    Runout,
    /// Span `W_k`, mm.
    Span,
    /// Dimension over pins `M_dK`, mm.
    OverPins,
    /// Of a profile trace: roll length `r_b ξ`, mm.
    RollLength,
    /// Of a profile trace: diameter, mm.
    Diameter,
    /// Of a profile trace: what the flank has beyond its involute, µm.
    Deviation,
}

const DEVIATION: Limits = Limits {
    allowed: "a number of µm, −1e7 … 1e7",
    range: (Included(-1e7), Included(1e7)),
    help: "correct the line",
};
const LENGTH: Limits = Limits {
    allowed: "a number of mm above 0 and up to 1e9",
    range: (Excluded(0.0), Included(1e9)),
    help: "correct the line",
};

const ROLL_LENGTH: Limits = Limits {
    allowed: "a number of mm, 0 … 1e9",
    range: (Included(0.0), Included(1e9)),
    help: "correct the line",
};

impl Column {
    /// Its name in messages.
    pub fn name(self) -> &'static str {
        match self {
            Column::Right(_) => "right",
            Column::Left(_) => "left",
            Column::Thickness => "thickness",
            Column::Runout => "runout",
            Column::Span => "span",
            Column::OverPins => "over pins",
            Column::RollLength => "roll length",
            Column::Diameter => "diameter",
            Column::Deviation => "deviation",
        }
    }

    /// The key that says which column of a table it is; none of what a trace says where it is.
    pub fn key(self) -> &'static str {
        match self {
            Column::Right(_) => "right",
            Column::Left(_) => "left",
            Column::RollLength | Column::Diameter => "",
            _ => "column",
        }
    }

    /// Whether a column of this `meaning` may be it.
    pub fn may_be(self, meaning: Meaning) -> bool {
        let Meaning { side, quantity } = meaning;
        let of_flank = |wanted, kind| {
            side == Some(wanted)
                && match quantity {
                    Quantity::Unsaid | Quantity::Pitch(None) => true,
                    Quantity::Pitch(said) => said == Some(kind),
                    _ => false,
                }
        };
        match self {
            Column::Right(kind) => of_flank(Side::Right, kind),
            Column::Left(kind) => of_flank(Side::Left, kind),
            Column::Thickness => quantity == Quantity::Thickness,
            Column::Runout => quantity == Quantity::Runout,
            Column::Span => quantity == Quantity::Span,
            Column::OverPins => quantity == Quantity::OverPins,
            Column::RollLength => quantity == Quantity::RollLength,
            Column::Diameter => quantity == Quantity::Diameter,
            Column::Deviation => quantity == Quantity::Deviation && side.is_none(),
        }
    }

    /// Whether a column of this `meaning` may be it where the user names it: its heading may say less, but nothing else.
    pub fn may_be_named(self, meaning: Meaning) -> bool {
        let Meaning { side, quantity } = meaning;
        let is_side = |wanted| side.is_none_or(|side| side == wanted);
        match (self, quantity) {
            (Column::Right(_), Quantity::Unsaid | Quantity::Pitch(_) | Quantity::Deviation) => {
                is_side(Side::Right)
            }
            (Column::Left(_), Quantity::Unsaid | Quantity::Pitch(_) | Quantity::Deviation) => {
                is_side(Side::Left)
            }
            (Column::Right(_) | Column::Left(_), _) => false,
            (_, Quantity::Unsaid) => true,
            (Column::Thickness | Column::Runout, Quantity::Deviation) => true,
            _ => self.may_be(meaning),
        }
    }

    /// Of a pitch deviation, its kind.
    pub fn kind(self) -> Option<PitchKind> {
        match self {
            Column::Right(kind) | Column::Left(kind) => Some(kind),
            _ => None,
        }
    }

    /// Of a pitch deviation, that of the other kind; else the same.
    pub fn of_other_kind(self) -> Column {
        let other = |kind| match kind {
            PitchKind::Single => PitchKind::Cumulative,
            PitchKind::Cumulative => PitchKind::Single,
        };
        match self {
            Column::Right(kind) => Column::Right(other(kind)),
            Column::Left(kind) => Column::Left(other(kind)),
            column => column,
        }
    }

    /// Its unit.
    pub fn unit(self) -> &'static str {
        match self {
            Column::Span | Column::OverPins | Column::RollLength | Column::Diameter => "mm",
            _ => "µm",
        }
    }

    /// What its values may be.
    pub fn limits(self) -> &'static Limits {
        match self {
            Column::Span | Column::OverPins | Column::Diameter => &LENGTH,
            Column::RollLength => &ROLL_LENGTH,
            _ => &DEVIATION,
        }
    }
}

/// "tooth, left (µm) and right (µm)".
pub fn headings(wanted: &[Column]) -> String {
    let columns: Vec<String> = wanted
        .iter()
        .map(|column| format!("{} ({})", column.name(), column.unit()))
        .collect();
    let place = match wanted.contains(&Column::Deviation) {
        true => "tooth, flank",
        false => "tooth",
    };
    match columns.split_last() {
        Some((last, [])) => format!("tooth and {last}"),
        Some((last, rest)) => format!("{place}, {} and {last}", rest.join(", ")),
        None => "tooth".to_owned(),
    }
}
