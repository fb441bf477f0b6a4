//! Proofs by directions: what they accept, what they refuse, and what the checker verifies.

use super::*;
use crate::along_face::OPEN;
use crate::clearance;
use crate::methods::{against_polygons, by_both_methods};
use gearlash::contact::{Piece, Proof, Prover, Reason, SideProof, lost_motion_at};

/// Proven poses of the campaign, each with what was found and its proof; and how many of other poses there were.
fn proven(
    kind: Teeth,
    depth: Option<Depth>,
    indices: impl Iterator<Item = u64>,
) -> (Vec<(Drawn, LostMotion, Proof)>, usize) {
    let mut left = 0;
    let mut proven = Vec::new();
    for index in indices {
        let drawn = Drawn::of(kind, depth, 3, index);
        let pose = Pose::new(&drawn.assembly, drawn.mating);
        let kernel = ExactKernel::new(&drawn.assembly);
        // Teeth in the mate's body need no proof of what touches.
        let found = kernel.lost_motion(&pose).ok().filter(|found| !found.solid);
        let Some(found) = found else { continue };
        let prover = Prover::new(&drawn.assembly, &kernel);
        let proof = prover.proof(&pose, &found);
        assert_eq!(proof.is_ok(), prover.check(&pose, &found).is_ok());
        match proof {
            Ok(proof) => proven.push((drawn, found, proof)),
            Err(_) => left += 1,
        }
    }
    (proven, left)
}

/// Polygons of both gears, coarse ones.
fn certificates(pair: &GearPair) -> CutPair {
    CutPair::for_certificates(pair.gear(Member::Wheel), pair.gear(Member::Pinion))
}

/// The checker, a program of its own, accepts what the prover proves: of all statuses and of contacts on involutes, tips and fillets. Few poses are
/// left to the polygons.
#[test]
fn the_checker_accepts_what_is_proven() {
    for depth in [None, Some(Depth::Grazing)] {
        let (proven, left) = proven(Teeth::Spur, depth, (0..10_000).step_by(5));
        let mut reasons = [0; 3];
        for (drawn, found, proof) in &proven {
            let pose = Pose::new(&drawn.assembly, drawn.mating);
            let verified = proof.verify(&drawn.assembly, &pose);
            assert_eq!(verified, Ok(()), "{}\n{found:?}", drawn.pair_file());
            for one in proof.sides.iter().flat_map(|side| &side.apart) {
                reasons[match one.by {
                    Reason::Direction => 0,
                    Reason::OutOfReach => 1,
                    Reason::LockedTangents | Reason::FreeTangents => 2,
                }] += 1;
            }
        }
        // Grazing tips reach no fillet.
        let mut expected = reasons.iter().take(if depth.is_none() { 3 } else { 2 });
        assert!(200 * left < proven.len(), "{left}");
        assert!(expected.all(|count| *count > 0), "{reasons:?}");
    }
}

/// The checker accepts proofs of helical pairs, whose sides touch in different sections: the play of both meets in the measuring plane.
#[test]
fn the_checker_accepts_proofs_in_two_sections() {
    let mut in_two = 0;
    let (proven, _) = proven(Teeth::Helical, None, 0..400);
    for (drawn, found, proof) in &proven {
        let pose = Pose::new(&drawn.assembly, drawn.mating);
        let verified = proof.verify(&drawn.assembly, &pose);
        assert_eq!(verified, Ok(()), "{}", drawn.pair_file());
        let sections = [found.right, found.left].map(|contact| contact.map(|one| one.section));
        in_two += usize::from(sections[0] != sections[1]);
    }
    assert!(in_two > 50, "{in_two}");
}

/// Each is proven, the checker accepts the proof, and the campaign finds that a contact moved by 3 bounds is refused.
#[test]
fn poses_once_left_to_the_polygons_are_proven() {
    let poses: Vec<(u64, u64, String)> = rows(include_str!("data/once_left.csv"));
    let against = complaints(&poses, |&(seed, index, _)| {
        let drawn = Drawn::new(None, seed, index);
        let pose = Pose::new(&drawn.assembly, drawn.mating);
        let kernel = ExactKernel::new(&drawn.assembly);
        let found = kernel.lost_motion(&pose).unwrap();
        let proof = Prover::new(&drawn.assembly, &kernel).proof(&pose, &found);
        let proof = proof.map_err(str::to_owned);
        let verified = proof.and_then(|proof| proof.verify(&drawn.assembly, &pose));
        let mut against = by_both_methods(Teeth::Spur, None, seed, index);
        against.extend(verified.err());
        against
    });
    assert!(against.is_empty(), "{against:#?}");
}

/// A free tip closes against the far flank of a locked tooth that points sideways, of 8 teeth. Half teeth that face each other let the gear turn
/// 17.6 µm further, of 37.4 µm. Source: points of whole gears in each other's metal, from another program.
#[test]
fn a_tip_may_close_against_the_far_flank_of_a_tooth_beside_it() {
    let drawn = Drawn::new(None, 3, 744_097);
    let pair = &drawn.assembly;
    let pose = Pose::new(pair, drawn.mating);
    let exact = ExactKernel::new(pair).lost_motion(&pose).unwrap();
    let polygon = certificates(pair).refined_kernel(pair).lost_motion(&pose);
    let polygon = polygon.unwrap();
    for found in [exact, polygon] {
        let right = found.right.unwrap();
        let overlap = |off: f64| clearance::overlap(pair, &pose, right.rotation + off);
        assert!(overlap(1e-6) <= 0.0 && overlap(-1e-4) > 1e-5, "{right:?}");
        near("angle", found.angle().unwrap(), 2.790_281e-3, 1e-8);
    }
}

/// The free gear closes against the far half of a locked tooth whose near half is out of reach. The exact method once left such teeth out, and turned
/// 1.3 to 54 mrad into the metal. Source: points of whole gears in each other's metal, from another program, and certificates by polygons.
#[test]
fn a_far_half_counts_where_the_near_half_is_out_of_reach() {
    let poses = [(3, 38733), (2, 44542), (2, 63195), (2, 85076), (2, 153_995)];
    let mut clear = 0;
    for (seed, index) in poses {
        let drawn = Drawn::new(None, seed, index);
        let pair = &drawn.assembly;
        let pose = Pose::new(pair, drawn.mating);
        let found = ExactKernel::new(pair).lost_motion(&pose).unwrap();
        let against = against_polygons(pair, &pose, &found);
        assert!(against.is_empty(), "{index}: {against:#?}");
        if found.status() != Status::Clear {
            continue;
        }
        clear += 1;
        let [right, left] = [found.right, found.left].map(|contact| contact.unwrap().rotation);
        for (rotation, opens) in [(right, 1.0), (left, -1.0)] {
            let overlap = |by: f64| clearance::overlap(pair, &pose, rotation + opens * by);
            assert!(overlap(1e-6) <= 0.0 && overlap(-1e-3) > 0.0, "{index}");
        }
    }
    assert!(clear > 2, "{clear}");
}

/// Root circles that overlap where a space faces a space jam the pair, or its contacts are lost: both methods once called such poses clear. Four low and
/// thin teeth on four, the free gear eccentric or not. Source: points of whole gears in each other's metal, from another program.
#[test]
fn a_space_may_not_hold_the_root_circle_of_the_mate() {
    let gear = |eccentricity| {
        let gear = spur(4, 2.0).rack(0.05, 0.1, 0.0).per_tooth(vec![-1.8; 4]);
        gear.runout(eccentricity, 1.0)
    };
    // A proof of [`OPEN`] without any separation.
    let side = |side| SideProof {
        side,
        section: 0.0,
        open: None,
        until: None,
        touch: None,
        apart: Vec::new(),
    };
    let sides = Side::BOTH.map(side).to_vec();
    let open = Proof { sides };
    let (mut jammed, mut lost, mut clear) = (0, 0, 0);
    for (eccentricity, distance) in [0.0, 0.05].into_iter().flat_map(|eccentricity| {
        let distances = [7.52, 7.54, 7.56, 7.58, 7.59, 7.605, 7.62, 7.64, 7.66];
        distances.map(|distance| (eccentricity, distance))
    }) {
        let pair = pair(&gear(0.0), &gear(eccentricity), distance);
        let cut = certificates(&pair);
        let kernel = ExactKernel::new(&pair);
        for fraction in (0..10).map(|k| 0.43 + 0.005 * f64::from(k)) {
            let pose = Pose::new(&pair, at(1, 1, fraction));
            let polygon = cut.refined_kernel(&pair).lost_motion(&pose);
            let statuses = [kernel.lost_motion(&pose), polygon].map(|found| {
                let Ok(found) = found else { return None };
                if let (Status::Clear, Some(right), Some(left)) =
                    (found.status(), found.right, found.left)
                {
                    let middle = 0.5 * (right.rotation + left.rotation);
                    let overlap = clearance::overlap(&pair, &pose, middle);
                    assert!(overlap <= 0.0, "{eccentricity} {distance} {fraction}");
                }
                Some(found.status())
            });
            assert_eq!(statuses[0], statuses[1], "{eccentricity} {distance}");
            // Neither prover nor checker takes a pose as proven at which nothing touches.
            let overlaps = distance < 2.0 * 3.8 + eccentricity;
            let checked = Prover::new(&pair, &kernel).check(&pose, &OPEN);
            assert_eq!(checked == Err("root lands reach each other"), overlaps);
            let checked = open.verify(&pair, &pose);
            assert_eq!(checked == Err("root circles overlap".to_owned()), overlaps);
            lost += usize::from(statuses[0].is_none());
            jammed += usize::from(statuses[0] == Some(Status::Jammed));
            clear += usize::from(statuses[0] == Some(Status::Clear));
        }
    }
    assert!([jammed, lost, clear].iter().all(|count| *count > 20));
}

/// The checker refuses a proof that says too much: one closed by more than its bound, with a pair left out, a direction turned, a stretch of a fillet
/// shortened, a common point moved out of the metal.
#[test]
fn the_checker_refuses_what_is_not_so() {
    let (proven, _) = proven(Teeth::Spur, None, (0..2500).step_by(5));
    let mut refused = [0; 6];
    for (drawn, _, proof) in &proven {
        let assembly = &drawn.assembly;
        let pose = Pose::new(assembly, drawn.mating);
        let refuses = |change: &dyn Fn(&mut Proof)| {
            let mut changed = proof.clone();
            change(&mut changed);
            changed.verify(assembly, &pose).is_err()
        };
        let Some((open, touch)) = proof.sides[0].open.zip(proof.sides[0].touch) else {
            // Nothing touches at any rotation: some tooth is in need of its proof.
            let none = |proof: &mut Proof| proof.sides[0].apart.clear();
            refused[5] += usize::from(refuses(&none));
            continue;
        };
        let closed =
            |proof: &mut Proof| proof.sides[0].open = Some(2.5 * touch.closed - 1.5 * open);
        let away = |proof: &mut Proof| {
            let normal = proof.sides[0].apart[0].normal;
            if let Some(touch) = &mut proof.sides[0].touch {
                touch.point += 10.0 * normal;
            }
        };
        let untouched = |proof: &mut Proof| proof.sides[0].touch = None;
        let is_refused = refuses(&closed) && refuses(&away) && refuses(&untouched);
        assert!(is_refused, "{}", drawn.pair_file());
        refused[0] += 1;
        refused[1] += 1;
        for k in 0..proof.sides[0].apart.len() {
            let named = proof.sides[0].apart[k];
            let without = |proof: &mut Proof| {
                proof.sides[0].apart.retain(|one| {
                    (one.locked_tooth, one.free_tooth) != (named.locked_tooth, named.free_tooth)
                });
            };
            let turned = |proof: &mut Proof| proof.sides[0].apart[k].normal *= -1.0;
            // The tangents of a fillet are its own.
            if matches!(named.by, Reason::Direction | Reason::OutOfReach) {
                assert!(refuses(&turned), "{}", drawn.pair_file());
                refused[2] += 1;
            }
            // The far half of a tooth counts too.
            let halved = |proof: &mut Proof| proof.sides[0].apart[k].locked = Piece::Top;
            let is_whole = named.locked == Piece::Tooth && named.free == Piece::Top;
            assert!(!is_whole || refuses(&halved), "{}", drawn.pair_file());
            // A tooth that is far away has no need of a proof.
            refused[3] += usize::from(refuses(&without));
            if let Piece::Fillet([low, high]) = named.locked {
                let shorter = |proof: &mut Proof| {
                    proof.sides[0].apart[k].locked = Piece::Fillet([low, 0.5 * (low + high)]);
                };
                refused[4] += usize::from(refuses(&shorter));
            }
        }
    }
    assert!(refused.iter().all(|count| *count > 20), "{refused:?}");
}

/// A wheel flank closes against the far flank of a pinion tooth, beside its tip land: `A5`. Both methods knew half teeth only, and turned 45.2 µm too far.
/// Source of 1669.056 µm: intersections of whole polygons by a program of its own.
#[test]
fn a_flank_may_close_against_the_far_flank() {
    // Three teeth on three, tips turned down, the locked pinion 39.5 µm eccentric.
    let gear = |shift, addendum| {
        let gear = spur_of_angle(3, 1.0, 28.0).shift(shift);
        gear.rack(addendum, 1.0, 0.0)
    };
    let pinion = gear(1.0, 1.0).tip_diameter(5.6).runout(0.0395, 2.0);
    let (wheel, pinion) = (gear(0.26, 0.6).front(), pinion.front());
    let pair = GearPair::with_locked(wheel, pinion, 4.0, Member::Pinion).unwrap();
    let mating = at_flank(1, 2, Side::Left, 0.95);
    let pose = Pose::new(&pair, mating);
    let kernel = ExactKernel::new(&pair);
    let exact = kernel.lost_motion(&pose).unwrap();
    let cut = certificates(&pair);
    let polygon = cut.refined_kernel(&pair).lost_motion(&pose).unwrap();
    for found in [&exact, &polygon] {
        near("µm", found.angle().unwrap() * um(&pair), 1669.056, 5e-4);
    }
    let certifier = Certifier::new(cut.kernel(&pair));
    assert!(certifier.check(&pose, &exact).is_ok());
    let contact: Contact = exact.right.unwrap();
    assert_eq!((contact.wheel.tooth, contact.pinion.tooth), (2, 3));
    assert!(contact.pinion.radius < 2.79 && exact.status() == Status::Clear);
    let overlap = |off: f64| clearance::overlap(&pair, &pose, contact.rotation + off);
    assert!(overlap(1e-4) <= 0.0 && overlap(-1e-3) > 1e-4);
    let proof = Prover::new(&pair, &kernel).proof(&pose, &exact).unwrap();
    assert_eq!(proof.verify(&pair, &pose), Ok(()));
    let found = lost_motion_at(&pair.clone().into(), mating).unwrap();
    assert_eq!(found.proof.as_deref(), Some(&proof));
    // The flank that closes is of the far half: without it another pair would.
    let mut open = exact;
    open.right.as_mut().unwrap().rotation -= 1e-4;
    assert!(Prover::new(&pair, &kernel).check(&pose, &open).is_err());
}

/// Each pose of a sweep is proven; polygons check the first of every 64, all with `Checked` and `Both`, none without proof. The proof is kept with `Both`
/// alone. All methods give the same values.
#[test]
fn polygons_check_every_64th_pose() {
    // Undercut teeth.
    let pair = pair(&spur(11, 2.0), &spur(16, 2.0), 27.1);
    let cut = certificates(&pair);
    let plan = SweepPlan::wheel_revolution(&pair, 12, (1, 1));
    let matings = plan.matings(&pair);
    let by = |method| sweep(&pair, &cut, method, &matings, 0.0, &go_on).unwrap();
    let sampled = by(Method::Exact { certify: true });
    for (method, checked, with_proof) in [
        (Method::Exact { certify: true }, &[0, 64, 128][..], false),
        (Method::Exact { certify: false }, &[], false),
        (Method::Checked, &Vec::from_iter(0..132), false),
        (Method::Both, &Vec::from_iter(0..132), true),
    ] {
        let poses = by(method);
        assert_eq!(poses.len(), 132);
        let indices = (0..132).filter(|index| poses[*index].polygon_checked);
        assert_eq!(Vec::from_iter(indices), checked, "{method:?}");
        for (pose, same) in poses.iter().zip(&sampled) {
            assert_eq!(pose.found, same.found);
            assert_eq!(pose.proof.is_some(), with_proof);
            let mut proofs = pose.proof.iter();
            assert!(proofs.all(|proof| proof.verify(&pair, &pose.pose).is_ok()));
        }
    }
}
