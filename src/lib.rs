//! Backlash of a measured gear pair, found by turning one gear's true outline against the other's.
//!
//! gearlash builds the real tooth outlines of two cylindrical gears, spur or helical: involutes, generated fillets, undercut, every
//! tooth at its *measured* place. It locks one gear and turns the other to right-flank and to left-flank contact. The signed angle
//! between the two is the lost motion; a negative value means that the pair cannot be assembled. Lengths are mm and angles rad,
//! unless a name ends in `_um`, `_mm` or `_deg`.
//!
//! # A pair from drawing data
//!
//! ```
//! use gearlash::contact::lost_motion_at;
//! use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign, Side};
//! use gearlash::pair::{GearPair, Mating};
//!
//! // Two gears of module 3, 20°, with 44 teeth, at the zero-backlash distance plus 0.1 mm.
//! let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(44, 3.0, 20f64.to_radians())?))?;
//! let wheel = AsBuilt::perfect(gear.clone(), Face::Front);
//! let pinion = AsBuilt::perfect(gear, Face::Back);
//! // Tooth 11 of the wheel mates with tooth 11 of the pinion at their right flanks.
//! let mating = Mating::at(11, 11, Side::Right);
//! let pair = GearPair::new(wheel, pinion, 132.1)?;
//! let j_wt = lost_motion_at(&pair.into(), mating)?.j_wt();
//! // Published for this pair.
//! assert!((j_wt.unwrap() - 0.0730569413863697).abs() < 1e-9);
//! # Ok::<(), gearlash::error::Error>(())
//! ```
//!
//! # A pair from spans and runout
//!
//! ```
//! use gearlash::contact::lost_motion_at;
//! use gearlash::gear::{AsBuilt, BasicGearData, Face, GearDesign};
//! use gearlash::metrology::{Measurements, Runout, RunoutStatement, ThicknessStatement, Toleranced};
//! use gearlash::pair::{GearPair, Mating};
//!
//! let design = GearDesign::standard(BasicGearData::new(44, 3.0, 20f64.to_radians())?);
//! let gear = |face, mm, total_um| -> Result<AsBuilt, Box<dyn std::error::Error>> {
//!     let measured = Measurements {
//!         thickness: ThicknessStatement::Span { teeth: 6, mm: Toleranced::Single(mm) },
//!         runout: RunoutStatement::Total(Runout { total_um, high_tooth: Some(7.0) }),
//!         ..Measurements::nominal(design, face)
//!     };
//!     let gear = measured.measure().map_err(|errors| errors[0].clone())?;
//!     assert!(gear.findings.is_empty());
//!     Ok(gear.as_built.most().clone())
//! };
//! let (wheel, pinion) = (gear(Face::Front, 50.55, 30.0)?, gear(Face::Back, 50.56, 20.0)?);
//! // e = F_r/2.
//! assert_eq!(wheel.eccentricity(), 0.015);
//! let pair = GearPair::new(wheel, pinion, 132.1)?;
//! let j_wt = lost_motion_at(&pair.into(), Mating::FIRST)?.j_wt();
//! assert!(j_wt > Some(0.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A revolution
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
//! # let gear = |teeth| -> Result<Gear, gearlash::error::GearError> {
//! #     Gear::nominal(GearDesign::standard(BasicGearData::new(teeth, 2.0, 20f64.to_radians())?))
//! # };
//! # let wheel = AsBuilt::perfect(gear(31)?, Face::Front);
//! # let pinion = AsBuilt::perfect(gear(17)?, Face::Back);
//! use gearlash::contact::{CutPair, Method, sweep};
//! use gearlash::pair::{GearPair, SweepPlan};
//! use gearlash::error::go_on;
//!
//! let cut = CutPair::for_certificates(&wheel, &pinion);
//! let pair = GearPair::new(wheel, pinion, 48.1)?;
//! let matings = SweepPlan::wheel_revolution(&pair, 16, (1, 1)).matings(&pair);
//! let poses = sweep(&pair, &cut, Method::Exact { certify: true }, &matings, 0.0, &go_on)?;
//! let least = poses.iter().filter_map(|pose| pose.j_wt()).fold(f64::INFINITY, f64::min);
//! assert!(poses.len() == 31 * 16 && least > 0.0);
//! # Ok::<(), gearlash::error::Error>(())
//! ```
//!
//! # The models beside it
//!
//! [`analytic`] shares only gears and poses with [`contact`], so their agreement is evidence.
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
//! # use gearlash::pair::{GearPair, Mating, Pose};
//! # let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(44, 3.0, 20f64.to_radians())?))?;
//! # let (wheel, pinion) = (AsBuilt::perfect(gear.clone(), Face::Front), AsBuilt::perfect(gear, Face::Back));
//! # let pair = GearPair::new(wheel, pinion, 132.1)?;
//! # let mating = Mating::FIRST;
//! let models = gearlash::analytic::evaluate(&pair, &Pose::new(&pair, mating));
//! let simulated = gearlash::contact::lost_motion_at(&pair.into(), mating)?.j_wt();
//! assert!((simulated.unwrap() - models.involute.unwrap()).abs() < 1e-9);
//! # Ok::<(), gearlash::error::Error>(())
//! ```
//!
//! # What touches
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
//! use gearlash::contact::{ToothPlace, lost_motion_at};
//! # use gearlash::pair::{GearPair, Mating};
//! # let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(44, 3.0, 20f64.to_radians())?))?;
//! # let (wheel, pinion) = (AsBuilt::perfect(gear.clone(), Face::Front), AsBuilt::perfect(gear, Face::Back));
//! # let pair = GearPair::new(wheel, pinion, 132.1)?;
//! # let mating = Mating::FIRST;
//! let pose = lost_motion_at(&pair.into(), mating)?;
//! let contacts = pose.proven().ok_or("unproven")?;
//! let right = contacts.right.ok_or("out of mesh")?;
//! assert_eq!((right.wheel.tooth, right.wheel.curve), (1, ToothPlace::Involute));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Every check of a pair
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
//! # use gearlash::pair::GearPair;
//! # let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
//! # let (wheel, pinion) = (AsBuilt::perfect(gear.clone(), Face::Front), AsBuilt::perfect(gear, Face::Back));
//! use gearlash::analysis::{Analysis, Plan};
//! use gearlash::analysis::diagnosis::CheckVerdict;
//! use gearlash::contact::Method;
//! use gearlash::analysis::study::Study;
//!
//! // 0.5 mm too near: the teeth do not fit.
//! let study = Study::of_pair("too near", &GearPair::new(wheel, pinion, 39.5)?, 4);
//! let plan = Plan::new(&study, Method::Exact { certify: true }).with_checks();
//! let analysis = Analysis::silently(&plan)?;
//! assert_eq!(analysis.diagnosis.verdict(), CheckVerdict::Fail);
//! # Ok::<(), gearlash::error::Error>(())
//! ```
//!
//! # The least and the greatest backlash
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
//! # use gearlash::pair::GearPair;
//! # let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
//! # let (wheel, pinion) = (AsBuilt::perfect(gear.clone(), Face::Front), AsBuilt::perfect(gear, Face::Back));
//! # use gearlash::analysis::{Analysis, Plan};
//! # use gearlash::contact::Method;
//! # use gearlash::analysis::study::Study;
//! let study = Study::of_pair("20/20", &GearPair::new(wheel, pinion, 40.1)?, 16);
//! let analysis = Analysis::silently(&Plan::new(&study, Method::Exact { certify: true }))?;
//! let runs: Vec<_> = analysis.all().collect();
//! let outcome = gearlash::analysis::outcome::Outcome::of(&runs, &[]);
//! let [least, greatest] = [outcome.least, outcome.greatest].map(|found| found.and_then(|found| found.pose.simulated.j_wt()));
//! assert!(least > Some(0.0) && least <= greatest && outcome.unproven == 0);
//! # Ok::<(), gearlash::error::Error>(())
//! ```
//!
//! # The gauge
//!
//! [`gauge`] measures the modelled gear on its outline, as a shop does.
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign, thickness};
//! use gearlash::gauge::{Settings, gauge};
//! use gearlash::error::go_on;
//!
//! let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
//! let settings = Settings { span_teeth: Some(3), steps_per_pitch: 1, ..Settings::default() };
//! let gauged = gauge(&AsBuilt::perfect(gear, Face::Front), &settings, &|_| (), &go_on)?;
//! // W_3 of 20 teeth, module 2: m cos α ((k − ½) π + z inv α), ISO 21771.
//! let alpha = 20f64.to_radians();
//! let span = 2.0 * alpha.cos() * (2.5 * std::f64::consts::PI + 20.0 * (alpha.tan() - alpha));
//! let spans = gauged.spans.map_err(|error| error.to_string())?;
//! assert!((spans.summary().mean - span).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A picture
//!
//! `gearlash-render` draws results; `gearlash-input` reads pair files.
//!
//! ```
//! # use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
//! # use gearlash::pair::{GearPair, Mating};
//! # let gear = Gear::nominal(GearDesign::standard(BasicGearData::new(20, 2.0, 20f64.to_radians())?))?;
//! # let (wheel, pinion) = (AsBuilt::perfect(gear.clone(), Face::Front), AsBuilt::perfect(gear, Face::Back));
//! # let pair = GearPair::new(wheel, pinion, 40.1)?.into();
//! # let mating = Mating::FIRST;
//! use gearlash::analysis::study::Material;
//! use gearlash::contact::lost_motion_at;
//! use gearlash_render::{Snapshot, snapshot};
//!
//! let found = lost_motion_at(&pair, mating)?;
//! let svg = snapshot(&Snapshot {
//!     title: "20/20",
//!     assembly: &pair,
//!     pose: &found.pose,
//!     material: Material::AsMeasured,
//!     found: found.found.as_ref(),
//!     section: None,
//! });
//! assert!(svg.contains("<svg"));
//! # Ok::<(), gearlash::error::Error>(())
//! ```
//!
//! # Many pairs
//!
//! [`population`] draws random assemblies and finds the share that misses a requirement. `matching` (with the feature of that name)
//! assigns measured wheels to pinions. [`outline`] reads gears from drawings. Each module begins with an example.
//!
//! # Features
//!
//! `rayon` (poses on all cores) and `serde` (results serialise) are on by default; `matching` (selective assembly) is not.
//! `ARCHITECTURE.md` describes the modules.

pub mod analysis;
pub mod analytic;
pub mod contact;
pub mod error;
pub mod gauge;
pub mod gear;
#[cfg(feature = "matching")]
pub mod matching;
pub mod metrology;
mod numeric;
pub mod outline;
pub mod pair;
mod parallel;
pub mod population;
