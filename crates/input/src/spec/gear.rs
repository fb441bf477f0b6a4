//! One gear by its data.

use super::flanks::{PitchSpec, RunoutSpec};
use super::lead::{LeadSpec, SpurSlopeSpec};
use super::profile::ProfileSpec;
use super::rules::{
    above_zero, at_least, at_most_one, exactly_one, length, no_default, whole, within,
};
use super::thickness::ThicknessSpec;
use super::value::each_value;
use gearlash::gauge::Settings;
use gearlash::gear::{BasicRack, Face, GRADES, Hand};
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Serialize};
use serde_with::skip_serializing_none;

/// A gear: its drawing, and what was measured on it.
#[skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = gear_keys)]
pub struct GearSpec {
    /// Number of teeth z.
    #[schemars(transform = whole(3, 10_000))]
    pub teeth: u32,
    /// Module m; m_n of a helical gear.
    #[serde(default)]
    #[schemars(transform = within(0.01, 1000.0))]
    pub module_mm: f64,
    /// Diametral pitch, teeth per inch, in place of module_mm.
    // The echo has module_mm, and a transverse system as the normal one.
    #[schemars(transform = within(0.0254, 2540.0))]
    pub diametral_pitch: Option<f64>,
    /// Pressure angle α; α_n of a helical gear.
    #[schemars(transform = within(5.0, 45.0))]
    pub pressure_angle_deg: f64,
    /// Section in which module, pressure angle, profile shift, rack and allowance_um are stated.
    #[schemars(extend("default" = "normal"))]
    pub system: Option<System>,
    /// Helix angle β at the reference circle; none: a spur gear.
    #[schemars(transform = within(0.0, 60.0))]
    pub helix_angle_deg: Option<f64>,
    /// Hand of helical teeth, "left" or "right"; the mate has the other.
    pub hand: Option<Hand>,
    /// Both ends of the teeth, away from the viewer from the plane in which tooth 1, pitch and runout are stated.
    #[schemars(transform = within(-1e6, 1e6))]
    pub face_mm: Option<[f64; 2]>,
    /// Face width, centred on the measuring plane; in place of face_mm.
    // The echo has face_mm.
    #[schemars(transform = length())]
    pub face_width_mm: Option<f64>,
    /// Profile shift coefficient x.
    #[serde(default)]
    #[schemars(transform = within(-100.0, 100.0))]
    pub profile_shift: f64,
    /// Required accuracy grade, ISO 1328-1, shown in the report.
    #[schemars(transform = whole(*GRADES.start(), *GRADES.end()))]
    pub grade: Option<u32>,
    /// Side of the face on which teeth are numbered clockwise: "front", towards you, or "back". Gears face to face have one of each: consecutive numbers mate.
    #[serde(default)]
    pub reference_face: Face,
    /// Tip diameter d_a; default from addendum and profile shift.
    #[serde(default)]
    #[schemars(transform = length())]
    pub tip_diameter_mm: f64,
    /// Multiplies every length and deviation, as shrinkage does; default: 1. The gears may differ by 2 %.
    #[schemars(transform = within(0.5, 2.0))]
    pub scale: Option<f64>,
    /// Thermal expansion: 11.5e-6 of steel; with assembly.temperature_c.
    #[schemars(transform = within(0.0, 3e-4))]
    pub expansion_per_k: Option<f64>,
    /// Basic rack, in modules; default: ISO 53, profile A.
    #[serde(default)]
    pub rack: RackSpec,
    /// Mean tooth thickness: one statement; none: nominal. Least and greatest make two runs, at least and at most material.
    #[serde(default)]
    pub thickness: ThicknessSpec,
    /// Radial runout; none: 0.
    #[serde(default)]
    pub runout: RunoutSpec,
    /// Pitch deviation of both flanks at the reference circle, one value a tooth.
    pub pitch: Option<PitchSpec>,
    /// Deviations of the profiles from the involute, plus = more material; what is given adds up.
    pub profile: Option<ProfileSpec>,
    /// Lead deviations, plus = more material; heights count from the reference face's end of the teeth.
    pub lead: Option<LeadSpec>,
}

impl GearSpec {
    /// Evaluation range of the profiles of right and left flanks, radii, mm, where it is given.
    pub fn evaluation_radii(&self) -> [Option<[f64; 2]>; 2] {
        let Some(profile) = &self.profile else {
            return [None; 2];
        };
        profile.flanks().map(|flank| {
            let range = flank.range_mm?;
            Some(range.map(|diameter| self.scale() * diameter / 2.0))
        })
    }

    /// Factor of its lengths and deviations.
    pub fn scale(&self) -> f64 {
        self.scale.unwrap_or(1.0)
    }

    /// Both ends of the teeth, mm from the measuring plane, where they are stated.
    pub fn face(&self) -> Option<[f64; 2]> {
        Some(self.face_mm?.map(|end| self.scale() * end))
    }

    /// The choices of a gauge: those `given`, and what the gear states where they leave a choice.
    pub fn gauge_settings(&self, given: Settings) -> Settings {
        let range = self.lead.as_ref().and_then(|lead| lead.range_mm);
        Settings {
            span_teeth: given.span_teeth.or(self.thickness.span_teeth()),
            pin: given.pin.or(self.thickness.pin_mm()),
            ball: given.ball.or(self.runout.ball_mm),
            face: self.face().unwrap_or_default(),
            evaluation: self.evaluation_radii(),
            lead_range: range.map(|range| range.map(|height| self.scale() * height)),
            ..given
        }
    }

    /// Both ends of the teeth as stated, mm over the measuring plane away from the reference face, that of the reference face first.
    pub fn heights(&self) -> Option<[f64; 2]> {
        Some(self.reference_face.heights(self.face_mm?))
    }

    /// The gear with every length and deviation multiplied by its factor.
    pub(crate) fn scaled(&self) -> Result<GearSpec, serde_json::Error> {
        let mut gear = serde_json::to_value(self)?;
        each_value(&mut gear, ("", ""), &mut |_, unit, value| {
            if !["mm", "um"].contains(&unit) {
                return;
            }
            let slope = value.as_str().map(SpurSlopeSpec::of_text);
            if let Some(number) = value.as_f64() {
                *value = (self.scale() * number).into();
            } else if let Some((um, hand)) = slope.and_then(|slope| slope.parsed()) {
                *value = serde_json::json!(SpurSlopeSpec::new(self.scale() * um, hand));
            }
        });
        gear["scale"].take();
        serde_json::from_value(gear)
    }

    /// Whether its teeth wind about its axis.
    pub fn is_helical(&self) -> bool {
        self.helix_angle_deg.is_some()
    }
}

/// One key for the module, at most one for the face. Module and tip diameter show no default: their 0 means absent.
fn gear_keys(schema: &mut Schema) {
    exactly_one(schema, &[&["module_mm"], &["diametral_pitch"]]);
    at_most_one(schema, &[&["face_mm"], &["face_width_mm"]]);
    no_default(schema, "tip_diameter_mm");
    no_default(schema, "module_mm");
}

/// The section of a helical gear in which its basic data are stated.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum System {
    /// Normal to the teeth.
    Normal,
    /// Normal to the axis.
    Transverse,
}

/// Basic rack, in modules.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
#[schemars(transform = above_zero(10.0))]
pub struct RackSpec {
    /// Addendum h_aP*.
    pub addendum: f64,
    /// Dedendum h_fP*.
    pub dedendum: f64,
    /// Root radius ρ_fP*; ≤ 0.317 at 25°.
    #[schemars(transform = at_least(0.0))]
    pub root_radius: f64,
}

/// ISO 53, profile A.
impl Default for RackSpec {
    fn default() -> RackSpec {
        RackSpec::from(&BasicRack::ISO_53_A)
    }
}

impl From<&BasicRack> for RackSpec {
    fn from(rack: &BasicRack) -> RackSpec {
        RackSpec {
            addendum: rack.addendum(),
            dedendum: rack.dedendum(),
            root_radius: rack.root_radius(),
        }
    }
}
