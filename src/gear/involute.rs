//! The involute of a unit base circle: pure functions of its roll.
//!
//! The roll `ξ` of a point is the angle by which the generating line has rolled: the tangent of the point's pressure angle. The
//! point has the radius `√(1 + ξ²)` base radii and the polar angle `inv α = ξ − atan ξ`. ISO 21771, 4.3.3 defines the involute
//! function `inv α = tan α − α`.

/// Involute function `inv α = tan α − α` of the pressure angle `alpha`, rad.
pub fn inv(alpha: f64) -> f64 {
    alpha.tan() - alpha
}

/// `inv α` of the point with roll `xi` ≥ 0.
pub fn inv_of_roll(xi: f64) -> f64 {
    xi - xi.atan()
}

/// Roll `ξ` of the point at `radius`, for base radius `base`: `√((r/r_b)² − 1)`.
///
/// Zero below the base circle. The product form keeps all digits near it.
pub fn roll_at(radius: f64, base: f64) -> f64 {
    ((radius - base) * (radius + base)).max(0.0).sqrt() / base
}

/// Radius of the point with roll `xi`: `r_b √(1 + ξ²)`.
pub fn radius_at(xi: f64, base: f64) -> f64 {
    base * xi.hypot(1.0)
}

/// Roll `ξ` with `ξ − atan ξ = involute`, for `involute` ≥ 0; the inverse of [`inv_of_roll`].
///
/// `ξ − atan ξ` is increasing and convex, so Newton's method descends monotonically from a start above the root. The start is above
/// because `ξ − atan ξ ≥ ξ − π/2` and, for `ξ ≤ 1`, `≥ ξ³/6`. The iteration stops when it no longer descends. The result is
/// within the rounding of `ξ − atan ξ`, 2e-16 (1 + involute)/ξ² · (1 + ξ²).
pub fn roll_of_inv(involute: f64) -> f64 {
    if involute.is_nan() || involute <= 0.0 {
        return 0.0;
    }
    let mut xi = if involute < 1.0 / 6.0 {
        (6.0 * involute).cbrt()
    } else {
        involute + std::f64::consts::FRAC_PI_2
    };
    loop {
        let next = xi - (inv_of_roll(xi) - involute) * (1.0 + 1.0 / (xi * xi));
        if next.is_nan() || next >= xi {
            return xi;
        }
        xi = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// inv 20° = 0.014904383867 (any table of involutes; here to 12 digits). Nothing is below the base circle.
    #[test]
    fn roll_of_inv_inverts_over_twelve_decades() {
        assert!((inv(20f64.to_radians()) - 0.014904383867).abs() < 1e-12);
        for k in -120..=20 {
            let xi = 10f64.powf(f64::from(k) / 10.0);
            let back = roll_of_inv(inv_of_roll(xi));
            // The rounding of ξ − atan ξ limits the inverse.
            let bound = 4.0 * f64::EPSILON * xi * (1.0 + 1.0 / (xi * xi));
            let off = (back - xi).abs();
            assert!(off <= bound.max(1e-15) || xi < 1e-4, "{xi} {back}");
        }
        assert_eq!((roll_of_inv(0.0), roll_at(0.9, 1.0)), (0.0, 0.0));
    }
}
