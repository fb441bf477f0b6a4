//! One gear: design, radii, exact curves, the measured place of each flank, and the polygon of its outline.
//!
//! Lengths are mm, angles radians. A gear's own frame has its geometric centre at the origin. A tooth's own frame has the tooth's
//! centre line on +x.

mod as_built;
mod by_tooth;
mod datum;
mod design;
mod deviation_curve;
mod deviations;
mod din_3967;
mod excess;
mod fillet;
#[allow(clippy::module_inception)]
mod gear;
mod grade;
mod half_tooth;
mod inspection;
pub mod involute;
mod lead;
mod modification;
mod modified_flanks;
mod part;
mod pins;
mod pitch;
mod placed;
mod readings;
mod runout;
mod side;
mod spans;
#[cfg(test)]
mod test_gears;
pub mod thickness;

pub use as_built::AsBuilt;
pub use by_tooth::ByTooth;
pub use datum::{EccentricitySeparation, separate_eccentricity, without_eccentricity};
pub use design::{BasicGearData, BasicRack, GearDesign, Hand};
pub use deviation_curve::DeviationCurve;
pub use deviations::Deviations;
pub use din_3967::{DIN_3967_SOURCE, ThicknessField};
pub(crate) use excess::Excess;
pub use fillet::Fillet;
pub use gear::Gear;
pub use grade::{GRADE_SOURCE, GRADES, Grade, GradedQuantity};
pub use half_tooth::{HalfTooth, Profile, Segment};
pub use inspection::{Inspection, has_different_teeth};
pub use lead::{EndRelief, Lead};
pub use modification::{Modification, Relief, Trace};
pub use part::{Circle, Cubic, Line, ModifiedFlank, Part, PartCurve, ProfilePart};
pub(crate) use part::{Osculating, smooth};
pub use pins::PinReadings;
pub use pitch::{Pitch, PitchAxis};
pub use placed::Placed;
pub(crate) use placed::steps_near;
pub(crate) use readings::FlankShifts;
pub use readings::Readings;
pub use runout::{Probe, RunoutFit, RunoutReadings};
pub use side::{Face, Flank, Side};
pub use spans::{PerTooth, Spans};
pub use thickness::MeasuringBody;
