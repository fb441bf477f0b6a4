//! Populations of pair files: from `[tolerance]` to rows, and from rows to the result of a run.

mod gears;
mod population;
mod result;
mod rows;
mod run;
mod sentence;
mod worst;

pub(crate) use gears::{GroupedLines, middle};
pub(crate) use population::{placed, shape_difference};
pub(crate) use result::limits;
pub(crate) use worst::sha256;

pub use crate::spec::MAX_ASSEMBLIES;
pub use gears::matching_files;
pub use population::{ToleranceFile, read_tolerance};
pub use result::{Convergence, Limit, PopulationSummary, ToleranceResult, required_ends};
pub use rows::{RowsHead, RowsReader, RowsTally, row_line, tenths_to_um};
pub use run::{BLOCK, Tick, ToleranceRun, TooManyImpossible};
pub use sentence::{phases_of_limits, sentence, shares, without_backlash, without_worst_case};
pub use worst::{Worst, is_worst_file, worst_file, worst_name};
