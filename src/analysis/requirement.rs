//! Requirements on a pair.

use crate::outline::AssembledPair;
use crate::pair::{Backlash, GearPair, Member};

/// Ends of an allowed range; `None`: no limit.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Limits {
    /// Lower limit.
    pub min: Option<f64>,
    /// Upper limit.
    pub max: Option<f64>,
}

/// The limited quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Quantity {
    /// Circumferential backlash on the operating pitch circle, `j_wt`, mm.
    OperatingBacklash,
    /// Backlash on the reference circle of the gear that turns, `j_t = j_wt r/r_w`, mm.
    ReferenceBacklash,
    /// Normal backlash, `j_bn = j_wt cos α_wt`, mm.
    NormalBacklash,
    /// Radial backlash, `j_r = a − a_0`, mm; infinite if backlash remains when the base circles touch.
    RadialBacklash,
    /// Lost motion of a gear, `j_wt/r_w`, rad.
    LostMotion(Member),
    /// Radial clearance between the tips of one gear and the roots of the other, the lesser of both, mm.
    RadialClearance,
}

impl Quantity {
    /// All except the backlash on the operating pitch circle.
    pub const BESIDE_OPERATING_BACKLASH: [Quantity; 6] = [
        Quantity::ReferenceBacklash,
        Quantity::NormalBacklash,
        Quantity::RadialBacklash,
        Quantity::LostMotion(Member::Wheel),
        Quantity::LostMotion(Member::Pinion),
        Quantity::RadialClearance,
    ];

    /// The bracket of the quantity over a run of `assembly` whose least (`is_max`: greatest) `j_wt`, mm, has the
    /// bracket `j_wt`. `None` for a drawn pair without this quantity.
    pub fn bracket(
        self,
        assembly: &AssembledPair,
        j_wt: [f64; 2],
        is_max: bool,
    ) -> Option<[f64; 2]> {
        match self {
            Quantity::OperatingBacklash => Some(j_wt),
            Quantity::LostMotion(member) => Some(j_wt.map(|j_wt| assembly.angle(member, j_wt))),
            Quantity::RadialClearance => {
                let both = Member::BOTH;
                let centred =
                    both.map(|member| assembly.radial_clearance(member)[usize::from(is_max)]);
                let off = both.map(|member| assembly.eccentricity(member));
                let value = clearance_off_axes(centred, off, is_max);
                let bound = assembly.outline_bound();
                Some([value - bound, value + bound])
            }
            _ => {
                let pair = assembly.data()?;
                Some(j_wt.map(|j_wt| self.value(pair, j_wt, is_max)))
            }
        }
    }

    /// Value of the quantity for `assembly` at a pose with the backlash `j_wt`, mm, the least (`is_max`: the greatest) of the cycle. The
    /// radial clearance does not depend on backlash: both gears are off their axes in the worse (better) direction.
    pub fn value(self, assembly: &GearPair, j_wt: f64, is_max: bool) -> f64 {
        let all = Backlash::new(assembly, j_wt);
        match self {
            Quantity::OperatingBacklash => j_wt,
            Quantity::ReferenceBacklash => all.j_t,
            Quantity::NormalBacklash => all.j_bn,
            Quantity::RadialBacklash => all.j_r.unwrap_or(f64::INFINITY),
            Quantity::LostMotion(member) => all.angle(member),
            Quantity::RadialClearance => {
                let both = Member::BOTH;
                let centred = both.map(|member| assembly.radial_clearance(member));
                let off = both.map(|member| assembly.gear(member).eccentricity());
                clearance_off_axes(centred, off, is_max)
            }
        }
    }
}

/// Requirements, each over the whole mesh cycle and at every centre distance and material.
pub type Requirements = Vec<(Quantity, Limits)>;

/// The least radial clearance, mm, of both gears' tips in their mates' roots, from those about the geometric centres.
/// Both gears are off their axes in the worse direction, or with `is_max` in the better one.
fn clearance_off_axes(centred: [f64; 2], off: [f64; 2], is_max: bool) -> f64 {
    let off: f64 = off.iter().sum();
    centred[0].min(centred[1]) + if is_max { off } else { -off }
}
