//! The gears and pairs that are timed.

use gearlash::contact::CutPair;
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Hand, Modification,
    Pitch, Relief, Side, Trace, thickness,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use gearlash::population::{GearScatter, Population, Scatter, Scatters};

fn gear(teeth: u32) -> Gear {
    Gear::nominal(GearDesign {
        basic_data: BasicGearData::new(teeth, 3.0, 20f64.to_radians()).unwrap(),
        profile_shift: 0.0,
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    })
    .unwrap()
}

/// Pitch deviation of ±8 µm without pattern and a runout of 20 µm: ordinary at module 3.
fn deviated(teeth: u32, face: Face) -> AsBuilt {
    deviating(gear(teeth), face, Default::default())
}

fn deviating(gear: Gear, face: Face, profiles: [Modification; 2]) -> AsBuilt {
    let teeth = gear.basic_data().teeth();
    let list = |start: u32| -> Vec<f64> {
        (0..teeth)
            .map(|k| 0.008 * (f64::from((k * 7919 + start) % 1000) / 500.0 - 1.0))
            .collect()
    };
    let deviations = Deviations {
        pitch: Some(Pitch::from_cumulative(&list(17), &list(443))),
        eccentricity: 0.010,
        high_tooth: 5.5,
        profiles,
        ..Deviations::default()
    };
    AsBuilt::new(gear, face, &deviations).unwrap()
}

/// A deviating gear with a profile slope of 4 µm, crowning of 3 µm, parabolic relief of tip (12 µm) and root (10 µm).
pub(super) fn modified(teeth: u32, face: Face) -> AsBuilt {
    let gear = gear(teeth);
    let share = |share: f64| gear.form_radius() + share * (gear.tip_radius() - gear.form_radius());
    let relief = |amount, from| {
        Some(Relief {
            amount,
            from: share(from),
            parabolic: true,
        })
    };
    let profile = Modification {
        slope: 0.004,
        crowning: 0.003,
        tip_relief: relief(0.012, 0.75),
        root_relief: relief(0.010, 0.2),
        ..Modification::default()
    };
    deviating(gear.clone(), face, [profile.clone(), profile])
}

/// A deviating gear with a measured trace of `points` points: a wave of 3 µm with noise of ±1 µm.
pub(super) fn traced(teeth: u32, face: Face, points: u32) -> AsBuilt {
    let gear = gear(teeth);
    let (from, to) = (gear.form_roll(), gear.tip_roll());
    let point = |k: u32| {
        let share = f64::from(k) / f64::from(points - 1);
        let noise = 0.001 * (f64::from(k * 7919 % 1000) / 500.0 - 1.0);
        (
            from + (to - from) * share,
            0.003 * (7.0 * share).sin() + noise,
        )
    };
    let profile = Modification {
        traces: vec![Trace {
            tooth: None,
            points: (0..points).map(point).collect(),
        }],
        ..Modification::default()
    };
    deviating(gear, face, [profile.clone(), profile])
}

/// The 44/44 pair with a helix angle of 15° and a face of overlap ratio 1.3, as deviated and eccentric as the spur one.
pub(super) fn helical() -> GearPair {
    // ε_β = b sin β/(π m_n), ISO 21771.
    let width = 1.3 * std::f64::consts::PI * 3.0 / 15f64.to_radians().sin();
    helical_of([44, 44], width)
}

/// A helical 27/51 pair, 15°, on a face of 50 mm.
pub(super) fn wide_face() -> GearPair {
    helical_of([27, 51], 50.0)
}

fn helical_of([wheel, pinion]: [u32; 2], width: f64) -> GearPair {
    let build = |teeth, hand, face| {
        let data = BasicGearData::new(teeth, 3.0, 20f64.to_radians()).unwrap();
        let design = GearDesign::standard(data.with_helix(15f64.to_radians(), hand).unwrap());
        deviating(Gear::nominal(design).unwrap(), face, Default::default())
    };
    let distance = 1.5 * f64::from(wheel + pinion) / 15f64.to_radians().cos() + 0.1;
    let (wheel, pinion) = (
        build(wheel, Hand::Right, Face::Front),
        build(pinion, Hand::Left, Face::Back),
    );
    let pair = GearPair::with_locked(wheel, pinion, distance, Member::Wheel).unwrap();
    pair.with_face([-0.5 * width, 0.5 * width]).unwrap()
}

/// A pair whose only deviations are runouts, mm.
pub(super) fn with_runouts(teeth: [u32; 2], runout: f64) -> GearPair {
    let build = |teeth, face| {
        let deviations = Deviations {
            eccentricity: 0.5 * runout,
            high_tooth: 3.3,
            ..Deviations::default()
        };
        AsBuilt::new(gear(teeth), face, &deviations).unwrap()
    };
    at_play(teeth, build)
}

/// A pair 0.1 mm beyond the play-free distance.
pub(super) fn pair(teeth: [u32; 2], perfect: bool) -> GearPair {
    let build = |teeth, face| {
        if perfect {
            AsBuilt::perfect(gear(teeth), face)
        } else {
            deviated(teeth, face)
        }
    };
    at_play(teeth, build)
}

fn at_play(teeth: [u32; 2], build: impl Fn(u32, Face) -> AsBuilt) -> GearPair {
    let distance = 1.5 * f64::from(teeth[0] + teeth[1]) + 0.1;
    let (wheel, pinion) = (build(teeth[0], Face::Front), build(teeth[1], Face::Back));
    GearPair::with_locked(wheel, pinion, distance, Member::Wheel).unwrap()
}

/// The drawing pair 20/40 of module 1: runouts of 18 and 22 µm in any direction, thickness 25cd, 30 js7. Thickness and distance scatter.
pub(super) fn drawing() -> Population {
    let gear = |teeth, runout: f64, face| {
        let data = BasicGearData::new(teeth, 1.0, 20f64.to_radians()).unwrap();
        let design = GearDesign::standard(data);
        let nominal = design.nominal_base_thickness();
        let base = thickness::base_from_allowance(&data, nominal, -0.057);
        let deviations = Deviations {
            eccentricity: 0.5 * runout,
            any_direction: true,
            high_tooth: 1.0,
            ..Deviations::default()
        };
        AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap()
    };
    let (wheel, pinion) = (gear(20, 0.018, Face::Front), gear(40, 0.022, Face::Back));
    let scatter = |cpk| GearScatter {
        thickness: Some(Scatter::normal_within(-0.015, 0.015, 0.0, cpk).unwrap()),
        ..GearScatter::default()
    };
    let scatters = Scatters {
        wheel: scatter(1.0),
        pinion: scatter(1.33),
        center_distance: Some(Scatter::uniform(-0.0105, 0.0105).unwrap()),
        ..Scatters::default()
    };
    Population::new(GearPair::new(wheel, pinion, 30.0).unwrap(), scatters).unwrap()
}

pub(super) fn cut(assembly: &GearPair) -> CutPair {
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|m| assembly.gear(m));
    CutPair::new(wheel, pinion, 1e-3)
}

/// Some 300 different poses of a revolution: none is warm.
pub(super) fn poses(assembly: &GearPair) -> Vec<Pose> {
    let teeth = assembly.gear(Member::Wheel).gear().basic_data().teeth();
    (0..308)
        .map(|k| {
            let mating = Mating {
                wheel_tooth: 1,
                pinion_tooth: 1,
                flank: Side::Right,
                fraction: f64::from(k * teeth) / 308.0,
            };
            Pose::new(assembly, mating)
        })
        .collect()
}
