//! Flank correlation: whether the two flanks' pitch curves go against each other.
//!
//! A tool cuts both flanks of a tooth, so most of a real pitch deviation moves them together; a left flank
//! whose sign is reversed moves against the right one instead. About the datum axis an eccentricity moves them
//! together, too, but for the pressure angle between them.

use super::harmonics::least_of_both;
use super::{Flank, Gear, Pitch};
use nalgebra::Complex;
use std::f64::consts::TAU;

impl Pitch {
    /// A bound of the probability that flanks without any relation go against each other as much as these do; 1 when they
    /// rather go together.
    ///
    /// Of each harmonic `h` below `z/2`, with Fourier coefficients `R` and `L`, let `ρ = 2 Re(R L*)/(|R|² + |L|²)`.
    /// For unrelated flanks (normal, stationary round the gear, alike in spectrum) `R + L` and `R − L` are
    /// independent and alike, so that `ρ = (|R + L|² − |R − L|²)/(|R + L|² + |R − L|²)` is uniform on −1 … 1,
    /// independent of the energy `|R|² + |L|²` and from harmonic to harmonic. Then for the mean `C = Σ p ρ` with
    /// the shares `p` of the energy, Chernoff's bound is `P(C ≤ −c) ≤ e^{−λc} Π sinh(λp)/(λp)` for every `λ`. It is taken for the energies of the
    /// cumulative and of the single deviations, and the lesser is doubled.
    pub fn anticorrelation_p_value(&self) -> f64 {
        let [right, left] = Flank::BOTH.map(|side| self.flank(side));
        if together(right, left) >= 0.0
            && together(&self.single(Flank::Right), &self.single(Flank::Left)) >= 0.0
        {
            // No bound is below 1, and the harmonics of thousands of teeth take a while.
            return 1.0;
        }
        let harmonics = self.harmonics();
        let z = self.flank(Flank::Right).len();
        (2.0 * least_of_both(&harmonics, 1, z)).min(1.0)
    }

    /// The same of datum-axis curves of `gear`, which hold an eccentricity of any size in their first harmonic.
    ///
    /// Let `u` and `v` be the first harmonics of the right and of the left flanks, each counted from where an eccentricity has its
    /// zero (`ψ ∓ α`, see [`Pitch::separate_eccentricity`]). An eccentricity puts the same into both: `S = u + v` holds it, `D = u − v`
    /// nothing of it. A reversed left flank changes the parts of `S` and `D`: then an eccentricity
    /// stands in `D`, as a first harmonic of the gear's own thickness would, and hardly anything in `S`.
    ///
    /// For unrelated flanks without eccentricity `|S|²` and `|D|²` are independent and alike (exponential); an eccentricity makes
    /// `k = |S|²/|D|²` the larger and leaves `D` alone. `D` stands out from the others by `q = |D|²/(|D|² + T)`, `T` the sum of
    /// the `n = 2 (harmonics − 1)` other `|S|²` and `|D|²`, weighted by `sin²(π h/z)/sin²(π/z)`: they are alike then for a random walk, and white ones
    /// stand out the less. `|D|² + T` is independent of `q`, which is Beta(1, n), so with `E[|D|² | q] = (1 + n) q` the probability of
    /// less than `k` at more than `q` is at most `x = k (1 − q)^n (1 + n q)`. That of any pair with less than `x` is
    /// at most `∫ min(1, x (1 + n) q/((1 − q)^n (1 + n q))) n (1 − q)^{n−1} dq ≤ x (1 + n) l + e^{−n l}` for any `l`; the best is
    /// `w (1 − ln w)`, `w = x (1 + n)/n` (own derivation). The other harmonics are judged as of own-axis data; the
    /// least of the three bounds is taken threefold. Curves that go together as read are none of these: an index error common to both
    /// flanks stands in `D`, too.
    pub fn datum_anticorrelation_p_value(&self, gear: &Gear) -> f64 {
        let [right, left] = Flank::BOTH.map(|side| self.flank(side));
        if together(right, left) >= 0.0 {
            // A reversed left flank takes the eccentricity with it: the curves as read go against each other.
            return 1.0;
        }
        let z = right.len();
        let harmonics = self.harmonics();
        // Of less than three teeth.
        if harmonics.is_empty() {
            return 1.0;
        }
        let rest = least_of_both(&harmonics, 2, z);
        let [u, v] = Flank::BOTH.map(|side| self.first_harmonic_as_eccentric(gear, side));
        let (together, apart) = ((u + v).norm_sqr(), (u - v).norm_sqr());
        let first = TAU / (2.0 * z as f64);
        let weight = |h: u32| ((first * f64::from(h)).sin() / first.sin()).powi(2);
        // |S|² + |D|² = 2 (|R|² + |L|²).
        let others: f64 = harmonics
            .iter()
            .zip(1..)
            .skip(1)
            .map(|(harmonic, h)| 2.0 * weight(h) * harmonic.energy)
            .sum();
        let n = 2.0 * (harmonics.len() - 1) as f64;
        let (k, q) = (together / apart, apart / (apart + others));
        let first = if n > 0.0 {
            let x = k * (1.0 - q).powf(n) * (1.0 + n * q);
            let w = (x * (1.0 + n) / n).clamp(f64::MIN_POSITIVE, 1.0);
            w * (1.0 - w.ln())
        } else {
            // k/(1 + k) is exact.
            k
        };
        // Where nothing stands apart it is 1, or no number, which the lesser of two passes over.
        (3.0 * rest.min(first)).min(1.0)
    }

    /// Energy `|R|² + |L|²` of the first harmonics of both flanks, mm² times `z²`.
    pub fn first_harmonic_energy(&self) -> f64 {
        let energy = |side| self.first_harmonic(side).norm_sqr();
        Flank::BOTH.map(energy).iter().sum()
    }

    /// What the two flanks' first harmonics differ by as read, half of it: the energy that a wave of both alike leaves, mm² times `z²`.
    pub fn first_harmonic_apart(&self) -> f64 {
        let [right, left] = Flank::BOTH.map(|side| self.first_harmonic(side));
        (right - left).norm_sqr() / 2.0
    }

    /// First harmonic of the own `side` flanks, counted from the angle `±α` at which an eccentricity shows nothing.
    fn first_harmonic_as_eccentric(&self, gear: &Gear, side: Flank) -> Complex<f64> {
        let alpha = gear.basic_data().transverse_pressure_angle();
        let ahead = -side.sense();
        let start = ahead * (gear.half_angle_at_roll(alpha.tan()) - alpha);
        self.first_harmonic(side) * Complex::from_polar(1.0, -start)
    }

    /// The same, counted from tooth 1.
    fn first_harmonic(&self, side: Flank) -> Complex<f64> {
        let flank = self.flank(side);
        let turn = TAU / flank.len().max(1) as f64;
        let teeth = flank.iter().enumerate();
        teeth
            .map(|(index, f)| Complex::from_polar(*f, -turn * index as f64))
            .sum()
    }
}

/// `Σ 2 Re(R L*)` over the harmonics below `z/2`: by Parseval `z Σ r l` less the harmonics 0 and `z/2`.
fn together(right: &[f64], left: &[f64]) -> f64 {
    let z = right.len();
    let all: f64 = right.iter().zip(left).map(|(r, l)| r * l).sum();
    let mean = right.iter().sum::<f64>() * left.iter().sum::<f64>();
    let alternating = |curve: &[f64]| -> f64 {
        let signs = [1.0, -1.0].into_iter().cycle();
        curve.iter().zip(signs).map(|(f, sign)| sign * f).sum()
    };
    let middle = match z % 2 {
        0 => alternating(right) * alternating(left),
        _ => 0.0,
    };
    z as f64 * all - mean - middle
}

#[cfg(test)]
mod tests {
    use super::super::harmonics::opposed;
    use super::*;

    /// Parseval: what goes together is the same summed over the harmonics and over the teeth, `z` even or odd.
    #[test]
    fn the_quick_sum_is_that_of_the_harmonics() {
        for z in [3u32, 4, 7, 8, 44, 45] {
            let wave = |i: u32, k: u32| f64::from((i * k * k + 3 * i) % 17) - 8.0;
            let right: Vec<f64> = (0..z).map(|i| wave(i, 5)).collect();
            let left: Vec<f64> = (0..z).map(|i| wave(i, 3)).collect();
            let pitch = Pitch::from_cumulative(&right, &left);
            let [right, left] = Flank::BOTH.map(|side| pitch.flank(side));
            let quick = together(right, left);
            let slow: f64 = pitch.harmonics().iter().map(|h| h.together).sum();
            let size: f64 = pitch.harmonics().iter().map(|h| h.energy).sum();
            assert!(
                (quick - slow).abs() <= 1e-12 * size,
                "z = {z}: {quick}, {slow}"
            );
        }
    }

    /// `F = A cos φ` on the right flanks alone: `A/2` of it alike on both leaves `±A/2`, whose harmonics are `A z/4` each.
    #[test]
    fn what_a_wave_of_both_flanks_leaves_of_a_wave_of_one() {
        let (z, amplitude) = (12, 3.0);
        let wave = |i: u32| amplitude * (TAU * f64::from(i) / f64::from(z)).cos();
        let right: Vec<f64> = (0..z).map(wave).collect();
        let pitch = Pitch::from_cumulative(&right, &vec![0.0; z as usize]);
        let left_over = 2.0 * (amplitude * f64::from(z) / 4.0).powi(2);
        assert!((pitch.first_harmonic_apart() - left_over).abs() < 1e-12 * left_over);
    }

    /// Random steps added up, or, of `white`, steps alone; the left flank against the right by `share`.
    fn random_pitch(z: u32, seed: u64, share: f64, white: bool) -> Pitch {
        let mut state = seed;
        let mut step = || {
            // SplitMix64 (Steele, Lea and Flood 2014).
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut bits = state;
            bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((bits ^ (bits >> 31)) >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let (mut right, mut left) = (Vec::new(), Vec::new());
        let (mut here, mut there) = (0.0, 0.0);
        for _ in 0..z {
            let (one, other) = (step(), step());
            let other = (1.0 - share) * other - share * one;
            (here, there) = match white {
                true => (one, other),
                false => (here + one, there + other),
            };
            right.push(here);
            left.push(there);
        }
        Pitch::from_cumulative(&right, &left)
    }

    /// The lesser of the bounds for the curves as they are and for their differences from tooth to tooth. Source: the harmonics of those
    /// differences, transformed themselves.
    #[test]
    fn single_deviations_are_judged_by_their_own_harmonics() {
        let mut lesser = [0; 2];
        for seed in 0..40 {
            for white in [false, true] {
                let pitch = random_pitch(17, seed, 0.4, white);
                let single = Flank::BOTH.map(|side| {
                    let curve = pitch.flank(side);
                    let before = |i: usize| curve[(i + curve.len() - 1) % curve.len()];
                    (0..curve.len())
                        .map(|i| curve[i] - before(i))
                        .collect::<Vec<f64>>()
                });
                let single = Pitch::from_cumulative(&single[0], &single[1]);
                for from in [1, 2] {
                    let bound = |pitch: &Pitch| {
                        let harmonics = pitch.harmonics();
                        opposed(harmonics[from - 1..].iter().map(|h| (h.energy, h.together)))
                    };
                    let (whole, steps) = (bound(&pitch), bound(&single));
                    let found = least_of_both(&pitch.harmonics(), from, 17);
                    let expected = whole.min(steps);
                    assert!((found / expected - 1.0).abs() < 1e-9, "{found}, {expected}");
                    lesser[usize::from(steps < whole)] += usize::from(expected < 0.9);
                }
            }
        }
        assert!(lesser.iter().all(|count| *count > 10), "{lesser:?}");
    }

    /// It bounds a probability: of unrelated flanks no more than a share `p` has less than `p`; flanks that go against each other have hardly any,
    /// those that go together 1.
    #[test]
    fn unrelated_flanks_are_as_seldom_opposed_as_it_says() {
        const DRAWN: u64 = 400;
        let found = |share: f64| -> Vec<f64> {
            let pitches = (0..DRAWN).map(|seed| random_pitch(24, seed, share, seed % 2 == 0));
            pitches
                .map(|pitch| pitch.anticorrelation_p_value())
                .collect()
        };
        let unrelated = found(0.0);
        for p in [0.02, 0.1, 0.3] {
            let below = unrelated.iter().filter(|&&found| found <= p).count() as f64;
            // Four standard deviations of a binomial count above what is expected at the most.
            let most = p * DRAWN as f64;
            assert!(
                below <= most + 4.0 * most.sqrt(),
                "{below} of {DRAWN} below {p}"
            );
        }
        let opposed = found(0.95);
        assert!(
            opposed.iter().all(|&found| found > 0.0 && found < 1e-3),
            "{opposed:?}"
        );
        let alike = random_pitch(24, 1, 0.0, false).flank(Flank::Right).to_vec();
        assert_eq!(
            Pitch::from_cumulative(&alike, &alike).anticorrelation_p_value(),
            1.0
        );
    }

    /// Long waves alike and short ones opposed, or the other way round: the cumulative deviations and the single ones say different things, and the
    /// one that is opposed counts. Four or eight waves of about one energy that are all opposed are as good as never unrelated.
    #[test]
    fn opposed_short_or_long_waves_count_by_themselves() {
        let waves = |harmonics: std::ops::Range<u32>, amplitude: f64, at: u32| -> f64 {
            let each = harmonics.map(|h| (f64::from(h * at) * TAU / 40.0 + f64::from(h)).cos());
            amplitude * each.sum::<f64>()
        };
        // Of the right flanks as they are, of the left ones with these signs.
        let pitch = |[long, short]: [f64; 2], signs: [f64; 2]| {
            let flank = |[one, other]: [f64; 2]| -> Vec<f64> {
                let each = 0..40;
                each.map(|at| waves(1..5, long * one, at) + waves(8..16, short * other, at))
                    .collect()
            };
            Pitch::from_cumulative(&flank([1.0, 1.0]), &flank(signs))
        };
        for (sizes, signs) in [([6.0, 4.0], [1.0, -1.0]), ([10.0, 2.5], [-1.0, 1.0])] {
            let pitch = pitch(sizes, signs);
            let [right, left] = Flank::BOTH.map(|side| pitch.flank(side));
            let single = Flank::BOTH.map(|side| pitch.single(side));
            let sums = [together(right, left), together(&single[0], &single[1])];
            assert!(
                sums[0] * signs[0] > 0.0 && sums[1] * signs[1] > 0.0,
                "{sums:?}"
            );
            let found = pitch.anticorrelation_p_value();
            assert!(found < 0.05, "{signs:?}: {found}");
        }
        assert_eq!(pitch([6.0, 4.0], [1.0, 1.0]).anticorrelation_p_value(), 1.0);
    }

    /// A wave once round that an eccentricity leaves on a flank of `z` teeth whose half tooth is `π/2z` on the reference circle, and of its like.
    fn once_round(curve: &[f64], side: Flank) -> Complex<f64> {
        let z = curve.len() as f64;
        let start = -side.sense() * (TAU / (4.0 * z) - 20f64.to_radians());
        let wave = |(i, f): (usize, &f64)| {
            let angle = TAU * i as f64 / z + start;
            Complex::new(f * angle.cos(), -f * angle.sin())
        };
        curve.iter().enumerate().map(wave).sum()
    }

    /// Source: the integral of which the bound is said to be one, summed up in steps; the energies of single deviations, transformed
    /// themselves; the first harmonics, counted by the reference circle.
    #[test]
    fn opposed_first_harmonics_are_as_improbable_as_the_integral_says() {
        let (mut by_first, mut unlike) = (0, 0);
        for z in [15, 16, 3] {
            let gear = Gear::nominal(crate::gear::GearDesign::plain(z.max(12), 2.0)).unwrap();
            for seed in 0..120 {
                let mut pitch = random_pitch(z, seed, 0.2, seed % 2 == 0);
                // Waves that stand apart by more and more.
                let [right, left] = Flank::BOTH.map(|side| {
                    let start =
                        -side.sense() * (TAU / (4.0 * f64::from(z.max(12))) - 20f64.to_radians());
                    let own = pitch.flank(side).iter().enumerate();
                    let wave = |i: usize| (TAU * i as f64 / f64::from(z) + start).cos();
                    let size = 0.06 * (seed % 30) as f64 * side.sense();
                    own.map(|(i, f)| f + size * wave(i)).collect::<Vec<f64>>()
                });
                pitch = Pitch::from_cumulative(&right, &left);
                let found = pitch.datum_anticorrelation_p_value(&gear);
                let [right, left] = Flank::BOTH.map(|side| pitch.flank(side));
                if together(right, left) >= 0.0 {
                    assert_eq!(found, 1.0);
                    unlike += 1;
                    continue;
                }
                if z == 3 {
                    // Nothing beside the first harmonics: k, threefold.
                    let [u, v] = Flank::BOTH.map(|side| {
                        let turn = -side.sense() * (TAU / 48.0 - TAU / 12.0);
                        once_round(pitch.flank(side), side) * Complex::from_polar(1.0, -turn)
                    });
                    let k = (u + v).norm_sqr() / (u - v).norm_sqr();
                    let expected = (3.0 * k).min(1.0);
                    assert!((found - expected).abs() < 1e-9, "{found} {expected}");
                    continue;
                }
                let [u, v] = Flank::BOTH.map(|side| once_round(pitch.flank(side), side));
                let (s, d) = ((u + v).norm_sqr(), (u - v).norm_sqr());
                let single = Flank::BOTH.map(|side| {
                    let curve = pitch.flank(side);
                    let before = |i: usize| curve[(i + curve.len() - 1) % curve.len()];
                    (0..curve.len())
                        .map(|i| curve[i] - before(i))
                        .collect::<Vec<f64>>()
                });
                let single = Pitch::from_cumulative(&single[0], &single[1]).harmonics();
                let per_first = (2.0 * (TAU / (2.0 * f64::from(z))).sin()).powi(2);
                let others: f64 = single[1..].iter().map(|h| 2.0 * h.energy / per_first).sum();
                let n = 2.0 * (single.len() - 1) as f64;
                let (k, q) = (s / d, d / (d + others));
                let x = k * (1.0 - q).powf(n) * (1.0 + n * q);
                const STEPS: u32 = 20_000;
                let integral: f64 = (0..STEPS)
                    .map(|i| {
                        let q = (f64::from(i) + 0.5) / f64::from(STEPS);
                        let at_most = x * (1.0 + n) * q / ((1.0 - q).powf(n) * (1.0 + n * q));
                        at_most.min(1.0) * n * (1.0 - q).powf(n - 1.0) / f64::from(STEPS)
                    })
                    .sum();
                let rest = least_of_both(&pitch.harmonics(), 2, z as usize);
                let first = found / 3.0;
                if found < 1.0 && first < rest * (1.0 - 1e-12) {
                    by_first += 1;
                    let case = format!("{z} {seed}: {first} {integral}");
                    assert!(first >= integral * (1.0 - 1e-3), "{case}");
                    // `1 + n q ≥ 1` is what it gives away, and a factor of (1 + n)/n.
                    assert!(first <= 2.5 * integral, "{case}");
                } else {
                    assert_eq!(found, (3.0 * rest).min(1.0), "{z} {seed}");
                    assert!(3.0 * integral.min(rest) >= 0.3 * found, "{z} {seed}");
                }
            }
        }
        assert!(by_first > 30 && unlike > 5, "{by_first} {unlike}");
    }
}
