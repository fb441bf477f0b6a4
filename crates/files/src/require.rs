//! `[require]`: the limits of the pair, converted for the library.

use super::spec::{LimitsSpec, RequireSpec};
use gearlash::analysis::requirement::{Limits, Quantity, Requirements};

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
