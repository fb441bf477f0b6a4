//! `[tolerance]`: how the numbers of a pair scatter from one assembly to the next.

use super::rules::{exactly_one, list_length, whole, within};
use super::value::Either;
use crate::limits::{
    ASSEMBLIES, CAPABILITY, CONTRIBUTION_ROWS, CORRELATION, PPM, SCATTER, SEED, SHARE, SPREAD,
};
use gearlash::gear::GRADES;
use schemars::{JsonSchema, Schema};
use serde::Serialize;

/// Assemblies that are drawn where nothing is said.
pub(crate) const DEFAULT_ASSEMBLIES: u32 = 100_000;
/// Rows of the samples that contributions are found from.
pub(crate) const DEFAULT_ROWS: u32 = 2048;
/// The share of assemblies that may be of no gear.
pub(crate) const DEFAULT_IMPOSSIBLE: f64 = 0.001;

/// How the numbers of the pair scatter from one assembly to the next: of gearlash tolerance.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ToleranceSpec {
    /// Assemblies that are drawn.
    #[schemars(with = "Option<u32>", extend("default" = DEFAULT_ASSEMBLIES), transform = whole(ASSEMBLIES))]
    pub assemblies: u32,
    /// Another seed, other assemblies.
    #[schemars(with = "Option<u32>", extend("default" = 1), transform = whole(SEED))]
    pub seed: u32,
    /// How many of a million assemblies may miss the requirement; exit code 1 where more do.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&PPM))]
    pub max_ppm: Option<f64>,
    /// The share of draws that may be of no gear, as with pointed teeth: above it there is no result.
    #[schemars(with = "Option<f64>", extend("default" = DEFAULT_IMPOSSIBLE), transform = within(&SHARE))]
    pub max_impossible: f64,
    /// Rows of the samples that the contributions are found from; 0: none are.
    #[schemars(with = "Option<u32>", extend("default" = DEFAULT_ROWS), transform = whole(CONTRIBUTION_ROWS))]
    pub contribution_rows: u32,
    /// By what the centre distance is greater than stated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub center_distance: Option<ScatterSpec>,
    /// Radial play of both bearings together, in place of the assembly's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bearing_play: Option<ScatterSpec>,
    /// How the gears are put together, where numbers of teeth have a common divisor.
    #[schemars(default)]
    pub phase: PhaseName,
    /// Correlation of both thicknesses; 1: both gears from one batch.
    #[schemars(with = "Option<f64>", extend("default" = 0.0), transform = within(&CORRELATION))]
    pub thickness_correlation: f64,
    /// How the wheel scatters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wheel: Option<GearToleranceSpec>,
    /// How the pinion scatters: the same keys.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pinion: Option<GearToleranceSpec>,
}

/// Which assembly phases are drawn.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum PhaseName {
    /// Any, each as often.
    #[default]
    Any,
    /// That of the sweep's start, or wheel tooth 1 with pinion tooth 1.
    Marked,
}

/// How one gear scatters: each key by itself, or whole gears.
#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
#[schemars(inline)]
pub struct GearToleranceSpec {
    /// By what all teeth are thicker than stated (than the middle of what is stated), at the reference circle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub thickness: Option<ScatterSpec>,
    /// Runout F_r in place of the gear's; its direction is any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub runout: Option<ScatterSpec>,
    /// Single pitch deviations of every tooth, on top of the gear's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch: Option<PitchScatterSpec>,
    /// By what each tooth is thicker, on top of the gear's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub per_tooth: Option<ScatterSpec>,
    /// Measured gears, one of which is drawn: gear files or pair files, by name; * stands for any letters of a file's name.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Either<String, Vec<String>>>", transform = list_length(1, None))]
    pub gears: Option<Vec<String>>,
}

/// How a length scatters, µm.
#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
#[schemars(inline)]
pub struct ScatterSpec {
    /// The distribution, and with it the keys: fixed: value_um; uniform: lower_um, upper_um; triangular: and mode_um; normal: sigma_um and mean_um, or lower_um, upper_um, mean_um and cpk; rayleigh: scale_um or upper_um; table: values_um. Limits that the pair file states as a band may be left out.
    pub scatter: ScatterName,
    /// Lower limit, µm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&SCATTER))]
    pub lower_um: Option<f64>,
    /// Upper limit, µm; of a rayleigh one that 99.73 % lie below.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&SCATTER))]
    pub upper_um: Option<f64>,
    /// Mean of a normal one, µm; default: the middle of the limits, or 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&SCATTER))]
    pub mean_um: Option<f64>,
    /// Standard deviation of a normal one, µm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&SPREAD))]
    pub sigma_um: Option<f64>,
    /// Process capability of a normal one between its limits; default: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&CAPABILITY))]
    pub cpk: Option<f64>,
    /// The most frequent of a triangular one, µm; default: the middle of the limits.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&SCATTER))]
    pub mode_um: Option<f64>,
    /// Scale of a rayleigh one, µm: the standard deviation of either component.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&SPREAD))]
    pub scale_um: Option<f64>,
    /// Value of a fixed one, µm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&SCATTER))]
    pub value_um: Option<f64>,
    /// Values of a table, µm, drawn with replacement.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&SCATTER), transform = list_length(1, None))]
    pub values_um: Option<Vec<f64>>,
}

/// A distribution.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum ScatterName {
    /// Always the same.
    Fixed,
    /// Everywhere between limits alike.
    Uniform,
    /// Most often at its mode, at its limits never.
    Triangular,
    /// Normal.
    #[default]
    Normal,
    /// Length of a vector with two normal components: of an eccentricity.
    Rayleigh,
    /// Measured values.
    Table,
}

/// How single pitch deviations scatter: their standard deviation, or the grade that allows three of them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(inline, transform = pitch_keys)]
pub struct PitchScatterSpec {
    /// Standard deviation of the single pitch deviation f_p, µm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&SPREAD))]
    pub sigma_um: Option<f64>,
    /// Accuracy grade, ISO 1328-1, whose tolerance of f_p is three standard deviations.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = whole(GRADES))]
    pub grade: Option<u32>,
}

fn pitch_keys(schema: &mut Schema) {
    exactly_one(schema, &[&["sigma_um"], &["grade"]]);
}
