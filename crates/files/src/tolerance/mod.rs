//! Populations of pair files: what `[tolerance]` makes of a pair, parts of a run, and what is reported of it.

mod bands;
mod consistent;
mod gear_names;
mod gears;
mod impossible;
mod limit;
mod merged;
mod mm;
mod part;
mod part_head;
mod population;
mod records;
mod result;
mod run;
mod sentence;
mod worst;
mod written;

pub(crate) use bands::middle;
pub(crate) use consistent::is_length;
pub(crate) use limit::limits;
pub(crate) use population::{placed, unlike};

pub use impossible::TooManyImpossible;
pub use limit::{Limit, in_words};
pub use part::{About, Part};
pub use part_head::{MOST_ASSEMBLIES, PartHead, Progress};
pub use population::{ToleranceFile, read_tolerance};
pub use result::{Convergence, ToleranceResult, convergence};
pub use run::{BlockError, Rows};
pub use sentence::{phases_of_limits, sentence, shares, without_backlash, without_worst_case};
pub use worst::{Worst, is_worst_file, worst_file, worst_name};
pub use written::histogram_csv;
