//! Results as text for a terminal.

pub mod check;
mod layout;
mod measured;
mod phases;
mod simulation;

pub(crate) use layout::{finish, table, where_it_is};
pub use simulation::simulation;
