//! Dimension over pins `M_dK`: over two in opposite spaces, and for odd tooth numbers also over three.
//!
//! Over two pins the anvils measure the distance of the pins' centres plus one diameter. With an odd number of teeth no
//! two spaces are opposite. Two pins then use the space after tooth `i` and the one `(z − 1)/2` further on. Three pins
//! add the space `(z + 1)/2` further on, and one anvil touches both.
//!
//! On a helical gear these are dimensions over balls with their centres in the measuring plane. A cylindrical pin lies along its space, on
//! the helix through the centre of a ball. It touches where that ball does, and its middle has the ball's distance from the axis. Pins
//! slide along their spaces until they are opposite each other. So the anvils measure `M_dR = r_K1 + r_K2 + D_M` for any number of teeth.

use super::seat::{Seat, check_standing_out};
use super::spread::{ends, mean};
use super::workpiece::Workpiece;
use super::{Unmeasured, tooth_after};
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

impl OverPins {
    /// Mean of `list`, mm; `list` must not be empty.
    pub fn mean(list: &[OverPins]) -> f64 {
        mean(list.iter().map(|over| over.length))
    }

    /// Least and greatest of `list`, mm; `list` must not be empty.
    pub fn ends(list: &[OverPins]) -> [f64; 2] {
        ends(list.iter().map(|over| over.length))
    }

    /// Greatest bound on the error in `list`, mm.
    pub fn error(list: &[OverPins]) -> f64 {
        list.iter().map(|over| over.error).fold(0.0, f64::max)
    }
}

/// Measures over pins of `diameter`, resting at `seats`.
pub(super) fn pins(work: &Workpiece, diameter: f64, seats: Vec<Seat>) -> Result<Pins, Unmeasured> {
    let basic_data = work.as_built.gear().basic_data();
    let teeth = basic_data.teeth();
    check_standing_out(&seats, diameter, work.as_built.gear().tip_radius())?;
    let at = |tooth: u32| {
        let seat = &seats[tooth as usize - 1];
        (seat.centre, seat.error)
    };
    let (two, three) = over(teeth, diameter, work.bound(), at);
    let lying = match basic_data.hand() {
        None => Vec::new(),
        Some(_) => {
            let apart =
                |one: Point2<f64>, other: Point2<f64>| one.coords.norm() + other.coords.norm();
            over_two(teeth, diameter, work.bound(), at, apart)
        }
    };
    Ok(Pins {
        diameter,
        two,
        three,
        lying,
        seats,
    })
}

/// Over two pins, each as far from the other as `apart` tells; otherwise as [`over`].
fn over_two(
    teeth: u32,
    diameter: f64,
    rounding: f64,
    at: impl Fn(u32) -> (Point2<f64>, f64),
    apart: impl Fn(Point2<f64>, Point2<f64>) -> f64,
) -> Vec<OverPins> {
    let one = |tooth: u32| {
        let opposite = tooth_after(teeth, tooth, teeth / 2);
        let ((one, one_error), (other, other_error)) = (at(tooth), at(opposite));
        OverPins {
            tooth,
            opposite,
            length: apart(one, other) + diameter,
            error: one_error + other_error + rounding,
        }
    };
    (1..=teeth).map(one).collect()
}

/// Over two pins and over three. `at` has for each tooth the centre of the pin in the space after it and its error
/// bound, mm; `rounding` is the rounding of the sums, mm.
pub(super) fn over(
    teeth: u32,
    diameter: f64,
    rounding: f64,
    at: impl Fn(u32) -> (Point2<f64>, f64),
) -> (Vec<OverPins>, Vec<OverPins>) {
    let apart = |one: Point2<f64>, other: Point2<f64>| (one - other).norm();
    let two = over_two(teeth, diameter, rounding, &at, apart);
    let three = (1..=teeth)
        .filter(|_| !teeth.is_multiple_of(2))
        .map(|tooth| {
            let opposite = tooth_after(teeth, tooth, teeth / 2);
            let (one, error) = at(tooth);
            let pair = [opposite, tooth_after(teeth, opposite, 1)].map(&at);
            let along = (pair[1].0 - pair[0].0).normalize();
            OverPins {
                tooth,
                opposite,
                length: along.perp(&(one - pair[0].0)).abs() + diameter,
                // Along the anvil the single pin is between the two, so their errors do not grow.
                error: error + pair[0].1.max(pair[1].1) + rounding,
            }
        });
    (two, three.collect())
}
