//! Rectangles around pieces of a path and around runs of pieces. They rule out most pairs of pieces before any curve is evaluated.
//!
//! A rectangle is parallel to the chord of its content, so its width is of second order in its length. A locked
//! rectangle is *behind* a free one at a gap if a straight line divides them with the free one counter-clockwise. Both
//! must be on the side of the axis where the angle of a line grows along any circle from one side of the line to the
//! other. Then at every radius the locked points are clockwise of the free ones.

use super::{C, dot};
use crate::gear::PartCurve;
use std::f64::consts::FRAC_PI_4;

/// A rectangle.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct Rectangle {
    /// Direction of its length.
    along: C,
    /// Its centre along its own axes: `along · middle` from the origin.
    middle: C,
    /// Half its length and half its width, mm.
    half: [f64; 2],
}

impl Rectangle {
    /// The rectangle of a piece of a curve between two parameters, with its points at `point`.
    pub fn new(curve: &PartCurve, (low, high): (f64, f64), point: impl Fn(f64) -> C) -> Rectangle {
        let ends = [low, high].map(&point);
        let chord = ends[1] - ends[0];
        let length = chord.norm_sqr().sqrt();
        let (reach, turn) = curve.spread(low, high);
        // The chord is parallel to a tangent, and tangents are within twice the turn of it. Below a right angle the
        // curve ends where its chord does.
        if !(turn < FRAC_PI_4 && length > 0.0) {
            return Rectangle {
                along: C::ONE,
                middle: point(0.5 * (low + high)),
                half: [reach; 2],
            };
        }
        let (a, b) = curve.bend(high);
        let span = high - low;
        let along = chord / length;
        Rectangle {
            along,
            middle: along.conj() * (ends[0] + ends[1]) * 0.5,
            half: [0.5 * length, (a + b * span) * span * span / 8.0],
        }
    }

    /// Half of its extents along two axes, with its length in the direction `along`, mm.
    #[inline]
    fn extents(&self, along: C) -> [f64; 2] {
        let (cos, sin) = (along.re.abs(), along.im.abs());
        let [length, width] = self.half;
        [length * cos + width * sin, length * sin + width * cos]
    }

    /// A point.
    pub fn point(at: C) -> Rectangle {
        Rectangle {
            along: C::ONE,
            middle: at,
            half: [0.0; 2],
        }
    }

    /// Least and greatest slope `y/x` of its points; `None` unless all have a positive `x`.
    pub fn slopes(&self) -> Option<[f64; 2]> {
        let [length, width] = self.half;
        let corners = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
        let corners =
            corners.map(|(l, w)| self.along * (self.middle + C::new(l * length, w * width)));
        let slopes = corners.map(|corner| corner.im / corner.re);
        let least = slopes.into_iter().fold(f64::INFINITY, f64::min);
        let greatest = slopes.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let are_ahead = corners.iter().all(|corner| corner.re > 0.0);
        are_ahead.then_some([least, greatest])
    }

    /// Its length, mm.
    #[inline]
    pub fn length(&self) -> f64 {
        2.0 * self.half[0]
    }

    /// Its width, mm.
    #[inline]
    pub fn width(&self) -> f64 {
        2.0 * self.half[1]
    }

    /// Direction of its length.
    #[inline]
    pub fn along(&self) -> C {
        self.along
    }

    #[inline]
    pub fn centre(&self) -> C {
        self.along * self.middle
    }

    /// The greatest `P · direction` of its points.
    #[inline]
    pub fn farthest(&self, direction: C) -> f64 {
        let own = self.along.conj() * direction;
        let [length, width] = self.half;
        dot(self.middle, own) + length * own.re.abs() + width * own.im.abs()
    }

    /// The rectangle moved to `centre + direction · X`.
    #[inline]
    pub fn placed(&self, centre: C, direction: C) -> Rectangle {
        let along = direction * self.along;
        Rectangle {
            along,
            middle: self.middle + along.conj() * centre,
            half: self.half,
        }
    }

    /// Its mirror image in the x axis.
    pub fn mirrored(&self) -> Rectangle {
        Rectangle {
            along: self.along.conj(),
            middle: self.middle.conj(),
            half: self.half,
        }
    }

    /// Bounds of the squares of its points' distances from the origin, mm².
    #[inline]
    pub fn squares(&self) -> (f64, f64) {
        let [length, width] = self.half;
        let (along, across) = (self.middle.re.abs(), self.middle.im.abs());
        let nearest = C::new((along - length).max(0.0), (across - width).max(0.0));
        let farthest = C::new(along + length, across + width);
        (nearest.norm_sqr(), farthest.norm_sqr())
    }

    /// Whether its points and those of another rectangle can have one radius, with `room`, mm², for the rounding of their squares.
    pub fn meets(&self, other: &Rectangle, room: f64) -> bool {
        let (own, other) = (self.squares(), other.squares());
        own.0 <= other.1 + room && other.0 <= own.1 + room
    }

    /// Whether its points are within 15° of its centre, seen from the origin.
    #[inline]
    pub fn is_narrow(&self) -> bool {
        let square = self.half[0] * self.half[0] + self.half[1] * self.half[1];
        // sin 15° > 1/4.
        16.0 * square <= self.middle.norm_sqr()
    }

    /// Whether any two points of both, the free one turned by `turned`, are within 120° of each other, seen from the origin.
    #[inline]
    pub fn is_near(&self, free: &Rectangle, turned: C) -> bool {
        let seen = self.along.conj() * turned * free.along * free.middle;
        self.is_narrow() && free.is_narrow() && dot(self.middle, seen) >= 0.0
    }

    /// Whether it is behind a free rectangle that is turned by `turned`, across a line with the unit `normal` out of this one and with
    /// `room`, mm. The points of both are within 60° of the line's direction, so within 120° of each other.
    pub fn is_behind(&self, free: &Rectangle, turned: C, normal: C, room: f64) -> bool {
        let along = -C::i() * normal;
        let is_ahead = |one: &Rectangle, along: C| {
            let least = -one.farthest(-along);
            least > 0.0 && 4.0 * least * least >= one.squares().1
        };
        let back = turned.conj();
        self.farthest(normal) + free.farthest(-normal * back) + room <= 0.0
            && is_ahead(self, along)
            && is_ahead(free, along * back)
    }

    /// Penetration, mm, into a free rectangle that is turned by `turned` and moved `room` nearer. It is measured across
    /// the better dividing line along one of them. A value of at most 0 proves that this rectangle is behind.
    #[inline]
    pub fn beyond(&self, free: &Rectangle, turned: C, room: f64) -> f64 {
        // Along the axes of the locked one; the normal that points counter-clockwise is the second axis or its opposite.
        let along = self.along.conj() * turned * free.along;
        let sign = 1f64.copysign(self.middle.re);
        let seen = along * free.middle;
        let extents = free.extents(along);
        let over = sign * (self.middle.im - seen.im) + self.half[1] + extents[1] + room;
        if over <= 0.0 && self.half[0] < sign * self.middle.re && extents[0] < sign * seen.re {
            return over;
        }
        // Along the axes of the free one.
        let seen = along.conj() * self.middle;
        let sign = 1f64.copysign(seen.re);
        let extents = self.extents(along);
        let other = sign * (seen.im - free.middle.im) + extents[1] + free.half[1] + room;
        if other <= 0.0 && extents[0] < sign * seen.re && free.half[0] < sign * free.middle.re {
            return other;
        }
        // Without proof it does not count as behind.
        match (over > 0.0, other > 0.0) {
            (true, true) => over.min(other),
            (true, false) => over,
            (false, true) => other,
            (false, false) => f64::INFINITY,
        }
    }
}

/// A shape around a piece of a path, or around a run of pieces.
pub(in crate::contact) trait Bounding: Copy {
    /// Pieces of a run that is not divided.
    const FEWEST: usize;

    /// The shape around two consecutive ones.
    fn round(&self, other: &Self) -> Self;
}

impl Bounding for Rectangle {
    const FEWEST: usize = 1;

    fn round(&self, other: &Rectangle) -> Rectangle {
        let between = other.along * other.middle - self.along * self.middle;
        let distance = between.norm();
        let along = if distance > 0.0 {
            between / distance
        } else {
            self.along
        };
        let each = [self, other].map(|it| {
            let turned = along.conj() * it.along;
            (turned * it.middle, it.extents(turned))
        });
        let [(a, b), (c, d)] = each;
        let least = [
            (a.re - b[0]).min(c.re - d[0]),
            (a.im - b[1]).min(c.im - d[1]),
        ];
        let most = [
            (a.re + b[0]).max(c.re + d[0]),
            (a.im + b[1]).max(c.im + d[1]),
        ];
        Rectangle {
            along,
            middle: C::new(least[0] + most[0], least[1] + most[1]) * 0.5,
            half: [0.5 * (most[0] - least[0]), 0.5 * (most[1] - least[1])],
        }
    }
}

/// Shapes around the pieces of a path in order, and around runs of pieces, as a tree.
#[derive(Debug, Clone)]
pub(in crate::contact) struct Tree<S>(Vec<(S, RunContent)>);

/// The content of a run.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) enum RunContent {
    /// Pieces `from..to`; one piece in a tree of rectangles.
    Pieces([usize; 2]),
    /// Two runs.
    Runs([usize; 2]),
}

impl<S: Bounding> Tree<S> {
    /// The tree over pieces in these shapes, in order.
    pub fn new(pieces: &[S]) -> Tree<S> {
        let mut runs = Vec::with_capacity(4 * pieces.len() / (S::FEWEST + 1));
        if !pieces.is_empty() {
            add(&mut runs, pieces, 0);
        }
        Tree(runs)
    }

    /// The run of all pieces, if there are any.
    pub fn whole(&self) -> Option<usize> {
        (!self.0.is_empty()).then_some(0)
    }

    /// The shape around a run.
    #[inline]
    pub fn shape(&self, run: usize) -> &S {
        &self.0[run].0
    }

    /// The content of a run.
    #[inline]
    pub fn inside(&self, run: usize) -> RunContent {
        self.0[run].1
    }

    /// The shapes around all runs.
    pub fn shapes(&self) -> impl Iterator<Item = &S> {
        self.0.iter().map(|(shape, _)| shape)
    }
}

/// Adds the run of these pieces, followed by its content.
fn add<S: Bounding>(runs: &mut Vec<(S, RunContent)>, pieces: &[S], first: usize) -> S {
    let place = runs.len();
    runs.push((pieces[0], RunContent::Pieces([first, first + pieces.len()])));
    let shape = if pieces.len() <= S::FEWEST {
        let rest = pieces[1..].iter();
        rest.fold(pieces[0], |round, piece| round.round(piece))
    } else {
        let (one, other) = pieces.split_at(pieces.len() / 2);
        let round = add(runs, one, first);
        runs[place].1 = RunContent::Runs([place + 1, runs.len()]);
        round.round(&add(runs, other, first + one.len()))
    };
    runs[place].0 = shape;
    shape
}

#[cfg(test)]
mod tests;
