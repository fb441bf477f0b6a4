//! Deviations of the flanks from the involute.

use super::rules::{
    beside, columns, deviation, exactly_one, length, list_length, not_beside, whole, within,
    without,
};
use super::value::{Either, FlankSpec, FlanksSpec, TableFileSpec};
use schemars::transform::{RecursiveTransform, Transform};
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Serialize};
use serde_with::skip_serializing_none;

/// Profile deviations, µm, plus = more material.
pub type ProfileSpec = FlanksSpec<FlankProfileSpec>;

/// Profile deviations of a flank, µm, plus = more material; they add.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FlankProfileSpec {
    /// Profile slope f_Hα at the end of the evaluation range, 0 at its start.
    #[schemars(transform = deviation())]
    pub slope_um: Option<f64>,
    /// Profile crowning C_α in the middle of the evaluation range, 0 at its ends; negative: hollow.
    #[schemars(transform = deviation())]
    pub crowning_um: Option<f64>,
    /// Taken off towards the tip.
    pub tip_relief: Option<ReliefSpec>,
    /// Taken off towards the root.
    pub root_relief: Option<ReliefSpec>,
    /// Evaluation range, diameters; default: root form circle to tip circle.
    #[schemars(transform = length(), transform = list_length(2, Some(2)))]
    pub range_mm: Option<Vec<f64>>,
    /// Measured profiles; teeth without one take the mean.
    #[schemars(transform = trace_of(&PROFILE_TRACE))]
    pub trace: Option<Either<TraceSpec, Vec<TraceSpec>>>,
}

/// Material taken off a flank.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ReliefSpec {
    /// Taken off at the tip circle, or at the root form circle.
    #[schemars(transform = within(0.0, 1e7))]
    pub um: f64,
    /// Diameter at which it begins.
    #[schemars(transform = length())]
    pub from_diameter_mm: f64,
    /// Growth with the roll: "linear", with an edge, or "parabolic".
    #[serde(default)]
    pub shape: ReliefShape,
}

/// How a relief grows with the roll.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum ReliefShape {
    /// As a straight line, with an edge where it begins.
    #[default]
    Linear,
    /// As a parabola that leaves the flank smoothly.
    Parabolic,
}

/// A measured curve of a flank: places, and the deviation at each; beyond its ends it stays as it is there.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub struct TraceSpec {
    /// Tooth it was measured on; none: all.
    #[schemars(transform = whole(1, 10_000))]
    pub tooth: Option<u32>,
    /// Roll lengths r_b ξ from the base circle, ascending.
    #[schemars(transform = within(0.0, 1e9), transform = list_length(2, None))]
    pub roll_length_mm: Option<Vec<f64>>,
    /// Diameters in place of roll lengths, ascending.
    #[schemars(transform = length(), transform = list_length(2, None))]
    pub diameter_mm: Option<Vec<f64>>,
    /// Heights, ascending.
    #[schemars(transform = within(0.0, 1e6), transform = list_length(2, None))]
    pub from_reference_face_mm: Option<Vec<f64>>,
    /// Deviation at each.
    #[schemars(transform = deviation(), transform = list_length(2, None))]
    pub deviation_um: Option<Vec<f64>>,
    /// In the transverse section, or normal to the teeth.
    #[schemars(extend("default" = "transverse"))]
    pub direction: Option<TraceDirection>,
    /// Traces from a table.
    #[serde(flatten)]
    pub table: Option<TableFileSpec>,
}

/// The direction in which deviations of a trace count.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum TraceDirection {
    /// Along the base tangent of the transverse section.
    Transverse,
    /// Normal to the teeth.
    Normal,
}

impl FlankProfileSpec {
    /// The traces.
    pub fn traces(&self) -> &[TraceSpec] {
        self.trace.as_ref().map_or(&[], Either::as_list)
    }
}

impl FlankSpec for FlankProfileSpec {
    fn or(self, both: FlankProfileSpec) -> FlankProfileSpec {
        FlankProfileSpec {
            slope_um: self.slope_um.or(both.slope_um),
            crowning_um: self.crowning_um.or(both.crowning_um),
            tip_relief: self.tip_relief.or(both.tip_relief),
            root_relief: self.root_relief.or(both.root_relief),
            range_mm: self.range_mm.or(both.range_mm),
            trace: self.trace.or(both.trace),
        }
    }

    fn trace(&mut self) -> &mut Option<Either<TraceSpec, Vec<TraceSpec>>> {
        &mut self.trace
    }
}

/// The keys of a trace along one direction of a flank.
pub(super) struct TraceKeys {
    description: &'static str,
    /// Keys for the places of its points, one of which is given.
    places: &'static [&'static str],
    columns: &'static str,
    /// Keys of the other direction.
    others: &'static [&'static str],
}

const PROFILE_TRACE: TraceKeys = TraceKeys {
    description: "A measured profile: where, and the deviation there; beyond its ends it stays as it is there.",
    places: &["roll_length_mm", "diameter_mm"],
    columns: "roll_length_mm or diameter_mm, deviation_um; tooth, flank where needed",
    others: &["from_reference_face_mm", "direction"],
};

pub(super) const LEAD_TRACE: TraceKeys = TraceKeys {
    description: "A measured lead: heights, and the deviation at each; beyond its ends it stays as it is there.",
    places: &["from_reference_face_mm"],
    columns: "from_reference_face_mm, deviation_um; tooth, flank where needed",
    others: &["roll_length_mm", "diameter_mm"],
};

/// Every trace of the value has the keys `of` its direction. Its points stand in one list of places beside their deviations, or
/// in a file.
pub(super) fn trace_of(of: &'static TraceKeys) -> impl Fn(&mut Schema) {
    let trace = |schema: &mut Schema| {
        if schema.pointer("/properties/deviation_um").is_none() {
            return;
        }
        schema.insert("description".to_owned(), of.description.into());
        of.others.iter().for_each(|key| without(schema, key));
        let lists: Vec<[&str; 1]> = of
            .places
            .iter()
            .chain([&"file"])
            .map(|key| [*key])
            .collect();
        let groups: Vec<&[&str]> = lists.iter().map(|keys| &keys[..]).collect();
        exactly_one(schema, &groups);
        for place in of.places {
            beside(schema, place, &[&["deviation_um"]]);
        }
        not_beside(schema, "file", &["deviation_um"]);
        columns(of.columns)(schema);
    };
    move |schema| RecursiveTransform(trace).transform(schema)
}
