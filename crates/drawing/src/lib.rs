//! Closed loops of exact segments from a drawing: DXF, SVG, or a list of points; and the outline of a gear as such a file.
//!
//! Each format becomes pieces in mm (`dxf`, `svg`, `csv`); `chain` joins their ends into loops. Lines, arcs and cubic curves stay
//! exact. Ellipses and rational splines become cubic curves; their bound is derived, never sampled. No unit is guessed and no
//! open path is closed beyond `join_mm`. Ignored elements are reported.

mod affine;
mod bspline;
mod chain;
mod csv;
mod curve;
mod dxf;
mod error;
mod limits;
mod options;
mod outline_file;
mod pieces;
mod repeat;
mod svg;
mod text;

pub use chain::DrawnPath;
pub use error::DrawingError;
pub use limits::JOIN_MM;
use limits::MAX_BYTES;
pub use options::{Options, Unit};
pub use outline_file::{OutlineFile, OutlineFormat};
pub use pieces::Drawing;
use pieces::Pieces;
pub use repeat::Repeat;
use std::path::Path;

/// A kind of drawing, by the ending of its name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Format {
    /// AutoCAD's exchange format, ASCII.
    Dxf,
    /// Scalable vector graphics.
    Svg,
    /// A list of points.
    Points,
}

impl Format {
    /// The kind of the file `name`; `None`: no drawing.
    pub fn of(name: &Path) -> Option<Format> {
        let ending = name.extension()?.to_str()?.to_ascii_lowercase();
        match &ending[..] {
            // A DWG is refused by its first bytes, with a remedy.
            "dxf" | "dwg" => Some(Format::Dxf),
            "svg" => Some(Format::Svg),
            "csv" | "txt" | "xyz" => Some(Format::Points),
            _ => None,
        }
    }
}

/// Reads the drawing `bytes`; the ending of `name` decides its format.
///
/// x points right and y up, the origin is the drawing's own; in an SVG, whose y points down, y is reversed so that the drawing
/// looks the same.
///
/// # Errors
/// [`DrawingError`], each with its place and a remedy.
pub fn read(name: &Path, bytes: &[u8], options: &Options) -> Result<Drawing, DrawingError> {
    if bytes.len() > MAX_BYTES {
        return Err(DrawingError::too_large("bytes", MAX_BYTES));
    }
    let mut pieces = Pieces::default();
    match Format::of(name) {
        Some(Format::Dxf) => dxf::read(bytes, options, &mut pieces)?,
        Some(Format::Svg) => svg::read(bytes, options, &mut pieces)?,
        Some(Format::Points) => csv::read(bytes, options, &mut pieces)?,
        None => {
            let reason =
                "unknown kind of drawing, expected a name that ends in .dxf, .svg, .csv or .txt";
            let help = "export the outline as DXF, SVG or CSV";
            return Err(DrawingError::at(name.display(), reason, help));
        }
    }
    pieces.drawing(options)
}
