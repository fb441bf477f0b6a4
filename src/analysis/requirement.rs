//! Requirements on a pair.

use crate::outline::AssembledPair;
use crate::pair::{Backlash, Member};

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
    ///
    /// The radial clearance does not depend on backlash: both gears are off their axes in the worse (better) direction.
    pub fn bracket(
        self,
        assembly: &AssembledPair,
        j_wt: [f64; 2],
        is_max: bool,
    ) -> Option<[f64; 2]> {
        let of_data = |value: fn(Backlash) -> f64| {
            let pair = assembly.data()?;
            Some(j_wt.map(|j_wt| value(Backlash::new(pair, j_wt))))
        };
        match self {
            Quantity::OperatingBacklash => Some(j_wt),
            Quantity::ReferenceBacklash => of_data(|all| all.j_t),
            Quantity::NormalBacklash => of_data(|all| all.j_bn),
            Quantity::RadialBacklash => of_data(|all| all.j_r.unwrap_or(f64::INFINITY)),
            Quantity::LostMotion(member) => Some(j_wt.map(|j_wt| assembly.angle(member, j_wt))),
            Quantity::RadialClearance => {
                let both = Member::BOTH;
                let centred =
                    both.map(|member| assembly.radial_clearance(member)[usize::from(is_max)]);
                let off = both.map(|member| assembly.eccentricity(member));
                let off: f64 = off.iter().sum();
                let value = centred[0].min(centred[1]) + if is_max { off } else { -off };
                let bound = assembly.outline_bound();
                Some([value - bound, value + bound])
            }
        }
    }
}

/// Requirements, each over the whole mesh cycle and at every centre distance and material.
pub type Requirements = Vec<(Quantity, Limits)>;
