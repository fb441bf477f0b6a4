//! Outlines against the exact method, which knows what each curve of a gear is and where it can touch.

use super::*;
use crate::campaign::turned;
use crate::paths::{READING, polygon};
use crate::random::{self, Kind, Random, either, mating};
use gearlash::contact::OutlineCertifier;
use gearlash::gear::Placed;
use rayon::prelude::*;

fn outlines(pair: &GearPair) -> OutlinePair {
    let [wheel, pinion] = Member::BOTH.map(|member| OutlineGear::from(pair.gear(member)));
    OutlinePair::new(wheel, pinion, pair.center_distance(), pair.locked()).unwrap()
}

/// The pose with the locked gear turned as by `mating` of outlines, which count from elsewhere, and from `beside` that, rad.
fn same(pair: &GearPair, outlines: &OutlinePair, mating: Mating, beside: f64) -> Pose {
    let locked = pair.gear(pair.locked());
    let pitch = locked.gear().basic_data().angular_pitch();
    let there = outlines.rotation(pair.locked(), &mating) - beside;
    let off = there - Pose::new(pair, mating).locked_rotation();
    let onward = -locked.face().ascending() * off / pitch;
    Pose::new(pair, mating.onward(pair, onward))
}

/// The status of a pose, whose contacts are the same by outlines, which polygons confirm. `rounding` is what both rotations of the locked gear differ
/// by, rad.
fn agreed(pair: &GearPair, mating: Mating, rounding: f64) -> Status {
    let outlines = outlines(pair);
    let pose = same(pair, &outlines, mating, 0.0);
    let exact = ExactKernel::new(pair).lost_motion(&pose).unwrap();
    let kernel = OutlineKernel::new(&outlines);
    let found = kernel.lost_motion(&mating).unwrap();
    assert_eq!(differ(&exact, &found, rounding), None, "{mating:?}");
    let seen = OutlineCertifier::new(&kernel).check(&mating, &found);
    assert_eq!(seen, Ok(()), "{mating:?} {found:?}");
    exact.status()
}

/// From far beyond any shop: undercut, three teeth, jams, tips in fillets and roots.
#[test]
fn of_wide_pairs_they_have_the_same_contacts() {
    let met = (0..400u32).filter_map(|number| {
        let drawn = Pair::new(77, number.into()).pose(0, Some(Depth::Any));
        let pair = &drawn.assembly;
        let reach =
            |member: Member| pair.gear(member).reach() + pair.gear(member.mate()).eccentricity();
        if reach(Member::Wheel).max(reach(Member::Pinion)) >= pair.center_distance() {
            return None;
        }
        let [wheel, pinion] = Member::BOTH.map(|member| pair.teeth(member));
        let [wheel, pinion] = [7 * number % wheel + 1, 11 * number % pinion + 1];
        let mating = at_flank(wheel, pinion, Side::BOTH[number as usize % 2], 0.3);
        Some(agreed(pair, mating, 1e-12))
    });
    let met: Vec<Status> = met.collect();
    for status in [Status::Clear, Status::Interference, Status::Jammed] {
        let count = met.iter().filter(|met| **met == status).count();
        assert!(count > 10, "{status:?}: {count}");
    }
    // Three free teeth, turned by more than half a turn from where they face the mate.
    let drawn = Drawn::new(None, 29, 637_932);
    let status = agreed(&drawn.assembly, drawn.mating, 1e-12);
    assert_eq!(status, Status::Jammed);
}

/// The outline of a gear as someone draws its reference face: a polygon of chords within `chord` mm of its curves.
pub fn drawn(built: &AsBuilt, chord: f64) -> Option<OutlineGear> {
    let placed = Placed::new(built, Point2::origin(), FRAC_PI_2);
    let points = placed.outline_near(Point2::origin(), 2.0 * built.reach(), chord);
    let mirror = -built.face().ascending();
    let mirrored = |point: &Point2<f64>| Point2::new(mirror * point.x, point.y);
    let points: Vec<Point2<f64>> = points.iter().map(mirrored).collect();
    let reading = OutlineReading {
        centre: Point2::new(mirror * placed.centre().x, placed.centre().y),
        face: built.face(),
        teeth: Some(built.gear().basic_data().teeth()),
        first_tooth: Some(FRAC_PI_2),
        bound: chord,
    };
    let gear = OutlineGear::new(&polygon(&points), &reading).ok()?;
    let (eccentricity, high_tooth) = (built.eccentricity(), built.high_tooth());
    gear.with_runout(eccentricity, high_tooth).ok()
}

/// Gears with deviations of some hundredths of a module.
pub const MEASURED: Kind = Kind {
    teeth: (11.0, 60.0),
    deviation: 6.0,
    shift: (-0.05, 0.2),
};

/// Both gears of `pair` as someone draws them, with chords within a part of the module; `None` where coarse chords cross.
pub fn drawn_pair(pair: &GearPair, chord: f64) -> Option<OutlinePair> {
    let module = pair.gear(Member::Wheel).gear().basic_data().module();
    let [wheel, pinion] = Member::BOTH.map(|member| drawn(pair.gear(member), chord * module));
    OutlinePair::new(wheel?, pinion?, pair.center_distance(), pair.locked()).ok()
}

/// Polygons of measured gears, right and left halves numbered as their data are: the lost motion of their curves, within the chords' error.
#[test]
fn polygons_of_measured_gears_have_their_lost_motion() {
    let mut random = Random(15);
    let mut compared = 0;
    for _ in 0..12 {
        let pair = random::pair(&mut random, MEASURED);
        let outlines = drawn_pair(&pair, 5e-5).unwrap();
        let (kernel, exact) = (OutlineKernel::new(&outlines), ExactKernel::new(&pair));
        let certifier = OutlineCertifier::new(&kernel);
        for k in 0..8 {
            let flank = Side::BOTH[k as usize % 2];
            let fraction = 0.1 * f64::from(k);
            let mating = at_flank(3 * k % 11 + 1, 5 * k % 11 + 1, flank, fraction);
            // A drawing counts from where its tooth 1 stands.
            let locked = pair.gear(pair.locked());
            let beside = Side::BOTH.map(|side| locked.flank_offset(side, 1));
            let pose = same(&pair, &outlines, mating, 0.5 * (beside[0] + beside[1]));
            let exact = exact.lost_motion(&pose).unwrap();
            let found = kernel.lost_motion(&mating).unwrap();
            refuses_any_other(&certifier, &mating, &found);
            let Some((angle, other)) = exact.angle().zip(found.angle()) else {
                continue;
            };
            let bound = exact.error().unwrap() + found.error().unwrap();
            near(mating, angle, other, bound);
            // Chords cut off metal, so there is only more room.
            assert!(other - angle > -1e-9, "{angle} {other}");
            compared += 1;
        }
    }
    assert!(compared > 80, "{compared}");
}

/// Polygons confirm `found`, and no rotation slightly to either side: before it nothing touches, after it something overlaps.
fn refuses_any_other(certifier: &OutlineCertifier, mating: &Mating, found: &LostMotion) {
    for (claimed, borne) in claims(found, f64::INFINITY) {
        let seen = certifier.check(mating, &claimed);
        assert_eq!(seen.is_ok(), borne, "{seen:?} of {claimed:?}");
        if let Some((seen, one)) = seen.err().zip(claimed.right) {
            let is_right = Some(one) != found.right;
            assert_eq!(seen.flank == "right", is_right, "{claimed:?}");
        }
    }
}

/// The contacts found, moved slightly to either side, and missing, each with whether it must be confirmed.
fn claims(found: &LostMotion, pitch: f64) -> Vec<(LostMotion, bool)> {
    let mut claims = vec![(*found, true)];
    for side in Side::BOTH {
        let Some(one) = found.on(side) else { continue };
        let off = 1e-6 + 3.0 * one.error;
        // A contact hardly known anywhere is not refused anywhere.
        let known = one.error <= 1e-3 * pitch;
        let moved = [off, -off].map(|off| turned(one, off));
        let moved = moved.into_iter().filter(|_| known).map(Some);
        for wrong in moved.chain([None]) {
            let claimed = with_contact(found, side, wrong);
            claims.push((claimed, claimed.solid));
        }
    }
    claims
}

/// The same drawn in arcs that bulge by a hundredth of their length: every one of them is a curve.
fn drawn_in_arcs(built: &AsBuilt, chord: f64) -> OutlineGear {
    let placed = Placed::new(built, Point2::origin(), FRAC_PI_2);
    let points = placed.outline_near(Point2::origin(), 2.0 * built.reach(), chord);
    let next = points.iter().cycle().skip(1);
    let arcs = points.iter().zip(next).map(|(from, to)| {
        let along = to - from;
        let out = Vector2::new(along.y, -along.x) * 0.01;
        let thirds = [1.0, 2.0].map(|k| from + along * (k / 3.0) + out);
        PathSegment::Cubic([*from, thirds[0], thirds[1], *to])
    });
    OutlineGear::new(&arcs.collect::<Vec<_>>(), &READING).unwrap()
}

/// Outlines of thousands of curves a tooth whose tips just miss each other, or just meet: either is borne out within the effort of a side. Source: a
/// distance above the sum of both reaches, and one below.
#[test]
fn polygons_bear_out_that_dense_tips_miss_each_other() {
    let gear = drawn_in_arcs(&spur(12, 2.0).front(), 1e-6);
    let pieces = gear.points(0.0, 1.0).len();
    assert!(pieces > 10_000, "{pieces}");
    for (apart, touches) in [(1e-6, false), (-0.5, true)] {
        let distance = 2.0 * gear.reach() + apart;
        let pair = OutlinePair::new(gear.clone(), gear.clone(), distance, Member::Wheel);
        let pair = pair.unwrap();
        let kernel = OutlineKernel::new(&pair);
        let found = kernel.lost_motion(&Mating::FIRST).unwrap();
        assert_eq!(found.right.is_some(), touches);
        let certifier = OutlineCertifier::new(&kernel);
        assert_eq!(certifier.check(&Mating::FIRST, &found), Ok(()), "{apart}");
    }
}

/// Whether a point of the locked outline is within the free gear's root circle at every rotation of that gear; `None` if that is uncertain.
fn stands_in_the_body(pair: &GearPair, pose: &Pose) -> Option<bool> {
    let (locked, free) = (pair.locked(), pair.gear(pair.free()));
    let turned = pair.mate_direction(locked) + pose.locked_rotation();
    let placed = Placed::new(pair.gear(locked), pair.axis(locked), turned);
    let (axis, module) = (pair.axis(pair.free()), free.gear().basic_data().module());
    let points = placed.outline_near(axis, 2.0 * pair.center_distance(), 1e-4 * module);
    let radii = points.iter().map(|point| (point - axis).norm());
    let nearest = radii.fold(f64::INFINITY, f64::min);
    let over = nearest - (free.gear().root_radius() - free.eccentricity());
    (over.abs() > 1e-3 * module).then_some(over < 0.0)
}

/// Pairs of the campaign's seed 77 that tell the program from one with a small mistake in it, as `witnesses` does of gears.
const OUTLINED: [u64; 9] = [0, 1, 2, 3, 5, 11, 25, 54, 122];

/// Source: the exact method, which knows what each curve is; and which claims are right.
#[test]
fn outlines_and_their_certificate_hold_against_the_exact_method() {
    for number in OUTLINED {
        let pair = Pair::new(77, number).pose(0, Some(Depth::Any)).assembly;
        let mating = Mating {
            fraction: 0.3,
            ..mating(&mut Random(number ^ 0x0717), &pair)
        };
        agreed(&pair, mating, 1e-12);
        let outlines = outlines(&pair);
        let kernel = OutlineKernel::new(&outlines);
        let found = kernel.lost_motion(&mating).unwrap();
        let overlap = found.right.zip(found.left);
        let overlap = overlap.map_or(0.0, |(right, left)| right.rotation - left.rotation);
        let free = pair.gear(pair.free()).gear();
        let pitch = free.basic_data().angular_pitch();
        // Nearer than the points are to the curves nothing is said.
        if let Some(deep) = stands_in_the_body(&pair, &same(&pair, &outlines, mating, 0.0)) {
            let solid = overlap >= pitch || deep;
            assert_eq!(found.solid, solid, "pair {number}");
        }
        let certifier = OutlineCertifier::new(&kernel);
        for (claimed, borne) in claims(&found, pitch) {
            let seen = certifier.check(&mating, &claimed);
            assert_eq!(seen.is_ok(), borne, "{number}: {seen:?} of {claimed:?}");
        }
    }
}

/// A trace of 30 to 500 points: two waves, noise of up to 1.5 µm from point to point, at times a step or nothing of all that.
fn trace(random: &mut Random, gear: &Gear, tooth: Option<u32>) -> Trace {
    let um = 1e-3;
    let count = 30 + random.bits() % 470;
    let waves = [0, 1].map(|_| {
        let amount = um * random.within(0.0, 6.0);
        (amount, random.within(1.0, 40.0), random.within(0.0, TAU))
    });
    let noise = um * random.decades(0.001, 1.5);
    let step = match random.chance(0.2) {
        true => (random.within(0.0, 1.0), um * random.within(-5.0, 5.0)),
        false => (2.0, 0.0),
    };
    let (from, to) = (gear.form_roll().max(1e-4), gear.tip_roll());
    let point = |k: u64| {
        let share = k as f64 / (count - 1) as f64;
        let wave = |(amount, times, phase): (f64, f64, f64)| amount * (times * share + phase).sin();
        let rough = noise * random.within(-1.0, 1.0);
        let stepped = if share > step.0 { step.1 } else { 0.0 };
        let waved: f64 = waves.into_iter().map(wave).sum();
        (from + (to - from) * share, waved + rough + stepped)
    };
    Trace {
        tooth,
        points: (0..count).map(point).collect(),
    }
}

/// A gear of 18 to 60 teeth, eccentric, pitches off by up to 10 µm, with traces of one, some or all teeth, of one side or both.
fn traced_gear(random: &mut Random, module: f64, face: Face) -> Option<AsBuilt> {
    let teeth = 18 + (random.bits() % 43) as u32;
    let gear = spur(teeth, module).shift(random.within(-0.1, 0.5));
    let plain = gear.try_gear().ok()?;
    let gear = gear.profiles([0, 1].map(|_| {
        let teeth = match random.bits() % 4 {
            0 => Vec::new(),
            1 => vec![None],
            2 => vec![Some(1), Some(4)],
            _ => (1..=teeth).map(Some).collect(),
        };
        let traces = teeth.into_iter().map(|tooth| trace(random, &plain, tooth));
        Modification {
            traces: traces.collect(),
            slope: 1e-3 * random.within(-5.0, 5.0),
            crowning: 1e-3 * random.within(0.0, 6.0),
            ..Modification::default()
        }
    }));
    let mut places = || Vec::from_iter((0..teeth).map(|_| 0.010 * random.within(-1.0, 1.0)));
    let [right, left] = [places(), places()];
    let eccentricity = match random.chance(0.3) {
        true => 0.0,
        false => 0.01 * module * random.within(0.0, 1.0),
    };
    let high_tooth = 1.0 + random.within(0.0, 0.99) * f64::from(teeth);
    let gear = gear.pitch(&right, &left).runout(eccentricity, high_tooth);
    gear.try_built(face)
}

fn traced_pair(random: &mut Random) -> Option<GearPair> {
    let module = random.decades(0.5, 6.0);
    let wheel = traced_gear(random, module, Face::Front)?;
    let pinion = traced_gear(random, module, Face::Back)?;
    let radius = |gear: &AsBuilt| {
        let gear = gear.gear();
        gear.basic_data().reference_radius() + module * gear.design().profile_shift
    };
    let distance = radius(&wheel) + radius(&pinion) + module * random.within(-0.06, 0.25);
    let locked = either(random, Member::BOTH);
    GearPair::with_locked(wheel, pinion, distance, locked).ok()
}

/// Gears whose flanks have dense measured traces. Source: the search over pairs of pieces of outlines, which uses nothing of base circles, rolls or
/// heights.
#[test]
fn dense_traces_touch_where_the_search_finds_them_to() {
    const SEEDS: u64 = 120;
    let poses = |seed: u64| {
        let mut random = Random(seed ^ 0x7ace_d000);
        let pair = traced_pair(&mut random)?;
        let outlines = outlines(&pair);
        let (search, exact) = (OutlineKernel::new(&outlines), ExactKernel::new(&pair));
        let met = (0..4).map(|_| {
            let teeth = [random.one_of(18), random.one_of(18)];
            let fraction = random.within(-0.5, 0.5);
            let flank = either(&mut random, Side::BOTH);
            let mating = at_flank(teeth[0], teeth[1], flank, fraction);
            let found = exact.lost_motion(&same(&pair, &outlines, mating, 0.0));
            let (found, witness) = (found.unwrap(), search.lost_motion(&mating).unwrap());
            assert_eq!(differ(&found, &witness, 1e-13), None, "{seed}");
            found.status()
        });
        Some(met.collect::<Vec<Status>>())
    };
    let met = (0..SEEDS).into_par_iter().filter_map(poses).flatten();
    let met: Vec<Status> = met.collect();
    let count = |status| met.iter().filter(|met| **met == status).count();
    let found = [Status::Clear, Status::Interference].map(count);
    assert!(met.len() as u64 > 3 * SEEDS, "{}", met.len());
    assert!(found.iter().all(|&count| count > 20), "{found:?}");
}
