//! `[tolerance]`: scatter of the numbers of a pair from one assembly to the next.

use super::rules::{above_zero, deviation, exactly_one, list_length, not_beside, whole, within};
use super::value::{Either, one_or_list};
use gearlash::gear::GRADES;
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Deserializer, Serialize};
use serde_with::skip_serializing_none;

/// Scatter from one assembly to the next, for gearlash tolerance.
#[skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct ToleranceSpec {
    /// Assemblies that are drawn.
    #[schemars(transform = whole(1, 1_000_000_000))]
    pub assemblies: u32,
    /// Another seed, other assemblies.
    #[schemars(transform = whole(0, u32::MAX))]
    pub seed: u32,
    /// How many of a million assemblies may miss the requirement; exit code 1 where more do.
    #[schemars(transform = within(0.0, 1e6))]
    pub max_ppm: Option<f64>,
    /// Allowed share of draws that give no gear, as with pointed teeth; above it there is no result.
    #[schemars(transform = within(0.0, 1.0))]
    pub max_impossible: f64,
    /// Rows of the samples for the contributions; 0: no contributions.
    #[schemars(transform = whole(0, 10_000_000))]
    pub contribution_rows: u32,
    /// Amount by which the centre distance is greater than stated.
    pub center_distance: Option<ScatterSpec>,
    /// Radial play of both bearings together, in place of the assembly's.
    pub bearing_play: Option<ScatterSpec>,
    /// How the gears are put together, where numbers of teeth have a common divisor.
    pub phase: PhaseName,
    /// Correlation of both thicknesses; 1: both gears from one batch.
    #[schemars(transform = within(-1.0, 1.0))]
    pub thickness_correlation: f64,
    /// How the wheel scatters.
    pub wheel: Option<GearToleranceSpec>,
    /// How the pinion scatters: the same keys.
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
            bearing_play: None,
            phase: PhaseName::Any,
            thickness_correlation: 0.0,
            wheel: None,
            pinion: None,
        }
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
    /// Amount by which all teeth are thicker than stated (than the middle of a band), at the reference circle.
    pub thickness: Option<ScatterSpec>,
    /// Runout F_r in place of the gear's; its direction is any.
    pub runout: Option<ScatterSpec>,
    /// Single pitch deviations of every tooth, on top of the gear's.
    pub pitch: Option<PitchScatterSpec>,
    /// Amount by which each tooth is thicker, on top of the gear's.
    pub per_tooth: Option<ScatterSpec>,
    /// Measured gears, one of which is drawn: gear files or pair files, by name; * stands for any letters of a file's name.
    #[serde(default, deserialize_with = "names")]
    #[schemars(with = "Option<Either<String, Vec<String>>>", transform = list_length(1, None))]
    pub gears: Option<Vec<String>>,
}

/// How a length scatters, µm.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub struct ScatterSpec {
    /// The distribution, and with it the keys: fixed: value_um; uniform: lower_um, upper_um; triangular: and mode_um; normal: sigma_um and mean_um, or lower_um, upper_um, mean_um and cpk; rayleigh: scale_um or upper_um; table: values_um. Limits that the pair file states as a band may be left out.
    pub scatter: ScatterName,
    /// Lower limit, µm.
    #[schemars(transform = deviation())]
    pub lower_um: Option<f64>,
    /// Upper limit, µm; of a rayleigh one that 99.73 % lie below.
    #[schemars(transform = deviation())]
    pub upper_um: Option<f64>,
    /// Mean of a normal one, µm; default: the middle of the limits, or 0.
    #[schemars(transform = deviation())]
    pub mean_um: Option<f64>,
    /// Standard deviation of a normal one, µm.
    #[schemars(transform = above_zero(1e7))]
    pub sigma_um: Option<f64>,
    /// Process capability of a normal one between its limits; default: 1.
    #[schemars(transform = above_zero(100.0))]
    pub cpk: Option<f64>,
    /// The most frequent of a triangular one, µm; default: the middle of the limits.
    #[schemars(transform = deviation())]
    pub mode_um: Option<f64>,
    /// Scale of a rayleigh one, µm: the standard deviation of either component.
    #[schemars(transform = above_zero(1e7))]
    pub scale_um: Option<f64>,
    /// Value of a fixed one, µm.
    #[schemars(transform = deviation())]
    pub value_um: Option<f64>,
    /// Values of a table, µm, drawn with replacement.
    #[schemars(transform = deviation(), transform = list_length(1, None))]
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
    /// Standard deviation of the single pitch deviation f_p, µm.
    #[schemars(transform = above_zero(1e7))]
    pub sigma_um: Option<f64>,
    /// Accuracy grade, ISO 1328-1, whose tolerance of f_p is three standard deviations.
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
        &["thickness", "runout", "pitch", "per_tooth"],
    );
}

fn pitch_keys(schema: &mut Schema) {
    exactly_one(schema, &[&["sigma_um"], &["grade"]]);
}
