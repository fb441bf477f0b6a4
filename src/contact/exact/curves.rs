//! Sets of pairs of curves, and their names in errors.

use crate::gear::ProfilePart;
use std::array::from_fn;

/// A set of pairs of curves, the locked gear's first.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct CurvePairs(pub [[bool; 4]; 4]);

impl CurvePairs {
    /// Every pair.
    pub const ALL: CurvePairs = CurvePairs([[true; 4]; 4]);

    /// This set without one pair.
    pub fn without(mut self, locked: ProfilePart, free: ProfilePart) -> CurvePairs {
        self.0[locked as usize][free as usize] = false;
        self
    }

    /// Every pair that contains a curve of this kind, on either gear.
    pub fn of(part: ProfilePart) -> CurvePairs {
        let part = part as usize;
        let one = |locked, free| locked == part || free == part;
        CurvePairs(from_fn(|locked| from_fn(|free| one(locked, free))))
    }

    /// This set without `others`.
    pub fn except(self, others: CurvePairs) -> CurvePairs {
        let one = |locked: usize, free: usize| self.0[locked][free] && !others.0[locked][free];
        CurvePairs(from_fn(|locked| from_fn(|free| one(locked, free))))
    }

    /// The pairs in both sets.
    pub fn intersection(self, others: CurvePairs) -> CurvePairs {
        let one = |locked: usize, free: usize| self.0[locked][free] && others.0[locked][free];
        CurvePairs(from_fn(|locked| from_fn(|free| one(locked, free))))
    }

    pub fn has(self, locked: ProfilePart, free: ProfilePart) -> bool {
        self.0[locked as usize][free as usize]
    }

    pub fn add(&mut self, locked: ProfilePart, free: ProfilePart) {
        self.0[locked as usize][free as usize] = true;
    }

    pub fn add_unless(&mut self, settled: bool, locked: ProfilePart, free: ProfilePart) {
        self.0[locked as usize][free as usize] |= !settled;
    }

    pub fn is_empty(self) -> bool {
        self == CurvePairs::default()
    }
}

/// Two curves whose search did not end, the locked gear's first.
#[derive(Debug)]
pub(super) struct SearchExhausted(pub ProfilePart, pub ProfilePart);

impl SearchExhausted {
    /// The reason in words, for the error message.
    pub fn reason(&self) -> &'static str {
        const REASONS: [[&str; 4]; 4] = [
            [
                "locked tip land on free tip land: not settled",
                "locked tip land on free involute: not settled",
                "locked tip land on free fillet: not settled",
                "locked tip land on free root land: not settled",
            ],
            [
                "locked involute on free tip land: not settled",
                "locked involute on free involute: not settled",
                "locked involute on free fillet: not settled",
                "locked involute on free root land: not settled",
            ],
            [
                "locked fillet on free tip land: not settled",
                "locked fillet on free involute: not settled",
                "locked fillet on free fillet: not settled",
                "locked fillet on free root land: not settled",
            ],
            [
                "locked root land on free tip land: not settled",
                "locked root land on free involute: not settled",
                "locked root land on free fillet: not settled",
                "locked root land on free root land: not settled",
            ],
        ];
        REASONS[self.0 as usize][self.1 as usize]
    }
}
