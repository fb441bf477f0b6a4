//! The unit of a drawing, which is stated and never guessed.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt;

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
