//! Random numbers from a seed.

/// SplitMix64 (Steele, Lea and Flood 2014): a seed gives one sequence, on any machine.
pub struct Random(pub u64);

impl Random {
    /// The sequence of number `index` of `seed`; every (`seed`, `index`) has its own.
    pub fn of(seed: u64, index: u64) -> Random {
        let start = Random(seed).bits();
        Random(Random(start ^ index).bits())
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// Log-uniform.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        self.within(low.ln(), high.ln()).exp()
    }

    pub fn chance(&mut self, share: f64) -> bool {
        self.within(0.0, 1.0) < share
    }

    /// `1..=count`.
    pub fn one_of(&mut self, count: u32) -> u32 {
        1 + (self.bits() % u64::from(count)) as u32
    }

    pub fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.one_of(choices.len() as u32) as usize - 1]
    }
}

/// The first with a probability of a half.
pub fn either<T>(random: &mut Random, [one, other]: [T; 2]) -> T {
    if random.chance(0.5) { one } else { other }
}
