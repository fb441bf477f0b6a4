//! What one gear is: its basic rack, its radii, its exact curves, where each
//! flank was measured to be, and the polygon cut from all that.
//!
//! Lengths in mm, angles in radians. A gear's own frame has its geometric
//! centre at the origin; a tooth's own frame has the tooth's centre line on +x.

mod datum;
mod deviation;
mod fillet;
#[allow(clippy::module_inception)]
mod gear;
mod grade;
mod inspection;
pub mod involute;
mod outline;
mod pitch;
mod placed;
mod profile;
mod rack;
mod side;
pub mod thickness;
mod toothing;

pub use datum::Separated;
pub use deviation::{AsBuilt, Deviations};
pub use fillet::Fillet;
pub use gear::{Blank, Gear};
pub use grade::{GRADE_SOURCE, GRADES, Graded};
pub use inspection::Inspection;
pub use outline::{HalfTooth, Segment};
pub use pitch::Pitch;
pub use placed::Placed;
pub use profile::{Curve, Profile};
pub use rack::Rack;
pub use side::{Face, Side};
pub use toothing::Toothing;
