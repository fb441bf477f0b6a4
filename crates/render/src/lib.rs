//! Pictures, pages and text tables. Nothing here computes anything about gears: it takes results and draws them.

pub mod chart;
pub mod comparison;
pub mod gauge;
mod kit;
mod map;
mod report;
mod snapshot;
pub mod text;
pub mod viewer;

pub use chart::PictureError;
pub use map::map_picture;
pub use report::{Report, report};
pub use snapshot::{Snapshot, animation, exaggerated, snapshot};
pub use text::simulation as simulation_table;
