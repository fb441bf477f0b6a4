//! The columns that a table may have: names, units, limits, and the headings that fit.

use super::heading::{Meaning, Quantity};
use crate::characters::listed;
use gearlash::gear::Side;
use gearlash::metrology::PitchKind;
use std::ops::Bound::{self, Excluded, Included};

/// A column of values beside the tooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Column {
    /// Pitch deviation of the right flank, µm.
    Right(PitchKind),
    /// Pitch deviation of the left flank, µm.
    Left(PitchKind),
    /// Thickness of the tooth less the mean, µm.
    Thickness,
    /// Radial runout reading, µm.
    Runout,
    /// Span `W_k`, mm.
    Span,
    /// Dimension over pins `M_dK`, mm.
    OverPins,
    /// Roll length `r_b ξ` of a point of a trace, mm.
    RollLength,
    /// Diameter of a point of a trace, mm.
    Diameter,
    /// Height of a point of a trace from an end of the teeth, mm.
    Height,
    /// Deviation of the flank at a point of a trace, µm.
    Deviation,
    /// Centre distance of a rig's result, mm.
    CenterDistance,
    WheelTooth,
    PinionTooth,
    /// Backlash that a rig measured at the right flanks, µm.
    MeasuredRight,
    /// Backlash that a rig measured at the left flanks, µm.
    MeasuredLeft,
    /// Lower limit that was predicted, µm.
    PredictedMin,
    /// Upper limit that was predicted, µm.
    PredictedMax,
}

pub struct Limits {
    /// The allowed range, in words: "a number of mm, 0 … 1e9".
    pub allowed: &'static str,
    pub range: (Bound<f64>, Bound<f64>),
}

const DEVIATION: Limits = Limits {
    allowed: "a number of µm, −1e7 … 1e7",
    range: (Included(-1e7), Included(1e7)),
};
const LENGTH: Limits = Limits {
    allowed: "a number of mm above 0 and up to 1e9",
    range: (Excluded(0.0), Included(1e9)),
};
const FROM_ZERO: Limits = Limits {
    allowed: "a number of mm, 0 … 1e9",
    range: (Included(0.0), Included(1e9)),
};

type Description = (
    &'static str,
    &'static str,
    &'static str,
    &'static Limits,
    Quantity,
);

impl Column {
    /// Name, the key that names the column in a pair file, unit, limits and heading.
    fn description(self) -> Description {
        use Quantity as Q;
        match self {
            Column::Right(_) => ("right", "right", "µm", &DEVIATION, Q::Pitch),
            Column::Left(_) => ("left", "left", "µm", &DEVIATION, Q::Pitch),
            Column::Thickness => ("thickness", "column", "µm", &DEVIATION, Q::Thickness),
            Column::Runout => ("runout", "column", "µm", &DEVIATION, Q::Runout),
            Column::Span => ("span", "column", "mm", &LENGTH, Q::Span),
            Column::OverPins => ("over pins", "column", "mm", &LENGTH, Q::OverPins),
            Column::RollLength => ("roll length", "", "mm", &FROM_ZERO, Q::RollLength),
            Column::Diameter => ("diameter", "", "mm", &LENGTH, Q::Diameter),
            Column::Height => ("height", "", "mm", &FROM_ZERO, Q::Height),
            Column::Deviation => ("deviation", "column", "µm", &DEVIATION, Q::Deviation),
            Column::CenterDistance => ("center_distance_mm", "", "mm", &LENGTH, Q::CenterDistance),
            Column::WheelTooth => ("wheel_tooth", "", "", &LENGTH, Q::WheelTooth),
            Column::PinionTooth => ("pinion_tooth", "", "", &LENGTH, Q::PinionTooth),
            Column::MeasuredRight => ("measured_right_um", "", "µm", &DEVIATION, Q::MeasuredRight),
            Column::MeasuredLeft => ("measured_left_um", "", "µm", &DEVIATION, Q::MeasuredLeft),
            Column::PredictedMin => ("predicted_min_um", "", "µm", &DEVIATION, Q::PredictedMin),
            Column::PredictedMax => ("predicted_max_um", "", "µm", &DEVIATION, Q::PredictedMax),
        }
    }

    pub fn name(self) -> &'static str {
        self.description().0
    }

    /// The key that names the column; empty without one.
    pub fn key(self) -> &'static str {
        self.description().1
    }

    pub fn unit(self) -> &'static str {
        self.description().2
    }

    pub fn limits(self) -> &'static Limits {
        self.description().3
    }

    /// Flank and kind of a pitch deviation.
    fn pitch(self) -> Option<(Side, PitchKind)> {
        match self {
            Column::Right(kind) => Some((Side::Right, kind)),
            Column::Left(kind) => Some((Side::Left, kind)),
            _ => None,
        }
    }

    pub fn kind(self) -> Option<PitchKind> {
        self.pitch().map(|(_, kind)| kind)
    }

    /// The pitch deviation of the other kind; other columns unchanged.
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

    /// Whether a column with a heading of this meaning may be this column.
    pub fn may_be(self, Meaning { side, quantity }: Meaning) -> bool {
        if let Some((wanted, kind)) = self.pitch() {
            let is_unsaid = matches!(quantity, Quantity::Unstated | Quantity::Pitch);
            return side == Some(wanted) && (is_unsaid || quantity.pitch_kind() == Some(kind));
        }
        quantity == self.description().4 && (self != Column::Deviation || side.is_none())
    }

    /// Whether a column that the user names may be this column. Its heading may state less, but nothing else.
    pub fn may_be_named(self, meaning: Meaning) -> bool {
        let Meaning { side, quantity } = meaning;
        let is_deviation = quantity == Quantity::Deviation;
        let is_unsaid = matches!(
            quantity,
            Quantity::Unstated | Quantity::MeasuredRight | Quantity::MeasuredLeft
        );
        if let Some((wanted, _)) = self.pitch() {
            let fits = is_unsaid || quantity.is_pitch() || is_deviation;
            return fits && side.is_none_or(|side| side == wanted);
        }
        is_unsaid
            || (is_deviation && matches!(self, Column::Thickness | Column::Runout))
            || self.may_be(meaning)
    }
}

/// "tooth, left (µm) and right (µm)".
pub fn headings(wanted: &[Column]) -> String {
    let columns = wanted.iter().map(|column| match column.unit() {
        "" => column.name().to_owned(),
        unit => format!("{} ({unit})", column.name()),
    });
    let place = if wanted.contains(&Column::Deviation) {
        "tooth, flank"
    } else {
        "tooth"
    };
    let words: Vec<String> = [place.to_owned()].into_iter().chain(columns).collect();
    listed(&words, "and")
}
