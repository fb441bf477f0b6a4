//! `[tolerance]`: scatter of the numbers of a pair from one assembly to the next.

use super::rules::{above_zero, deviation, exactly_one, list_length, not_beside, whole, within};
use super::value::{Either, one_or_list};
use gearlash::gear::GRADES;
use gearlash::pair::Member;
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Deserializer, Serialize};
use serde_with::skip_serializing_none;

/// Most assemblies of a run.
pub const MAX_ASSEMBLIES: u64 = 1_000_000_000;

/// Scatter of assemblies, for gearlash tolerance.
#[skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ToleranceSpec {
    /// Assemblies drawn.
    #[schemars(transform = whole(1, MAX_ASSEMBLIES as u32))]
    pub assemblies: u32,
    /// Seed of the draws.
    #[schemars(transform = whole(0, u32::MAX))]
    pub seed: u32,
    /// Assemblies of a million that may miss the requirement; exit code 1 where more do.
    #[schemars(transform = within(0.0, 1e6))]
    pub max_ppm: Option<f64>,
    /// Allowed share of draws that give no gear, as with pointed teeth.
    #[schemars(transform = within(0.0, 1.0))]
    pub max_impossible: f64,
    /// Rows for the contributions, capped by assemblies; 0: none.
    #[schemars(transform = whole(0, 10_000_000))]
    pub contribution_rows: u32,
    /// Amount beyond the stated centre distance.
    pub center_distance: Option<ScatterSpec>,
    /// On top of the assembly's, over its over_mm.
    pub misalignment: Option<AxesScatterSpec>,
    /// Radial play of both bearings together, in place of the assembly's.
    pub bearing_play: Option<ScatterSpec>,
    /// Assembly phase: "any", or "marked", that of the start of the sweep, or of tooth 1 with tooth 1.
    pub phase: PhaseName,
    /// Correlation of both thicknesses; 1: both gears from one batch.
    #[schemars(transform = within(-1.0, 1.0))]
    pub thickness_correlation: f64,
    /// How the wheel scatters.
    pub wheel: Option<GearToleranceSpec>,
    /// How the pinion scatters.
    pub pinion: Option<GearToleranceSpec>,
}

impl Default for ToleranceSpec {
    fn default() -> ToleranceSpec {
        ToleranceSpec {
            assemblies: 100_000,
            seed: 1,
            max_ppm: None,
            max_impossible: 0.001,
            contribution_rows: 2048,
            center_distance: None,
            misalignment: None,
            bearing_play: None,
            phase: PhaseName::Any,
            thickness_correlation: 0.0,
            wheel: None,
            pinion: None,
        }
    }
}

impl ToleranceSpec {
    /// How a gear scatters.
    pub fn gear(&self, member: Member) -> Option<&GearToleranceSpec> {
        [&self.wheel, &self.pinion][member as usize].as_ref()
    }
}

/// Which assembly phases are drawn.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum PhaseName {
    /// Any, each as often.
    #[default]
    Any,
    /// The phase of the sweep's start, or wheel tooth 1 with pinion tooth 1.
    Marked,
}

/// Scatter of one gear: each key by itself, or whole gears.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline, transform = gear_keys)]
pub struct GearToleranceSpec {
    /// Amount by which all teeth are thicker than stated (than the middle of a band).
    pub thickness: Option<ScatterSpec>,
    /// Runout F_r in place of the gear's, in any direction.
    pub runout: Option<ScatterSpec>,
    /// Single pitch deviations, on top of the gear's.
    pub pitch: Option<PitchScatterSpec>,
    /// Amount by which each tooth is thicker, on top of the gear's.
    pub per_tooth: Option<ScatterSpec>,
    /// On top of the gear's, right and left flanks separately.
    pub lead: Option<LeadScatterSpec>,
    /// Lean of the teeth's axis over the face, in place of the gear's.
    pub wobble_um: Option<SpreadSpec>,
    /// Gear or pair files of measured gears, one of which is drawn; * stands for any letters.
    #[serde(default, deserialize_with = "names")]
    #[schemars(with = "Option<Either<String, Vec<String>>>", transform = list_length(1, None))]
    pub gears: Option<Vec<String>>,
}

/// How the leads of all teeth of a gear scatter.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub struct LeadScatterSpec {
    /// Growth over the length of lead.over.
    pub slope_um: Option<SpreadSpec>,
    /// Lead crowning C_β.
    pub crowning_um: Option<SpreadSpec>,
}

/// How the axes scatter.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub struct AxesScatterSpec {
    /// f_Σδ, in the plane of the axes.
    pub in_plane_um: Option<SpreadSpec>,
    /// f_Σβ, out of it.
    pub out_of_plane_um: Option<SpreadSpec>,
}

/// A normal distribution about 0; of a wobble that of either component.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline, transform = spread_keys, transform = above_zero(1e7))]
pub struct SpreadSpec {
    /// Standard deviation.
    pub sigma: Option<f64>,
    /// Amount that 99.73 % keep.
    pub max: Option<f64>,
}

/// How a length scatters, µm.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline, transform = deviation())]
pub struct ScatterSpec {
    /// Distribution and its keys: fixed (value_um), uniform (lower_um, upper_um), triangular (also mode_um), normal (sigma_um, mean_um; or limits, mean_um, cpk), rayleigh (scale_um or upper_um), table (values_um). Limits that the pair file states as a band may be left out.
    pub scatter: ScatterName,
    /// Lower limit.
    pub lower_um: Option<f64>,
    /// Upper limit; of rayleigh 99.73 % lie below.
    pub upper_um: Option<f64>,
    /// Mean; default: the middle of the limits, or 0.
    pub mean_um: Option<f64>,
    /// Standard deviation.
    #[schemars(transform = above_zero(1e7))]
    pub sigma_um: Option<f64>,
    /// Process capability between the limits; default: 1.
    #[schemars(transform = above_zero(100.0))]
    pub cpk: Option<f64>,
    /// Most frequent value; default: the middle of the limits.
    pub mode_um: Option<f64>,
    /// Standard deviation of either component.
    #[schemars(transform = above_zero(1e7))]
    pub scale_um: Option<f64>,
    /// The value.
    pub value_um: Option<f64>,
    /// Values, drawn with replacement.
    #[schemars(transform = list_length(1, None))]
    pub values_um: Option<Vec<f64>>,
}

/// A distribution.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum ScatterName {
    /// Always equal.
    Fixed,
    /// Equally often between limits.
    Uniform,
    /// Most often at its mode, never at its limits.
    Triangular,
    /// Normal.
    #[default]
    Normal,
    /// Length of a vector with two normal components, as of an eccentricity.
    Rayleigh,
    /// Measured values.
    Table,
}

/// How single pitch deviations scatter: their standard deviation, or the grade that allows three of them.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline, transform = pitch_keys)]
pub struct PitchScatterSpec {
    /// Standard deviation of f_p.
    #[schemars(transform = above_zero(1e7))]
    pub sigma_um: Option<f64>,
    /// Grade of ISO 1328-1 whose tolerance of f_p is three standard deviations.
    #[schemars(transform = whole(*GRADES.start(), *GRADES.end()))]
    pub grade: Option<u32>,
}

fn names<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Vec<String>>, D::Error> {
    one_or_list(from).map(Some)
}

/// A list of gears excludes the other keys.
fn gear_keys(schema: &mut Schema) {
    not_beside(
        schema,
        "gears",
        &[
            "thickness",
            "runout",
            "pitch",
            "per_tooth",
            "lead",
            "wobble_um",
        ],
    );
}

fn spread_keys(schema: &mut Schema) {
    exactly_one(schema, &[&["sigma"], &["max"]]);
}

fn pitch_keys(schema: &mut Schema) {
    exactly_one(schema, &[&["sigma_um"], &["grade"]]);
}
