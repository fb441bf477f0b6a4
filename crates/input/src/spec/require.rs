//! `[require]`: limits that the pair must keep.

use super::rules::within;
use gearlash::analysis::requirement::{Limits, Quantity, Requirements};
use gearlash::pair::Member;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_with::skip_serializing_none;

/// Limits that the pair must keep over its whole mesh cycle, at every centre distance and material; exit code 1 when it does not.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(extend("minProperties" = 1), transform = within(-1e6, 1e6))]
pub struct RequireSpec {
    /// Circumferential backlash on the operating pitch circle.
    pub j_wt_um: Option<LimitsSpec>,
    /// Normal backlash.
    pub j_bn_um: Option<LimitsSpec>,
    /// Circumferential backlash on the reference circle of the gear that turns.
    pub j_t_um: Option<LimitsSpec>,
    /// Radial backlash.
    pub j_r_um: Option<LimitsSpec>,
    /// Lost motion of a gear.
    #[schemars(transform = within(-10_800.0, 10_800.0))]
    pub lost_motion_arcmin: Option<AngleLimitsSpec>,
    /// Radial clearance of the tips.
    #[schemars(transform = within(-1000.0, 1000.0))]
    pub radial_clearance_mm: Option<LimitsSpec>,
}

/// Least and greatest allowed: either or both.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline, extend("minProperties" = 1))]
pub struct LimitsSpec {
    /// Least allowed.
    pub min: Option<f64>,
    /// Greatest allowed.
    pub max: Option<f64>,
}

/// Least and greatest allowed at one of the gears.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline, extend("minProperties" = 2))]
pub struct AngleLimitsSpec {
    /// Least allowed.
    pub min: Option<f64>,
    /// Greatest allowed.
    pub max: Option<f64>,
    /// Gear at which the angle is counted, wheel or pinion.
    pub at: Member,
}

impl RequireSpec {
    /// In mm and rad.
    pub(crate) fn requirements(&self) -> Requirements {
        let mm = |limits: LimitsSpec, per: f64| Limits {
            min: limits.min.map(|min| min * per),
            max: limits.max.map(|max| max * per),
        };
        let um = 1e-3;
        let arcmin = (1.0f64 / 60.0).to_radians();
        let lengths = [
            (self.j_wt_um, Quantity::OperatingBacklash, um),
            (self.j_bn_um, Quantity::NormalBacklash, um),
            (self.j_t_um, Quantity::ReferenceBacklash, um),
            (self.j_r_um, Quantity::RadialBacklash, um),
            (self.radial_clearance_mm, Quantity::RadialClearance, 1.0),
        ];
        let lengths = lengths
            .into_iter()
            .filter_map(|(limits, quantity, per)| Some((quantity, mm(limits?, per))));
        let angle = self.lost_motion_arcmin.map(|limits| {
            let ends = LimitsSpec {
                min: limits.min,
                max: limits.max,
            };
            (Quantity::LostMotion(limits.at), mm(ends, arcmin))
        });
        lengths.chain(angle).collect()
    }
}
