//! Random numbers with random access: number i of assembly n does not depend on any other draw.
//!
//! ChaCha with 8 rounds in its counter mode. The key is the seed and the kind of sample, and the stream is the number of the assembly. Each
//! quantity has its own stretch of the stream. So any number is drawn without the previous ones, with the same result in any order.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

/// One draw of a population: an assembly, and its purpose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Draw {
    /// The seed; another one gives another population.
    pub seed: u64,
    /// Its purpose.
    pub sample: SampleKind,
    /// The number of the assembly, from 1.
    pub number: u64,
}

/// Purpose of a sample of assemblies. Each purpose has its own numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SampleKind {
    /// The population.
    Population,
    /// The first of two independent samples for contributions.
    First,
    /// The second of them.
    Second,
}

/// Blocks of 64 bytes per quantity: more than the numbers of any gear.
const BLOCKS: u64 = 1 << 32;

impl Draw {
    /// The numbers of one quantity.
    pub(super) fn stream(&self, quantity: u32) -> Stream {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&self.seed.to_le_bytes());
        key[8] = self.sample as u8;
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

    /// Seed, sample, assembly and quantity never share a number, and no number depends on earlier draws.
    #[test]
    fn every_draw_has_numbers_of_its_own() {
        let mut seen = std::collections::HashSet::new();
        use SampleKind::{First, Population, Second};
        let samples = [Population, First, Second];
        for (seed, sample, number) in (0..3)
            .flat_map(|seed| samples.map(|sample| (seed, sample)))
            .flat_map(|(seed, sample)| [1, 2, u64::MAX].map(|number| (seed, sample, number)))
        {
            let draw = Draw {
                seed,
                sample,
                number,
            };
            for quantity in 0..3 {
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
