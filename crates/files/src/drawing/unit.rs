//! The unit of a drawing, which is stated and never guessed.

use super::DrawingError;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
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

    /// The one called `name`, as in a pair file or as tables write it.
    pub(super) fn named(name: &str) -> Option<Unit> {
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

/// Length of a unit of the drawing, mm: what the file states (in words, and mm), else what was given.
pub fn settled(
    stated: Option<(String, f64)>,
    given: Option<Unit>,
    why_not: &str,
) -> Result<f64, DrawingError> {
    match (stated, given) {
        // Printed with at least six digits by every program.
        (Some((words, mm)), Some(given)) if (mm / given.mm() - 1.0).abs() > 1e-6 => {
            Err(DrawingError::OtherUnit {
                stated: words,
                given,
            })
        }
        (_, Some(given)) => Ok(given.mm()),
        (Some((_, mm)), None) => Ok(mm),
        (None, None) => Err(DrawingError::NoUnit {
            why: why_not.to_owned(),
        }),
    }
}
