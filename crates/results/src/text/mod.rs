//! Results as text for a terminal.

pub mod check;
mod difference;
mod import;
mod layout;
mod matching;
mod measured;
mod outlines;
mod phases;
pub mod rexs;
mod simulation;
mod tolerance;
mod unit;
mod verdict;

pub use difference::text as outline_difference;
pub use import::imported;
pub(crate) use layout::where_it_is;
pub use layout::{Column, Screen, Table, Tone};
pub use matching::text as matched;
pub use outlines::text as outlines;
pub use simulation::simulation;
pub use tolerance::text as tolerance;
