//! The half teeth of a gear with profile deviations.
//!
//! The flank of a half tooth ends at the tip and form circle of the involute, where `r_b ξ + δ(ξ) = r_b ξ_0`: its tangents to the
//! base circle have the involute's lengths. Fillet and root land turn with the lower end of the flank.

use super::part::ModifiedFlank;
use super::{ByTooth, DeviationCurve, Gear, Part, PartCurve, ProfilePart};
use crate::error::GearError;
use crate::numeric::bisect;
use std::sync::Arc;

/// The half teeth of one side of a gear.
pub(super) type HalfTeeth = ByTooth<[Part; 4]>;

/// The half teeth of `gear` with deviations.
///
/// # Errors
/// As [`half_tooth`].
pub(super) fn modified(
    gear: &Gear,
    curves: &ByTooth<DeviationCurve>,
) -> Result<HalfTeeth, GearError> {
    curves.try_map(|curve| half_tooth(gear, curve.clone()))
}

/// The half teeth of `gear` with the deviations of `halves` multiplied by `factor`.
///
/// # Errors
/// As [`half_tooth`].
pub(super) fn exaggerated(
    halves: &HalfTeeth,
    gear: &Gear,
    factor: f64,
) -> Result<HalfTeeth, GearError> {
    halves.try_map(
        |parts| match parts[ProfilePart::Involute as usize].curve.deviation() {
            Some(deviation) => half_tooth(gear, deviation.scaled(factor)),
            None => Ok(gear.parts().clone()),
        },
    )
}

/// The half tooth of `gear` with a deviation.
///
/// # Errors
/// [`GearError::Profile`] if the flank is irregular or leaves no tip land.
fn half_tooth(gear: &Gear, deviation: DeviationCurve) -> Result<[Part; 4], GearError> {
    let base = gear.base_radius();
    let [tip, form] = [gear.tip_roll(), gear.form_roll()];
    let fault = |what| GearError::Profile { what };
    let folded = "turns back on itself or crosses the base circle";
    let ends = [tip, form].map(|roll| end_at(base, roll, &deviation));
    let [Some(tip_end), Some(form_end)] = ends else {
        return Err(fault(folded));
    };
    if !(form_end < tip_end) {
        return Err(fault(
            "leaves nothing between root form circle and tip circle",
        ));
    }
    let range = [form_end, tip_end];
    let flank = ModifiedFlank::new(base, gear.half_base_angle(), Arc::new(deviation), range);
    let flank = flank.ok_or(fault(folded))?;
    let [mut land, mut side, mut fillet, mut bottom] = gear.parts().clone();
    // Both ends turn by the change of their rolls.
    land.ends[1] += tip - tip_end;
    if land.ends[1] <= 0.0 {
        return Err(fault("leaves the tooth no tip land"));
    }
    let turned = form_end - form;
    side.curve = PartCurve::Modified(flank);
    side.ends = [tip_end, form_end];
    if turned != 0.0 {
        fillet.curve = PartCurve::Trochoid(gear.fillet().turned(turned));
        bottom.ends[0] -= turned;
        bottom.ends[1] = bottom.ends[1].max(bottom.ends[0]);
    }
    Ok([land, side, fillet, bottom])
}

/// The roll nearest to `ξ_0` with `r_b ξ + δ(ξ) = r_b ξ_0`, to the last bit; `None` if there is none on the involute.
///
/// It is exactly `ξ_0` without a deviation there. A steep deviation may have more solutions at a greater distance, so growing steps
/// from `ξ_0` find the first.
pub(super) fn end_at(base: f64, roll: f64, deviation: &DeviationCurve) -> Option<f64> {
    let excess = |xi: f64| base * (xi - roll) + deviation.at(xi);
    let here = excess(roll);
    if here == 0.0 {
        return Some(roll);
    }
    let [least, most] = deviation.bounds(0.0, 2.0 * roll + 1.0)[0];
    // At least the rounding of a roll: the deviation may be smaller.
    let reach = least.abs().max(most.abs()) / base * 1.001 + 4.0 * f64::EPSILON * roll;
    let mut inside = 0.0;
    let mut step = here.abs() / base;
    let beyond = loop {
        let there = (roll - here.signum() * step).max(0.0);
        if excess(there) * here <= 0.0 {
            break there;
        }
        if step > reach || there == 0.0 {
            return None;
        }
        (inside, step) = (step, 2.0 * step);
    };
    let inside = roll - here.signum() * inside;
    let [inside, beyond] = bisect(inside, beyond, 0.0, |xi| excess(xi) * here > 0.0);
    Some(0.5 * (inside + beyond))
}
