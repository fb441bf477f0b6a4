//! Helical gears whose profiles deviate, against dense sections and closed forms.

use crate::along_face::{against_sections, profile};
use crate::random::{self, Random, WILD};
use gearlash::analytic::LineOfAction;
use gearlash::contact::ExactKernel;
use gearlash::gear::{
    AsBuilt, BasicGearData, Deviations, Face, Flank, Gear, GearDesign, Hand, Modification, Pitch,
    Relief, Trace, thickness,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};

/// 27/51, m_n 4.5, β 21° over a face of 50 mm at 190 mm, with profiles of the wheel and of the pinion, the same on both flanks.
fn pair(helix: f64, profiles: [&Modification; 2], thicker: f64) -> GearPair {
    let gear = |teeth, hand, profile: &Modification, face, thicker: f64| {
        let data = BasicGearData::new(teeth, 4.5, 20f64.to_radians()).unwrap();
        // Without an angle a spur gear.
        let data = data.with_helix(helix.to_radians(), hand).unwrap();
        let design = GearDesign::standard(data);
        let base = thickness::base_from_allowance(&data, design.nominal_base_thickness(), -0.1);
        // Both flanks by this along the transverse base tangent; a thickness is an arc of the reference circle in the normal section.
        let arc = 2.0 * thicker * data.reference_radius() / data.base_radius() * data.helix_cos();
        let deviations = Deviations {
            per_tooth: vec![arc; teeth as usize],
            profiles: [profile.clone(), profile.clone()],
            ..Deviations::default()
        };
        AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap()
    };
    let wheel = gear(51, Hand::Right, profiles[0], Face::Front, thicker);
    let pinion = gear(27, Hand::Left, profiles[1], Face::Back, 0.0);
    let distance = 0.5 * 78.0 * 4.5 / helix.to_radians().cos() + 0.1;
    let pair = GearPair::new(wheel, pinion, distance).unwrap();
    pair.with_face([-20.0, 30.0]).unwrap()
}

fn angles(pair: &GearPair) -> Vec<f64> {
    let kernel = ExactKernel::new(pair);
    let matings = (0..8).map(|k| Mating {
        fraction: f64::from(k) / 8.0,
        ..Mating::FIRST
    });
    let found = matings.map(|mating| kernel.lost_motion(&Pose::new(pair, mating)));
    found.map(|found| found.unwrap().angle().unwrap()).collect()
}

/// Greatest difference of two pairs at eight phases, µm; the first is expected to have `more` lost motion, rad.
fn most_off(one: &GearPair, other: &GearPair, more: f64) -> f64 {
    let um = 1e3 * one.operating_pitch_radius(one.free());
    let pairs = angles(one).into_iter().zip(angles(other));
    pairs.fold(0.0, |most, (one, other)| {
        f64::max(most, (one - other - more).abs() * um)
    })
}

/// A constant deviation is a thicker tooth: by δ along the base tangent on each flank.
#[test]
fn a_constant_profile_is_a_thicker_tooth() {
    let constant = Modification {
        traces: vec![Trace {
            tooth: None,
            points: vec![(0.1, 8e-3), (0.9, 8e-3)],
        }],
        ..Modification::default()
    };
    let none = Modification::default();
    let one = pair(21.0, [&constant, &none], 0.0);
    let other = pair(21.0, [&none, &none], 8e-3);
    assert!(most_off(&one, &other, 0.0) < 1e-4);
}

/// A pair with next to no helix angle is the spur pair with the same profiles.
#[test]
fn a_pair_with_hardly_a_helix_is_a_spur_pair() {
    let profile = Modification {
        slope: -4e-3,
        crowning: 6e-3,
        ..Modification::default()
    };
    let none = Modification::default();
    let pairs = [1e-4, 0.0].map(|helix| pair(helix, [&profile, &none], 0.0));
    let off = most_off(&pairs[0], &pairs[1], 0.0);
    assert!(off < 1e-3, "{off}");
}

/// A straight slope touches at an end of its evaluation range that is on the line of contact, which this face always has: the tooth is thicker
/// by all of the slope. Relief beyond the path of contact changes nothing.
#[test]
fn a_slope_binds_at_the_end_of_the_line() {
    let none = Modification::default();
    let slope = Modification {
        slope: 10e-3,
        ..Modification::default()
    };
    let perfect = pair(21.0, [&none, &none], 0.0);
    let sloped = pair(21.0, [&slope, &none], 0.0);
    let base = sloped.gear(sloped.free()).gear().base_radius();
    let off = most_off(&perfect, &sloped, 2.0 * 10e-3 / base);
    // The tilted normal moves the contact: ½ ρ (δ'/s)² a side.
    assert!(off < 0.1, "{off}");
}

/// Crowns of both gears touch where their sum is greatest; the quantity of model 3, which knows no sections but closed forms.
#[test]
fn model_3_agrees_over_the_face() {
    let profile = Modification {
        slope: -4e-3,
        crowning: 6e-3,
        tip_relief: Some(Relief {
            amount: 10e-3,
            from: 125.0,
            parabolic: true,
        }),
        ..Modification::default()
    };
    let other = Modification {
        crowning: 5e-3,
        ..Modification::default()
    };
    let pair = pair(21.0, [&profile, &other], 0.0);
    let kernel = ExactKernel::new(&pair);
    let um = 1e3 * pair.operating_pitch_radius(pair.free());
    for k in 0..8 {
        let mating = Mating {
            fraction: f64::from(k) / 8.0,
            ..Mating::FIRST
        };
        let pose = Pose::new(&pair, mating);
        let found = kernel.lost_motion(&pose).unwrap();
        let formula = LineOfAction::new(&pair, &pose).angle().unwrap();
        let off = (formula - found.angle().unwrap()) * um;
        assert!((-1e-6..0.05).contains(&off), "{k}: {off}");
        let against = against_sections(&pair, &pose, &found, 200, [1e-12, 0.5e-2 / um]);
        assert!(against.is_empty(), "{k}: {against:#?}");
    }
}

/// A random pair with random profiles; `None` where one cannot exist.
pub fn deviating_pair(numbers: &mut Random, traces: bool) -> Option<GearPair> {
    let plain = random::pair(numbers, WILD);
    let [wheel, pinion] = Member::BOTH.map(|member| {
        let built = plain.gear(member);
        let gear = built.gear().clone();
        let deviations = Deviations {
            eccentricity: built.eccentricity(),
            high_tooth: built.high_tooth(),
            pitch: Some(pitch(built)),
            profiles: [0; 2].map(|_| profile(numbers, &gear, traces)),
            ..Deviations::default()
        };
        AsBuilt::new(gear, built.face(), &deviations).ok()
    });
    GearPair::with_locked(wheel?, pinion?, plain.center_distance(), plain.locked()).ok()
}

/// The places of a gear's flanks as a pitch deviation.
fn pitch(built: &AsBuilt) -> Pitch {
    let r = built.gear().basic_data().reference_radius();
    let curve = |own: Flank| -> Vec<f64> {
        let side = built.face().seen_from_front(own);
        let teeth = 1..=built.gear().basic_data().teeth();
        let along = built.face().ascending() * r;
        teeth
            .map(|tooth| along * built.flank_offset(side, tooth))
            .collect()
    };
    Pitch::from_cumulative(&curve(Flank::Right), &curve(Flank::Left))
}
