//! Gears and matings in a few words, and comparisons that name their case.

#![allow(dead_code)] // each test binary uses its part

use gearlash::analysis::study::Study;
use gearlash::error::GearError;
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Hand, Lead,
    Modification, Pitch, Side, thickness,
};
use gearlash::pair::{GearPair, Mating, Member};
use serde::de::DeserializeOwned;
use std::fmt::Debug;
use std::path::Path;

/// `found` is `expected` within `within`; the message names `what`.
#[track_caller]
pub fn near(what: impl Debug, found: f64, expected: f64, within: f64) {
    let off = (found - expected).abs();
    assert!(off <= within, "{what:?}: {found}, not {expected}");
}

/// `tan α − α`.
pub fn inv(angle: f64) -> f64 {
    angle.tan() - angle
}

/// `j_wt`, mm, of perfect 20° gears at `a`, whose reference radii have this sum and whose teeth are thinner by so much together at the reference
/// circles: `2 a (inv α_wt − inv α) + thinner a/sum` (ISO 21771).
pub fn j_wt(a: f64, sum: f64, thinner: f64) -> f64 {
    let alpha = 20f64.to_radians();
    let operating = (sum * alpha.cos() / a).min(1.0).acos();
    2.0 * a * (inv(operating) - inv(alpha)) + thinner * a / sum
}

/// The least and the greatest of `values`.
pub fn ends(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    let wider = |[low, high]: [f64; 2], value: f64| [value.min(low), value.max(high)];
    values.into_iter().fold(start, wider)
}

/// Halves the interval from `low`, where `is_low` holds, to `high`, where it does not. Returns both ends.
pub fn halved(
    mut low: f64,
    mut high: f64,
    halvings: u32,
    is_low: impl Fn(f64) -> bool,
) -> [f64; 2] {
    for _ in 0..halvings {
        let middle = 0.5 * (low + high);
        *if is_low(middle) { &mut low } else { &mut high } = middle;
    }
    [low, high]
}

/// A gear to make. It is nominal and perfect where nothing else is said.
#[derive(Clone)]
pub struct Make {
    pub design: GearDesign,
    /// Allowance of the thickness at the reference circle in the normal section, mm.
    pub allowance: f64,
    /// Reduction of the base thickness, mm.
    pub thinner: f64,
    pub deviations: Deviations,
}

/// 20°, ISO 53 profile A, no profile shift; the gears of the test rig (Karba et al.) with 44 teeth of module 3.
pub fn spur(teeth: u32, module: f64) -> Make {
    spur_of_angle(teeth, module, 20.0)
}

/// [`spur`] of another pressure angle.
pub fn spur_of_angle(teeth: u32, module: f64, degrees: f64) -> Make {
    let data = BasicGearData::new(teeth, module, degrees.to_radians());
    Make::of(GearDesign::standard(data.unwrap()))
}

impl Make {
    pub fn of(design: GearDesign) -> Make {
        Make {
            design,
            allowance: 0.0,
            thinner: 0.0,
            deviations: Deviations::default(),
        }
    }

    pub fn shift(mut self, profile_shift: f64) -> Make {
        self.design.profile_shift = profile_shift;
        self
    }

    pub fn tip_diameter(mut self, mm: f64) -> Make {
        self.design.tip_diameter = Some(mm);
        self
    }

    pub fn rack(mut self, addendum: f64, dedendum: f64, root_radius: f64) -> Make {
        self.design.rack = BasicRack::new(addendum, dedendum, root_radius).unwrap();
        self
    }

    pub fn helix(mut self, degrees: f64, hand: Hand) -> Make {
        let data = self.design.basic_data;
        self.design.basic_data = data.with_helix(degrees.to_radians(), hand).unwrap();
        self
    }

    pub fn allowance(mut self, mm: f64) -> Make {
        self.allowance = mm;
        self
    }

    pub fn thinner(mut self, mm: f64) -> Make {
        self.thinner = mm;
        self
    }

    pub fn runout(mut self, eccentricity: f64, high_tooth: f64) -> Make {
        self.deviations.eccentricity = eccentricity;
        self.deviations.high_tooth = high_tooth;
        self
    }

    /// Whether the runout has any direction.
    pub fn open(mut self, any_direction: bool) -> Make {
        self.deviations.any_direction = any_direction;
        self
    }

    pub fn wobble(mut self, lean: f64, tooth: f64) -> Make {
        self.deviations.wobble = lean;
        self.deviations.wobble_tooth = tooth;
        self
    }

    pub fn profiles(mut self, profiles: [Modification; 2]) -> Make {
        self.deviations.profiles = profiles;
        self
    }

    pub fn leads(mut self, leads: [Lead; 2]) -> Make {
        self.deviations.leads = leads;
        self
    }

    pub fn per_tooth(mut self, mm: Vec<f64>) -> Make {
        self.deviations.per_tooth = mm;
        self
    }

    pub fn pitch(mut self, right: &[f64], left: &[f64]) -> Make {
        self.deviations.pitch = Some(Pitch::from_cumulative(right, left));
        self
    }

    pub fn try_gear(&self) -> Result<Gear, GearError> {
        let data = &self.design.basic_data;
        let nominal = self.design.nominal_base_thickness();
        let base = thickness::base_from_allowance(data, nominal, self.allowance) - self.thinner;
        Gear::new(self.design, base)
    }

    pub fn gear(&self) -> Gear {
        self.try_gear().unwrap()
    }

    pub fn try_built(&self, face: Face) -> Option<AsBuilt> {
        AsBuilt::new(self.try_gear().ok()?, face, &self.deviations).ok()
    }

    pub fn built(&self, face: Face) -> AsBuilt {
        AsBuilt::new(self.gear(), face, &self.deviations).unwrap()
    }

    pub fn front(&self) -> AsBuilt {
        self.built(Face::Front)
    }

    pub fn back(&self) -> AsBuilt {
        self.built(Face::Back)
    }
}

/// The wheel shows its front, the pinion its back; the wheel is locked.
pub fn pair(wheel: &Make, pinion: &Make, center_distance: f64) -> GearPair {
    locked(wheel, pinion, center_distance, Member::Wheel)
}

/// [`pair`] with either gear locked.
pub fn locked(wheel: &Make, pinion: &Make, center_distance: f64, member: Member) -> GearPair {
    GearPair::with_locked(wheel.front(), pinion.back(), center_distance, member).unwrap()
}

/// A mating of right flanks, and a part of a pitch from there.
pub fn at(wheel: u32, pinion: u32, fraction: f64) -> Mating {
    at_flank(wheel, pinion, Side::Right, fraction)
}

pub fn at_flank(wheel: u32, pinion: u32, flank: Side, fraction: f64) -> Mating {
    Mating {
        fraction,
        ..Mating::at(wheel, pinion, flank)
    }
}

/// µm of `j_wt` a radian of the free gear.
pub fn um(pair: &GearPair) -> f64 {
    1e3 * pair.operating_pitch_radius(pair.free())
}

/// The study of a pair file; its path counts from the root of the repository.
pub fn study(path: impl AsRef<Path>) -> Study {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    gearlash_input::read(&path).unwrap().study
}

/// The pair of a study that has one centre distance and one thickness.
pub fn pair_of(study: &Study) -> GearPair {
    let (_, wheel, pinion) = &study.materials[0];
    let pair = study.pair(wheel, pinion, study.center_distances[0]);
    pair.unwrap()
}

/// The rows of a table of comma-separated values below its head; lines that begin with # are comments.
pub fn rows<T: DeserializeOwned>(text: &str) -> Vec<T> {
    let mut reader = csv::ReaderBuilder::new();
    let reader = reader.comment(Some(b'#')).trim(csv::Trim::All);
    let mut reader = reader.from_reader(text.as_bytes());
    reader.deserialize().map(Result::unwrap).collect()
}
