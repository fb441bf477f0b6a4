//! The greatest gap of two flanks with any deviation, by bounds of their height.
//!
//! Hold the free gear at a gap, and let a point of the plane have the roll `η_F` and the string length `s_F` of the
//! free base circle. The point is `a = s_F − r_F η_F` outside the free involute, and in the free metal if the deviation
//! `δ_F` is above `a`. Along the locked flank, with roll `x` and string length `s = r_L x + δ_L`, let
//!
//! ```text
//! D(x) = δ_F(y) − a,    y = η_F at the locked point,
//! ```
//!
//! be the *height*. At that gap the flanks are clear of each other if it is nowhere above 0. With `η` the angle between
//! the normals of both involutes
//!
//! ```text
//! y' = −(s cos η + δ_L' sin η)/s_F;    η' = 1 − y';    s_F' = s sin η − δ_L' cos η + r_F y';
//! D' = δ_L' cos η − s sin η + δ_F' y';
//! D'' = δ_L'' cos η − δ_L' sin η η' + δ_F'' y'² + δ_F' y'' − (r_L + δ_L') sin η − s cos η η'.
//! ```
//!
//! Along a locked involute with a constant deviation `q`, the length `a` has the slope `s sin η`, and `η` rises. From the place where `η`
//! is 0, `a` rises to both sides. The string length is a convex function of the place. So a locked point that is `δ_L − q` further out has
//! an `a` that is less by at most `(δ_L − q) cos η`. This bounds `D` over any rolls ([`Heights::most`]); the second derivative gives a
//! bound that closes the place of contact itself ([`Heights::most_near`]). Newton's method finds opposite normals, ends of the free flank, and
//! summits of the height.

mod search;

use crate::contact::exact::flank_heights::{FlankHeights, amount, deviation};
use crate::contact::exact::placed::PlacedHalf;
use crate::contact::exact::shape::{C, turn};
use crate::gear::{DeviationCurve, ProfilePart};
pub(super) use search::greatest_gap_by_heights;

/// Rolls nearer than this are equal, rad: heights between them differ by less than rounding.
const SAME_ROLL: f64 = 1e-13;

/// Slope below which the height counts as level, mm/rad: its top is higher by the square of that.
const LEVEL_SLOPE: f64 = 1e-9;

/// Limit of steps to a summit. The width doubles each time, and the ends of a stretch converge superlinearly.
const STEPS_UPHILL: u32 = 40;

/// Greatest angle between the normals of involutes that can meet, rad: less than a right angle.
const WIDEST: f64 = 1.55;

/// Two flanks with the free gear held at a gap.
struct Heights<'a> {
    /// From the frame of the locked tooth to that of the free one.
    centre: C,
    direction: C,
    locked: Flank<'a>,
    free: Flank<'a>,
}

#[derive(Clone, Copy)]
struct Flank<'a> {
    base: f64,
    half_base: f64,
    deviation: Option<&'a DeviationCurve>,
    heights: &'a FlankHeights,
    range: (f64, f64),
}

impl<'a> Flank<'a> {
    fn new(half: &PlacedHalf<'a>) -> Option<Flank<'a>> {
        let part = half.shape.part(ProfilePart::Involute);
        Some(Flank {
            base: half.shape.base,
            half_base: half.shape.half_base,
            deviation: deviation(part),
            heights: half.shape.flank_heights()?,
            range: part.range(),
        })
    }

    #[inline]
    fn jet(&self, xi: f64) -> [f64; 3] {
        self.deviation.map_or([0.0; 3], |curve| curve.jet(xi))
    }

    fn bounds(&self, from: f64, to: f64) -> [[f64; 2]; 3] {
        let bounds = |curve: &DeviationCurve| curve.bounds(from, to);
        self.deviation.map_or([[0.0; 2]; 3], bounds)
    }
}

/// A place of the locked flank.
#[derive(Debug, Clone, Copy)]
struct FlankPlace {
    x: f64,
    /// `δ_L` and its derivatives.
    own: [f64; 3],
    /// `s`, `|P|`, `s_F`, `a`, mm.
    arm: f64,
    radius: f64,
    reach: f64,
    room: f64,
    sin: f64,
    cos: f64,
    y: f64,
    /// `y'`.
    follows: f64,
    /// The derivatives of `δ_F`.
    mate: [f64; 2],
    /// `D` and `D'`.
    height: f64,
    slope: f64,
}

impl Heights<'_> {
    /// A place of the locked flank; `None` inside the free base circle.
    fn place(&self, x: f64) -> Option<FlankPlace> {
        let (locked, free) = (&self.locked, &self.free);
        let own = locked.jet(x);
        let [out, out_slope, _] = own;
        let arm = locked.base * x + out;
        let along = turn(x - locked.half_base);
        let point = self.centre + self.direction * (along * C::new(locked.base, -arm));
        let square = point.norm_sqr();
        let reach = square - free.base * free.base;
        if !(reach > 0.0) {
            return None;
        }
        let reach = reach.sqrt();
        // Direction of the string's end on the base circle.
        let end = point * C::new(free.base, reach);
        let y = end.im.atan2(end.re) + free.half_base;
        let between = self.direction * along * end.conj() / square;
        let (sin, cos) = (-between.im, -between.re);
        let [mate, mate_slope, mate_second] = free.jet(y);
        let follows = -(arm * cos + out_slope * sin) / reach;
        let room = reach - free.base * y;
        Some(FlankPlace {
            x,
            own,
            arm,
            radius: square.sqrt(),
            reach,
            room,
            sin,
            cos,
            y,
            follows,
            mate: [mate_slope, mate_second],
            height: mate - room,
            slope: out_slope * cos - arm * sin + mate_slope * follows,
        })
    }

    /// `D''`, mm/rad².
    fn bend(&self, place: &FlankPlace) -> f64 {
        let [_, slope, second] = place.own;
        let [mate_slope, mate_second] = place.mate;
        let FlankPlace {
            arm,
            reach,
            sin,
            cos,
            follows,
            ..
        } = *place;
        let (base, turning) = (self.locked.base, 1.0 - follows);
        let along = arm * cos + slope * sin;
        let along_rate =
            (base + slope) * cos - arm * sin * turning + second * sin + slope * cos * turning;
        let reach_rate = arm * sin - slope * cos + self.free.base * follows;
        let bow = (along * reach_rate / reach - along_rate) / reach;
        second * cos - slope * sin * turning + mate_second * follows * follows + mate_slope * bow
            - (base + slope) * sin
            - arm * cos * turning
    }

    /// Whether the free flank extends to a place.
    fn reaches(&self, place: &FlankPlace) -> bool {
        let (low, high) = self.free.range;
        place.y >= low && place.y <= high
    }

    /// Rolls of the free flank that face those of the locked one from `place` on by `width` in the sense `on`, and the
    /// least `s_F` there. The points move by at most `travel` mm in that sense and deviate by up to `off` more or less.
    /// The whole flank if the rolls are unknown; `None` if it has none of them.
    fn facing(
        &self,
        place: &FlankPlace,
        on: f64,
        [width, travel, arm, off]: [f64; 4],
    ) -> Option<([f64; 2], f64)> {
        let (low, high) = self.free.range;
        let nearest = place.radius - travel;
        let square = nearest * nearest - self.free.base * self.free.base;
        let (faced, reach) = if nearest > 0.0 && square > 100.0 * off * off {
            let reach = square.sqrt();
            let follows = arm / reach;
            let sin = (place.sin.abs() + width * (1.0 + follows)).min(1.0);
            // Further out along the string the roll changes by sin η/s_F per length; `s_F` is less by at most a tenth.
            let play = 1.5 * off * (sin + off / reach) / reach;
            let by = width * follows;
            let faced = if on > 0.0 {
                [place.y - by - play, place.y + play]
            } else {
                [place.y - play, place.y + by + play]
            };
            (faced, reach)
        } else {
            ([low, high], 0.0)
        };
        let faced = [faced[0].max(low), faced[1].min(high)];
        (faced[0] <= faced[1]).then_some((faced, reach))
    }

    /// A bound of the height from `place` on by `width` in the sense `on`, from the involute with the deviation at `place`.
    fn most(&self, place: &FlankPlace, on: f64, width: f64) -> f64 {
        let ends = [place.x, place.x + on * width];
        let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let [greatest, least] = self.locked.heights.whole();
        let arm = self.locked.base * to + place.own[0];
        let measures = [width, arm * width, arm, greatest - least];
        let Some((faced, _)) = self.facing(place, on, measures) else {
            return f64::NEG_INFINITY;
        };
        let beyond = self.locked.heights.most(from, to) - place.own[0];
        let mate = self.free.heights.most(faced[0], faced[1]);
        mate + beyond.max(0.0) - place.room + self.falls(place, on, arm, width)
    }

    /// Greatest fall of `a` from `place` on.
    fn falls(&self, place: &FlankPlace, on: f64, arm: f64, width: f64) -> f64 {
        (-place.sin * on).max(0.0) * arm * width
    }

    /// Whether nothing from `place` on, to the flank's end at `width`, is as high as `level`.
    fn is_past(&self, place: &FlankPlace, on: f64, width: f64, level: f64) -> bool {
        let arm = self.locked.base * self.locked.range.1 + place.own[0];
        let [greatest, _] = self.locked.heights.whole();
        let [mate, _] = self.free.heights.whole();
        let beyond = (greatest - place.own[0]).max(0.0);
        mate + beyond - place.room + self.falls(place, on, arm, width) <= level
    }

    /// A bound of the height from `place` on by `width` in the sense `on`, from a bound of its second derivative.
    fn most_near(&self, place: &FlankPlace, on: f64, width: f64) -> f64 {
        let ends = [place.x, place.x + on * width];
        let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let [outs, slopes, seconds] = self.locked.bounds(from, to);
        let steepest = amount(slopes);
        let (base, mate_base) = (self.locked.base, self.free.base);
        let (arm, short) = (base * to + outs[1], base * from + outs[0]);
        let travel = (arm + steepest) * width;
        let measures = [width, travel, arm + steepest, 0.0];
        let Some((faced, reach)) = self.facing(place, on, measures) else {
            return f64::NEG_INFINITY;
        };
        if !(reach > 0.0 && short > 0.0) {
            return f64::INFINITY;
        }
        let [_, mate_slopes, mate_seconds] = self.free.bounds(faced[0], faced[1]);
        let farthest = place.radius + travel;
        let far = (farthest * farthest - mate_base * mate_base).sqrt();
        let follows = (arm + steepest) / reach;
        let turned = width * (1.0 + follows);
        let sin = (place.sin.abs() + turned).min(1.0);
        let cos = (place.cos - turned).max(0.0);
        let follows_least = (short * cos - steepest * sin).max(0.0) / far;
        // A term of either sign: a positive one is greatest with its greatest factor, a negative one with its least.
        let times = |term: f64, least: f64, most: f64| term * if term > 0.0 { most } else { least };
        let own = times(seconds[1], cos, 1.0);
        let squares = [follows_least, follows].map(|rate| rate * rate);
        let mate = times(mate_seconds[1], squares[0], squares[1]);
        // A bound of y''.
        let bow =
            (base + steepest + (arm * sin + steepest) * (1.0 + follows) + amount(seconds) * sin)
                / reach
                + (arm + steepest) * (arm * sin + steepest + mate_base * follows) / (reach * reach);
        let bend = own
            + mate
            + amount(mate_slopes) * bow
            + steepest * sin * (2.0 + follows)
            + base * (turned - place.sin)
            - short * cos * (1.0 + follows_least);
        // Greatest value of height + slope t + curvature t²/2 for t from 0 to the width.
        let slope = place.slope * on;
        let best = if bend < 0.0 {
            (-slope / bend).clamp(0.0, width)
        } else if slope + 0.5 * bend * width > 0.0 {
            width
        } else {
            0.0
        };
        place.height + best * (slope + 0.5 * bend * best)
    }

    /// The starting place: where the normals of both involutes are opposite, or the nearest such place on both flanks.
    fn middle(&self, start: f64) -> Option<FlankPlace> {
        let (low, high) = self.locked.range;
        let (free_low, free_high) = self.free.range;
        let mut place = self.place(start.clamp(low, high))?;
        for _ in 0..8 {
            let rate = 1.0 - place.follows;
            let x = (place.x - place.sin.atan2(place.cos) / rate).clamp(low, high);
            // The bounds hold from any place.
            if (x - place.x).abs() < 1e-3 {
                break;
            }
            place = self.place(x)?;
        }
        if !self.reaches(&place) {
            place = self.at_free_roll(place, place.y.clamp(free_low, free_high))?;
        }
        // The normals of the involutes turn no further than both rolls.
        let rest = high - low + free_high - free_low;
        (place.sin.atan2(place.cos).abs() + rest < WIDEST).then_some(place)
    }

    /// The place that faces a roll of the free flank, by Newton's method from `place`; `None` if the locked flank has none.
    fn at_free_roll(&self, mut place: FlankPlace, roll: f64) -> Option<FlankPlace> {
        let (low, high) = self.locked.range;
        for _ in 0..16 {
            let x = place.x + (roll - place.y) / place.follows;
            if !(x >= low && x <= high) {
                return None;
            }
            let by = (x - place.x).abs();
            place = self.place(x)?;
            if by <= SAME_ROLL {
                return Some(place);
            }
        }
        None
    }

    /// Whether no part of the free flank faces the locked one past a place, in the sense `on`.
    fn leaves(&self, place: &FlankPlace, on: f64) -> bool {
        let (low, high) = self.free.range;
        if on > 0.0 {
            place.y <= low + SAME_ROLL
        } else {
            place.y >= high - SAME_ROLL
        }
    }

    /// A roll between `place` and `width` further on at which to divide: the end of the free flank if it lies between, otherwise the middle.
    fn division(&self, place: &FlankPlace, on: f64, width: f64) -> f64 {
        let (low, high) = self.free.range;
        let end = if on > 0.0 { low } else { high };
        let there = place.y + on * width * place.follows;
        if (there - end) * on < 0.0
            && let Some(at_end) = self.at_free_roll(*place, end)
            && (at_end.x - place.x) * on > 0.0
            && (at_end.x - place.x) * on < width
        {
            return at_end.x;
        }
        place.x + 0.5 * on * width
    }

    /// The level place next to `place` by Newton's method, within the width of `step`; `None` if it leads further away, or to a minimum.
    fn level_place(&self, place: FlankPlace, step: f64) -> Option<FlankPlace> {
        let (low, high) = self.locked.range;
        let mut there = place;
        for _ in 0..8 {
            let bend = self.bend(&there);
            let by = -there.slope / bend;
            let x = there.x + by;
            if !(bend < 0.0 && (x - place.x).abs() <= step && x >= low && x <= high) {
                return None;
            }
            // The square of this is negligible.
            if by.abs() < 1e-9 {
                return Some(there);
            }
            there = self.place(x)?;
            if !self.reaches(&there) {
                return None;
            }
        }
        None
    }

    /// The next summit uphill of `place`, no further away than a few times `step` or the end of a flank.
    fn summit(&self, place: FlankPlace, step: f64) -> Option<FlankPlace> {
        if let Some(there) = self.level_place(place, step)
            && there.height >= place.height
        {
            return Some(there);
        }
        let on = 1f64.copysign(place.slope);
        let (low, high) = self.locked.range;
        let (mut near, mut width) = (place, 0.25 * step);
        let mut far = None;
        for _ in 0..STEPS_UPHILL {
            let x = (near.x + on * width).clamp(low, high);
            if x == near.x {
                return Some(near);
            }
            let mut there = self.place(x)?;
            let mut is_end = false;
            if !self.reaches(&there) {
                let (free_low, free_high) = self.free.range;
                there = self.at_free_roll(near, there.y.clamp(free_low, free_high))?;
                is_end = true;
            }
            if there.slope * on <= 0.0 {
                far = Some(there);
                break;
            }
            if there.height < near.height {
                // Over a summit and down again into a minimum.
                width *= 0.25;
                continue;
            }
            near = there;
            if is_end {
                return Some(near);
            }
        }
        // The root of the chord, halving the weight of an end that stays.
        let mut far = far?;
        let (mut rise, mut fall) = (near.slope * on, far.slope * on);
        for _ in 0..STEPS_UPHILL {
            let share = rise / (rise - fall);
            let x = near.x + (far.x - near.x) * share;
            if (far.x - near.x).abs() <= SAME_ROLL || x == near.x || x == far.x {
                break;
            }
            let there = self.place(x)?;
            let slope = there.slope * on;
            if slope > 0.0 {
                (near, rise, fall) = (there, slope, 0.5 * fall)
            } else {
                (far, fall, rise) = (there, slope, 0.5 * rise)
            }
            if slope.abs() <= LEVEL_SLOPE {
                break;
            }
        }
        let all = [place, near, far].into_iter();
        all.max_by(|a, b| a.height.total_cmp(&b.height))
    }
}

#[cfg(test)]
mod tests;
