//! Special places of the locked flank by Newton's method: opposite normals, ends of the free flank, summits of the height.

use super::{FlankPlace, Heights};

/// Rolls nearer than this are equal, rad: heights between them differ by less than rounding.
pub(super) const SAME_ROLL: f64 = 1e-13;

/// Slope below which the height counts as level, mm/rad: its top is higher by the square of that.
const LEVEL_SLOPE: f64 = 1e-9;

/// Limit of steps to a summit. The width doubles each time, and the ends of a stretch converge superlinearly.
const STEPS_UPHILL: u32 = 40;

/// Greatest angle between the normals of involutes that can meet, rad: less than a right angle.
const WIDEST: f64 = 1.55;

impl Heights<'_> {
    /// The starting place: where the normals of both involutes are opposite, or the nearest such place on both flanks.
    pub(super) fn middle(&self, start: f64) -> Option<FlankPlace> {
        let (low, high) = self.locked.range;
        let (free_low, free_high) = self.free.range;
        let mut look = self.look(start.clamp(low, high))?;
        for _ in 0..8 {
            let rate = 1.0 - look.follows;
            let x = (look.x - look.sin.atan2(look.cos) / rate).clamp(low, high);
            // The bounds hold from any place.
            if (x - look.x).abs() < 1e-3 {
                break;
            }
            look = self.look(x)?;
        }
        if !self.reaches(&look) {
            look = self.at_free_roll(look, look.y.clamp(free_low, free_high))?;
        }
        // The normals of the involutes turn no further than both rolls.
        let rest = high - low + free_high - free_low;
        (look.sin.atan2(look.cos).abs() + rest < WIDEST).then_some(look)
    }

    /// The place that faces a roll of the free flank, by Newton's method from `look`; `None` if the locked flank has none.
    fn at_free_roll(&self, mut look: FlankPlace, roll: f64) -> Option<FlankPlace> {
        let (low, high) = self.locked.range;
        for _ in 0..16 {
            let x = look.x + (roll - look.y) / look.follows;
            if !(x >= low && x <= high) {
                return None;
            }
            let by = (x - look.x).abs();
            look = self.look(x)?;
            if by <= SAME_ROLL {
                return Some(look);
            }
        }
        None
    }

    /// Whether no part of the free flank faces the locked one past a place, in the sense `on`.
    pub(super) fn leaves(&self, look: &FlankPlace, on: f64) -> bool {
        let (low, high) = self.free.range;
        if on > 0.0 {
            look.y <= low + SAME_ROLL
        } else {
            look.y >= high - SAME_ROLL
        }
    }

    /// A roll between `look` and `width` further on at which to divide: the end of the free flank if it lies between, otherwise the middle.
    pub(super) fn division(&self, look: &FlankPlace, on: f64, width: f64) -> f64 {
        let (low, high) = self.free.range;
        let end = if on > 0.0 { low } else { high };
        let there = look.y + on * width * look.follows;
        if (there - end) * on < 0.0
            && let Some(at_end) = self.at_free_roll(*look, end)
            && (at_end.x - look.x) * on > 0.0
            && (at_end.x - look.x) * on < width
        {
            return at_end.x;
        }
        look.x + 0.5 * on * width
    }

    /// The level place next to `look` by Newton's method, within the width of `step`; `None` if it leads further away, or to a minimum.
    fn level_place(&self, look: FlankPlace, step: f64) -> Option<FlankPlace> {
        let (low, high) = self.locked.range;
        let mut there = look;
        for _ in 0..8 {
            let bend = self.bend(&there);
            let by = -there.slope / bend;
            let x = there.x + by;
            if !(bend < 0.0 && (x - look.x).abs() <= step && x >= low && x <= high) {
                return None;
            }
            // The square of this is negligible.
            if by.abs() < 1e-9 {
                return Some(there);
            }
            there = self.look(x)?;
            if !self.reaches(&there) {
                return None;
            }
        }
        None
    }

    /// The next summit uphill of `look`, no further away than a few times `step` or the end of a flank.
    pub(super) fn summit(&self, look: FlankPlace, step: f64) -> Option<FlankPlace> {
        if let Some(there) = self.level_place(look, step)
            && there.height >= look.height
        {
            return Some(there);
        }
        let on = 1f64.copysign(look.slope);
        let (low, high) = self.locked.range;
        let (mut near, mut width) = (look, 0.25 * step);
        let mut far = None;
        for _ in 0..STEPS_UPHILL {
            let x = (near.x + on * width).clamp(low, high);
            if x == near.x {
                return Some(near);
            }
            let mut there = self.look(x)?;
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
            let there = self.look(x)?;
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
        let all = [look, near, far].into_iter();
        all.max_by(|a, b| a.height.total_cmp(&b.height))
    }
}
