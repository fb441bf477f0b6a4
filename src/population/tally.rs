//! Rows of single assemblies, and sums over them.

use super::assembly::{Outcome, OutcomeKind};
use super::requirement::Standing;
use super::spread::{Overflow, Spread, tenths};
use std::collections::BTreeSet;

/// Number of the worst assemblies that are kept.
pub const WORST_KEPT: usize = 10;

/// Number of equal stretches of the assemblies, each with a count of those outside the requirement.
pub const STRETCHES: usize = 64;

/// One assembly of a run, reduced to the data of its statistics.
///
/// Lengths are whole tenths of a nanometre, a tenth of the width of a proven bracket. Sums of integers do not depend on their order, so rows
/// computed anywhere give the same statistics to the last bit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Row {
    /// Number of the assembly, from 1.
    pub number: u64,
    /// Its kind.
    pub kind: OutcomeKind,
    /// Least `j_wt` over the mesh cycle, tenths of a nanometre.
    pub least: Option<i64>,
    /// Greatest `j_wt`, tenths of a nanometre.
    pub greatest: Option<i64>,
    /// Whether all its extremes are proven; `false` without any.
    pub is_proven: bool,
    /// Whether a quantity is below its lower limit.
    pub is_below: bool,
    /// Whether a quantity is above its upper limit.
    pub is_above: bool,
    /// Distance to the nearest limit, tenths of a nanometre. `None` without a limit or a value.
    pub margin: Option<i64>,
}

impl Row {
    /// The row of assembly `number` with its `outcome` and `standing`.
    pub fn new(number: u64, outcome: &Outcome, standing: &Standing) -> Row {
        Row {
            number,
            kind: outcome.kind,
            least: outcome.least.map(tenths),
            greatest: outcome.greatest.map(tenths),
            is_proven: outcome.is_proven,
            is_below: standing.below,
            is_above: standing.above,
            margin: standing.margin,
        }
    }

    /// The rank of the assembly among the worst: the least is the worst. Jammed and out of mesh come first; `None` without a margin.
    fn rank(&self) -> Option<i64> {
        match self.kind {
            OutcomeKind::Jammed | OutcomeKind::NoContact => Some(i64::MIN),
            OutcomeKind::Unproven | OutcomeKind::Impossible => None,
            OutcomeKind::Clear | OutcomeKind::Interference => self.margin,
        }
    }

    /// Whether the assembly misses the requirement. An assembly without a result does.
    fn is_outside(&self) -> bool {
        let has_result = !matches!(self.kind, OutcomeKind::Unproven | OutcomeKind::Impossible);
        self.is_below || self.is_above || !has_result
    }

    /// Whether it has an unproven extreme.
    fn is_doubtful(&self) -> bool {
        (self.least.is_some() || self.greatest.is_some()) && !self.is_proven
    }
}

/// Number of assemblies of each kind.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Counts([u64; OutcomeKind::ALL.len()]);

impl Counts {
    /// All kinds.
    pub fn total(&self) -> u64 {
        self.0.iter().sum()
    }

    /// Number of assemblies of this kind.
    pub fn of(&self, kind: OutcomeKind) -> u64 {
        self.0[kind as usize]
    }
}

/// Sums over the assemblies of one run, independent of their order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tally {
    /// Kinds of the assemblies.
    pub counts: Counts,
    /// Assemblies with an unproven extreme.
    pub doubtful: u64,
    /// Assemblies below a lower limit.
    pub below: u64,
    /// Assemblies above an upper limit.
    pub above: u64,
    /// Assemblies that do not meet the requirement: below, above, or without a result.
    pub outside: u64,
    /// Their number in each of [`STRETCHES`] equal stretches of the run.
    pub outside_by_stretch: Vec<u64>,
    /// Least `j_wt` of each assembly.
    pub least: Spread,
    /// Greatest `j_wt` of each assembly.
    pub greatest: Spread,
    /// The [`WORST_KEPT`] assemblies: margin to the nearest limit, tenths of a nanometre, and number. Jammed and out of mesh have `i64::MIN`.
    pub worst: BTreeSet<(i64, u64)>,
    /// The first impossible assembly.
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
    /// Adds `row`, one of a run of `total` assemblies.
    ///
    /// # Errors
    /// [`Overflow`].
    pub fn add(&mut self, row: &Row, total: u64) -> Result<(), Overflow> {
        self.counts.0[row.kind as usize] += 1;
        self.doubtful += u64::from(row.is_doubtful());
        self.below += u64::from(row.is_below);
        self.above += u64::from(row.is_above);
        let outside = u64::from(row.is_outside());
        self.outside += outside;
        let stretch =
            u128::from(row.number.saturating_sub(1)) * STRETCHES as u128 / u128::from(total.max(1));
        if let Some(count) = self.outside_by_stretch.get_mut(stretch as usize) {
            *count += outside;
        }
        if let Some(least) = row.least {
            self.least.add(least, row.number)?;
        }
        if let Some(greatest) = row.greatest {
            self.greatest.add(greatest, row.number)?;
        }
        if let Some(rank) = row.rank() {
            self.worst.insert((rank, row.number));
            if self.worst.len() > WORST_KEPT {
                self.worst.pop_last();
            }
        }
        if row.kind == OutcomeKind::Impossible {
            let first = self.first_impossible.unwrap_or(row.number);
            self.first_impossible = Some(first.min(row.number));
        }
        Ok(())
    }
}
