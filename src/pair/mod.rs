//! Two gears put together: centre distance, which teeth mate, where each gear stands.
//!
//! Bookkeeping only: the simulation and the analytic models both read it, and
//! share nothing else.

mod backlash;
mod gear_pair;
mod iso_286;
mod pose;
mod sweep_plan;

pub use backlash::{Backlash, BacklashUnit, arcmin};
pub use gear_pair::{GearPair, MOST_UNEQUAL, Member};
pub use iso_286::{DesignatedDistance, ISO_286_SOURCE};
pub use pose::{Mating, Pose, ToothNumbers};
pub use sweep_plan::SweepPlan;
