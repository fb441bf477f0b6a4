//! Gears given by an outline: from the keys and the drawing to the gear.

mod compared;
mod gear;
mod listed;
mod pair;
mod paths;

pub use compared::ComparedOutlines;
pub(crate) use compared::{compared, compared_tables};
pub use gear::DrawingRead;
pub(crate) use gear::gear;
pub use listed::{ListedOutline, ListedOutlines, listed_outlines, lists_outlines};
pub use pair::{APART_MM, Drawings, OutlineOptions};
pub(crate) use pair::{
    by_flags, check_distances, has_outline, outline_table, refuse, refuse_axes, refuse_limits,
    refuse_tables, refuse_uncertainties, slips,
};
