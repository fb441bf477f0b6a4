//! Pair files with at least one gear given by an outline: from the keys and the drawing to the study. Also gears given by an
//! outline alone.

mod compared;
mod gear;
mod gears;
mod listed;
mod pair;
mod paths;
mod refused;

pub use compared::{ComparedOutlines, TwoDrawings};
pub use gear::DrawingRead;
pub(crate) use gears::{of_drawing, read as read_gear};
pub use listed::{ListedOutline, ListedOutlines, listed_outlines, lists_outlines};
pub(crate) use pair::read;
pub use pair::{Drawings, OutlineOptions};
pub(crate) use refused::{has_outline, refuse};
