//! Pair files of which one gear at least is an outline: from the keys and the drawing to the study, the verdict and the result; gears by their
//! outline alone, and what is gauged on them.

mod compared;
mod fitted;
mod gauged;
mod gear;
mod gears;
mod pair;
mod paths;
mod refused;
mod result;
mod sentence;

pub use compared::{
    ComparedOutlines, TwoDrawings, comparison_json, difference_csv, difference_sentence, turn_words,
};
pub use fitted::looks_like;
pub use gauged::{GaugedOutline, gauged_csv, gauged_json};
pub use gear::DrawingRead;
pub use gears::{OutlineGearEntry, OutlineGearsFile};
pub(crate) use gears::{of_drawing, read as read_gear};
pub(crate) use pair::read;
pub use pair::{Drawings, OutlinePairFile};
pub(crate) use refused::{has_outline, refused};
pub use result::{outline_map_csv, to_csv, to_json};
pub use sentence::{region_words, sentence, summary};
