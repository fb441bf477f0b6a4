//! What a reader asks of a table, and what it gets a tooth or a point.

use super::column::Column;
use gearlash::gear::Flank;

/// What a reader needs of a table.
#[derive(Debug, Clone, Copy)]
pub struct Wanted<const N: usize> {
    /// The columns beside the tooth, in the order in which the values come back.
    pub columns: [Column; N],
    /// `z`, where it is known.
    pub teeth: Option<u32>,
    /// Which teeth must be there.
    pub coverage: Coverage,
}

/// Which teeth a table must have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Coverage {
    /// Every tooth, exactly once.
    EveryTooth,
    /// Some teeth, each at most once.
    SomeTeeth,
}

/// What a table says of one tooth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row<const N: usize> {
    /// The line it stands in.
    pub line: u64,
    /// The tooth.
    pub tooth: u32,
    /// The values, in the order of [`Wanted::columns`] and in their units.
    pub values: [f64; N],
}

/// A point of a profile trace, whatever kind of file it stands in.
#[derive(Debug, Clone, PartialEq)]
pub struct TraceRow {
    /// The line it stands in.
    pub line: u64,
    pub tooth: Option<u32>,
    pub flank: Option<Flank>,
    /// Roll length or diameter, mm.
    pub at_mm: f64,
    pub deviation_um: f64,
}
