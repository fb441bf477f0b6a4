//! Helical pairs against single sections, which are spur pairs, polygons, and model 3. Half of the pairs have two base pitches.

use super::*;
use crate::along_face::{against_sections, evenly, exact, held_back, of_section};
use crate::helical_pairs::{drawn, pair_of_the_prototype, try_drawn};
use crate::random::{self, Random};
use crate::witnesses::{depth, listed};
use crate::{clearance, posed};

/// Any place of a mating of any of the first six teeth.
fn any_pose(pair: &GearPair, rng: &mut Random) -> Pose {
    let fraction = rng.within(0.0, 1.0);
    let teeth = [0; 2].map(|_| rng.one_of(6));
    let mating = at_flank(teeth[0], teeth[1], rng.pick(&Side::BOTH), fraction);
    Pose::new(pair, mating)
}

/// A drawn pair and pose with play or overlap, and both contacts, right first.
fn with_contacts(rng: &mut Random, warm: bool) -> (GearPair, Pose, LostMotion, [Contact; 2]) {
    loop {
        let pair = drawn(rng, warm);
        let pose = any_pose(&pair, rng);
        let lost = ExactKernel::new(&pair).lost_motion(&pose);
        let Some(lost) = lost.ok().filter(|lost| lost.status() != Status::Jammed) else {
            continue;
        };
        if let Some((right, left)) = lost.right.zip(lost.left) {
            return (pair, pose, lost, [right, left]);
        }
    }
}

/// Source: many more single sections than the kernel takes.
#[test]
fn no_section_is_tighter_than_the_face() {
    for (warm, poses) in [(false, 150), (true, 150)] {
        let mut rng = Random(5 + u64::from(warm));
        let mut apart = 0;
        for _ in 0..poses {
            let (pair, pose, lost, [right, left]) = with_contacts(&mut rng, warm);
            assert_eq!(pair.base_pitches_differ(), warm);
            // 1e-8 µm.
            let rounding = 1e-8 / um(&pair);
            let against = against_sections(&pair, &pose, &lost, 100, [rounding; 2]);
            assert!(against.is_empty(), "{pair:?}: {against:#?}");
            apart += u32::from(right.section != left.section);
        }
        assert!(apart > 20, "{apart}");
    }
}

/// Another way, pair by pair and without sections: model 3, which asks of each pair of involutes whether its stretch of line contact meets the
/// face. Where nothing but involutes touches it has the same contacts.
#[test]
fn pairs_of_involutes_have_the_same_contact() {
    for (warm, least) in [(false, 400), (true, 200)] {
        let mut rng = Random(8 + u64::from(warm));
        let (mut compared, mut off_plane) = (0, 0);
        while compared < least {
            let pair = drawn(&mut rng, warm);
            let pose = any_pose(&pair, &mut rng);
            let lost = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
            let model = LineOfAction::new(&pair, &pose);
            for (found, model) in [(lost.right, model.right), (lost.left, model.left)] {
                let Some((found, model)) = found.zip(model) else {
                    continue;
                };
                let smooth = Member::BOTH.into_iter().all(|member| {
                    let (gear, radius) = (pair.gear(member).gear(), found.touch(member).radius);
                    radius > gear.form_radius() + 1e-6 && radius < gear.tip_radius() - 1e-6
                });
                if smooth {
                    compared += 1;
                    off_plane += u32::from(found.section != 0.0);
                    let at = |section| serde_json::json!(Contact { section, ..found });
                    assert!(at(5.0).get("section").is_some() && at(0.0).get("section").is_none());
                    let off = without_turns(found.rotation - model.rotation);
                    near((found, model), off * um(&pair), 0.0, 1e-8);
                }
            }
        }
        assert!(4 * off_plane > 3 * least, "{off_plane}");
    }
}

/// Contradictions about jams: a jammed section of a pose that is not jammed, or a reported one that does not jam.
fn against_jam(pair: &GearPair, pose: &Pose, found: &LostMotion) -> Option<String> {
    // By more than the uncertainty of its overlap.
    let surely_jams = |b: f64| {
        let found = exact(&pair.section(b), &pose.in_section(pair, b));
        let overlap = found.right.zip(found.left);
        let overlap = overlap.map(|(right, left)| right.rotation - left.rotation);
        let bounded = overlap.zip(found.error());
        let is_known = bounded.is_none_or(|(one, bound)| one > bound);
        found.status() == Status::Jammed && is_known
    };
    if found.solid {
        let named = found.right?.section;
        return (!surely_jams(named)).then(|| format!("{named} does not jam"));
    }
    let jam = evenly(pair, 2000).find(|&b| surely_jams(b))?;
    Some(format!("{jam} jams, {found:?}"))
}

/// A pose of the helical campaign: its depth, its seed and its number.
type Posed = (Option<Depth>, u64, u64);

const GRAZING: Option<Depth> = Some(Depth::Grazing);

fn posed((depth, seed, index): Posed) -> (GearPair, Pose, LostMotion) {
    let drawn = Drawn::of(Teeth::Helical, depth, seed, index);
    let pose = Pose::new(&drawn.assembly, drawn.mating);
    let found = ExactKernel::new(&drawn.assembly).lost_motion(&pose);
    (drawn.assembly, pose, found.unwrap())
}

/// Rounding of a difference of angles of some turns.
const TURNS: f64 = 1e-12;

/// Source: single sections, which are spur pairs, and 2001 of them for jams; and brute force.
#[test]
fn contacts_and_jams_between_sections_are_found() {
    type Row = (Option<Depth>, u64, u64, String);
    let poses: Vec<Row> = rows(include_str!("data/between_sections.csv"));
    let against = complaints(&poses, |(depth, seed, index, judge)| {
        let (pair, pose, found) = posed((*depth, *seed, *index));
        let mut against = against_sections(&pair, &pose, &found, 200, [TURNS; 2]);
        if judge == "jams" {
            against.extend(against_jam(&pair, &pose, &found));
            return against;
        }
        for contact in [found.right, found.left].into_iter().flatten() {
            let section = pair.section(contact.section);
            let here = pose.in_section(&pair, contact.section);
            against.extend(clearance::against(&section, &here, &exact(&section, &here)));
        }
        against
    });
    assert!(against.is_empty(), "{against:#?}");
}

/// A tip in the root of the eccentric free gear between the sections. Earlier these pairs had play, or 0.004 to 0.27 rad less overlap than
/// neighbouring sections. Source: the section named, which is jammed by itself.
#[test]
fn a_tip_in_a_root_jams_anywhere_along_the_face() {
    for number in 1..=3 {
        let file = format!("tests/exact/data/tip_in_root_{number}.toml");
        let (pair, mating) = posed::pose(file, Side::Left);
        let pose = Pose::new(&pair, mating);
        let found = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        assert_eq!(found.status(), Status::Jammed, "{number}: {found:?}");
        let sections = [found.right, found.left].map(|contact| contact.unwrap().section);
        assert_eq!(sections[0], sections[1], "{number}");
        let there = of_section(&pair, &pose, sections[0], &exact);
        assert!(there[0].0 > -there[1].0, "{number}: {there:?}");
        for (side, (held, _)) in Side::BOTH.into_iter().zip(there) {
            let own = held_back(&pair, &pose, side, 0.0, &found.on(side).unwrap());
            near(number, own, held, 1e-12);
        }
    }
}

/// Poses from far beyond what anybody makes, tips that barely reach each other among them. Source: single sections.
#[test]
fn no_section_of_wild_pairs_is_tighter_than_the_face() {
    let witnesses = listed("helical").into_iter();
    let witnesses = witnesses.map(|index| (depth(index), 2, index));
    let wild = (0..100u64)
        .map(|index| (GRAZING, 3, index))
        .chain((0..50).map(|index| (None, 4, index)));
    let cases: Vec<Posed> = witnesses.chain(wild).collect();
    let against = complaints(&cases, |&(depth, seed, index)| {
        let drawn = Drawn::of(Teeth::Helical, depth, seed, index);
        let pose = Pose::new(&drawn.assembly, drawn.mating);
        // The effort of a pose ends some of these.
        let found = ExactKernel::new(&drawn.assembly).lost_motion(&pose).ok();
        found.map_or(Vec::new(), |found| {
            against_sections(&drawn.assembly, &pose, &found, 60, [TURNS; 2])
        })
    });
    // Close to practice.
    let pair = try_drawn(&mut Random(65 ^ 0x5ec)).unwrap();
    let mating = random::mating(&mut Random(65 ^ 0x9e1), &pair);
    let pose = Pose::new(&pair, mating);
    let found = exact(&pair, &pose);
    let close = against_sections(&pair, &pose, &found, 60, [TURNS; 2]);
    assert!(against.is_empty(), "{against:#?}");
    assert!(close.is_empty(), "{close:#?}");
}

/// Lost motion, µm at the operating pitch circle, at 108 poses a quarter of a pitch apart.
fn curve(pair: &GearPair, face: [f64; 2]) -> Vec<f64> {
    let pair = pair.clone().with_face(face).unwrap();
    let kernel = ExactKernel::new(&pair);
    let pitches = (0..108).map(|k| f64::from(k) * 0.25);
    let poses = pitches.map(|pitches| Pose::new(&pair, Mating::FIRST.onward(&pair, pitches)));
    let angles = poses.map(|pose| kernel.lost_motion(&pose).unwrap().angle().unwrap());
    angles.map(|angle| angle * um(&pair)).collect()
}

/// The hand turned over with the axis changes nothing; the hand alone only where the face is off the measuring plane.
#[test]
fn the_hand_turned_over_with_the_axis_changes_nothing() {
    let [right, left] = [Hand::Right, Hand::Left]
        .map(|hand| pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], hand, 3));
    let one = curve(&right, [-10.0, 40.0]);
    let worst = |other: Vec<f64>| {
        let off = one.iter().zip(other).map(|(a, b)| (a - b).abs());
        off.fold(0.0, f64::max)
    };
    let over = worst(curve(&left, [-40.0, 10.0]));
    assert!(over < 1e-8, "{over}");
    let alone = worst(curve(&left, [-10.0, 40.0]));
    assert!(alone > 1.0, "{alone}");
}
