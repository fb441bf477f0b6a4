//! `[uncertainty]`: standard uncertainties of the measurements, converted for the library.

use super::spec::{AssemblySpec, GearSpec, ThicknessSpec, UncertaintySpec};
use gearlash::analysis::uncertainty::Uncertainty;
use gearlash::gear::{AsBuilt, thickness};

impl UncertaintySpec {
    /// In mm for the library, with the thickness of each gear by its statement.
    pub(crate) fn of_pair(
        &self,
        assembly: &AssemblySpec,
        gears: [(&GearSpec, &AsBuilt); 2],
    ) -> Uncertainty {
        let mm = 1e-3;
        Uncertainty {
            base_thickness: gears
                .map(|(spec, gear)| spec.scale() * self.base_thickness(&spec.thickness, gear)),
            per_tooth: self.per_tooth_um * mm,
            pitch: self.pitch_um * mm,
            runout: self.runout_um * mm,
            center_distance: self.center_distance_um * mm,
            lead: self.lead_um.unwrap_or(0.0) * mm,
            lean: self
                .misalignment_um
                .zip(assembly.over_mm())
                .map_or(0.0, |(um, over)| um * mm / over),
            distance_at: assembly.holds_at(),
            coverage: self.coverage_factor,
        }
    }

    /// Standard uncertainty of `s_bt`, mm. A span measures `s_bt cos β_b`. A thicker tooth lifts pins: the slope of that lift
    /// converts. An allowance applies at the reference circle in the normal section; at the base circle it is
    /// `cos α_t/cos β` times that.
    fn base_thickness(&self, spec: &ThicknessSpec, gear: &AsBuilt) -> f64 {
        let basic_data = gear.gear().basic_data();
        let stated = &spec.statement;
        let um = if stated.span.is_some() {
            self.span_um / basic_data.base_helix_angle().cos()
        } else if let Some(pins) = &stated.over_pins {
            let base = gear.gear().base_thickness();
            // A thousandth of a module: small against the curve, large against rounding.
            let step = 1e-3 * basic_data.module();
            let body = pins.kind.unwrap_or_default();
            let over = |base| thickness::over_from_base(basic_data, body, pins.pin_mm, base);
            self.over_pins_um * 2.0 * step / (over(base + step) - over(base - step))
        } else if stated.base_thickness_mm.is_some() {
            self.allowance_um
        } else {
            self.allowance_um * thickness::per_normal_thickness(basic_data)
        };
        um * 1e-3
    }
}
