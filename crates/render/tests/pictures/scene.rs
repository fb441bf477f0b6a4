//! The scene in mm: outlines, contacts and lines where the closed form says they are.

use crate::closed_form::{j_bn, lost_motion, pair, pose};
use gearlash::contact::{FreePlacement, Scene};
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Placed, Side,
};
use gearlash::pair::Member;
use nalgebra::{Point2, Vector2};
use std::f64::consts::PI;

/// Distance of `point` from the closed polygon.
fn distance(polygon: &[Point2<f64>], point: Point2<f64>) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon
        .iter()
        .zip(next)
        .map(|(a, b)| {
            let (along, to) = (b - a, point - a);
            let t = (to.dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            (to - t * along).norm()
        })
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn the_points_of_a_contact_lie_on_both_outlines() {
    let chord = 1e-5;
    for locked in [Member::Wheel, Member::Pinion] {
        for (flank, fraction) in [(Side::Right, 0.0), (Side::Left, 0.2), (Side::Right, -0.3)] {
            let assembly = pair([25, 38], 2.0, 63.07, locked);
            let at = pose(&assembly, [7, 30], flank, fraction);
            let lost = lost_motion(&assembly, &at);
            let assembled = assembly.clone().into();
            let scene = Scene::new(&assembled, &at, &lost);
            assert_eq!(scene.free_placement(), FreePlacement::AtContact(flank));
            for meeting in scene.contacts() {
                let outline = |member| {
                    scene
                        .placed(member)
                        .outline_near(meeting.on_locked, 5.0, chord)
                };
                let off_locked = distance(&outline(locked), meeting.on_locked);
                let off_free = distance(&outline(locked.mate()), meeting.on_free);
                // Only contacts on the real flanks say something.
                assert!(
                    off_locked <= 2.0 * chord,
                    "{locked:?} {meeting:?} {off_locked}"
                );
                assert!(off_free <= 2.0 * chord, "{locked:?} {meeting:?} {off_free}");
                let expected = if meeting.side == flank {
                    0.0
                } else {
                    j_bn(&assembly)
                };
                assert!((meeting.gap - expected).abs() < 1e-12, "{meeting:?}");
            }
        }
    }
}

#[test]
fn contacts_lie_on_their_line_of_action_between_the_tip_circles() {
    let assembly = pair([25, 38], 2.0, 63.07, Member::Wheel);
    let at = pose(&assembly, [7, 30], Side::Right, 0.2);
    let lost = lost_motion(&assembly, &at);
    let assembled = assembly.clone().into();
    let scene = Scene::new(&assembled, &at, &lost);
    for (side, contact) in [(Side::Right, lost.right), (Side::Left, lost.left)] {
        let action = scene.line_of_action(side).unwrap();
        let [from, to] = action.path.unwrap();
        let point = contact.unwrap().point;
        let along = (to - from).normalize();
        assert!((point - from).perp(&along).abs() < 1e-12);
        assert!((0.0..=(to - from).norm()).contains(&(point - from).dot(&along)));
        // Each end of the path is on a tip circle, each end of the line on a base circle.
        let gear = |member| assembly.gear(member).gear();
        let axis = assembly.axis(Member::Pinion);
        assert!(((from - axis).norm() - gear(Member::Pinion).tip_radius()).abs() < 1e-12);
        assert!((to.coords.norm() - gear(Member::Wheel).tip_radius()).abs() < 1e-12);
        assert!((action.ends[0].coords.norm() - gear(Member::Wheel).base_radius()).abs() < 1e-12);
    }
}

/// `j_wt = j_bn/cos α_wt` (design section 5).
#[test]
fn circumferential_backlash_is_that_of_the_operating_circle() {
    let assembly = pair([25, 38], 2.0, 63.07, Member::Pinion);
    let at = pose(&assembly, [7, 30], Side::Left, 0.0);
    let lost = lost_motion(&assembly, &at);
    let assembled = assembly.clone().into();
    let (j_wt, _) = Scene::new(&assembled, &at, &lost)
        .circumferential_backlash()
        .unwrap();
    let expected = j_bn(&assembly) / assembly.operating_pressure_angle().cos();
    assert!((j_wt - expected).abs() < 1e-12, "{j_wt} {expected}");
}

/// The rim of a gear between its tip and root circles: every vertex there, and no tooth twice.
#[test]
fn an_outline_keeps_its_deviations_and_its_eccentricity() {
    let basic_data = BasicGearData::new(20, 3.0, 20f64.to_radians()).unwrap();
    let gear = Gear::nominal(GearDesign {
        basic_data,
        profile_shift: 0.0,
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    })
    .unwrap();
    let mut per_tooth = vec![0.0; 20];
    per_tooth[4] = 0.3;
    let deviations = Deviations {
        per_tooth,
        eccentricity: 0.2,
        high_tooth: 6.0,
        ..Deviations::default()
    };
    let as_built = AsBuilt::new(gear, Face::Back, &deviations).unwrap();
    let axis = Point2::new(10.0, -4.0);
    let placed = Placed::new(&as_built, axis, 0.4);
    // Numbers ascend counter-clockwise on a back face: tooth 6 stands a quarter turn from tooth 1.
    let high = 0.4 + PI / 2.0;
    let centre = axis + 0.2 * Vector2::new(high.cos(), high.sin());
    assert!((placed.centre() - centre).norm() < 1e-12);
    assert_eq!(placed.teeth_near(centre, 1.0).len(), 20);

    // Tooth 5 is 0.3 mm thicker on the reference circle than π m/2.
    let direction = placed.direction(5);
    let place = centre + 30.0 * Vector2::new(direction.cos(), direction.sin());
    let chord = 1e-6;
    let outline = placed.outline_near(place, 3.0, chord);
    let half = (PI * 3.0 / 2.0 + 0.3) / 60.0;
    for side in Side::BOTH {
        let angle = direction + side.sense() * half;
        let flank = centre + 30.0 * Vector2::new(angle.cos(), angle.sin());
        assert!(distance(&outline, flank) <= 2.0 * chord, "{side:?}");
    }
    let rim = outline.iter().map(|point| (point - centre).norm());
    let off_rim = rim
        .filter(|r| !(26.25 - 1e-9..=33.0 + 1e-9).contains(r))
        .count();
    assert_eq!(off_rim, 1, "the centre closes the polygon");
}
