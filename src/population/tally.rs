//! What comes of many assemblies, added up.

use super::assembly::{Outcome, OutcomeKind};
use super::requirement::Standing;
use super::spread::{Overflow, Spread};
use std::collections::BTreeSet;

/// How many of the worst assemblies are kept in mind.
pub const WORST: usize = 10;

/// Stretches of equal numbers of assemblies that those beyond the requirement are counted in.
pub const STRETCHES: usize = 64;

/// How many assemblies end in which way.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Counts {
    /// Some backlash at every pose.
    pub clear: u64,
    /// Less than none at a pose.
    pub interference: u64,
    /// Teeth across each other at a pose.
    pub jammed: u64,
    /// Nothing to touch at a pose.
    pub out_of_mesh: u64,
    /// No extreme was found.
    pub unproven: u64,
    /// Of no gear, or of no pair.
    pub impossible: u64,
}

impl Counts {
    /// All.
    pub fn total(&self) -> u64 {
        self.clear
            + self.interference
            + self.jammed
            + self.out_of_mesh
            + self.unproven
            + self.impossible
    }

    fn of(&mut self, kind: OutcomeKind) -> &mut u64 {
        match kind {
            OutcomeKind::Clear => &mut self.clear,
            OutcomeKind::Interference => &mut self.interference,
            OutcomeKind::Jammed => &mut self.jammed,
            OutcomeKind::OutOfMesh => &mut self.out_of_mesh,
            OutcomeKind::Unproven => &mut self.unproven,
            OutcomeKind::Impossible => &mut self.impossible,
        }
    }

    fn add(&mut self, other: &Counts) {
        self.clear += other.clear;
        self.interference += other.interference;
        self.jammed += other.jammed;
        self.out_of_mesh += other.out_of_mesh;
        self.unproven += other.unproven;
        self.impossible += other.impossible;
    }
}

/// Sums over assemblies of one population. Sums over different assemblies add up to those over all, whichever way they were cut.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tally {
    /// How they end.
    pub counts: Counts,
    /// Those whose least or greatest is the best that was found, and not proven.
    pub doubtful: u64,
    /// Those with less than the requirement at a pose.
    pub below: u64,
    /// Those with more.
    pub above: u64,
    /// Those that do not meet it: below, above, or nothing was found.
    pub outside: u64,
    /// How many of them in each of [`STRETCHES`] equal parts of all assemblies.
    pub outside_by_stretch: Vec<u64>,
    /// Least `j_wt` of each.
    pub least: Spread,
    /// Greatest `j_wt` of each.
    pub greatest: Spread,
    /// The [`WORST`] of them: what each has left to the nearer limit, tenths of a nanometre (`i64::MIN` where it is jammed or out of mesh), and its
    /// number.
    pub worst: BTreeSet<(i64, u64)>,
    /// The first that is impossible.
    pub first_impossible: Option<u64>,
}

impl Default for Tally {
    fn default() -> Tally {
        Tally {
            counts: Counts::default(),
            doubtful: 0,
            below: 0,
            above: 0,
            outside: 0,
            outside_by_stretch: vec![0; STRETCHES],
            least: Spread::default(),
            greatest: Spread::default(),
            worst: BTreeSet::new(),
            first_impossible: None,
        }
    }
}

impl Tally {
    /// Adds assembly `number` of `total`, which ends and stands to what is required as said.
    ///
    /// # Errors
    /// [`Overflow`].
    pub fn count(
        &mut self,
        outcome: &Outcome,
        standing: &Standing,
        number: u64,
        total: u64,
    ) -> Result<(), Overflow> {
        *self.counts.of(outcome.kind) += 1;
        let has_value = outcome.least.is_some() || outcome.greatest.is_some();
        self.doubtful += u64::from(has_value && !outcome.is_proven);
        let (below, above) = (standing.below, standing.above);
        let nothing = matches!(
            outcome.kind,
            OutcomeKind::Unproven | OutcomeKind::Impossible
        );
        let outside = u64::from(below || above || nothing);
        self.below += u64::from(below);
        self.above += u64::from(above);
        self.outside += outside;
        let stretch = u128::from(number - 1) * STRETCHES as u128 / u128::from(total);
        if let Some(count) = self.outside_by_stretch.get_mut(stretch as usize) {
            *count += outside;
        }
        if let Some(least) = outcome.least {
            self.least.add(&Spread::of_one(least, number)?)?;
        }
        if let Some(greatest) = outcome.greatest {
            self.greatest.add(&Spread::of_one(greatest, number)?)?;
        }
        if let Some(margin) = standing.margin {
            self.worst.insert((margin, number));
            self.keep_worst();
        }
        if outcome.kind == OutcomeKind::Impossible {
            self.first_impossible = first(self.first_impossible, Some(number));
        }
        Ok(())
    }

    /// Adds the sums over other assemblies of the same population.
    ///
    /// # Errors
    /// [`Overflow`].
    pub fn add(&mut self, other: &Tally) -> Result<(), Overflow> {
        self.counts.add(&other.counts);
        self.doubtful += other.doubtful;
        self.below += other.below;
        self.above += other.above;
        self.outside += other.outside;
        let stretches = self.outside_by_stretch.iter_mut();
        for (sum, other) in stretches.zip(&other.outside_by_stretch) {
            *sum += other;
        }
        self.least.add(&other.least)?;
        self.greatest.add(&other.greatest)?;
        self.worst.extend(&other.worst);
        self.keep_worst();
        self.first_impossible = first(self.first_impossible, other.first_impossible);
        Ok(())
    }

    fn keep_worst(&mut self) {
        while self.worst.len() > WORST {
            self.worst.pop_last();
        }
    }
}

fn first(one: Option<u64>, other: Option<u64>) -> Option<u64> {
    one.into_iter().chain(other).min()
}
