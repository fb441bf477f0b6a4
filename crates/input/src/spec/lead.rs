//! Deviations of the flanks along the face width.

use super::profile::ReliefShape;
use super::rules::{deviation, length, within};
use super::trace::{FlankSpec, FlanksSpec, LEAD_TRACE, TraceSpec, trace_of};
use super::value::Either;
use gearlash::gear::{Hand, PitchAxis};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_with::skip_serializing_none;

/// Lead deviations, µm, plus = more material, in the transverse section along the base tangent. Heights count from the reference face's
/// end of the teeth.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LeadSpec {
    /// Values of the flanks.
    #[serde(flatten)]
    pub flanks: FlanksSpec<FlankLeadSpec>,
    /// Height where pitch and thickness were measured; default: the measuring plane.
    #[schemars(transform = within(0.0, 1e6))]
    pub zero_mm: Option<f64>,
    /// Evaluation range L_β, heights; default: without 5 % of the width, at most one module, at both ends.
    #[schemars(transform = within(0.0, 1e6))]
    pub range_mm: Option<[f64; 2]>,
    /// Length that slopes refer to: the evaluation range (ISO 1328-1), or the whole face.
    #[serde(default)]
    pub over: SlopeLength,
    /// End from which heights of traces count.
    #[serde(default)]
    pub from: TeethEnd,
    /// Axis of the measurement; "datum": traces contain the wobble, which is taken out of them.
    #[serde(default)]
    pub axis: PitchAxis,
}

/// Lead deviations of a flank, µm, plus = more material; they add.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = deviation())]
pub struct FlankLeadSpec {
    /// Growth from the reference face to the far end.
    pub slope_um: Option<f64>,
    /// Helix slope f_Hβ, plus = greater helix angle; of spur gears "10 r" or "10 l".
    pub helix_slope_um: Option<Either<f64, SpurSlopeSpec>>,
    /// Lead crowning C_β, off both ends of the face; negative: hollow.
    pub crowning_um: Option<f64>,
    /// Taken off towards the ends.
    pub end_relief: Option<Either<EndReliefSpec, Vec<EndReliefSpec>>>,
    /// Measured leads; teeth without one take the mean.
    #[schemars(transform = trace_of(&LEAD_TRACE))]
    pub trace: Option<Either<TraceSpec, Vec<TraceSpec>>>,
}

/// Pattern of the helix slope of a spur gear.
pub(crate) const SPUR_SLOPE: &str = r"^[0-9]+(\.[0-9]+)? ?[rl]$";

/// The helix slope of a spur gear: a size and a hand.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
#[schemars(inline)]
pub struct SpurSlopeSpec {
    #[schemars(regex(pattern = SPUR_SLOPE))]
    text: String,
}

impl SpurSlopeSpec {
    /// The slope that makes flanks wind as those of this hand.
    pub fn new(um: f64, hand: Hand) -> SpurSlopeSpec {
        let letter = match hand {
            Hand::Right => 'r',
            Hand::Left => 'l',
        };
        SpurSlopeSpec {
            text: format!("{um} {letter}"),
        }
    }

    /// The text as stated: "10 r".
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Size, µm, and hand; `None` for another text.
    pub fn parsed(&self) -> Option<(f64, Hand)> {
        let (um, hand) = match self.text.strip_suffix('r') {
            Some(um) => (um, Hand::Right),
            None => (self.text.strip_suffix('l')?, Hand::Left),
        };
        let is_size = |um: &f64| (0.0..=1e7).contains(um);
        Some((um.trim_end().parse().ok().filter(is_size)?, hand))
    }

    /// The slope that a text states.
    pub(crate) fn of_text(text: &str) -> SpurSlopeSpec {
        SpurSlopeSpec {
            text: text.to_owned(),
        }
    }
}

/// Material taken off towards an end of the teeth.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct EndReliefSpec {
    /// Taken off at the end.
    #[schemars(transform = within(0.0, 1e7))]
    pub um: f64,
    /// Length over which it grows.
    #[schemars(transform = length())]
    pub length_mm: f64,
    /// Which end.
    #[serde(default)]
    pub end: ReliefEnd,
    /// As of a tip relief.
    #[serde(default)]
    pub shape: ReliefShape,
}

/// The length that slopes refer to.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum SlopeLength {
    /// The evaluation range.
    #[default]
    Range,
    /// The whole face.
    Face,
}

/// An end of the teeth.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum TeethEnd {
    /// The end of the reference face.
    #[default]
    Reference,
    /// The other end.
    Far,
}

/// The ends of the teeth with a relief.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum ReliefEnd {
    /// The end of the reference face.
    Reference,
    /// The other end.
    Far,
    /// Both ends.
    #[default]
    Both,
}

impl FlankSpec for FlankLeadSpec {
    fn or(self, both: FlankLeadSpec) -> FlankLeadSpec {
        FlankLeadSpec {
            slope_um: self.slope_um.or(both.slope_um),
            helix_slope_um: self.helix_slope_um.or(both.helix_slope_um),
            crowning_um: self.crowning_um.or(both.crowning_um),
            end_relief: self.end_relief.or(both.end_relief),
            trace: self.trace.or(both.trace),
        }
    }

    fn trace(&mut self) -> &mut Option<Either<TraceSpec, Vec<TraceSpec>>> {
        &mut self.trace
    }
}
