//! What the gauges read, as text, as charts and as a gear file that states it.

mod charts;
mod gear_file;
mod lengths;
mod text;

pub use charts::charts;
pub use gear_file::gear_file;
pub use text::{missing, text};
