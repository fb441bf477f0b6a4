//! Gears by their outline alone: a closed path that someone drew or traced, and the teeth found on it.
//!
//! An outline has no module, no base circle and no line of action; nothing here guesses them.

mod of_gear;
mod segment;

pub use of_gear::of_gear;
pub use segment::PathSegment;
