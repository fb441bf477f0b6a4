//! What one gear is: its basic rack, its radii, its exact curves, where each
//! flank was measured to be, and the polygon cut from all that.
//!
//! Lengths in mm, angles in radians. A gear's own frame has its geometric
//! centre at the origin; a tooth's own frame has the tooth's centre line on +x.

mod basic_gear_data;
mod basic_rack;
mod datum;
mod datum_axis;
mod deviation;
mod din_3967;
mod excess;
mod fillet;
mod flank_correlation;
#[allow(clippy::module_inception)]
mod gear;
mod grade;
mod harmonics;
mod inspection;
pub mod involute;
mod modification;
mod modified_flanks;
mod outline;
mod part;
mod pins;
mod pitch;
mod placed;
mod profile;
mod readings;
mod roll_curve;
mod runout;
mod side;
mod spans;
pub mod thickness;

pub use basic_gear_data::{BasicGearData, Hand};
pub use basic_rack::BasicRack;
pub use datum::EccentricitySeparation;
pub use deviation::{AsBuilt, Deviations};
pub use din_3967::{DIN_3967_SOURCE, ThicknessField};
pub(crate) use excess::Excess;
pub use fillet::Fillet;
pub use gear::{Gear, GearDesign};
pub use grade::{GRADE_SOURCE, GRADES, Grade, GradedQuantity};
pub use inspection::Inspection;
pub use modification::{Modification, Relief, Trace};
pub use outline::{HalfTooth, Segment};
pub use part::{Circle, Cubic, Line, ModifiedFlank, Part, PartCurve, ProfilePart};
pub(crate) use part::{Osculating, smooth};
pub use pins::PinReadings;
pub use pitch::{Pitch, PitchAxis};
pub use placed::Placed;
pub(crate) use placed::steps_near;
pub use profile::Profile;
pub(crate) use readings::FlankShifts;
pub use readings::Readings;
pub use roll_curve::RollCurve;
pub(crate) use runout::range;
pub use runout::{Probe, RunoutFit, RunoutReadings};
pub use side::{Face, Flank, Side};
pub use spans::{PerTooth, Spans};
pub use thickness::MeasuringBody;
