//! The virtual gauge: it measures a model of a gear as a shop measures the gear.
//!
//! Anvils, pins, balls, measuring circles and a master gear touch the outline itself, on polygons that are cut finer around each contact.
//! No reading is computed from the gear's deviations. The tests compare the readings with the deviations of the model.
//!
//! A gear given by its outline alone has no reference circle and no master: only spans and pins are measured ([`gauge_outline`]).
//!
//! A helical gear is measured in the measuring plane. A ball touches the flanks beside that plane, and a span is
//! measured along the normal of the helix, so both also use the sections in which they touch.
//!
//! Readings are in mm and use the gear's own names: teeth by number, flanks as seen on the reference face.

mod eccentricity;
mod flank_distance;
mod flanks;
mod formula;
mod gauged;
mod grades;
mod lead;
mod outlines;
mod pins;
mod profile;
mod roll;
mod roll_extremes;
mod root;
mod runout;
mod seat;
mod span;
mod stated;
mod workpiece;

pub use eccentricity::Eccentricity;
pub use flanks::{PitchReadings, ThicknessReadings};
pub use formula::Formula;
pub use gauged::{Gauged, Settings, gauge, graded, pin_sizes, pitches, pose_count, profiles};
pub use grades::GradedReading;
pub use lead::{FaceReadings, FaceRunout, LeadReadings, SectionReadings, leads};
pub use outlines::gauge_outline;
pub use pins::{OverPins, Pins};
pub use profile::{FlankTraces, ProfileReadings, TraceReading};
pub use roll::Roll;
pub use roll_extremes::{RollPose, RollRange};
pub use root::RootReading;
pub use runout::{BallReading, RunoutReadings};
pub use seat::Seat;
pub use span::{Span, Spans};
pub use stated::StatedThickness;

use crate::numeric::{ends, mean};

/// The tooth `steps` ascending numbers after `tooth` of `teeth`.
fn tooth_after(teeth: u32, tooth: u32, steps: u32) -> u32 {
    (tooth - 1 + steps) % teeth + 1
}

/// Summary of the readings of one length, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summary {
    /// Least and greatest.
    pub ends: [f64; 2],
    /// Mean.
    pub mean: f64,
    /// Greatest bound on the error of a reading.
    pub error: f64,
}

impl Summary {
    /// Summarises readings with the bounds on their errors.
    fn of(readings: impl Iterator<Item = (f64, f64)> + Clone) -> Summary {
        let lengths = readings.clone().map(|(length, _)| length);
        Summary {
            ends: ends(lengths.clone()),
            mean: mean(lengths),
            error: readings.map(|(_, error)| error).fold(0.0, f64::max),
        }
    }
}

/// The reason why a gauge has no reading on this gear. It is a result, not a fault: the other gauges still measure.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{0}")]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Unmeasured(pub String);
