//! Populations of pair files: from `[tolerance]` to rows, and from rows to the result of a run.

mod gears;
mod population;
mod result;
mod rows;
mod run;
mod sentence;
mod worst;

pub(crate) use gears::{GroupedWarnings, middle};
pub(crate) use population::{placed, shape_difference};
pub(crate) use result::limits;
pub(crate) use worst::sha256;

pub use gears::named;
pub use population::{ToleranceFile, read_tolerance};
pub use result::{About, Convergence, Limit, ToleranceResult, required_ends};
pub use rows::{RowsHead, RowsReader, RowsTally, row_line, tenths_to_um};
pub use run::{BLOCK, Tick, ToleranceRun, TooManyImpossible};
pub use sentence::{phases_of_limits, sentence, shares, without_backlash, without_worst_case};
pub use worst::{Worst, is_worst_file, worst_file, worst_name};

/// Most assemblies of a run.
pub const MAX_ASSEMBLIES: u64 = 1_000_000_000;
