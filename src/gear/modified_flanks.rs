//! The half teeth of a gear with profile deviations.
//!
//! The flank of a half tooth ends at the tip and form circle of the involute, where `r_b ξ + δ(ξ) = r_b ξ_0`: its tangents to the
//! base circle have the involute's lengths. Fillet and root land turn with the lower end of the flank.

use super::part::ModifiedFlank;
use super::{DeviationCurve, Gear, Part, PartCurve, ProfilePart};
use crate::error::GearError;
use crate::numeric::bisect;
use std::collections::HashMap;
use std::sync::Arc;

/// The half teeth of one side of a gear: few shapes, and the shape of each tooth.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ModifiedHalves {
    pub shapes: Vec<[Part; 4]>,
    /// Index of each tooth's shape, tooth 1 first; empty: all teeth have the first shape.
    pub of_tooth: Vec<u32>,
}

impl ModifiedHalves {
    /// The half teeth of `gear` with one deviation per tooth, or one for all teeth.
    ///
    /// # Errors
    /// As [`half_tooth`].
    pub fn new(gear: &Gear, curves: &[Arc<DeviationCurve>]) -> Result<ModifiedHalves, GearError> {
        let mut shapes = Vec::new();
        let mut known = HashMap::new();
        let mut of_tooth = Vec::with_capacity(curves.len());
        for curve in curves {
            let shape = match known.get(&Arc::as_ptr(curve)) {
                Some(&shape) => shape,
                None => {
                    shapes.push(half_tooth(gear, curve)?);
                    let shape = shapes.len() as u32 - 1;
                    known.insert(Arc::as_ptr(curve), shape);
                    shape
                }
            };
            of_tooth.push(shape);
        }
        if shapes.len() == 1 {
            of_tooth.clear();
        }
        Ok(ModifiedHalves { shapes, of_tooth })
    }

    /// Index of a tooth's shape.
    pub fn shape_of(&self, tooth: u32) -> usize {
        let shape = self.of_tooth.get(tooth as usize - 1);
        shape.map_or(0, |&shape| shape as usize)
    }

    /// The half teeth of `gear` with these deviations multiplied by `factor`.
    ///
    /// # Errors
    /// As [`half_tooth`].
    pub fn exaggerated(&self, gear: &Gear, factor: f64) -> Result<ModifiedHalves, GearError> {
        let enlarged = |parts: &[Part; 4]| match &parts[ProfilePart::Involute as usize].curve {
            PartCurve::Modified(flank) => {
                half_tooth(gear, &Arc::new(flank.deviation().scaled(factor)))
            }
            _ => Ok(gear.parts().clone()),
        };
        Ok(ModifiedHalves {
            shapes: self.shapes.iter().map(enlarged).collect::<Result<_, _>>()?,
            of_tooth: self.of_tooth.clone(),
        })
    }
}

/// The half tooth of `gear` with a deviation.
///
/// # Errors
/// [`GearError::Profile`] if the flank is irregular or leaves no tip land.
fn half_tooth(gear: &Gear, deviation: &Arc<DeviationCurve>) -> Result<[Part; 4], GearError> {
    let base = gear.base_radius();
    let [tip, form] = [gear.tip_roll(), gear.form_roll()];
    let fault = |what| GearError::Profile { what };
    let folded = "turns back on itself or crosses the base circle";
    let ends = [tip, form].map(|roll| end_at(base, roll, deviation));
    let [Some(tip_end), Some(form_end)] = ends else {
        return Err(fault(folded));
    };
    if !(form_end < tip_end) {
        return Err(fault(
            "leaves nothing between root form circle and tip circle",
        ));
    }
    let range = [form_end, tip_end];
    let flank = ModifiedFlank::new(base, gear.half_base_angle(), Arc::clone(deviation), range);
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
