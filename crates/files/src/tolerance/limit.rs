//! Limits of other quantities than `j_wt`, in the units of results.

use crate::numbers::{rounded, shortest, unit_of};
use gearlash::population::Requirement;
use serde::Serialize;

/// A quantity that is limited, with its limits in its unit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Limit {
    /// Name, such as `j_bn`.
    pub quantity: String,
    /// Its unit.
    pub unit: String,
    /// No less than this.
    pub min: Option<f64>,
    /// No more than this.
    pub max: Option<f64>,
}

/// The limits of `requirement` on other quantities than `j_wt`.
pub fn limits(requirement: &Requirement) -> Vec<Limit> {
    let each = requirement.others().map(|(quantity, limits)| {
        let (name, unit, per, _) = unit_of(quantity);
        let in_unit = |value: Option<f64>| value.map(|value| rounded(value * per, 9));
        Limit {
            quantity: name.to_owned(),
            unit: unit.to_owned(),
            min: in_unit(limits.min),
            max: in_unit(limits.max),
        }
    });
    each.collect()
}

/// The required ends (`is_max`: the upper ones), such as "40 µm", "40 µm or j_bn 38 µm", "radial clearance 0.3 mm"; `None`
/// without any. `j_wt` is in mm.
pub fn in_words(j_wt: Option<f64>, others: &[Limit], is_max: bool) -> Option<String> {
    let own = j_wt.map(|mm| format!("{} µm", shortest(rounded(1e3 * mm, 6))));
    let others = others.iter().filter_map(|limit| {
        let value = if is_max { limit.max } else { limit.min }?;
        Some(format!(
            "{} {} {}",
            limit.quantity,
            shortest(value),
            limit.unit
        ))
    });
    let each: Vec<String> = own.into_iter().chain(others).collect();
    (!each.is_empty()).then(|| each.join(" or "))
}
