//! What a pair file asks for: two gears as measured, where they stand, which poses to run.
//!
//! Made by [`crate::input::read`], which checks everything first. Lengths in mm
//! unless the name says µm.

use crate::error::GearError;
use crate::gear::{AsBuilt, Side};
use crate::notes::GearNotes;
use crate::pair::{GearPair, Mating, Member, SweepPlan};
use crate::sources::Sources;
use std::collections::HashMap;

/// Poses of a study, over all centre distances and materials: their result fills 25 GB.
pub const MOST_POSES: u64 = 10_000_000;

/// Bytes that a pose takes in a result as JSON, about: 1400 where a pair is jammed to 2100 with tip corners.
pub const POSE_BYTES_JSON: u64 = 2100;

/// The same as CSV.
pub const POSE_BYTES_CSV: u64 = 400;

/// So many bytes in words, to about two digits.
pub(crate) fn size(bytes: u64) -> String {
    match bytes {
        0..1_000_000_000 => format!("{} MB", bytes.div_ceil(1_000_000)),
        1_000_000_000..10_000_000_000 => format!("{:.1} GB", bytes as f64 / 1e9),
        _ => format!("{} GB", bytes.div_ceil(1_000_000_000)),
    }
}

/// Which end of the thickness tolerance a run takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Material {
    /// Both gears thickest.
    Most,
    /// Both gears thinnest.
    Least,
    /// Both gears have a single thickness.
    AsMeasured,
}

impl Material {
    /// `most`, `least` or `as-measured`, as results name it.
    pub fn name(self) -> &'static str {
        match self {
            Material::Most => "most",
            Material::Least => "least",
            Material::AsMeasured => "as-measured",
        }
    }
}

/// One measurement on a rig, and what was predicted for it.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredRow {
    /// Centre distance `a`, mm.
    pub center_distance: f64,
    /// Wheel tooth of the mating.
    pub wheel_tooth: u32,
    /// Pinion tooth of the mating.
    pub pinion_tooth: u32,
    /// Circumferential backlash measured at the right flanks, µm.
    pub right_um: f64,
    /// The same at the left flanks.
    pub left_um: f64,
    /// Lower limit predicted, µm.
    pub predicted_min_um: f64,
    /// Upper limit predicted, µm.
    pub predicted_max_um: f64,
    /// Where the row comes from; may be empty.
    pub source: String,
}

/// A pair file, understood.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// Title; the file stem when the file has none.
    pub title: String,
    /// File stem, the name of the folder for results.
    pub stem: String,
    /// Wheel and pinion of each material: `AsMeasured` alone, or `Most` and `Least`.
    pub materials: Vec<(Material, AsBuilt, AsBuilt)>,
    /// The gear that stands still.
    pub locked: Member,
    /// Centre distances `a`, mm, distinct, in the order of the file (or of first appearance in `measured`).
    pub center_distances: Vec<f64>,
    /// `c`, mm: radial clearance of both bearings together.
    pub bearing_clearance: f64,
    /// The poses of every run; `None`: exactly the rows of `measured`.
    pub sweep: Option<SweepPlan>,
    /// Measured rows in the order of their file; empty when there is none.
    pub measured: Vec<MeasuredRow>,
    /// Chordal error of the polygons, mm.
    pub chord: f64,
    /// Tolerance of a comparison, µm of `j_wt`.
    pub tolerance_um: f64,
    /// Whether contact off the line of action passes a comparison.
    pub allow_off_line_contact: bool,
    /// The input as understood: keys as in a pair file, defaults filled in. Read as a pair file
    /// (beside the same measured file) it gives the same study.
    pub echo: serde_json::Value,
    /// What the statements about the wheel and about the pinion say of each other.
    pub notes: [GearNotes; 2],
    /// What the user should know, for standard error.
    pub warnings: Vec<String>,
    /// What was found to be in order, for standard error.
    pub remarks: Vec<String>,
    /// The files it was read from.
    pub sources: Sources,
}

/// One gear of a file, for what needs no mate.
#[derive(Debug, Clone, PartialEq)]
pub struct GearStudy {
    /// `wheel` or `pinion` of a pair file, `gear` of a gear file.
    pub name: &'static str,
    /// In the thicknesses it states: `AsMeasured` alone, or `Most` and `Least`.
    pub materials: Vec<(Material, AsBuilt)>,
    /// Its table as understood, defaults filled in.
    pub echo: serde_json::Value,
}

impl GearStudy {
    /// `k` of the span that states the thickness, or else of the one that cross-checks it.
    pub fn span_teeth(&self) -> Option<u32> {
        let teeth = stated(&self.echo, "span", "teeth")?.as_u64()?;
        u32::try_from(teeth).ok()
    }

    /// `D_M`, mm, of the dimension over pins that states the thickness, or else of the one that cross-checks it.
    pub fn pin(&self) -> Option<f64> {
        stated(&self.echo, "over_pins", "pin_mm")?.as_f64()
    }
}

/// `key` of the `measurement` of a gear's thickness that counts, or else of its cross-check.
fn stated<'a>(
    gear: &'a serde_json::Value,
    measurement: &str,
    key: &str,
) -> Option<&'a serde_json::Value> {
    let thickness = &gear["thickness"];
    [thickness, &thickness["cross_check"]]
        .into_iter()
        .find_map(|statement| statement[measurement].get(key))
}

/// The gears of a gear file or a pair file.
///
/// Made by [`crate::input::read_gears`].
#[derive(Debug, Clone, PartialEq)]
pub struct GearsStudy {
    /// Title; the file stem when the file has none.
    pub title: String,
    /// File stem, the name of the folder for results.
    pub stem: String,
    /// One gear, or wheel and pinion.
    pub gears: Vec<GearStudy>,
    /// What the user should know, for standard error.
    pub warnings: Vec<String>,
    /// What was found to be in order, for standard error.
    pub remarks: Vec<String>,
    /// The files it was read from.
    pub sources: Sources,
}

impl From<Study> for GearsStudy {
    fn from(study: Study) -> GearsStudy {
        let gear = |name: &'static str, of: fn(&(Material, AsBuilt, AsBuilt)) -> &AsBuilt| {
            let mut materials: Vec<(Material, AsBuilt)> = Vec::new();
            for pair in &study.materials {
                // A gear with a single thickness has it in both materials of its pair.
                match materials.first_mut() {
                    Some(first) if first.1 == *of(pair) => first.0 = Material::AsMeasured,
                    _ => materials.push((pair.0, of(pair).clone())),
                }
            }
            GearStudy {
                name,
                materials,
                echo: study.echo[name].clone(),
            }
        };
        GearsStudy {
            gears: vec![
                gear("wheel", |pair| &pair.1),
                gear("pinion", |pair| &pair.2),
            ],
            title: study.title,
            stem: study.stem,
            warnings: study.warnings,
            remarks: study.remarks,
            sources: study.sources,
        }
    }
}

/// One run: a pair as assembled and the matings to pose it in.
#[derive(Debug, Clone, PartialEq)]
pub struct RunPlan {
    /// Which thickness.
    pub material: Material,
    /// The pair.
    pub assembly: GearPair,
    /// Wheel and pinion tooth that name the assembly phase, where phases are run apart.
    pub phase: Option<(u32, u32)>,
    /// In order.
    pub matings: Vec<Mating>,
}

impl Study {
    /// `D_M`, mm, of the dimension over pins that states or cross-checks the thickness of `gear`, `wheel` or `pinion`.
    pub fn pin(&self, gear: &str) -> Option<f64> {
        stated(&self.echo[gear], "over_pins", "pin_mm")?.as_f64()
    }

    /// Whether its poses are whole revolutions.
    pub fn sweeps(&self) -> bool {
        matches!(
            self.sweep,
            Some(SweepPlan::Revolution { .. } | SweepPlan::Phases { .. })
        )
    }

    /// The same study at other centre distances, mm.
    ///
    /// # Errors
    /// [`GearError::BaseCirclesOverlap`], at a distance or, with bearing clearance, at `a − c`;
    /// [`GearError::OutOfRange`] for a study that runs exactly its measured rows.
    pub fn at(mut self, center_distances: Vec<f64>) -> Result<Study, GearError> {
        if self.sweep.is_none() {
            return Err(GearError::OutOfRange {
                what: "number of other centre distances",
                value: center_distances.len() as f64,
                allowed: "none: without [sweep] exactly the rows of [measured] are run, at theirs",
            });
        }
        for (_, wheel, pinion) in &self.materials {
            for a in &center_distances {
                let closest = a - self.bearing_clearance;
                GearPair::new(wheel.clone(), pinion.clone(), closest, self.locked)?;
            }
        }
        self.echo["assembly"]["center_distance_mm"] = serde_json::json!(center_distances);
        self.center_distances = center_distances;
        Ok(self)
    }

    /// How many poses [`Study::runs`] has in all.
    pub fn pose_count(&self) -> u64 {
        let materials = self.materials.len() as u64;
        match &self.sweep {
            Some(plan) => {
                let runs = self.center_distances.len() as u64 * materials;
                plan.poses().saturating_mul(runs)
            }
            None => {
                let here = |row: &&MeasuredRow| {
                    let mut distances = self.center_distances.iter();
                    distances.any(|a| a.to_bits() == row.center_distance.to_bits())
                };
                2 * materials * self.measured.iter().filter(here).count() as u64
            }
        }
    }

    /// Every centre distance with every material, the materials of the first distance first, phase by phase.
    ///
    /// # Errors
    /// None for a study that was read; a pair that cannot be assembled otherwise.
    pub fn runs(&self) -> Result<Vec<RunPlan>, GearError> {
        let mut measured = self.measured_matings();
        let mut runs = Vec::with_capacity(self.center_distances.len() * self.materials.len());
        for &a in &self.center_distances {
            let rows = measured.remove(&a.to_bits()).unwrap_or_default();
            for (material, wheel, pinion) in &self.materials {
                let assembly = GearPair::new(wheel.clone(), pinion.clone(), a, self.locked)?;
                let parts = match &self.sweep {
                    Some(plan) => plan.parts(),
                    None => Vec::new(),
                };
                let mut add = |phase, matings| {
                    runs.push(RunPlan {
                        material: *material,
                        assembly: assembly.clone(),
                        phase,
                        matings,
                    });
                };
                if self.sweep.is_none() {
                    add(None, rows.clone());
                }
                for (phase, plan) in parts {
                    add(phase, plan.matings(&assembly));
                }
            }
        }
        Ok(runs)
    }

    /// A right-flank and a left-flank pose of each measured row, by the bits of its centre distance.
    fn measured_matings(&self) -> HashMap<u64, Vec<Mating>> {
        let mut matings: HashMap<u64, Vec<Mating>> = HashMap::new();
        for row in &self.measured {
            let of_distance = matings.entry(row.center_distance.to_bits()).or_default();
            of_distance.extend(Side::BOTH.map(|flank| Mating {
                wheel_tooth: row.wheel_tooth,
                pinion_tooth: row.pinion_tooth,
                flank,
                fraction: 0.0,
            }));
        }
        matings
    }
}
