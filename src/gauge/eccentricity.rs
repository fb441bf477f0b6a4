//! Eccentricity, measured on the tip lands.
//!
//! All tip lands lie on one circle about the gear's own centre, independent of the flanks. A least-squares circle goes
//! through the middles `p_i` of all tip lands. With the radius `ρ_0` of the first of them and `u_i = p_i/ρ_0`, a circle
//! about `c` has `(|p_i|² − ρ_0²)/(2 ρ_0) = c·u_i + k`, linear in `c` and `k`. For points of one circle it is exact.
//! The rows `(u_i, 1)` are of order 1, so the normal matrix `N` loses no digits.

use super::workpiece::Workpiece;
use crate::gear::Side;
use nalgebra::{Matrix3, Point2, UnitComplex, Vector2, Vector3};

/// Offset of the gear's own centre from the rotation axis.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Eccentricity {
    /// `e`, mm; 0 if it is not above its error.
    pub amount: f64,
    /// The high tooth (fractional, `1 ≤ … < z + 1`); 1 without eccentricity.
    pub high_tooth: f64,
    /// Whether the high tooth is only one of many possible ones.
    pub any_direction: bool,
    /// Bound on the error of `amount`, mm.
    pub error: f64,
}

/// The centre of the circle through `points`, and the factor from the error of a point to that of the centre.
///
/// A point that is off by `δ_i` changes its left side by `u_i·δ_i`. It changes its row by `δ_i/ρ_0`, which times the unknown `c` is `c/ρ_0`
/// as much. The sum is at most `(1 + |c|/ρ_0) |δ_i|`. The solution is `N⁻¹ Σ row_i side_i`, so the centre moves by at most `Σ ‖(N⁻¹
/// row_i)_xy‖ (1 + |c|/ρ_0) |δ_i|`. (For `z` points evenly around, `N` is diagonal with `z/2`, and the sum is 2.)
fn centre(points: &[Point2<f64>]) -> Option<(Vector2<f64>, f64)> {
    let first = points.first()?.coords.norm();
    let row = |point: &Point2<f64>| Vector3::new(point.x / first, point.y / first, 1.0);
    let (mut squares, mut moments) = (Matrix3::zeros(), Vector3::zeros());
    for point in points {
        let radius = point.coords.norm();
        // Not as a difference of squares, whose rounding would be that of r².
        let side = 0.5 * (radius - first) * (radius + first) / first;
        squares += row(point) * row(point).transpose();
        moments += row(point) * side;
    }
    let inverse = squares.try_inverse()?;
    let found = (inverse * moments).xy();
    let parts = points
        .iter()
        .map(|point| (inverse * row(point)).xy().norm());
    Some((found, parts.sum::<f64>() * (1.0 + found.norm() / first)))
}

/// Finds the eccentricity.
pub(super) fn eccentricity(work: &Workpiece) -> Eccentricity {
    let gear = work.as_built;
    let teeth = gear.gear().basic_data().teeth();
    let displacement = gear.displacement(0.0);
    let land = |tooth: u32| -> Point2<f64> {
        let turn = UnitComplex::new(gear.tooth_angle(f64::from(tooth)))
            * work.turn(Side::Right, tooth, 0.0);
        turn * work.tip_land(Side::Right, tooth) + displacement
    };
    let points: Vec<Point2<f64>> = (1..=teeth).map(land).collect();
    // Tip lands all round are never in line, so there is a centre.
    let (found, growth) = centre(&points).unwrap_or((Vector2::zeros(), f64::INFINITY));
    let amount = found.norm();
    let error = growth * work.bound();
    if amount <= error {
        return Eccentricity {
            amount: 0.0,
            high_tooth: 1.0,
            any_direction: gear.any_direction(),
            error,
        };
    }
    let angle = gear.face().ascending() * found.y.atan2(found.x);
    Eccentricity {
        amount,
        high_tooth: gear.gear().basic_data().tooth_towards(angle),
        any_direction: gear.any_direction(),
        error,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// The bound is reached: if every point moves by δ along its part of the solution, the centre moves by the sum. For points evenly
    /// around that is 2 (closed form: N = diag(z/2, z/2, z)). If half of them are bunched, the centre is less certain.
    #[test]
    fn errors_of_points_reach_the_bound_of_the_centre() {
        let at = |turn: f64| Vector2::new((TAU * turn).cos(), (TAU * turn).sin());
        let circle = |share: f64| -> Vec<Point2<f64>> {
            let each = (0..24).map(|i| share * f64::from(i) / 24.0);
            each.map(|turn| Point2::new(0.2, -0.1) + 50.0 * at(turn))
                .collect()
        };
        let even = circle(1.0);
        let (found, growth) = centre(&even).unwrap();
        assert!((found - Vector2::new(0.2, -0.1)).norm() < 1e-13, "{found}");
        // Its own eccentricity of 0.22 on 50 mm shifts the directions of the points by that ratio.
        assert!((growth - 2.0).abs() < 2.0 * 0.23 / 50.0 * 2.0, "{growth}");
        for points in [even, circle(0.3)] {
            let (found, growth) = centre(&points).unwrap();
            let delta = 1e-6;
            let moved = |i: usize| -> Vector2<f64> {
                let mut one = points.clone();
                one[i] += delta * (points[i].coords - found).normalize();
                centre(&one).unwrap().0 - found
            };
            // Outwards if that moves the centre along a direction, otherwise inwards.
            let sums = (0..12).map(|direction| {
                let along = at(f64::from(direction) / 12.0);
                (0..24).map(|i| moved(i).dot(&along).abs()).sum::<f64>() / delta
            });
            let most = sums.fold(0.0, f64::max);
            assert!(most <= growth * (1.0 + 1e-6), "{most} {growth}");
            // The bound adds lengths, the worst case only their components along one direction: 2/π of them for even points.
            assert!(most > 0.6 * growth, "{most} {growth}");
        }
    }
}
