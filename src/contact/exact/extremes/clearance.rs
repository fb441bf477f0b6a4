//! The clearance of a tip corner from its mate's fillet over a stretch of the locked gear's turn, cut where its bound is too weak.

use super::super::line::Line;
use super::super::placed::Role;
use super::super::shape::{C, HalfToothShape, turn};
use super::corner_path::{CornerPath, is_clear_over};
use super::tip_at_fillet::TipAtFillet;

/// Limit of halvings of a stretch (tuned: a part of a pitch of 12 teeth is down to 5 minutes of arc).
pub(super) const HALVINGS: u32 = 5;

/// Two distances of the outlines' centres, and the line of action at each.
#[derive(Debug)]
pub(super) struct LinesAtDistances([(f64, Line); 2]);

impl LinesAtDistances {
    /// The lines at the least and the greatest distance; `None` if base circles with the sum `sum` of radii overlap at one.
    pub fn new((low, high): (f64, f64), sum: f64) -> Option<LinesAtDistances> {
        let line = |distance: f64| Some((distance, Line::new(C::from(distance), sum)?));
        Some(LinesAtDistances([line(low)?, line(high)?]))
    }
}

/// Lower bound of the free gear's further turn from the contact of the involutes to the contact of the corner of `tip` with the fillet, rad;
/// negative if the corner may be first. It holds beside the room of the involutes and their ends.
///
/// The locked half tooth is within `play` of the angle `at`. The two values are for the two distances of the outlines' centres in
/// `lines` ([`LinesAtDistances::new`]); between them the straight line holds. The stretch is
/// halved up to `halvings` times if they do not reach `enough`.
pub(super) fn tip_clearance(
    tip: &TipAtFillet,
    (at, play): (f64, f64),
    lines: &LinesAtDistances,
    enough: f64,
    halvings: u32,
) -> [f64; 2] {
    let [(low, _), (high, _)] = lines.0;
    let cut = RefinedStretch {
        tip,
        lines,
        bend: if high == low {
            0.0
        } else {
            tip.bend(low) * (high - low).powi(2)
        },
    };
    let whole = cut.over(at, play);
    cut.refined((at, play), whole, enough, halvings)
}

/// Whether the corner of `tip` stays clear of the fillet of `mate` while the free gear has `room` more to the contact of the involutes. It must
/// hold at every distance between those of `lines` and every place of the locked half tooth within `play` of the angle `at`.
pub(super) fn stays_clear(
    tip: &TipAtFillet,
    mate: &HalfToothShape,
    (at, play): (f64, f64),
    LinesAtDistances(lines): &LinesAtDistances,
    room: f64,
) -> bool {
    let [(low, _), (high, _)] = *lines;
    let (locked, free) = (&tip.locked, &tip.free);
    let bend = if high == low {
        0.0
    } else {
        tip.bend(low) * (high - low).powi(2)
    };
    let rate = -locked.base / free.base;
    lines.iter().all(|(distance, line)| {
        let path = |at: f64| {
            let l = -turn(at);
            let f = turn(tip.gap(at, line) - (room + bend));
            match tip.owner {
                Role::Free => {
                    let centre = C::from(*distance);
                    CornerPath::of_free(f * free.corner, centre, l, *distance, rate)
                }
                Role::Locked => {
                    CornerPath::of_locked(l * locked.corner, C::ZERO, f, *distance, rate)
                }
            }
        };
        let margins = (1e-14 * distance, room + bend);
        is_clear_over((at, play), 1.0, mate, tip.deepest, margins, &path)
    })
}

/// A stretch of the locked gear's turn that is cut where its bound is too weak.
struct RefinedStretch<'a> {
    tip: &'a TipAtFillet,
    /// The lines at the least and the greatest distance.
    lines: &'a LinesAtDistances,
    /// Curvature of the bound between the distances.
    bend: f64,
}

impl RefinedStretch<'_> {
    /// [`tip_clearance`] with the value `whole` of the uncut stretch, cut at most `halvings` times.
    fn refined(
        &self,
        (at, play): (f64, f64),
        whole: [f64; 2],
        enough: f64,
        halvings: u32,
    ) -> [f64; 2] {
        if halvings == 0 || least(whole) >= enough {
            return whole;
        }
        let half = 0.5 * play;
        let halves = [at - half, at + half].map(|at| ((at, half), self.over(at, half)));
        let [worse, other] = if least(halves[0].1) <= least(halves[1].1) {
            halves
        } else {
            [halves[1], halves[0]]
        };
        let found = self.refined(worse.0, worse.1, enough, halvings - 1);
        // The value of the whole is at most this, so the other half need not exceed it either.
        let enough = enough.min(least(found));
        let beside = self.refined(other.0, other.1, enough, halvings - 1);
        [0, 1].map(|end| found[end].min(beside[end]).max(whole[end]))
    }

    fn over(&self, at: f64, play: f64) -> [f64; 2] {
        let LinesAtDistances([near, far]) = self.lines;
        let end = |line| {
            let (clearance, is_above) = self.tip.at_distance(at, play, line);
            (clearance - self.bend, is_above)
        };
        let (first, leaves) = end(near);
        if near.0 == far.0 {
            return [first; 2];
        }
        let (last, also_leaves) = end(far);
        let ends = [first, last];
        // Between the distances the clearance is above the straight line only while the corner is below the form circle. Where it crosses
        // that circle, the room of the involutes and their ends holds.
        if leaves || also_leaves {
            [least(ends); 2]
        } else {
            ends
        }
    }
}

fn least([a, b]: [f64; 2]) -> f64 {
    a.min(b)
}
