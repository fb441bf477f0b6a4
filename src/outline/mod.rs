//! Gears given by their outline alone: a closed path, drawn or traced, and the teeth found on it.
//!
//! An outline has no module, no base circle and no line of action, and none are guessed. [`fit_involute`] is a
//! finding only. An outline gear has half teeth, tooth numbers and an axis, which contact needs ([`crate::contact::OutlineKernel`]).
//!
//! `OutlineGear::from` converts a gear given by data, so a pair may combine both. [`OutlineDifference`] compares two outlines of one
//! gear; [`crate::gauge`] measures spans and pins on an outline. `gearlash-drawing` and `gearlash-input` (`outlines`) read files into
//! [`OutlineGear`]s, and [`crate::analysis::study::Study::of_drawn`] makes studies of them.
//!
//! ```
//! use gearlash::contact::OutlineKernel;
//! use gearlash::gear::Face;
//! use gearlash::outline::{OutlineGear, OutlinePair, OutlineReading, PathSegment};
//! use gearlash::pair::{Mating, Member};
//! use nalgebra::Point2;
//! use std::f64::consts::{FRAC_PI_2, TAU};
//!
//! // A wheel of twelve straight-sided teeth, 26 mm over the tips, the first one up, clockwise.
//! let corner = |radius: f64, pitches: f64| {
//!     let (sin, cos) = (FRAC_PI_2 - pitches * TAU / 12.0).sin_cos();
//!     Point2::new(radius * cos, radius * sin)
//! };
//! let tooth = |k: f64| [corner(10.0, k - 0.3), corner(13.0, k - 0.1), corner(13.0, k + 0.1), corner(10.0, k + 0.3)];
//! let corners: Vec<Point2<f64>> = (0..12).flat_map(|k| tooth(f64::from(k))).collect();
//! let next = corners.iter().cycle().skip(1);
//! let path: Vec<PathSegment> = corners.iter().zip(next).map(|(a, b)| PathSegment::Line([*a, *b])).collect();
//! let reading = OutlineReading {
//!     centre: Point2::origin(),
//!     face: Face::Front,
//!     teeth: Some(12),
//!     first_tooth: None,
//!     bound: 0.0,
//! };
//! let gear = OutlineGear::new(&path, &reading)?;
//! let pair = OutlinePair::new(gear.clone(), gear, 23.5, Member::Wheel)?;
//! let mating = Mating::FIRST;
//! let found = OutlineKernel::new(&pair).lost_motion(&mating)?;
//! assert!(found.angle().is_some_and(|play| play > 0.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assembled_pair;
mod change;
mod difference;
mod fitted;
mod gear;
mod half;
mod of_gear;
#[cfg(feature = "offset")]
mod offset;
mod pair;
mod path;
mod placed_gear;
pub mod polygon;
mod teeth;
mod tooth_classes;

pub use crate::error::OutlineError;
pub use assembled_pair::AssembledPair;
pub use change::GearChange;
pub use difference::{Deviation, OutlineDifference};
pub use fitted::{FittedCentre, FittedInvolute, StandardGear, fit_centre, fit_involute};
pub use gear::{OutlineGear, OutlineReading};
pub use of_gear::{of_gear, of_section};
pub use pair::OutlinePair;
pub use path::PathSegment;
pub use placed_gear::PlacedGear;

pub(crate) use half::{HalfOutline, HalfPiece};
pub(crate) use tooth_classes::ToothClasses;
