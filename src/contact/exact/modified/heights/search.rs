//! The greatest gap of two flanks: samples give the highest place, then bounds prove that none is higher, repeatedly.

use super::{Flank, FlankPlace, Heights, SAME_ROLL};
use crate::contact::exact::candidate::CandidateContact;
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::placed::PlacedHalf;
use crate::contact::exact::shape::turn;
use crate::gear::ProfilePart;

/// Limit of rolls examined for one pair of flanks before the search takes over (tuned: measured traces need about forty).
const MOST_PLACES: u32 = 1000;

/// Limit of rounds that find a higher place (tuned: two are usual).
const MOST_ROUNDS: u32 = 12;

/// Gaps nearer than this have the same contact, rad: its curvature is below 1e4 mm/rad².
const SAME_GAP: f64 = 1e-9;

/// Share of the greatest length below which a height is zero: a few dozen roundings.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Greatest difference of the radii of one point of contact on both flanks, mm.
const SETTLED: f64 = 1e-9;

/// An examination of the flanks at a gap.
struct HeightSearch {
    /// Whether to find the highest place; otherwise whether any place is above the level.
    is_search: bool,
    /// Lower heights do not matter, mm.
    level: f64,
    best: Option<FlankPlace>,
    /// Width, rad, at which a search ends, and below which bounds of second derivatives apply.
    near: f64,
    places_left: u32,
}

impl HeightSearch {
    /// Examines the flank from `from` to the roll `end`, over ever shorter stretches, for heights above the
    /// level. `false` if one is found; `None` after too many places.
    fn examine_towards(&mut self, heights: &Heights, from: FlankPlace, end: f64) -> Option<bool> {
        let on = if end >= from.x { 1.0 } else { -1.0 };
        let (mut place, mut width) = (from, self.near);
        let mut open: Vec<(FlankPlace, f64)> = Vec::with_capacity(16);
        loop {
            let rest = (end - place.x) * on;
            let is_over = !(rest > 0.0) || heights.leaves(&place, on);
            if is_over || heights.is_past(&place, on, rest, self.level) {
                return Some(true);
            }
            open.push((place, width.min(rest)));
            while let Some((place, width)) = open.pop() {
                if heights.leaves(&place, on) || heights.most(&place, on, width) <= self.level {
                    continue;
                }
                let is_near = width <= self.near;
                if is_near && (self.is_search || heights.most_near(&place, on, width) <= self.level)
                {
                    continue;
                }
                let middle = if is_near {
                    heights.division(&place, on, width)
                } else {
                    place.x + 0.5 * on * width
                };
                let half = (middle - place.x) * on;
                if !(half > 0.0 && half < width) {
                    return None;
                }
                // Inside the free base circle the free flank has ended.
                if let Some(there) = heights.place(middle) {
                    if !self.offer(heights, &there)? {
                        return Some(false);
                    }
                    open.push((there, width - half));
                }
                open.push((place, half));
            }
            if !(width < rest) {
                return Some(true);
            }
            let Some(there) = heights.place(place.x + on * width) else {
                return (on > 0.0).then_some(true);
            };
            if !self.offer(heights, &there)? {
                return Some(false);
            }
            place = there;
            width *= 2.0;
        }
    }

    /// Examines the whole flank, from `middle` and from the highest place if it is `known`, as [`HeightSearch::examine_towards`].
    fn examine_flank(
        &mut self,
        heights: &Heights,
        middle: &FlankPlace,
        known: Option<&FlankPlace>,
    ) -> Option<bool> {
        let (low, high) = heights.locked.range;
        let is_clear = match known {
            None => {
                self.examine_towards(heights, *middle, low)?
                    && self.examine_towards(heights, *middle, high)?
            }
            Some(known) => {
                let [away, back] = if known.x >= middle.x {
                    [high, low]
                } else {
                    [low, high]
                };
                self.examine_towards(heights, *known, away)?
                    && self.examine_towards(heights, *known, middle.x)?
                    && self.examine_towards(heights, *middle, back)?
            }
        };
        Some(is_clear)
    }

    /// Counts an examined place. Returns whether to continue; `None` after too many.
    fn offer(&mut self, heights: &Heights, place: &FlankPlace) -> Option<bool> {
        self.places_left = self.places_left.checked_sub(1)?;
        if !(place.height > self.level && heights.reaches(place)) {
            return Some(true);
        }
        self.best = Some(*place);
        if self.is_search {
            self.level = place.height;
        }
        Some(self.is_search)
    }
}

/// The greatest gap above `floor` of the flanks of a step, searched first at the gap `guess`; `None` if it is not settled.
pub(in super::super) fn greatest_gap_by_heights(
    posed: &PosedFlanks,
    step: i64,
    floor: f64,
    guess: f64,
) -> Option<Option<CandidateContact>> {
    let halves = (posed.locked(step), posed.free(step));
    let flanks = [Flank::new(&halves.0)?, Flank::new(&halves.1)?];
    let at = |gap: f64| heights(posed, &halves, flanks, gap);
    let (low, high) = flanks[0].range;
    let mut start = 0.5 * (low + high);
    let near = flanks[0].heights.fine();
    let size = posed.problem.distance + flanks[0].base + flanks[1].base;
    let rounding = ROUNDING * size;
    let mut search = HeightSearch {
        is_search: !floor.is_finite(),
        level: f64::NEG_INFINITY,
        best: None,
        near,
        places_left: MOST_PLACES,
    };
    let mut found: Option<CandidateContact> = None;
    let mut gap = if search.is_search { guess } else { floor };
    for _ in 0..MOST_ROUNDS {
        let heights = at(gap);
        let middle = heights.middle(start)?;
        start = middle.x;
        if !search.is_search {
            search.level = rounding;
            let known = match &found {
                Some(found) => Some(heights.place(found.locked.1)?),
                None => None,
            };
            if search.offer(&heights, &middle)?
                && search.examine_flank(&heights, &middle, known.as_ref())?
            {
                return Some(found);
            }
        }
        // The highest place changes little with the gap.
        search.is_search = true;
        search.offer(&heights, &middle)?;
        search.examine_flank(&heights, &middle, None)?;
        let higher = heights.summit(search.best.take()?, near)?;
        let mut best = touch(posed, step, &halves, &higher)?;
        let mut moved = best.gap - gap;
        // At its own gap the highest place differs; the gap is less by the square of that.
        for _ in 0..3 {
            if moved.abs() < SAME_GAP {
                break;
            }
            let heights = at(best.gap);
            let place = heights.place(best.locked.1)?;
            let again = touch(posed, step, &halves, &heights.summit(place, near)?)?;
            moved = again.gap - best.gap;
            best = again;
        }
        if found.is_some_and(|found| best.gap <= found.gap) || best.gap <= floor {
            return None;
        }
        (gap, found) = (best.gap, Some(best));
        search.is_search = false;
    }
    None
}

/// Both flanks with the free gear held at a gap.
pub(super) fn heights<'a>(
    posed: &PosedFlanks,
    (locked, free): &(PlacedHalf<'a>, PlacedHalf<'a>),
    flanks: [Flank<'a>; 2],
    gap: f64,
) -> Heights<'a> {
    let back = turn(-gap) * posed.origin;
    let own = free.direction.conj();
    Heights {
        centre: (back * locked.centre - free.centre) * own,
        direction: back * locked.direction * own,
        locked: flanks[0],
        free: flanks[1],
    }
}

/// The gap at a place of the locked flank, or at the free flank's end where that ends.
fn touch(
    posed: &PosedFlanks,
    step: i64,
    (locked, free): &(PlacedHalf, PlacedHalf),
    place: &FlankPlace,
) -> Option<CandidateContact> {
    let part = ProfilePart::Involute;
    let radius = |half: &PlacedHalf, t: f64| half.at(part, t).point.norm();
    let (low, high) = free.range(part);
    let (x, y) = if place.y >= high - SAME_ROLL || place.y <= low + SAME_ROLL {
        let y = place.y.clamp(low, high);
        let (inner, outer) = locked.range(part);
        let x = locked.curve(part);
        (x.invert(radius(free, y), [outer, inner], place.x), y)
    } else {
        let y = free.curve(part);
        let rho = radius(locked, place.x);
        (place.x, y.invert(rho, [low, high], place.y))
    };
    let meets = (radius(locked, x) - radius(free, y)).abs() <= SETTLED;
    let slack = 2.0 * ROUNDING * (posed.problem.distance + locked.shape.base + free.shape.base);
    let slack = slack * posed.problem.per_free_base;
    meets.then(|| {
        let origin = posed.origin_of(step);
        CandidateContact::new((locked, (part, x)), (free, (part, y)), origin, slack)
    })
}
