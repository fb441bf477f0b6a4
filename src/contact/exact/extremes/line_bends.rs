//! How the touch of two involutes on the line of action bends with the locked gear's rotation.
//!
//! With `B` from the free outline's centre to the locked one's, both involutes touch at the gap `μ` where (see [`super::super::line`])
//!
//! ```text
//! r_bF μ + r_bL x = G(B) + const,    G = Σ (arg B + α) − T,    T = √(|B|² − Σ²).
//! ```
//!
//! The gradient of `G` is the unit normal of the flanks, `n = i e^{i(arg B + α)}`. It turns by `τ̂·dB/T`, `τ̂ = e^{i(arg B + α)}`, so
//!
//! ```text
//! D²G[d, d] = −(τ̂·d)²/T,    |D²G[d, c]| ≤ |d| |c|/T,    |D³G[d, d, d]| ≤ |d|³ (2 + |B|/T)/T²,
//! ```
//!
//! the last since `|dT| ≤ |B|/T |dB|`. `B` moves by the eccentricities, the locked one's with `x`, the free one's with `μ`. Let `E_k` bound its
//! `k`-th derivative by `x`, and `μ_k` that of `μ`. The derivatives of the equation are
//!
//! ```text
//! r_bF μ'   = −r_bL + n·B'
//! r_bF μ''  = n·B'' + D²G[B', B']
//! r_bF μ''' = n·B''' + 3 D²G[B', B''] + D³G[B', B', B']
//! ```
//!
//! and in each the free eccentricity times the derivative itself goes to the left-hand side.

use super::super::flank_problem::FlankProblem;

/// Bounds over all poses of a side, per radian of the locked gear's rotation.
#[derive(Debug, Clone, Copy)]
pub(super) struct LineBends {
    /// Bound of the turn of the line of action.
    pub turn: f64,
    /// Bound of the second derivative of the touch.
    pub second: f64,
    /// Bound of its third derivative.
    pub third: f64,
}

impl LineBends {
    /// The bounds of a side with the eccentricities `off`, mm, of its outlines.
    ///
    /// They are `None` if base circles may overlap or less than half the free arm is left.
    pub fn new(problem: &FlankProblem, off: [f64; 2]) -> Option<LineBends> {
        let bases = [problem.locked.shape.base, problem.free.shape.base];
        LineBends::of(bases, problem.distance, off)
    }

    fn of([locked, free]: [f64; 2], distance: f64, off: [f64; 2]) -> Option<LineBends> {
        let sum = locked + free;
        let both = off[0] + off[1];
        let nearest = distance - both;
        let square = nearest * nearest - sum * sum;
        let arm = free - off[1];
        if !(nearest > 0.0 && square > 0.0 && arm > 0.5 * free) {
            return None;
        }
        let length = square.sqrt();
        let [e, f] = off;
        let first = (locked + e) / arm;
        let moves = e + f * first;
        let second = (e + f * first * first + moves * moves / length) / arm;
        let moves_second = e + f * first * first + f * second;
        let steep = 2.0 + (distance + both) / length;
        let third = (e
            + f * first.powi(3)
            + 3.0 * f * first * second
            + 3.0 * moves * moves_second / length
            + moves.powi(3) * steep / (length * length))
            / arm;
        Some(LineBends {
            turn: moves / length,
            second,
            third,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::shape::{C, turn};
    use super::*;
    use std::f64::consts::PI;

    /// No touch bends more than its bounds, and some not much less. Source: differences of the rotation of touch, found by Newton's method from
    /// the length of the line of action.
    #[test]
    fn a_touch_bends_no_more_than_its_bounds() {
        for (bases, off) in [
            ([60.0, 15.0], [0.0, 0.5]),
            ([15.0, 60.0], [0.5, 0.0]),
            ([30.0, 20.0], [0.03, 0.04]),
            ([30.0, 20.0], [0.9, 0.4]),
        ] {
            let sum: f64 = bases[0] + bases[1];
            let distance = sum / 20f64.to_radians().cos();
            let touch = |x: f64, phases: [f64; 2]| {
                let (mut mu, mut beta) = (0.0, 0.0);
                for _ in 0..60 {
                    let between = C::from(distance) - turn(x + phases[0]) * off[0]
                        + turn(mu + phases[1]) * off[1];
                    let length = (between.norm_sqr() - sum * sum).sqrt();
                    beta = between.arg() + length.atan2(sum);
                    mu -= (length - bases[0] * (beta - x) - bases[1] * (beta - mu)) / bases[1];
                }
                (mu, beta)
            };
            let bounds = LineBends::of(bases, distance, off).unwrap();
            let most = [bounds.turn, bounds.second, bounds.third];
            let mut shares = [0.0f64; 3];
            for k in 0..400 {
                let phases = [f64::from(k % 20), f64::from(k / 20)].map(|k| 0.1 * PI * k);
                const H: f64 = 5e-3;
                let [a, b, c, d] = [-1.5, -0.5, 0.5, 1.5].map(|x| touch(x * H, phases));
                let found = [
                    (c.1 - b.1) / H,
                    (a.0 - b.0 - c.0 + d.0) / (2.0 * H * H),
                    (d.0 - 3.0 * c.0 + 3.0 * b.0 - a.0) / (H * H * H),
                ];
                for (share, (found, most)) in shares.iter_mut().zip(found.iter().zip(most)) {
                    *share = share.max(found.abs() / most);
                }
            }
            let is_near = |share: &f64| (0.4..=1.001).contains(share);
            assert!(shares.iter().all(is_near), "{shares:?}");
        }
    }
}
