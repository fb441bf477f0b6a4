//! How a drawing is read. Its unit is stated and never guessed.

use super::DrawingError;
use super::limits::JOIN_MM;
use super::repeat::Repeat;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt;

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
                let help = "correct `units`, or leave it out";
                Err(DrawingError::new(reason, help))
            }
            (_, Some(given)) => Ok(self.scale * given.mm()),
            (Some((_, mm)), None) => Ok(self.scale * mm),
            (None, None) => {
                let names = Unit::NAMED
                    .map(|(name, _)| format!("\"{name}\""))
                    .join(" | ");
                let reason = format!("the unit is not stated: {why_not}");
                let help = format!("state the length of a unit of the drawing: units = {names}");
                Err(DrawingError {
                    lacks_unit: true,
                    ..DrawingError::new(reason, help)
                })
            }
        }
    }
}

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum Unit {
    /// Millimetre.
    Mm,
    /// Inch, 25.4 mm.
    Inch,
    /// Centimetre.
    Cm,
    /// Metre.
    M,
    /// Micrometre.
    Um,
}

impl Unit {
    /// All, each by its name in a pair file.
    pub const NAMED: [(&'static str, Unit); 5] = [
        ("mm", Unit::Mm),
        ("inch", Unit::Inch),
        ("cm", Unit::Cm),
        ("m", Unit::M),
        ("um", Unit::Um),
    ];

    /// Its length, mm.
    pub fn mm(self) -> f64 {
        match self {
            Unit::Mm => 1.0,
            Unit::Inch => 25.4,
            Unit::Cm => 10.0,
            Unit::M => 1000.0,
            Unit::Um => 0.001,
        }
    }

    /// The unit called `name`, as in a pair file or as tables write it.
    pub(super) fn from_name(name: &str) -> Option<Unit> {
        let name = match name {
            "in" => "inch",
            "µm" | "μm" => "um",
            name => name,
        };
        let mut units = Unit::NAMED.into_iter();
        units.find(|unit| unit.0 == name).map(|unit| unit.1)
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut units = Unit::NAMED.iter();
        f.write_str(units.find(|unit| unit.1 == *self).map_or("", |unit| unit.0))
    }
}
