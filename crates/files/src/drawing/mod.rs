//! Closed loops of exact segments from a drawing: DXF, SVG, or a list of points.
//!
//! Each format becomes pieces in mm (`dxf`, `svg`, `csv`); `chain` joins their ends into loops. Lines, arcs and cubic
//! curves stay exact; what has no such form (an ellipse, a rational spline) becomes cubic curves with a bound that is derived,
//! never sampled. No unit is guessed, nothing is closed that was drawn open, and what is left out is said.

mod affine;
mod bspline;
mod chain;
mod csv;
mod curve;
mod dxf;
mod error;
mod limits;
mod options;
mod piece;
mod pieces;
mod repeat;
mod smooth;
mod svg;
mod text;
mod unit;

pub use chain::Loop;
pub use error::DrawingError;
pub use limits::JOIN_MM;
use limits::MOST_BYTES;
pub use options::Options;
pub use pieces::Drawing;
use pieces::Pieces;
pub use repeat::Repeat;
use std::path::Path;
pub use unit::Unit;

/// Reads the drawing `bytes`; the ending of `name` decides its format.
///
/// x points right and y up, the origin is the drawing's own; in an SVG, whose y points down, y is reversed so that the drawing
/// looks the same.
///
/// # Errors
/// [`DrawingError`], each with its place and what helps.
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
        Some("csv" | "txt" | "xyz") => csv::read(bytes, options, &mut pieces)?,
        _ => return Err(DrawingError::Ending(name.to_owned())),
    }
    pieces.drawing(options)
}
