//! Eccentricity, as the tip lands show it.
//!
//! All tip lands lie on one circle about the gear's own centre, wherever the flanks stand. The
//! circle through the middles of all of them is found by least squares in the form `|p|² = 2 c·p + k`, which is linear in
//! `c` and `k`; on points of one circle it is exact.

use super::workpiece::Workpiece;
use crate::gear::Side;
use nalgebra::{Matrix3, Point2, UnitComplex, Vector3};

/// Where the gear's own centre stands off the rotation axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eccentricity {
    /// `e`, mm; 0 where it is no more than its error.
    pub amount: f64,
    /// The tooth (fractional, `1 ≤ … < z + 1`) it points to; 1 where there is none.
    pub high_tooth: f64,
    /// Bound on the error of `amount`, mm.
    pub error: f64,
}

/// Finds the eccentricity.
pub(super) fn eccentricity(work: &Workpiece) -> Eccentricity {
    let gear = work.as_built;
    let teeth = gear.gear().toothing().teeth();
    let displacement = gear.displacement(0.0);
    let (mut squares, mut moments) = (Matrix3::zeros(), Vector3::zeros());
    for tooth in 1..=teeth {
        let land = work.tip_land(Side::Right);
        let turn = UnitComplex::new(gear.tooth_angle(f64::from(tooth)))
            * work.turn(Side::Right, tooth, 0.0);
        let point: Point2<f64> = turn * land + displacement;
        let row = Vector3::new(2.0 * point.x, 2.0 * point.y, 1.0);
        squares += row * row.transpose();
        moments += row * point.coords.norm_squared();
    }
    let none = Eccentricity {
        amount: 0.0,
        high_tooth: 1.0,
        error: work.bound(),
    };
    // Tip lands all round are never in line.
    let Some(found) = squares.try_inverse().map(|inverse| inverse * moments) else {
        return none;
    };
    let amount = found.x.hypot(found.y);
    if amount <= none.error {
        return none;
    }
    let angle = gear.face().ascending() * found.y.atan2(found.x);
    Eccentricity {
        amount,
        high_tooth: gear.gear().toothing().tooth_towards(angle),
        ..none
    }
}
