//! Selective assembly: which measured wheel goes with which measured pinion, and which teeth meet.
//!
//! A [`Matrix`] has what every wheel comes to with every pinion in every assembly phase; [`Matrix::assign`] picks the pairs that assemble
//! the most within what is required and, among those, come nearest to a wanted backlash. Beside it stand what random pairing and thickness
//! classes would come to ([`Matrix::at_random`], [`Matrix::by_classes`]). Needs the feature `matching`.
//!
//! A cell of the matrix is an assembly of a [population](crate::population) a phase. `gearlash-files` (`matching`) reads the folders and writes the
//! result.
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
//! use gearlash::matching::{Matrix, Terms};
//! use gearlash::pair::Member;
//! use gearlash::population::Requirement;
//! use std::ops::ControlFlow;
//!
//! let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
//! let wheels = [0.002, 0.006].map(|e| AsBuilt::perfect(gear.clone(), Face::Front).with_runout(e, 1.0));
//! let pinions = [0.002, 0.006].map(|e| AsBuilt::perfect(gear.clone(), Face::Back).with_runout(e, 1.0));
//! let [wheels, pinions] = [wheels, pinions].map(|gears| gears.into_iter().collect::<Result<Vec<_>, _>>());
//! let terms = Terms {
//!     center_distances: [40.1; 2],
//!     clearance: 0.0,
//!     locked: Member::Wheel,
//!     face: [0.0; 2],
//!     requirement: Requirement::new(Some(0.064), None),
//!     target: None,
//! };
//! let matrix = Matrix::new(&wheels?, &pinions?, &terms, &|| ControlFlow::Continue(()))?;
//! assert_eq!(matrix.assign().pairs.len(), 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assignment;
mod classes;
mod matrix;

pub use assignment::{Assignment, MOST_EXACT};
pub use classes::{Expected, MOST_CLASSES};
pub use matrix::{Fit, Matrix, PairFit, Terms};
