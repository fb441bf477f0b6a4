//! Random numbers that depend on nothing but what they are for.
//!
//! ChaCha with 8 rounds in its counter mode: the key is the seed and the run, the stream the number of the assembly, and each quantity has
//! a stretch of the stream that no other reaches. So any number of any assembly is had without those before it, and whoever draws it,
//! in whatever order, draws the same.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

/// One draw of a population: an assembly, and what it is drawn for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Draw {
    /// Another seed, another population.
    pub seed: u64,
    /// The run that it belongs to.
    pub run: Run,
    /// The number of the assembly, from 1.
    pub number: u64,
}

/// Purpose of a sample of assemblies. Each purpose has numbers of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Run {
    /// The population.
    Population,
    /// One of two independent samples that contributions are found from.
    First,
    /// The other.
    Second,
}

/// Blocks of 64 bytes that a quantity has: more than any gear has numbers.
const BLOCKS: u64 = 1 << 32;

impl Draw {
    /// The numbers of one quantity.
    pub(super) fn stream(&self, quantity: u32) -> Stream {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&self.seed.to_le_bytes());
        key[8] = self.run as u8;
        key[16..24].copy_from_slice(b"gearlash");
        let mut generator = ChaCha8Rng::from_seed(key);
        generator.set_stream(self.number);
        generator.set_block_pos(u64::from(quantity) * BLOCKS);
        Stream(generator)
    }
}

/// Random numbers, one after the other.
pub(super) struct Stream(ChaCha8Rng);

impl Stream {
    /// Uniform in (0, 1), both ends excluded: the middle of one of 2^52 equal parts.
    pub fn uniform(&mut self) -> f64 {
        ((self.0.next_u64() >> 12) as f64 + 0.5) * (0.5f64).powi(52)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Neither seed, run, assembly nor quantity share a number, and none depends on what was drawn before.
    #[test]
    fn every_draw_has_numbers_of_its_own() {
        let mut seen = std::collections::HashSet::new();
        for seed in 0..3 {
            for run in [Run::Population, Run::First, Run::Second] {
                for number in [1, 2, u64::MAX] {
                    for quantity in 0..3 {
                        let draw = Draw { seed, run, number };
                        let mut stream = draw.stream(quantity);
                        for _ in 0..100 {
                            let uniform = stream.uniform();
                            assert!(0.0 < uniform && uniform < 1.0);
                            assert!(seen.insert(uniform.to_bits()));
                        }
                        let again = draw.stream(quantity).uniform();
                        assert!(seen.contains(&again.to_bits()));
                    }
                }
            }
        }
    }

    /// Mean 1/2 and variance 1/12, each within five standard errors.
    #[test]
    fn numbers_are_uniform() {
        let draw = Draw {
            seed: 7,
            run: Run::Population,
            number: 1,
        };
        let mut stream = draw.stream(0);
        let n = 100_000;
        let numbers: Vec<f64> = (0..n).map(|_| stream.uniform() - 0.5).collect();
        let mean = numbers.iter().sum::<f64>() / f64::from(n);
        let variance = numbers.iter().map(|x| x * x).sum::<f64>() / f64::from(n);
        let root = f64::from(n).sqrt();
        assert!(mean.abs() < 5.0 * (1.0f64 / 12.0).sqrt() / root);
        // The variance of (x − 1/2)² is 1/80 − 1/144.
        assert!((variance - 1.0 / 12.0).abs() < 5.0 * (1.0f64 / 180.0).sqrt() / root);
    }
}
