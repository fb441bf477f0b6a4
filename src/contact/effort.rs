//! Counted work. An interrupted search ends at the same place on any machine and with any number of threads.
//!
//! The unit is a node of the branch and bound over pairs of curves ([`super::gap`]), about 0.3 µs. Other work counts as
//! the number of nodes that take as long.

use crate::pair::GearPair;
use std::cell::Cell;

/// Budget of one pose (tuned): under 0.1 s, since the most expensive units take up to 0.6 µs for helical pairs on a busy machine.
const OF_POSE: u64 = 150_000;

/// The remaining budget of a search.
#[derive(Debug)]
pub(crate) struct Effort {
    most: u64,
    left: Cell<u64>,
}

impl Effort {
    /// A budget of `most` units.
    pub fn new(most: u64) -> Effort {
        Effort {
            most,
            left: Cell::new(most),
        }
    }

    /// The budget of one pose, for all methods that find and check it in all sections of a face.
    pub fn of_pose() -> Effort {
        Effort::new(OF_POSE)
    }

    /// The budget of the extremes of a pair over one mesh cycle. It includes the distance up to which the pair is in mesh, and for helical
    /// pairs the distance from which it assembles (tuned: about 2 s for spur pairs, 5 to 10 s for helical ones).
    pub fn of_extremes(assembly: &GearPair) -> Effort {
        Effort::new(if assembly.varies_along_face() {
            9_000_000
        } else {
            6_000_000
        })
    }

    /// One part in `parts` of the remaining budget. The caller must charge its use to the whole.
    pub fn part(&self, parts: u64) -> Effort {
        Effort::new(self.left() / parts)
    }

    /// An unlimited budget, for reference methods.
    pub fn endless() -> Effort {
        Effort::new(u64::MAX)
    }

    /// Subtracts `units`, or all that is left.
    pub fn spend(&self, units: u64) {
        self.left.set(self.left().saturating_sub(units));
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

    /// The use of a part is not charged twice, and the budget never falls below zero.
    #[test]
    fn effort_ends_at_zero() {
        let whole = Effort::new(100);
        let part = whole.part(4);
        part.spend(20);
        assert_eq!((part.left(), part.used(), whole.left()), (5, 20, 100));
        whole.spend(part.used());
        assert_eq!(whole.left(), 80);
        part.spend(6);
        assert!(part.is_spent() && part.used() == 25 && !whole.is_spent());
    }
}
