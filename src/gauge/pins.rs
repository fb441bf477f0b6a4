//! Dimension over pins `M_dK`: over two in opposite spaces, and for odd tooth numbers over three.
//!
//! Over two pins the anvils read the distance of the pins' centres and one diameter more. With an odd number of
//! teeth no two spaces are opposite: two pins take the space after tooth `i` and the one `(z − 1)/2`
//! further on; three pins take a second one beside it, `(z + 1)/2` further on, and
//! one anvil lies on both.

use super::Unmeasured;
use super::seat::Seat;
use super::spread::{ends, mean};
use super::workpiece::Workpiece;

/// One dimension over pins.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OverPins {
    /// The first pin lies in the space after this tooth.
    pub tooth: u32,
    /// The second one in the space after this tooth.
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
    /// The pins where they lie, by the tooth before the space.
    pub seats: Vec<Seat>,
    /// Over two pins, by the tooth before the first one. With an even number of teeth each diameter stands there twice.
    pub two: Vec<OverPins>,
    /// Over three pins, by the tooth before the single one; empty for an even number of teeth.
    pub three: Vec<OverPins>,
}

impl OverPins {
    /// Mean of `list`, mm; not of an empty one.
    pub fn mean(list: &[OverPins]) -> f64 {
        mean(list.iter().map(|over| over.length))
    }

    /// Least and greatest of `list`, mm; not of an empty one.
    pub fn ends(list: &[OverPins]) -> [f64; 2] {
        ends(list.iter().map(|over| over.length))
    }

    /// Greatest bound on the error in `list`, mm.
    pub fn error(list: &[OverPins]) -> f64 {
        list.iter()
            .fold(0.0, |most, over| f64::max(most, over.error))
    }
}

/// Measures over pins of `diameter`, resting at `seats`.
pub(super) fn pins(work: &Workpiece, diameter: f64, seats: Vec<Seat>) -> Result<Pins, Unmeasured> {
    let basic_data = work.as_built.gear().basic_data();
    let teeth = basic_data.teeth();
    let tip = work.as_built.gear().tip_radius();
    if let Some(low) = seats
        .iter()
        .find(|s| s.centre.coords.norm() + 0.5 * diameter <= tip)
    {
        return Err(Unmeasured(format!(
            "a pin of {diameter} mm does not stand out of the space after tooth {}",
            low.tooth
        )));
    }
    let at = |tooth: u32| &seats[tooth as usize - 1];
    let two = (1..=teeth).map(|tooth| {
        let (one, other) = (at(tooth), at(work.after(tooth, teeth / 2)));
        OverPins {
            tooth,
            opposite: other.tooth,
            length: (one.centre - other.centre).norm() + diameter,
            error: one.error + other.error + work.bound(),
        }
    });
    let three = (1..=teeth)
        .filter(|_| !teeth.is_multiple_of(2))
        .map(|tooth| {
            let one = at(tooth);
            let pair = [teeth / 2, teeth / 2 + 1].map(|steps| at(work.after(tooth, steps)));
            let along = (pair[1].centre - pair[0].centre).normalize();
            OverPins {
                tooth,
                opposite: pair[0].tooth,
                length: along.perp(&(one.centre - pair[0].centre)).abs() + diameter,
                // The single pin stands between the two, seen along the anvil: their errors do not grow.
                error: one.error + pair[0].error.max(pair[1].error) + work.bound(),
            }
        });
    Ok(Pins {
        diameter,
        two: two.collect(),
        three: three.collect(),
        seats,
    })
}
