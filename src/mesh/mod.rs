//! What two gears do: contact of their outlines, lost motion, sweeps of poses.

mod exact;
mod lost_motion;

pub use exact::ExactKernel;
pub use lost_motion::{Contact, LostMotion, Status, Touch};
