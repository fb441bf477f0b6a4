//! How a drawing is read.

use super::limits::JOIN_MM;
use super::repeat::Repeat;
use super::{DrawingError, Unit};

/// How a drawing is read.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Length of one unit of the drawing; needed where the file states none.
    pub unit: Option<Unit>,
    /// Factor of all lengths.
    pub scale: f64,
    /// The layer of a DXF or the id of an element of an SVG to read; `None`: all.
    pub select: Option<String>,
    /// Ends nearer than this are one point, mm.
    pub join_mm: f64,
    /// How the one drawn tooth is repeated, where the drawing shows one tooth.
    pub repeat: Option<Repeat>,
    /// A list of points is joined by a cubic spline with continuous curvature, not by straight lines.
    pub smooth: bool,
}

impl Default for Options {
    fn default() -> Options {
        Options {
            unit: None,
            scale: 1.0,
            select: None,
            join_mm: JOIN_MM,
            repeat: None,
            smooth: false,
        }
    }
}

impl Options {
    /// Length of a unit of the drawing, mm: as the file states it (in words, and mm), else as given.
    pub(super) fn unit_mm(
        &self,
        stated: Option<(String, f64)>,
        why_not: &str,
    ) -> Result<f64, DrawingError> {
        match (stated, self.unit) {
            // Printed with at least six digits by every program.
            (Some((words, mm)), Some(given)) if (mm / given.mm() - 1.0).abs() > 1e-6 => {
                let reason = format!("the file states {words}, the pair file \"{given}\"");
                Err(DrawingError::new(
                    reason,
                    "correct `units`, or leave it out",
                ))
            }
            (_, Some(given)) => Ok(self.scale * given.mm()),
            (Some((_, mm)), None) => Ok(self.scale * mm),
            (None, None) => {
                let names = Unit::NAMED.map(|(name, _)| format!("\"{name}\""));
                Err(DrawingError::new(
                    format!("the unit is not stated: {why_not}"),
                    format!(
                        "state the length of a unit of the drawing: units = {}",
                        names.join(" | ")
                    ),
                ))
            }
        }
    }
}
