//! Errors of measurements that no gear can have.

use super::finding::Outlier;
use crate::error::GearError;
use crate::gear::Flank;

/// An error in the measurements of a gear.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeasurementError {
    /// A thickness statement that is not a number, or readings that no tooth can have: pins inside the base circle, a place twice.
    #[error("{error}")]
    Thickness {
        /// Which statement.
        role: StatementRole,
        /// The cause.
        error: GearError,
    },
    /// No gear of this design has the stated thickness.
    #[error("{error}")]
    NoGear {
        /// Which statement.
        role: StatementRole,
        /// The cause.
        error: GearError,
        /// Outliers that may be the cause.
        suspects: Vec<Outlier>,
    },
    /// A span, a pin or a chord that does not touch the involute where the thickness is measured.
    #[error("{error}")]
    OffInvolute {
        /// Which statement.
        role: StatementRole,
        /// The place of contact.
        error: GearError,
        /// Measurements that would touch the involute.
        fits: Fits,
        /// Outliers that may be the cause.
        suspects: Vec<Outlier>,
    },
    /// Per-tooth thickness without one number per tooth, or not determined.
    #[error("{0}")]
    PerTooth(GearError),
    /// Pitch without one number per tooth.
    #[error("{0}")]
    Pitch(GearError),
    /// A flank half a pitch or more off its place.
    #[error(
        "the {} flank of tooth {tooth} stands {off_um:.1} µm from the mean, allowed is less than half a pitch, {half_pitch_um:.1} µm",
        flank.name()
    )]
    PitchOffHalf {
        /// The own flank.
        flank: Flank,
        /// The tooth.
        tooth: u32,
        /// Deviation, µm.
        off_um: f64,
        /// Half a pitch, µm.
        half_pitch_um: f64,
    },
    /// Pitch about the datum axis and a runout, without a choice of the eccentricity.
    #[error(
        "pitch measured about the datum axis already contains the eccentricity, and the runout would count it twice"
    )]
    EccentricityTwice,
    /// The eccentricity of a runout is chosen, but no runout is stated.
    #[error("no runout is stated, or no high tooth of it")]
    NoRunout,
    /// An eccentricity is chosen from pitch about the gear's own axis.
    #[error("values about the gear's own axis contain no eccentricity")]
    NoEccentricityInOwnPitch,
    /// No eccentricity explains pitch about the datum axis.
    #[error("{0}")]
    DatumPitch(GearError),
    /// The iteration of mean thickness and eccentricity did not converge.
    #[error("no eccentricity goes with the stated thickness")]
    NotSettled,
    /// A runout that is not a number, a high tooth that does not exist, or readings that no eccentricity explains.
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
    /// A profile that no flank of the gear can have.
    #[error("{error}")]
    Profile {
        /// The own flank.
        flank: Flank,
        /// The key at fault.
        key: ProfileKey,
        /// The cause.
        error: GearError,
    },
    /// A lead that no flank of the gear can have.
    #[error("{error}")]
    Lead {
        /// The own flank.
        flank: Flank,
        /// The key at fault.
        key: LeadKey,
        /// The cause.
        error: GearError,
    },
    /// Leads about the datum axis from which the wobble cannot be taken.
    #[error("{0}")]
    DatumLeads(&'static str),
    /// Deviations that leave a tooth without tip or neck, or a space without room.
    #[error("{error}")]
    Deviations {
        /// The error.
        error: GearError,
        /// The deviations at fault.
        cause: DeviationCause,
        /// Outliers that may be the cause.
        suspects: Vec<Outlier>,
    },
}

/// A key of a profile statement.
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
    /// All keys together.
    All,
}

/// A key of a lead statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LeadKey {
    /// Evaluation range, or the height at which pitch and thickness were measured.
    Range,
    /// Reliefs of the ends.
    EndRelief,
    /// Measured traces.
    Trace,
    /// All keys together.
    All,
}

/// The role of a thickness statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StatementRole {
    /// The statement that determines the gear.
    Counts,
    /// The statement used for comparison.
    CrossCheck,
}

/// Measurements that touch the involute of a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fits {
    /// The least and greatest number of teeth for a span; `None` if no span fits.
    Spans(Option<(u32, u32)>),
    /// Diameter of a pin, mm; `None` if no pin fits.
    Pin(Option<f64>),
    /// A chord at another height.
    Chord,
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
    /// The leads.
    Lead,
}
