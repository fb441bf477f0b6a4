//! A point of a profile trace, whatever kind of file it stands in.

use gearlash::gear::Flank;

/// A point of a trace.
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
