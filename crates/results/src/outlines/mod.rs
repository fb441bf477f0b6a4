//! Results of drawn gears: verdict, JSON, CSV, gauge readings and differences.

mod difference;
mod fitted;
mod gauged;
mod result;
mod sentence;

pub use difference::{comparison_json, difference_csv, difference_sentence, turn_words};
pub use fitted::looks_like;
pub use gauged::{GaugedOutline, gauged_json};
pub use result::{checked, outline_map_csv, to_csv, to_json};
pub use sentence::{lines, region_words};
