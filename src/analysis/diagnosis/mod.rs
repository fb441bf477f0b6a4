//! Checks of a pair for interference: whether it occurs, where, why, and its cost, by formula and on the outlines.
//!
//! The formulas give yes or no from a gear's parameters. The simulation shows which parts meet, how much lost motion
//! that costs, and from which centre distance on. A [`Check`] states both.
//!
//! The solvers here change the centre distance of a pair and turn it between the poses of a sweep. Each states its
//! result and its accuracy. They examine only the given poses and rotations from them.

mod check;
mod checks;
mod clearance;
mod contact_count;
mod lands;
mod map;
mod onset;
mod pose_evidence;
mod zero_distance;

pub use check::{Check, CheckName, CheckVerdict};
pub use checks::{CheckedPair, Diagnosis, Searched, diagnose, failed_checks, pitch_count};
pub use clearance::{RadialClearance, radial_clearance};
pub use contact_count::{ContactCount, Loss, Worst};
pub use map::{Limit, MAP_ROWS, Map, MapCell, map};
pub use onset::{Onset, form_onset, non_involute_onset};
pub use pose_evidence::PoseEvidence;
pub use zero_distance::{ZeroDistance, zero_distance};
