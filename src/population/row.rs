//! One assembly of a run, reduced to the data of its statistics.
//!
//! Lengths are whole tenths of a nanometre, a tenth of the width of a proven bracket. Sums of integers do not depend on
//! their order, so rows computed anywhere give the same statistics to the last bit.

use super::assembly::{Outcome, OutcomeKind};
use super::requirement::Standing;
use super::spread::tenths;

/// One assembly of a run.
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
    pub(super) fn rank(&self) -> Option<i64> {
        match self.kind {
            OutcomeKind::Jammed | OutcomeKind::NoContact => Some(i64::MIN),
            OutcomeKind::Unproven | OutcomeKind::Impossible => None,
            OutcomeKind::Clear | OutcomeKind::Interference => self.margin,
        }
    }

    /// Whether the assembly misses the requirement. An assembly without a result does.
    pub(super) fn is_outside(&self) -> bool {
        let has_result = !matches!(self.kind, OutcomeKind::Unproven | OutcomeKind::Impossible);
        self.is_below || self.is_above || !has_result
    }

    /// Whether it has an unproven extreme.
    pub(super) fn is_doubtful(&self) -> bool {
        (self.least.is_some() || self.greatest.is_some()) && !self.is_proven
    }
}
