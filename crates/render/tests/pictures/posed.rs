//! Poses with what the exact method finds there.

use super::design::design;
use gearlash::analysis::study::Material;
use gearlash::contact::{ExactKernel, LostMotion, Scene};
use gearlash::gear::{AsBuilt, Deviations, Face, Gear, GearDesign, Pitch, Side, involute};
use gearlash::outline::AssembledPair;
use gearlash::pair::{GearPair, Mating, Member, Pose};
use gearlash_render::{Snapshot, snapshot};
use std::f64::consts::TAU;

/// A pair of full-depth gears of 20°, wheel front, pinion back.
pub fn pair(teeth: [u32; 2], module: f64, center_distance: f64, locked: Member) -> GearPair {
    let [wheel, pinion] = teeth.map(|teeth| Gear::nominal(design(teeth, module)).unwrap());
    GearPair::with_locked(
        AsBuilt::perfect(wheel, Face::Front),
        AsBuilt::perfect(pinion, Face::Back),
        center_distance,
        locked,
    )
    .unwrap()
}

/// A pose of a pair.
pub struct Posed {
    pub title: &'static str,
    pub material: Material,
    pub pair: GearPair,
    /// The pair as pictures take it.
    pub assembled: AssembledPair,
    pub pose: Pose,
    pub found: LostMotion,
}

impl Posed {
    pub fn new(
        pair: GearPair,
        [wheel_tooth, pinion_tooth]: [u32; 2],
        flank: Side,
        fraction: f64,
    ) -> Posed {
        let mating = Mating {
            wheel_tooth,
            pinion_tooth,
            flank,
            fraction,
        };
        let pose = Pose::new(&pair, mating);
        Posed {
            title: "Untitled",
            material: Material::AsMeasured,
            assembled: pair.clone().into(),
            found: ExactKernel::new(&pair).lost_motion(&pose).unwrap(),
            pair,
            pose,
        }
    }

    pub fn titled(self, title: &'static str) -> Posed {
        Posed { title, ..self }
    }

    pub fn view(&self) -> Snapshot<'_> {
        Snapshot {
            title: self.title,
            assembly: &self.assembled,
            pose: &self.pose,
            material: self.material,
            found: Ok(&self.found),
            section: None,
        }
    }

    pub fn draw(&self) -> String {
        snapshot(&self.view())
    }

    pub fn scene(&self) -> Scene<'_> {
        Scene::new(&self.assembled, &self.pose, &self.found)
    }
}

/// A small perfect pair with play.
pub fn nominal() -> Posed {
    let pair = pair([17, 12], 2.0, 29.1, Member::Wheel);
    Posed::new(pair, [3, 5], Side::Right, 0.0).titled("perfect")
}

/// 12/60 with 200 µm of runout and 40 µm of pitch deviation, in right-hand turn `fraction`.
pub fn deviated(title: &'static str, distance: f64, fraction: f64) -> Posed {
    let wave = |teeth: u32, size: f64, shift: f64| -> Vec<f64> {
        let angle = |i| f64::from(i) / f64::from(teeth) * TAU + shift;
        (0..teeth).map(|i| size * (2.0 * angle(i)).sin()).collect()
    };
    let gear = |teeth: u32, face, eccentricity, high_tooth| {
        let gear = Gear::nominal(GearDesign {
            profile_shift: if teeth < 17 { 0.3 } else { 0.0 },
            ..design(teeth, 2.0)
        });
        let pitch = Pitch::from_cumulative(&wave(teeth, 0.04, 0.3), &wave(teeth, 0.03, 1.1));
        let deviations = Deviations {
            per_tooth: wave(teeth, 0.02, 2.0),
            pitch: Some(pitch),
            eccentricity,
            high_tooth,
            ..Deviations::default()
        };
        AsBuilt::new(gear.unwrap(), face, &deviations).unwrap()
    };
    let wheel = gear(12, Face::Front, 0.06, 3.5);
    let pinion = gear(60, Face::Back, 0.1, 17.0);
    let pair = GearPair::with_locked(wheel, pinion, distance, Member::Wheel).unwrap();
    Posed::new(pair, [3, 15], Side::Right, fraction).titled(title)
}

/// The kinds of picture that only a solver's result shows: interference, a jam, a tip on a fillet, strong deviations.
pub fn all() -> Vec<Posed> {
    const R: Side = Side::Right;
    const L: Side = Side::Left;
    let perfect = [
        ("12/60", [12, 60], 2.0, 72.05, [3, 15], R, 0.25),
        ("12/60 tight", [12, 60], 2.0, 71.9, [3, 15], L, 0.5),
        ("44/44 tight", [44, 44], 3.0, 131.9, [11, 11], R, 0.0),
        ("86/21 tight", [86, 21], 3.0, 160.44, [1, 1], R, 0.3),
        ("tip on fillet", [86, 21], 3.0, 160.2, [1, 1], L, 0.75),
        ("jammed 86/21", [86, 21], 3.0, 158.0, [1, 1], R, 0.0),
    ];
    let perfect = perfect.map(|(title, z, module, a, teeth, flank, fraction)| {
        let pair = pair(z, module, a, Member::Wheel);
        Posed::new(pair, teeth, flank, fraction).titled(title)
    });
    let deviated = [
        ("deviated clear", 73.0, 0.25),
        ("deviated tight", 72.5, 0.25),
        ("deviated tighter", 72.3, -0.4),
    ]
    .map(|(title, a, fraction)| deviated(title, a, fraction));
    perfect.into_iter().chain(deviated).collect()
}

pub fn find(title: &str) -> Posed {
    let mut all = all().into_iter();
    all.find(|posed| posed.title == title).unwrap()
}

/// `j_bn = p_b − s_b1 − s_b2 + 2 (r_b1 + r_b2) inv α_wt`, mm.
pub fn j_bn(assembly: &GearPair) -> f64 {
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| assembly.gear(m).gear());
    wheel.basic_data().base_pitch() - wheel.base_thickness() - pinion.base_thickness()
        + 2.0
            * (wheel.base_radius() + pinion.base_radius())
            * involute::inv(assembly.operating_pressure_angle())
}
