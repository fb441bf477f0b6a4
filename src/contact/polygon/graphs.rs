//! A lower bound of the distance of two curve stretches: each is a graph over one line.
//!
//! A stretch is a graph `y(x)` over a line that both chords nearly follow. Its ends are on the curve. Its tangent is
//! within `θ ≤ β + κ s` of the line, where `β` is the chord's angle to the line, `κ` its greatest curvature and `s` its
//! length. Thus `|y''| = κ/cos³θ ≤ κ (1 + 2 θ²)` for `θ ≤ 1/2`, and by the remainder of linear interpolation
//!
//! ```text
//! |y(x) − chord(x)| ≤ K (x − x_0)(x_1 − x)/2,   K = κ (1 + 2 θ²)
//! ```
//!
//! The gap of the chords less both remainders is a parabola. Two graphs do not meet if it stays above 0 on the `x` they share. The distance
//! of two chords less their errors is a weaker bound: it ignores that curves meet their chords at the ends. The uncertainty of this bound
//! falls with the third power of the length, that of the weaker one with the second.

use nalgebra::{Point2, Vector2};

/// Greatest angle `θ`, rad, for which the bound above holds.
const STEEPEST: f64 = 0.5;

/// Greatest part of a stretch that a cut leaves on either side. It guarantees that the pieces become shorter.
const WIDEST: f64 = 0.25;

/// A stretch of a curve: its ends, mm, and its greatest curvature, 1/mm.
#[derive(Clone, Copy)]
pub(super) struct Stretch<'a> {
    pub ends: &'a [Point2<f64>; 2],
    pub half_length: f64,
    pub curvature: f64,
}

/// A stretch over the line: its chord from `start` to `end`, the chord's height at `start`, its slope, and `K`.
struct Graph {
    start: f64,
    end: f64,
    height: f64,
    slope: f64,
    bend: f64,
}

impl Graph {
    fn chord(&self, x: f64) -> f64 {
        self.height + self.slope * (x - self.start)
    }

    fn remainder(&self, x: f64) -> f64 {
        0.5 * self.bend * (x - self.start) * (self.end - x)
    }

    fn middle(&self) -> f64 {
        0.5 * (self.start + self.end)
    }
}

/// A lower bound of the distance of two stretches, and the place where the bound is least.
#[derive(Clone, Copy)]
pub(super) struct Gap {
    /// Measured across the mean of the chords, mm; 0 or less proves nothing. The distance of the curves is at least 0.75 of it.
    pub width: f64,
    /// Place along the line.
    lowest: f64,
    /// `K_1 + K_2`, 1/mm.
    bend: f64,
    /// Place of each stretch's first end along the line, and its signed length from there.
    runs: [(f64, f64); 2],
}

impl Gap {
    /// Parts of each stretch at which both are best cut where `width` falls short by `missing`, on either side of the
    /// place where it is least.
    ///
    /// Near a touch the gap of two curves is `(K_1 + K_2) t²/2`. Further away than `δ = √(2 d/(K_1 + K_2))` it exceeds
    /// the missing `d`, so the outer pieces are clear. `d` falls with the third power of the length `L`, so the middle
    /// piece is only about `L √L` long. Curves that cross by no more than `d` do so within `δ`.
    pub fn cuts(&self, missing: f64) -> [[f64; 2]; 2] {
        let longest = self.runs[0].1.abs().max(self.runs[1].1.abs());
        let half = (2.0 * missing / self.bend).sqrt().min(WIDEST * longest);
        self.runs.map(|(start, run)| {
            let [middle, half] = [(self.lowest - start) / run, half / run.abs()];
            [middle - half, middle + half]
        })
    }
}

/// A lower bound of the distance of two stretches. `None` if the chords are too steep, or the curves too curved, to be
/// graphs over the mean of the chords.
pub(super) fn gap(first: &Stretch, second: &Stretch) -> Option<Gap> {
    let turn = |stretch: &Stretch| 2.04 * stretch.half_length * stretch.curvature;
    // An arc that turns by at most half a radian is within 2 % of its chord in length.
    let turn = turn(first).max(turn(second));
    if turn > STEEPEST {
        return None;
    }
    // Unit vectors; chords of facing flanks may run either way.
    let first_along = (first.ends[1] - first.ends[0]) * (0.5 / first.half_length);
    let second_along = (second.ends[1] - second.ends[0]) * (0.5 / second.half_length);
    let reversed = first_along.dot(&second_along) < 0.0;
    let second_along = if reversed {
        -second_along
    } else {
        second_along
    };
    // Each chord is at half the angle between them from their mean, and `sin 2β ≤ 0.8` implies `β ≤ 0.6 sin 2β`.
    let sine = first_along.perp(&second_along).abs();
    let steep = 0.6 * sine + turn;
    if sine > 0.8 || steep > STEEPEST {
        return None;
    }
    // Its length is `cos β`, which scales all measures along it; a curvature grows by `1/cos β ≤ 1 + 0.6 β²`.
    let along = 0.5 * (first_along + second_along);
    let bending = 1.0 + 3.2 * steep * steep;
    let origin = first.ends[0];
    let graph = |stretch: &Stretch, reversed: bool| {
        let [from, to] = if reversed {
            [stretch.ends[1], stretch.ends[0]]
        } else {
            *stretch.ends
        };
        let (from, run): (Vector2<f64>, _) = (from - origin, to - from);
        let (start, run, rise) = (along.dot(&from), along.dot(&run), along.perp(&run));
        Graph {
            start,
            end: start + run,
            height: along.perp(&from),
            slope: rise / run,
            bend: stretch.curvature * bending,
        }
    };
    let (one, other) = (graph(first, false), graph(second, reversed));
    let (from, to) = (one.start.max(other.start), one.end.min(other.end));
    let bend = one.bend + other.bend;
    let run = |graph: &Graph, reversed: bool| {
        if reversed {
            (graph.end, graph.start - graph.end)
        } else {
            (graph.start, graph.end - graph.start)
        }
    };
    let at = |width: f64, lowest: f64| Gap {
        width,
        lowest,
        bend,
        runs: [run(&one, false), run(&other, reversed)],
    };
    if from > to {
        return Some(at(from - to, from));
    }
    let apart = |x: f64| other.chord(x) - one.chord(x);
    let side = apart(0.5 * (from + to)).signum();
    // The parabola opens upward, with the curvature K_1 + K_2.
    let slope = side * (other.slope - one.slope);
    let level = one.bend * one.middle() + other.bend * other.middle() - slope;
    // Parallel lines give 0/0: any place will do.
    let lowest = (level / bend).max(from).min(to);
    let width = side * apart(lowest) - one.remainder(lowest) - other.remainder(lowest);
    Some(at(width, lowest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2 as UP;

    /// An arc of the circle about `(0, y)` from one angle to another, with its exact curvature.
    fn arc(y: f64, radius: f64, angles: [f64; 2]) -> ([Point2<f64>; 2], f64) {
        let at = |angle: f64| Point2::new(radius * angle.cos(), y + radius * angle.sin());
        (angles.map(at), 1.0 / radius)
    }

    fn stretch(arc: &([Point2<f64>; 2], f64), bent: f64) -> Stretch<'_> {
        Stretch {
            ends: &arc.0,
            half_length: 0.5 * (arc.0[1] - arc.0[0]).norm(),
            curvature: bent * arc.1,
        }
    }

    /// Two circles of radius 10 and 20 bulge towards each other with the least distance `d`, or overlap. Their gap is not above `d`, and
    /// below it by the third order at most. Source: the closed form of their distance. Neighbours on either side of the contact share
    /// one `x`, where their ends are apart.
    #[test]
    fn the_gap_of_arcs_is_exact_to_the_third_order() {
        let facing = |half: f64| {
            [
                [UP - half, UP + 0.9 * half],
                [-UP - 0.45 * half, -UP + half],
            ]
        };
        for (half, distance, loss) in [
            (0.1, 3e-2, 2e-2),
            (0.01, 1e-5, 2e-6),
            (0.001, 1e-8, 2e-10),
            (0.1, -1e-6, 1.0),
            (0.01, 0.0, 1.0),
            (0.001, -1e-12, 1.0),
        ] {
            let [own, mate] = facing(half);
            let first = arc(-10.0, 10.0, own);
            let second = arc(20.0 + distance, 20.0, mate);
            for second in [second, ([second.0[1], second.0[0]], second.1)] {
                for [one, other] in [[&first, &second], [&second, &first]] {
                    let gap = gap(&stretch(one, 1.0), &stretch(other, 1.0)).unwrap();
                    let short = distance - gap.width;
                    assert!(
                        (-1e-14..=loss).contains(&short),
                        "{half} {distance}: {short}"
                    );
                }
            }
        }
        let first = arc(-10.0, 10.0, [UP + 0.01, UP + 0.03]);
        let second = arc(20.0, 20.0, [-UP - 0.005, -UP + 0.005]);
        let beside = gap(&stretch(&first, 1.0), &stretch(&second, 1.0));
        assert!(beside.unwrap().width > 0.0);
    }

    /// An arc touches another; its curvature is known only to a factor of 1.02, as for an involute. After a cut where
    /// the bound says, the outer pieces are clear, and the middle ones are shorter than halves.
    #[test]
    fn a_cut_leaves_clear_pieces_outside() {
        for half in [0.1, 0.01, 0.001] {
            let own = [UP - half, UP + 0.8 * half];
            let mate = [-UP + 0.4 * half, -UP - 0.5 * half];
            let judged = |first: [f64; 2], second: [f64; 2]| {
                let part = |ends: [f64; 2], part: f64| ends[0] + part * (ends[1] - ends[0]);
                let first = arc(-10.0, 10.0, first.map(|at| part(own, at)));
                let second = arc(20.0, 20.0, second.map(|at| part(mate, at)));
                gap(&stretch(&first, 1.02), &stretch(&second, 1.02)).unwrap()
            };
            let whole = judged([0.0, 1.0], [0.0, 1.0]);
            assert!(whole.width < 0.0);
            let [a, b] = whole.cuts(-whole.width);
            assert!(a[0] > 0.0 && a[1] < 1.0 && a[1] - a[0] < 0.4, "{a:?}");
            for (first, second) in [
                ([0.0, a[0]], [0.0, b[0]]),
                ([0.0, a[0]], b),
                (a, [0.0, b[0]]),
                (a, [b[1], 1.0]),
                ([a[1], 1.0], b),
                ([a[1], 1.0], [b[1], 1.0]),
            ] {
                let width = judged(first, second).width;
                assert!(width > 0.0, "{half}: {width}");
            }
        }
    }

    #[test]
    fn curves_that_are_no_graph_have_no_bound() {
        let first = arc(0.0, 1.0, [0.0, 0.3]);
        let bent = arc(0.0, 0.2, [3.0, 3.3]);
        let level = arc(3.0, 10.0, [-1.6, -1.55]);
        for (second, curvature) in [(level, 1.0), (bent, 20.0)] {
            assert!(gap(&stretch(&first, 1.0), &stretch(&second, curvature)).is_none());
        }
    }
}
