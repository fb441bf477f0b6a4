//! Discs around runs of the chords of a half tooth. A tree of them saves the certificate of outlines from examining every chord.
//!
//! An outline can have tens of thousands of segments per tooth, and without the tree each pair of segments would be examined.

use crate::contact::gap::{Bounding, C};

/// Rounding of a disc around two others, per greatest length: a dozen operations.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A disc, mm.
#[derive(Debug, Clone, Copy)]
pub(super) struct Disc {
    pub middle: C,
    pub radius: f64,
}

impl Disc {
    /// Whether it has no point in common with another.
    #[inline]
    pub fn is_apart(&self, other: &Disc) -> bool {
        let within = self.radius + other.radius;
        (self.middle - other.middle).norm_sqr() > within * within
    }
}

impl Bounding for Disc {
    /// Tuned: for fewer chords the tree takes longer than the chords.
    const FEWEST: usize = 8;

    /// The least disc around both.
    fn round(&self, other: &Disc) -> Disc {
        let between = other.middle - self.middle;
        let distance = between.norm();
        if distance + other.radius <= self.radius {
            return *self;
        }
        if distance + self.radius <= other.radius {
            return *other;
        }
        let radius = 0.5 * (distance + self.radius + other.radius);
        let middle = self.middle + between * ((radius - self.radius) / distance);
        Disc {
            middle,
            radius: radius + ROUNDING * (middle.norm() + radius),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::gap::{RunContent, Tree};
    use std::ops::Range;

    fn chords_of(discs: &Tree<Disc>, run: usize) -> Range<usize> {
        match discs.inside(run) {
            RunContent::Pieces([from, to]) => from..to,
            RunContent::Runs([one, other]) => {
                let (one, other) = (chords_of(discs, one), chords_of(discs, other));
                assert_eq!(one.end, other.start);
                one.start..other.end
            }
        }
    }

    /// Every run's disc contains those of all its chords, and the runs have each chord once, in order.
    #[test]
    fn a_run_is_round_all_its_chords() {
        assert_eq!(Tree::<Disc>::new(&[]).whole(), None);
        for count in [1u32, 8, 9, 100] {
            let chords = (0..count).map(|k| Disc {
                middle: C::from_polar(30.0 + (0.7 * f64::from(k)).sin(), 0.02 * f64::from(k)),
                radius: 0.3 + 0.2 * (1.9 * f64::from(k)).cos(),
            });
            let chords: Vec<Disc> = chords.collect();
            let discs = Tree::new(&chords);
            assert_eq!(chords_of(&discs, discs.whole().unwrap()), 0..chords.len());
            for (run, disc) in discs.shapes().enumerate() {
                for chord in &chords[chords_of(&discs, run)] {
                    let off = (chord.middle - disc.middle).norm() + chord.radius;
                    assert!(off <= disc.radius + 1e-12, "{count} {run}");
                }
            }
        }
    }
}
