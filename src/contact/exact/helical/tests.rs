//! What is not looked at along the face.

use super::turning::{FreeGear, Place};
use crate::contact::exact::section::Wanted;
use crate::contact::exact::tests::{Draws, mating, wild};
use crate::contact::{Contact, Effort, ExactKernel, Status};
use crate::pair::Pose;
use std::f64::consts::TAU;

/// Every place of wild pairs that are not jammed, its whole section looked at: what [`Facing::may_hold`] leaves out neither touches first nor jams.
#[test]
fn places_that_are_left_out_change_nothing() {
    let mut draws = Draws(5);
    let effort = Effort::endless();
    let (mut poses, mut sections) = (0, 0);
    while poses < 12 {
        let Some(pair) = wild(&mut draws) else {
            continue;
        };
        let at = mating(1, 1, draws.within(0.0, 1.0));
        let (kernel, pose) = (ExactKernel::new(&pair), Pose::new(&pair, at));
        let found = kernel.found_within(&pose, &effort).unwrap();
        let both = found.lost_motion.right.zip(found.lost_motion.left);
        let Some((right, left)) = both.filter(|_| found.jam.is_none()) else {
            continue;
        };
        let plane = &kernel.section;
        let helical = kernel.helical.as_ref().unwrap();
        let Some(edges) = &helical.edges else {
            continue;
        };
        let mut places = Vec::new();
        for (problem, rotation) in [
            (&plane.right, right.rotation),
            (&plane.left, -left.rotation),
        ] {
            let posed = plane.posed(problem, &pose);
            let stands = FreeGear {
                rotation,
                is_held: true,
            };
            places.extend(edges.places(&pair, &posed, stands, &effort));
        }
        for &Place { b, .. } in &places {
            let here = pose.in_section(&pair, b);
            let section = plane.turned(&pair.section(b));
            let alone = section.lost_motion(&here, Wanted::all(&effort)).unwrap();
            assert_ne!(alone.status(), Status::Jammed, "{b} of {pair:?} {at:?}");
            let beyond = |one: Contact, over: Contact| {
                let turned =
                    one.rotation - here.free_rotation() - over.rotation + pose.free_rotation();
                (
                    turned - TAU * (turned / TAU).round(),
                    1e-12 + one.error + over.error,
                )
            };
            let farther = alone.right.map(|contact| beyond(contact, right));
            assert!(
                farther.is_none_or(|(turned, bound)| turned <= bound),
                "{b} of {pair:?} {at:?}"
            );
            let farther = alone.left.map(|contact| beyond(contact, left));
            assert!(
                farther.is_none_or(|(turned, bound)| turned >= -bound),
                "{b} of {pair:?} {at:?}"
            );
        }
        poses += u32::from(places.len() > 50);
        sections += places.len();
    }
    println!("{sections} sections");
}
