//! One assembly of a population as a pair file.

use super::gears::thickness_band;
use super::population::ToleranceFile;
use crate::lead::with_added_leads;
use crate::spec::{
    BearingClearanceSpec, Either, EitherGearSpec, FaceRunoutSpec, GearSpec, PairSpec, PitchSpec,
    Revolutions, RunoutSpec, StatementSpec, SweepSpec, TeethEnd, ThicknessSpec,
};
use gearlash::error::Error;
use gearlash::gear::thickness::span_from_base;
use gearlash::gear::{AsBuilt, Flank, Side};
use gearlash::metrology::Wobble;
use gearlash::outline::AssembledPair;
use gearlash::pair::Member;
use gearlash::population::{Assembly, Draw, Sample};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::path::Path;

/// One of the worst assemblies of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Worst {
    /// Its number.
    pub number: u64,
    /// Least `j_wt`, mm.
    pub least_mm: Option<f64>,
    /// Greatest `j_wt`, mm.
    pub greatest_mm: Option<f64>,
    /// Its pair file.
    pub pair: Value,
}

/// The name of the pair file of the worst assembly, of the next worst, ….
pub fn worst_name(index: usize) -> String {
    format!("worst_{:02}.toml", index + 1)
}

/// Name and text of the pair file of the worst assembly (`index` 0), of the next worst, …, of the pair file at `path`. Drawings are named by
/// absolute paths, since the file is written to another folder.
pub fn worst_file(
    index: usize,
    worst: &Worst,
    path: &Path,
) -> (String, Result<String, toml::ser::Error>) {
    let mut pair = worst.pair.clone();
    for gear in Member::BOTH {
        let key = format!("/{}/outline/file", gear.name());
        if let Some(Value::String(file)) = pair.pointer_mut(&key)
            && let Ok(drawing) = std::path::absolute(path.with_file_name(&*file))
        {
            *file = drawing.display().to_string();
        }
    }
    // Pair files cause no error.
    let text = toml::to_string(&pair);
    let text = text.map(|text| format!("{WRITTEN}{}\n{text}", sha256(&text)));
    (worst_name(index), text)
}

/// Start of the first line of such a file; the hash of all other lines follows.
const WRITTEN: &str = "# written by gearlash tolerance; sha256 of the lines below: ";

/// The SHA-256 of `text` in hexadecimal digits.
pub fn sha256(text: &str) -> String {
    let digest = Sha256::digest(text.as_bytes());
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The wobble of `gear` as the runout of a shoulder of the reference diameter, on the reference face of a gear stated as `own`.
fn wobble(gear: &AsBuilt, own: &GearSpec) -> Option<FaceRunoutSpec> {
    let data = gear.gear().basic_data();
    let wobble = Wobble {
        lean: gear.wobble(),
        tooth: gear.wobble_tooth(),
    };
    let diameter_mm = 2.0 * data.reference_radius();
    let [near, _] = own.heights()?;
    (wobble.lean > 0.0).then(|| FaceRunoutSpec {
        um: 1e3 * wobble.lean * diameter_mm,
        diameter_mm,
        high_tooth: wobble.tooth_at(data, near),
        face: Some(TeethEnd::Reference),
    })
}

/// Whether `text` is an unchanged file of [`worst_file`].
pub fn is_worst_file(text: &str) -> bool {
    let hashed = text.strip_prefix(WRITTEN);
    let parts = hashed.and_then(|rest| rest.split_once('\n'));
    parts.is_some_and(|(stated, below)| stated == sha256(below))
}

impl ToleranceFile {
    /// Assembly `number` of `sample`.
    ///
    /// # Errors
    /// As [`Assembly::outcome`].
    pub(super) fn worst(&self, sample: &Sample<'_>, number: u64) -> Result<Worst, Error> {
        let draw = sample.draw(number);
        let assembly = self.population.assembly(draw)?;
        let found = assembly.outcome()?;
        let title = format!(
            "{}, assembly {number} of seed {}",
            self.pair.spec.title, sample.seed
        );
        let spec = self.spec_of(&assembly, draw, title);
        Ok(Worst {
            number,
            least_mm: found.least,
            greatest_mm: found.greatest,
            // Cannot fail: gears by data, plain structs with text keys.
            pair: serde_json::to_value(spec).unwrap_or_default(),
        })
    }

    /// `assembly` as a pair file without the population.
    fn spec_of(&self, assembly: &Assembly, draw: Draw, title: String) -> Option<PairSpec> {
        let own = &self.pair.spec;
        let pair = &assembly.pair;
        let bearings = own.assembly.bearing_clearance_mm;
        let is_own = bearings.sum_mm() == assembly.clearance;
        let mut spec = own.clone();
        spec.title = title;
        spec.wheel = self.gear_spec(assembly, draw, Member::Wheel)?;
        spec.pinion = self.gear_spec(assembly, draw, Member::Pinion)?;
        spec.assembly = spec.assembly.at(vec![pair.center_distance()]);
        let scatters = self.population.scatters();
        if scatters.lean != [None, None] {
            spec.assembly = spec.assembly.with_lean(pair.lean());
        }
        if !is_own {
            spec.assembly.bearing_clearance_mm =
                BearingClearanceSpec::of([assembly.clearance, 0.0]);
        }
        spec.sweep = Some(SweepSpec {
            revolutions: Some(Revolutions::Wheel),
            start: Some([1, assembly.phase]),
            ..SweepSpec::default()
        });
        (spec.measured, spec.uncertainty, spec.tolerance) = (None, None, None);
        Some(spec)
    }

    /// A gear of a pair with an outline, with its flank offset and its runout.
    fn of_outlines(&self, pair: &AssembledPair, member: Member) -> EitherGearSpec {
        let mut own = [&self.pair.spec.wheel, &self.pair.spec.pinion][member as usize].clone();
        let (scale, scatter) = (
            own.scale().unwrap_or(1.0),
            self.population.scatters().of(member),
        );
        if let EitherGearSpec::Outline(spec) = &mut own
            && (scatter.thickness.is_some() || thickness_band(&self.pair, member).is_some())
        {
            let offset = pair.flank_offset(member).map(|mm| Either::One(mm / scale));
            spec.thickness.get_or_insert_default().flank_offset_mm = offset;
        }
        if scatter.runout.is_none() {
            return own;
        }
        let eccentricity = pair.eccentricity(member);
        let runout = RunoutSpec {
            total_um: Some(2e3 * eccentricity / scale),
            high_tooth: (eccentricity > 0.0).then(|| pair.high_tooth(member)),
            ..RunoutSpec::default()
        };
        match &mut own {
            EitherGearSpec::Data(spec) => spec.runout = runout,
            EitherGearSpec::Outline(spec) => spec.runout = runout,
        }
        own
    }

    /// A gear as it is: the mean thickness that the tool cut, the deviations of each flank, its runout.
    fn gear_spec(&self, assembly: &Assembly, draw: Draw, member: Member) -> Option<EitherGearSpec> {
        let Some(pair) = assembly.pair.data() else {
            return Some(self.of_outlines(&assembly.pair, member));
        };
        let gear = pair.gear(member);
        let own = self.pair.spec.data(member)?;
        let measured = &self.measured[member as usize];
        // Finds the drawn whole gear by all but its runout, whose direction can be drawn.
        let centred = |gear: &AsBuilt| gear.with_runout(0.0, 1.0).ok();
        let drawn = self.population.scatters().of(member).gears.iter();
        let mut drawn = drawn.flat_map(|gears| gears.iter()).zip(measured);
        let own_centred = centred(gear);
        let same = drawn.find(|(one, _)| centred(one) == own_centred);
        let own = same.map_or(own, |(_, one)| &one.spec);
        let gear = gear.in_measuring_plane();
        // Lengths and deviations as stated; the file states the factor.
        let unscaled = own.scale.map(|scale| gear.expanded(1.0 / scale));
        let gear = &unscaled
            .and_then(Result::ok)
            .unwrap_or_else(|| gear.clone());
        let teeth = gear.gear().basic_data().teeth();
        let radius = gear.gear().basic_data().reference_radius();
        // Where teeth differ in thickness, each thickness is stated and the rest is pitch. Elsewhere all deviation is pitch.
        let scatters = self.population.scatters();
        let stated = own.thickness.per_tooth_um.as_ref();
        let differ =
            scatters.of(member).per_tooth.is_some() || stated.is_some_and(|each| !each.is_empty());
        let thicker = |tooth: u32| {
            if differ {
                let turned = Side::BOTH.map(|side| side.sense() * gear.stated_offset(side, tooth));
                radius * turned.iter().sum::<f64>()
            } else {
                0.0
            }
        };
        let pitch = |own: Flank| -> Vec<f64> {
            let side = gear.face().seen_from_front(own);
            let along = 1e3 * gear.face().ascending();
            let offset = |tooth: u32| {
                radius * gear.stated_offset(side, tooth) - 0.5 * side.sense() * thicker(tooth)
            };
            (1..=teeth).map(|tooth| along * offset(tooth)).collect()
        };
        let (right, left) = (pitch(Flank::Right), pitch(Flank::Left));
        let deviates = right.iter().chain(&left).any(|um| *um != 0.0);
        let eccentricity = gear.eccentricity();
        // As a span over one tooth: in the normal section.
        let base = span_from_base(gear.gear().basic_data(), 1, gear.gear().base_thickness());
        Some(EitherGearSpec::Data(Box::new(GearSpec {
            reference_face: gear.face(),
            face_mm: own.heights().map(|ends| gear.face().heights(ends)),
            thickness: ThicknessSpec {
                statement: StatementSpec {
                    base_thickness_mm: Some(Either::One(base)),
                    ..StatementSpec::default()
                },
                per_tooth_um: differ.then(|| {
                    let normal = 1e3 * gear.gear().basic_data().helix_cos();
                    (1..=teeth).map(|tooth| normal * thicker(tooth)).collect()
                }),
                ..ThicknessSpec::default()
            },
            runout: RunoutSpec {
                total_um: Some(2e3 * eccentricity),
                face_runout: wobble(gear, own),
                high_tooth: (eccentricity > 0.0).then(|| gear.high_tooth()),
                ..RunoutSpec::default()
            },
            pitch: deviates.then_some(PitchSpec {
                right_um: Some(right),
                left_um: Some(left),
                ..PitchSpec::default()
            }),
            lead: match self.population.leads(draw, member) {
                Some(further) => with_added_leads(own, &further),
                None => own.lead.clone(),
            },
            ..own.clone()
        })))
    }
}
