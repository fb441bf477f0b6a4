//! Helical pairs against other ways to the same contact: single sections, which are spur pairs, polygons, and model 3.

use super::helical_pairs::{Draws, drawn, drawn_wide};
use gearlash::analytic::LineOfAction;
use gearlash::contact::{Contact, CutPair, ExactKernel, LostMotion, Status, ToothPlace};
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Mating, Member, Pose};
use std::f64::consts::TAU;

/// Tooth 1 of both gears, left flanks.
const LEFT: Mating = Mating {
    flank: Side::Left,
    ..Mating::FIRST
};

/// Any place of a mating of any of the first six teeth.
fn any_mating(rng: &mut Draws, flank: Side) -> Mating {
    Mating {
        wheel_tooth: rng.whole(1..7),
        pinion_tooth: rng.whole(1..7),
        flank,
        fraction: rng.within(0.0..1.0),
    }
}

/// `rotation` of the free gear beyond its nominal one at `pose`, rad, without whole turns.
fn beyond(rotation: f64, pose: &Pose) -> f64 {
    let beyond = rotation - pose.free_rotation();
    beyond - TAU * (beyond / TAU).round()
}

/// Right and left contact of a pose that is neither out of mesh nor jammed.
fn with_play_or_overlap(lost: &LostMotion) -> Option<[Contact; 2]> {
    let both = lost.right.zip(lost.left);
    let both = both.filter(|_| lost.status() != Status::Jammed);
    both.map(|(right, left)| [right, left])
}

/// Right and left contact of `pose` from single sections at `places`, rad beyond the nominal rotation: a loop over spur pairs.
fn by_sections(
    pair: &GearPair,
    pose: &Pose,
    places: impl Iterator<Item = f64>,
) -> Option<[f64; 2]> {
    let mut found = [f64::NEG_INFINITY, f64::INFINITY];
    for b in places {
        let section = pair.section(b);
        let here = pose.in_section(pair, b);
        let lost = ExactKernel::new(&section).lost_motion(&here).ok()?;
        if let Some(right) = lost.right {
            found[0] = found[0].max(beyond(right.rotation, &here));
        }
        if let Some(left) = lost.left {
            found[1] = found[1].min(beyond(left.rotation, &here));
        }
    }
    Some(found)
}

/// Another way: many more single sections than the kernel takes. It must find no less at any, and what it found at one of them.
#[test]
fn no_section_is_tighter_than_the_face() {
    let mut rng = Draws(5);
    let (mut pairs, mut compared, mut between, mut over) = (0, 0, 0, 0);
    while pairs < 100 {
        let Some(pair) = drawn(&mut rng) else {
            continue;
        };
        pairs += 1;
        let kernel = ExactKernel::new(&pair);
        let [from, to] = pair.face();
        let per_um = 1e3 * pair.operating_pitch_radius(pair.free());
        for _ in 0..3 {
            let first = any_mating(&mut rng, Side::Left);
            let pose = Pose::new(&pair, first);
            let Ok(lost) = kernel.lost_motion(&pose) else {
                continue;
            };
            let Some([right, left]) = with_play_or_overlap(&lost) else {
                continue;
            };
            let own = [right, left].map(|contact| beyond(contact.rotation, &pose));
            let places = (0..=160).map(|k| from + (to - from) * f64::from(k) / 160.0);
            let [most, least] = by_sections(&pair, &pose, places).unwrap();
            let tighter = [(most - own[0]) * per_um, (own[1] - least) * per_um];
            for (tighter, contact) in tighter.into_iter().zip([right, left]) {
                compared += 1;
                if tighter > 1e-8 {
                    over += 1;
                    println!("{tighter:e} µm at face {from} {to}: {contact:?}");
                }
                between += u32::from(tighter < -1e-8);
            }
            let [at_right, at_left] = [right.section, left.section];
            let there = by_sections(&pair, &pose, [at_right, at_left].into_iter()).unwrap();
            assert!(
                (there[0] - own[0]).abs() * per_um < 1e-8
                    && (there[1] - own[1]).abs() * per_um < 1e-8
            );
        }
    }
    println!("{compared} compared, {between} found tighter between, {over} over");
    assert!(over == 0 && compared > 130 && between > 0);
}

/// Another way, of pairs from far beyond what anybody makes: the tightest of 49 single sections, and by golden section what is tightest about it.
/// Where tips hardly reach each other that stands between any sections: where edges cross.
#[test]
fn no_section_of_wild_pairs_is_tighter_than_the_face() {
    let mut rng = Draws(1);
    let (mut compared, mut short, mut given_up, mut touched) = (0, 0, 0, [0; 3]);
    for _ in 0..300 {
        let state = rng.0;
        let Some(pair) = drawn_wide(&mut rng) else {
            continue;
        };
        let first = LEFT;
        let pose = Pose::new(&pair, first.onward(&pair, rng.within(0.0..30.0)));
        // The effort of a pose ends some of these.
        let Ok(lost) = ExactKernel::new(&pair).lost_motion(&pose) else {
            given_up += 1;
            continue;
        };
        let Some([right, left]) = with_play_or_overlap(&lost) else {
            continue;
        };
        short += u32::from(lost.angle().unwrap() * pair.operating_pitch_radius(pair.free()) > 1.0);
        let [from, to] = pair.face();
        for (index, contact) in [right, left].into_iter().enumerate() {
            let sense = [1.0, -1.0][index];
            let at = |b: f64| {
                let found = by_sections(&pair, &pose, [b].into_iter());
                found.map_or(f64::NEG_INFINITY, |found| sense * found[index])
            };
            let places = (0..=48).map(|k| from + (to - from) * f64::from(k) / 48.0);
            let each: Vec<(f64, f64)> = places.map(|b| (b, at(b))).collect();
            let top = (0..each.len()).max_by(|&a, &b| each[a].1.total_cmp(&each[b].1));
            let top = top.unwrap();
            let (mut low, mut high) = (
                each[top.saturating_sub(1)].0,
                each[(top + 1).min(each.len() - 1)].0,
            );
            let mut most = each[top].1;
            for _ in 0..40 {
                let [one, other] = [0.381_966, 0.618_034].map(|part| low + (high - low) * part);
                let found = [at(one), at(other)];
                most = most.max(found[0]).max(found[1]);
                if found[0] >= found[1] {
                    high = other
                } else {
                    low = one
                }
            }
            let own = sense * beyond(contact.rotation, &pose);
            // 0.1 nm a metre from the axis: what directions of some ten turns are rounded by.
            assert!(
                most <= own + contact.error + 1e-13,
                "{} rad tighter of the pair drawn from {state}: {contact:?}",
                most - own
            );
            compared += 1;
            let curves = [contact.wheel.curve, contact.pinion.curve];
            let kinds = [ToothPlace::Involute, ToothPlace::Tip, ToothPlace::Fillet];
            for (count, kind) in touched.iter_mut().zip(kinds) {
                *count += u32::from(curves.contains(&kind));
            }
        }
    }
    println!(
        "{compared} contacts, {short} with more than 1 mm of play, involutes, tips, fillets {touched:?}"
    );
    assert!(
        compared > 130 && short > 6 && 20 * given_up < compared,
        "{compared} {short} {given_up}"
    );
    assert!(touched.into_iter().all(|count| count > 3), "{touched:?}");
}

/// Pairs from a longer run of those draws with a tip in the root of the eccentric free gear between the sections. They
/// were found to have play, or 0.004 to 0.27 rad less overlap than neighbouring sections.
#[test]
fn a_tip_in_a_root_jams_anywhere_along_the_face() {
    for state in [
        6_568_607_135_856_689_832,
        10_815_346_586_222_210_270,
        15_388_175_465_193_024_504,
    ] {
        let mut rng = Draws(state);
        let pair = drawn_wide(&mut rng).unwrap();
        let first = LEFT;
        let pose = Pose::new(&pair, first.onward(&pair, rng.within(0.0..30.0)));
        let lost = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        let [from, to] = pair.face();
        let places = (0..=2000).map(|k| from + (to - from) * f64::from(k) / 2000.0);
        let [most, least] = by_sections(&pair, &pose, places).unwrap();
        // Named is what touches in one section that is jammed by itself.
        let [right, left] = [lost.right.unwrap(), lost.left.unwrap()];
        assert_eq!(right.section, left.section, "{state}");
        let [own, other] = by_sections(&pair, &pose, std::iter::once(right.section)).unwrap();
        let named = [right, left].map(|contact| beyond(contact.rotation, &pose));
        assert!(
            own > other && (named[0] - own).abs() < 1e-12 && (named[1] - other).abs() < 1e-12,
            "{state}: {own} {other} {named:?}"
        );
        assert!(
            most > least && lost.status() == Status::Jammed,
            "{state}: {most} {least} {lost:?}"
        );
    }
}

/// Between involutes the sections that hold the tightest of all pairs are complete: of four times as many none is tighter. Between a tip and a
/// fillet sections alone miss some, and four times as many less.
#[test]
fn four_times_as_many_sections_find_the_same_between_involutes() {
    let mut rng = Draws(11);
    let (mut pairs, mut several, mut on_fillets) = (0, 0, 0);
    while pairs < 500 {
        let Some(pair) = drawn(&mut rng) else {
            continue;
        };
        let places = ExactKernel::new(&pair).sections();
        let first = any_mating(&mut rng, Side::Right);
        let pose = Pose::new(&pair, first);
        let lost = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        let Some([right, left]) = with_play_or_overlap(&lost) else {
            continue;
        };
        let per_um = 1e3 * pair.operating_pitch_radius(pair.free());
        let [from, to] = pair.face();
        let count = 4 * places.len();
        let finer = (0..=count).map(|k| from + (to - from) * k as f64 / count as f64);
        let more = by_sections(&pair, &pose, places.iter().copied().chain(finer)).unwrap();
        several += u32::from(places.len() > 2);
        let few = by_sections(&pair, &pose, places.into_iter()).unwrap();
        for (k, contact) in [right, left].into_iter().enumerate() {
            let missed = (more[k] - few[k]).abs() * per_um;
            let touched = [contact.wheel.curve, contact.pinion.curve];
            if touched.contains(&ToothPlace::Fillet) {
                on_fillets += u32::from(missed > 1e-8);
            } else {
                assert!(missed <= 1e-8, "{missed} µm: {contact:?}");
            }
        }
        pairs += 1;
    }
    assert!(several > 100 && on_fillets > 0, "{several} {on_fillets}");
}

/// Another method: polygons cut finer round each contact, in 33 sections and in those that touch. And a certificate, section by section.
#[test]
fn polygons_in_33_sections_agree() {
    let mut rng = Draws(6);
    let (mut compared, mut fillets) = (0, 0);
    while compared < 300 {
        let Some(pair) = drawn(&mut rng) else {
            continue;
        };
        let kernel = ExactKernel::new(&pair);
        let mating = any_mating(&mut rng, Side::Right);
        let pose = Pose::new(&pair, mating);
        let lost = kernel.lost_motion(&pose).unwrap();
        let Some([right, left]) = with_play_or_overlap(&lost) else {
            continue;
        };
        compared += 1;
        let touched = [right, left].map(|contact| [contact.wheel.curve, contact.pinion.curve]);
        fillets += u32::from(touched.as_flattened().contains(&ToothPlace::Fillet));
        let certified = pair.lost_motion(mating).unwrap();
        assert_eq!(certified.found, Ok(lost), "{:?}", pair.face());
        let cut = CutPair::new(pair.gear(Member::Wheel), pair.gear(Member::Pinion), 2e-4);
        let [from, to] = pair.face();
        let slices = (0..33).map(|k| from + (to - from) * f64::from(k) / 32.0);
        let (mut most, mut least) = ((f64::NEG_INFINITY, 0.0), (f64::INFINITY, 0.0));
        for b in slices.chain([right.section, left.section]) {
            let section = pair.section(b);
            let here = pose.in_section(&pair, b);
            let found = cut.refined_kernel(&section).lost_motion(&here).unwrap();
            let [one, other] = [found.right, found.left].map(|contact| {
                contact.map(|contact| (beyond(contact.rotation, &here), contact.error))
            });
            most = one.filter(|one| one.0 > most.0).unwrap_or(most);
            least = other.filter(|other| other.0 < least.0).unwrap_or(least);
        }
        for (own, (polygons, error)) in [(right, most), (left, least)] {
            let off = (beyond(own.rotation, &pose) - polygons).abs();
            assert!(off <= error + own.error, "{off} of {error}: {own:?}");
        }
    }
    assert!(fillets > 0, "{fillets}");
}

/// Another way, pair by pair and without sections: model 3, which asks of each pair of involutes whether its stretch of line contact meets the
/// face. Where nothing but involutes touches it has the same contacts.
#[test]
fn pairs_of_involutes_have_the_same_contact() {
    let mut rng = Draws(8);
    let (mut compared, mut off_plane) = (0, 0);
    while compared < 400 {
        let Some(pair) = drawn(&mut rng) else {
            continue;
        };
        let kernel = ExactKernel::new(&pair);
        let radius = 1e3 * pair.operating_pitch_radius(pair.free());
        for _ in 0..3 {
            let mating = any_mating(&mut rng, Side::Right);
            let pose = Pose::new(&pair, mating);
            let lost = kernel.lost_motion(&pose).unwrap();
            let model = LineOfAction::new(&pair, &pose);
            for (found, model) in [(lost.right, model.right), (lost.left, model.left)] {
                let (Some(found), Some(model)) = (found, model) else {
                    continue;
                };
                let smooth = [found.wheel, found.pinion]
                    .into_iter()
                    .zip([Member::Wheel, Member::Pinion])
                    .all(|(touch, member)| {
                        let gear = pair.gear(member).gear();
                        touch.radius > gear.form_radius() + 1e-6
                            && touch.radius < gear.tip_radius() - 1e-6
                    });
                let off = found.rotation - model.rotation;
                let off = (off - TAU * (off / TAU).round()).abs() * radius;
                if smooth {
                    compared += 1;
                    off_plane += u32::from(found.section != 0.0);
                    assert!(off < 1e-8, "{off} µm: {found:?}, {model:?}");
                }
            }
        }
    }
    assert!(off_plane > 300, "{off_plane}");
}
