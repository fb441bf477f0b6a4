//! Branch and bound over any pair of curves: slow, but simple to verify.
//!
//! Two half teeth are at their positions in a pose, counted from the free gear's axis. A locked point `P` and a free
//! point `Q` meet if `|P| = |Q| = ρ`, at the free gear's rotation `arg(P · conj Q)`, the *gap*. The contact of the
//! right side is the greatest gap. A node is a pair of arcs. Let `σ = ρ dθ/dρ = tan ψ`, with `ψ` the angle between
//! tangent and radius. Over `ln ρ` the gap has the slope `σ_locked − σ_free`. So:
//!
//! - A node whose radii do not overlap, or whose greatest gap is below one already found, is empty.
//! - If both arcs are monotone in `ρ` and their `ψ` do not overlap, the gap is monotone. It is greatest at an end of the
//!   common radii, and one evaluation settles the node.
//! - If their `ψ` overlap, the gap exceeds that at one radius by at most (slope) × (length in ln ρ). This is of second order
//!   in the arc's length, so a few dozen nodes close a smooth maximum.
//! - If both curvatures are known and make the gap concave over `ln ρ`, its one maximum is at the root of its slope. If they
//!   make it convex, it is greatest at an end: `dσ/d ln ρ = (κρ − sin ψ)/cos³ ψ`, because `dψ/ds = κ − sin ψ/ρ` and
//!   `dρ/ds = cos ψ`.
//! - Any other node is cut in two.
//!
//! All bounds use the distance and turn of the curve from its middle ([`crate::gear::PartCurve::spread`]). They assume
//! nothing else about the curves' shape.

use super::{C, Origin, PlacedCurve, length, slope};
use std::cell::Cell;
use std::f64::consts::{FRAC_PI_2, PI};

/// Nodes of one side of a pose, over all its pairs, after which its contact counts as lost. A node takes about 0.3 µs.
/// Both sides share the budget of the pose ([`crate::contact::Effort`]).
pub(in crate::contact) const MOST_NODES: usize = 150_000;

/// Newton steps for a point at a radius that count as one node. Half a dozen are usual, a few dozen where a fillet ends level.
const STEPS_A_NODE: usize = 5;

/// Angle, rad, below which an arc counts as a point: a few units in the last place of a parameter of order 1. (Arcs
/// that cannot be cut any more never reach a finer one.)
const FINEST: f64 = 16.0 * f64::EPSILON;

/// A piece of a curve with its bounds.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct CurveArc<'a> {
    placed: PlacedCurve<'a>,
    /// The caller's index of the curve.
    name: usize,
    low: f64,
    high: f64,
    /// Points at both ends, and in the middle of its parameters.
    ends: [C; 2],
    middle: C,
    /// Radius about its middle that contains it.
    reach: f64,
    /// Angle from the axis that contains it, to either side of its middle.
    swing: f64,
    radii: (f64, f64),
    /// Bounds of `ψ` where the arc is monotone in `ρ`, and whether `ρ` rises with the parameter.
    slope: Option<(f64, f64, bool)>,
    /// Bounds of the curvature `κ` along rising `ρ`, 1/mm, where the arc is monotone and they are known.
    curvature: Option<(f64, f64)>,
}

impl<'a> CurveArc<'a> {
    /// `placed` from parameter `low` to `high`.
    pub fn new(placed: PlacedCurve<'a>, name: usize, low: f64, high: f64) -> CurveArc<'a> {
        let ends = [low, high].map(|t| placed.at(t).point);
        CurveArc::between(placed, name, [low, high], ends)
    }

    /// As [`CurveArc::new`]; `ends` are the points at both parameters.
    fn between(
        placed: PlacedCurve<'a>,
        name: usize,
        [low, high]: [f64; 2],
        ends: [C; 2],
    ) -> CurveArc<'a> {
        let sample = placed.at(0.5 * (low + high));
        let (reach, turn) = placed.curve.spread(low, high);
        let radius = length(sample.point);
        let swing = if reach < radius {
            (reach / radius).asin()
        } else {
            PI
        };
        // z = tangent/radius direction; of its two senses the one with rising ρ.
        let z = C::i() * sample.normal * sample.point.conj();
        let psi = (z.im * z.re.signum()).atan2(z.re.abs());
        let play = turn + swing;
        let mut arc = CurveArc {
            placed,
            name,
            low,
            high,
            ends,
            middle: sample.point,
            reach,
            swing,
            radii: (radius - reach, radius + reach),
            slope: None,
            curvature: None,
        };
        let far = ends.map(length);
        if low == high {
            arc.slope = Some((0.0, 0.0, true));
        } else if psi.abs() + play < FRAC_PI_2 {
            arc.radii = (far[0].min(far[1]), far[0].max(far[1]));
            arc.slope = Some((psi - play, psi + play, far[0] <= far[1]));
            let curvature = placed.curve.convexity(low, high);
            // The metal is on the left of `i n`, which may be the falling direction.
            arc.curvature = curvature.map(|(least, most)| {
                if z.re > 0.0 {
                    (least, most)
                } else {
                    (-most, -least)
                }
            });
        } else {
            // It leaves its chord by at most `(A + B Δ) Δ²/8`. Where it runs round the axis, its radii vary no more than that.
            let length = high - low;
            let (a, b) = placed.curve.bend(high);
            let off = (a + b * length) * length * length / 8.0;
            let (least, most) = chord_radii(ends, far);
            arc.radii.0 = arc.radii.0.max(least - off);
            arc.radii.1 = arc.radii.1.min(most + off);
        }
        arc
    }

    /// Bounds of `dσ/d ln ρ = (κρ − sin ψ)/cos³ ψ` between two radii, where they are known.
    fn slope_change(&self, inner: f64, outer: f64) -> Option<(f64, f64)> {
        let ((low, high, _), (least, most)) = (self.slope?, self.curvature?);
        let (sines, cosines) = ([low.sin(), high.sin()], [low.cos(), high.cos()]);
        let by = |curvature: f64| [curvature * inner, curvature * outer];
        let least = f64::min(by(least)[0], by(least)[1]) - sines[1];
        let most = f64::max(by(most)[0], by(most)[1]) - sines[0];
        // Where ψ can be 0 the cosine can be 1.
        let nearest = if low <= 0.0 && high >= 0.0 {
            1.0
        } else {
            cosines[0].max(cosines[1])
        };
        let steepest = cosines[0].min(cosines[1]);
        let over = |cos: f64| 1.0 / (cos * cos * cos);
        let scaled = |bound: f64, wide: bool| bound * over(if wide { steepest } else { nearest });
        Some((scaled(least, least < 0.0), scaled(most, most > 0.0)))
    }

    /// Whether both can have points at one radius.
    pub fn meets(&self, other: &CurveArc) -> bool {
        self.radii.0.max(other.radii.0) <= self.radii.1.min(other.radii.1)
    }

    /// Bounds of the gap with a free arc from `origin`, rad. The greatest gap is at most the second and at least the
    /// first, which is −∞ unless they are known to meet.
    pub fn gap_with(&self, free: &CurveArc, origin: Origin) -> (f64, f64) {
        let play = self.swing + free.swing;
        let middle = origin.gap(self.middle * free.middle.conj());
        // More than half a turn counts from the other side.
        if (middle - origin.about).abs() + play >= PI {
            return (f64::NEG_INFINITY, origin.about + PI);
        }
        let meet = self.slope.is_some() && free.slope.is_some();
        let least = if meet {
            middle - play
        } else {
            f64::NEG_INFINITY
        };
        (least, middle + play)
    }

    fn middle_parameter(&self) -> f64 {
        0.5 * (self.low + self.high)
    }

    /// Whether a parameter lies between its ends.
    fn can_be_cut(&self) -> bool {
        let middle = self.middle_parameter();
        self.low < middle && middle < self.high
    }

    fn cut(&self) -> [CurveArc<'a>; 2] {
        let (at, middle) = (self.middle_parameter(), self.middle);
        [
            ([self.low, at], [self.ends[0], middle]),
            ([at, self.high], [middle, self.ends[1]]),
        ]
        .map(|(at, ends)| CurveArc::between(self.placed, self.name, at, ends))
    }

    /// The parameter at radius `rho` of a monotone arc, limited to its ends. The steps used are added to `steps`.
    fn at_radius(&self, rho: f64, rising: bool, steps: &Cell<usize>) -> f64 {
        let (inner, outer) = if rising {
            (self.low, self.high)
        } else {
            (self.high, self.low)
        };
        if rho <= self.radii.0 {
            inner
        } else if rho >= self.radii.1 {
            outer
        } else {
            let middle = 0.5 * (inner + outer);
            let (t, taken) = self.placed.invert_counted(rho, [inner, outer], middle);
            steps.set(steps.get() + taken);
            t
        }
    }
}

/// Steps of [`summit`]: halvings alone end at the last bit of a radius.
const SUMMIT_STEPS: u32 = 64;

/// The radius between two at which a gap concave over `ln ρ` is greatest, and how much it can be greater elsewhere, rad. The bound is the
/// tangent: slope times distance to the place where the slope has changed its sign. `steps` counts as in [`CurveArc::at_radius`].
fn summit(
    locked: &CurveArc,
    free: &CurveArc,
    rising: (bool, bool),
    (mut inner, mut outer): (f64, f64),
    steps: &Cell<usize>,
) -> (f64, f64) {
    let rise = |rho: f64| {
        let at =
            |arc: &CurveArc, rising: bool| slope(&arc.placed.at(arc.at_radius(rho, rising, steps)));
        at(locked, rising.0) - at(free, rising.1)
    };
    let (mut low, mut high) = (rise(inner), rise(outer));
    if !(low > 0.0) {
        return (inner, 0.0);
    }
    if !(high < 0.0) {
        return (outer, 0.0);
    }
    let mut best = (inner, f64::INFINITY);
    for step in 0..SUMMIT_STEPS {
        // The chord's root, and every third time the middle, so that the bracket shrinks for any slope.
        let share = if step % 3 == 2 {
            0.5
        } else {
            low / (low - high)
        };
        let rho = inner + (outer - inner) * share;
        let there = rise(rho);
        let (other, found) = if there >= 0.0 {
            (outer, (&mut inner, &mut low))
        } else {
            (inner, (&mut outer, &mut high))
        };
        (*found.0, *found.1) = (rho, there);
        let slack = there.abs() * (other / rho).ln().abs();
        if slack < best.1 {
            best = (rho, slack);
        }
        if slack <= f64::EPSILON || outer <= inner {
            break;
        }
    }
    best
}

/// Least and greatest distance of a chord from the origin, given those of its ends.
fn chord_radii([from, to]: [C; 2], far: [f64; 2]) -> (f64, f64) {
    let along = to - from;
    let length = along.norm_sqr();
    // The foot of the perpendicular, as a part of the chord.
    let foot = -(from.re * along.re + from.im * along.im) / length;
    let least = if foot > 0.0 && foot < 1.0 {
        self::length(from + along * foot)
    } else {
        far[0].min(far[1])
    };
    (least, far[0].max(far[1]))
}

/// A common point of a locked and a free curve.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct CurveContact {
    /// Gap, rad, from the caller's origin.
    pub gap: f64,
    /// Bound on the error of the search, rad.
    pub slack: f64,
    /// Name and parameter of the locked curve.
    pub locked: (usize, f64),
    /// Name and parameter of the free curve.
    pub free: (usize, f64),
}

/// Pairs of a locked and a free arc that are still to be examined, the last one first. Arcs are large, so each is stored once.
#[derive(Debug, Default)]
pub(in crate::contact) struct OpenPairs<'a> {
    arcs: Vec<CurveArc<'a>>,
    pairs: Vec<ArcPair>,
}

/// A pair of arcs by their indices. Arcs after the first `arcs` belong to later pairs.
#[derive(Debug, Clone, Copy)]
struct ArcPair {
    locked: usize,
    free: usize,
    arcs: usize,
}

impl<'a> OpenPairs<'a> {
    /// Stores an arc for pairs to come, and returns its index.
    pub fn arc(&mut self, arc: CurveArc<'a>) -> usize {
        self.arcs.push(arc);
        self.arcs.len() - 1
    }

    /// Adds the pair of two arcs.
    pub fn add(&mut self, locked: usize, free: usize) {
        let arcs = self.arcs.len();
        self.pairs.push(ArcPair { locked, free, arcs });
    }

    /// Adds each pair of a `locked` and a `free` arc.
    pub fn add_all(
        &mut self,
        locked: impl Iterator<Item = CurveArc<'a>>,
        free: impl Iterator<Item = CurveArc<'a>>,
    ) {
        let free: Vec<usize> = free.map(|arc| self.arc(arc)).collect();
        if free.is_empty() {
            return;
        }
        for arc in locked {
            let arc = self.arc(arc);
            free.iter().for_each(|mate| self.add(arc, *mate));
        }
    }

    fn next(&mut self) -> Option<[usize; 2]> {
        let pair = self.pairs.pop()?;
        self.arcs.truncate(pair.arcs);
        Some([pair.locked, pair.free])
    }
}

/// The greatest gap over pairs of a locked and a free curve, if it exceeds `floor`.
///
/// Gaps count from `origin`. The nodes used are subtracted from `nodes_left`.
///
/// # Errors
/// The names of two curves whose search did not end.
pub(in crate::contact) fn greatest(
    open: &mut OpenPairs,
    origin: Origin,
    floor: f64,
    nodes_left: &mut usize,
) -> Result<Option<CurveContact>, (usize, usize)> {
    let mut best: Option<CurveContact> = None;
    let mut level = floor;
    let steps = Cell::new(0);
    while let Some(pair) = open.next() {
        let [locked, free] = pair.map(|at| &open.arcs[at]);
        if *nodes_left == 0 {
            return Err((locked.name, free.name));
        }
        // The steps belong to the previous node.
        *nodes_left = nodes_left.saturating_sub(1 + steps.take() / STEPS_A_NODE);
        let inner = locked.radii.0.max(free.radii.0);
        let outer = locked.radii.1.min(free.radii.1);
        let play = locked.swing + free.swing;
        // The longer arc is cut. If its ends are adjacent numbers, cutting the other would not end: near a parameter of
        // 0 there is always a finer one.
        let at_locked = locked.reach >= free.reach;
        let longer = if at_locked { locked } else { free };
        if inner > outer || locked.gap_with(free, origin).1 <= level {
            continue;
        }
        let mut record = |t: f64, u: f64, slack: f64| {
            let points = [locked.placed.at(t), free.placed.at(u)].map(|sample| sample.point);
            let gap = origin.gap(points[0] * points[1].conj());
            if gap > level {
                level = gap;
                best = Some(CurveContact {
                    gap,
                    slack,
                    locked: (locked.name, t),
                    free: (free.name, u),
                });
            }
            gap
        };
        if let (Some(a), Some(b)) = (locked.slope, free.slope) {
            let mut meet = |rho: f64, slack: f64| {
                record(
                    locked.at_radius(rho, a.2, &steps),
                    free.at_radius(rho, b.2, &steps),
                    slack,
                )
            };
            if a.0 >= b.1 {
                meet(outer, 0.0);
                continue;
            }
            if a.1 <= b.0 {
                meet(inner, 0.0);
                continue;
            }
            let straight = Some((0.0, 0.0));
            let both_straight =
                |a: Option<(f64, f64)>| a.map(|(l, m)| (l.abs(), m.abs())) == straight;
            if both_straight(locked.curvature) && both_straight(free.curvature) {
                // `sin ψ = d/ρ` with the line's distance `d` from the axis: the sign of the difference of slopes is constant.
                meet(inner, 0.0);
                meet(outer, 0.0);
                continue;
            }
            let changes = locked
                .slope_change(inner, outer)
                .zip(free.slope_change(inner, outer));
            let changes = changes.map(|(locked, free)| (locked.0 - free.1, locked.1 - free.0));
            if changes.is_some_and(|(least, _)| least > 0.0) {
                // Convex over ln ρ: greatest at an end.
                meet(inner, 0.0);
                meet(outer, 0.0);
                continue;
            }
            if changes.is_some_and(|(_, most)| most < 0.0) {
                let (rho, slack) = summit(locked, free, (a.2, b.2), (inner, outer), &steps);
                meet(rho, slack);
                continue;
            }
            let slope = (a.1.tan() - b.0.tan()).max(b.1.tan() - a.0.tan());
            let rise = slope * (outer - inner) / inner;
            let slack = if longer.can_be_cut() { 0.0 } else { rise };
            let gap = meet(0.5 * (inner + outer), slack.max(f64::EPSILON));
            if gap + rise - slack <= level + f64::EPSILON {
                continue;
            }
        } else if play <= FINEST || !longer.can_be_cut() {
            record(locked.middle_parameter(), free.middle_parameter(), play);
            continue;
        }
        let halves = longer.cut();
        let bounds = halves.each_ref().map(|half| {
            let (locked, free) = if at_locked {
                (half, free)
            } else {
                (locked, half)
            };
            let meets = locked.meets(free);
            meets.then(|| locked.gap_with(free, origin).1)
        });
        // The half that can have the greater gap goes last, because the last is taken first. Along a curve that runs
        // round the axis the gap grows.
        let order: [usize; 2] = if bounds[0] > bounds[1] {
            [1, 0]
        } else {
            [0, 1]
        };
        let is_open = |&half: &usize| bounds[half].is_some_and(|bound| bound > level);
        for half in order.into_iter().filter(is_open) {
            let half = open.arc(halves[half]);
            if at_locked {
                open.add(half, pair[1]);
            } else {
                open.add(pair[0], half);
            }
        }
    }
    *nodes_left = nodes_left.saturating_sub(steps.take() / STEPS_A_NODE);
    open.arcs.clear();
    Ok(best)
}

#[cfg(test)]
mod tests;
