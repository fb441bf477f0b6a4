//! Pictures and pages. This package computes nothing about gears: it draws results.
//!
//! ```
//! use gearlash::analysis::study::Material;
//! use gearlash::contact::lost_motion_at;
//! use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign, Side};
//! use gearlash::pair::{GearPair, Mating};
//! use gearlash_render::{Snapshot, snapshot};
//!
//! let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(30, 2.0, 20f64.to_radians())?))?;
//! let (wheel, pinion) = (AsBuilt::perfect(gear.clone(), Face::Front), AsBuilt::perfect(gear, Face::Back));
//! let pair = GearPair::new(wheel, pinion, 60.1)?.into();
//! let mating = Mating { wheel_tooth: 1, pinion_tooth: 1, flank: Side::Right, fraction: 0.25 };
//! let found = lost_motion_at(&pair, mating)?;
//! let svg = snapshot(&Snapshot {
//!     title: "30/30",
//!     assembly: &pair,
//!     pose: &found.pose,
//!     material: Material::AsMeasured,
//!     found: found.found.as_ref(),
//!     section: None,
//! });
//! assert!(svg.contains("<svg") && svg.contains("30/30"));
//! # Ok::<(), gearlash::error::Error>(())
//! ```

pub mod chart;
pub mod gauge;
mod kit;
mod map;
mod match_map;
mod pose_name;
mod report;
mod snapshot;
pub mod viewer;

pub use chart::PictureError;
pub use chart::population::{Pictures, pictures as tolerance_pictures};
pub use kit::dark_style;
pub use map::{backlash_map_picture, map_picture};
pub use match_map::match_map;
pub use report::{Report, ToleranceReport, report, tolerance_report};
pub use snapshot::{Snapshot, animation, exaggerated, outline_difference, pose_picture, snapshot};
