//! Two gears put together: centre distance, mating teeth, rotations.
//!
//! The simulation and the analytic models share nothing but these data.

mod backlash;
mod facing_teeth;
mod gear_pair;
mod iso_286;
mod pose;
mod section;
mod sweep_plan;

pub use backlash::{Backlash, BacklashUnit, arcmin};
pub(crate) use facing_teeth::FacingTeeth;
pub(crate) use gear_pair::overlap_half_angle;
pub use gear_pair::{FaceDeviation, GearPair, MOST_LEAN, MOST_MODULE_DIFFERENCE, Member};
pub use iso_286::{DesignatedDistance, ISO_286_SOURCE};
pub use pose::{Mating, Pose, ToothNumbers};
pub use section::section_at;
pub(crate) use section::{Leaning, LeaningSide, beyond_ends_bound};
pub use sweep_plan::SweepPlan;
