//! Values that look as if something else were meant: another unit or sign, a mean that is not taken out, the same measurement twice.

use super::finding::{Finding, Quantity, SameKind};
use super::statement::ThicknessStatement;
use super::toleranced::Toleranced;
use crate::gear::BasicGearData;

/// Standard deviations of a list within which its mean must lie. Values about the stated mean thickness have a mean of 0, within
/// their scatter by `√z`; three of them from 0 the whole list lies on one side of it. Tuned: that is how values from the nominal thickness look.
const OFF: f64 = 3.0;
/// The mean of a list, in modules, that no allowance explains: DIN 3967's greatest, a, stays below it from a module of 2 mm on. Tuned.
const MOST_MEAN: f64 = 0.1;
/// Per-tooth thickness that varies about a mean that is large beside its scatter and adds to the one that is stated.
///
/// One value for all teeth is an offset and meant as one; the nominal thickness is what such a list may count from; readings all round
/// hold the list's mean, so it does not add to them.
pub(super) fn off_mean(
    statement: &ThicknessStatement,
    basic_data: &BasicGearData,
    per_tooth_um: &[f64],
) -> Option<Finding> {
    let first = *per_tooth_um.first()?;
    let count = per_tooth_um.len() as f64;
    let mean_um = per_tooth_um.iter().sum::<f64>() / count;
    let module_um = 1000.0 * basic_data.module();
    if mean_um.abs() > MOST_MEAN * module_um {
        return Some(Finding::PerToothMeanTooLarge { mean_um });
    }
    match statement {
        ThicknessStatement::Nominal
        | ThicknessStatement::AllowanceUm(Toleranced::Single(0.0))
        | ThicknessStatement::SpanReadings { .. }
        | ThicknessStatement::PinReadings { .. } => return None,
        _ => {}
    }
    if per_tooth_um.iter().all(|um| *um == first) {
        return None;
    }
    let squares: f64 = per_tooth_um.iter().map(|um| (um - mean_um).powi(2)).sum();
    let scatter_um = (squares / (count - 1.0)).sqrt();
    (mean_um.abs() > OFF * scatter_um).then_some(Finding::PerToothOffMean {
        mean_um,
        scatter_um,
    })
}

/// An allowance that looks as if the other sign were meant.
pub(super) fn of_allowance(statement: &ThicknessStatement) -> Option<Finding> {
    match statement {
        ThicknessStatement::AllowanceUm(um) if *um.most() > 0.0 => {
            Some(Finding::AllowanceThickens { um: *um.most() })
        }
        _ => None,
    }
}

/// By which share the thickness of a shifted tooth may be off half the pitch, either way: a shift of 0.65 at 20°.
const SHIFTED: f64 = 0.3;
/// How much whole lengths of one gear vary, of their mean, at most: a deviation in µm varies as much as it is large. Tuned.
const VARIES: f64 = 0.1;

/// Where the values in µm are all about the number that the whole length has in mm: thicknesses or pitches, not what they deviate by. A
/// list of one value may be an offset.
pub(super) fn looks_like_whole(quantity: Quantity, um: &[f64], whole_mm: f64) -> Option<Finding> {
    let mean_um = um.iter().sum::<f64>() / um.len() as f64;
    let is_alike = |value: &f64| (value - mean_um).abs() < VARIES * mean_um;
    let differ = um.iter().any(|value| *value != um[0]);
    let is_whole = (mean_um - whole_mm).abs() < SHIFTED * whole_mm;
    (differ && is_whole && um.iter().all(is_alike))
        .then_some(Finding::LooksLikeWhole { quantity, mean_um })
}

/// What `cross_check` has in common with the statement that `counts`, where it is the same measurement: it repeats its faults, the
/// pin's or the count of teeth.
pub(super) fn same_kind(
    counts: &ThicknessStatement,
    cross_check: &ThicknessStatement,
) -> Option<Finding> {
    let of = |statement: &ThicknessStatement| match statement {
        // A base thickness may come from any measurement.
        ThicknessStatement::Nominal
        | ThicknessStatement::FlankOffset(_)
        | ThicknessStatement::BaseThickness(_) => None,
        ThicknessStatement::Span { teeth, .. } | ThicknessStatement::SpanReadings { teeth, .. } => {
            Some((SameKind::Span, f64::from(*teeth)))
        }
        ThicknessStatement::OverPins { pin_mm, .. }
        | ThicknessStatement::PinReadings { pin_mm, .. } => Some((SameKind::OverPins, *pin_mm)),
        ThicknessStatement::AllowanceUm(_) | ThicknessStatement::Field(_) => {
            Some((SameKind::Allowance, 0.0))
        }
    };
    let (kind, _) = of(cross_check).filter(|kind| of(counts) == Some(*kind))?;
    Some(Finding::CrossCheckOfSameKind(kind))
}
