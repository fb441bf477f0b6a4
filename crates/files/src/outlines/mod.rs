//! Pair files with at least one gear given by an outline: from the keys and the drawing to the study. Also gears given by an
//! outline alone.

mod compared;
mod gear;
mod listed;
mod pair;
mod paths;

pub use compared::{ComparedOutlines, TwoDrawings};
pub use gear::DrawingRead;
pub use listed::{ListedOutline, ListedOutlines, listed_outlines, lists_outlines};
pub use pair::{Drawings, OutlineOptions};
pub(crate) use pair::{has_outline, of_drawing, read, read_gear, refuse};
