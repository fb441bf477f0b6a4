//! `[uncertainty]`: standard uncertainties of the measurements.

use super::rules::{above_zero, within};
use super::{AssemblySpec, GearSpec, ThicknessSpec};
use gearlash::analysis::uncertainty::Uncertainty;
use gearlash::gear::{AsBuilt, thickness};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_with::skip_serializing_none;

/// Standard uncertainties of what was measured, µm; the expanded uncertainty of least and greatest backlash follows.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
#[schemars(transform = within(0.0, 1e6))]
pub struct UncertaintySpec {
    /// A span.
    pub span_um: f64,
    /// A dimension over pins.
    pub over_pins_um: f64,
    /// A thickness stated in any other way.
    pub allowance_um: f64,
    /// A tooth against the others.
    pub per_tooth_um: f64,
    /// The pitch deviation of a flank.
    pub pitch_um: f64,
    /// The runout of each gear.
    pub runout_um: f64,
    /// The centre distance.
    pub center_distance_um: f64,
    /// The lead deviation of a flank where it touches.
    pub lead_um: Option<f64>,
    /// Both deviations of the shafts, over the length of assembly.misalignment.
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

impl UncertaintySpec {
    /// In mm for the library. A gear given by data has its thickness by its statement, and the `amplification` of its spans where these
    /// give each tooth's; `None`: a drawn gear.
    pub(crate) fn of_pair(
        &self,
        assembly: &AssemblySpec,
        gears: [Option<(&GearSpec, &AsBuilt)>; 2],
        amplification: [Option<u32>; 2],
    ) -> Uncertainty {
        let mm = 1e-3;
        let each = |of: &dyn Fn(&GearSpec, &AsBuilt) -> f64| {
            gears.map(|gear| gear.map_or(0.0, |(spec, gear)| of(spec, gear)))
        };
        let base_thickness =
            each(&|spec, gear| spec.scale() * self.base_thickness(&spec.thickness, gear));
        let per_tooth = each(&|_, gear| {
            self.per_tooth_um * mm * thickness::per_normal_thickness(gear.gear().basic_data())
        });
        Uncertainty {
            base_thickness,
            // Random errors of L spans: √L times that of one for a tooth, of which the mean has one.
            per_tooth: std::array::from_fn(|k| {
                let more = f64::from(amplification[k].unwrap_or(1) - 1);
                per_tooth[k].hypot(more.sqrt() * base_thickness[k])
            }),
            pitch: each(&|_, gear| {
                let angle = gear.gear().basic_data().transverse_pressure_angle();
                self.pitch_um * mm * angle.cos()
            }),
            lead: each(&|_, _| self.lead_um.unwrap_or(0.0) * mm),
            runout: self.runout_um * mm,
            center_distance: self.center_distance_um * mm,
            lean: self
                .misalignment_um
                .zip(assembly.over_mm())
                .map_or(0.0, |(um, over)| um * mm / over),
            distance_at: assembly.distance_place_mm(),
            coverage: self.coverage_factor,
        }
    }

    /// The keys stated that concern gears given by data alone.
    pub(crate) fn of_data(&self) -> Vec<String> {
        let others = ["runout_um", "center_distance_um", "coverage_factor"];
        let keys = serde_json::to_value(self).unwrap_or_default();
        let keys = keys.as_object().into_iter().flatten();
        let stated =
            keys.filter(|(key, um)| um.as_f64() > Some(0.0) && !others.contains(&key.as_str()));
        stated.map(|(key, _)| key.clone()).collect()
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
