//! Gears by their outline alone: a closed path that someone drew or traced, and the teeth found on it.
//!
//! An outline has no module, no base circle and no line of action; nothing here guesses them. What is left is what turning one gear
//! against the other needs: half teeth, their numbers and an axis ([`crate::contact::OutlineKernel`]).

mod centre;
mod error;
mod gear;
mod half;
mod of_gear;
mod pair;
mod path;
mod segment;
mod teeth;

pub use centre::{FittedCentre, fit_centre};
pub use error::OutlineError;
pub use gear::{OutlineGear, OutlineReading};
pub use of_gear::of_gear;
pub use pair::OutlinePair;
pub use segment::PathSegment;

pub(crate) use half::{HalfOutline, HalfPiece};
