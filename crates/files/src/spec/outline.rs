//! A gear by its outline: the drawing, and how to read it.

use super::rules::{whole, within};
use super::value::Either;
use super::{FaceName, RunoutSpec};
use crate::drawing::Unit;
use crate::limits::{FIRST_TOOTH, JOIN, TEETH};
use schemars::JsonSchema;
use serde::Serialize;

/// A gear by its outline, in place of teeth, module, pressure angle, rack and thickness.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct OutlineGearSpec {
    /// The gear as drawn, in place of all its data but reference_face and runout.
    pub outline: OutlineSpec,
    /// Which face the picture shows; the drawing shows the reference face, on which teeth are numbered clockwise.
    #[schemars(default)]
    pub reference_face: FaceName,
    /// Radial runout; none: 0.
    #[schemars(with = "Option<RunoutSpec>")]
    pub runout: RunoutSpec,
}

/// A drawing of a gear: DXF, SVG, or a list of points.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct OutlineSpec {
    /// A .dxf, .svg, .csv or .txt file (the last two: points x, y in order) beside the pair file.
    pub file: String,
    /// Unit of the drawing, mm, inch, cm, m or um; needed where it states none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub units: Option<Unit>,
    /// The axis in the drawing, mm; "bore": that of the one circle inside; "fit": that of the circle through the tips.
    #[schemars(with = "Option<Either<[f64; 2], CentreName>>")]
    pub center_mm: CentreSpec,
    /// Teeth there should be; none: as many as are found.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = whole(TEETH))]
    pub teeth: Option<u32>,
    /// The layer of a DXF to read; none: all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub layer: Option<String>,
    /// The element of an SVG to read; none: all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub id: Option<String>,
    /// Ends of lines nearer than this are one point, mm.
    #[schemars(with = "Option<f64>", transform = within(&JOIN))]
    pub join_mm: f64,
    /// Direction of tooth 1 in the drawing, degrees counter-clockwise from +x; none: the first at or clockwise of +y.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(transform = within(&FIRST_TOOTH))]
    pub first_tooth_deg: Option<f64>,
    /// Of a list of points: "polygon", or "smooth", a cubic spline through them.
    #[schemars(default)]
    pub kind: PointsKind,
}

/// Where the centre is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum CentreSpec {
    /// In the drawing, mm.
    At([f64; 2]),
    /// To be found.
    Found(CentreName),
}

/// What the centre is found by.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum CentreName {
    /// The one circle inside.
    Bore,
    /// The circle through the tips.
    Fit,
}

/// What stands between the points of a list.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum PointsKind {
    /// Straight lines.
    #[default]
    Polygon,
    /// A cubic spline with continuous curvature.
    Smooth,
}
