//! Dimension over pins `M_dK`: over two in opposite spaces, and for odd tooth numbers also over three.
//!
//! Over two pins the anvils measure the distance of the pins' centres plus one diameter. With an odd number of teeth no
//! two spaces are opposite. Two pins then use the space after tooth `i` and the one `(z − 1)/2` further on. Three pins
//! add the space `(z + 1)/2` further on, and one anvil touches both.
//!
//! On a helical gear these are dimensions over balls with their centres in the measuring plane. A cylindrical pin lies along its space, on
//! the helix through the centre of a ball. It touches where that ball does, and its middle has the ball's distance from the axis. Pins
//! slide along their spaces until they are opposite each other. So the anvils measure `M_dR = r_K1 + r_K2 + D_M` for any number of teeth.

use super::seat::Seat;
use super::{Summary, Unmeasured, tooth_after};
use nalgebra::Point2;

/// One dimension over pins.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OverPins {
    /// The first pin is in the space after this tooth.
    pub tooth: u32,
    /// The second pin is in the space after this tooth.
    pub opposite: u32,
    /// `M_dK`, mm.
    pub length: f64,
    /// Bound on its error, mm.
    pub error: f64,
}

/// `M_dK` at every space.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Pins {
    /// Pin diameter `D_M`, mm.
    pub diameter: f64,
    /// The pins at rest, by the tooth before the space.
    pub seats: Vec<Seat>,
    /// Over two pins, by the tooth before the first one. With an even number of teeth each diameter occurs twice.
    pub two: Vec<OverPins>,
    /// Over three pins, by the tooth before the single one; empty for an even number of teeth.
    pub three: Vec<OverPins>,
    /// Over two cylindrical pins along the spaces, as `two`; empty for a spur gear, where `two` has the same values.
    pub lying: Vec<OverPins>,
}

impl Pins {
    /// The readings of `list` in short.
    pub fn summary(list: &[OverPins]) -> Summary {
        Summary::of(list.iter().map(|over| (over.length, over.error)))
    }
}

/// The dimensions over pins of `diameter` that rest at `seats`. The pins must reach beyond the tip circle of radius `tip`, mm.
/// `rounding` is that of the sums, mm.
pub(super) fn pins(
    seats: Vec<Seat>,
    diameter: f64,
    tip: f64,
    rounding: f64,
    is_helical: bool,
) -> Result<Pins, Unmeasured> {
    let is_low = |seat: &&Seat| seat.centre.coords.norm() + 0.5 * diameter <= tip;
    if let Some(low) = seats.iter().find(is_low) {
        return Err(Unmeasured(format!(
            "a pin of {diameter} mm does not stand out of the space after tooth {}",
            low.tooth
        )));
    }
    let teeth = seats.len() as u32;
    let at = |tooth: u32| &seats[tooth as usize - 1];
    let over_two = |apart: fn(Point2<f64>, Point2<f64>) -> f64| {
        let one = |tooth: u32| {
            let opposite = tooth_after(teeth, tooth, teeth / 2);
            let (one, other) = (at(tooth), at(opposite));
            OverPins {
                tooth,
                opposite,
                length: apart(one.centre, other.centre) + diameter,
                error: one.error + other.error + rounding,
            }
        };
        (1..=teeth).map(one).collect::<Vec<OverPins>>()
    };
    let over_three = |tooth: u32| {
        let opposite = tooth_after(teeth, tooth, teeth / 2);
        let one = at(tooth);
        let pair = [opposite, tooth_after(teeth, opposite, 1)].map(at);
        let along = (pair[1].centre - pair[0].centre).normalize();
        OverPins {
            tooth,
            opposite,
            length: along.perp(&(one.centre - pair[0].centre)).abs() + diameter,
            // Along the anvil the single pin is between the two, so their errors do not grow.
            error: one.error + pair[0].error.max(pair[1].error) + rounding,
        }
    };
    let single = (1..=teeth).filter(|_| !teeth.is_multiple_of(2));
    Ok(Pins {
        diameter,
        two: over_two(|one, other| (one - other).norm()),
        three: single.map(over_three).collect(),
        lying: if is_helical {
            over_two(|one, other| one.coords.norm() + other.coords.norm())
        } else {
            Vec::new()
        },
        seats,
    })
}
