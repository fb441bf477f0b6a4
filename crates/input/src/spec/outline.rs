//! A gear by its outline: the drawing, and how to read it.

use super::RunoutSpec;
use super::rules::{whole, within};
use super::value::{BandSpec, Either};
use gearlash::gear::Face;
use gearlash_drawing::{JOIN_MM, Unit};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_with::skip_serializing_none;

/// A gear by its outline, in place of teeth, module, pressure angle and rack.
#[skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OutlineGearSpec {
    /// The gear as drawn, in place of all its data but thickness.flank_offset_mm, reference_face, runout and scale.
    pub outline: OutlineSpec,
    /// How the part differs from the drawing.
    pub thickness: Option<OutlineThicknessSpec>,
    /// Which face the picture shows; the drawing shows the reference face, on which teeth are numbered clockwise.
    #[serde(default)]
    pub reference_face: Face,
    /// Radial runout; none: 0.
    #[serde(default)]
    pub runout: RunoutSpec,
    /// Multiplies every length of the drawing, the flank offset and the runout, as shrinkage does; default: 1.
    #[schemars(transform = within(0.5, 2.0))]
    pub scale: Option<f64>,
}

/// How a part differs from its outline.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OutlineThicknessSpec {
    /// How far the outline is moved out along its normal, mm; negative: in, as by a kerf; none: 0.
    #[schemars(transform = within(-100.0, 100.0))]
    pub flank_offset_mm: Option<Either<f64, BandSpec>>,
}

/// A drawing of a gear: DXF, SVG, or a list of points.
#[skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = within(-1e6, 1e6))]
pub struct OutlineSpec {
    /// A .dxf, .svg, .csv or .txt file, the last two with points x, y in order.
    pub file: String,
    /// Unit of the drawing, mm, inch, cm, m or um, where it states none.
    pub units: Option<Unit>,
    /// Axis in the drawing; "bore": of the one circle inside; "fit": of the circle through the tips.
    #[serde(default)]
    #[schemars(with = "Either<[f64; 2], CentreName>")]
    pub center_mm: CentreSpec,
    /// Teeth there should be; none: as found.
    #[schemars(transform = whole(3, 10_000))]
    pub teeth: Option<u32>,
    /// DXF layer to read; none: all.
    pub layer: Option<String>,
    /// SVG element to read; none: all.
    pub id: Option<String>,
    /// A point inside the outline to read; none: the only outline, or the one round the centre.
    #[schemars(with = "Option<[f64; 2]>")]
    pub at_mm: Option<[f64; 2]>,
    /// The outline to read, from 1 in the order of the file; paths inside another do not count.
    #[schemars(transform = whole(1, 10_000))]
    pub number: Option<u32>,
    /// Ends of lines nearer than this are one point.
    #[serde(default = "join_mm")]
    #[schemars(transform = within(0.0, 10.0))]
    pub join_mm: f64,
    /// Direction of tooth 1, counter-clockwise from +x; none: the first at or clockwise of +y.
    #[schemars(transform = within(-360.0, 360.0))]
    pub first_tooth_deg: Option<f64>,
    /// How points are joined: "polygon", or "smooth", a cubic spline.
    #[serde(default)]
    pub kind: PointsKind,
}

/// Position of the centre.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum CentreSpec {
    /// In the drawing, mm.
    At([f64; 2]),
    /// Found in the drawing.
    Found(CentreName),
}

impl Default for CentreSpec {
    fn default() -> CentreSpec {
        CentreSpec::At([0.0; 2])
    }
}

fn join_mm() -> f64 {
    JOIN_MM
}

/// How the centre is found.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum CentreName {
    /// The one circle inside.
    Bore,
    /// The circle through the tips.
    Fit,
}

/// How the points of a list are joined.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum PointsKind {
    /// Straight lines.
    #[default]
    Polygon,
    /// A cubic spline with continuous curvature.
    Smooth,
}
