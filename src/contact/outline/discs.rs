//! A tree of discs around runs of the chords of a half tooth. It saves the certificate of outlines from examining every chord.
//!
//! An outline can have tens of thousands of segments per tooth, and without the tree each pair of segments would be examined.

use crate::contact::gap::C;
use std::ops::Range;

/// Chords of a run that is not divided (tuned: for fewer the tree takes longer than the chords).
const FEWEST: usize = 8;

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

/// Discs around the chords of a path in order, and around runs of them.
#[derive(Debug)]
pub(super) struct Discs(Vec<Run>);

#[derive(Debug)]
struct Run {
    disc: Disc,
    /// Its first chord, and its number of chords.
    first: u32,
    count: u32,
    /// The second of its two runs, the first of which follows it; 0 if it is not divided.
    second: u32,
}

/// The content of a run.
#[derive(Debug, PartialEq)]
pub(super) enum Inside {
    /// These chords.
    Chords(Range<usize>),
    /// Two runs.
    Runs([usize; 2]),
}

impl Discs {
    /// The tree over the discs of chords, in order.
    pub fn new(chords: &[Disc]) -> Discs {
        let mut runs = Vec::with_capacity(chords.len() / 2);
        if !chords.is_empty() {
            add(&mut runs, chords, 0);
        }
        Discs(runs)
    }

    /// The run of all chords, if there are any.
    pub fn whole(&self) -> Option<usize> {
        (!self.0.is_empty()).then_some(0)
    }

    /// The disc around a run.
    #[inline]
    pub fn disc(&self, run: usize) -> &Disc {
        &self.0[run].disc
    }

    /// The content of a run.
    #[inline]
    pub fn inside(&self, run: usize) -> Inside {
        let Run {
            first,
            count,
            second,
            ..
        } = self.0[run];
        match second {
            0 => Inside::Chords(first as usize..(first + count) as usize),
            _ => Inside::Runs([run + 1, second as usize]),
        }
    }
}

/// Adds the run of these chords, followed by its content.
fn add(runs: &mut Vec<Run>, chords: &[Disc], first: u32) -> Disc {
    let place = runs.len();
    runs.push(Run {
        disc: chords[0],
        first,
        count: chords.len() as u32,
        second: 0,
    });
    let disc = if chords.len() <= FEWEST {
        let rest = chords[1..].iter();
        rest.fold(chords[0], |round, chord| round.round(chord))
    } else {
        let (one, other) = chords.split_at(chords.len() / 2);
        let round = add(runs, one, first);
        runs[place].second = runs.len() as u32;
        round.round(&add(runs, other, first + one.len() as u32))
    };
    runs[place].disc = disc;
    disc
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every run's disc contains those of all its chords, and the undivided runs have each chord once, in order.
    #[test]
    fn a_run_is_round_all_its_chords() {
        assert_eq!(Discs::new(&[]).whole(), None);
        for count in [1u32, 8, 9, 100] {
            let chords = (0..count).map(|k| Disc {
                middle: C::from_polar(30.0 + (0.7 * f64::from(k)).sin(), 0.02 * f64::from(k)),
                radius: 0.3 + 0.2 * (1.9 * f64::from(k)).cos(),
            });
            let chords: Vec<Disc> = chords.collect();
            let discs = Discs::new(&chords);
            let (mut open, mut seen) = (vec![discs.whole().unwrap()], Vec::new());
            while let Some(run) = open.pop() {
                let all = &discs.0[run];
                let own = all.first as usize..(all.first + all.count) as usize;
                for chord in &chords[own.clone()] {
                    let off = (chord.middle - all.disc.middle).norm() + chord.radius;
                    assert!(off <= all.disc.radius + 1e-12, "{count} {run}");
                }
                match discs.inside(run) {
                    Inside::Chords(range) => {
                        assert_eq!(range, own);
                        seen.extend(range);
                    }
                    Inside::Runs([one, other]) => open.extend([other, one]),
                }
            }
            assert_eq!(seen, (0..chords.len()).collect::<Vec<_>>());
        }
    }
}
