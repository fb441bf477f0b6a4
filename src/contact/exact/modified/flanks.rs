//! Where the flanks of one pair of teeth touch.
//!
//! A convex flank lies on one side of each of its tangents, and of every line through its tip corner within the corner's cone: where two flanks
//! touch from outside along a tangent of both it divides them, so that their gap is nowhere greater. One such place is enough, however it was
//! found: Newton's method finds it. Flanks that are not convex are searched.

use super::{OnLine, OuterGears};
use crate::contact::exact::candidate::{CandidateContact, slope};
use crate::contact::exact::flank_problem::PosedFlanks;
use crate::contact::exact::placed::Placed;
use crate::contact::exact::shape::Sample;
use crate::contact::gap::{Arc, MOST_NODES, Meeting, greatest};
use crate::gear::{Osculating, ProfilePart, smooth};

/// A step this small, of a length, leaves its square: nothing.
const SETTLED: f64 = 1e-9;

/// Newton's method from an outer contact takes three or four.
const STEPS: u32 = 16;

/// How often at most the part of two flanks is doubled that is searched: to all of them from a thousandth.
const WIDENINGS: u32 = 11;

impl OuterGears {
    /// The greatest gap above `floor` of a pair's flanks, by branch and bound over as much of them as their outer gap leaves open; `None` where it
    /// is not settled.
    ///
    /// The outer gap falls from the contact on the line of action to either side: where it is below what was found between, so is all beyond.
    pub(super) fn flanks_within(
        &self,
        posed: &PosedFlanks,
        outer: &PosedFlanks,
        pair: &OnLine,
        floor: f64,
    ) -> Option<Option<CandidateContact>> {
        let part = ProfilePart::Involute;
        let (locked, free) = (posed.locked(pair.step), posed.free(pair.step));
        let (outer_locked, outer_free) = (outer.locked(pair.step), outer.free(pair.step));
        let radius = |half: &Placed, roll: f64| half.at(part, roll).point.norm();
        let (low, high) = outer_locked.range(part);
        let (free_low, free_high) = outer_free.range(part);
        let free_radii = [free_low, free_high].map(|roll| radius(&outer_free, roll));
        let outer_gap = |roll: f64, rho: f64| {
            let start = pair.rolls.1.clamp(free_low, free_high);
            let mate = outer_free
                .curve(part)
                .invert(rho, [free_low, free_high], start);
            let on = ((&outer_locked, (part, roll)), (&outer_free, (part, mate)));
            CandidateContact::new(on.0, on.1, outer.origin, 0.0).gap
        };
        let beyond = outer.free_offset - posed.free_offset;
        // As far as two circles of the flanks' curvatures are apart by what the deviations vary.
        let arm = |half: &Placed, roll: f64| half.shape.base * roll.max(0.01);
        let arms = [
            arm(&outer_locked, pair.rolls.0),
            arm(&outer_free, pair.rolls.1),
        ];
        let away = (2.0 * self.range / (1.0 / arms[0] + 1.0 / arms[1])).sqrt();
        let mut width = away / arms[0];
        let mut nodes_left = MOST_NODES;
        for _ in 0..WIDENINGS {
            let ends = [pair.rolls.0 - width, pair.rolls.0 + width];
            let ends = ends.map(|roll| roll.clamp(low, high));
            // The lower end of a locked flank is farthest from the free axis.
            let radii = ends.map(|roll| radius(&outer_locked, roll));
            let (own_low, own_high) = locked.range(part);
            let from = |end: usize, own: f64, border: f64| match ends[end] == border {
                true => own,
                false => locked
                    .curve(part)
                    .invert(radii[end], [own_high, own_low], ends[end]),
            };
            let on_locked = (from(0, own_low, low), from(1, own_high, high));
            let (mate_low, mate_high) = free.range(part);
            let to = |rho: f64| {
                let start = pair.rolls.1.clamp(mate_low, mate_high);
                free.curve(part).invert(rho, [mate_low, mate_high], start)
            };
            // Where the flank itself ends it does so at another radius than the outer one.
            let reached = [radius(&locked, on_locked.0), radius(&locked, on_locked.1)];
            let on_free = (to(radii[1].min(reached[1])), to(radii[0].max(reached[0])));
            let (locked_arcs, free_arcs) = (arcs(&locked, on_locked), arcs(&free, on_free));
            let nodes = locked_arcs
                .iter()
                .flat_map(|arc| free_arcs.iter().map(move |free| (*arc, *free)));
            let found =
                greatest(&mut nodes.collect(), posed.origin, floor, &mut nodes_left).ok()?;
            let level = found.map_or(floor, |found| found.gap);
            let is_closed = |end: usize| {
                ends[end] == [low, high][end]
                    || [radii[0] >= free_radii[1], radii[1] <= free_radii[0]][end]
                    || outer_gap(ends[end], radii[end]) - beyond <= level
            };
            if is_closed(0) && is_closed(1) {
                let candidate = |found: Meeting| {
                    let on = ((part, found.locked.1), (part, found.free.1));
                    CandidateContact::new((&locked, on.0), (&free, on.1), posed.origin, found.slack)
                };
                return Some(found.map(candidate));
            }
            width *= 2.0;
        }
        None
    }
}

impl PosedFlanks<'_> {
    /// Where the flanks of a pair touch, from where the outer ones would: at a common tangent, or at a tip corner beyond which it lies. `None`
    /// where Newton's method finds none, or one below a flank's lower end.
    pub(super) fn flanks_touch(&self, pair: &OnLine) -> Option<CandidateContact> {
        let (locked, free) = (self.locked(pair.step), self.free(pair.step));
        let ranges = [&locked, &free].map(|half| half.range(ProfilePart::Involute));
        let (mut x, mut y) = pair.rolls;
        let mut settled = false;
        for _ in 0..STEPS {
            let ((p, one), (q, other)) = (locked.flank(x)?, free.flank(y)?);
            let [at_x, at_y] = [Turning::new(&p, &one), Turning::new(&q, &other)];
            // Both at one radius, with opposite normals: where they are not on opposite sides nothing touches from outside.
            let rest = 0.5 * (p.point.norm_sqr() - q.point.norm_sqr());
            let w = p.point.conj() * p.normal * q.point * q.normal.conj();
            if !(w.re < 0.0) {
                return None;
            }
            let turn = (-w.im).atan2(-w.re);
            let determinant = at_y.along * at_x.turn - at_x.along * at_y.turn;
            let by =
                [&at_y, &at_x].map(|there| (rest * there.turn - turn * there.along) / determinant);
            x += by[0] / one.speed;
            y += by[1] / other.speed;
            if by[0].abs().max(by[1].abs()) < SETTLED * self.problem.distance {
                settled = true;
                break;
            }
        }
        let [(low, high), (free_low, free_high)] = ranges;
        // Not of NaN either.
        if !(settled && x >= low && y >= free_low) {
            return None;
        }
        let [over, free_over] = [x > high, y > free_high];
        // The gap is stationary along the flanks, not across them: both are put at one radius.
        let on = |half: &Placed, rho: f64, range: [f64; 2], start: f64| {
            half.curve(ProfilePart::Involute).invert(rho, range, start)
        };
        let radius = |half: &Placed, t: f64| half.at(ProfilePart::Involute, t).point.norm();
        let inward = [high, low];
        match (over, free_over) {
            (true, true) => return None,
            // Newton's last step left no more than its square.
            (false, false) => (),
            (true, false) => {
                (x, y) = (
                    high,
                    on(&free, radius(&locked, high), [free_low, free_high], y),
                )
            }
            (false, true) => (x, y) = (on(&locked, radius(&free, free_high), inward, x), free_high),
        }
        let candidate = CandidateContact::new(
            (&locked, (ProfilePart::Involute, x)),
            (&free, (ProfilePart::Involute, y)),
            self.origin,
            0.0,
        );
        if over || free_over {
            let towards = if over { -1.0 } else { 1.0 };
            let meets = (radius(&locked, x) - radius(&free, y)).abs() <= SETTLED;
            if !(meets && rises(&locked, x, &free, y, towards)) {
                return None;
            }
        }
        Some(candidate)
    }
}

/// A stretch of a flank, cut at its edges.
fn arcs<'a>(half: &Placed<'a>, (low, high): (f64, f64)) -> Vec<Arc<'a>> {
    let curve = half.curve(ProfilePart::Involute);
    let arc = |(low, high)| Arc::new(curve, ProfilePart::Involute as usize, low, high);
    smooth(curve.curve.edges(), low, high).map(arc).collect()
}

/// Whether the gap of two flanks rises still at these rolls, towards greater radii (`towards` 1) or lesser ones (−1): over ln ρ its slope is
/// that of the locked flank less that of the free one.
pub(super) fn rises(locked: &Placed, x: f64, free: &Placed, y: f64, towards: f64) -> bool {
    let slope_at = |half: &Placed, t: f64| slope(&half.at(ProfilePart::Involute, t));
    towards * (slope_at(locked, x) - slope_at(free, y)) > 0.0
}

/// How a step of a length along a flank changes half the square of the radius and the angle between normal and radius.
struct Turning {
    along: f64,
    turn: f64,
}

impl Turning {
    fn new(sample: &Sample, own: &Osculating) -> Turning {
        // P · i n and P · n.
        let z = sample.point.conj() * sample.normal;
        Turning {
            along: -z.im,
            turn: own.curvature - z.re / sample.point.norm_sqr(),
        }
    }
}
