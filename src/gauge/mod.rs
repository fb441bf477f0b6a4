//! The gauge on the model: measures a gear as built as the shop does.
//!
//! Anvils, pins, balls, measuring circles and a master gear are brought to the outline itself, polygons cut
//! ever finer round each contact; no reading is computed from the gear's deviations. The tests
//! compare the readings with the deviations that were put in.
//!
//! A gear by its outline alone has no reference circle and no master: spans and pins alone are read on it ([`gauge_outline`]).
//!
//! A helical gear is read in the measuring plane. A ball touches the flanks beside that plane, and a span lies along the normal of the
//! helix, so both also use the sections in which they touch.
//!
//! Readings are in mm and named as the gear's own: teeth by number, flanks seen on the reference face.

mod eccentricity;
mod flank_distance;
mod flanks;
mod formula;
mod gauged;
mod grades;
mod master;
mod outlines;
mod pins;
mod profile;
mod roll;
mod roll_extremes;
mod root;
mod runout;
mod seat;
mod span;
mod spread;
mod stated;
mod workpiece;

pub use eccentricity::Eccentricity;
pub use flanks::{PitchReadings, ThicknessReadings};
pub use formula::Formula;
pub use gauged::{Gauged, Settings, gauge, graded, pin_sizes, pitches, pose_count, profiles};
pub use grades::GradedReading;
pub use outlines::gauge_outline;
pub use pins::{OverPins, Pins};
pub use profile::{FlankProfiles, ProfileReading, ProfileReadings};
pub use roll::Roll;
pub use roll_extremes::{RollPose, RollRange};
pub use root::RootReading;
pub use runout::{BallReading, RunoutReadings};
pub use seat::Seat;
pub use span::{Span, Spans};
pub use stated::StatedThickness;

/// Why a gauge has no reading: a measurement that this gear does not allow. A result, not a fault: the other gauges still read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{0}")]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Unmeasured(pub String);
