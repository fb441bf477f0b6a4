//! What a pair must keep.

use crate::pair::Member;

/// Ends of what is allowed; `None`: none.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Limits {
    /// No less than this.
    pub min: Option<f64>,
    /// No more than this.
    pub max: Option<f64>,
}

/// What of a pair is limited.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Quantity {
    /// Circumferential backlash on the operating pitch circle, `j_wt`, mm.
    OperatingBacklash,
    /// The same on the reference circle of the gear that turns, `j_t = j_wt r/r_w`, mm.
    ReferenceBacklash,
    /// Normal backlash, `j_bn = j_wt cos α_wt`, mm.
    NormalBacklash,
    /// Radial backlash, `j_r = a − a_0`, mm; without end where some backlash is left on touching base circles.
    RadialBacklash,
    /// Lost motion of a gear, `j_wt/r_w`, rad.
    LostMotion(Member),
    /// Radial clearance between the tips of one gear and the roots of the other, the least of both, mm.
    RadialClearance,
}

/// What a pair must keep, each over the whole mesh cycle and at every centre distance and material.
pub type Requirements = Vec<(Quantity, Limits)>;

/// The least radial clearance, mm, of both gears' tips in their mates' roots, by those about their geometric centres: both gears off their axes to the
/// worse, or, `is_max`, to the better side.
pub(super) fn clearance_off_axes(centred: [f64; 2], eccentricities: [f64; 2], is_max: bool) -> f64 {
    let off: f64 = eccentricities.iter().sum();
    centred[0].min(centred[1]) + if is_max { off } else { -off }
}
