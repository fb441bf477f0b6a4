//! Helical gears whose profiles deviate, against dense sections and closed forms.

use super::*;
use crate::along_face::{against_sections, profile};
use crate::kit;
use crate::random::{self, Random, WILD};
use gearlash::gear::Relief;

/// 27/51, m_n 4.5, β 21° over a face of 50 mm at 190 mm, with profiles of the wheel and of the pinion, the same on both flanks.
fn pair(profiles: [&Modification; 2], thicker: f64) -> GearPair {
    let gear = |teeth, hand, profile: &Modification, thicker: f64| {
        let gear = spur(teeth, 4.5).helix(21.0, hand).allowance(-0.1);
        let data = gear.design.basic_data;
        // Both flanks by this along the transverse base tangent; a thickness is an arc of the reference circle in the normal section.
        let arc = 2.0 * thicker * data.reference_radius() / data.base_radius() * data.helix_cos();
        let gear = gear.profiles([profile.clone(), profile.clone()]);
        gear.per_tooth(vec![arc; teeth as usize])
    };
    let wheel = gear(51, Hand::Right, profiles[0], thicker);
    let pinion = gear(27, Hand::Left, profiles[1], 0.0);
    let distance = 0.5 * 78.0 * 4.5 / 21f64.to_radians().cos() + 0.1;
    let pair = kit::pair(&wheel, &pinion, distance);
    pair.with_face([-20.0, 30.0]).unwrap()
}

/// Eight phases of a pitch.
fn poses(pair: &GearPair) -> impl Iterator<Item = Pose> {
    (0..8).map(|k| Pose::new(pair, at(1, 1, f64::from(k) / 8.0)))
}

/// Greatest difference of two pairs at eight phases, µm; the first is expected to have `more` lost motion, rad.
fn most_off(one: &GearPair, other: &GearPair, more: f64) -> f64 {
    let angle = |pair: &GearPair, pose: &Pose| {
        let found = ExactKernel::new(pair).lost_motion(pose).unwrap();
        found.angle().unwrap()
    };
    let both = poses(one).zip(poses(other));
    let off = both.map(|(here, there)| angle(one, &here) - angle(other, &there) - more);
    off.fold(0.0, |most, off| f64::max(most, off.abs() * um(one)))
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
    let one = pair([&constant, &none], 0.0);
    let other = pair([&none, &none], 8e-3);
    assert!(most_off(&one, &other, 0.0) < 1e-4);
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
    let perfect = pair([&none, &none], 0.0);
    let sloped = pair([&slope, &none], 0.0);
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
    let pair = pair([&profile, &other], 0.0);
    let kernel = ExactKernel::new(&pair);
    let um = um(&pair);
    for (k, pose) in poses(&pair).enumerate() {
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
        let places = teeth.map(|tooth| along * built.flank_offset(side, tooth));
        places.collect()
    };
    Pitch::from_cumulative(&curve(Flank::Right), &curve(Flank::Left))
}
