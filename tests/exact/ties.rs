//! Which of several pairs that touch together gives a contact its name: of perfect gears all that are in contact do.

use crate::design::design;
use gearlash::contact::{Contact, ExactKernel};
use gearlash::gear::{AsBuilt, Face, Gear, Side};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use nalgebra::Point2;

/// Contacts whose distances from the pitch point differ by less are equally near, mm.
const EQUALLY_NEAR: f64 = 1e-6;

/// The tie goes to the contact nearer to the pitch point. Between two equally near ones it goes at right flanks to the one clockwise on the
/// locked gear, at left flanks to the one counter-clockwise. As the gears turn from one named contact to the next, the name changes where
/// the first is further by 1e-6 mm. Source: the rule, and the two points named.
#[test]
fn of_pairs_that_tie_the_nearer_to_the_pitch_point_is_named() {
    let gear = |teeth, face| AsBuilt::perfect(Gear::nominal(design(teeth, 2.0)).unwrap(), face);
    let mut changes = 0;
    for (teeth, distance) in [([30, 30], 60.02), ([40, 25], 65.02), ([19, 52], 71.01)] {
        for locked in [Member::Wheel, Member::Pinion] {
            let (wheel, pinion) = (gear(teeth[0], Face::Front), gear(teeth[1], Face::Back));
            let pair = GearPair::with_locked(wheel, pinion, distance, locked).unwrap();
            let kernel = ExactKernel::new(&pair);
            let pitch_point = Point2::new(pair.operating_pitch_radius(Member::Wheel), 0.0);
            for side in Side::BOTH {
                let at = |fraction: f64| -> Contact {
                    let pose = Pose::new(
                        &pair,
                        Mating {
                            fraction,
                            ..Mating::FIRST
                        },
                    );
                    let found = kernel.lost_motion(&pose).unwrap();
                    match side {
                        Side::Right => found.right.unwrap(),
                        Side::Left => found.left.unwrap(),
                    }
                };
                let tooth = |contact: &Contact| match locked {
                    Member::Wheel => contact.wheel.tooth,
                    Member::Pinion => contact.pinion.tooth,
                };
                for k in 0..40 {
                    let [mut low, mut high] = [0, 1].map(|on| f64::from(k + on) / 40.0);
                    if tooth(&at(low)) == tooth(&at(high)) {
                        continue;
                    }
                    for _ in 0..50 {
                        let middle = 0.5 * (low + high);
                        if tooth(&at(middle)) == tooth(&at(low)) {
                            low = middle
                        } else {
                            high = middle
                        }
                    }
                    let both = [at(low), at(high)];
                    // Both are on one straight path of contact, a base pitch apart.
                    let gap = (both[0].point - both[1].point).norm();
                    let base_pitch = pair.gear(locked).gear().basic_data().base_pitch();
                    assert!((gap - base_pitch).abs() < 1e-9, "{gap} {base_pitch}");
                    let away = both.map(|contact| (contact.point - pitch_point).norm());
                    let built = pair.gear(locked);
                    let preferred = match side {
                        Side::Right => -1,
                        Side::Left => 1,
                    };
                    let next = built.counter_clockwise(tooth(&both[0]), preferred);
                    let farther = if next == tooth(&both[1]) {
                        away[1] - away[0]
                    } else {
                        away[0] - away[1]
                    };
                    assert!(
                        (farther - EQUALLY_NEAR).abs() < 1e-8,
                        "{teeth:?} {side:?}: {farther:e}"
                    );
                    changes += 1;
                }
            }
        }
    }
    assert_eq!(changes, 12);
}
