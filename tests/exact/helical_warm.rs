//! Helical pairs whose gears expand differently: one base helix angle, two base pitches.

use crate::helical_extremes::held;
use crate::helical_pairs::{Draws, drawn, pair_of_the_prototype};
use gearlash::analytic::LineOfAction;
use gearlash::contact::{CutPair, ExactKernel, LostMotion, Status};
use gearlash::gear::{Hand, Side};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use std::f64::consts::TAU;

/// `pair` with the lengths of its gears multiplied by `factors`; centre distance and face stay.
fn warm(pair: &GearPair, factors: [f64; 2]) -> Option<GearPair> {
    let [wheel, pinion] = [(Member::Wheel, factors[0]), (Member::Pinion, factors[1])]
        .map(|(member, factor)| pair.gear(member).expanded(factor));
    let warm = GearPair::with_locked(
        wheel.ok()?,
        pinion.ok()?,
        pair.center_distance(),
        pair.locked(),
    );
    warm.ok()?.with_face(pair.face()).ok()
}

/// A drawn pair whose base pitches differ by up to 1 %.
fn drawn_warm(rng: &mut Draws) -> Option<GearPair> {
    let pair = drawn(rng)?;
    let factors = [0, 1].map(|_| 1.0 + rng.within(-5e-3..5e-3));
    let warm = warm(&pair, factors)?;
    assert!(warm.base_pitches_differ());
    Some(warm)
}

fn posed(pair: &GearPair, rng: &mut Draws) -> Pose {
    let mating = Mating {
        wheel_tooth: rng.whole(1..7),
        pinion_tooth: rng.whole(1..7),
        flank: Side::Left,
        fraction: rng.within(0.0..1.0),
    };
    Pose::new(pair, mating)
}

fn turns(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// Twist of the free gear's teeth at `b`: `−η b tan β/r`, of the warm radius.
fn free_twist(pair: &GearPair, b: f64) -> f64 {
    let data = pair.gear(pair.free()).gear().basic_data();
    let eta = match data.hand() {
        Some(Hand::Right) => 1.0,
        _ => -1.0,
    };
    -eta * b * data.helix_angle().tan() / data.reference_radius()
}

/// Right and left contact from single sections at `places`, rad beyond the nominal rotation of the measuring plane, each with its error.
/// The teeth of a section are turned by the free gear's own twist from those of the measuring plane.
fn by_sections(
    pair: &GearPair,
    pose: &Pose,
    places: impl Iterator<Item = f64>,
    method: impl Fn(&GearPair, &Pose) -> LostMotion,
) -> [(f64, f64); 2] {
    let mut found = [(f64::NEG_INFINITY, 0.0), (f64::INFINITY, 0.0)];
    for b in places {
        let section = pair.section(b);
        let here = pose.in_section(pair, b);
        let lost = method(&section, &here);
        let beyond = |rotation: f64| turns(rotation - free_twist(pair, b) - pose.free_rotation());
        if let Some(right) = lost.right {
            let right = (beyond(right.rotation), right.error);
            found[0] = if right.0 > found[0].0 {
                right
            } else {
                found[0]
            };
        }
        if let Some(left) = lost.left {
            let left = (beyond(left.rotation), left.error);
            found[1] = if left.0 < found[1].0 { left } else { found[1] };
        }
    }
    found
}

/// 161 single sections, which are spur pairs of unequal base pitch, are nowhere tighter than the face, and equally
/// tight at its contact. 33 sections by polygons agree.
#[test]
fn sections_and_polygons_confirm_unlike_gears() {
    let mut rng = Draws(21);
    let (mut compared, mut within) = (0, 0);
    while compared < 150 {
        let Some(pair) = drawn_warm(&mut rng) else {
            continue;
        };
        let pose = posed(&pair, &mut rng);
        let Ok(lost) = ExactKernel::new(&pair).lost_motion(&pose) else {
            continue;
        };
        let (Some(right), Some(left)) = (lost.right, lost.left) else {
            continue;
        };
        if lost.status() == Status::Jammed {
            continue;
        }
        compared += 1;
        within += u32::from(right.section != left.section);
        let [from, to] = pair.face();
        let per_um = 1e3 * pair.operating_pitch_radius(pair.free());
        let own = [right, left].map(|contact| turns(contact.rotation - pose.free_rotation()));
        let exact =
            |section: &GearPair, here: &Pose| ExactKernel::new(section).lost_motion(here).unwrap();
        let places = (0..=160).map(|k| from + (to - from) * f64::from(k) / 160.0);
        let [most, least] = by_sections(&pair, &pose, places, exact);
        assert!((most.0 - own[0]) * per_um < 1e-8 && (own[1] - least.0) * per_um < 1e-8);
        let touching = [right.section, left.section];
        let [most, least] = by_sections(&pair, &pose, touching.into_iter(), exact);
        assert!((most.0 - own[0]).abs() * per_um < 1e-8);
        assert!((least.0 - own[1]).abs() * per_um < 1e-8);

        let certified = pair.lost_motion(*pose.mating()).unwrap();
        assert_eq!(certified.found, Ok(lost), "{:?}", pair.face());
        let cut = CutPair::new(pair.gear(Member::Wheel), pair.gear(Member::Pinion), 2e-4);
        let places = (0..33).map(|k| from + (to - from) * f64::from(k) / 32.0);
        let polygons = by_sections(&pair, &pose, places.chain(touching), |section, here| {
            cut.refined_kernel(section).lost_motion(here).unwrap()
        });
        for ((own, contact), (polygons, error)) in own.iter().zip([right, left]).zip(polygons) {
            let off = (own - polygons).abs();
            assert!(
                off <= error + contact.error,
                "{off} of {error}: {contact:?}"
            );
        }
    }
    assert!(within > 20, "{within}");
}

/// Another way: model 3, which tests for each pair of involutes whether its stretch of line contact meets the face.
#[test]
fn pairs_of_involutes_of_unlike_gears_have_the_same_contact() {
    let mut rng = Draws(22);
    let mut compared = 0;
    while compared < 200 {
        let Some(pair) = drawn_warm(&mut rng) else {
            continue;
        };
        let radius = 1e3 * pair.operating_pitch_radius(pair.free());
        let pose = posed(&pair, &mut rng);
        let lost = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        let model = LineOfAction::new(&pair, &pose);
        for (found, model) in [(lost.right, model.right), (lost.left, model.left)] {
            let (Some(found), Some(model)) = (found, model) else {
                continue;
            };
            let touched = [found.wheel, found.pinion].into_iter();
            let smooth = touched
                .zip([Member::Wheel, Member::Pinion])
                .all(|(touch, member)| {
                    let gear = pair.gear(member).gear();
                    touch.radius > gear.form_radius() + 1e-6
                        && touch.radius < gear.tip_radius() - 1e-6
                });
            if smooth {
                compared += 1;
                let off = turns(found.rotation - model.rotation).abs() * radius;
                assert!(off < 1e-8, "{off} µm: {found:?}, {model:?}");
            }
        }
    }
}

/// A wider face never has more play, a face without width equals the spur pair of the transverse section, and the
/// extremes hold. Perfect gears of unequal base pitch: the tightest pair of teeth is the one furthest on, and a wider
/// face has more of them. In closed form each further pitch takes `κ r_w`, with `κ = (r_b1/r_b2) τ_1 − τ_2`.
#[test]
fn unlike_gears_lose_play_with_the_width() {
    let pair = pair_of_the_prototype([0.0; 2], [0.0; 2], Hand::Right, 1);
    let pair = warm(&pair, [1.0, 1.0 + 40.0 * 98.5e-6]).unwrap();
    let radius = pair.operating_pitch_radius(pair.free());
    let data = [Member::Wheel, Member::Pinion].map(|member| *pair.gear(member).gear().basic_data());
    let kappa = data[0].base_radius() / data[1].base_radius() * data[0].angular_pitch()
        - data[1].angular_pitch();
    // Distance along the face over which a pair of teeth advances by a pitch.
    let axial = data[0].angular_pitch() / data[0].twist().abs();
    let mut last = f64::INFINITY;
    let mut least = Vec::new();
    for widths in 0..4 {
        let half = f64::from(widths) * axial;
        let wide = pair.clone().with_face([-half, half]).unwrap();
        let found = held(&wide, 60);
        let end = found.least.unwrap();
        assert!(end.is_proven(), "{end:?}");
        assert!(end.high <= last + 1e-9, "{widths}: {end:?} {last}");
        last = end.high;
        least.push(0.5 * (end.low + end.high));
    }
    for two in least.windows(2) {
        // One pitch more on each side, where either flank is tightest.
        let expected = 2.0 * kappa.abs() * radius;
        assert!(
            (two[0] - two[1] - expected).abs() < 3e-6,
            "{least:?} {expected}"
        );
    }
}

/// Drawn pairs: no pose of the cycle is outside the bracket, and most brackets are proven.
#[test]
fn extremes_of_unlike_gears_hold() {
    let mut rng = Draws(23);
    let (mut proven, mut brackets) = (0, 0);
    for _ in 0..40 {
        let Some(pair) = drawn_warm(&mut rng) else {
            continue;
        };
        let found = held(&pair, 100);
        for end in [found.least, found.greatest].into_iter().flatten() {
            proven += u32::from(end.is_proven());
            brackets += 1;
        }
    }
    println!("{proven} of {brackets} proven");
    assert!(proven * 10 > brackets * 8, "{proven} of {brackets}");
}
