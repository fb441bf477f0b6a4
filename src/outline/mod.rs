//! Gears by their outline alone: a closed path that someone drew or traced, and the teeth found on it.
//!
//! An outline has no module, no base circle and no line of action; nothing is computed from guessed ones (what flanks look like is a
//! finding: [`OutlineGear::fitted_involute`]). What is left is what turning one gear
//! against the other needs: half teeth, their numbers and an axis ([`crate::contact::OutlineKernel`]).
//!
//! A gear by its data becomes an outline by `OutlineGear::from`, so that either may stand in a pair; how far two outlines of one gear lie apart
//! is `difference`, spans and pins on one are [`crate::gauge`]'s. Files become [`OutlineGear`]s in `gearlash-files` (`drawing`, `outlines`),
//! studies of them are made by [`crate::analysis::study::Study::of_drawn`].
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
mod boundary;
mod centre;
mod difference;
mod error;
mod fitted;
mod gear;
mod half;
mod of_gear;
mod pair;
mod path;
pub mod polygon;
mod segment;
mod teeth;

pub use assembled_pair::AssembledPair;
pub use centre::{FittedCentre, fit_centre};
pub use difference::{Deviation, OutlineDifference};
pub use error::OutlineError;
pub use fitted::{FittedInvolute, StandardGear};
pub use gear::{OutlineGear, OutlineReading};
pub use of_gear::{of_gear, of_section};
pub use pair::OutlinePair;
pub use segment::PathSegment;

pub(crate) use half::{HalfOutline, HalfPiece};
