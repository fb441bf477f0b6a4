//! Random pairs that deviate along the face, and the dense transverse sections that witness their poses.

#![allow(dead_code)] // each test binary uses its part

#[allow(clippy::duplicate_mod)] // the campaign of plane sections has it, too
#[path = "campaign/random.rs"]
mod random;

use gearlash::contact::{ExactKernel, LostMotion};
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, EndRelief, Face, Gear, GearDesign, Hand, Lead,
    Modification, Pitch, Relief, Side, Trace, thickness,
};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use random::Random;
use std::f64::consts::TAU;

/// Points of a measured lead.
const TRACE_POINTS: u32 = 33;

/// Resolution of the place of a contact, µm: 1e-5 mm along a lead that rises by 2 µm per mm.
const RESOLVED: f64 = 2e-5;

/// Lengths of the highest places that are refined, as a part of the distance of dense sections.
const REFINED: f64 = 1e-6;

/// Pose `index` of `seed`, each of a pair of its own, with a helix angle of 0 to 35°. Leads, pitch, eccentricity, wobble and leaning shafts are up
/// to some 30 µm over the face.
pub fn drawn(seed: u64, index: u64) -> (GearPair, Pose) {
    first(seed, index, false)
}

/// As [`drawn`], with profile deviations of up to some 20 µm on most flanks and with parallel axes.
pub fn drawn_with_profiles(seed: u64, index: u64) -> (GearPair, Pose) {
    first(seed, index, true)
}

fn first(seed: u64, index: u64, profiles: bool) -> (GearPair, Pose) {
    let mut random = Random::of(seed, index);
    loop {
        if let Some(drawn) = one(&mut random, profiles) {
            return drawn;
        }
    }
}

fn one(random: &mut Random, profiles: bool) -> Option<(GearPair, Pose)> {
    let module = random.decades(1.0, 6.0);
    let helix = if random.chance(0.25) {
        0.0
    } else {
        random.within(0.5, 35.0).to_radians()
    };
    let hand = random.pick(&[Hand::Right, Hand::Left]);
    let width = random.within(3.0, 16.0) * module;
    let from = -width * random.within(0.05, 0.95);
    let mut faces = [[from, from + width]; 2];
    if random.chance(0.5) {
        // One gear is wider.
        let wider = random.one_of(2) as usize - 1;
        faces[wider][0] -= random.within(0.0, module);
        faces[wider][1] += random.within(0.0, module);
    }
    let kinds = Kinds {
        traces: random.pick(&[0, 0, 1, 2]),
        leads: random.chance(if profiles { 0.4 } else { 0.8 }),
        wobble: random.chance(0.4) && !profiles,
        profiles,
    };
    let shafts = random.chance(0.4) && !profiles;
    let data = [hand, hand.mate()].map(|hand| {
        let teeth = random.decades(17.0, 90.0) as u32;
        let data = BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap();
        if helix == 0.0 {
            data
        } else {
            data.with_helix(helix, hand).unwrap()
        }
    });
    let wheel = gear(random, data[0], faces[0], &kinds)?;
    let pinion = gear(random, data[1], faces[1], &kinds)?;
    let tight = gearlash::analytic::InvolutePair::new(wheel.gear(), pinion.gear());
    let distance = tight.center_distance(0.0)? + random.within(0.02, 0.2) * module;
    let locked = random.pick(&Member::BOTH);
    let pair = GearPair::with_locked(wheel, pinion, distance, locked).ok()?;
    let lean = if shafts {
        [0, 1].map(|_| random.pick(&[0.0, 1.0]) * random.within(-6e-4, 6e-4))
    } else {
        [0.0; 2]
    };
    let pair = pair.with_faces(faces).ok()?.with_lean(lean).ok()?;
    if !pair.binds_anywhere() {
        return None;
    }
    let [wheel_tooth, pinion_tooth] = Member::BOTH.map(|member| random.one_of(pair.teeth(member)));
    let mating = Mating {
        fraction: random.within(0.0, 1.0),
        ..Mating::at(wheel_tooth, pinion_tooth, random.pick(&Side::BOTH))
    };
    let pose = Pose::new(&pair, mating);
    Some((pair, pose))
}

/// Deviations of both gears of a pair.
struct Kinds {
    /// 0: no traces, 1: one for all teeth, 2: one for each flank.
    traces: u32,
    leads: bool,
    wobble: bool,
    profiles: bool,
}

fn gear(
    random: &mut Random,
    data: BasicGearData,
    face: [f64; 2],
    kinds: &Kinds,
) -> Option<AsBuilt> {
    let teeth = data.teeth();
    let design = GearDesign {
        basic_data: data,
        profile_shift: random.within(0.0, 0.5),
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    };
    let allowance = -random.within(0.02, 0.06) * data.module();
    let base = thickness::base_from_allowance(&data, design.nominal_base_thickness(), allowance);
    let seen = random.pick(&[Face::Front, Face::Back]);
    // Heights count from the reference face inwards.
    let own = match seen {
        Face::Front => face,
        Face::Back => [-face[1], -face[0]],
    };
    let um = 1e-3;
    let mut pitch = || -> Vec<f64> {
        let all = (0..teeth).map(|_| um * random.within(-8.0, 8.0));
        all.collect()
    };
    let [right, left] = [pitch(), pitch()];
    let leads = [0, 1].map(|_| lead(random, teeth, own, kinds));
    let mut high = || random.within(1.0, f64::from(teeth) + 1.0);
    let (high_tooth, wobble_tooth) = (high(), high());
    let gear = Gear::new(design, base).ok()?;
    let profiles = [0, 1].map(|_| {
        let is_drawn = kinds.profiles && random.chance(0.8);
        if is_drawn {
            profile(random, &gear)
        } else {
            Modification::default()
        }
    });
    let deviations = Deviations {
        profiles,
        pitch: random
            .chance(0.7)
            .then(|| Pitch::from_cumulative(&right, &left)),
        eccentricity: random.pick(&[0.0, 1.0]) * um * random.within(0.0, 30.0),
        high_tooth,
        wobble: if kinds.wobble {
            random.within(0.0, 5e-4)
        } else {
            0.0
        },
        wobble_tooth,
        leads,
        ..Deviations::default()
    };
    AsBuilt::new(gear, seen, &deviations).ok()
}

/// Slope, crowning, reliefs and traces of one side of a gear.
fn profile(random: &mut Random, gear: &Gear) -> Modification {
    let um = 1e-3;
    let [form, tip] = [gear.form_roll(), gear.tip_roll()];
    let at = |share: f64| form + (tip - form) * share;
    let radius = |roll: f64| gear.base_radius() * roll.hypot(1.0);
    let some = |random: &mut Random, least: f64, most: f64| {
        random.pick(&[0.0, 1.0]) * um * random.within(least, most)
    };
    let relief = |random: &mut Random, from: f64| {
        random.chance(0.4).then(|| Relief {
            amount: um * random.within(0.0, 20.0),
            from: radius(at(from + random.within(-0.2, 0.2))),
            parabolic: random.chance(0.5),
        })
    };
    let mut modification = Modification {
        slope: some(random, -12.0, 12.0),
        crowning: some(random, -4.0, 10.0),
        tip_relief: relief(random, 0.7),
        root_relief: relief(random, 0.25),
        ..Modification::default()
    };
    let own = match random.one_of(4) {
        1 => vec![None],
        2 => (1..=gear.basic_data().teeth()).map(Some).collect(),
        _ => Vec::new(),
    };
    let (wave, noise) = (random.within(0.0, 3.0), random.pick(&[0.0, 0.2, 1.0]));
    let trace = |tooth: Option<u32>| {
        let (phase, turns) = (random.within(0.0, TAU), random.within(0.5, 3.0));
        let point = |k: u32| {
            let part = f64::from(k) / f64::from(TRACE_POINTS - 1);
            let form = wave * (phase + TAU * turns * part).sin() + noise * random.within(-1.0, 1.0);
            (at(part).max(1e-6 * f64::from(k)), um * form)
        };
        let points = (0..TRACE_POINTS).map(point).collect();
        Trace { tooth, points }
    };
    modification.traces = own.into_iter().map(trace).collect();
    modification
}

fn lead(random: &mut Random, teeth: u32, face: [f64; 2], kinds: &Kinds) -> Lead {
    let um = 1e-3;
    let width = face[1] - face[0];
    let mut some =
        |least: f64, most: f64| random.pick(&[0.0, 1.0]) * um * random.within(least, most);
    let mut lead = Lead {
        face,
        range: [face[0] + 0.05 * width, face[1] - 0.05 * width],
        zero: 0.0,
        ..Lead::default()
    };
    if kinds.leads {
        lead.slope = some(-30.0, 30.0);
        lead.crowning = some(-4.0, 20.0);
        let amount = some(0.0, 20.0);
        lead.end_reliefs = [false, true]
            .map(|at_far_end| EndRelief {
                amount,
                length: width * random.within(0.05, 0.4),
                at_far_end,
                parabolic: random.chance(0.5),
            })
            .to_vec();
    }
    let own = match kinds.traces {
        0 => Vec::new(),
        1 => vec![None],
        _ => (1..=teeth).map(Some).collect(),
    };
    let trace = |tooth: Option<u32>| {
        let slope = random.within(-10.0, 10.0);
        let (wave, turns) = (random.within(0.0, 4.0), random.within(0.5, 3.0));
        let phase = random.within(0.0, TAU);
        let noise = random.pick(&[0.0, 0.3, 1.5]);
        let point = |k: u32| {
            let part = f64::from(k) / f64::from(TRACE_POINTS - 1);
            let form = wave * (phase + TAU * turns * part).sin() + noise * random.within(-1.0, 1.0);
            (face[0] + width * part, um * (slope * part + form))
        };
        let points = (0..TRACE_POINTS).map(point).collect();
        Trace { tooth, points }
    };
    lead.traces = own.into_iter().map(trace).collect();
    lead
}

/// Rotations beyond nominal at which the free gear of `pose` stops: on the right, and on the left; the right one counts up to tightness, the
/// left one down.
fn beyond(pose: &Pose, lost: &LostMotion) -> Option<[f64; 2]> {
    let off = lost.right?.rotation - pose.free_rotation();
    let right = off - TAU * (off / TAU).round();
    Some([right, right + lost.angle()?])
}

/// How far the section at `b` holds the free gear back on the right and on the left, rad; plus is tighter.
fn tightness(pair: &GearPair, pose: &Pose, b: f64) -> Option<[f64; 2]> {
    let (section, here) = pose.section(pair, b);
    let lost = ExactKernel::new(&section).lost_motion(&here).ok()?;
    if lost.right.is_none() || lost.left.is_none() {
        // A section beyond the teeth.
        return Some([f64::MIN; 2]);
    }
    beyond(&here, &lost).map(|[right, left]| [right, -left])
}

/// The tightest of `count` sections and both ends on the right and on the left, rad, as rotations of the free gear beyond nominal.
pub fn dense(pair: &GearPair, pose: &Pose, count: u32) -> [f64; 2] {
    let found = sections(pair, pose, count).expect("contact in every section");
    let most = [0, 1].map(|k| {
        found
            .iter()
            .map(|(_, tight)| tight[k])
            .fold(f64::MIN, f64::max)
    });
    [most[0], -most[1]]
}

/// The sections that can hold a tooth of both gears, mm: teeth of leaning axes reach over the common face.
fn reach(pair: &GearPair) -> [f64; 2] {
    let [from, to] = pair.face();
    let most = Member::BOTH.map(|member| pair.gear(member).reach());
    let over = pair.most_lean() * most[0].max(most[1]);
    [from - over, to + over]
}

fn sections(pair: &GearPair, pose: &Pose, count: u32) -> Option<Vec<(f64, [f64; 2])>> {
    let [from, to] = reach(pair);
    let place = |k: u32| from + (to - from) * f64::from(k) / f64::from(count);
    (0..=count)
        .map(|k| Some((place(k), tightness(pair, pose, place(k))?)))
        .collect()
}

/// A pose against its dense sections.
#[derive(Debug, Clone, Copy)]
pub struct Witnessed {
    /// How much tighter than the whole face the tightest section is on a side, less its bound, µm of `j_wt`: a fault above 0.
    pub looser: f64,
    /// How much tighter the whole face is than the tightest section with zoom, less its bound: a fault above 0.
    pub tighter: f64,
    /// How much tighter the whole face is than the tightest section without zoom.
    pub between: f64,
    /// Place of the contact on the right and on the left, and of the tightest section, mm.
    pub places: [[f64; 2]; 2],
}

/// The contacts of a pose over the whole face against `count` sections with zoom at their tightest places; `None` for jammed poses.
pub fn witness(pair: &GearPair, pose: &Pose, count: u32) -> Option<Witnessed> {
    let lost = ExactKernel::new(pair)
        .lost_motion(pose)
        .expect("a proven pose");
    let [right, left] = beyond(pose, &lost)?;
    let whole = [right, -left];
    let found = sections(pair, pose, count)?;
    let um = 1e3 * pair.operating_pitch_radius(pair.free());
    let mut witnessed = Witnessed {
        looser: f64::MIN,
        tighter: f64::MIN,
        between: 0.0,
        places: [[0.0; 2]; 2],
    };
    for (k, contact) in [lost.right?, lost.left?].into_iter().enumerate() {
        let bound = contact.error + RESOLVED / um;
        let most = found
            .iter()
            .map(|(_, tight)| tight[k])
            .fold(f64::MIN, f64::max);
        // Every place whose neighbours are looser, the tightest first.
        let mut tops: Vec<usize> = (0..found.len())
            .filter(|&i| {
                let beside = [i.saturating_sub(1), (i + 1).min(found.len() - 1)];
                beside.iter().all(|&j| found[j].1[k] <= found[i].1[k])
            })
            .collect();
        tops.sort_by(|&i, &j| found[j].1[k].total_cmp(&found[i].1[k]));
        // The section of the contact itself is one of the dense ones: a peak can be narrower than their distance.
        let own = tightness(pair, pose, contact.section)?[k];
        let mut tightest = (contact.section, own);
        for &i in tops.iter().take(ZOOMED) {
            let (b, tight) = refined(pair, pose, k, &found, i)?;
            if tight > tightest.1 {
                tightest = (b, tight);
            }
        }
        let (place, zoomed) = tightest;
        witnessed.places[k] = [contact.section, place];
        witnessed.looser = witnessed.looser.max((zoomed - whole[k] - bound) * um);
        witnessed.tighter = witnessed.tighter.max((whole[k] - zoomed - bound) * um);
        witnessed.between = witnessed.between.max((whole[k] - most) * um);
    }
    Some(witnessed)
}

/// Places that are refined.
const ZOOMED: usize = 3;

/// The tightest section on a side around place `i` of `found`, each round four times denser.
fn refined(
    pair: &GearPair,
    pose: &Pose,
    side: usize,
    found: &[(f64, [f64; 2])],
    i: usize,
) -> Option<(f64, f64)> {
    let [from, to] = reach(pair);
    let (mut best, mut reach) = (found[i], found[1].0 - found[0].0);
    let end = REFINED * reach;
    while reach > end {
        reach *= 0.25;
        for step in [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0] {
            let b = (best.0 + step * reach).clamp(from, to);
            let tight = tightness(pair, pose, b)?;
            if tight[side] > best.1[side] {
                best = (b, tight);
            }
        }
    }
    Some((best.0, best.1[side]))
}
