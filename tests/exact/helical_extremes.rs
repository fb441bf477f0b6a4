//! Proven extremes of pairs that vary along the face against poses of the exact method over the same face, which know nothing of their bounds.

use super::*;
use crate::along_face;
use crate::extremes::{ROUNDING, WIDTH, held, held_from, proven};
use crate::helical_pairs::{drawn, expanded, pair_of_the_prototype};
use crate::random::Random;
use gearlash::analysis::face_width::{AtWidth, FaceExtreme, over_widths};
use gearlash::error::go_on;

/// The prototype's pair, of six curves of pitch each: proven both ways at any width, and the least no greater of the wider.
#[test]
fn ordinary_helical_pairs_are_proven_and_hold() {
    for seed in 0..6 {
        let mut last = [f64::INFINITY; 2];
        for width in [0.0, 1.0, 12.5, 25.0, 50.0, 100.0] {
            let pair = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Right, seed);
            let pair = pair.with_face([-0.5 * width, 0.5 * width]).unwrap();
            let found = held(&pair, 300).unwrap();
            let ends = [found.least, found.greatest].map(Option::unwrap);
            for (end, last) in ends.iter().zip(&mut last) {
                assert!(end.is_proven());
                assert!(end.low <= *last + WIDTH, "{width} {seed}: {end:?} {last}");
                *last = end.low;
            }
        }
    }
}

/// Pairs from far beyond any shop, tips on fillets among them, and such of unequal base pitch: most are proven, and what is not says so.
#[test]
fn helical_pairs_hold_or_are_doubted() {
    for (warm, count, poses, tenths) in [(false, 28, 100, 9), (true, 20, 70, 8)] {
        let mut rng = Random(9 + u64::from(warm));
        let (mut sure, mut brackets) = (0, 0);
        for _ in 0..count {
            let found = held(&drawn(&mut rng, warm), poses).unwrap();
            sure += proven(&found);
            brackets += [found.least, found.greatest].iter().flatten().count();
        }
        let is_most = sure * 10 > brackets * tenths;
        assert!(is_most, "{warm}: {sure} of {brackets}");
    }
}

/// Helical gears whose profiles deviate, over a part of their cycle: brackets of a hundredth of a micrometre hold.
#[test]
fn extremes_of_helical_profiles_hold() {
    let (pair, _) = along_face::drawn(6, 3, true);
    let pitches = (0..40).map(|k| 0.1 * f64::from(k));
    let poses = pitches.map(|pitches| Pose::new(&pair, Mating::FIRST.onward(&pair, pitches)));
    let found = held_from(&pair, Mating::FIRST, 4, poses).unwrap();
    for end in [found.least, found.greatest].map(Option::unwrap) {
        assert!(end.high - end.low < 1e-5, "{end:?}");
    }
}

/// The lost motion, mm, that perfect gears have on a face of an overlap ratio above 1: both sides touch wherever along the face they do so
/// tightest, each in a phase of its own. The last is what neighbouring phases differ by there, so what sampled phases can miss.
fn tightest_of_all_phases(plane: &GearPair) -> (f64, f64) {
    let kernel = ExactKernel::new(plane);
    let radius = plane.operating_pitch_radius(plane.free());
    let phases = 4000;
    let at = |k: i32| {
        let mating = Mating::FIRST.onward(plane, f64::from(k) / f64::from(phases));
        let pose = Pose::new(plane, mating);
        let lost = kernel.lost_motion(&pose).unwrap();
        let beyond = |contact: Option<Contact>| {
            without_turns(contact.unwrap().rotation - pose.free_rotation()) * radius
        };
        [beyond(lost.left), -beyond(lost.right)]
    };
    let found: Vec<[f64; 2]> = (0..phases).map(at).collect();
    let mut missed = 0.0;
    let sides = [0, 1].map(|side| {
        let room = |k: usize| found[k % found.len()][side];
        let all = 0..found.len();
        let least = all.min_by(|&a, &b| room(a).total_cmp(&room(b))).unwrap();
        let near = [least + 1, least + found.len() - 1].map(|k| room(k) - room(least));
        missed += near[0].max(near[1]);
        room(least)
    });
    (sides[0] + sides[1], missed)
}

/// Perfect gears whose tips touch fillets, on a face of an overlap ratio above 1: at every rotation one backlash, that of the tightest phases of
/// the measuring plane alone, a spur pair. Source: poses of that.
#[test]
fn perfect_gears_whose_tips_touch_fillets_have_one_backlash() {
    let gear = |z, hand| spur(z, 2.0).rack(1.2, 1.35, 0.2).helix(15.0, hand).front();
    let (wheel, pinion) = (gear(70, Hand::Right), gear(25, Hand::Left));
    let distance = 95.0 / 15f64.to_radians().cos();
    let mut touched = 0;
    for closer in [0.15, 0.19, 0.22] {
        let plane = GearPair::new(wheel.clone(), pinion.clone(), distance - closer).unwrap();
        let (one, missed) = tightest_of_all_phases(&plane);
        let wide = plane.with_face([-20.0, 20.0]).unwrap();
        let found = held(&wide, 150).unwrap();
        let [least, greatest] = [found.least.unwrap(), found.greatest.unwrap()];
        touched += u32::from(missed > 1e-9);
        for end in [least, greatest] {
            assert!(end.low <= one + ROUNDING && end.high >= one - missed - ROUNDING);
        }
    }
    assert_eq!(touched, 1);
}

/// Perfect gears of unequal base pitch: a wider face never has more play, as the tightest pair of teeth is the one furthest on, and the extremes hold.
/// In closed form each further pitch takes `κ r_w`, with `κ = (r_b1/r_b2) τ_1 − τ_2`.
#[test]
fn unlike_gears_lose_play_with_the_width() {
    let pair = pair_of_the_prototype([0.0; 2], [0.0; 2], Hand::Right, 1);
    let pair = expanded(&pair, [1.0, 1.0 + 40.0 * 98.5e-6]).unwrap();
    let radius = pair.operating_pitch_radius(pair.free());
    let data = Member::BOTH.map(|member| *pair.gear(member).gear().basic_data());
    let kappa = data[0].base_radius() / data[1].base_radius() * data[0].angular_pitch()
        - data[1].angular_pitch();
    // Distance along the face over which a pair of teeth advances by a pitch.
    let axial = data[0].angular_pitch() / data[0].twist().abs();
    let mut last = f64::INFINITY;
    let mut least = Vec::new();
    for widths in 0..4 {
        let half = f64::from(widths) * axial;
        let wide = pair.clone().with_face([-half, half]).unwrap();
        let found = held(&wide, 60).unwrap();
        let end = found.least.unwrap();
        assert!(end.is_proven(), "{end:?}");
        assert!(end.high <= last + 1e-9, "{widths}: {end:?} {last}");
        last = end.high;
        least.push(0.5 * (end.low + end.high));
    }
    for two in least.windows(2) {
        // One pitch more on each side, where either flank is tightest.
        near(&least, two[0] - two[1], 2.0 * kappa.abs() * radius, 3e-6);
    }
}

/// A face that holds another has no more play, as far as the brackets tell; eccentricities alone cost nothing. A face is cut about its middle. Width 0
/// is one section: a spur pair of its own, whose extremes the search for spur pairs finds.
#[test]
fn a_wider_face_costs() {
    for (pitch, costs) in [([0.0; 2], false), ([4.0, 5.0], true)] {
        let pair = pair_of_the_prototype([30.0, 40.0], pitch, Hand::Right, 7);
        let pair = pair.with_face([-20.0, 40.0]).unwrap();
        let method = Method::Exact { certify: true };
        let study = Study::of_pair("pair", &pair, 4);
        let full = extremes(&study, method, &go_on).unwrap().each;
        let widths = over_widths(&study, &full, method, &go_on).unwrap();
        let faces: Vec<[f64; 2]> = widths.iter().map(|at| at.face).collect();
        let held = [[10.0, 10.0], [2.5, 17.5], [-5.0, 25.0], [-12.5, 32.5]];
        assert_eq!(faces[..4], held);
        assert_eq!(faces[4..], [[-20.0, 40.0]]);
        for pair in widths.windows(2) {
            for [here, before] in both(&pair[1], &pair[0]) {
                assert!(here.low <= before.high, "{here:?} {before:?}");
                assert!(here.against(&before).unwrap()[0] <= 0.0);
            }
        }
        let ends = both(&widths[4], &widths[0]);
        let [least, greatest] = ends.map(|[all, one]| all.against(&one).unwrap());
        let [free, dear] = [least[0].min(greatest[0]) > -3e-6, greatest[1] < -1e-3];
        assert!(if costs { dear } else { free }, "{least:?} {greatest:?}");
        let study = Study::of_pair("section", &pair.section(10.0), 4);
        let alone = &extremes(&study, method, &go_on).unwrap().each[0];
        let sections = [&alone.least, &alone.greatest].map(|end| end.as_ref().unwrap());
        for ([width, _], section) in both(&widths[0], &widths[0]).into_iter().zip(sections) {
            assert!(width.low <= section.high && section.low <= width.high);
            assert!((width.found - section.found()).abs() <= WIDTH);
            assert!(width.doubtful.is_none() && section.is_proven());
        }
    }
}

/// Single sections of gears that lean miss each other: the narrowest face is a quarter of the whole, and costs as other faces do. The bound over open
/// axes follows from one section without wobble. Both differed by a millimetre from what is found while teeth of single sections leaned.
#[test]
fn faces_of_gears_that_lean_cost_micrometres() {
    let pair = pair_of_the_prototype([30.0, 40.0], [0.0; 2], Hand::Right, 7);
    let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member).with_wobble(2e-4, 3.0));
    let pair = GearPair::new(wheel, pinion, pair.center_distance()).unwrap();
    let pair = pair.with_face([-20.0, 40.0]).unwrap();
    let method = Method::Exact { certify: false };
    let study = Study::of_pair("leans", &pair, 4);
    let full = extremes(&study, method, &go_on).unwrap().each;
    let widths = over_widths(&study, &full, method, &go_on).unwrap();
    assert_eq!(widths[0].face, [2.5, 17.5]);
    for [whole, narrow] in both(&widths[3], &widths[0]) {
        near("width", whole.found, narrow.found, 0.03);
    }
    let open = Study {
        open_lean: [1e-4, 1e-4],
        ..study
    };
    let found = extremes(&open, method, &go_on).unwrap().each;
    let greatest = found[0].greatest.as_ref().unwrap();
    assert!(greatest.high - greatest.found() < 0.03, "{greatest:?}");
}

/// Least and greatest of two widths.
fn both<'a>(one: &'a AtWidth, other: &'a AtWidth) -> [[FaceExtreme<'a>; 2]; 2] {
    [
        [one.least().unwrap(), other.least().unwrap()],
        [one.greatest().unwrap(), other.greatest().unwrap()],
    ]
}
