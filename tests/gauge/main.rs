//! The gauge against formulas, published values and the deviations that were put in. Lengths in mm.

mod as_built;
mod fitted_involute;
mod helical;
#[path = "../common/helical_dimensions.rs"]
mod helical_dimensions;
mod helical_in_space;
mod helical_runout;
mod lead;
mod outline_difference;
mod outlines;
mod perfect;
mod profile;
mod profile_sizes;
mod roll;

#[path = "../common/made_up.rs"]
mod made_up;

use gearlash::gauge::{Gauged, Settings, gauge};
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch,
};
use made_up::{made_up, scaled};
use std::ops::ControlFlow;

/// Issue 5: 1e-6 µm.
const PICOMETRE: f64 = 1e-9;

fn design(teeth: u32, module: f64, alpha_deg: f64, profile_shift: f64) -> GearDesign {
    GearDesign {
        basic_data: BasicGearData::new(teeth, module, alpha_deg.to_radians()).unwrap(),
        profile_shift,
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    }
}

fn measure(gear: &AsBuilt, settings: Settings) -> Gauged {
    gauge(gear, &settings, &|_| (), &|| ControlFlow::Continue(())).unwrap()
}

/// A few poses of the roll test only: for tests of the other gauges.
fn quick() -> Settings {
    Settings {
        steps_per_pitch: 1,
        ..Settings::default()
    }
}

/// A gear with deviations of every kind: per-tooth thickness ±8 µm, pitch ±12 µm.
struct Made {
    gear: AsBuilt,
    per_tooth: Vec<f64>,
    right: Vec<f64>,
    left: Vec<f64>,
}

fn made(teeth: u32, face: Face, eccentricity: f64) -> Made {
    let per_tooth = scaled(&made_up(teeth, 1), 8e-3);
    let (right, left) = (
        scaled(&made_up(teeth, 2), 12e-3),
        scaled(&made_up(teeth, 3), 12e-3),
    );
    let design = design(teeth, 3.0, 20.0, 0.1);
    let gear = Gear::new(design, design.nominal_base_thickness() - 0.04).unwrap();
    let deviations = Deviations {
        per_tooth: per_tooth.clone(),
        pitch: Some(Pitch::from_cumulative(&right, &left)),
        eccentricity,
        high_tooth: 5.25,
        ..Deviations::default()
    };
    Made {
        gear: AsBuilt::new(gear, face, &deviations).unwrap(),
        per_tooth,
        right,
        left,
    }
}
