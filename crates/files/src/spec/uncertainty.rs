//! `[uncertainty]`: standard uncertainties of the measurements.

use super::rules::{above_zero, within};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_with::skip_serializing_none;

/// Standard uncertainties of what was measured, µm; the expanded uncertainty of least and greatest backlash follows.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct UncertaintySpec {
    /// A span.
    #[schemars(transform = within(0.0, 1e6))]
    pub span_um: f64,
    /// A dimension over pins.
    #[schemars(transform = within(0.0, 1e6))]
    pub over_pins_um: f64,
    /// A thickness stated in any other way.
    #[schemars(transform = within(0.0, 1e6))]
    pub allowance_um: f64,
    /// A tooth against the others.
    #[schemars(transform = within(0.0, 1e6))]
    pub per_tooth_um: f64,
    /// The pitch deviation of a flank.
    #[schemars(transform = within(0.0, 1e6))]
    pub pitch_um: f64,
    /// The runout of each gear.
    #[schemars(transform = within(0.0, 1e6))]
    pub runout_um: f64,
    /// The centre distance.
    #[schemars(transform = within(0.0, 1e6))]
    pub center_distance_um: f64,
    /// The lead deviation of a flank where it touches.
    #[schemars(transform = within(0.0, 1e6))]
    pub lead_um: Option<f64>,
    /// Both deviations of the shafts, over the length of assembly.misalignment.
    #[schemars(transform = within(0.0, 1e6))]
    pub misalignment_um: Option<f64>,
    /// Coverage factor of the expanded uncertainty.
    #[schemars(transform = above_zero(10.0))]
    pub coverage_factor: f64,
}

impl Default for UncertaintySpec {
    fn default() -> UncertaintySpec {
        UncertaintySpec {
            span_um: 0.0,
            over_pins_um: 0.0,
            allowance_um: 0.0,
            per_tooth_um: 0.0,
            pitch_um: 0.0,
            runout_um: 0.0,
            center_distance_um: 0.0,
            lead_um: None,
            misalignment_um: None,
            coverage_factor: 2.0,
        }
    }
}
