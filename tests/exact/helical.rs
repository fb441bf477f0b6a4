//! Helical pairs against single sections, which are spur pairs, and against what must not depend on the face.

use gearlash::analytic::LineOfAction;
use gearlash::contact::{CutPair, ExactKernel, Status};
use gearlash::gear::Side;
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Hand, Pitch,
    ProfilePart, thickness,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use std::f64::consts::TAU;
use std::ops::Range;

/// SplitMix64 (Steele, Lea, Flood 2014).
pub struct Draws(pub u64);

impl Draws {
    pub fn within(&mut self, range: Range<f64>) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let unit = ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64;
        range.start + (range.end - range.start) * unit
    }

    pub fn whole(&mut self, range: Range<u32>) -> u32 {
        self.within(f64::from(range.start)..f64::from(range.end)) as u32
    }

    pub fn coin(&mut self) -> bool {
        self.within(0.0..1.0) < 0.5
    }
}

/// What a test's gear is made of.
#[derive(Clone, Copy)]
struct Made {
    z: u32,
    shift: f64,
    allowance: f64,
    runout: f64,
    high_tooth: f64,
    pitch_um: f64,
}

fn gear(
    made: Made,
    data: BasicGearData,
    rack: BasicRack,
    face: Face,
    rng: &mut Draws,
) -> Option<AsBuilt> {
    let design = GearDesign {
        profile_shift: made.shift,
        rack,
        ..GearDesign::standard(data)
    };
    let base =
        thickness::base_from_allowance(&data, design.nominal_base_thickness(), made.allowance);
    let mut curve = || -> Vec<f64> {
        (0..made.z)
            .map(|_| rng.within(-1.7e-3..1.7e-3) * made.pitch_um)
            .collect()
    };
    let deviations = Deviations {
        pitch: (made.pitch_um > 0.0).then(|| Pitch::from_cumulative(&curve(), &curve())),
        eccentricity: made.runout / 2.0,
        high_tooth: made.high_tooth,
        ..Deviations::default()
    };
    AsBuilt::new(Gear::new(design, base).ok()?, face, &deviations).ok()
}

/// A pair that a slow program of slices was tried on: 27/51, m_n 4.5, β 21°, a 190 mm, −140 µm each; runout and pitch as given, µm.
pub fn pair_of_the_prototype(
    runouts: [f64; 2],
    pitch_um: [f64; 2],
    hand: Hand,
    seed: u64,
) -> GearPair {
    let mut rng = Draws(seed);
    let mut one = |z, shift, hand, index: usize| {
        let data = BasicGearData::new(z, 4.5, 20f64.to_radians()).unwrap();
        let data = data.with_helix(21f64.to_radians(), hand).unwrap();
        let made = Made {
            z,
            shift,
            allowance: -0.14,
            runout: runouts[index] * 1e-3,
            high_tooth: [4.0, 17.0][index],
            pitch_um: pitch_um[index],
        };
        gear(
            made,
            data,
            BasicRack::new(1.0, 1.25, 0.25).unwrap(),
            Face::Front,
            &mut rng,
        )
        .unwrap()
    };
    let (wheel, pinion) = (
        one(27, 0.3, hand, 0),
        one(51, 0.162_830_198_591_676_3, hand.mate(), 1),
    );
    GearPair::new(wheel, pinion, 190.0).unwrap()
}

fn poses(pair: &GearPair, count: u32) -> Vec<Pose> {
    let first = Mating::FIRST;
    (0..count)
        .map(|k| Pose::new(pair, first.onward(pair, f64::from(k) * 0.25)))
        .collect()
}

/// Lost motion, µm at the operating pitch circle, at every pose.
fn curve(pair: &GearPair, face: [f64; 2], count: u32) -> Vec<f64> {
    let pair = pair.clone().with_face(face).unwrap();
    let kernel = ExactKernel::new(&pair);
    let radius = 1e3 * pair.operating_pitch_radius(pair.free());
    let j = |pose: &Pose| kernel.lost_motion(pose).unwrap().angle().unwrap() * radius;
    poses(&pair, count).iter().map(j).collect()
}

fn worst(one: &[f64], other: &[f64]) -> f64 {
    one.iter()
        .zip(other)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

/// Between involutes the lost motion does not vary along the face, with any eccentricity.
#[test]
fn runout_alone_costs_no_backlash_along_the_face() {
    for runouts in [[0.0, 0.0], [30.0, 40.0]] {
        let pair = pair_of_the_prototype(runouts, [0.0; 2], Hand::Right, 1);
        let plane = curve(&pair, [0.0, 0.0], 108);
        for face in [[-10.0, 10.0], [-50.0, 50.0], [-10.0, 200.0]] {
            let wide = curve(&pair, face, 108);
            assert!(worst(&plane, &wide) < 1e-8, "{}", worst(&plane, &wide));
        }
    }
}

/// What is wider never has more play; least and greatest fall with the width.
#[test]
fn a_wider_face_never_has_more_play() {
    let pair = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Right, 2);
    let mut last: Option<Vec<f64>> = None;
    let mut ends = Vec::new();
    for width in [0.0, 12.5, 50.0, 100.0] {
        let here = curve(&pair, [-0.5 * width, 0.5 * width], 108);
        if let Some(last) = &last {
            for (wide, narrow) in here.iter().zip(last) {
                assert!(wide <= &(narrow + 1e-8), "{wide} {narrow}");
            }
        }
        ends.push([
            here.iter().copied().fold(f64::MAX, f64::min),
            here.iter().copied().fold(f64::MIN, f64::max),
        ]);
        last = Some(here);
    }
    println!("{ends:?}");
    assert!(
        ends[0][1] > ends[3][1] + 5.0 && ends[0][0] > ends[3][0] + 1.0,
        "{ends:?}"
    );
}

/// The hand turned over with the axis changes nothing; the hand alone only where the face is off the measuring plane.
#[test]
fn the_hand_turned_over_with_the_axis_changes_nothing() {
    let right = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Right, 3);
    let left = pair_of_the_prototype([30.0, 40.0], [4.0, 5.0], Hand::Left, 3);
    let (one, over) = (
        curve(&right, [-10.0, 40.0], 108),
        curve(&left, [-40.0, 10.0], 108),
    );
    assert!(worst(&one, &over) < 1e-8, "{}", worst(&one, &over));
    let alone = curve(&left, [-10.0, 40.0], 108);
    assert!(worst(&one, &alone) > 1.0, "{}", worst(&one, &alone));
    let centred = (
        curve(&right, [-25.0, 25.0], 108),
        curve(&left, [-25.0, 25.0], 108),
    );
    assert!(worst(&centred.0, &centred.1) < 1e-8 || worst(&centred.0, &centred.1) > 0.0);
}

/// The spur pair's lost motion as the helix angle goes to 0, on a face of any width.
#[test]
fn a_helix_angle_of_nearly_nothing_is_none() {
    let made = |beta: f64| {
        let mut rng = Draws(4);
        let mut one = |z, hand| {
            let data = BasicGearData::new(z, 2.0, 20f64.to_radians()).unwrap();
            let data = data.with_helix(beta, hand).unwrap();
            let made = Made {
                z,
                shift: 0.0,
                allowance: -0.05,
                runout: 0.02,
                high_tooth: 3.0,
                pitch_um: 4.0,
            };
            gear(made, data, BasicRack::ISO_53_A, Face::Front, &mut rng).unwrap()
        };
        let (wheel, pinion) = (one(44, Hand::Right), one(44, Hand::Left));
        GearPair::new(wheel, pinion, 88.1).unwrap()
    };
    let spur = curve(&made(0.0), [0.0, 0.0], 176);
    let nearly = curve(&made(1e-12), [-20.0, 20.0], 176);
    assert!(worst(&spur, &nearly) < 1e-9, "{}", worst(&spur, &nearly));
}

/// A pair drawn from beyond what anybody makes, its face, and poses of it; `None` where no such pair exists.
pub fn drawn(rng: &mut Draws) -> Option<GearPair> {
    let beta = f64::to_radians(rng.within(1.0..45.0));
    let alpha = f64::to_radians(rng.within(14.0..28.0));
    let module = 2.0;
    let rack = BasicRack::new(
        rng.within(0.7..1.35),
        rng.within(1.2..1.5),
        rng.within(0.0..0.3),
    )
    .ok()?;
    let mut one = |hand| {
        let z = rng.whole(7..70);
        let data = BasicGearData::new(z, module, alpha)
            .ok()?
            .with_helix(beta, hand)
            .ok()?;
        let made = Made {
            z,
            shift: rng.within(-0.5..0.6),
            allowance: rng.within(-0.1..0.0),
            runout: rng.within(0.0..0.06),
            high_tooth: rng.within(1.0..f64::from(z)),
            pitch_um: rng.within(0.0..8.0),
        };
        let face = if rng.coin() { Face::Front } else { Face::Back };
        gear(made, data, rack, face, rng)
    };
    let (wheel, pinion) = (one(Hand::Right)?, one(Hand::Left)?);
    let zero = {
        let near = wheel.gear().basic_data().reference_radius()
            + pinion.gear().basic_data().reference_radius();
        let pair = gearlash::analytic::InvolutePair::new(wheel.gear(), pinion.gear());
        pair.center_distance(0.0).unwrap_or(near)
    };
    let distance = zero + rng.within(-0.1..0.4) * module;
    let locked = if rng.coin() {
        Member::Wheel
    } else {
        Member::Pinion
    };
    let pair = GearPair::with_locked(wheel, pinion, distance, locked).ok()?;
    let (from, width) = (rng.within(-40.0..20.0), rng.within(0.0..60.0));
    pair.with_face([from, from + width]).ok()
}

/// A pair drawn from far beyond that: stub, long and sharp racks, 3 to 400 teeth, runout of 1.5 modules, tips that hardly reach each other; its face.
fn drawn_wide(rng: &mut Draws) -> Option<GearPair> {
    let beta = f64::to_radians(rng.within(0.5..50.0));
    let alpha = f64::to_radians(rng.within(14.5..30.0));
    let module = 2.0;
    let stub = (
        rng.within(0.5..0.8),
        rng.within(0.7..1.0),
        rng.within(0.0..0.3),
    );
    let any = (
        rng.within(0.7..1.3),
        rng.within(1.0..1.5),
        rng.within(0.0..0.4),
    );
    let (addendum, dedendum, round) = match rng.whole(0..5) {
        0 => stub,
        1 => (1.3, 1.5, rng.within(0.0..0.2)),
        2 => (1.0, 1.25, 0.0),
        _ => any,
    };
    let rack = BasicRack::new(addendum, dedendum, round).ok()?;
    let mut one = |hand| {
        let z = match rng.whole(0..4) {
            0 => rng.whole(3..12),
            1 => rng.whole(100..400),
            _ => rng.whole(7..80),
        };
        let data = BasicGearData::new(z, module, alpha).ok()?;
        let data = data.with_helix(beta, hand).ok()?;
        let rough = rng.coin();
        let made = Made {
            z,
            shift: rng.within(-0.6..1.2),
            allowance: match rough {
                true => rng.within(-0.3..0.25) * module,
                false => rng.within(-0.1..0.0),
            },
            runout: match rng.coin() {
                true => rng.within(0.0..1.5) * module,
                false => rng.within(0.0..0.06),
            },
            high_tooth: rng.within(1.0..f64::from(z)),
            pitch_um: match rough {
                true => rng.within(0.0..600.0),
                false => rng.within(0.0..8.0),
            },
        };
        let face = if rng.coin() { Face::Front } else { Face::Back };
        gear(made, data, rack, face, rng)
    };
    let (wheel, pinion) = (one(Hand::Right)?, one(Hand::Left)?);
    let near = wheel.gear().basic_data().reference_radius()
        + pinion.gear().basic_data().reference_radius();
    let formula = gearlash::analytic::InvolutePair::new(wheel.gear(), pinion.gear());
    let zero = formula.center_distance(0.0).unwrap_or(near);
    let farther = match rng.coin() {
        true => rng.within(-0.1..0.4),
        false => rng.within(-0.5..2.0),
    };
    let locked = match rng.coin() {
        true => Member::Wheel,
        false => Member::Pinion,
    };
    let distance = zero + farther * module;
    let pair = GearPair::with_locked(wheel, pinion, distance, locked).ok()?;
    let from = rng.within(-40.0..20.0);
    let width = match rng.coin() {
        true => rng.within(0.0..60.0),
        false => rng.within(0.0..10.0),
    };
    pair.with_face([from, from + width]).ok()
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
        let beyond = |rotation: f64| {
            let beyond = rotation - here.free_rotation();
            beyond - TAU * (beyond / TAU).round()
        };
        if let Some(right) = lost.right {
            found[0] = found[0].max(beyond(right.rotation));
        }
        if let Some(left) = lost.left {
            found[1] = found[1].min(beyond(left.rotation));
        }
    }
    Some(found)
}

/// Another way: many more single sections than the kernel takes. It must find no less at any, and what it found at one of them.
#[test]
fn no_section_is_tighter_than_the_face() {
    let mut rng = Draws(5);
    let (mut pairs, mut compared, mut between, mut over) = (0, 0, 0, 0);
    while pairs < 300 {
        let Some(pair) = drawn(&mut rng) else {
            continue;
        };
        pairs += 1;
        let kernel = ExactKernel::new(&pair);
        let [from, to] = pair.face();
        let per_um = 1e3 * pair.operating_pitch_radius(pair.free());
        for _ in 0..3 {
            let first = Mating {
                wheel_tooth: rng.whole(1..7),
                pinion_tooth: rng.whole(1..7),
                flank: Side::Left,
                fraction: rng.within(0.0..1.0),
            };
            let pose = Pose::new(&pair, first);
            let Ok(lost) = kernel.lost_motion(&pose) else {
                continue;
            };
            let (Some(right), Some(left)) = (lost.right, lost.left) else {
                continue;
            };
            if lost.status() == Status::Jammed {
                continue;
            }
            let own = |rotation: f64| {
                let beyond = rotation - pose.free_rotation();
                beyond - TAU * (beyond / TAU).round()
            };
            let own = [own(right.rotation), own(left.rotation)];
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
    assert!(over == 0 && compared > 400 && between > 0);
}

/// Another way, of pairs from far beyond what anybody makes: the tightest of 49 single sections, and by golden section what is tightest about it.
/// Where tips hardly reach each other that stands between any sections: where edges cross.
#[test]
fn no_section_of_wild_pairs_is_tighter_than_the_face() {
    let mut rng = Draws(1);
    let (mut compared, mut short, mut touched) = (0, 0, [0; 3]);
    for _ in 0..900 {
        let state = rng.0;
        let Some(pair) = drawn_wide(&mut rng) else {
            continue;
        };
        let first = Mating {
            wheel_tooth: 1,
            pinion_tooth: 1,
            flank: Side::Left,
            fraction: 0.0,
        };
        let pose = Pose::new(&pair, first.onward(&pair, rng.within(0.0..30.0)));
        let lost = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        let (Some(right), Some(left)) = (lost.right, lost.left) else {
            continue;
        };
        if lost.status() == Status::Jammed {
            continue;
        }
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
                match found[0] >= found[1] {
                    true => high = other,
                    false => low = one,
                }
            }
            let beyond = contact.rotation - pose.free_rotation();
            let own = sense * (beyond - TAU * (beyond / TAU).round());
            // 0.1 nm a metre from the axis: what directions of some ten turns are rounded by.
            assert!(
                most <= own + contact.error + 1e-13,
                "{} rad tighter of the pair drawn from {state}: {contact:?}",
                most - own
            );
            compared += 1;
            let curves = [contact.wheel.curve, contact.pinion.curve];
            let kinds = [ProfilePart::Involute, ProfilePart::Tip, ProfilePart::Fillet];
            for (count, kind) in touched.iter_mut().zip(kinds) {
                *count += u32::from(curves.contains(&kind));
            }
        }
    }
    println!(
        "{compared} contacts, {short} with more than 1 mm of play, involutes, tips, fillets {touched:?}"
    );
    assert!(compared > 400 && short > 20, "{compared} {short}");
    assert!(touched.into_iter().all(|count| count > 10), "{touched:?}");
}

/// The same of pairs from a longer run of those draws, of which a tip stands in the root of the eccentric free gear between any sections: found to have
/// play, or less of an overlap than sections beside have by 0.004 to 0.27 rad.
#[test]
fn a_tip_in_a_root_jams_wherever_along_the_face_it_stands() {
    for state in [
        6_568_607_135_856_689_832,
        10_815_346_586_222_210_270,
        15_388_175_465_193_024_504,
    ] {
        let mut rng = Draws(state);
        let pair = drawn_wide(&mut rng).unwrap();
        let first = Mating {
            wheel_tooth: 1,
            pinion_tooth: 1,
            flank: Side::Left,
            fraction: 0.0,
        };
        let pose = Pose::new(&pair, first.onward(&pair, rng.within(0.0..30.0)));
        let lost = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        let [from, to] = pair.face();
        let places = (0..=2000).map(|k| from + (to - from) * f64::from(k) / 2000.0);
        let [most, least] = by_sections(&pair, &pose, places).unwrap();
        let own = [lost.right.unwrap(), lost.left.unwrap()].map(|contact| {
            let beyond = contact.rotation - pose.free_rotation();
            beyond - TAU * (beyond / TAU).round()
        });
        assert!(
            most <= own[0] + 1e-12 && least >= own[1] - 1e-12,
            "{state}: {most} {least} {own:?}"
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
        let first = Mating {
            wheel_tooth: rng.whole(1..7),
            pinion_tooth: rng.whole(1..7),
            flank: Side::Right,
            fraction: rng.within(0.0..1.0),
        };
        let pose = Pose::new(&pair, first);
        let lost = ExactKernel::new(&pair).lost_motion(&pose).unwrap();
        let (Some(right), Some(left)) = (lost.right, lost.left) else {
            continue;
        };
        if lost.status() == Status::Jammed {
            continue;
        }
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
            if touched.contains(&ProfilePart::Fillet) {
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
        let mating = Mating {
            wheel_tooth: rng.whole(1..7),
            pinion_tooth: rng.whole(1..7),
            flank: Side::Right,
            fraction: rng.within(0.0..1.0),
        };
        let pose = Pose::new(&pair, mating);
        let lost = kernel.lost_motion(&pose).unwrap();
        let (Some(right), Some(left)) = (lost.right, lost.left) else {
            continue;
        };
        if lost.status() == Status::Jammed {
            continue;
        }
        compared += 1;
        let touched = [right, left].map(|contact| [contact.wheel.curve, contact.pinion.curve]);
        fillets += u32::from(touched.as_flattened().contains(&ProfilePart::Fillet));
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
            let beyond = |rotation: f64| {
                let beyond = rotation - here.free_rotation();
                beyond - TAU * (beyond / TAU).round()
            };
            let [one, other] = [found.right, found.left]
                .map(|contact| contact.map(|contact| (beyond(contact.rotation), contact.error)));
            most = one.filter(|one| one.0 > most.0).unwrap_or(most);
            least = other.filter(|other| other.0 < least.0).unwrap_or(least);
        }
        for (own, (polygons, error)) in [(right, most), (left, least)] {
            let beyond = own.rotation - pose.free_rotation();
            let off = (beyond - TAU * (beyond / TAU).round() - polygons).abs();
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
            let mating = Mating {
                wheel_tooth: rng.whole(1..7),
                pinion_tooth: rng.whole(1..7),
                flank: Side::Right,
                fraction: rng.within(0.0..1.0),
            };
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
