//! Positions of the flanks: runout and pitch.

use super::lead::TeethEnd;
use super::rules::{
    at_least, beside, columns, deviation, exactly_one, length, no_default, not_beside, values_need,
    within, without,
};
use gearlash::gear::PitchAxis;
use gearlash::metrology::{EccentricitySource, PitchKind, PitchSense};
use gearlash_tables::TableFileSpec;
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Serialize};
use serde_with::skip_serializing_none;

/// Radial runout.
#[skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = runout_keys, transform = columns("tooth, runout (µm); the first harmonic counts"))]
pub struct RunoutSpec {
    /// Runout F_r, twice the eccentricity.
    #[serde(default = "no_runout")]
    #[schemars(transform = at_least(0.0))]
    pub total_um: Option<f64>,
    /// Tooth that stands farthest out; fractions allowed. Without it the verdict covers every direction; a drawn gear needs it.
    #[schemars(transform = at_least(1.0))]
    pub high_tooth: Option<f64>,
    /// Radial runout in two planes along the axis, in place of total_um: eccentricity and wobble.
    pub planes: Option<[RunoutPlaneSpec; 2]>,
    /// Axial runout of a shoulder that was machined with the teeth: their wobble.
    pub face_runout: Option<FaceRunoutSpec>,
    /// Readings all round from a table.
    #[serde(flatten)]
    pub table: Option<TableFileSpec>,
    /// Place of a reading: its tooth (a fork), or the space after it (a ball).
    pub at: Option<ReadingPlace>,
    /// Ball diameter, for `gauge` too; default: touching at the reference circle.
    #[schemars(transform = length())]
    pub ball_mm: Option<f64>,
}

fn no_runout() -> Option<f64> {
    Some(0.0)
}

impl Default for RunoutSpec {
    fn default() -> RunoutSpec {
        RunoutSpec {
            total_um: no_runout(),
            high_tooth: None,
            planes: None,
            face_runout: None,
            table: None,
            at: None,
            ball_mm: None,
        }
    }
}

impl RunoutSpec {
    /// The runout in the measuring plane, µm, where it is stated there.
    pub fn total(&self) -> f64 {
        self.total_um.unwrap_or(0.0)
    }
}

/// Radial runout in a plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub struct RunoutPlaneSpec {
    /// Its height from the reference face's end of the teeth.
    #[schemars(transform = within(0.0, 1e6))]
    pub from_reference_face_mm: f64,
    /// Runout F_r there.
    #[schemars(transform = at_least(0.0))]
    pub total_um: f64,
    /// Tooth that stands farthest out in this plane.
    #[schemars(transform = at_least(1.0))]
    pub high_tooth: f64,
}

/// Axial runout of a shoulder.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub struct FaceRunoutSpec {
    /// Total reading.
    #[schemars(transform = within(0.0, 1e7))]
    pub um: f64,
    /// Diameter on which it was read.
    #[schemars(transform = length())]
    pub diameter_mm: f64,
    /// Tooth at that end beside which the shoulder stands out farthest.
    #[schemars(transform = at_least(1.0))]
    pub high_tooth: f64,
    /// The way the shoulder looks, and the end of the teeth at which teeth are counted.
    #[schemars(extend("default" = "reference"))]
    pub face: Option<TeethEnd>,
}

/// Where a runout reading belongs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum ReadingPlace {
    /// The tooth of its number.
    Tooth,
    /// The space after it.
    Space,
}

/// Pitch deviation of both flanks, one value a tooth.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = pitch_keys, transform = columns("tooth, left, right (µm)"))]
pub struct PitchSpec {
    /// Kind of the values.
    #[serde(default)]
    pub kind: PitchKind,
    /// "own": values free of eccentricity; "datum": measured about the datum axis (the bore), with it.
    #[serde(default)]
    pub axis: PitchAxis,
    /// Meaning of +: along ascending numbers, or more material.
    #[serde(default)]
    pub sense: PitchSense,
    /// Right flanks, tooth 1 first.
    #[schemars(transform = deviation())]
    pub right_um: Option<Vec<f64>>,
    /// Left flanks, tooth 1 first.
    #[schemars(transform = deviation())]
    pub left_um: Option<Vec<f64>>,
    /// Column of the left flanks, by heading or letter.
    pub left: Option<String>,
    /// Column of the right flanks, by heading or letter.
    pub right: Option<String>,
    /// With axis = "datum" and a runout: which of them counts.
    pub eccentricity: Option<EccentricitySource>,
    /// Both flanks from a table.
    #[serde(flatten)]
    pub table: Option<TableFileSpec>,
}

fn runout_keys(schema: &mut Schema) {
    exactly_one(schema, &[&["total_um"], &["file"], &["planes"]]);
    no_default(schema, "total_um");
    not_beside(schema, "high_tooth", &["file", "planes"]);
    not_beside(schema, "face_runout", &["planes"]);
    beside(schema, "file", &[&["at"]]);
    beside(schema, "at", &[&["file"]]);
}

fn pitch_keys(schema: &mut Schema) {
    no_default(schema, "kind");
    values_need(schema, "right_um", "left_um", "kind");
    values_need(schema, "left_um", "right_um", "kind");
    beside(schema, "file", &[&["kind"]]);
    not_beside(schema, "file", &["right_um", "left_um"]);
    beside(schema, "left", &[&["file"]]);
    beside(schema, "right", &[&["file"]]);
    // Pitch has a column for each flank.
    without(schema, "column");
}
