//! The position of a pin at rest in a space of an outline.
//!
//! As on a gear by its data (`src/gauge/seat.rs`) its centre is half its diameter from both flanks, and Newton's method
//! on the two distances finds it. It comes from outside, above the middle of the space. No step is longer than the
//! distance to the nearest metal, so it passes through none. The half teeth reach to the middle of the root: a pin that
//! touches no flank first, or the root alone, has no seat.

use super::place::{Goal, Place, rounding};
use crate::gauge::seat::check_standing_out;
use crate::gauge::{Seat, Unmeasured, tooth_after};
use crate::gear::Flank;
use crate::outline::OutlineGear;
use crate::parallel;
use nalgebra::{Complex, Matrix2, Point2, Vector2};

/// Limit of Newton steps; a dozen is already much.
const MOST_STEPS: usize = 60;

/// Longest step, as a part of the distance to the nearest metal.
const SHARE: f64 = 0.9;

/// Least sine of the angle between two flanks that hold a pin better than one.
const HOLD: f64 = 1e-3;

/// Lays a pin of `diameter` into every space.
pub(super) fn seats(gear: &OutlineGear, diameter: f64) -> Result<Vec<Seat>, Unmeasured> {
    let seats = parallel::map(1..=gear.teeth(), |tooth| seat(gear, tooth, diameter));
    let seats = seats.into_iter().collect::<Result<Vec<_>, _>>()?;
    check_standing_out(&seats, diameter, gear.tip_radius())?;
    Ok(seats)
}

/// Lays a pin of `diameter` into the space after `tooth`.
fn seat(gear: &OutlineGear, tooth: u32, diameter: f64) -> Result<Seat, Unmeasured> {
    let (face, radius, fine) = (gear.face(), 0.5 * diameter, rounding(gear));
    let ends = [(Flank::Right, 0), (Flank::Left, 1)].map(|(flank, steps)| {
        let side = face.seen_from_front(flank);
        let tooth = tooth_after(gear.teeth(), tooth, steps);
        (side, tooth, gear.half(side, tooth))
    });
    let middle = gear.tooth_angle(f64::from(tooth) + 0.5);
    let mut centre = Complex::from_polar(gear.tip_radius() + radius, middle);
    for _ in 0..MOST_STEPS {
        let found: [Place; 2] =
            ends.map(|(side, _, half)| Goal::Nearest(centre).on(&half.pieces, side, fine));
        let [one, other] = found.map(|place| {
            let away = (centre - place.at) / place.value;
            Vector2::new(away.re, away.im)
        });
        let gradients = Matrix2::from_rows(&[one.transpose(), other.transpose()]);
        let hold = gradients.determinant().abs();
        let lack = Vector2::new(radius - found[0].value, radius - found[1].value);
        let Some(inverse) = gradients.try_inverse().filter(|_| hold >= HOLD) else {
            break;
        };
        if lack.amax() <= 4.0 * fine {
            // Each distance is within its bound. A centre between two gradients of the determinant D moves by at most √2 · √2/|D| as much.
            let missed = found[0].missed.max(found[1].missed);
            let distance = lack.amax() + missed + fine + gear.bound();
            return Ok(Seat {
                tooth,
                centre: Point2::new(centre.re, centre.im),
                error: 2.0 * distance / hold,
                touched: [0, 1].map(|i: usize| found[i].touch(ends[i].2, ends[i].1)),
                sections: [0.0; 2],
            });
        }
        let step = inverse * lack;
        let longest = SHARE * found[0].value.min(found[1].value);
        centre += Complex::new(step.x, step.y) * (longest / step.norm()).min(1.0);
    }
    Err(Unmeasured(format!(
        "a pin of {diameter} mm finds no rest on both flanks of the space after tooth {tooth}: take one of another diameter"
    )))
}
