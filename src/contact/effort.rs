//! Counted work. An interrupted search ends at the same place on any machine and with any number of threads.
//!
//! The unit is a node of the branch and bound over pairs of curves ([`super::gap`]), about 0.3 µs. Other work counts as
//! the number of nodes that take as long.

use crate::error::{Tick, go_on};
use crate::pair::GearPair;
use std::cell::Cell;

/// Budget of one pose (tuned): under 0.1 s, since the most expensive units take up to 0.6 µs for helical pairs on a busy machine.
const OF_POSE: u64 = 150_000;

/// Units between two ticks: a tenth of a second on slow machines.
const TICK: u64 = 100_000;

/// The remaining budget of a search. A break of its tick ends it.
pub(crate) struct Effort<'t> {
    most: u64,
    left: Cell<u64>,
    pub tick: &'t Tick<'t>,
    /// Units until the next tick.
    quiet: Cell<u64>,
}

impl<'t> Effort<'t> {
    /// A budget of `most` units.
    pub fn new(most: u64, tick: &'t Tick<'t>) -> Effort<'t> {
        Effort {
            most,
            left: Cell::new(most),
            tick,
            quiet: Cell::new(TICK),
        }
    }

    /// The budget of one pose, for all methods that find and check it in all sections of a face.
    pub fn of_pose() -> Effort<'t> {
        Effort::new(OF_POSE, &go_on)
    }

    /// The budget of the extremes of a pair over one mesh cycle. It includes the distance up to which the pair is in mesh, and for helical
    /// pairs the distance from which it assembles (tuned: about 2 s for spur pairs, 5 to 10 s for helical ones).
    pub fn of_extremes(assembly: &GearPair, tick: &'t Tick<'t>) -> Effort<'t> {
        let most = if assembly.varies_along_face() {
            9_000_000
        } else {
            6_000_000
        };
        Effort::new(most, tick)
    }

    /// One part in `parts` of the remaining budget. The caller must charge its use to the whole.
    pub fn part(&self, parts: u64) -> Effort<'t> {
        Effort::new(self.left() / parts, self.tick)
    }

    /// An unlimited budget, for reference methods.
    pub fn endless() -> Effort<'t> {
        Effort::new(u64::MAX, &go_on)
    }

    /// Subtracts `units`, or all that is left. Ticks after every tenth of a second of work, and has nothing left after a break.
    pub fn spend(&self, units: u64) {
        self.left.set(self.left().saturating_sub(units));
        if units < self.quiet.get() {
            self.quiet.set(self.quiet.get() - units);
            return;
        }
        self.quiet.set(TICK);
        if (self.tick)(0).is_break() {
            self.left.set(0);
        }
    }

    pub fn left(&self) -> u64 {
        self.left.get()
    }

    pub fn used(&self) -> u64 {
        self.most - self.left()
    }

    /// Whether less than a hundredth is left, too little for another search to find more.
    pub fn is_nearly_spent(&self) -> bool {
        self.left() <= self.most / 100
    }

    pub fn is_spent(&self) -> bool {
        self.left() == 0
    }
}

#[cfg(test)]
mod tests {
    use super::Effort;
    use crate::error::go_on;

    /// The use of a part is not charged twice, and the budget never falls below zero.
    #[test]
    fn effort_ends_at_zero() {
        let whole = Effort::new(100, &go_on);
        let part = whole.part(4);
        part.spend(20);
        assert_eq!((part.left(), part.used(), whole.left()), (5, 20, 100));
        whole.spend(part.used());
        assert_eq!(whole.left(), 80);
        part.spend(6);
        assert!(part.is_spent() && part.used() == 25 && !whole.is_spent());
    }
}
