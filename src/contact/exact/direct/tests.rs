//! The rules that select the corners to examine, compared with the placed teeth.

use super::*;
use crate::contact::exact::section::Section;
use crate::gear::{AsBuilt, Deviations, Face, Gear, GearDesign, Side};
use crate::pair::{Mating, Member, Pose};

/// The far corner of a locked land is examined if the free tip circle, `e` off its axis, can have its radius: `|ρ² −
/// r²| ≤ e (2r + e)`. Source: the radius of the corner of the placed tooth.
#[test]
fn a_far_corner_is_examined_where_the_free_tip_circle_can_be() {
    let gear = |teeth, face, eccentricity| {
        let gear = Gear::nominal(GearDesign::plain(teeth, 2.0)).unwrap();
        let deviations = Deviations {
            eccentricity,
            high_tooth: 3.5,
            ..Deviations::default()
        };
        AsBuilt::new(gear, face, &deviations).unwrap()
    };
    let (off, distance) = (0.5, 44.3);
    let (wheel, pinion) = (gear(25, Face::Front, 0.2), gear(18, Face::Back, off));
    let pair = GearPair::with_locked(wheel, pinion, distance, Member::Wheel).unwrap();
    let section = Section::new(&pair);
    let solver = section.solver.as_ref().unwrap();
    let tip = pair.gear(Member::Pinion).gear().tip_radius();
    let (low, high) = (
        tip * tip - off * (2.0 * tip + off),
        (tip + off) * (tip + off),
    );
    let (mut within, mut nearer, mut farther) = (0, 0, 0);
    for (problem, flank) in [(&section.right, Side::Right), (&section.left, Side::Left)] {
        for k in 0..1000 {
            let mating = Mating {
                wheel_tooth: 1 + k % 25,
                pinion_tooth: 1 + k % 18,
                flank,
                fraction: f64::from(k) / 1000.0,
            };
            let posed = section.posed(problem, &Pose::new(&pair, mating));
            for step in posed.steps() {
                let locked = posed.locked(step);
                let far = locked.range(ProfilePart::Tip).0;
                let square = locked.at(ProfilePart::Tip, far).point.norm_sqr();
                let found = posed.far_corner_reaches(solver, posed.places(step).0);
                let expected = (low..=high).contains(&square);
                let case = format!("{k} {step}: {square} of {low} to {high}, {found:?}");
                assert_eq!(found.is_some(), expected, "{case}");
                assert!(
                    found.is_none_or(|found| (found - square).abs() < 1e-10),
                    "{case}"
                );
                within += i32::from(expected);
                nearer += i32::from(square < low);
                farther += i32::from(square > high);
            }
        }
    }
    assert!(
        within > 100 && nearer > 100 && farther > 100,
        "{within} {nearer} {farther}"
    );
}
