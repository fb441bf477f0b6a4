//! A study of a pair: two gears as measured, their positions, and the poses to run. Lengths in mm unless the name says µm.

use super::axes::BearingEnds;
use super::requirement::Requirements;
use super::uncertainty::Uncertainty;
use crate::error::{Error, GearError};
use crate::gear::{AsBuilt, Side};
use crate::metrology::GearNotes;
use crate::outline::{AssembledPair, OutlineGear, OutlinePair};
use crate::pair::{BacklashUnit, GearPair, Mating, Member, SweepPlan};
use std::collections::HashMap;

/// The end of the thickness tolerance in a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
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

    /// In words: `most material`, `least material` or `single thickness`.
    pub fn words(self) -> &'static str {
        match self {
            Material::Most => "most material",
            Material::Least => "least material",
            Material::AsMeasured => "single thickness",
        }
    }
}

/// One measurement on a rig, and its prediction.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MeasuredRow {
    /// Centre distance `a`, mm.
    pub center_distance: f64,
    /// Wheel tooth of the mating.
    pub wheel_tooth: u32,
    /// Pinion tooth of the mating.
    pub pinion_tooth: u32,
    /// Circumferential backlash measured at the right flanks, µm.
    pub right_um: f64,
    /// Circumferential backlash measured at the left flanks, µm.
    pub left_um: f64,
    /// Lower limit predicted, µm; `None` without a prediction.
    pub predicted_min_um: Option<f64>,
    /// Upper limit predicted, µm; `None` without a prediction.
    pub predicted_max_um: Option<f64>,
    /// Where the row comes from; may be empty.
    pub source: String,
}

/// The contents of a pair file.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// Title.
    pub title: String,
    /// Wheel and pinion of each material: `AsMeasured` alone, or `Most` and `Least`. Empty where a gear is drawn.
    pub materials: Vec<(Material, AsBuilt, AsBuilt)>,
    /// Wheel and pinion of each material of a pair with a drawn gear; the mate is given by the outline of its data.
    pub drawn: Vec<(Material, OutlineGear, OutlineGear)>,
    /// The gear that stands still.
    pub locked: Member,
    /// The common face of helical gears, mm from the wheel's measuring plane ([`GearPair::with_face`]).
    pub face: [f64; 2],
    /// Lean of the pinion's axis from the wheel's, mm per mm ([`GearPair::with_lean`]).
    pub lean: [f64; 2],
    /// Greatest further lean in either sense, in the plane of the axes and out of it, mm per mm. Extremes cover all leans up to it; single poses have none.
    pub open_lean: [f64; 2],
    /// Bearings with another clearance at each end; extremes cover all places of the axes in them.
    pub bearing_ends: Option<BearingEnds>,
    /// Centre distances `a` in the wheel's measuring plane, mm, distinct; those of a file in ascending order.
    pub center_distances: Vec<f64>,
    /// Least and greatest distance, mm, if [`Study::center_distances`] samples a tolerance band. Backlash grows with
    /// the distance: the least is at the low end of the band, the greatest at the high end.
    pub distance_band: Option<[f64; 2]>,
    /// `c`, mm: radial clearance of both bearings together, in the measuring plane.
    pub bearing_clearance: f64,
    /// The poses of every run; `None`: exactly the rows of `measured`.
    pub sweep: Option<SweepPlan>,
    /// Whether the extremes cover every assembly phase; otherwise only the phases of the listed matings.
    pub all_phases: bool,
    /// Measured rows in the order of their file; empty when there is none.
    pub measured: Vec<MeasuredRow>,
    /// Chordal error of the polygons, mm.
    pub chordal_error: f64,
    /// Tolerance of a comparison, µm of `j_wt`.
    pub tolerance_um: f64,
    /// Whether contact off the line of action passes a comparison.
    pub allow_off_line_contact: bool,
    /// Requirements on the pair.
    pub requirements: Requirements,
    /// Uncertainties of its measurements, if stated.
    pub uncertainty: Option<Uncertainty>,
    /// Notes on the statements about the wheel, and about the pinion.
    pub notes: [GearNotes; 2],
}

/// One centre distance, material and, where they are run apart, assembly phase.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Which end of the thickness tolerances.
    pub material: Material,
    /// The gears at this centre distance.
    pub assembly: AssembledPair,
    /// Wheel and pinion tooth that name the assembly phase.
    pub phase: Option<(u32, u32)>,
}

impl Run {
    /// Its centre distance, mm, and its material.
    pub(super) fn group_key(&self) -> (f64, Material) {
        (self.assembly.center_distance(), self.material)
    }
}

/// A run and its matings.
#[derive(Debug, Clone, PartialEq)]
pub struct RunPlan {
    /// The run.
    pub run: Run,
    /// The matings, in order.
    pub matings: Vec<Mating>,
}

impl Study {
    /// One wheel revolution of `pair` at its centre distance, with `steps_per_pitch` poses per pitch, starting at wheel
    /// tooth 1 and pinion tooth 1.
    ///
    /// ```
    /// use gearlash::analysis::{Analysis, Plan};
    /// use gearlash::gear::{AsBuilt, BasicGearData, Face, Gear, GearDesign};
    /// use gearlash::contact::Method;
    /// use gearlash::pair::GearPair;
    /// use gearlash::analysis::study::Study;
    ///
    /// let gear = |teeth| -> Result<Gear, gearlash::error::GearError> {
    ///     Gear::nominal(GearDesign::standard(BasicGearData::new(teeth, 2.0, 20f64.to_radians())?))
    /// };
    /// let wheel = AsBuilt::perfect(gear(31)?, Face::Front);
    /// let pinion = AsBuilt::perfect(gear(17)?, Face::Back);
    /// let study = Study::of_pair("31/17", &GearPair::new(wheel, pinion, 48.1)?, 8);
    /// let plan = Plan::new(&study, Method::Exact { certify: true }).with_checks();
    /// let analysis = Analysis::silently(&plan)?;
    /// assert_eq!(analysis.runs[0].poses.len(), 31 * 8);
    /// assert_eq!(analysis.unproven(), 0);
    /// # Ok::<(), gearlash::error::Error>(())
    /// ```
    pub fn of_pair(title: &str, pair: &GearPair, steps_per_pitch: u32) -> Study {
        let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member));
        let sweep = SweepPlan::wheel_revolution(pair, steps_per_pitch, (1, 1));
        Study {
            materials: vec![(Material::AsMeasured, wheel.clone(), pinion.clone())],
            face: pair.face(),
            lean: pair.lean(),
            sweep: Some(sweep),
            ..Study::plain(title, pair.locked(), vec![pair.center_distance()])
        }
    }

    /// The poses `sweep` of a pair with a drawn gear, with its wheel and pinion of each material at each centre distance, mm. Without
    /// `sweep`, exactly the rows of [`Study::measured`].
    pub fn of_drawn(
        title: &str,
        gears: Vec<(Material, OutlineGear, OutlineGear)>,
        locked: Member,
        center_distances: Vec<f64>,
        sweep: impl Into<Option<SweepPlan>>,
    ) -> Study {
        Study {
            drawn: gears,
            sweep: sweep.into(),
            ..Study::plain(title, locked, center_distances)
        }
    }

    /// A study without gears, with the defaults of a pair file.
    fn plain(title: &str, locked: Member, center_distances: Vec<f64>) -> Study {
        Study {
            title: title.to_owned(),
            materials: Vec::new(),
            drawn: Vec::new(),
            locked,
            face: [0.0; 2],
            lean: [0.0; 2],
            open_lean: [0.0; 2],
            bearing_ends: None,
            center_distances,
            distance_band: None,
            bearing_clearance: 0.0,
            sweep: None,
            all_phases: false,
            measured: Vec::new(),
            chordal_error: 1e-5,
            tolerance_um: 0.1,
            allow_off_line_contact: false,
            requirements: Requirements::new(),
            uncertainty: None,
            notes: [GearNotes::default(), GearNotes::default()],
        }
    }

    /// Two of its gears assembled at the centre distance `a`, mm.
    ///
    /// # Errors
    /// As [`GearPair::with_locked`].
    pub fn pair(&self, wheel: &AsBuilt, pinion: &AsBuilt, a: f64) -> Result<GearPair, GearError> {
        let pair = GearPair::with_locked(wheel.clone(), pinion.clone(), a, self.locked)?;
        pair.with_face(self.face)?.with_lean(self.lean)
    }

    /// The pair of each material at the centre distance `a`, mm.
    ///
    /// # Errors
    /// As [`GearPair::with_locked`] and [`OutlinePair::new`].
    pub fn pairs(&self, a: f64) -> Result<Vec<(Material, AssembledPair)>, Error> {
        let mut pairs = Vec::with_capacity(self.material_count());
        for (material, wheel, pinion) in &self.materials {
            pairs.push((*material, self.pair(wheel, pinion, a)?.into()));
        }
        for (material, wheel, pinion) in &self.drawn {
            let pair = OutlinePair::new(wheel.clone(), pinion.clone(), a, self.locked)?;
            pairs.push((*material, pair.into()));
        }
        Ok(pairs)
    }

    /// Its materials.
    pub fn material_names(&self) -> impl Iterator<Item = Material> + '_ {
        let drawn = self.drawn.iter().map(|(material, ..)| *material);
        let data = self.materials.iter().map(|(material, ..)| *material);
        data.chain(drawn)
    }

    /// Number of materials.
    pub fn material_count(&self) -> usize {
        self.material_names().count()
    }

    /// Keeps only the pairs of `material`.
    pub fn keep(&mut self, material: Material) {
        self.materials.retain(|gears| gears.0 == material);
        self.drawn.retain(|gears| gears.0 == material);
    }

    /// Teeth of wheel and pinion.
    pub fn teeth(&self) -> [u32; 2] {
        let of_data = |gear: &AsBuilt| gear.gear().basic_data().teeth();
        let data = self.materials.iter();
        let data = data.map(|(_, wheel, pinion)| [wheel, pinion].map(of_data));
        let drawn = self.drawn.iter();
        let drawn = drawn.map(|(_, wheel, pinion)| [wheel, pinion].map(OutlineGear::teeth));
        data.chain(drawn).next().unwrap_or_default()
    }

    /// The pair of each material at its first centre distance; none if it cannot be assembled.
    pub(super) fn first_pairs(&self) -> impl Iterator<Item = AssembledPair> {
        let pairs = self.center_distances.first().map(|a| self.pairs(*a));
        pairs.into_iter().flatten().flatten().map(|(_, pair)| pair)
    }

    /// Lost motion in arcmin at the gear `at`; NaN for pairs that cannot be assembled at their first distance, which [`Study::runs`] refuses.
    pub fn arcmin(&self, at: Member) -> BacklashUnit {
        let share = |pair: AssembledPair| pair.operating_pitch_radius(at) / pair.center_distance();
        BacklashUnit::Arcmin {
            at,
            share: self.first_pairs().next().map_or(f64::NAN, share),
        }
    }

    /// Whether its gears are helical.
    pub fn is_helical(&self) -> bool {
        let mut gears = self.materials.iter();
        gears.any(|(_, wheel, _)| wheel.gear().basic_data().hand().is_some())
    }

    /// Whether teeth deviate along the face: lead deviations, or leaning axes.
    pub fn deviates_along_face(&self) -> bool {
        self.has_pair(GearPair::deviates_along_face)
    }

    /// Whether axes lean, or may.
    pub fn leans(&self) -> bool {
        self.open_lean != [0.0; 2] || self.has_pair(GearPair::leans)
    }

    fn has_pair(&self, is: fn(&GearPair) -> bool) -> bool {
        let mut pairs = self.first_pairs();
        pairs.any(|pair| pair.data().is_some_and(is))
    }

    /// Whether a pair of teeth may be tightest anywhere on the face ([`GearPair::binds_anywhere`]).
    pub fn binds_anywhere(&self) -> bool {
        self.has_pair(GearPair::binds_anywhere)
    }

    /// Whether transverse sections differ along the face.
    pub fn varies_along_face(&self) -> bool {
        self.is_helical() || self.deviates_along_face()
    }

    /// [`Study::bearing_clearance`] of single poses, mm: 0 where the axes tilt in their bearings, which extremes alone cover.
    pub fn clearance_of_poses(&self) -> f64 {
        match self.bearing_ends {
            None => self.bearing_clearance,
            Some(_) => 0.0,
        }
    }

    /// Whether its poses cover whole revolutions.
    pub fn sweeps(&self) -> bool {
        matches!(
            self.sweep,
            Some(SweepPlan::Revolution { .. } | SweepPlan::Phases { .. })
        )
    }

    /// This study at other, separate centre distances, mm, without [`Study::distance_band`].
    ///
    /// # Errors
    /// As [`Study::pairs`], at a distance or, with bearing clearance, at `a − c`;
    /// [`GearError::MeasuredRows`] for a study that runs exactly its measured rows.
    pub fn at(mut self, center_distances: Vec<f64>) -> Result<Study, Error> {
        if self.sweep.is_none() {
            return Err(GearError::MeasuredRows.into());
        }
        for a in &center_distances {
            self.pairs(a - self.bearing_clearance)?;
        }
        self.center_distances = center_distances;
        self.distance_band = None;
        Ok(self)
    }

    /// Number of poses of [`Study::runs`].
    pub fn pose_count(&self) -> u64 {
        let materials = self.material_count() as u64;
        match &self.sweep {
            Some(plan) => {
                let runs = self.center_distances.len() as u64 * materials;
                plan.poses().saturating_mul(runs)
            }
            None => {
                let measured = self.measured_matings();
                let each = self.center_distances.iter();
                let counts = each.filter_map(|a| Some(measured.get(&a.to_bits())?.len() as u64));
                materials * counts.sum::<u64>()
            }
        }
    }

    /// Every centre distance with every material, distance by distance and phase by phase.
    ///
    /// # Errors
    /// None for a study from a file; otherwise a pair that cannot be assembled.
    pub fn runs(&self) -> Result<Vec<RunPlan>, Error> {
        let measured = self.measured_matings();
        let mut runs = Vec::with_capacity(self.center_distances.len() * self.material_count());
        for &a in &self.center_distances {
            for (material, assembly) in self.pairs(a)? {
                let plan = |phase, matings| RunPlan {
                    run: Run {
                        material,
                        assembly: assembly.clone(),
                        phase,
                    },
                    matings,
                };
                match &self.sweep {
                    None => {
                        let matings = measured.get(&a.to_bits()).cloned();
                        runs.push(plan(None, matings.unwrap_or_default()));
                    }
                    Some(sweep) => {
                        let parts = sweep.parts().into_iter();
                        runs.extend(
                            parts.map(|(phase, part)| plan(phase, part.matings(&assembly))),
                        );
                    }
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
            let mating = |flank| Mating::at(row.wheel_tooth, row.pinion_tooth, flank);
            of_distance.extend(Side::BOTH.map(mating));
        }
        matings
    }
}
