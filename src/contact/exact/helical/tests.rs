//! The places along the face that are not examined.

use super::turning::{FreeGear, Place};
use crate::contact::exact::section::SectionRequest;
use crate::contact::exact::tests::{Draws, mating, wild};
use crate::contact::{Contact, Effort, ExactKernel, Status};
use crate::pair::Pose;
use std::f64::consts::TAU;

/// Every place of wild pairs that are not jammed, with its whole section examined: the places that [`Facing::may_be_tighter_or_jam`]
/// rejects neither touch first nor jam.
#[test]
fn rejected_places_change_nothing() {
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
            let alone = section
                .lost_motion(&here, SectionRequest::all(&effort))
                .unwrap();
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

/// Over a face, a contact is known no better than in its own section. Source: the method of that section alone.
#[test]
fn a_face_knows_no_more_of_a_contact_than_its_section() {
    let mut draws = Draws(9);
    let mut contacts = 0;
    while contacts < 60 {
        let Some(pair) = wild(&mut draws) else {
            continue;
        };
        let pose = Pose::new(&pair, mating(1, 1, draws.within(0.0, 1.0)));
        let kernel = ExactKernel::new(&pair);
        let Ok(found) = kernel.found_within(&pose, &Effort::of_pose()) else {
            continue;
        };
        let found = found.lost_motion;
        for (side, contact) in [found.right, found.left].into_iter().enumerate() {
            let Some(contact) = contact else { continue };
            let here = pose.in_section(&pair, contact.section);
            let section = kernel.section.turned(&pair.section(contact.section));
            let alone = section.lost_motion(&here, SectionRequest::all(&Effort::endless()));
            let alone = alone.unwrap();
            let alone = [alone.right, alone.left][side].unwrap();
            assert!(contact.error >= alone.error, "{contact:?} {alone:?}");
            contacts += 1;
        }
    }
}
