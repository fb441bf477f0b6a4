//! Populations of pair files: what `[tolerance]` makes of a pair, parts of a run, and what is told of it.

mod gears;
mod mm;
mod part;
mod population;
mod records;
mod result;
mod run;
mod sentence;
mod worst;

pub(crate) use population::{middle, requirement};

pub use part::{About, Part, PartError, PartHead, Progress};
pub use population::{ToleranceFile, read_tolerance};
pub use result::{Convergence, ToleranceResult, convergence, histogram_csv};
pub use run::{BlockError, Rows};
pub use sentence::sentence;
pub use worst::{Worst, worst_file};
