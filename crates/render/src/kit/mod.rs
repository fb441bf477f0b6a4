//! What every picture is drawn with.

pub mod clip;
pub mod labels;
pub mod scale;
pub mod sheet;
