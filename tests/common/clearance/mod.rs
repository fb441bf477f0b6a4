//! Brute force: clearance of dense points of either gear in the other's own frame, with nothing of either method. The crate only defines a pose and the
//! position of a tooth. As the free gear turns in from open, contact is where the least clearance of half teeth that face each other changes its sign.

#![allow(dead_code, unused_imports)] // each test binary uses its part

mod half;
mod named;
mod stood;
mod verdict;
mod whole;

use crate::kit::halved;
use gearlash::gear::Side;
use gearlash::pair::{GearPair, Member, Pose};
use half::{Clearance, Ends, Half};
pub use named::named;
use std::rc::Rc;
use stood::{Frame, Stood};
pub use verdict::against;
pub use whole::{overlap, overlap_just_inside};

/// Points per curve before refinement.
const POINTS: usize = 24;

/// Distance from the least, in modules, within which local minima are refined: points 0.05 m apart on curves of
/// curvature 1/(0.05 m) miss 0.01 m.
const NEAR: f64 = 0.03;

/// A facing pair: the two teeth, and the ends of both half teeth.
struct Faced {
    locked: Frame,
    free_tooth: u32,
    halves: [Rc<Half>; 2],
    ends: [Ends; 2],
    /// Centre on the centre line, and radius, of a circle about each half tooth.
    circles: [(f64, f64); 2],
}

/// The pairs of one side at one pose.
pub struct Referee<'a> {
    assembly: &'a GearPair,
    side: Side,
    free: Stood<'a>,
    locked: Stood<'a>,
    pairs: Vec<Faced>,
    module: f64,
}

/// A point that does not matter.
const FAR: Clearance = Clearance {
    mm: f64::INFINITY,
    cut: false,
    end: f64::INFINITY,
};

/// Golden section.
const RATIO: f64 = 0.618_033_988_749_894_8;

/// Where between `low` and `high` a golden section search finds `f` least, and the value.
fn least_between(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> (f64, f64) {
    let mut best = (low, f64::INFINITY);
    let mut at = |place: f64| {
        let value = f(place);
        if value < best.1 {
            best = (place, value);
        }
        value
    };
    let (mut c, mut d) = (high - RATIO * (high - low), low + RATIO * (high - low));
    let (mut at_c, mut at_d) = (at(c), at(d));
    for _ in 0..48 {
        if at_c < at_d {
            (high, d, at_d) = (d, c, at_c);
            c = high - RATIO * (high - low);
            at_c = at(c);
        } else {
            (low, c, at_c) = (c, d, at_d);
            d = low + RATIO * (high - low);
            at_d = at(d);
        }
    }
    best
}

/// Whether any stretch of negative values begins or ends at a curve.
fn crosses(found: &[f64], along: impl Fn(usize) -> f64, at: impl Fn(f64) -> Clearance) -> bool {
    (1..found.len()).any(|k| {
        let (clear, over) = match (found[k - 1] < 0.0, found[k] < 0.0) {
            (false, true) => (along(k - 1), along(k)),
            (true, false) => (along(k), along(k - 1)),
            _ => return false,
        };
        let [_, over] = halved(clear, over, 40, |place| at(place).mm >= 0.0);
        !at(over).cut
    })
}

impl<'a> Referee<'a> {
    pub fn new(assembly: &'a GearPair, pose: &Pose, side: Side) -> Referee<'a> {
        let locked = Stood::new(assembly, assembly.locked());
        let free = Stood::new(assembly, assembly.free());
        let module = assembly.gear(Member::Wheel).gear().basic_data().module();
        let gear = assembly.gear(assembly.locked());
        let basic_data = *gear.gear().basic_data();
        let teeth = i64::from(basic_data.teeth());
        let mating = pose.mating().tooth(assembly.locked());
        // From the locked tooth that points at the mate, once around.
        let ahead = pose.locked_rotation() + gear.tooth_angle(f64::from(mating));
        let middle = -(ahead / basic_data.angular_pitch()).round() as i64;
        let axis = assembly.axis(assembly.free());
        let mate = assembly.gear(assembly.free());
        let mut pairs = Vec::new();
        for step in middle - (teeth - 1) / 2..=middle + teeth / 2 {
            let tooth = gear.counter_clockwise(mating, step);
            let frame = locked.frame(pose.locked_rotation(), side, tooth);
            let ends = locked.ends(side, tooth);
            let half = locked.half(side, tooth);
            let (at, spread) = locked.circle(&half, ends);
            let at = frame.out([at, 0.0]);
            if (at[0] - axis.x).hypot(at[1] - axis.y) - spread > mate.reach() {
                continue;
            }
            let free_tooth = pose.facing_tooth(assembly, side, step);
            let theirs = free.ends(side, free_tooth);
            let mates = free.half(side, free_tooth);
            pairs.push(Faced {
                locked: frame,
                free_tooth,
                ends: [ends, theirs],
                circles: [locked.circle(&half, ends), free.circle(&mates, theirs)],
                halves: [half, mates],
            });
        }
        Referee {
            assembly,
            side,
            free,
            locked,
            pairs,
            module,
        }
    }

    /// Rounding of a clearance, mm: a few dozen operations on lengths up to the distance, turned by `rotation`.
    pub fn rounding(&self, pose: &Pose) -> f64 {
        let turned = 1.0 + pose.locked_rotation().abs() + pose.free_rotation().abs();
        let size = self.assembly.center_distance() + self.locked.half.tip + self.free.half.tip;
        64.0 * f64::EPSILON * size * turned
    }

    /// Least clearance of the side, mm, with the free gear at `rotation`.
    pub fn least(&self, rotation: f64) -> f64 {
        let mut least = 4.0 * self.module;
        for pair in &self.pairs {
            let free = self.free.frame(rotation, self.side, pair.free_tooth);
            let [ours, theirs] = pair.ends;
            let [locked, half] = pair.halves.each_ref().map(|half| &**half);
            let near = NEAR * self.module + least.max(0.0);
            let reaches = |(at, spread): (f64, f64), from: &Frame, to: &Frame, other: &Half| {
                let at = from.out([at, 0.0]);
                (at[0] - to.centre[0]).hypot(at[1] - to.centre[1]) - spread <= other.tip + near
            };
            if reaches(pair.circles[1], &free, &pair.locked, locked) {
                least = self.points((half, free, theirs), (locked, pair.locked, ours), least);
            }
            if reaches(pair.circles[0], &pair.locked, &free, half) {
                least = self.points((locked, pair.locked, ours), (half, free, theirs), least);
            }
            if least < 0.0 {
                break;
            }
        }
        least
    }

    /// Least clearance of one half tooth's points from the other, at most `least`. It is negative only where one crosses the other's *curve*: metal that
    /// came in over the cut at an end of the half tooth crosses the curve of another tooth, or none.
    fn points(
        &self,
        (one, from, its): (&Half, Frame, Ends),
        (other, to, ends): (&Half, Frame, Ends),
        mut least: f64,
    ) -> f64 {
        // Points this far outside the tip circle do not matter.
        let out = other.tip + NEAR * self.module + least.max(0.0);
        let at = |t: f64| {
            let [x, y] = to.seen(from.out(one.along(t, its)));
            match x.hypot(y) > out {
                true => FAR,
                false => other.clearance(x, y, ends),
            }
        };
        let along = |k: usize| k as f64 / POINTS as f64;
        let mut found = [f64::INFINITY; 4 * POINTS + 1];
        for (k, mm) in found.iter_mut().enumerate() {
            *mm = at(along(k)).mm;
        }
        let lowest = found.iter().copied().fold(f64::INFINITY, f64::min);
        if lowest < 0.0 && crosses(&found, along, at) {
            return least.min(lowest);
        }
        // A minimum between two points is shallow: its bound is where it came in.
        let shallow = |t: f64| {
            let found = at(t);
            match found.mm < 0.0 && found.cut {
                true => found.end,
                false => found.mm,
            }
        };
        for k in 0..=4 * POINTS {
            let here = found[k];
            let before = if k > 0 { found[k - 1] } else { f64::INFINITY };
            let after = found.get(k + 1).copied().unwrap_or(f64::INFINITY);
            if here < 0.0 || here > before || here > after {
                continue;
            }
            least = least.min(here);
            if here > least + NEAR * self.module {
                continue;
            }
            // On either side, because curves meet at an angle.
            for (i, j) in [(k.saturating_sub(1), k), (k, (k + 1).min(4 * POINTS))] {
                if found[i] >= 0.0 && found[j] >= 0.0 && i < j {
                    least = least.min(least_between(along(i), along(j), shallow).1);
                }
            }
        }
        least
    }

    /// +1 where a greater rotation is more open (right), −1 otherwise.
    pub fn opening(&self) -> f64 {
        -self.side.sense()
    }

    /// The first contact when the free gear is turned in over `pitches` of its own on either side of `near`, in steps of a 200th of a pitch; a step whose
    /// least clearance is inside it is refined.
    pub fn contact(&self, near: f64, pitches: f64) -> Option<f64> {
        let gear = self.assembly.gear(self.assembly.free()).gear();
        let pitch = gear.basic_data().angular_pitch();
        let steps = (400.0 * pitches) as i64;
        let at = |k: i64| near + self.opening() * pitch * (pitches - k as f64 / 200.0);
        // Tip circles may be apart for any direction of the eccentricities.
        let reach = Member::BOTH.map(|member| self.assembly.gear(member).reach());
        if self.pairs.is_empty() || reach[0] + reach[1] < self.assembly.center_distance() {
            return None;
        }
        let mut before = [self.least(at(0)), self.least(at(1))];
        if before[0] < 0.0 {
            return Some(at(0));
        }
        for k in 1..steps {
            if before[1] < 0.0 {
                return Some(self.between(at(k - 1), at(k)));
            }
            let next = self.least(at(k + 1));
            if before[1] <= before[0]
                && before[1] <= next
                && before[1] < 0.05 * self.module
                && let Some(inside) = self.dip(at(k - 1), at(k + 1))
            {
                return Some(self.between(at(k - 1), inside));
            }
            before = [before[1], next];
        }
        None
    }

    /// Steps on the open side, of growing width, from `first` to `pitches` of the free gear, rad.
    pub fn open_steps(&self, first: f64, pitches: f64) -> impl Iterator<Item = f64> {
        let gear = self.assembly.gear(self.assembly.free()).gear();
        let most = pitches * gear.basic_data().angular_pitch();
        // Not finer than a millionth of a pitch: overlap that begins nearer lasts longer, or is visible at `first`.
        let start = first.max(1e-6 * most);
        (1..60)
            .map(move |k| start * 1.5f64.powi(k))
            .take_while(move |&step| step < most)
    }

    /// Least clearance within a 200th of a pitch of `rotation`, by steps.
    pub fn deepest(&self, rotation: f64) -> f64 {
        let gear = self.assembly.gear(self.assembly.free()).gear();
        let width = gear.basic_data().angular_pitch() / 200.0;
        let steps = (-20..=20).map(|k| self.least(rotation + width * f64::from(k) / 20.0));
        steps.fold(f64::INFINITY, f64::min)
    }

    /// A rotation between two at which something overlaps, if any.
    fn dip(&self, low: f64, high: f64) -> Option<f64> {
        let (rotation, least) = least_between(low, high, |rotation| self.least(rotation));
        (least < 0.0).then_some(rotation)
    }

    /// The contact between a clear rotation and an overlapping one.
    pub fn between(&self, clear: f64, over: f64) -> f64 {
        halved(clear, over, 60, |rotation| self.least(rotation) >= 0.0)[1]
    }
}
