//! Gears in a few words, and comparisons that name their case: shared by the tests of checks, models and gauges.

#![allow(dead_code)] // each test binary uses its part

use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Hand, Pitch, thickness,
};
use gearlash::pair::GearPair;
use std::fmt::Debug;
use std::ops::ControlFlow;

/// Never stops.
pub fn on() -> ControlFlow<()> {
    ControlFlow::Continue(())
}

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

/// The least and the greatest of `values`.
pub fn ends(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    let wider = |[low, high]: [f64; 2], value: f64| [value.min(low), value.max(high)];
    values.into_iter().fold(start, wider)
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
    Make::of(GearDesign {
        basic_data: BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap(),
        profile_shift: 0.0,
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    })
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

    pub fn pitch(mut self, right: &[f64], left: &[f64]) -> Make {
        self.deviations.pitch = Some(Pitch::from_cumulative(right, left));
        self
    }

    pub fn gear(&self) -> Gear {
        let (data, nominal) = (
            &self.design.basic_data,
            self.design.nominal_base_thickness(),
        );
        let base = thickness::base_from_allowance(data, nominal, self.allowance) - self.thinner;
        Gear::new(self.design, base).unwrap()
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
    GearPair::new(wheel.front(), pinion.back(), center_distance).unwrap()
}
