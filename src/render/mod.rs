//! Pictures. The renderer computes nothing about gears: it takes results and draws them.

mod caption;
mod clip;
mod gears;
mod inset;
mod labels;
mod legend;
mod link;
mod main_view;
mod marks;
mod page;
mod scale;
mod snapshot;
mod view;

pub use snapshot::{Snapshot, snapshot};
