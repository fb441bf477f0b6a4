//! Evaluation of the measurements of one gear.
//!
//! [`Measurements`] hold the data of a shop: a design, a statement of the tooth thickness (and a second for comparison), deviations
//! of single teeth, pitch of both flanks, runout. [`Measurements::measure`] builds a [`MeasuredGear`]:
//!
//! - Pitch about the datum axis contains the eccentricity. Removing it exactly needs the mean thickness, and readings of the
//!   thickness need the pitch. Both are found in a fixed-point iteration.
//! - Spans all round give each tooth's thickness if they determine it. The effect of the pitch is removed first.
//! - Runout readings of a ball or a fork give the eccentricity after removing the effect of the flanks.
//!
//! Contradictions, outliers and implausible values are [`Finding`]s with their numbers. A finding changes no value.
//!
//! ```
//! use gearlash::gear::{BasicGearData, Face, GearDesign};
//! use gearlash::metrology::{Finding, Measurements, Outlier, ThicknessStatement};
//!
//! // A gear of module 3 with 21 teeth, and spans over 3 teeth at every first tooth; that at tooth 5 was read one thimble line off.
//! let design = GearDesign::standard(BasicGearData::new(21, 3.0, 20f64.to_radians())?);
//! let mut readings: Vec<(u32, f64)> = (1..=21).map(|tooth| (tooth, 22.99)).collect();
//! readings[4].1 += 0.010;
//! let measurements = Measurements {
//!     thickness: ThicknessStatement::SpanReadings { teeth: 3, readings, per_tooth: true },
//!     ..Measurements::nominal(design, Face::Front)
//! };
//! let gear = measurements.measure().map_err(|errors| errors[0].clone())?;
//! let outlier = gear.findings.iter().find_map(|finding| match finding {
//!     Finding::Outlier(Outlier::Reading(outlier)) => Some(outlier),
//!     _ => None,
//! });
//! let outlier = outlier.ok_or("no outlier")?;
//! assert_eq!(outlier.place, 5);
//! assert!((outlier.off_um - 10.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod contradictions;
mod datum_leads;
mod error;
mod finding;
mod flank_correlation;
mod lead;
mod measure;
mod outliers;
mod pitch_statement;
mod plausibility;
mod profile;
mod runout;
mod settle;
mod thickness_statement;
mod wobble;

pub use error::{DeviationCause, Fits, LeadKey, MeasurementError, ProfileKey, StatementRole};
pub use finding::{
    AllRoundNote, Eccentricity, EccentricityNote, Finding, FittedReadings, FlankKnowledge,
    GearNotes, MeanOnly, Outlier, PitchOutlier, Quantity, ReadingOutlier, Reversal,
    RunoutContradiction, RunoutSource, SameKind, SomeTeeth, ThicknessBesidePitch,
    ThicknessStatements, TooFar,
};
pub use flank_correlation::{anticorrelation_p_value, datum_anticorrelation_p_value};
pub use measure::{CrossCheck, MeasuredGear, Measurements};
pub use pitch_statement::{EccentricitySource, PitchKind, PitchSense, PitchStatement};
pub use runout::{ProbeReadings, ReadWith, Runout, RunoutStatement};
pub use thickness_statement::{ThicknessStatement, Toleranced, chord_height};
pub use wobble::{RunoutAt, Wobble};
