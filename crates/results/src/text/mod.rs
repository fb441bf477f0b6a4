//! Results as text for a terminal.

pub mod check;
mod difference;
mod import;
mod measured;
pub mod outlines;
mod phases;
pub mod rexs;
mod simulation;

pub use crate::layout::{Column, Screen, Table, Tone};
pub use difference::text as outline_difference;
pub use import::imported;
pub use measured::measured_shown;
pub use simulation::simulation;
