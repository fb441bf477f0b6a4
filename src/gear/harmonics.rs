//! Harmonics of both flanks' pitch curves, and how improbable it is that they go against each other.

use super::{Flank, Pitch};
use std::f64::consts::TAU;

/// One harmonic of both flanks.
pub(super) struct Harmonic {
    /// `|R|² + |L|²`.
    pub energy: f64,
    /// `2 Re(R L*)`, which is `ρ` times the energy.
    pub together: f64,
}

impl Pitch {
    /// The harmonics from 1 to below `z/2`.
    pub(super) fn harmonics(&self) -> Vec<Harmonic> {
        let [right, left] = Flank::BOTH.map(|side| self.flank(side));
        let z = right.len().min(left.len());
        let turns: Vec<(f64, f64)> = (0..z)
            .map(|i| (TAU * i as f64 / z.max(1) as f64).sin_cos())
            .collect();
        let transform = |curve: &[f64], h: usize| {
            let terms = curve.iter().enumerate();
            terms.fold([0.0; 2], |[re, im], (i, f)| {
                let (sin, cos) = turns[h * i % z];
                [re + f * cos, im + f * sin]
            })
        };
        (1..z.div_ceil(2))
            .map(|h| {
                let (r, l) = (transform(&right[..z], h), transform(&left[..z], h));
                Harmonic {
                    energy: r[0] * r[0] + r[1] * r[1] + l[0] * l[0] + l[1] * l[1],
                    together: 2.0 * (r[0] * l[0] + r[1] * l[1]),
                }
            })
            .collect()
    }
}

/// The lesser of Chernoff's bounds for the cumulative and for the single deviations of `z` teeth, harmonics `from` on.
pub(super) fn least_of_both(harmonics: &[Harmonic], from: usize, z: usize) -> f64 {
    let list = || harmonics.iter().zip(1..).skip(from - 1);
    let cumulative = opposed(list().map(|(h, _)| (h.energy, h.together)));
    // f_i = F_i − F_{i−1} multiplies harmonic h by 2 sin(π h/z).
    let single = opposed(list().map(|(harmonic, h)| {
        let factor = (TAU * f64::from(h) / (2.0 * z as f64)).sin().powi(2);
        (factor * harmonic.energy, factor * harmonic.together)
    }));
    cumulative.min(single)
}

/// Chernoff's bound for the harmonics' energies and what of them goes together.
pub(super) fn opposed(harmonics: impl Iterator<Item = (f64, f64)> + Clone) -> f64 {
    let energy: f64 = harmonics.clone().map(|(energy, _)| energy).sum();
    let against = -harmonics.clone().map(|(_, together)| together).sum::<f64>() / energy;
    if !(energy > 0.0 && against > 0.0) {
        return 1.0;
    }
    // Any λ gives a bound; steps of a quarter come within a few per cent of the best.
    let exponent = (0..80)
        .map(|n| 1.25f64.powi(n))
        .map(|lambda| {
            let sum: f64 = harmonics
                .clone()
                .map(|(e, _)| ln_sinh_ratio(lambda * e / energy))
                .sum();
            sum - lambda * against
        })
        .fold(0.0, f64::min);
    exponent.exp()
}

/// `ln(sinh x/x)`, `x ≥ 0`.
fn ln_sinh_ratio(x: f64) -> f64 {
    if x < 1e-3 {
        // Next term x⁴/180.
        x * x / 6.0
    } else {
        x + (-(-2.0 * x).exp_m1() / (2.0 * x)).ln()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parseval: `Σ F_i² = 2/z Σ |harmonic|²` of an odd number of values about their mean.
    #[test]
    fn the_energy_of_the_harmonics_is_that_of_the_teeth() {
        for z in [3u32, 7, 45] {
            let list = |k: u32| {
                (0..z)
                    .map(|i| f64::from((i * i * k + 5 * i) % 13))
                    .collect()
            };
            let (right, left): (Vec<f64>, Vec<f64>) = (list(3), list(7));
            let pitch = Pitch::from_cumulative(&right, &left);
            let squares = Flank::BOTH.map(|side| pitch.flank(side).iter().map(|f| f * f).sum());
            let of_teeth: f64 = squares.iter().sum();
            let energy: f64 = pitch.harmonics().iter().map(|h| h.energy).sum();
            let of_harmonics = 2.0 / f64::from(z) * energy;
            assert!(
                (of_harmonics - of_teeth).abs() < 1e-12 * of_teeth,
                "z = {z}"
            );
        }
    }
}
