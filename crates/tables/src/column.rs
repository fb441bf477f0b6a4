//! The columns that a table may have: names, units, limits, and the headings that fit.

use gearlash::gear::Side;
use gearlash::metrology::PitchKind;
use gearlash_text::MM_PER_INCH;
use gearlash_text::characters::listed;
use serde::Deserialize;
use std::ops::Bound::{self, Excluded, Included};

/// A quantity in a column of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Not stated: the heading names only a flank.
    Unstated,
    /// Number of a tooth.
    Tooth,
    /// A number of an unspecified quantity.
    Number,
    /// The first tooth of a span.
    FirstTooth,
    /// Number of a space.
    Space,
    /// Pitch deviation of either kind, µm.
    Pitch,
    /// Single pitch deviation, µm.
    SinglePitch,
    /// Cumulative pitch deviation, µm.
    CumulativePitch,
    /// Difference of neighbouring single pitch deviations, which follows from them.
    PitchDifference,
    /// Radial runout reading, µm.
    Runout,
    /// Thickness of the tooth less the mean, µm.
    Thickness,
    /// Span `W_k`, mm.
    Span,
    /// Dimension over pins `M_dK`, mm.
    OverPins,
    /// Dimension over three pins, mm.
    OverThreePins,
    /// Roll length `r_b ξ` of a point of a trace, mm.
    RollLength,
    /// Diameter of a point of a trace, mm.
    Diameter,
    /// Height of a point of a trace from an end of the teeth, mm.
    Height,
    /// Deviation of the flank at a point of a trace, µm.
    Deviation,
    /// The name of a flank in each row.
    Flank,
    /// Centre distance of a rig's result, mm.
    CenterDistance,
    /// Tooth of the wheel in a rig's result.
    WheelTooth,
    /// Tooth of the pinion in a rig's result.
    PinionTooth,
    /// Backlash that a rig measured at the right flanks, µm.
    MeasuredRight,
    /// Backlash that a rig measured at the left flanks, µm.
    MeasuredLeft,
    /// Lower limit that was predicted, µm.
    PredictedMin,
    /// Upper limit that was predicted, µm.
    PredictedMax,
    /// Words about the origin of a row.
    Source,
}

impl Quantity {
    /// Whether it is a pitch deviation of any kind.
    pub fn is_pitch(self) -> bool {
        self == Quantity::Pitch || self.pitch_kind().is_some()
    }

    /// Whether a table may lack it.
    pub fn is_optional(self) -> bool {
        matches!(self, Quantity::PredictedMin | Quantity::PredictedMax)
    }

    /// Kind of a pitch deviation, where it is stated.
    pub fn pitch_kind(self) -> Option<PitchKind> {
        match self {
            Quantity::SinglePitch => Some(PitchKind::Single),
            Quantity::CumulativePitch => Some(PitchKind::Cumulative),
            _ => None,
        }
    }

    fn of_pitch(kind: PitchKind) -> Quantity {
        match kind {
            PitchKind::Single => Quantity::SinglePitch,
            PitchKind::Cumulative => Quantity::CumulativePitch,
        }
    }
}

/// A column that is wanted, or the meaning of a heading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// The flank that a heading names. A wanted column has one where it is of pitch.
    pub side: Option<Side>,
    /// The quantity of its values.
    pub quantity: Quantity,
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

impl Column {
    /// The column of a `quantity` of no flank.
    pub fn of(quantity: Quantity) -> Column {
        Column {
            side: None,
            quantity,
        }
    }

    /// The column of the pitch deviations of one flank.
    pub fn pitch(side: Side, kind: PitchKind) -> Column {
        Column {
            side: Some(side),
            quantity: Quantity::of_pitch(kind),
        }
    }

    /// Name, the key that names the column in a pair file, unit and limits of a wanted column.
    fn description(self) -> (&'static str, &'static str, &'static str, &'static Limits) {
        match self.quantity {
            Quantity::SinglePitch | Quantity::CumulativePitch => {
                let side = self.side.map_or("", Side::name);
                (side, side, "µm", &DEVIATION)
            }
            Quantity::Thickness => ("thickness", "column", "µm", &DEVIATION),
            Quantity::Runout => ("runout", "column", "µm", &DEVIATION),
            Quantity::Span => ("span", "column", "mm", &LENGTH),
            Quantity::OverPins => ("over pins", "column", "mm", &LENGTH),
            Quantity::RollLength => ("roll length", "", "mm", &FROM_ZERO),
            Quantity::Diameter => ("diameter", "", "mm", &LENGTH),
            Quantity::Height => ("height", "", "mm", &FROM_ZERO),
            Quantity::Deviation => ("deviation", "column", "µm", &DEVIATION),
            Quantity::CenterDistance => ("center_distance_mm", "", "mm", &LENGTH),
            Quantity::WheelTooth => ("wheel_tooth", "", "", &LENGTH),
            Quantity::PinionTooth => ("pinion_tooth", "", "", &LENGTH),
            Quantity::MeasuredRight => ("measured_right_um", "", "µm", &DEVIATION),
            Quantity::MeasuredLeft => ("measured_left_um", "", "µm", &DEVIATION),
            Quantity::PredictedMin => ("predicted_min_um", "", "µm", &DEVIATION),
            Quantity::PredictedMax => ("predicted_max_um", "", "µm", &DEVIATION),
            _ => ("", "", "", &LENGTH),
        }
    }

    /// Its name in messages.
    pub fn name(self) -> &'static str {
        self.description().0
    }

    /// The key that names the column; empty without one.
    pub fn key(self) -> &'static str {
        self.description().1
    }

    /// The unit of its values; empty without one.
    pub fn unit(self) -> &'static str {
        self.description().2
    }

    /// Factor from values in `unit`, by default its own: 1000 for mm in place of µm. Inches and thousandths of an inch are converted.
    /// `None` for any other unit.
    pub fn from_unit(self, unit: Option<&str>) -> Option<f64> {
        match (self.unit(), unit) {
            (_, None) => Some(1.0),
            (own, Some(unit)) if unit == own => Some(1.0),
            ("µm", Some("mm")) => Some(1000.0),
            ("µm", Some("in")) => Some(1e3 * MM_PER_INCH),
            ("µm", Some("mil")) | ("mm", Some("in")) => Some(MM_PER_INCH),
            ("mm", Some("mil")) => Some(1e-3 * MM_PER_INCH),
            _ => None,
        }
    }

    /// The allowed values.
    pub fn limits(self) -> &'static Limits {
        self.description().3
    }

    /// Kind of a pitch deviation, where it is stated.
    pub fn kind(self) -> Option<PitchKind> {
        self.quantity.pitch_kind()
    }

    /// The pitch deviation of the other kind; other columns unchanged.
    pub fn of_other_kind(self) -> Column {
        let quantity = match self.quantity {
            Quantity::SinglePitch => Quantity::CumulativePitch,
            Quantity::CumulativePitch => Quantity::SinglePitch,
            quantity => quantity,
        };
        Column { quantity, ..self }
    }

    /// Whether a column with a heading of this meaning may be this column.
    pub fn may_be(self, heading: Column) -> bool {
        let is_quantity = heading.quantity == self.quantity;
        if self.kind().is_some() {
            let is_unstated = matches!(heading.quantity, Quantity::Unstated | Quantity::Pitch);
            return heading.side == self.side && (is_unstated || is_quantity);
        }
        is_quantity && (self.quantity != Quantity::Deviation || heading.side.is_none())
    }

    /// Whether a column that the user names may be this column. Its heading may state less, but nothing else.
    pub fn may_be_named(self, heading: Column) -> bool {
        let Column { side, quantity } = heading;
        let is_deviation = quantity == Quantity::Deviation;
        let is_unstated = matches!(
            quantity,
            Quantity::Unstated | Quantity::MeasuredRight | Quantity::MeasuredLeft
        );
        if self.kind().is_some() {
            let fits = is_unstated || quantity.is_pitch() || is_deviation;
            return fits && (side.is_none() || side == self.side);
        }
        is_unstated
            || (is_deviation && matches!(self.quantity, Quantity::Thickness | Quantity::Runout))
            || self.may_be(heading)
    }
}

/// "tooth, left (µm) and right (µm)".
pub fn headings(wanted: &[Column]) -> String {
    let columns = wanted.iter().map(|column| match column.unit() {
        "" => column.name().to_owned(),
        unit => format!("{} ({unit})", column.name()),
    });
    let mut wanted = wanted.iter();
    let place = if wanted.any(|column| column.quantity == Quantity::Deviation) {
        "tooth, flank"
    } else {
        "tooth"
    };
    let words: Vec<String> = [place.to_owned()].into_iter().chain(columns).collect();
    listed(&words, "and")
}
