//! Random pairs that deviate along the face, and the dense transverse sections that witness their poses.

#![allow(dead_code)] // each test binary uses its part

use crate::campaign::{random::Random, without_turns};
use crate::kit::Make;
use gearlash::contact::{Contact, ExactKernel, LostMotion, Status};
use gearlash::gear::{
    AsBuilt, BasicGearData, EndRelief, Face, Gear, GearDesign, Hand, Lead, Modification, Relief,
    Side, Trace,
};
use gearlash::pair::{GearPair, Mating, Member, Pose, section_at};
use std::f64::consts::TAU;

/// Points of a measured lead.
const TRACE_POINTS: u32 = 33;

/// Resolution of the place of a contact, µm: 1e-5 mm along a lead that rises by 2 µm per mm.
const RESOLVED: f64 = 2e-5;

/// The resolution as an angle of the free gear, rad.
pub fn resolved(pair: &GearPair) -> f64 {
    RESOLVED / (1e3 * pair.operating_pitch_radius(pair.free()))
}

/// Pose `index` of `seed`, each of a pair of its own, with a helix angle of 0 to 35°. Leads, pitch, eccentricity, wobble and leaning shafts are up
/// to some 30 µm over the face. With `profiles` most flanks have profile deviations of up to some 20 µm, and axes are parallel.
pub fn drawn(seed: u64, index: u64, profiles: bool) -> (GearPair, Pose) {
    let mut random = Random::of(seed, index);
    let mut drawn = std::iter::repeat_with(|| one(&mut random, profiles)).flatten();
    drawn.next().expect("an endless sequence")
}

fn one(random: &mut Random, profiles: bool) -> Option<(GearPair, Pose)> {
    let module = random.decades(1.0, 6.0);
    let spur = random.chance(0.25);
    let helix = if spur { 0.0 } else { random.within(0.5, 35.0) };
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
        data.with_helix(f64::to_radians(helix), hand).unwrap()
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
    let gear = Make::of(GearDesign::standard(data)).shift(random.within(0.0, 0.5));
    let gear = gear.allowance(-random.within(0.02, 0.06) * data.module());
    let seen = random.pick(&[Face::Front, Face::Back]);
    // Heights count from the reference face inwards.
    let own = match seen {
        Face::Front => face,
        Face::Back => [-face[1], -face[0]],
    };
    let um = 1e-3;
    let mut pitch = || Vec::from_iter((0..teeth).map(|_| um * random.within(-8.0, 8.0)));
    let [right, left] = [pitch(), pitch()];
    let gear = gear.leads([0, 1].map(|_| lead(random, teeth, own, kinds)));
    let mut high = || random.within(1.0, f64::from(teeth) + 1.0);
    let (high_tooth, wobble_tooth) = (high(), high());
    let plain = gear.try_gear().ok()?;
    let gear = gear.profiles([0, 1].map(|_| match kinds.profiles && random.chance(0.8) {
        true => profile(random, &plain, true),
        false => Modification::default(),
    }));
    let gear = match random.chance(0.7) {
        true => gear.pitch(&right, &left),
        false => gear,
    };
    let eccentricity = random.pick(&[0.0, 1.0]) * um * random.within(0.0, 30.0);
    let wobble = match kinds.wobble {
        true => random.within(0.0, 5e-4),
        false => 0.0,
    };
    let gear = gear.runout(eccentricity, high_tooth);
    gear.wobble(wobble, wobble_tooth).try_built(seen)
}

/// A profile on some of a gear's flanks, from none to twenty times what a shop tolerates.
pub fn profile(random: &mut Random, gear: &Gear, traces: bool) -> Modification {
    let um = 1e-3 * gear.basic_data().module() * random.decades(0.1, 10.0);
    let base = gear.base_radius();
    let rolls = [gear.form_roll(), gear.tip_roll()];
    let at = |share: f64| rolls[0] + (rolls[1] - rolls[0]) * share;
    let radius = |roll: f64| base * roll.hypot(1.0);
    let mut modification = Modification::default();
    if random.chance(0.4) {
        modification.slope = um * random.within(-5.0, 5.0);
    }
    if random.chance(0.4) {
        modification.crowning = um * random.within(-2.0, 5.0);
    }
    let mut relief = |from: f64| {
        random.chance(0.4).then(|| Relief {
            amount: um * random.within(0.0, 10.0),
            from: radius(at(from + random.within(-0.2, 0.2))),
            parabolic: random.chance(0.5),
        })
    };
    modification.tip_relief = relief(0.7);
    modification.root_relief = relief(0.25);
    let teeth = gear.basic_data().teeth();
    if traces && random.chance(0.4) {
        let mut trace = |tooth| {
            let count = 2 + (random.bits() % 30) as usize;
            let deviation = |k: usize| {
                let roll = at(k as f64 / (count - 1) as f64);
                (roll.max(1e-6 * k as f64), um * random.within(-1.0, 1.0))
            };
            Trace {
                tooth,
                points: (0..count).map(deviation).collect(),
            }
        };
        modification.traces = match teeth % 3 {
            0 => vec![trace(None)],
            _ => (1..=teeth.min(4)).map(|tooth| trace(Some(tooth))).collect(),
        };
    }
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

/// How far a contact at `b` holds the free gear back, rad beyond the nominal rotation of the measuring plane; plus is tighter. The teeth of a
/// section are turned by the free gear's own twist, `−η b tan β/r`, from those of the measuring plane.
pub fn held_back(pair: &GearPair, pose: &Pose, side: Side, b: f64, contact: &Contact) -> f64 {
    let data = pair.gear(pair.free()).gear().basic_data();
    let eta = match data.hand() {
        Some(Hand::Right) => 1.0,
        _ => -1.0,
    };
    let twist = -eta * b * data.helix_angle().tan() / data.reference_radius();
    let turned = contact.rotation - twist - pose.free_rotation();
    -side.sense() * without_turns(turned)
}

/// [`held_back`] on the right and on the left, and the error, by the section at `b` alone, a spur pair; nothing holds it in a section without contact.
pub fn of_section(
    pair: &GearPair,
    pose: &Pose,
    b: f64,
    method: &impl Fn(&GearPair, &Pose) -> LostMotion,
) -> [(f64, f64); 2] {
    let (section, here) = section_at(pair, pose, b);
    let found = method(&section, &here);
    Side::BOTH.map(|side| {
        let held = |one: Contact| (held_back(pair, pose, side, b, &one), one.error);
        found.on(side).map_or((f64::NEG_INFINITY, 0.0), held)
    })
}

/// Nothing touches.
pub const OPEN: LostMotion = LostMotion {
    right: None,
    left: None,
    solid: false,
};

/// The exact method; nothing where its search gives up.
pub fn exact(section: &GearPair, here: &Pose) -> LostMotion {
    let found = ExactKernel::new(section).lost_motion(here);
    found.unwrap_or(OPEN)
}

/// `count` even parts of the sections that can hold a tooth of both gears, mm: teeth of leaning axes reach over the common face.
pub fn evenly(pair: &GearPair, count: u32) -> impl Iterator<Item = f64> {
    let [from, to] = reach(pair);
    (0..=count).map(move |k| from + (to - from) * f64::from(k) / f64::from(count))
}

fn reach(pair: &GearPair) -> [f64; 2] {
    let [from, to] = pair.face();
    let most = Member::BOTH.map(|member| pair.gear(member).reach());
    let over = pair.lean_bound() * most[0].max(most[1]);
    [from - over, to + over]
}

/// A section tighter than the whole face by more than `looser`, rad, or a face tighter than any section by more than `tighter`. Jammed poses have none.
/// It examines `count` sections and that of the contact, and then others ever nearer to the tightest of them.
pub fn against_sections(
    pair: &GearPair,
    pose: &Pose,
    found: &LostMotion,
    count: u32,
    [looser, tighter]: [f64; 2],
) -> Vec<String> {
    if found.status() == Status::Jammed {
        return Vec::new();
    }
    let [from, to] = reach(pair);
    // Leads and profiles have several places that are nearly the tightest.
    let refined = if pair.binds_anywhere() { 3 } else { 1 };
    // An error leaves as much for a section that is no tighter.
    let surely = |b: f64| of_section(pair, pose, b, &exact).map(|(held, error)| held - error);
    let each: Vec<(f64, [f64; 2])> = evenly(pair, count).map(|b| (b, surely(b))).collect();
    let mut against = Vec::new();
    for (k, side) in Side::BOTH.into_iter().enumerate() {
        let is_top = |i: &usize| {
            let beside = [i.saturating_sub(1), (i + 1).min(each.len() - 1)];
            beside.iter().all(|&j| each[j].1[k] <= each[*i].1[k])
        };
        let mut tops: Vec<usize> = (0..each.len()).filter(is_top).collect();
        tops.sort_by(|&i, &j| each[j].1[k].total_cmp(&each[i].1[k]));
        let climbed = tops.iter().take(refined).map(|&i| {
            let (mut best, mut step) = ((each[i].0, each[i].1[k]), (to - from) / f64::from(count));
            while step > 1e-7 {
                for b in [best.0 - step, best.0 + step].map(|b| b.clamp(from, to)) {
                    let here = surely(b)[k];
                    if here > best.1 {
                        best = (b, here);
                    }
                }
                step *= 0.5;
            }
            best
        });
        let best = climbed.reduce(|a, b| if b.1 > a.1 { b } else { a });
        let best = best.expect("a tightest section");
        let Some(contact) = found.on(side) else {
            if best.1 > f64::NEG_INFINITY {
                against.push(format!("{side:?}: none claimed, {best:?}"));
            }
            continue;
        };
        let own = held_back(pair, pose, side, 0.0, &contact);
        let (there, error) = of_section(pair, pose, contact.section, &exact)[k];
        let most = best.1.max(there - error);
        if most > own + contact.error + looser {
            against.push(format!("{best:?}, {there} tighter than {own}, {contact:?}"));
        }
        if !(best.1.max(there + error) >= own - contact.error - tighter) {
            against.push(format!("{best:?}, {there} looser than {own}, {contact:?}"));
        }
    }
    against
}
