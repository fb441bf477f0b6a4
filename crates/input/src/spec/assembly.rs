//! The assembly of the pair, and the poses to run and to compare.

use super::rules::{
    at_least, at_most_one, beside, beside_places, deviation, exactly_one, length, list_length,
    not_beside, whole, within,
};
use super::value::{Either, one_or_list};
use gearlash::analysis::axes::BearingEnds;
use gearlash::error::GearError;
use gearlash::pair::{DesignatedDistance, ISO_286_SOURCE, Member};
use gearlash_text::numbers::{rounded, shortest};
use schemars::{JsonSchema, Schema};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::Value;
use serde_with::skip_serializing_none;
use std::str::FromStr;

/// "30 js7", "30,0 H7", "30 ±0.02", "30 +0.03/0".
pub(crate) const DISTANCE_FIELD: &str = r"^ *[0-9.,]+ *((js|JS|[HhFf]) *([5-9]|10)|(±|\+-) *[0-9.,]+|([-+−] *[0-9.,]+| [0.,]+)( */ *([-+−] *[0-9.,]+|[0.,]+)| *[-+−] *[0-9.,]+| +0)?) *$";
/// Centre distances of one file: each is a run that holds both gears.
pub const MAX_DISTANCES: usize = 10_000;
/// Poses a pitch where none are stated.
pub(crate) const DEFAULT_STEPS: u32 = 16;

/// How the gears are put together.
#[skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(transform = both_spellings)]
pub struct AssemblySpec {
    /// Centre distance a; with measured and no sweep its rows decide.
    #[serde(default = "no_distances", alias = "centre_distance_mm")]
    pub center_distance_mm: CenterDistanceSpec,
    /// The gear that stands still, "wheel" or "pinion".
    #[serde(default)]
    pub locked: Member,
    /// Radial play of each gear on its axis.
    #[serde(default, deserialize_with = "both_or_each")]
    #[schemars(with = "Either<f64, BearingClearanceSpec>", transform = at_least(0.0))]
    pub bearing_clearance_mm: BearingClearanceSpec,
    /// Deviation of the shafts from parallel.
    pub misalignment: Option<MisalignmentSpec>,
    /// Axial offset of the pinion's measuring plane from the wheel's, away from the viewer; none: 0.
    #[schemars(transform = within(-1e6, 1e6))]
    pub face_offset_mm: Option<f64>,
    /// Temperature of gears and housing; all lengths but bearing play are stated at 20 °C.
    #[schemars(transform = within(-200.0, 400.0))]
    pub temperature_c: Option<f64>,
    /// Thermal expansion of the housing: 23e-6 of aluminium.
    #[schemars(transform = within(0.0, 3e-4))]
    pub housing_expansion_per_k: Option<f64>,
}

impl AssemblySpec {
    /// Lean of the pinion's axis from the wheel's, mm per mm: in the plane of the axes, and out of it.
    pub fn lean(&self) -> [f64; 2] {
        let [[in_plane, _], [out_of_plane, _]] = self.stated_leans();
        match &self.center_distance_mm {
            CenterDistanceSpec::Ends(ends) => [ends.lean(out_of_plane), out_of_plane],
            _ => [in_plane, out_of_plane],
        }
    }

    /// Greatest further lean of the pinion's axis in either sense, mm per mm: in the plane of the axes, and out of it.
    pub fn open_lean(&self) -> [f64; 2] {
        self.stated_leans().map(|[_, greatest]| greatest)
    }

    /// Lean in the plane of the axes and out of it, mm per mm: as stated, and the greatest of an unknown sense.
    fn stated_leans(&self) -> [[f64; 2]; 2] {
        let Some(stated) = self.misalignment else {
            return [[0.0; 2]; 2];
        };
        [stated.in_plane_um, stated.out_of_plane_um].map(|deviation| {
            let um = match deviation {
                Either::One(um) => [um, 0.0],
                Either::Other(greatest) => [0.0, greatest.max],
            };
            um.map(|um| um / 1e3 / stated.over_mm)
        })
    }

    /// The place along the axes at which the first stated centre distance holds, mm from the wheel's measuring plane.
    pub fn distance_place_mm(&self) -> f64 {
        match &self.center_distance_mm {
            CenterDistanceSpec::Ends(ends) => ends.ends_mm[0][0],
            _ => self
                .misalignment
                .and_then(|stated| stated.at_mm)
                .unwrap_or(0.0),
        }
    }

    /// These axes with the lean of the pinion's, mm per mm, over the length of their stated deviation.
    pub fn with_lean(mut self, lean: [f64; 2]) -> AssemblySpec {
        if let Some(stated) = &mut self.misalignment {
            let um = |lean: f64| Either::One(1e3 * lean * stated.over_mm);
            (stated.in_plane_um, stated.out_of_plane_um) = (um(lean[0]), um(lean[1]));
        }
        self
    }

    /// Length along the axes over which their deviations are stated, mm.
    pub fn over_mm(&self) -> Option<f64> {
        match &self.center_distance_mm {
            CenterDistanceSpec::Ends(ends) => Some(ends.length().abs()),
            _ => self.misalignment.map(|stated| stated.over_mm),
        }
    }

    /// The one stated centre distance, mm in the wheel's measuring plane.
    pub fn single_distance_mm(&self) -> Option<f64> {
        let nominal = self.center_distance_mm.nominal_mm()?;
        Some(self.in_measuring_plane(nominal))
    }

    /// The centre distance in the wheel's measuring plane where a stated one is `mm`.
    pub fn in_measuring_plane(&self, mm: f64) -> f64 {
        let ([in_plane, out_of_plane], at) = (self.lean(), self.distance_place_mm());
        if at == 0.0 || (in_plane, out_of_plane) == (0.0, 0.0) {
            return mm;
        }
        rounded(across(mm, out_of_plane * at) - in_plane * at, 12)
    }

    /// This assembly at `distances` in the wheel's measuring plane, mm, with the same axes.
    pub fn at(mut self, distances: Vec<f64>) -> AssemblySpec {
        let (lean, open) = (self.lean(), self.open_lean());
        if let CenterDistanceSpec::Ends(ends) = &self.center_distance_mm {
            let over_mm = ends.length().abs();
            let [in_plane_um, out_of_plane_um] = [0, 1].map(|k| match open[k] {
                0.0 => Either::One(1e3 * lean[k] * over_mm),
                most => Either::Other(EitherSenseSpec {
                    max: 1e3 * most * over_mm,
                }),
            });
            self.misalignment = Some(MisalignmentSpec {
                in_plane_um,
                out_of_plane_um,
                over_mm,
                at_mm: None,
            });
        }
        if let Some(stated) = &mut self.misalignment {
            stated.at_mm = Some(0.0);
        }
        AssemblySpec {
            center_distance_mm: CenterDistanceSpec::Distances(distances),
            ..self
        }
    }
}

/// The in-plane part of a centre distance, mm, of axes that stand `out_of_plane` mm out of their plane.
fn across(mm: f64, out_of_plane: f64) -> f64 {
    (mm * mm - out_of_plane * out_of_plane).max(0.0).sqrt()
}

/// Deviations of the axes from parallel, ISO/TR 10064-3.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline, transform = deviation())]
pub struct MisalignmentSpec {
    /// In-plane deviation f_Σδ; plus: further apart away from the viewer.
    #[serde(default = "parallel")]
    pub in_plane_um: Either<f64, EitherSenseSpec>,
    /// Out-of-plane deviation f_Σβ; plus: the pinion stands higher there.
    #[serde(default = "parallel")]
    pub out_of_plane_um: Either<f64, EitherSenseSpec>,
    /// Length over which both are stated.
    #[schemars(transform = length())]
    pub over_mm: f64,
    /// Place where the centre distance holds, from the wheel's measuring plane; default: 0.
    #[schemars(transform = within(-1e6, 1e6))]
    pub at_mm: Option<f64>,
}

fn parallel() -> Either<f64, EitherSenseSpec> {
    Either::One(0.0)
}

/// A deviation of unknown sense.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub struct EitherSenseSpec {
    /// Its greatest amount; the verdict covers all up to it, in either sense.
    pub max: f64,
}

/// `centre_distance_mm` is `center_distance_mm`.
fn both_spellings(schema: &mut Schema) {
    let [american, british] = ["center_distance_mm", "centre_distance_mm"];
    if let Some(Value::Object(properties)) = schema.get_mut("properties")
        && let Some(distance) = properties.get(american).cloned()
    {
        let mut distance = distance;
        distance["description"] = "The same key in British spelling.".into();
        properties.insert(british.to_owned(), distance);
    }
    at_most_one(schema, &[&[american], &[british]]);
}

/// An empty list of distances.
fn no_distances() -> CenterDistanceSpec {
    CenterDistanceSpec::Distances(Vec::new())
}

/// The centre distances of a pair file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(inline)]
pub enum CenterDistanceSpec {
    /// One distance, or a list, mm.
    #[schemars(with = "Either<f64, Vec<f64>>")]
    #[schemars(transform = length(), transform = list_length(1, Some(MAX_DISTANCES)))]
    Distances(#[serde(deserialize_with = "one_or_list")] Vec<f64>),
    /// Nominal distance and tolerance.
    #[schemars(description = "")] // that of the struct
    Band(DistanceBandSpec),
    /// Nominal distance and tolerance field, ISO 286.
    #[schemars(description = "")] // that of the struct
    Designated(DesignatedDistanceSpec),
    /// Distances at two places along the axes.
    #[schemars(description = "")] // that of the struct
    Ends(DistanceEndsSpec),
}

impl CenterDistanceSpec {
    /// The distances to run, mm: the least, the nominal and the greatest of a band.
    pub fn distances_mm(&self) -> Vec<f64> {
        match self {
            CenterDistanceSpec::Distances(list) => list.clone(),
            CenterDistanceSpec::Ends(ends) => vec![ends.ends_mm[0][1]],
            _ => self
                .band()
                .map_or(Vec::new(), DistanceBandSpec::distances_mm),
        }
    }

    /// The one stated distance, mm: the nominal one of a band; `None` for several.
    pub fn nominal_mm(&self) -> Option<f64> {
        match self {
            CenterDistanceSpec::Distances(list) => match list[..] {
                [only] => Some(only),
                _ => None,
            },
            CenterDistanceSpec::Ends(ends) => Some(ends.ends_mm[0][1]),
            _ => Some(self.band()?.nominal_mm),
        }
    }

    /// The least and the greatest distance of a band, mm.
    pub fn band_mm(&self) -> Option<[f64; 2]> {
        self.band().map(DistanceBandSpec::ends_mm)
    }

    fn band(&self) -> Option<&DistanceBandSpec> {
        match self {
            CenterDistanceSpec::Band(band) => Some(band),
            CenterDistanceSpec::Designated(designated) => Some(&designated.band),
            CenterDistanceSpec::Distances(_) | CenterDistanceSpec::Ends(_) => None,
        }
    }
}

/// A nominal distance, mm, and its tolerance as a drawing writes it: js, H, h, F or f of ISO 286, grades 5 to 10, ± mm, or +0.03/0.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[serde(transparent)]
#[schemars(inline)]
pub struct DesignatedDistanceSpec {
    #[schemars(regex(pattern = DISTANCE_FIELD))]
    text: String,
    /// Its meaning as a band.
    #[serde(skip)]
    band: DistanceBandSpec,
    #[serde(skip)]
    is_field: bool,
}

/// Keeps the stated text and its meaning. Errors: a text that is no designation, and a size beyond the table of ISO 286.
impl FromStr for DesignatedDistanceSpec {
    type Err = GearError;

    fn from_str(text: &str) -> Result<DesignatedDistanceSpec, GearError> {
        let stated: DesignatedDistance = text.parse()?;
        let [lower, upper] = stated.deviations_um()?;
        Ok(DesignatedDistanceSpec {
            text: stated.to_string(),
            band: DistanceBandSpec {
                nominal_mm: stated.nominal(),
                tolerance_um: None,
                upper_um: Some(upper),
                lower_um: Some(lower),
            },
            is_field: stated.is_field(),
        })
    }
}

impl DesignatedDistanceSpec {
    /// The meaning of a tolerance field: "30 js7 is 30 ± 0.0105 mm", "30 H7 is 30 … 30.021 mm".
    pub fn meaning(&self) -> Option<String> {
        let (text, nominal) = (&self.text, self.band.nominal_mm);
        let [least, greatest] = self.band.ends_mm();
        let half = rounded(greatest - nominal, 12);
        let limits = if half == rounded(nominal - least, 12) {
            format!("{} ± {}", shortest(nominal), shortest(half))
        } else {
            format!("{} … {}", shortest(least), shortest(greatest))
        };
        self.is_field
            .then(|| format!("{text} is {limits} mm, {ISO_286_SOURCE}"))
    }
}

impl<'de> Deserialize<'de> for DesignatedDistanceSpec {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<DesignatedDistanceSpec, D::Error> {
        let text = String::deserialize(from)?;
        text.parse().map_err(D::Error::custom)
    }
}

/// A nominal distance with tolerance_um, or with upper_um and lower_um: least, nominal and greatest are run.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline, transform = band_keys, transform = deviation())]
pub struct DistanceBandSpec {
    /// Nominal centre distance, mm.
    #[schemars(transform = length())]
    pub nominal_mm: f64,
    /// Symmetric tolerance, ± µm.
    #[schemars(transform = within(0.0, 1e7))]
    pub tolerance_um: Option<f64>,
    /// Upper deviation, µm.
    pub upper_um: Option<f64>,
    /// Lower deviation, µm, at most the upper one.
    pub lower_um: Option<f64>,
}

impl DistanceBandSpec {
    /// The least and the greatest distance, mm.
    pub fn ends_mm(&self) -> [f64; 2] {
        let [lower, upper] = match self.tolerance_um {
            Some(tolerance) => [-tolerance, tolerance],
            None => [self.lower_um, self.upper_um].map(|um| um.unwrap_or(0.0)),
        };
        // A millionth of a nm: 132.2 mm + 50 µm is the f64 of 132.25.
        [lower, upper].map(|um| rounded(self.nominal_mm + um / 1000.0, 12))
    }

    /// Both ends and, where it lies between them, the nominal distance, ascending, mm.
    fn distances_mm(&self) -> Vec<f64> {
        let [least, greatest] = self.ends_mm();
        let mut distances = vec![least, greatest];
        if least < self.nominal_mm && self.nominal_mm < greatest {
            distances.insert(1, self.nominal_mm);
        }
        distances.dedup();
        distances
    }
}

fn band_keys(schema: &mut Schema) {
    exactly_one(schema, &[&["tolerance_um"], &["upper_um", "lower_um"]]);
}

/// Centre distances as measured at two places, as at both walls: the axes lean in their plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline)]
pub struct DistanceEndsSpec {
    /// Place along the axes from the wheel's measuring plane, away from the viewer, and centre distance there, twice.
    #[schemars(transform = within(-1e9, 1e9))]
    pub ends_mm: [[f64; 2]; 2],
}

impl DistanceEndsSpec {
    /// Distance of both places, mm.
    fn length(&self) -> f64 {
        self.ends_mm[1][0] - self.ends_mm[0][0]
    }

    /// Lean in the plane of the axes, mm per mm, of axes that lean `out_of_plane`.
    fn lean(&self, out_of_plane: f64) -> f64 {
        let [one, other] = self.ends_mm.map(|[at, mm]| across(mm, out_of_plane * at));
        (other - one) / self.length()
    }
}

/// One for each gear; in bearings at two places one for both or each, and the places.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(inline, transform = clearance_keys, transform = at_least(0.0))]
pub struct BearingClearanceSpec {
    /// The wheel's, mm.
    pub wheel: Either<f64, [f64; 2]>,
    /// The pinion's, mm.
    pub pinion: Either<f64, [f64; 2]>,
    /// Places of both bearings, from the wheel's measuring plane: the verdict covers axes that tilt in them.
    #[schemars(transform = within(-1e6, 1e6))]
    pub at_mm: Option<[f64; 2]>,
}

impl Default for BearingClearanceSpec {
    fn default() -> BearingClearanceSpec {
        BearingClearanceSpec::of([0.0; 2])
    }
}

/// A list needs its places.
fn clearance_keys(schema: &mut Schema) {
    beside_places(schema, &["wheel", "pinion"], "at_mm");
}

impl BearingClearanceSpec {
    /// Clearance of the wheel and of the pinion, mm.
    pub fn of([wheel, pinion]: [f64; 2]) -> BearingClearanceSpec {
        BearingClearanceSpec {
            wheel: Either::One(wheel),
            pinion: Either::One(pinion),
            at_mm: None,
        }
    }

    /// Clearance of each gear at both ends, mm, wheel first.
    pub fn each(&self) -> [[f64; 2]; 2] {
        [self.wheel, self.pinion].map(|stated| match stated {
            Either::One(mm) => [mm; 2],
            Either::Other(ends) => ends,
        })
    }

    /// Bearings whose places are stated.
    pub fn ends(&self) -> Option<BearingEnds> {
        let [wheel, pinion] = self.each();
        Some(BearingEnds {
            at: self.at_mm?,
            clearance: [0, 1].map(|k| wheel[k] + pinion[k]),
        })
    }

    /// The sum of both in the measuring plane, mm: the gears can approach by this much.
    pub fn sum_mm(&self) -> f64 {
        let [wheel, pinion] = self.each();
        self.ends()
            .map_or(wheel[0] + pinion[0], |ends| ends.clearance_at(0.0))
    }
}

fn both_or_each<'de, D: Deserializer<'de>>(from: D) -> Result<BearingClearanceSpec, D::Error> {
    Ok(match Either::deserialize(from)? {
        Either::One(both) => BearingClearanceSpec::of([both; 2]),
        Either::Other(each) => each,
    })
}

/// Measured backlash to set beside the simulation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MeasuredSpec {
    /// CSV file beside the pair file.
    pub file: String,
}

/// Which poses: one of mating, revolutions and phases; none: one revolution of the wheel.
#[skip_serializing_none]
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(extend("minProperties" = 1), transform = sweep_keys)]
pub struct SweepSpec {
    /// Wheel and pinion tooth, in place of revolutions: a right-flank and a left-flank pose each.
    #[schemars(length(min = 1), transform = whole(1, 10_000))]
    pub mating: Option<Vec<[u32; 2]>>,
    /// Pitches beyond each mating.
    #[schemars(length(min = 1), transform = within(-1000.0, 1000.0))]
    pub fraction: Option<Vec<f64>>,
    /// How far the gears turn: one "wheel" revolution (default), or "hunting", until the same teeth meet again.
    pub revolutions: Option<Revolutions>,
    /// Every assembly phase, in place of revolutions.
    pub phases: Option<Phases>,
    /// Phases of verdict and extremes; none: of the listed poses, all with steps_per_pitch alone.
    pub extremes: Option<ExtremePhases>,
    /// Poses a pitch.
    #[schemars(extend("default" = DEFAULT_STEPS), transform = whole(1, 1000))]
    pub steps_per_pitch: Option<u32>,
    /// Wheel and pinion tooth that mate first.
    #[schemars(transform = whole(1, 10_000))]
    pub start: Option<[u32; 2]>,
}

/// How far the gears turn.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum Revolutions {
    /// One turn of the wheel.
    Wheel,
    /// Until the same teeth meet again.
    Hunting,
}

/// Which assembly phases are run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub enum Phases {
    /// Every one.
    All,
}

/// Which assembly phases verdict and extremes cover.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(inline)]
pub enum ExtremePhases {
    /// Every one.
    AllPhases,
}

/// Settings of the polygon method.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct AccuracySpec {
    /// Chordal error before refinement; changes time, no result.
    #[schemars(transform = within(1e-5, 100.0))]
    pub chord_um: f64,
}

impl Default for AccuracySpec {
    fn default() -> AccuracySpec {
        AccuracySpec { chord_um: 0.01 }
    }
}

/// Settings of gearlash compare.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct CompareSpec {
    /// Tolerance of j_wt.
    #[schemars(transform = at_least(0.0))]
    pub tolerance_um: f64,
    /// Whether contact off the line of action passes.
    pub allow_off_line_contact: bool,
}

impl Default for CompareSpec {
    fn default() -> CompareSpec {
        CompareSpec {
            tolerance_um: 0.1,
            allow_off_line_contact: false,
        }
    }
}

fn sweep_keys(schema: &mut Schema) {
    at_most_one(schema, &[&["mating"], &["revolutions"], &["phases"]]);
    beside(schema, "fraction", &[&["mating"]]);
    not_beside(schema, "start", &["mating", "phases"]);
    not_beside(schema, "extremes", &["mating", "phases"]);
    not_beside(schema, "steps_per_pitch", &["mating"]);
}
