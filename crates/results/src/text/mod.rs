//! Results as text for a terminal.

pub mod check;
mod difference;
mod import;
mod matching;
mod measured;
mod phases;
pub mod rexs;
mod simulation;
mod tolerance;
mod verdict;

pub use crate::layout::{Column, Screen, Table, Tone};
pub use difference::text as outline_difference;
pub use import::imported;
pub use matching::text as matched;
pub use simulation::simulation;
pub use tolerance::text as tolerance;
