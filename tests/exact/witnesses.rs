//! Poses that expose a small mistake in the program: the first of thousands at which a one-line change of `src/contact` (a mutant: `tests/README.md`)
//! gave a wrong contact or a wrong verdict, and which a method without the change refuses.

use super::*;
use crate::campaign::turned;
use crate::clearance;
use crate::methods::{against_polygons, by_both_methods, cut};
use crate::random::{self, Random};
use gearlash::error::Error;

/// Seed of the campaign's pairs.
const SEED: u64 = 2;

/// The poses of a list of `data/witnesses.toml`.
pub fn listed(list: &str) -> Vec<u64> {
    let lists: toml::Table = include_str!("data/witnesses.toml").parse().unwrap();
    lists[list].clone().try_into().unwrap()
}

/// One pose in five grazes, and one has a tip on a root.
pub fn depth(index: u64) -> Option<Depth> {
    match index % 5 {
        3 => Some(Depth::Grazing),
        4 => Some(Depth::OnRoot),
        _ => None,
    }
}

fn drawn(index: u64) -> (GearPair, Pose) {
    let drawn = Drawn::of(Teeth::Spur, depth(index), SEED, index);
    let pose = Pose::new(&drawn.assembly, drawn.mating);
    (drawn.assembly, pose)
}

fn of_spur(depth: Option<Depth>, index: u64) -> Vec<String> {
    by_both_methods(Teeth::Spur, depth, SEED, index)
}

/// Source: the polygon method and its certificate.
#[test]
fn spur_poses_hold_against_polygons() {
    let mut against = complaints(&listed("spur"), |&index| of_spur(depth(index), index));
    let grazing = Some(Depth::Grazing);
    against.extend(complaints(&listed("grazing"), |&index| {
        of_spur(grazing, index)
    }));
    assert!(against.is_empty(), "{against:#?}");
}

/// A pose that both methods had wrong in the same way. Source: clearance of dense points.
#[test]
fn a_pose_that_both_methods_may_get_wrong_holds_against_brute_force() {
    let (assembly, pose) = drawn(81);
    let found = ExactKernel::new(&assembly).lost_motion(&pose).unwrap();
    let against = clearance::against(&assembly, &pose, &found);
    assert!(against.is_empty(), "{against:#?}");
}

/// Source: the independent half teeth of the clearance, and the teeth found by polygons.
#[test]
fn contacts_are_where_reported() {
    let against = complaints(&listed("named"), |&index| {
        let (assembly, pose) = drawn(index);
        let found = ExactKernel::new(&assembly).lost_motion(&pose).unwrap();
        let mut against = clearance::named(&assembly, &pose, &found);
        let polygon = cut(&assembly).refined_kernel(&assembly).lost_motion(&pose);
        let names = |contact: Contact| (contact.wheel.tooth, contact.pinion.tooth);
        let teeth = [found, polygon.unwrap()]
            .map(|found| [found.right, found.left].map(|contact| contact.map(names)));
        if teeth[0] != teeth[1] {
            against.push(format!("polygons name other teeth: {teeth:?}"));
        }
        against
    });
    assert!(against.is_empty(), "{against:#?}");
}

/// Contacts as found; off by ten bounds and by ten thousand either way; missing; and invented. Each with whether it
/// must be confirmed. The rotations of a jammed pose have no meaning.
fn claims(assembly: &GearPair, found: &LostMotion) -> Vec<(LostMotion, bool)> {
    let axis = assembly.axis(assembly.free());
    let gear = assembly.gear(assembly.free()).gear();
    let pitch = gear.basic_data().angular_pitch();
    let mut claims = vec![(*found, true)];
    for side in Side::BOTH {
        let mut claim = |contact| {
            let claimed = with_contact(found, side, contact);
            let borne = claimed.solid || claimed.status() == Status::Jammed;
            claims.push((claimed, borne));
        };
        let Some(contact) = found.on(side) else {
            // The contact of the other side, if there is one.
            if let Some(other) = found.on(side.other()) {
                claim(Some(other));
            }
            continue;
        };
        let lever = (contact.point - axis).perp(&contact.normal).abs();
        // The finest polygons resolve some hundreds of ulps.
        let known = contact.error + 1e3 * f64::EPSILON * assembly.center_distance() / lever;
        for off in [10.0, -10.0, 1e4, -1e4].map(|bounds| bounds * known) {
            if off.abs() < 1e-3 * pitch {
                claim(Some(turned(contact, off)));
            }
        }
        claim(None);
        // With a bound of a fiftieth of a pitch a contact within it is right, and one off by three of them is wrong.
        let wide = pitch / 50.0;
        for bounds in [0.0, 0.5, -0.5, 3.0, -3.0] {
            let contact = Contact {
                error: wide,
                ..turned(contact, bounds * wide)
            };
            let claimed = with_contact(found, side, Some(contact));
            let jammed = claimed.solid || claimed.status() == Status::Jammed;
            claims.push((claimed, bounds.abs() < 1.0 || jammed));
        }
    }
    claims
}

/// The wrong verdicts of the certificate.
fn misjudged(assembly: &GearPair, pose: &Pose, found: &LostMotion) -> Vec<String> {
    let cut = cut(assembly);
    let certifier = Certifier::new(cut.kernel(assembly));
    let claims = claims(assembly, found).into_iter();
    let wrong = claims.filter_map(|(claimed, borne)| {
        let seen = certifier.check(pose, &claimed);
        let right = match &seen {
            Ok(()) => borne,
            Err(Error::CertificateFailed { .. }) => !borne,
            Err(_) => false,
        };
        (!right).then(|| format!("{seen:?} of {claimed:?}"))
    });
    wrong.collect()
}

/// Source: both methods, which agree on the right contacts.
#[test]
fn the_certificate_confirms_right_contacts_and_refuses_wrong_ones() {
    let against = complaints(&listed("certified"), |&index| {
        let (assembly, pose) = drawn(index);
        let found = ExactKernel::new(&assembly).lost_motion(&pose).unwrap();
        let mut against = of_spur(depth(index), index);
        against.extend(misjudged(&assembly, &pose, &found));
        against
    });
    assert!(against.is_empty(), "{against:#?}");
}

/// Source: the polygon method and its certificate.
#[test]
fn deviating_profiles_hold_against_polygons() {
    let against = complaints(&listed("modified"), |&seed| {
        let mut random = Random(seed ^ 0x77aa);
        let assembly = crate::profiles::deviating_pair(&mut random, seed % 3 == 0).unwrap();
        let pose = Pose::new(&assembly, random::mating(&mut random, &assembly));
        let exact = ExactKernel::new(&assembly).lost_motion(&pose).unwrap();
        against_polygons(&assembly, &pose, &exact)
    });
    assert!(against.is_empty(), "{against:#?}");
}
