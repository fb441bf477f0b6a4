//! Shifts of the outlines' centres by the eccentricities in a direction, throughout a cycle.

use super::super::shape::{C, turn};
use super::mesh_cycle::{CycleSide, PARTS, PosedSide};
use std::f64::consts::TAU;

/// Values at both ends of a pitch and between its parts.
type Ends<T = f64> = [T; PARTS + 1];

/// The shift of the centres along a direction: the contributions of the locked and of the free gear's turn.
#[derive(Debug)]
pub(super) struct CentreShift([Vec<Ends>; 2]);

impl CentreShift {
    /// The shift along `toward`, times its length, of a side that is `posed` at the start of the cycle, with the free gear at `gap`.
    pub fn new(side: &CycleSide, posed: &PosedSide, gap: f64, toward: C) -> CentreShift {
        let problem = side.problem;
        let locked = posed.flanks.centre - C::from(problem.distance);
        let free = -posed.flanks.free_centre * turn(gap);
        let of = |at: C, sense: f64, count: i64| -> Vec<Ends> {
            if at == C::ZERO {
                return vec![[0.0; PARTS + 1]; count as usize];
            }
            let turned = |pitches: f64| turn(sense * TAU * pitches / count as f64);
            // Whole pitches and parts are turned in sequence, which differs by rounding alone.
            let parts: Ends<C> =
                std::array::from_fn(|part| toward.conj() * turned(part as f64 / PARTS as f64));
            let ends = |index: i64| {
                let shifted = at * turned(index as f64);
                parts.map(|part| (part * shifted).re)
            };
            (0..count).map(ends).collect()
        };
        CentreShift([
            of(locked, side.sense, problem.locked.count()),
            of(free, -side.sense, problem.free.count()),
        ])
    }

    /// The sum of both.
    pub fn plus(mut self, other: &CentreShift) -> CentreShift {
        for (own, other) in self.0.iter_mut().zip(&other.0) {
            for (own, other) in own.iter_mut().flatten().zip(other.iter().flatten()) {
                *own += other;
            }
        }
        self
    }

    /// The values throughout a mating.
    pub fn at(&self, mating: u64) -> Ends {
        let [locked, free] = &self.0;
        let x = &locked[(mating % locked.len() as u64) as usize];
        let y = &free[(mating % free.len() as u64) as usize];
        std::array::from_fn(|end| x[end] + y[end])
    }
}
