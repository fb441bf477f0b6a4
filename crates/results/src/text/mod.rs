//! Results as text for a terminal.

mod measured;
mod read;
mod simulation;

/// The checks of a pair as text.
pub mod check {
    pub use crate::checks::{doubts, shown, text, titles};
}

pub use crate::difference::difference_text;
pub use crate::layout::{Column, Screen, Table, Tone};
pub use measured::measured_shown;
pub use read::{gearbox, gearbox_pair, imported, listed_outlines};
pub use simulation::simulation;
