//! The exact method against the polygon method, its own search, and brute force. Longer campaigns are `tests/tools/campaign.rs`.

use super::*;
use crate::campaign::{Tally, run, turned};
use crate::random::{self, Random};
use crate::{clearance, posed};
use rayon::prelude::*;

const SEED: u64 = 2;

pub fn cut(pair: &GearPair) -> CutPair {
    let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member));
    CutPair::new(wheel, pinion, 1e-4 * wheel.gear().basic_data().module())
}

/// Contradictions to `found` by polygons and by their certificate.
pub fn against_polygons(pair: &GearPair, pose: &Pose, found: &LostMotion) -> Vec<String> {
    let cut = cut(pair);
    let polygon = cut.refined_kernel(pair).lost_motion(pose).unwrap();
    let certified = Certifier::new(cut.kernel(pair)).check(pose, found);
    let mut against = Vec::from_iter(differ(found, &polygon, 1e-14));
    against.extend(certified.err().map(|error| error.to_string()));
    let statuses = [found, &polygon].map(LostMotion::status);
    if statuses[0] != statuses[1] {
        against.push(format!("{statuses:?}"));
    }
    against
}

/// Faults of both methods and the certificate, and unproven poses.
pub fn by_both_methods(kind: Teeth, depth: Option<Depth>, seed: u64, index: u64) -> Vec<String> {
    complained(run(kind, depth, seed, index..index + 1, true))
}

fn complained(tally: Tally) -> Vec<String> {
    let found = tally.faults.into_iter().chain(tally.unproven);
    found.map(|(_, what)| what).collect()
}

fn sound(tally: &Tally) {
    println!("{}", tally.report());
    assert!(tally.faults.is_empty(), "{:#?}", tally.faults);
}

/// No fault among poses of all depths, and no status or class of contact that was not met.
#[test]
fn both_methods_and_the_certificate_agree_on_random_poses() {
    let tally = run(Teeth::Spur, None, SEED, 0..4_000, true);
    sound(&tally);
    assert_eq!(tally.empty(Teeth::Spur, None), [""; 0]);
    // One contact in 1e5 poses, a grazing one, is given up.
    assert!(tally.unproven.is_empty(), "{:#?}", tally.unproven);
}

/// The same over the faces of helical pairs. Some of them are given up, and none takes more effort than a pose may.
#[test]
fn both_methods_and_the_certificate_agree_on_random_helical_poses() {
    let poses = 400;
    let tally = run(Teeth::Helical, None, SEED, 0..poses, true);
    sound(&tally);
    assert_eq!(tally.empty(Teeth::Helical, None), [""; 0]);
    // One in forty is: faces of dozens of modules on which tips come to roots everywhere.
    let unproven = tally.unproven.len() as u64;
    assert!(25 * unproven <= poses, "{:#?}", tally.unproven);
    let [used, most] = tally.effort;
    assert!(used <= most && most < u64::MAX, "{used} of {most}");
}

/// Poses of campaigns that one method had wrong. Source: polygons of whole teeth.
#[test]
fn poses_that_one_method_had_wrong_hold_by_both() {
    let poses: Vec<(Teeth, u64, u64, String)> = rows(include_str!("data/one_method_wrong.csv"));
    let against = complaints(&poses, |(kind, seed, index, what)| {
        let tally = run(*kind, None, *seed, *index..index + 1, true);
        let mut against = Vec::new();
        if what != "a gap of more than half a turn" {
            against.extend(tally.border.iter().map(|(_, border)| border.clone()));
        }
        if what == "a far flank on a tip land" && !tally.left.is_empty() {
            against.push("left to the polygons".to_owned());
        }
        against.extend(complained(tally));
        against
    });
    assert!(against.is_empty(), "{against:#?}");
}

/// Polygons alone, without an exact result to compare: they looked at no other sections than those that hold the tightest of all pairs of involutes, and
/// left out what edges do between these. Source: the exact method.
#[test]
fn polygons_alone_see_what_touches_between_the_sections() {
    let mut between = 0;
    for index in 0..60 {
        let drawn = Drawn::of(Teeth::Helical, Some(Depth::Grazing), 1, index);
        let assembly = &drawn.assembly;
        let cut = cut(assembly);
        let by = |method| {
            let found = sweep(assembly, &cut, method, &[drawn.mating], 0.0, &go_on);
            found.unwrap().remove(0).found.unwrap()
        };
        let (exact, polygon) = (by(Method::Exact { certify: true }), by(Method::Polygon));
        assert_eq!(exact.status(), polygon.status(), "pose {index}");
        assert_eq!(differ(&exact, &polygon, 0.0), None, "pose {index}");
        let sections = ExactKernel::new(assembly).sections();
        let contacts = [exact.right, exact.left].into_iter().flatten();
        let beside = contacts.filter(|one| !sections.contains(&one.section));
        between += beside.count();
    }
    assert!(between > 5, "{between}");
}

/// Source: clearance of dense points of either gear in the other's own frame, and points of whole gears in each other; nothing of either method.
#[test]
fn the_exact_method_holds_against_brute_force() {
    for (depth, seed, poses) in [(None, SEED, 40), (Some(Depth::Grazing), 5, 30)] {
        let indices: Vec<u64> = (0..poses).collect();
        let against = complaints(&indices, |index| {
            let drawn = Drawn::new(depth, seed, *index);
            let pose = Pose::new(&drawn.assembly, drawn.mating);
            let found = ExactKernel::new(&drawn.assembly).lost_motion(&pose);
            by_brute_force(&drawn.assembly, &pose, &found.unwrap())
        });
        assert!(against.is_empty(), "{against:#?}");
    }
}

/// Contradictions of half teeth and of whole gears to `found`.
pub fn by_brute_force(pair: &GearPair, pose: &Pose, found: &LostMotion) -> Vec<String> {
    let mut against = clearance::against(pair, pose, found);
    if found.status() == Status::Clear {
        against.extend(clearance::overlap_just_inside(pair, pose, found));
    }
    against
}

/// Brute force sees what is wrong: rotations of a contact off by ten bounds either way, and a contact not claimed.
#[test]
fn brute_force_refuses_wrong_rotations() {
    let mut refused = 0;
    for index in 0..5 {
        let drawn = Drawn::new(None, SEED, index);
        let pose = Pose::new(&drawn.assembly, drawn.mating);
        let kernel = ExactKernel::new(&drawn.assembly);
        let found = kernel.lost_motion(&pose).unwrap();
        // A contact known to less than a tenth of this is none to try it on.
        let off = 1e-8;
        let Some(right) = found.right.filter(|right| right.error <= 0.1 * off) else {
            continue;
        };
        for wrong in [Some(off), Some(-off), None] {
            let claimed = wrong.map(|off| turned(right, off));
            let claimed = with_contact(&found, Side::Right, claimed);
            let against = clearance::against(&drawn.assembly, &pose, &claimed);
            let refuses = against.iter().any(|what| what.starts_with("right"));
            assert!(refuses, "pose {index}, {wrong:?}");
            refused += 1;
        }
    }
    assert!(refused > 8, "{refused}");
}

/// The pair file printed for a pose is that pose, to the last bit.
#[test]
fn a_printed_pose_reads_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pose.json");
    for index in 0..400 {
        let kind = [Teeth::Spur, Teeth::Helical][index as usize % 2];
        let drawn = Drawn::of(kind, None, SEED, index);
        std::fs::write(&path, drawn.pair_file()).unwrap();
        let (assembly, mating) = posed::pose(&path, drawn.mating.flank);
        assert_eq!(assembly, drawn.assembly, "pose {index}");
        assert_eq!(mating, drawn.mating);
    }
}

/// Whether a pair is solved without a search, and the status of the pose; `None` if a method leaves it open. Both methods must agree.
fn quick_as_search(pair: &GearPair, pose: &Pose, what: &str) -> Option<(bool, Status)> {
    let kernel = ExactKernel::new(pair);
    let quick = kernel.lost_motion(pose).ok()?;
    let search = kernel.lost_motion_by_search(pose).ok()?;
    let differ = differ(&quick, &search, 1e-14);
    assert!(differ.is_none(), "{what}: {differ:?}");
    for (one, other) in [(quick.right, search.right), (quick.left, search.left)] {
        let Some((one, other)) = one.zip(other).filter(|_| kernel.is_direct()) else {
            continue;
        };
        let names = [one, other]
            .map(|contact| [contact.wheel, contact.pinion].map(|touch| (touch.tooth, touch.curve)));
        // Very near to a curve's end either name is right.
        let apart = (one.wheel.radius - other.wheel.radius).abs() > 1e-6;
        assert!(names[0] == names[1] || !apart, "{what}: {names:?}");
    }
    Some((kernel.is_direct(), quick.status()))
}

const ORDINARY: random::Kind = random::Kind {
    teeth: (12.0, 300.0),
    deviation: 3.0,
    shift: (0.0, 0.2),
};

/// Source: branch and bound over all pairs of curves, without special cases. In most gears the pairs that the quick method omits are clear by a
/// wide margin. A wrong condition shows only in unusual gears; flanks without traces are convex and have the quick method too.
#[test]
fn the_quick_method_finds_what_branch_and_bound_finds() {
    let ordinary = |seed: u64| {
        let mut random = Random(60_000 + seed);
        let pair = random::pair(&mut random, ORDINARY);
        let mating = random::mating(&mut random, &pair);
        Some((pair, mating))
    };
    let wide = |index: u64| {
        let drawn = Drawn::new(None, 1, index);
        Some((drawn.assembly, drawn.mating))
    };
    let deviating = |seed: u64| {
        let mut random = Random(seed ^ 0x5eed_0000);
        let pair = crate::profiles::deviating_pair(&mut random, false)?;
        let mating = random::mating(&mut random, &pair);
        Some((pair, mating))
    };
    type Draw = fn(u64) -> Option<(GearPair, Mating)>;
    // Name and draws; the least numbers of settled poses, of pairs solved without and with a search, and of each status.
    let kinds: [(&str, Draw, u64, [usize; 4]); 3] = [
        ("ordinary", ordinary, 800, [800, 680, 0, 0]),
        // The search cannot settle some lands that touch between their corners.
        ("wide", wide, 5000, [4750, 1001, 501, 101]),
        ("deviating", deviating, 4000, [3001, 0, 0, 101]),
    ];
    for (name, draw, count, [settled, direct, searched, each]) in kinds {
        let met: Vec<(bool, Status)> = (0..count)
            .into_par_iter()
            .filter_map(|index| {
                let (pair, mating) = draw(index)?;
                quick_as_search(&pair, &Pose::new(&pair, mating), &format!("{name} {index}"))
            })
            .collect();
        let quick = met.iter().filter(|met| met.0).count();
        let statuses = [Status::Clear, Status::Interference, Status::Jammed];
        let statuses = statuses.map(|status| met.iter().filter(|met| met.1 == status).count());
        assert!(met.len() >= settled && quick >= direct && met.len() - quick >= searched);
        assert!(statuses.iter().all(|count| *count >= each), "{statuses:?}");
    }
    // A corner outside the tip circle of an eccentric gear meets it slightly later: a mutant that omitted it was off by 3 µrad.
    let drawn = Drawn::new(Some(Depth::Grazing), 7, 49_556);
    let pose = Pose::new(&drawn.assembly, drawn.mating);
    assert!(quick_as_search(&drawn.assembly, &pose, "49 556").is_some());
}

/// Pairs with slope, crowning, relief and traces, and without traces gears that expand by up to 0.8 %. Source: the polygon method and its
/// certificate, which know no base pitch; and for each sixteenth brute force.
#[test]
fn deviating_profiles_agree_by_every_method() {
    for (warm, seeds, least, each) in [(false, 200, 150, 3), (true, 400, 301, 0)] {
        let met: Vec<Status> = (0..seeds)
            .into_par_iter()
            .filter_map(|seed| {
                let mut random = Random(if warm { seed ^ 0x3a7 } else { seed });
                let mut pair = crate::profiles::deviating_pair(&mut random, !warm)?;
                if warm {
                    let factors = [0; 2].map(|_| 1.0 + random.within(-0.008, 0.008));
                    pair = crate::helical_pairs::expanded(&pair, factors)?;
                }
                let pose = Pose::new(&pair, random::mating(&mut random, &pair));
                let exact = ExactKernel::new(&pair).lost_motion(&pose).ok()?;
                let mut against = against_polygons(&pair, &pose, &exact);
                if !warm && seed % 16 == 0 {
                    against.extend(clearance::against(&pair, &pose, &exact));
                }
                assert!(against.is_empty(), "{warm} {seed}: {against:#?}");
                Some(exact.status())
            })
            .collect();
        let statuses = [Status::Clear, Status::Interference, Status::Jammed];
        let found = statuses.map(|status| met.iter().filter(|met| **met == status).count());
        assert!(met.len() >= least, "{}", met.len());
        assert!(found.iter().all(|count| *count >= each), "{found:?}");
    }
}
