//! Results as JSON and CSV: the keys of the interface, units in their names.

mod checks;
mod comparison;
mod csv_row;
pub mod gauge;
mod json;
mod notes;
mod records;
mod summary;
mod table;
mod verdict;
mod written;

pub use checks::{checks_json, map_csv};
pub use comparison::{ComparedPair, comparison_json};
pub use records::doubts;
pub(crate) use table::csv_text;
pub use table::{Cell, Column, Table, Unit};
pub use verdict::{extremes_json, pose_json};
pub use written::{ResultFile, ResultWriter, result_file};
