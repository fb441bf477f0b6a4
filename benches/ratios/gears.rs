//! The gears and pairs that are timed.

use gearlash::contact::CutPair;
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Hand, Lead,
    Modification, Pitch, Relief, Side, Trace, thickness,
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
    let further = Deviations {
        profiles,
        ..Deviations::default()
    };
    deviating_further(gear, face, further)
}

fn deviating_further(gear: Gear, face: Face, further: Deviations) -> AsBuilt {
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
        ..further
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

/// Deviations along the face.
#[derive(Clone, Copy, Default)]
pub(super) struct AlongFace {
    pub helical: bool,
    /// Whether leads have a slope of a few µm and a crown of 5 µm.
    pub leads: bool,
    /// Whether a lead of 33 points is added to these, a wave of 2 µm with noise.
    pub trace: bool,
    /// Lean of the pinion's shaft, mm per mm.
    pub lean: f64,
}

/// The 44/44 pair, spur on a face of 40 mm or helical as [`helical`], with deviations along the face.
pub(super) fn along_face(kind: AlongFace) -> GearPair {
    let angle = 15f64.to_radians();
    let (width, cos) = if kind.helical {
        (1.3 * std::f64::consts::PI * 3.0 / angle.sin(), angle.cos())
    } else {
        (40.0, 1.0)
    };
    let half = 0.5 * width;
    let lead = |slope: f64| {
        if !kind.leads {
            return Lead::default();
        }
        let point = |k: u32| {
            let share = f64::from(k) / 32.0;
            let noise = 0.0003 * (f64::from(k * 7919 % 1000) / 500.0 - 1.0);
            (width * share - half, 0.002 * (6.0 * share).sin() + noise)
        };
        let trace = Trace {
            tooth: None,
            points: (0..33).map(point).collect(),
        };
        Lead {
            face: [-half, half],
            range: [-0.9 * half, 0.9 * half],
            slope,
            crowning: 0.005,
            traces: kind.trace.then_some(trace).into_iter().collect(),
            ..Lead::default()
        }
    };
    let build = |hand, face, slopes: [f64; 2]| {
        let data = BasicGearData::new(44, 3.0, 20f64.to_radians()).unwrap();
        let data = if kind.helical {
            data.with_helix(angle, hand).unwrap()
        } else {
            data
        };
        let further = Deviations {
            leads: slopes.map(lead),
            ..Deviations::default()
        };
        let gear = Gear::nominal(GearDesign::standard(data)).unwrap();
        deviating_further(gear, face, further)
    };
    let wheel = build(Hand::Right, Face::Front, [0.006, -0.004]);
    let pinion = build(Hand::Left, Face::Back, [0.002, -0.001]);
    let distance = 132.0 / cos + 0.1;
    let pair = GearPair::with_locked(wheel, pinion, distance, Member::Wheel).unwrap();
    let pair = pair.with_face([-half, half]).unwrap();
    pair.with_lean([kind.lean, -0.7 * kind.lean]).unwrap()
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
