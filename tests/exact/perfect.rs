//! Perfect gears against the closed form, and results that depend on the pose alone.

use crate::design::design;
use crate::random::{self, Kind, Random};
use gearlash::gear::{AsBuilt, Face, Gear, ProfilePart, Side, involute};
use gearlash::mesh::{ExactKernel, LostMotion};
use gearlash::pair::{GearPair, Mating, Member, Pose};

/// `j_bn = p_b − s_b1 − s_b2 + 2 (r_b1 + r_b2) inv α_wt`, mm.
fn normal_backlash(assembly: &GearPair) -> f64 {
    let [wheel, pinion] =
        [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member).gear());
    let sum = wheel.base_radius() + pinion.base_radius();
    let roll = involute::roll_at(assembly.center_distance(), sum);
    wheel.basic_data().base_pitch() - wheel.base_thickness() - pinion.base_thickness()
        + 2.0 * sum * involute::inv_of_roll(roll)
}

/// Whether both tips stay on the mate's involute, below the far base circle's tangency, and one
/// pair at least is always on the path: then the closed form holds at every phase.
fn within_path(assembly: &GearPair) -> bool {
    let [wheel, pinion] =
        [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member).gear());
    let sum = wheel.base_radius() + pinion.base_radius();
    let line = sum * involute::roll_at(assembly.center_distance(), sum);
    let tips = [wheel, pinion].map(|gear| gear.base_radius() * gear.tip_roll());
    let forms = [wheel, pinion].map(|gear| gear.base_radius() * gear.form_roll());
    let clearance = |tip: f64, root: f64| {
        assembly.center_distance() - tip - root > 0.02 * wheel.basic_data().module()
    };
    line - tips[0] >= forms[1]
        && line - tips[1] >= forms[0]
        && tips[0] + tips[1] - line > wheel.basic_data().base_pitch()
        && clearance(wheel.tip_radius(), pinion.root_radius())
        && clearance(pinion.tip_radius(), wheel.root_radius())
}

const PERFECT: Kind = Kind {
    teeth: (12.0, 300.0),
    deviation: 0.0,
    shift: (-0.15, 0.3),
};

/// Source: design section 2, exact for perfect involute gears. `j_wt = j_bn / cos α_wt`.
#[test]
fn perfect_gears_follow_the_closed_form_to_a_tenth_of_a_picometre() {
    let mut random = Random(44);
    let (mut pairs, mut poses, mut on_path, mut negative, mut worst) = (0, 0, 0, 0, 0.0f64);
    while pairs < 1000 {
        let assembly = random::pair(&mut random, PERFECT);
        if !within_path(&assembly) {
            continue;
        }
        pairs += 1;
        let j_wt = normal_backlash(&assembly) / assembly.operating_pressure_angle().cos();
        negative += usize::from(j_wt < 0.0);
        let kernel = ExactKernel::new(&assembly);
        let radius = assembly.operating_pitch_radius(assembly.free());
        for _ in 0..4 {
            let mating = random::mating(&mut random, &assembly);
            let found = kernel.lost_motion(&Pose::new(&assembly, mating)).unwrap();
            let above = 1000.0 * (found.angle().unwrap() * radius - j_wt);
            poses += 1;
            // A tip that reaches past the line of action into the fillet takes backlash away; nothing adds any.
            assert!(
                above <= 1e-7,
                "{above:e} µm: {mating:?} {assembly:?} {found:?}"
            );
            let contacts = [found.right.unwrap(), found.left.unwrap()];
            let mut touches = contacts
                .iter()
                .flat_map(|contact| [contact.wheel, contact.pinion]);
            if touches.all(|touch| touch.curve == ProfilePart::Involute) {
                assert!(
                    above >= -1e-7,
                    "{above:e} µm: {mating:?} {assembly:?} {found:?}"
                );
                worst = worst.max(above.abs());
                on_path += 1;
            }
        }
    }
    println!(
        "worst {worst:e} µm; {on_path} of {poses} poses on the path; {negative} of {pairs} pairs interfere"
    );
    assert!(20 * on_path > 19 * poses);
    assert!(negative > 100);
}

fn bits(found: &LostMotion) -> Vec<u64> {
    [found.right, found.left]
        .iter()
        .flatten()
        .flat_map(|contact| {
            [
                contact.rotation.to_bits(),
                contact.error.to_bits(),
                contact.point.x.to_bits(),
                contact.point.y.to_bits(),
                contact.normal.x.to_bits(),
                contact.wheel.radius.to_bits(),
                contact.pinion.radius.to_bits(),
                u64::from(contact.wheel.tooth),
                u64::from(contact.pinion.tooth),
            ]
        })
        .collect()
}

/// A pose's result is the same to the last bit in order, shuffled, singly on a fresh kernel, and on threads.
#[test]
fn the_bits_depend_on_the_pose_alone() {
    use rayon::prelude::*;
    for seed in 0..12 {
        let mut random = Random(seed);
        let kind = if seed % 2 == 0 { random::WILD } else { PERFECT };
        let assembly = random::pair(&mut random, kind);
        let matings: Vec<Mating> = (0..50)
            .map(|_| random::mating(&mut random, &assembly))
            .collect();
        let kernel = ExactKernel::new(&assembly);
        let solve = |kernel: &ExactKernel, mating: &Mating| {
            bits(&kernel.lost_motion(&Pose::new(&assembly, *mating)).unwrap())
        };
        let in_order: Vec<_> = matings
            .iter()
            .map(|mating| solve(&kernel, mating))
            .collect();
        let mut backwards: Vec<_> = matings
            .iter()
            .rev()
            .map(|mating| solve(&kernel, mating))
            .collect();
        backwards.reverse();
        let singly: Vec<_> = matings
            .iter()
            .map(|mating| solve(&ExactKernel::new(&assembly), mating))
            .collect();
        let threads: Vec<_> = matings
            .par_iter()
            .map(|mating| solve(&kernel, mating))
            .collect();
        assert_eq!(in_order, backwards);
        assert_eq!(in_order, singly);
        assert_eq!(in_order, threads);
    }
}

/// All pairs on the path tie between perfect gears: the one nearest to the pitch point is named.
#[test]
fn of_pairs_that_tie_the_nearest_to_the_pitch_point_is_named() {
    let mut random = Random(7);
    let mut pairs = 0;
    while pairs < 100 {
        let assembly = random::pair(&mut random, PERFECT);
        if !within_path(&assembly) {
            continue;
        }
        pairs += 1;
        let base_pitch = assembly
            .gear(Member::Wheel)
            .gear()
            .basic_data()
            .base_pitch();
        let pitch_point =
            nalgebra::Point2::new(assembly.operating_pitch_radius(Member::Wheel), 0.0);
        let pose = Pose::new(&assembly, random::mating(&mut random, &assembly));
        let found = ExactKernel::new(&assembly).lost_motion(&pose).unwrap();
        // Contacts stand one base pitch apart on the line of action: the nearest is within half of
        // one, unless the path ends before it.
        let [wheel, pinion] =
            [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member).gear());
        let operating = assembly.operating_pressure_angle().tan();
        let beyond =
            |gear: &gearlash::gear::Gear| gear.base_radius() * (gear.tip_roll() - operating);
        if beyond(wheel).min(beyond(pinion)) < base_pitch / 2.0 {
            continue;
        }
        for contact in [found.right.unwrap(), found.left.unwrap()] {
            let away = (contact.point - pitch_point).norm();
            assert!(away <= base_pitch / 2.0 + 1e-6, "{away} of {base_pitch}");
        }
    }
}

/// Two pairs half a base pitch before and behind the pitch point are equally near: named is the one clockwise on the locked gear in
/// right-flank contact, its mirror image in left-flank contact, as the method's description says.
#[test]
fn of_two_equally_near_pairs_the_clockwise_one_is_named_at_the_right() {
    let design = design(44, 3.0);
    let [wheel, pinion] = [Face::Front, Face::Back]
        .map(|face| AsBuilt::perfect(Gear::nominal(design).unwrap(), face));
    for locked in [Member::Wheel, Member::Pinion] {
        let assembly = GearPair::new(wheel.clone(), pinion.clone(), 132.1, locked).unwrap();
        let kernel = ExactKernel::new(&assembly);
        let pitch_point =
            nalgebra::Point2::new(assembly.operating_pitch_radius(Member::Wheel), 0.0);
        for flank in Side::BOTH {
            for tooth in 1..=44 {
                let mating = Mating {
                    wheel_tooth: tooth,
                    pinion_tooth: 7,
                    flank,
                    fraction: 0.5,
                };
                let found = kernel.lost_motion(&Pose::new(&assembly, mating)).unwrap();
                let named = match flank {
                    Side::Right => found.right.unwrap().point,
                    Side::Left => found.left.unwrap().point,
                };
                let away = (named - pitch_point).norm();
                assert!(
                    (away - 0.5 * design.basic_data.base_pitch()).abs() < 1e-9,
                    "{away}"
                );
                let other = pitch_point - (named - pitch_point);
                let axis = assembly.axis(locked);
                let turn = (named - axis).perp(&(other - axis)) * -flank.sense();
                assert!(turn > 0.0, "{locked:?} {mating:?}: {found:?}");
            }
        }
    }
}

/// The common normal of two involutes touches both base circles.
#[test]
fn the_normal_of_two_involutes_touches_both_base_circles() {
    let mut random = Random(11);
    let mut met = 0;
    while met < 200 {
        let assembly = random::pair(&mut random, PERFECT);
        let pose = Pose::new(&assembly, random::mating(&mut random, &assembly));
        let found = ExactKernel::new(&assembly).lost_motion(&pose).unwrap();
        for contact in [found.right, found.left].into_iter().flatten() {
            if [contact.wheel.curve, contact.pinion.curve] != [ProfilePart::Involute; 2] {
                continue;
            }
            met += 1;
            assert!((contact.normal.norm() - 1.0).abs() < 1e-12);
            for member in [Member::Wheel, Member::Pinion] {
                let base = assembly.gear(member).gear().base_radius();
                let arm = (contact.point - assembly.axis(member)).perp(&contact.normal);
                assert!((arm.abs() - base).abs() < 1e-9 * base, "{arm} of {base}");
            }
        }
    }
}
