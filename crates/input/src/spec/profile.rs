//! Deviations of the flanks from the involute.

use super::rules::{deviation, length, list_length, within};
use super::trace::{FlankSpec, FlanksSpec, PROFILE_TRACE, TraceSpec, trace_of};
use super::value::Either;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_with::skip_serializing_none;

/// Profile deviations, µm, plus = more material.
pub type ProfileSpec = FlanksSpec<FlankProfileSpec>;

/// Profile deviations of a flank, µm, plus = more material; they add.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = deviation())]
pub struct FlankProfileSpec {
    /// Profile slope f_Hα at the end of the evaluation range, 0 at its start.
    pub slope_um: Option<f64>,
    /// Profile crowning C_α in the middle of the evaluation range, 0 at its ends; negative: hollow.
    pub crowning_um: Option<f64>,
    /// Taken off towards the tip.
    pub tip_relief: Option<ReliefSpec>,
    /// Taken off towards the root.
    pub root_relief: Option<ReliefSpec>,
    /// Evaluation range, diameters; default: root form circle to tip circle.
    #[schemars(with = "Option<Vec<f64>>", transform = length(), transform = list_length(2, Some(2)))]
    pub range_mm: Option<[f64; 2]>,
    /// Measured profiles; teeth without one take the mean.
    #[schemars(transform = trace_of(&PROFILE_TRACE))]
    pub trace: Option<Either<TraceSpec, Vec<TraceSpec>>>,
}

/// Material taken off a flank.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ReliefSpec {
    /// Taken off at the tip circle, or at the root form circle.
    #[schemars(transform = within(0.0, 1e7))]
    pub um: f64,
    /// Diameter at which it begins.
    #[schemars(transform = length())]
    pub from_diameter_mm: f64,
    /// Growth with the roll: "linear", with an edge, or "parabolic".
    #[serde(default)]
    pub shape: ReliefShape,
}

/// How a relief grows with the roll.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum ReliefShape {
    /// As a straight line, with an edge where it begins.
    #[default]
    Linear,
    /// As a parabola that leaves the flank smoothly.
    Parabolic,
}

impl FlankProfileSpec {
    /// The traces.
    pub fn traces(&self) -> &[TraceSpec] {
        self.trace.as_ref().map_or(&[], Either::as_list)
    }
}

impl FlankSpec for FlankProfileSpec {
    fn or(self, both: FlankProfileSpec) -> FlankProfileSpec {
        FlankProfileSpec {
            slope_um: self.slope_um.or(both.slope_um),
            crowning_um: self.crowning_um.or(both.crowning_um),
            tip_relief: self.tip_relief.or(both.tip_relief),
            root_relief: self.root_relief.or(both.root_relief),
            range_mm: self.range_mm.or(both.range_mm),
            trace: self.trace.or(both.trace),
        }
    }

    fn trace(&mut self) -> &mut Option<Either<TraceSpec, Vec<TraceSpec>>> {
        &mut self.trace
    }
}
