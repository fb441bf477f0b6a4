//! Closed loops of exact segments from a drawing: DXF, SVG, or a list of points.
//!
//! Each format becomes pieces in mm (`dxf`, `svg`, `csv`); `chain` joins their ends into loops. Lines, arcs and cubic
//! curves stay exact; what has no such form (an ellipse, a rational spline) becomes cubic curves with a bound that is derived,
//! never sampled. No unit is guessed, nothing is closed that was drawn open, and what is left out is said.

mod bspline;
mod chain;
mod csv;
mod curve;
mod dxf;
mod error;
mod piece;
mod pieces;
mod smooth;
mod svg;
mod text;
mod unit;

pub use error::DrawingError;
use gearlash::outline::PathSegment;
use pieces::Pieces;
use std::path::Path;
pub use unit::Unit;

/// Ends of drawn lines nearer than this are one point, mm. Tuned: drawings print six decimals of an inch (0.03 µm) and round twice,
/// and no gear has a straight edge of 1 µm that matters.
pub const JOIN_MM: f64 = 0.001;
/// Gaps up to this are rounding of the same point, mm: a coordinate of `FARTHEST_MM` is known to 1.2e-10 mm.
const SAME_MM: f64 = 1e-9;
/// Coordinates and radii beyond this are no gear's, mm: a kilometre.
const FARTHEST_MM: f64 = 1e6;
/// What has no exact form is followed as near as this, mm: 0.01 µm, a tenth of the finest outline that makes sense to write. Tuned:
/// a tenth of it takes twice the curves.
const FIT_MM: f64 = 1e-5;
/// Bytes of a drawing: a text file of a million segments.
const MOST_BYTES: usize = 64 << 20;
/// Segments of a drawing: some thousand for each tooth of the largest gears.
const MOST_SEGMENTS: usize = 1_000_000;
/// Names that a message lists.
const MOST_NAMED: usize = 10;

/// How a drawing is read.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Length of one unit of the drawing; needed where the file states none.
    pub unit: Option<Unit>,
    /// What to read: a layer of a DXF, the id of an element of an SVG; `None`: all.
    pub select: Option<String>,
    /// Ends nearer than this are one point, mm.
    pub join_mm: f64,
    /// A list of points is joined by a cubic spline with continuous curvature, not by straight lines.
    pub smooth: bool,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            unit: None,
            select: None,
            join_mm: JOIN_MM,
            smooth: false,
        }
    }
}

/// A closed path.
#[derive(Debug, Clone, PartialEq)]
pub struct Loop {
    /// Each starts where the one before ends, the first where the last ends, to 1e-9 mm; in any direction.
    pub segments: Vec<PathSegment>,
    /// Layer or id; empty without one.
    pub name: String,
    /// How far the segments may lie from what was drawn, mm: curves that were fitted, gaps that were closed.
    pub bound_mm: f64,
    /// Where in the file it begins.
    pub place: String,
}

/// What a file draws.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// Length of one of its units, mm.
    pub unit_mm: f64,
    /// At least one, in the order of the file.
    pub loops: Vec<Loop>,
    /// What was left out, and why.
    pub remarks: Vec<String>,
}

/// Reads the drawing `bytes`; the ending of `name` decides its format.
///
/// x points right and y up, the origin is the drawing's own; in an SVG, whose y points down, y is turned round so that the drawing
/// looks the same.
///
/// # Errors
/// [`DrawingError`], each with its place and the way out.
pub fn read(name: &Path, bytes: &[u8], options: &Options) -> Result<Drawing, DrawingError> {
    if bytes.len() > MOST_BYTES {
        return Err(DrawingError::TooLarge {
            what: "bytes",
            most: MOST_BYTES,
        });
    }
    let mut pieces = Pieces::default();
    let ending = name.extension().and_then(|ending| ending.to_str());
    match ending.map(str::to_ascii_lowercase).as_deref() {
        Some("dxf") => dxf::read(bytes, options, &mut pieces)?,
        Some("svg") => svg::read(bytes, options, &mut pieces)?,
        Some("csv") => csv::read(bytes, options, &mut pieces)?,
        _ => return Err(DrawingError::Ending(name.to_owned())),
    }
    pieces.drawing(options)
}
