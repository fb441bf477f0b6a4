//! Radius of the root circle: a stylus on the bottom of every tooth space.
//!
//! The bottom of a space belongs to the two half teeth beside it. Each extends from the end of its fillet to the middle
//! of its space, turned with its flank. If one half's fillet covers the other's bottom, because flanks deviate
//! outwards, the root circle is hidden, and that space is omitted.

use super::Unmeasured;
use super::workpiece::Workpiece;
use crate::gear::{Flank, GearDesign};

/// The root circle about the gear's own centre.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RootReading {
    /// `r_f`, mm: mean over the spaces in which it is visible.
    pub radius: f64,
    /// Bound on its error, mm.
    pub error: f64,
    /// Thickness from the depth of the tool, mm: `s = m (π/2 + 2 x_E tan α)` at the reference circle. `x_E` follows
    /// from `r_f = r − m (h_fP* − x_E)` with the rack of the drawing.
    pub thickness: f64,
    /// Bound on the error of `thickness`, mm.
    pub thickness_error: f64,
}

/// Measures the root circle.
pub(super) fn root(work: &Workpiece) -> Result<RootReading, Unmeasured> {
    let gear = work.as_built;
    let ascending = gear.face().ascending();
    let half = 0.5 * ascending;
    let (mut sum, mut count) = (0.0, 0.0);
    for tooth in 1..=gear.gear().basic_data().teeth() {
        let next = work.tooth_after(tooth, 1);
        let ends = [(Flank::Right, tooth, half), (Flank::Left, next, -half)];
        // From the middle of the space.
        let [from, to] = ends.map(|(own, tooth, pitches)| {
            let side = gear.face().seen_from_front(own);
            work.turn(side, tooth, pitches) * work.root_end(side, tooth)
        });
        // The cross product of both, over r_f²: the angle of the bottom between them.
        let shown = ascending * from.coords.perp(&to.coords) / from.coords.norm();
        if shown >= -work.bound() {
            sum += from.coords.norm();
            count += 1.0;
        }
    }
    if count == 0.0 {
        return Err(Unmeasured(
            "fillets cover the root circle in every tooth space".to_owned(),
        ));
    }
    let radius = sum / count;
    let design = gear.gear().design();
    let (basic_data, rack) = (&design.basic_data, &design.rack);
    let module = basic_data.module();
    let tan = basic_data.pressure_angle().tan();
    let shift = (radius - basic_data.reference_radius()) / module + rack.dedendum();
    Ok(RootReading {
        radius,
        error: work.bound(),
        thickness: GearDesign {
            profile_shift: shift,
            ..*design
        }
        .nominal_thickness(),
        // The rounding of r and of the shift is a few ulps of r, far within the bound.
        thickness_error: 2.0 * (2.0 * work.bound()) * tan,
    })
}
