//! Values that can be written in more than one way.

use super::rules::exactly_one;
use gearlash::metrology::Toleranced;
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;

/// A value with two ways to write it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(inline)]
pub enum Either<A, B> {
    /// The simpler way.
    #[schemars(description = "")]
    One(A),
    /// The other way.
    #[schemars(description = "")]
    Other(B),
}

/// A value, or a list of them.
pub(super) fn one_or_list<'de, D: Deserializer<'de>, T: Deserialize<'de>>(
    from: D,
) -> Result<Vec<T>, D::Error> {
    Ok(match Either::deserialize(from)? {
        Either::One(one) => vec![one],
        Either::Other(list) => list,
    })
}

impl<T> Either<T, Vec<T>> {
    /// One value or a list as a list.
    pub fn as_list(&self) -> &[T] {
        match self {
            Either::One(one) => std::slice::from_ref(one),
            Either::Other(list) => list,
        }
    }
}

/// Least and most material.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub struct BandSpec {
    /// Thinnest.
    #[serde(alias = "lower")]
    pub min: f64,
    /// Thickest.
    #[serde(alias = "upper")]
    pub max: f64,
}

impl Either<f64, BandSpec> {
    /// One value, or the least and the greatest.
    pub(crate) fn toleranced(self) -> Toleranced<f64> {
        match self {
            Either::One(value) => Toleranced::Single(value),
            Either::Other(BandSpec { min, max }) => Toleranced::Band {
                least: min,
                most: max,
            },
        }
    }
}

/// Least and most material, or upper and lower allowance as a drawing writes them.
#[derive(Debug, JsonSchema)]
#[schemars(inline, transform = allowance_keys)]
pub struct AllowanceBandSpec {
    /// Thinnest.
    pub min: Option<f64>,
    /// Thickest.
    pub max: Option<f64>,
    /// Thickest.
    pub upper: Option<f64>,
    /// Thinnest.
    pub lower: Option<f64>,
}

fn allowance_keys(schema: &mut Schema) {
    exactly_one(schema, &[&["min", "max"], &["upper", "lower"]]);
}

/// Hands each number and text in `value` to `take`, with its dotted path and the unit of its key or of one above.
///
/// Both flanks of a pitch, both ends of a range and all numbers of a distribution have one path.
pub(crate) fn each_value(
    value: &mut Value,
    (path, unit): (&str, &str),
    take: &mut dyn FnMut(&str, &str, &mut Value),
) {
    match value {
        Value::Object(table) => {
            let is_scatter = table.contains_key("scatter");
            for (name, value) in table {
                let parts = ["right_um", "left_um", "min", "max"];
                let path = if is_scatter || parts.contains(&name.as_str()) {
                    path.to_owned()
                } else {
                    format!("{path}.{name}")
                };
                let own = name.rsplit('_').next();
                let own = own.filter(|own| ["um", "mm", "deg", "c"].contains(own));
                each_value(value, (&path, own.unwrap_or(unit)), take);
            }
        }
        Value::Array(list) => {
            for value in list {
                each_value(value, (path, unit), take);
            }
        }
        Value::Number(_) | Value::String(_) => take(path, unit, value),
        Value::Null | Value::Bool(_) => {}
    }
}
