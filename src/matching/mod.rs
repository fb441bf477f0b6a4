//! Selective assembly: which measured wheel goes with which measured pinion, and which teeth meet.
//!
//! A [`Matrix`] holds the result of every wheel with every pinion in every assembly phase. [`Matrix::assign`] finds the most pairs that
//! meet the requirement and, among those, the pairs nearest to a target backlash. [`Matrix::at_random`] and [`Matrix::by_classes`] give
//! the expectation for random pairing and for thickness classes. The module needs the feature `matching`.
//!
//! A cell of the matrix is an assembly of a [population](crate::population) per phase. `gearlash-input` (`matching`) reads the folders
//! and writes the result.
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
//! use gearlash::matching::{Matrix, PairConditions};
//! use gearlash::pair::Member;
//! use gearlash::population::AssemblyLimits;
//! use gearlash::error::go_on;
//!
//! let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
//! let wheels = [0.002, 0.006].map(|e| AsBuilt::perfect(gear.clone(), Face::Front).with_runout(e, 1.0));
//! let pinions = [0.002, 0.006].map(|e| AsBuilt::perfect(gear.clone(), Face::Back).with_runout(e, 1.0));
//! let [wheels, pinions] = [wheels, pinions].map(|gears| gears.into_iter().collect::<Result<Vec<_>, _>>());
//! let conditions = PairConditions {
//!     center_distances: [40.1; 2],
//!     clearance: 0.0,
//!     locked: Member::Wheel,
//!     face: [0.0; 2],
//!     lean: [0.0; 2],
//!     requirement: AssemblyLimits::new(Some(0.064), None),
//!     target: None,
//! };
//! let matrix = Matrix::new(&wheels?, &pinions?, &conditions, &go_on)?;
//! assert_eq!(matrix.assign().pairs.len(), 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod matrix;

pub use matrix::{
    Assignment, Expected, Fit, MOST_CLASSES, MOST_EXACT, Matrix, PairConditions, PairFit,
};
