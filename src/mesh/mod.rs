//! What two gears do: contact of their outlines, lost motion, sweeps of poses.

mod lost_motion;
mod scene;

pub use lost_motion::{Contact, LostMotion, Status, Touch};
pub use scene::{Drawn, LineOfAction, Meeting, Scene};
