//! Does a pair interfere, where, why, and what does it cost: every check of a pair, by formula and on the outlines.
//!
//! The formulas give yes or no from a gear's parameters; the simulation knows what
//! met what, how much lost motion that costs, and from which centre distance on.
//! Both stand side by side in a [`Check`].
//!
//! Solvers here move the centre distance of a pair and turn it on between the
//! poses of a sweep; each states what it found and how closely. None of them
//! looks beyond the poses it was given but by turning on from them.

mod check;
mod checks;
mod clearance;
mod contact_count;
mod lands;
mod map;
mod onset;
mod seen;
mod zero_distance;

pub use check::{Check, CheckName, Verdict};
pub use checks::{Diagnosis, Group, Searched, diagnose, failed_checks, pitch_count};
pub use clearance::{RadialClearance, radial_clearance};
pub use contact_count::{ContactCount, Loss, Worst};
pub use map::{Limit, MAP_ROWS, Map, MapCell, map};
pub use onset::{Onset, form_onset, non_involute_onset};
pub use seen::Seen;
pub use zero_distance::{ZeroDistance, zero_distance};
