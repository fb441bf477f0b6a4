//! Values for both flanks or for each, and the measured traces among them.

use super::rules::{
    beside, columns, deviation, exactly_one, length, list_length, not_beside, whole, within,
    without,
};
use super::value::Either;
use gearlash_tables::TableFileSpec;
use schemars::transform::{RecursiveTransform, Transform};
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Serialize};
use serde_with::skip_serializing_none;

/// Values for both flanks, or for each in a table of its own.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub struct FlanksSpec<F> {
    /// Values for both flanks.
    #[serde(flatten)]
    pub both: F,
    /// Values of right flanks, in place of those of both.
    pub right: Option<F>,
    /// Values of left flanks, in place of those of both.
    pub left: Option<F>,
}

/// Values of one flank.
pub trait FlankSpec: Clone + Default + PartialEq {
    /// These values, and those of `both` flanks in place of absent ones.
    fn or(self, both: Self) -> Self;

    /// Its traces, one or a list.
    fn trace(&mut self) -> &mut Option<Either<TraceSpec, Vec<TraceSpec>>>;
}

impl<F: FlankSpec> FlanksSpec<F> {
    /// The values of right flanks and of left ones: once where they are equal.
    pub fn new([right, left]: [F; 2]) -> FlanksSpec<F> {
        if right == left {
            return FlanksSpec {
                both: right,
                ..FlanksSpec::default()
            };
        }
        FlanksSpec {
            both: F::default(),
            right: Some(right),
            left: Some(left),
        }
    }

    /// The values of right flanks and of left ones, each in a table of its own or for both.
    pub fn flanks(&self) -> [&F; 2] {
        [&self.right, &self.left].map(|own| own.as_ref().unwrap_or(&self.both))
    }
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

/// The keys of a trace along one direction of a flank.
pub(super) struct TraceKeys {
    description: &'static str,
    /// Keys for the places of its points, one of which is given.
    places: &'static [&'static str],
    columns: &'static str,
    /// Keys of the other direction.
    others: &'static [&'static str],
}

pub(super) const PROFILE_TRACE: TraceKeys = TraceKeys {
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

/// Every trace of the value has the keys `of` its direction. Its points are a list of places and a list of deviations, or a
/// file.
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
