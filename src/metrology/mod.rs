//! From measurements of one gear to the gear they mean, and to what they say of each other.
//!
//! [`Measurements`] is what a shop has: a design, one statement of the tooth thickness (and perhaps a second to compare it with),
//! deviations of single teeth, pitch of both flanks, runout. [`Measurements::measure`] makes one gear of it, a [`MeasuredGear`]:
//!
//! - Pitch about the datum axis contains the eccentricity. It is taken out exactly, which takes the mean thickness; readings of
//!   the thickness give the mean once the pitch is known. The two settle in a fixed point.
//! - Spans all round give each tooth's thickness where they determine it; pitch explains its part of them.
//! - Runout readings of a ball or a fork give the eccentricity once what the flanks do to them is taken out.
//!
//! What contradicts, stands out or looks as if something else were meant is a [`Finding`] with its numbers; it changes nothing.
//!
//! ```
//! use gearlash::gear::{BasicGearData, BasicRack, Face, GearDesign};
//! use gearlash::metrology::{Finding, Measurements, Outlier, ThicknessStatement};
//!
//! // A gear of module 3 with 21 teeth, and spans over 3 teeth at every first tooth; that at tooth 5 was read one thimble line off.
//! let design = GearDesign {
//!     basic_data: BasicGearData::new(21, 3.0, 20f64.to_radians())?,
//!     profile_shift: 0.0,
//!     rack: BasicRack::ISO_53_A,
//!     tip_diameter: None,
//! };
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

mod all_round;
mod contradictions;
mod doubts;
mod eccentricity;
mod error;
mod finding;
mod first_harmonic;
mod measure;
mod notes;
mod outliers;
mod pitch_statement;
mod profile;
mod runout;
mod runout_fit;
mod settle;
mod statement;
mod toleranced;
mod tooth;

pub use error::{DeviationCause, Fits, MeasurementError, ProfileKey, StatementRole};
pub use finding::{
    Finding, FittedReadings, FlankKnowledge, MeanOnly, Outlier, PitchOutlier, Quantity,
    ReadingOutlier, RunoutContradiction, RunoutSource, SameKind, ThicknessBesidePitch, TooFar,
};
pub use measure::{CrossCheck, MeasuredGear, Measurements};
pub use notes::{AllRoundNote, Eccentricity, EccentricityNote, GearNotes, ThicknessStatements};
pub use pitch_statement::{EccentricitySource, PitchKind, PitchSense, PitchStatement};
pub use runout::{ProbeReadings, ReadWith, Runout, RunoutStatement};
pub use statement::ThicknessStatement;
pub use toleranced::Toleranced;
