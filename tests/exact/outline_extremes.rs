//! Random drawn pairs: proven extremes hold dense poses, polygons of odd teeth overlap just outside the play, excluded pairs of pieces do not touch.

use super::*;
use crate::drawn::cross;
use crate::kit::inv;
use crate::outlines::{MEASURED, drawn_pair};
use crate::paths::{READING, arc, closed_by_arcs, lines, turned};
use crate::random::{self, Random, either};
use gearlash::analysis::extremes::RunExtremes;
use gearlash::analysis::study::Material;
use gearlash::error::go_on;

/// The kind of curve of a flank.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Flanks {
    Chords(u32),
    Arcs(u32),
    Cubics(u32),
}

/// A gear of module 1 and what is random about it.
#[derive(Debug, Clone, Copy)]
struct Drawn {
    teeth: u32,
    flanks: Flanks,
    shift: f64,
    tip: f64,
    /// Greatest distance of a point from the involute, mm.
    rough: f64,
    /// Number of teeth that have points of their own; the others are equal.
    unlike: u32,
}

impl Drawn {
    /// Half the angle of a tooth at a radius: an involute of 20°, and a radial line below its base circle.
    fn half_angle(&self, radius: f64) -> f64 {
        let z = f64::from(self.teeth);
        let angle = 20f64.to_radians();
        let base = 0.5 * z * angle.cos();
        let here = (base / radius.max(base)).acos();
        (FRAC_PI_2 + 2.0 * self.shift * angle.tan()) / z + inv(angle) - inv(here)
    }

    /// Right flank from the root to the tip, of a tooth on +y.
    fn flank(&self, random: &mut Random) -> Vec<PathSegment> {
        let pitch = 0.5 * f64::from(self.teeth) + self.shift;
        let [root, tip] = [pitch - 1.25, pitch + self.tip];
        let count = match self.flanks {
            Flanks::Chords(count) => count,
            Flanks::Arcs(count) | Flanks::Cubics(count) => 2 * count,
        };
        let step = (tip - root) / f64::from(count);
        let point = |k: u32, random: &mut Random| {
            let off = |random: &mut Random| random.within(-1.0, 1.0);
            let is_inner = k > 0 && k < count;
            let along = if is_inner { off(random) } else { 0.0 };
            let radius = root + step * (f64::from(k) + 0.3 * along);
            let angle = self.half_angle(radius) + self.rough * off(random) / radius;
            Point2::new(radius * angle.sin(), radius * angle.cos())
        };
        let points: Vec<Point2<f64>> = (0..=count).map(|k| point(k, random)).collect();
        match self.flanks {
            Flanks::Chords(_) => lines(&points),
            Flanks::Arcs(_) => {
                let piece = |three: &[Point2<f64>]| arc([three[0], three[1], three[2]]);
                points.windows(3).step_by(2).map(piece).collect()
            }
            Flanks::Cubics(_) => {
                let slope = |k: usize| {
                    let (from, to) = (k.saturating_sub(1), (k + 1).min(points.len() - 1));
                    (points[to] - points[from]) / (to - from) as f64
                };
                let piece = |k: usize| {
                    let [a, d] = [points[k], points[k + 1]];
                    PathSegment::Cubic([a, a + slope(k) / 3.0, d - slope(k + 1) / 3.0, d])
                };
                (0..points.len() - 1).map(piece).collect()
            }
        }
    }

    /// `None` where curves cross.
    fn gear(&self, random: &mut Random) -> Option<OutlineGear> {
        let pitch = TAU / f64::from(self.teeth);
        let mut path: Vec<PathSegment> = Vec::new();
        let mut flanks = None;
        for tooth in 0..self.teeth {
            if flanks.is_none() || tooth <= self.unlike {
                flanks = Some([self.flank(random), self.flank(random)]);
            }
            let Some([right, left]) = &flanks else { break };
            // Up on the left, down on the right.
            let mirrored = left.iter().map(PathSegment::mirrored);
            let down = right.iter().rev().map(PathSegment::reversed);
            let both: Vec<PathSegment> = mirrored.chain(down).collect();
            path.extend(turned(&both, -pitch * f64::from(tooth)));
        }
        OutlineGear::new(&closed_by_arcs(&path), &READING).ok()
    }
}

/// A pair, each gear with `unlike` teeth of their own.
fn pair(
    random: &mut Random,
    unlike: impl Fn(&mut Random) -> u32,
    flanks: impl Fn(&mut Random) -> Flanks,
) -> OutlinePair {
    let unlike = unlike(random);
    let rough = match random.chance(0.5) {
        true => random.decades(1e-4, 1e-2),
        false => 0.0,
    };
    let runout = random.chance(0.08);
    let (few, more) = if unlike > 0 || runout {
        (7, 4)
    } else {
        (8, 40)
    };
    let mut drawn = || Drawn {
        teeth: few + random.one_of(more),
        flanks: flanks(random),
        shift: random.within(-0.1, 0.5),
        tip: random.within(0.8, 1.0),
        rough,
        unlike,
    };
    let each = [drawn(), drawn()];
    let [wheel, pinion] = each.map(|drawn| {
        let gear = drawn.gear(random).unwrap();
        if !runout {
            return gear;
        }
        let high = 1.0 + random.within(0.0, f64::from(drawn.teeth));
        gear.with_runout(random.within(0.0, 0.02), high).unwrap()
    });
    let [one, other] = each.map(|drawn| 0.5 * f64::from(drawn.teeth) + drawn.shift);
    let a = one + other + random.within(-0.03, 0.2);
    let locked = either(random, Member::BOTH);
    OutlinePair::new(wheel, pinion, a, locked).unwrap()
}

fn found(pair: &OutlinePair) -> RunExtremes {
    let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member).clone());
    let gears = vec![(Material::AsMeasured, wheel, pinion)];
    let sweep = SweepPlan::Matings {
        matings: vec![(1, 1)],
        fractions: vec![0.0],
    };
    let distances = vec![pair.center_distance()];
    let study = Study::of_drawn("drawn", gears, pair.locked(), distances, sweep);
    let found = extremes(&study, Method::Exact { certify: false }, &go_on).unwrap();
    found.each.into_iter().next().unwrap()
}

/// Poses a pitch.
const DENSE: u64 = 400;

/// No pose lies outside the brackets of `pair`; the widths of these, mm.
fn hold(pair: &OutlinePair, case: &str) -> [f64; 2] {
    let run = found(pair);
    let [Some(least), Some(greatest)] = [&run.least, &run.greatest] else {
        panic!("{case}: {:?}", run.status)
    };
    let kernel = OutlineKernel::new(pair);
    let radius = pair.operating_pitch_radius(pair.free());
    // Equal teeth repeat in every pitch; of unlike ones every 7th pose of the whole cycle.
    let (pitches, every) = match run.has_like_teeth() {
        true => (1, 1),
        false => (run.matings, 7),
    };
    for k in (0..DENSE * pitches).step_by(every) {
        let mating = Mating::FIRST.onward(pair, k as f64 / DENSE as f64);
        let pose = kernel.lost_motion(&mating).unwrap();
        let (angle, error) = pose.angle().zip(pose.error()).unwrap();
        let [low, high] = [angle - error, angle + error].map(|angle| angle * radius);
        let is_held = high >= least.low && low <= greatest.high;
        assert!(is_held, "{case}: {low} {mating:?} {least:?} {greatest:?}");
    }
    // Both ends are attained, the inner ones by the poses named.
    for end in [least, greatest] {
        let j_wt = end.found();
        assert!(end.low <= j_wt && j_wt <= end.high, "{case}: {end:?}");
        assert!(end.is_proven(), "{case}: {end:?}");
    }
    [least, greatest].map(|end| end.high - end.low)
}

/// The brackets of `count` pairs hold and are proven. `GEARLASH_PAIRS` states another count.
fn all_hold(
    (seed, count): (u64, u64),
    unlike: impl Fn(&mut Random) -> u32 + Copy,
    flanks: impl Fn(&mut Random) -> Flanks + Copy,
) {
    let count = std::env::var("GEARLASH_PAIRS").map_or(count, |count| count.parse().unwrap());
    let mut widest: f64 = 0.0;
    for number in 0..count {
        let mut random = Random(seed + 1000 * number);
        let pair = pair(&mut random, unlike, flanks);
        let widths = hold(&pair, &format!("seed {seed}, pair {number}"));
        widest = widths.into_iter().fold(widest, f64::max);
    }
    assert!(widest <= 5e-5);
}

/// The unlike teeth of a gear: none, or in some pairs all.
fn mostly_equal(random: &mut Random) -> u32 {
    if random.chance(0.08) { u32::MAX } else { 0 }
}

/// A pitch in which only equal teeth meet stands for all such pitches. Source, as of both tests below: poses of the same pairs, 400 per pitch.
#[test]
fn no_pose_of_a_few_odd_teeth_lies_outside_the_bracket() {
    let odd = |random: &mut Random| random.one_of(3);
    all_hold((4, 12), odd, |random| Flanks::Arcs(1 + random.one_of(3)));
}

#[test]
fn no_pose_of_polygons_lies_outside_the_bracket() {
    let chords = |random: &mut Random| Flanks::Chords(2 + random.one_of(18));
    all_hold((1, 40), mostly_equal, chords);
}

#[test]
fn no_pose_of_arcs_and_cubics_lies_outside_the_bracket() {
    let kinds: [fn(u32) -> Flanks; 2] = [Flanks::Arcs, Flanks::Cubics];
    let flanks = |random: &mut Random| either(random, kinds)(1 + random.one_of(3));
    all_hold((2, 24), mostly_equal, flanks);
}

/// A pair of irregular teeth, each with points of its own, apart by more than their sum of pitch radii; `None` where curves cross.
fn odd_pair(
    random: &mut Random,
    locked: Member,
    apart: [f64; 2],
    eccentricity: f64,
) -> Option<OutlinePair> {
    let mut drawn = || Drawn {
        teeth: 5 + random.one_of(20),
        flanks: match random.one_of(3) {
            1 => Flanks::Chords(1 + random.one_of(3)),
            2 => Flanks::Arcs(random.one_of(2)),
            _ => Flanks::Cubics(random.one_of(2)),
        },
        shift: random.within(-0.1, 0.3),
        tip: random.within(0.4, 0.9),
        rough: 0.12,
        unlike: u32::MAX,
    };
    let each = [drawn(), drawn()];
    let [wheel, pinion] = each.map(|drawn| drawn.gear(random));
    let wheel = wheel?.with_runout(eccentricity, 2.5).unwrap();
    let [one, other] = each.map(|drawn| 0.5 * f64::from(drawn.teeth) + drawn.shift);
    let distance = one + other + random.within(apart[0], apart[1]);
    OutlinePair::new(wheel, pinion?, distance, locked).ok()
}

/// Rectangles around runs of pieces rule out no contact. Source: every pair of pieces.
#[test]
fn nothing_that_touches_is_ruled_out() {
    let mut compared = 0;
    for seed in 0..90u64 {
        let mut random = Random(1000 + seed);
        let locked = Member::BOTH[seed as usize % 2];
        let pair = if seed % 3 == 0 {
            let chord = random.decades(5e-4, 1.5e-2);
            drawn_pair(&random::pair(&mut random, MEASURED), chord)
        } else {
            let eccentricity = random.within(0.0, 0.3);
            odd_pair(&mut random, locked, [-1.0, 1.8], eccentricity)
        };
        // Curves may cross; such an outline is no gear.
        let Some(pair) = pair else { continue };
        let kernel = OutlineKernel::new(&pair);
        for k in 0..8u32 {
            let mating = at(k % 5 + 1, (k + 1) % 5 + 1, random.within(-0.5, 0.5));
            let found = kernel.lost_motion(&mating).unwrap();
            let all = kernel.lost_motion_by_search(&mating).unwrap();
            assert_eq!(found.status(), all.status(), "{seed} {k}");
            // For solid poses an overlap of half a turn counts from either side.
            if found.solid {
                continue;
            }
            assert_eq!(differ(&found, &all, 0.0), None, "{seed} {k}");
            compared += [found.right, found.left].iter().flatten().count();
        }
    }
    assert!(compared > 500, "{compared}");
}

/// Wheels of irregular, different teeth: polygons overlap just outside the play found, and not just inside it.
#[test]
fn odd_teeth_overlap_just_outside_the_play() {
    let (mut clear, mut tight) = (0, 0);
    for seed in 0..160u64 {
        let mut random = Random(seed);
        let locked = Member::BOTH[seed as usize % 2];
        let Some(pair) = odd_pair(&mut random, locked, [0.0, 1.6], 0.0) else {
            continue;
        };
        let kernel = OutlineKernel::new(&pair);
        for k in 0..6u32 {
            let mating = at(k % 5 + 1, (k + 1) % 5 + 1, 0.23 * f64::from(k));
            let found = kernel.lost_motion(&mating).unwrap();
            let Some((right, left)) = found.right.zip(found.left) else {
                continue;
            };
            let off = |contact: &Contact| contact.error + 2e-4;
            if found.status() == Status::Clear && left.rotation - right.rotation > 2e-3 {
                for (rotation, overlaps) in [
                    (right.rotation - 4.0 * off(&right), true),
                    (right.rotation + off(&right), false),
                    (0.5 * (right.rotation + left.rotation), false),
                    (left.rotation - off(&left), false),
                    (left.rotation + 4.0 * off(&left), true),
                ] {
                    let crosses = cross(&pair, &mating, rotation);
                    assert_eq!(crosses, overlaps, "{seed} {k} {rotation} {found:?}");
                }
                clear += 1;
            } else if found.status() == Status::Interference {
                for share in [0.0, 0.3, 0.7, 1.0] {
                    let between = left.rotation + share * (right.rotation - left.rotation);
                    let is_narrow = right.rotation - left.rotation < 1e-3;
                    let overlaps = is_narrow || cross(&pair, &mating, between);
                    assert!(overlaps, "{seed} {k} {found:?}");
                }
                tight += 1;
            }
        }
    }
    assert!(clear > 400 && tight > 8, "{clear} {tight}");
}
