//! The tables of a pair file together: the values both gears must share, and the study.

use super::assembly;
use super::check::check;
use super::common_face;
use super::files::PairFile;
use super::gear::GearPart;
use super::measured::RigResults;
use super::outlines;
use super::spec::{
    AccuracySpec, AssemblySpec, CenterDistanceSpec, CompareSpec, EitherGearSpec, MAX_DISTANCES,
    MisalignmentSpec, PAIR, PairSpec, RequireSpec, ToleranceSpec, UncertaintySpec,
};
use super::sweep::Sweep;
use super::temperature::Temperature;
use super::tolerance_table;
use super::{pair_slips, shafts, temperature, unit_slips};
use crate::names;
use gearlash::analysis::study::{Material, Study};
use gearlash::gear::AsBuilt;
use gearlash::metrology::Toleranced;
use gearlash::outline::OutlineGear;
use gearlash_text::{Table, numbers};

/// Poses of a study, over all centre distances and materials: their result fills 27 GB.
pub const MAX_POSES: u64 = 10_000_000;

/// Bytes that a pose takes in a result as JSON, about: 900 where a pair is jammed to 2250 with tip corners.
pub const POSE_BYTES_JSON: u64 = 2250;

/// Bytes that a pose takes in a result as CSV, about.
pub const POSE_BYTES_CSV: u64 = 450;

/// The tables of a pair file: `None` for a table with a problem, `Some(None)` for an absent one.
pub struct PairTables<'a> {
    file: &'a Table<'a>,
    stem: String,
    title: Option<String>,
    /// Whether a gear is given by its outline.
    is_drawn: bool,
    wheel: GearPart,
    pinion: GearPart,
    assembly: Option<AssemblySpec>,
    poses: PosesRead,
    tolerance: Option<Option<ToleranceSpec>>,
}

/// `[sweep]` and `[measured]`: `None` for a table with a problem, `Some(None)` for an absent one.
struct PosesRead {
    measured: Option<Option<RigResults>>,
    /// `Some(None)`: exactly the measured rows are run.
    sweep: Option<Option<Sweep>>,
}

/// The gears in each material at their centre distances, in the wheel's measuring plane and at the temperature of the pair.
struct PlacedGears {
    materials: Vec<(Material, AsBuilt, AsBuilt)>,
    drawn: Vec<(Material, OutlineGear, OutlineGear)>,
    stated: CenterDistanceSpec,
    center_distances: Vec<f64>,
    band: Option<[f64; 2]>,
    face: [f64; 2],
}

impl<'a> PairTables<'a> {
    pub fn read(file: &'a Table<'a>) -> PairTables<'a> {
        check(&PAIR, file);
        let (stem, title) = names(file);
        let is_drawn = outlines::has_outline(file);
        if is_drawn {
            outlines::refuse_tables(file);
        }
        let wheel = GearPart::read(file, "wheel");
        let pinion = GearPart::read(file, "pinion");
        let poses = PosesRead::new(file, (wheel.known.teeth, pinion.known.teeth));
        PairTables {
            assembly: assembly::read(file, !rows_only(file)),
            poses,
            tolerance: tolerance_table::tolerance(file),
            file,
            stem,
            title,
            is_drawn,
            wheel,
            pinion,
        }
    }

    /// The study, after the checks that concern several tables.
    pub fn study(self) -> Option<PairFile> {
        let gears = [&self.wheel, &self.pinion];
        let mut warnings = gears.map(|gear| &gear.warnings[..]).concat();
        let mut remarks = gears.map(|gear| &gear.remarks[..]).concat();
        let placed = if self.is_drawn {
            self.drawn(&mut warnings, &mut remarks)?
        } else {
            self.by_data(&mut warnings, &mut remarks)?
        };
        let assembly = self.assembly?;
        let (measured, sweep, tolerance) =
            (self.poses.measured?, self.poses.sweep?, self.tolerance?);
        let accuracy: AccuracySpec = self.file.read("accuracy")?.unwrap_or_default();
        let compare: CompareSpec = self.file.read("compare")?.unwrap_or_default();
        let require: Option<RequireSpec> = self.file.read("require")?;
        let uncertainty: Option<UncertaintySpec> = self.file.read("uncertainty")?;
        let title = self.title?;
        let bearings = assembly.bearing_clearance_mm;
        warnings.extend(unit_slips::warnings("assembly", &assembly));
        warnings.extend(unit_slips::warnings("tolerance", &tolerance));
        warnings.extend(pair_slips::bearing_slips(&bearings));
        warnings.extend(pair_slips::face_slip(gears));
        let distances = &placed.center_distances;
        warnings.extend(pair_slips::distance_slips(
            &self.wheel,
            &self.pinion,
            distances,
        ));
        let compared = pair_slips::tolerance_slip("compare.tolerance_um", compare.tolerance_um);
        warnings.extend(compared);
        warnings.extend(measured.as_ref().and_then(RigResults::equal_rows));
        warnings.extend(measured.as_ref().and_then(RigResults::unpredicted));

        let built = match placed.materials.first() {
            Some((_, wheel, pinion)) => [Some(wheel), Some(pinion)],
            None => [&self.wheel.as_built, &self.pinion.as_built]
                .map(|gear| gear.as_ref().map(Toleranced::most)),
        };
        let amplification = gears.map(|gear| gear.notes.all_round?.amplification);
        let lean = [assembly.lean(), assembly.open_lean()];
        let spec = PairSpec {
            title: title.clone(),
            wheel: self.wheel.spec?,
            pinion: self.pinion.spec?,
            assembly: AssemblySpec {
                center_distance_mm: placed.stated,
                misalignment: assembly.misalignment.map(|stated| MisalignmentSpec {
                    at_mm: Some(assembly.distance_place_mm()),
                    ..stated
                }),
                ..assembly
            },
            measured: measured.as_ref().map(RigResults::spec),
            sweep: sweep.as_ref().map(|sweep| sweep.spec.clone()),
            accuracy: (!self.is_drawn).then_some(accuracy),
            compare: (!self.is_drawn).then_some(compare),
            require,
            uncertainty,
            tolerance,
        };
        let uncertainty = uncertainty.map(|stated| {
            let specs = [&spec.wheel, &spec.pinion].map(EitherGearSpec::data);
            let gears = [0, 1].map(|k| specs[k].zip(built[k]));
            stated.of_pair(&spec.assembly, gears, amplification)
        });
        let study = Study {
            title,
            materials: placed.materials,
            drawn: placed.drawn,
            locked: spec.assembly.locked,
            face: placed.face,
            lean: lean[0],
            open_lean: lean[1],
            bearing_ends: bearings.ends(),
            center_distances: placed.center_distances,
            distance_band: placed.band,
            bearing_clearance: bearings.sum_mm(),
            all_phases: sweep
                .as_ref()
                .is_some_and(|sweep| sweep.spec.extremes.is_some()),
            sweep: sweep.map(|sweep| sweep.plan),
            measured: measured.map_or_else(Vec::new, RigResults::into_rows),
            chordal_error: accuracy.chord_um / 1000.0,
            tolerance_um: compare.tolerance_um,
            allow_off_line_contact: compare.allow_off_line_contact,
            uncertainty,
            requirements: require.map_or_else(Vec::new, |require| require.requirements()),
            notes: [self.wheel.notes, self.pinion.notes],
        };
        Some(PairFile {
            study,
            stem: self.stem,
            spec,
            drawings: [self.wheel.drawing, self.pinion.drawing],
            left_out: self.is_drawn.then_some(
                "A drawn gear has no module and no involute: formulas and checks are left out.",
            ),
            warnings,
            remarks,
            sources: self.file.reading().sources(),
        })
    }

    /// The gears of a pair with an outline.
    fn drawn(&self, warnings: &mut Vec<String>, remarks: &mut Vec<String>) -> Option<PlacedGears> {
        let gears = [&self.wheel, &self.pinion];
        outlines::refuse_limits(self.file);
        outlines::refuse_uncertainties(self.file, gears);
        let assembly = self.assembly.as_ref()?;
        outlines::refuse_axes(self.file, assembly);
        self.file.reading().is_good().then_some(())?;
        let (wheel, pinion) = (self.wheel.outline()?, self.pinion.outline()?);
        let stated = self.poses.distances(self.file, assembly, None, warnings)?;
        let center_distances = stated.distances_mm();
        let band = stated.band_mm();
        let is_band = wheel.is_band() || pinion.is_band();
        self.poses
            .check_count(self.file, Some(&center_distances), is_band)?;
        let thickest = [wheel.most(), pinion.most()];
        outlines::check_distances(self.file, thickest, &center_distances, assembly)?;
        warnings.extend(outlines::slips(thickest, &center_distances, assembly));
        Temperature::read(self.file, assembly, gears)?;
        remarks.extend(self.file.reading().take_remarks());
        remarks.extend(meaning(&stated));
        Some(PlacedGears {
            materials: Vec::new(),
            drawn: in_materials(&wheel, &pinion),
            stated,
            center_distances,
            band,
            face: [0.0; 2],
        })
    }

    /// The gears of a pair by data.
    fn by_data(
        &self,
        warnings: &mut Vec<String>,
        remarks: &mut Vec<String>,
    ) -> Option<PlacedGears> {
        let base_radii = self.base_radii();
        let assembly = self.assembly.as_ref();
        let stated = assembly.and_then(|assembly| {
            self.poses
                .distances(self.file, assembly, base_radii, warnings)
        });
        let center_distances = stated.as_ref().map(CenterDistanceSpec::distances_mm);
        let gears = [&self.wheel, &self.pinion];
        let built = gears.map(|gear| gear.as_built.as_ref());
        let is_band = built.into_iter().flatten().any(Toleranced::is_band);
        self.poses
            .check_count(self.file, center_distances.as_deref(), is_band)?;
        let (stated, mut center_distances) = (stated?, center_distances?);
        let mut band = stated.band_mm();
        let assembly = assembly?;
        let (lean, open_lean) = (assembly.lean(), assembly.open_lean());
        let bearing_ends = assembly.bearing_clearance_mm.ends();
        if open_lean != [0.0; 2] {
            if assembly.distance_place_mm() != 0.0 && open_lean[0] != 0.0 {
                return self.file.refuse(
                    "assembly.misalignment.at_mm",
                    "given beside an in-plane deviation of unknown sense, allowed is 0",
                    "remove it, and state the centre distance in the wheel's measuring plane",
                );
            }
            remarks.push("assembly.misalignment: least and greatest of the verdict are over all deviations up to max, in either sense; single poses have none".to_owned());
        }
        if assembly.distance_place_mm() != 0.0 && lean != [0.0; 2] {
            self.poses
                .check_rows(self.file, "assembly.misalignment.at_mm")?;
            for mm in center_distances.iter_mut().chain(band.iter_mut().flatten()) {
                *mm = assembly.in_measuring_plane(*mm);
            }
            let listed: Vec<String> = center_distances
                .iter()
                .map(|mm| numbers::shortest(*mm))
                .collect();
            remarks.push(format!(
                "assembly.center_distance_mm: results name the distance in the wheel's measuring plane, {} mm",
                listed.join(", ")
            ));
        }
        let mut materials = in_materials(built[0]?, built[1]?);
        let temperature = Temperature::read(self.file, assembly, gears)?;
        if temperature.is_some() {
            self.poses.check_rows(self.file, "assembly.temperature_c")?;
        }
        remarks.extend(self.file.reading().take_remarks());
        if let Some(temperature) = temperature {
            materials = temperature.gears(self.file, materials)?;
            for mm in center_distances.iter_mut().chain(band.iter_mut().flatten()) {
                *mm = temperature.distance(*mm);
            }
            let described = temperature.described();
            remarks.push(format!("assembly.temperature_c: {described}"));
        }
        let base_radii = materials
            .first()
            .map(|(_, wheel, pinion)| wheel.gear().base_radius() + pinion.gear().base_radius())?;
        let is_shifted = temperature.is_some() || assembly.distance_place_mm() != 0.0;
        let mut distances = center_distances.iter();
        let overlap = distances.find_map(|&a| assembly::overlap(a, base_radii));
        if let Some(reason) = overlap.filter(|_| is_shifted) {
            let (key, help) = if temperature.is_some() {
                (
                    "temperature_c",
                    "check the temperature and the coefficients of expansion",
                )
            } else {
                (
                    "misalignment",
                    "check it, and where the centre distance holds",
                )
            };
            return self.file.refuse(&format!("assembly.{key}"), reason, help);
        }
        warnings.extend(shafts::check(self.file, assembly, materials.first())?);
        remarks.extend(meaning(&stated));
        let face_offset_mm = assembly.face_offset_mm;
        let warm = temperature.map_or([1.0; 2], |temperature| temperature.gear_factors());
        let factors = [self.wheel.scale * warm[0], self.pinion.scale * warm[1]];
        temperature::check_unequal(self.file, factors)?;
        // The distance of the measuring planes expands as the wheel does.
        let offset = face_offset_mm.unwrap_or(0.0) * warm[0];
        let uncertainty: Option<UncertaintySpec> = self.file.read("uncertainty")?;
        let is_uncertain = uncertainty.is_some_and(|stated| stated.misalignment_um.is_some());
        if is_uncertain && assembly.over_mm().is_none() {
            return self.file.refuse(
                "uncertainty.misalignment_um",
                "given without assembly.misalignment, to whose length it refers",
                "add misalignment = { over_mm = … } to [assembly], or remove it",
            );
        }
        let wobbles = |(_, wheel, pinion): &(Material, AsBuilt, AsBuilt)| {
            wheel.wobble() + pinion.wobble() > 0.0
        };
        let leans = is_uncertain
            || open_lean != [0.0; 2]
            || bearing_ends.is_some()
            || lean != [0.0; 2]
            || materials.iter().any(wobbles);
        let mut pairs = materials.iter();
        let profiled = pairs.find_map(|(_, wheel, pinion)| {
            let gears = [("wheel", wheel), ("pinion", pinion)];
            gears.into_iter().find(|(_, gear)| gear.is_modified())
        });
        if let Some((name, _)) = profiled.filter(|_| leans) {
            return self.file.refuse(
                &format!("{name}.profile"),
                "given beside axes that lean: sections of such teeth are not worked out",
                "leave it out, or the misalignment, the wobble and the bearing clearances at two ends",
            );
        }
        let face = common_face::common_face(self.file, gears, (offset, leans), factors)?;
        // Teeth are counted in the wheel's measuring plane.
        if face[0] < face[1] && face_offset_mm.is_some() {
            for (_, _, pinion) in &mut materials {
                *pinion = pinion.section_at(-offset);
            }
        }
        Some(PlacedGears {
            materials,
            drawn: Vec::new(),
            stated,
            center_distances,
            band,
            face,
        })
    }

    /// The sum of both base radii, mm, after the checks of values that the gears share.
    fn base_radii(&self) -> Option<f64> {
        assembly::check_shared(self.file, &self.wheel.known, &self.pinion.known)?;
        Some(self.wheel.base_radius()? + self.pinion.base_radius()?)
    }
}

/// Whether exactly the measured rows are run.
fn rows_only(file: &Table) -> bool {
    file.means("measured") && !file.means("sweep")
}

impl PosesRead {
    /// Reads both tables of `file`, a pair of gears with `teeth` teeth.
    fn new(file: &Table, teeth: (Option<u32>, Option<u32>)) -> PosesRead {
        PosesRead {
            measured: if file.means("measured") {
                RigResults::read(file, teeth).map(Some)
            } else {
                Some(None)
            },
            sweep: if rows_only(file) {
                Some(None)
            } else {
                Sweep::read(file, teeth).map(Some)
            },
        }
    }

    /// Reports the `key` that changes centre distances beside measured rows, which state their own.
    fn check_rows(&self, table: &Table, key: &str) -> Option<()> {
        if self.measured.as_ref()?.is_none() {
            return Some(());
        }
        table.refuse(
            key,
            "given together with measured, whose rows state their own centre distances",
            "remove one or the other",
        )
    }

    /// The centre distances to run, a list in ascending order. They are checked against the sum of `base_radii`, mm, if it is known.
    fn distances(
        &self,
        file: &Table,
        assembly: &AssemblySpec,
        base_radii: Option<f64>,
        warnings: &mut Vec<String>,
    ) -> Option<CenterDistanceSpec> {
        let given = &assembly.center_distance_mm;
        let mut stated = match (&self.sweep, self.measured.as_ref()?) {
            (Some(None), Some(measured)) => {
                let list = measured_distances(measured, base_radii);
                let given = given.distances_mm();
                if !given.is_empty()
                    && (given.len() != list.len() || list.iter().any(|mm| !given.contains(mm)))
                {
                    warnings.push(
                        "assembly.center_distance_mm is not used: without [sweep] exactly the rows of [measured] are run, at their centre distances".to_owned(),
                    );
                }
                CenterDistanceSpec::Distances(list)
            }
            _ => {
                let stated = given.clone();
                if let Some(base_radii) = base_radii {
                    let list = stated.distances_mm();
                    assembly::check_distances(file, &list, base_radii);
                }
                stated
            }
        };
        if let Some(base_radii) = base_radii {
            let (list, play) = (
                stated.distances_mm(),
                assembly.bearing_clearance_mm.sum_mm(),
            );
            assembly::check_clearance(file, &list, base_radii, play);
        }
        if let CenterDistanceSpec::Distances(list) = &mut stated {
            list.sort_unstable_by(f64::total_cmp);
        }
        Some(stated)
    }

    /// Reports a study of too many poses; `is_band`: it has least and most material.
    fn check_count(&self, table: &Table, distances: Option<&[f64]>, is_band: bool) -> Option<()> {
        let materials = 1 + u64::from(is_band);
        let (poses, key) = match (self.sweep.as_ref()?, self.measured.as_ref()?) {
            (Some(sweep), _) => {
                let runs = distances.map_or(1, <[f64]>::len) as u64 * materials;
                (sweep.plan.poses().saturating_mul(runs), "sweep")
            }
            (None, Some(measured)) => (2 * measured.rows.len() as u64 * materials, "measured.file"),
            (None, None) => return None,
        };
        if poses <= MAX_POSES {
            return Some(());
        }
        table.refuse(
            key,
            format!(
                "{poses} poses over all centre distances and materials, about {} of result, allowed are up to 10 million, {}",
                numbers::bytes(poses.saturating_mul(POSE_BYTES_JSON + POSE_BYTES_CSV)),
                numbers::bytes(MAX_POSES * (POSE_BYTES_JSON + POSE_BYTES_CSV)),
            ),
            "take fewer steps_per_pitch or fractions, or split the centre distances over several files",
        )
    }
}

/// The centre distances of measured rows, checked against the sum of `base_radii`, mm, if it is known.
fn measured_distances(measured: &RigResults, base_radii: Option<f64>) -> Vec<f64> {
    let list = measured.distances();
    measured.file.list(|| {
        for &(line, a) in &list {
            if let Some(reason) = base_radii.and_then(|sum| assembly::overlap(a, sum)) {
                let help = "correct the line, or remove it";
                measured.file.add_at(line, reason, help);
            }
        }
        Some(())
    });
    if let Some((line, _)) = list.get(MAX_DISTANCES) {
        measured.file.add_at(
            *line,
            "one centre distance too many, allowed are up to 10 000",
            "split the file",
        );
    }
    list.into_iter().map(|(_, a)| a).collect()
}

/// The meaning of a designated centre distance, for a remark.
fn meaning(stated: &CenterDistanceSpec) -> Option<String> {
    let CenterDistanceSpec::Designated(designated) = stated else {
        return None;
    };
    let words = designated.meaning()?;
    Some(format!("assembly.center_distance_mm: {words}"))
}

/// Both gears in each material. A gear with one material has it in both.
fn in_materials<T: Clone>(wheel: &Toleranced<T>, pinion: &Toleranced<T>) -> Vec<(Material, T, T)> {
    let most = (wheel.most().clone(), pinion.most().clone());
    if !wheel.is_band() && !pinion.is_band() {
        return vec![(Material::AsMeasured, most.0, most.1)];
    }
    let least = (wheel.least().clone(), pinion.least().clone());
    vec![
        (Material::Most, most.0, most.1),
        (Material::Least, least.0, least.1),
    ]
}
