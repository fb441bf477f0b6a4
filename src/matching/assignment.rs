//! Which wheel goes with which pinion.

use super::matrix::{MOST_STEPS, Matrix};
use pathfinding::kuhn_munkres::kuhn_munkres;
use pathfinding::matrix::Matrix as Weights;

/// Gears of a kind up to which the assignment is the best there is (the method takes their number cubed: some seconds). With more it is a
/// start that takes the nearest pair first.
pub const MOST_EXACT: usize = 1000;

/// Which gears go together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Assignment {
    /// Wheel and pinion of each pair within what is required, both from 0, in the order of the wheels.
    pub pairs: Vec<(usize, usize)>,
    /// Whether no other assignment has more pairs, or as many that come nearer to what is wanted.
    pub is_best: bool,
}

impl Matrix {
    /// The pairs that assemble the most within what is required and, among those, whose backlash is nearest to what is wanted in sum.
    pub fn assign(&self) -> Assignment {
        let [wheels, pinions] = self.size();
        let mut pairs = match wheels.max(pinions) <= MOST_EXACT {
            true => self.best(),
            false => self.nearest_first(),
        };
        pairs.retain(|(wheel, pinion)| self.meets(*wheel, *pinion));
        pairs.sort_unstable();
        Assignment {
            pairs,
            is_best: wheels.max(pinions) <= MOST_EXACT,
        }
    }

    fn meets(&self, wheel: usize, pinion: usize) -> bool {
        self.pair_fit(wheel, pinion)
            .is_some_and(|meeting| meeting.best.meets)
    }

    fn steps(&self, wheel: usize, pinion: usize) -> i64 {
        let meeting = self.pair_fit(wheel, pinion);
        meeting.map_or(MOST_STEPS, |meeting| meeting.best.steps())
    }

    /// One more pair weighs more than all distances together.
    fn best(&self) -> Vec<(usize, usize)> {
        let [wheels, pinions] = self.size();
        if self.most() == 0 {
            return Vec::new();
        }
        let one = MOST_STEPS * (self.most() as i64 + 1);
        let weight = |wheel: usize, pinion: usize| match self.meets(wheel, pinion) {
            true => one - self.steps(wheel, pinion),
            false => 0,
        };
        // Rows are no more than columns.
        match wheels <= pinions {
            true => {
                let weights = Weights::from_fn(wheels, pinions, |(w, p)| weight(w, p));
                kuhn_munkres(&weights).1.into_iter().enumerate().collect()
            }
            false => {
                let weights = Weights::from_fn(pinions, wheels, |(p, w)| weight(w, p));
                let found = kuhn_munkres(&weights).1.into_iter().enumerate();
                found.map(|(pinion, wheel)| (wheel, pinion)).collect()
            }
        }
    }

    fn nearest_first(&self) -> Vec<(usize, usize)> {
        let [wheels, pinions] = self.size();
        let places = (0..wheels).flat_map(|wheel| (0..pinions).map(move |pinion| (wheel, pinion)));
        let mut places: Vec<(usize, usize)> = places
            .filter(|(wheel, pinion)| self.meets(*wheel, *pinion))
            .collect();
        places.sort_by_key(|(wheel, pinion)| (self.steps(*wheel, *pinion), *wheel, *pinion));
        let mut free = [vec![true; wheels], vec![true; pinions]];
        places.retain(|(wheel, pinion)| {
            let both = free[0][*wheel] && free[1][*pinion];
            if both {
                free[0][*wheel] = false;
                free[1][*pinion] = false;
            }
            both
        });
        places
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::matching::{Fit, PairFit};
    use crate::population::{Outcome, OutcomeKind};
    use proptest::prelude::*;

    /// A matrix of distances from what is wanted, µm; `None`: beyond what is required.
    fn matrix(wheels: usize, pinions: usize, off_um: &[Option<u32>]) -> Matrix {
        let cell = |off: &Option<u32>| PairFit {
            best: Fit {
                pinion_tooth: 1,
                outcome: Outcome {
                    kind: OutcomeKind::Clear,
                    least: Some(0.0),
                    greatest: Some(0.0),
                    is_proven: true,
                },
                meets: off.is_some(),
                off: off.map_or(1.0, |um| 1e-3 * f64::from(um)),
            },
            meeting: u32::from(off.is_some()),
        };
        Matrix {
            wheels,
            pinions,
            cells: off_um.iter().map(cell).collect(),
            phases: 1,
            thicknesses: [vec![1.0; wheels], vec![1.0; pinions]],
        }
    }

    /// Pairs and the sum of their distances, of the best of all ways to give wheels from `wheel` on a pinion that is free.
    fn brute(matrix: &Matrix, wheel: usize, free: u32) -> (usize, i64) {
        if wheel == matrix.wheels {
            return (0, 0);
        }
        let mut best = brute(matrix, wheel + 1, free);
        for pinion in 0..matrix.pinions {
            if free & 1 << pinion != 0 && matrix.meets(wheel, pinion) {
                let (pairs, off) = brute(matrix, wheel + 1, free & !(1 << pinion));
                let here = (pairs + 1, off + matrix.steps(wheel, pinion));
                if here.0 > best.0 || here.0 == best.0 && here.1 < best.1 {
                    best = here;
                }
            }
        }
        best
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        /// Against every way there is.
        #[test]
        fn no_other_assignment_is_better(
            wheels in 1..7usize,
            pinions in 1..7usize,
            off in prop::collection::vec(prop::option::weighted(0.5, 0..50u32), 36),
        ) {
            let matrix = matrix(wheels, pinions, &off[..wheels * pinions]);
            let found = matrix.assign();
            let sum: i64 = found.pairs.iter().map(|(w, p)| matrix.steps(*w, *p)).sum();
            prop_assert_eq!((found.pairs.len(), sum), brute(&matrix, 0, u32::MAX));
            prop_assert!(found.is_best);
        }

        /// The start for many gears: each gear once, only pairs that meet, and none left over that could be added.
        #[test]
        fn nearest_first_leaves_no_pair_over(
            off in prop::collection::vec(prop::option::weighted(0.5, 0..50u32), 64),
        ) {
            let matrix = matrix(8, 8, &off);
            let pairs = matrix.nearest_first();
            for (index, (wheel, pinion)) in pairs.iter().enumerate() {
                prop_assert!(matrix.meets(*wheel, *pinion));
                prop_assert!(pairs[..index].iter().all(|other| other.0 != *wheel && other.1 != *pinion));
            }
            for wheel in (0..8).filter(|wheel| pairs.iter().all(|pair| pair.0 != *wheel)) {
                for pinion in (0..8).filter(|pinion| pairs.iter().all(|pair| pair.1 != *pinion)) {
                    prop_assert!(!matrix.meets(wheel, pinion));
                }
            }
        }
    }

    /// As many as eight of each, in 500 random matrices, against every way (8 × 8 with half of the pairs allowed).
    #[test]
    fn eight_by_eight() {
        let mut state = 1u64;
        let mut next = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as u32
        };
        for _ in 0..500 {
            let off: Vec<Option<u32>> = (0..64)
                .map(|_| (next() % 3 != 0).then(|| next() % 40))
                .collect();
            let matrix = matrix(8, 8, &off);
            let found = matrix.assign();
            let sum: i64 = found.pairs.iter().map(|(w, p)| matrix.steps(*w, *p)).sum();
            assert_eq!((found.pairs.len(), sum), brute(&matrix, 0, 0xff));
        }
    }
}
