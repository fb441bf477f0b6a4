//! Perfect gears against the closed form, and which of several pairs that touch together gives a contact its name.

use super::*;
use crate::kit::locked;
use crate::random::{self, PERFECT, Random};

/// `j_wt = j_bn/cos α_wt` of perfect gears in involute contact, `j_bn = p_b − s_b1 − s_b2 + 2 (r_b1 + r_b2) inv α_wt`, mm.
pub fn closed_form(assembly: &GearPair) -> f64 {
    let [wheel, pinion] = Member::BOTH.map(|member| assembly.gear(member).gear());
    let sum = wheel.base_radius() + pinion.base_radius();
    let roll = involute::roll_at(assembly.center_distance(), sum);
    let thick = wheel.base_thickness() + pinion.base_thickness();
    let space = wheel.basic_data().base_pitch() - thick;
    (space + 2.0 * sum * involute::inv_of_roll(roll)) / assembly.operating_pressure_angle().cos()
}

/// Whether both tips stay on the mate's involute, below the far base circle's tangency, and one
/// pair at least is always on the path: then the closed form holds at every phase.
fn within_path(assembly: &GearPair) -> bool {
    let [wheel, pinion] = Member::BOTH.map(|member| assembly.gear(member).gear());
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

/// Source: the closed form, exact for perfect involute gears. The common normal of two involutes touches both base circles.
#[test]
fn perfect_gears_follow_the_closed_form_to_a_tenth_of_a_picometre() {
    let mut random = Random(44);
    let (mut pairs, mut poses, mut on_path, mut negative) = (0, 0, 0, 0);
    while pairs < 1000 {
        let assembly = random::pair(&mut random, PERFECT);
        if !within_path(&assembly) {
            continue;
        }
        pairs += 1;
        let j_wt = closed_form(&assembly);
        negative += usize::from(j_wt < 0.0);
        let kernel = ExactKernel::new(&assembly);
        for _ in 0..4 {
            let mating = random::mating(&mut random, &assembly);
            let found = kernel.lost_motion(&Pose::new(&assembly, mating)).unwrap();
            let above = found.angle().unwrap() * um(&assembly) - 1e3 * j_wt;
            poses += 1;
            // A tip that reaches past the line of action into the fillet takes backlash away; nothing adds any.
            assert!(above <= 1e-7, "{above:e} µm: {mating:?} {assembly:?}");
            let contacts = [found.right.unwrap(), found.left.unwrap()];
            let touches = |contact: &Contact| [contact.wheel, contact.pinion];
            let mut touches = contacts.iter().flat_map(touches);
            if touches.all(|touch| touch.curve == ProfilePart::Involute) {
                assert!(above >= -1e-7, "{above:e} µm: {mating:?} {assembly:?}");
                on_path += 1;
                for contact in contacts {
                    assert!((contact.normal.norm() - 1.0).abs() < 1e-12);
                    for member in Member::BOTH {
                        let base = assembly.gear(member).gear().base_radius();
                        let arm = (contact.point - assembly.axis(member)).perp(&contact.normal);
                        near(mating, arm.abs(), base, 1e-9 * base);
                    }
                }
            }
        }
    }
    assert!(20 * on_path > 19 * poses && negative > 100);
}

/// The tie goes to the contact nearer to the pitch point, by 1e-6 mm; else at right flanks to the one clockwise on the locked gear, at left flanks to the
/// one counter-clockwise. Source: the rule, and the two points named where the name changes.
#[test]
fn of_pairs_that_tie_the_nearer_to_the_pitch_point_is_named() {
    let mut changes = 0;
    for (teeth, distance) in [([30, 30], 60.02), ([40, 25], 65.02), ([19, 52], 71.01)] {
        for member in Member::BOTH {
            let [wheel, pinion] = teeth.map(|teeth| spur(teeth, 2.0));
            let pair = locked(&wheel, &pinion, distance, member);
            let kernel = ExactKernel::new(&pair);
            let pitch_point = Point2::new(pair.operating_pitch_radius(Member::Wheel), 0.0);
            for side in Side::BOTH {
                let at = |fraction: f64| -> Contact {
                    let found = kernel.lost_motion(&Pose::new(&pair, at(1, 1, fraction)));
                    found.unwrap().on(side).unwrap()
                };
                let tooth = |contact: &Contact| contact.touch(member).tooth;
                for k in 0..40 {
                    let [low, high] = [0, 1].map(|on| f64::from(k + on) / 40.0);
                    let first = tooth(&at(low));
                    if first == tooth(&at(high)) {
                        continue;
                    }
                    let both = halved(low, high, 50, |middle| tooth(&at(middle)) == first).map(at);
                    // Both are on one straight path of contact, a base pitch apart.
                    let gap = (both[0].point - both[1].point).norm();
                    let built = pair.gear(member);
                    near("gap", gap, built.gear().basic_data().base_pitch(), 1e-9);
                    let away = both.map(|contact| (contact.point - pitch_point).norm());
                    let preferred = if side == Side::Right { -1 } else { 1 };
                    let next = built.counter_clockwise(tooth(&both[0]), preferred);
                    let sense = if next == tooth(&both[1]) { 1.0 } else { -1.0 };
                    let farther = sense * (away[1] - away[0]);
                    // Contacts whose distances from the pitch point differ by less are equally near.
                    near((teeth, side), farther, 1e-6, 1e-8);
                    changes += 1;
                }
            }
        }
    }
    assert_eq!(changes, 12);
}
