//! Backlash of a measured gear pair, found by turning one gear's true outline against the other's.
//!
//! A pair file states two spur gears, what was *measured* on them, and how they are put together. gearlash
//! builds the real tooth outlines (involutes, generated fillets, undercut, every tooth where it was
//! measured to be), locks one gear and turns the other to right-flank and to left-flank contact. The angle
//! between is the lost motion, signed: negative means that the pair cannot be assembled.
//!
//! The way through the crate, each stage importing only earlier ones:
//!
//! ```text
//! gear → metrology ┐
//!   └→ pair ───────┴→ study ← input (the pair file)
//!       │              └→ simulate → compare → measured, outcome, phases, curves, cycle, diagnosis → gauge → render → cli
//!       ├→ mesh ───────────────┘        │
//!       └→ analytic ────────────────────┘
//! ```
//!
//! [`analytic`] shares nothing with [`mesh`] but gears, deviations and poses: their agreement means something.
//! Lengths are mm and angles radians inside; names at the edge carry their unit (`_um`, `_mm`, `_deg`).
//!
//! ```
//! use gearlash::gear::{AsBuilt, GearDesign, Face, Gear, BasicRack, Side, BasicGearData};
//! use gearlash::mesh::{ExactKernel, Status};
//! use gearlash::pair::{GearPair, Mating, Member, Pose};
//!
//! // Two gears of module 3, 20°, with 44 teeth, 0.1 mm farther apart than play-free.
//! let basic_data = BasicGearData::new(44, 3.0, 20f64.to_radians())?;
//! let design = GearDesign { basic_data, profile_shift: 0.0, rack: BasicRack::ISO_53_A, tip_diameter: None };
//! let gear = Gear::nominal(design)?;
//! let wheel = AsBuilt::perfect(gear.clone(), Face::Front);
//! let pinion = AsBuilt::perfect(gear, Face::Back);
//! let assembly = GearPair::new(wheel, pinion, 132.1, Member::Wheel)?;
//!
//! // Tooth 11 of the wheel mates with tooth 11 of the pinion at their right flanks.
//! let mating = Mating { wheel_tooth: 11, pinion_tooth: 11, flank: Side::Right, fraction: 0.0 };
//! let pose = Pose::new(&assembly, mating);
//! let found = ExactKernel::new(&assembly).lost_motion(&pose)?;
//! assert_eq!(found.status(), Status::Clear);
//!
//! // j_wt = φ_j r_w; published for this pair: 0.0730569413863697 mm.
//! let j_wt = found.angle().unwrap() * assembly.operating_pitch_radius(Member::Pinion);
//! assert!((j_wt - 0.0730569413863697).abs() < 1e-9);
//! # Ok::<(), gearlash::error::Error>(())
//! ```

pub mod analysis;
pub mod analytic;
pub mod compare;
pub mod curves;
pub mod cycle;
pub mod diagnosis;
pub mod error;
pub mod gauge;
pub mod gear;
pub mod measured;
pub mod mesh;
pub mod metrology;
pub mod outcome;
pub mod pair;
mod parallel;
pub mod phases;
pub mod simulate;
pub mod study;
pub mod tally;
