//! Measurements that no gear has.

use super::finding::Outlier;
use crate::error::GearError;
use crate::gear::Flank;

/// One thing that is wrong with the measurements of a gear.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeasurementError {
    /// A statement of the thickness that is no number, or whose readings go with no tooth: pins inside the base circle, a place twice.
    #[error("{error}")]
    Thickness {
        /// Which statement.
        role: StatementRole,
        /// What is wrong.
        error: GearError,
    },
    /// No gear of this design has the stated thickness.
    #[error("{error}")]
    NoGear {
        /// Which statement.
        role: StatementRole,
        /// Why.
        error: GearError,
        /// The reading that may be the reason, if there is one.
        suspects: Vec<Outlier>,
    },
    /// A span or a pin that does not touch the involute where the thickness is measured.
    #[error("{error}")]
    OffInvolute {
        /// Which statement.
        role: StatementRole,
        /// Where it touches.
        error: GearError,
        /// What would touch.
        fits: Fits,
        /// The reading that may be the reason, if there is one.
        suspects: Vec<Outlier>,
    },
    /// Per-tooth thickness that is not one number a tooth, or is not determined.
    #[error("{0}")]
    PerTooth(GearError),
    /// Pitch that is not one number a tooth.
    #[error("{0}")]
    Pitch(GearError),
    /// A flank half a pitch or more from where it belongs.
    #[error(
        "the {} flank of tooth {tooth} stands {off_um:.1} µm from the mean, allowed is less than half a pitch, {half_pitch_um:.1} µm",
        flank.name()
    )]
    PitchOffHalf {
        /// The own flank.
        flank: Flank,
        /// The tooth.
        tooth: u32,
        /// How far, µm.
        off_um: f64,
        /// Half a pitch, µm.
        half_pitch_um: f64,
    },
    /// Pitch about the datum axis and a runout, and nothing says which eccentricity counts.
    #[error(
        "pitch measured about the datum axis already contains the eccentricity, and the runout would count it twice"
    )]
    EccentricityTwice,
    /// The eccentricity of the runout is to count, and none is stated.
    #[error("no runout is stated, or no high tooth of it")]
    NoRunout,
    /// An eccentricity is to count of pitch about the gear's own axis.
    #[error("values about the gear's own axis contain no eccentricity")]
    NoEccentricityInOwnPitch,
    /// No eccentricity explains pitch about the datum axis.
    #[error("{0}")]
    DatumPitch(GearError),
    /// The fixed point of mean thickness and eccentricity was not reached.
    #[error("no eccentricity goes with the stated thickness")]
    NotSettled,
    /// A runout that is no number or whose high tooth is none of the gear's, or readings that are not one number a tooth or that no eccentricity explains.
    #[error("{0}")]
    Runout(GearError),
    /// A runout of the tooth depth or more.
    #[error("out of range, allowed is below the tooth depth, {depth_um:.1} µm")]
    RunoutBeyondDepth {
        /// The tooth depth, µm.
        depth_um: f64,
    },
    /// A ball that does not rest on the involutes.
    #[error("{0}")]
    Ball(GearError),
    /// No ball rests on the involutes of this gear.
    #[error("no ball rests on the involutes of this gear")]
    NoBall,
    /// A profile that no flank of the gear has.
    #[error("{error}")]
    Profile {
        /// The own flank.
        flank: Flank,
        /// What of it.
        key: ProfileKey,
        /// Why.
        error: GearError,
    },
    /// Deviations that leave a tooth without tip or neck, or a space without room.
    #[error("{error}")]
    Deviations {
        /// What they leave.
        error: GearError,
        /// The deviations that do.
        cause: DeviationCause,
        /// The values that may be the reason.
        suspects: Vec<Outlier>,
    },
}

/// What is said of a profile, as a key of a pair file says it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProfileKey {
    /// Profile slope.
    Slope,
    /// Profile crowning.
    Crowning,
    /// Tip relief.
    TipRelief,
    /// Root relief.
    RootRelief,
    /// Evaluation range.
    Range,
    /// Measured traces.
    Trace,
    /// All of it together.
    All,
}

/// Which of two statements of the thickness.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StatementRole {
    /// The one that counts.
    Counts,
    /// The one that it is compared with.
    CrossCheck,
}

/// What would touch the involute of a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fits {
    /// Spans over the least and greatest number of teeth, if there is any.
    Spans(Option<(u32, u32)>),
    /// A pin of this diameter, mm, if there is any.
    Pin(Option<f64>),
}

/// Which deviations are too large.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DeviationCause {
    /// The thickness of single teeth, by spans.
    Spans,
    /// The thickness of single teeth, as stated.
    PerTooth,
    /// The pitch.
    Pitch,
    /// The profiles.
    Profile,
}
