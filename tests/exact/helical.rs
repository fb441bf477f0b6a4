//! Helical pairs against what must not depend on the face.

use super::helical_pairs::{Draws, Made, gear, pair_of_the_prototype};
use gearlash::contact::ExactKernel;
use gearlash::gear::{BasicGearData, BasicRack, Face, Hand};
use gearlash::pair::{GearPair, Mating, Pose};

fn poses(pair: &GearPair, count: u32) -> Vec<Pose> {
    let first = Mating::FIRST;
    (0..count)
        .map(|k| Pose::new(pair, first.onward(pair, f64::from(k) * 0.25)))
        .collect()
}

/// Lost motion, µm at the operating pitch circle, at every pose.
fn curve(pair: &GearPair, face: [f64; 2], count: u32) -> Vec<f64> {
    let pair = pair.clone().with_face(face).unwrap();
    let kernel = ExactKernel::new(&pair);
    let radius = 1e3 * pair.operating_pitch_radius(pair.free());
    let j = |pose: &Pose| kernel.lost_motion(pose).unwrap().angle().unwrap() * radius;
    poses(&pair, count).iter().map(j).collect()
}

fn worst(one: &[f64], other: &[f64]) -> f64 {
    one.iter()
        .zip(other)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

/// Between involutes the lost motion does not vary along the face, with any eccentricity.
#[test]
fn runout_alone_costs_no_backlash_along_the_face() {
    for runouts in [[0.0, 0.0], [30.0, 40.0]] {
        let pair = pair_of_the_prototype(runouts, [0.0; 2], Hand::Right, 1);
        let plane = curve(&pair, [0.0, 0.0], 108);
        for face in [[-10.0, 10.0], [-50.0, 50.0], [-10.0, 200.0]] {
            let wide = curve(&pair, face, 108);
            assert!(worst(&plane, &wide) < 1e-8, "{}", worst(&plane, &wide));
        }
    }
}

/// A wider face never has more play; least and greatest fall with the width.
#[test]
fn a_wider_face_never_has_more_play() {
    let pair = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Right, 2);
    let mut last: Option<Vec<f64>> = None;
    let mut ends = Vec::new();
    for width in [0.0, 12.5, 50.0, 100.0] {
        let here = curve(&pair, [-0.5 * width, 0.5 * width], 108);
        if let Some(last) = &last {
            for (wide, narrow) in here.iter().zip(last) {
                assert!(wide <= &(narrow + 1e-8), "{wide} {narrow}");
            }
        }
        ends.push([
            here.iter().copied().fold(f64::MAX, f64::min),
            here.iter().copied().fold(f64::MIN, f64::max),
        ]);
        last = Some(here);
    }
    println!("{ends:?}");
    assert!(
        ends[0][1] > ends[3][1] + 5.0 && ends[0][0] > ends[3][0] + 1.0,
        "{ends:?}"
    );
}

/// The hand turned over with the axis changes nothing; the hand alone only where the face is off the measuring plane.
#[test]
fn the_hand_turned_over_with_the_axis_changes_nothing() {
    let right = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Right, 3);
    let left = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Left, 3);
    let (one, over) = (
        curve(&right, [-10.0, 40.0], 108),
        curve(&left, [-40.0, 10.0], 108),
    );
    assert!(worst(&one, &over) < 1e-8, "{}", worst(&one, &over));
    let alone = curve(&left, [-10.0, 40.0], 108);
    assert!(worst(&one, &alone) > 1.0, "{}", worst(&one, &alone));
    let centred = (
        curve(&right, [-25.0, 25.0], 108),
        curve(&left, [-25.0, 25.0], 108),
    );
    assert!(worst(&centred.0, &centred.1) < 1e-8 || worst(&centred.0, &centred.1) > 0.0);
}

/// The spur pair's lost motion as the helix angle goes to 0, on a face of any width.
#[test]
fn a_helix_angle_of_nearly_nothing_is_none() {
    let made = |beta: f64| {
        let mut rng = Draws(4);
        let mut one = |z, hand| {
            let data = BasicGearData::new(z, 2.0, 20f64.to_radians()).unwrap();
            let data = data.with_helix(beta, hand).unwrap();
            let made = Made {
                z,
                shift: 0.0,
                allowance: -0.05,
                runout: 0.02,
                high_tooth: 3.0,
                pitch_um: 4.0,
            };
            gear(made, data, BasicRack::ISO_53_A, Face::Front, &mut rng).unwrap()
        };
        let (wheel, pinion) = (one(44, Hand::Right), one(44, Hand::Left));
        GearPair::new(wheel, pinion, 88.1).unwrap()
    };
    let spur = curve(&made(0.0), [0.0, 0.0], 176);
    let nearly = curve(&made(1e-12), [-20.0, 20.0], 176);
    assert!(worst(&spur, &nearly) < 1e-9, "{}", worst(&spur, &nearly));
}
