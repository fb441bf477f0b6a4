//! Work, counted: so a search that is cut short ends at the same place on any machine and on any number of threads.
//!
//! A unit is a node of the branch and bound over pairs of curves ([`super::gap`]), some 0.3 µs. What else takes time counts as many units as it takes
//! nodes' time.

use crate::pair::GearPair;
use std::cell::Cell;

/// Of one pose (tuned): below 0.1 s where the costliest units take up to 0.6 µs, those of helical pairs on a busy machine.
const OF_POSE: u64 = 150_000;

/// What a search may still do.
#[derive(Debug)]
pub(crate) struct Effort {
    most: u64,
    left: Cell<u64>,
}

impl Effort {
    /// So many units.
    pub fn new(most: u64) -> Effort {
        Effort {
            most,
            left: Cell::new(most),
        }
    }

    /// Of one pose, by all methods it is found and checked by, over all sections of a face.
    pub fn of_pose() -> Effort {
        Effort::new(OF_POSE)
    }

    /// Of the extremes of a pair over one mesh cycle, with the distance up to which it is in mesh, and of helical pairs that from which it
    /// assembles (tuned: some 2 s of spur pairs, 5 to 10 s of helical ones).
    pub fn of_extremes(assembly: &GearPair) -> Effort {
        Effort::new(if assembly.is_helical() {
            9_000_000
        } else {
            6_000_000
        })
    }

    /// Of what is left, one part in `parts`; what is used of it has still to be spent of the whole.
    pub fn part(&self, parts: u64) -> Effort {
        Effort::new(self.left() / parts)
    }

    /// Without end: to check others by.
    pub fn endless() -> Effort {
        Effort::new(u64::MAX)
    }

    /// Takes `units`, or all that is left.
    pub fn spend(&self, units: u64) {
        self.left.set(self.left().saturating_sub(units));
    }

    pub fn left(&self) -> u64 {
        self.left.get()
    }

    pub fn used(&self) -> u64 {
        self.most - self.left()
    }

    /// Whether so little is left that another search would find nothing more: a hundredth.
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

    /// What is used of a part is not taken twice, and nothing falls below none.
    #[test]
    fn effort_ends_at_none() {
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
