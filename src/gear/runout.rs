//! Radial runout readings of a ball or pin → eccentricity.

use std::f64::consts::TAU;

/// The eccentricity in one runout reading a tooth or space, lengths in the unit of the readings.
///
/// An outline displaced by `e` towards `ψ` lets a ball at the angle `θ` stand out by
/// `c + e cos(θ − ψ)`, to first order in `e/r`: the ball's place in its space moves with the outline,
/// and what counts is the radial part. Over `z` equally spaced readings 1, `cos θ` and `sin θ` are
/// orthogonal with the norms `z`, `z/2`, `z/2` (`z ≥ 3`), so least squares give
/// `e (cos ψ, sin ψ) = 2/z Σ reading (cos θ, sin θ)`. The second order, of size `e²/r`, goes with
/// `(e cos)²` and `(e sin)²`: a constant and a second harmonic, orthogonal to the first for `z ≥ 4`.
/// There the fit of a pure eccentricity is exact to second order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunoutFit {
    /// Eccentricity `e`: half the range of the first harmonic.
    pub eccentricity: f64,
    /// Tooth (fractional, `1 ≤ … < z + 1`) towards which the outline is displaced.
    pub high_tooth: f64,
    /// `F_r`: greatest reading minus least.
    pub range: f64,
    /// Greatest distance of a reading from mean and first harmonic.
    pub rest: f64,
}

impl RunoutFit {
    /// Fits `readings` (+ = outwards), the first of them `ahead` pitches beyond the centre of tooth 1
    /// along ascending numbers: 0 at teeth, 1/2 in the spaces that follow them.
    pub fn new(readings: &[f64], ahead: f64) -> RunoutFit {
        let count = readings.len().max(1) as f64;
        let angle = |index: usize| (index as f64 + ahead) * TAU / count;
        let mean = readings.iter().sum::<f64>() / count;
        let project = |wave: fn(f64) -> f64| {
            let parts = readings.iter().enumerate();
            2.0 / count
                * parts
                    .map(|(i, reading)| (reading - mean) * wave(angle(i)))
                    .sum::<f64>()
        };
        let (x, y) = (project(f64::cos), project(f64::sin));
        let rest = readings.iter().enumerate().map(|(i, reading)| {
            let (sin, cos) = angle(i).sin_cos();
            (reading - mean - x * cos - y * sin).abs()
        });
        let place = (y.atan2(x) / TAU * count).rem_euclid(count);
        let greatest = readings.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = readings.iter().copied().fold(f64::INFINITY, f64::min);
        RunoutFit {
            eccentricity: x.hypot(y),
            // rem_euclid of a tiny negative number rounds up to z itself.
            high_tooth: 1.0 + if place < count { place } else { 0.0 },
            range: (greatest - least).max(0.0),
            rest: rest.fold(0.0, f64::max),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cosine put in comes out; a second harmonic beside it stays outside.
    #[test]
    fn finds_the_cosine_that_was_put_in() {
        for (teeth, ahead, e, high, second) in [
            (44, 0.0, 3.3, 33.0, 0.0),
            (17, 0.5, 12.0, 1.25, 2.0),
            (4, 0.5, 1.0, 4.75, 0.5),
        ] {
            let step = TAU / f64::from(teeth);
            let reading = |tooth: i32| {
                let place = f64::from(tooth) + ahead - high;
                7.0 + e * (place * step).cos() + second * (2.0 * place * step).cos()
            };
            let readings: Vec<f64> = (1..=teeth).map(reading).collect();
            let fit = RunoutFit::new(&readings, ahead);
            assert!((fit.eccentricity - e).abs() < 1e-12, "{fit:?}");
            assert!((fit.high_tooth - high).abs() < 1e-12, "{fit:?}");
            assert!(
                (fit.rest <= second + 1e-12) && (second == 0.0 || fit.rest > 0.3 * second),
                "{fit:?}"
            );
        }
    }

    #[test]
    fn equal_readings_have_no_eccentricity() {
        let fit = RunoutFit::new(&[0.1; 7], 0.0);
        assert!(fit.eccentricity < 1e-15 && fit.range == 0.0, "{fit:?}");
    }
}
