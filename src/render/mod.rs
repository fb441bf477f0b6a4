//! Pictures, tables and files. The renderer computes nothing about gears: it takes results and draws them.

mod animation;
mod caption;
pub mod chart;
pub mod check;
mod clip;
pub mod comparison;
mod exaggerated;
mod gears;
mod inset;
mod labels;
mod legend;
mod link;
mod main_view;
mod map;
mod marks;
mod met;
mod motion;
mod overlap_label;
mod page;
mod pitch_chart;
mod report;
mod result;
mod scale;
mod snapshot;
mod table;
mod turning;
mod view;
pub mod viewer;

pub use animation::animation;
pub use comparison::ComparedPair;
pub use exaggerated::exaggerated;
pub use map::{map_csv, map_picture};
pub use report::{Report, report};
pub use result::{ResultFile, result_file};
pub use snapshot::{Snapshot, snapshot};
pub use table::simulation as simulation_table;
