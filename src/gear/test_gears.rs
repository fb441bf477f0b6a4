//! Gears of unit tests.

use super::{AsBuilt, BasicGearData, Deviations, Face, Gear, GearDesign, Hand, Pitch};

impl GearDesign {
    /// The usual gear of tests: 20°, ISO 53 profile A, no profile shift.
    pub(crate) fn plain(teeth: u32, module: f64) -> GearDesign {
        GearDesign::standard(BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap())
    }

    /// This design with a profile shift.
    pub(crate) fn shifted(self, profile_shift: f64) -> GearDesign {
        GearDesign {
            profile_shift,
            ..self
        }
    }

    /// This design with a helix angle.
    pub(crate) fn helical(self, degrees: f64, hand: Hand) -> GearDesign {
        let data = self.basic_data.with_helix(degrees.to_radians(), hand);
        GearDesign {
            basic_data: data.unwrap(),
            ..self
        }
    }

    /// The gear as drawn.
    pub(crate) fn gear(self) -> Gear {
        Gear::nominal(self).unwrap()
    }

    /// A gear with these deviations.
    pub(crate) fn built(self, face: Face, deviations: &Deviations) -> AsBuilt {
        AsBuilt::new(self.gear(), face, deviations).unwrap()
    }
}

impl Deviations {
    /// An eccentricity alone.
    pub(crate) fn off_axis(eccentricity: f64, high_tooth: f64) -> Deviations {
        Deviations {
            eccentricity,
            high_tooth,
            ..Deviations::default()
        }
    }

    /// These deviations with cumulative pitch deviations.
    pub(crate) fn with_pitch(self, right: &[f64], left: &[f64]) -> Deviations {
        Deviations {
            pitch: Some(Pitch::from_cumulative(right, left)),
            ..self
        }
    }
}
