//! A tip corner on its mate's fillet over a stretch of a mating: bounds that close with the square of its length.
//!
//! While the corner `P` is between two radii of the mate, the hollow fillet is inside its chord between these radii, and outside its
//! tangent in their middle. `P` is outside a straight line with the normal `n` through `A` of the mate's frame while
//!
//! ```text
//! s(x, μ) = (Q − A)·n ≥ 0,    Q = P in that frame,
//! ```
//!
//! so `s = 0` gives a rotation `μ` that bounds that of the touch, from above with the chord, from below with the tangent. All its
//! derivatives are lengths of the picture. `|s_xx|`, `|s_xμ|` and `|s_μμ|` are at most the distances of `P` from the axes, and `μ'' =
//! −(s_xx + 2 s_xμ μ' + s_μμ μ'²)/s_μ`.

use super::super::flank_problem::PosedFlanks;
use super::super::path::InvolutePair;
use super::super::placed::Role;
use super::super::shape::{C, HalfToothShape, turn};
use super::corner_path::{CornerPath, around_radius};
use crate::contact::gap::dot;
use crate::gear::ProfilePart;

/// Limit of Newton steps: `s` is a sine of `μ`, near its steepest place (4 are usual).
const STEPS: usize = 20;

/// A straight line of the mate's frame.
#[derive(Debug, Clone, Copy)]
struct StraightLine {
    point: C,
    normal: C,
}

/// The place where the corner reaches a border.
#[derive(Debug, Clone, Copy)]
pub(super) struct BorderTouch {
    pub gap: f64,
    /// Its derivative by the rotation of the locked gear.
    pub slope: f64,
    /// `s_μ`.
    turning: f64,
    /// Radius of the corner about the mate's centre, and its speed in the mate's frame.
    radius: f64,
    speed: f64,
    /// Bounds of `|s_xx|`, `|s_xμ|`, `|s_μμ|`.
    lengths: [f64; 3],
}

/// The corner of a tip and its mate's fillet, at a pose.
#[derive(Debug, Clone, Copy)]
pub(super) struct OnFillet<'a> {
    posed: PosedFlanks<'a>,
    step: i64,
    owner: Role,
}

/// The results of two poses: bounds of the gap at both, its slopes, and the curvature between them.
#[derive(Debug, Clone, Copy)]
pub(super) struct FilletBounds {
    /// Gaps at which the corner is clear of the fillet.
    pub clear: [BorderTouch; 2],
    /// Gaps at which it is in the fillet; `None` if unknown.
    pub inside: Option<[BorderTouch; 2]>,
    /// Bound on the second derivative of any of them by the rotation of the locked gear.
    pub bend: f64,
}

impl<'a> OnFillet<'a> {
    pub fn new(posed: PosedFlanks<'a>, step: i64, owner: Role) -> OnFillet<'a> {
        OnFillet { posed, step, owner }
    }

    fn mate(&self) -> &'a HalfToothShape {
        match self.owner {
            Role::Locked => &self.posed.problem.free.shape,
            Role::Free => &self.posed.problem.locked.shape,
        }
    }

    /// The corner's path past the fillet, at a gap that changes at `rate` with the locked gear's turn.
    pub fn path(&self, gap: f64, rate: f64) -> CornerPath {
        let problem = self.posed.problem;
        let pair = InvolutePair::new(&self.posed, self.step);
        let (locked, free) = (&problem.locked.shape, &problem.free.shape);
        let l = -turn(pair.locked_base + locked.half_base);
        let turned = turn(gap);
        let f = turned * turn(pair.free_base + free.half_base);
        let (centre, free_centre) = (self.posed.centre, turned * self.posed.free_centre);
        let distance = problem.distance;
        match self.owner {
            Role::Free => {
                let corner = free_centre + f * free.tip_corner();
                CornerPath::of_free(corner, centre, l, distance, rate)
            }
            Role::Locked => {
                let corner = centre - distance + l * locked.tip_corner();
                CornerPath::of_locked(corner, free_centre, f, distance, rate)
            }
        }
    }

    /// The place where the corner reaches `border`, searched near the gap `near`; `None` if it does not.
    fn reach(&self, border: StraightLine, near: f64) -> Option<BorderTouch> {
        let problem = self.posed.problem;
        let pair = InvolutePair::new(&self.posed, self.step);
        let (locked, free) = (&problem.locked.shape, &problem.free.shape);
        let l = -turn(pair.locked_base + locked.half_base);
        let f = turn(pair.free_base + free.half_base);
        let (centre, free_centre) = (self.posed.centre, self.posed.free_centre);
        let moving = C::i() * (centre - C::from(problem.distance));
        let along = |z: C| dot(z, border.normal);
        let mut gap = near;
        for _ in 0..STEPS {
            let turned = turn(gap);
            // The corner from the free axis, in the mate's frame, and its derivatives by gap and by the locked rotation.
            let (point, seen, by_gap, by_turn) = match self.owner {
                Role::Free => {
                    let point = turned * (free_centre + f * free.corners()[0].1);
                    let seen = (point - centre) * l.conj();
                    let by_turn = -moving * l.conj() - C::i() * seen;
                    (point, seen, C::i() * point * l.conj(), by_turn)
                }
                Role::Locked => {
                    let own = l * locked.corners()[0].1;
                    let back = turned.conj() * f.conj();
                    let point = centre + own;
                    let seen = point * back - free_centre * f.conj();
                    let by_turn = (moving + C::i() * own) * back;
                    (point, seen, -C::i() * point * back, by_turn)
                }
            };
            let apart = along(seen - border.point);
            let turning = along(by_gap);
            if !(turning > 0.0) {
                return None;
            }
            let step = -apart / turning;
            gap += step;
            if step.abs() < 1e-9 {
                let slope = -along(by_turn) / turning;
                let off = moving.norm();
                let lengths = match self.owner {
                    Role::Free => [3.0 * off + seen.norm(), point.norm(), point.norm()],
                    Role::Locked => {
                        let own = off + locked.tip_radius;
                        [own, own, point.norm()]
                    }
                };
                return Some(BorderTouch {
                    gap,
                    slope,
                    turning,
                    radius: seen.norm(),
                    speed: (by_turn + by_gap * slope).norm(),
                    lengths,
                });
            }
        }
        None
    }
}

/// Bounds over a stretch between two poses of the same teeth, `angle` of the locked gear apart; `deepest` is the least `γ` in reach. `None`
/// if they are unknown.
///
/// A chord may end at the form circle. A corner above that circle when it meets the chord's line was not in the fillet before.
pub(super) fn bounds(
    ends: [OnFillet; 2],
    near: [f64; 2],
    angle: f64,
    deepest: f64,
) -> Option<FilletBounds> {
    let mate = ends[0].mate();
    let range = (deepest, mate.fillet_end);
    // In front of the line of a chord that extends to the form circle there is no fillet, from `low` on.
    let to_the_form_circle = |(low, _): (f64, f64)| {
        let found = reach(ends, chord(mate, (low, mate.fillet_end)), near)?;
        with_curvature(found, None, angle)
    };
    // The radii of the corner: the whole fillet's chord first, then the radii found with it.
    let mut band = range;
    for _ in 0..3 {
        let border = chord(mate, band);
        let found = reach(ends, border, near)?;
        match radii(mate, found, angle, range) {
            Some(found) => band = found,
            None => return to_the_form_circle(band),
        }
    }
    let clear = reach(ends, chord(mate, band), near)?;
    // The final chord holds for the radii that the corner has with it.
    let Some(needed) = radii(mate, clear, angle, range) else {
        return to_the_form_circle(band);
    };
    let play = 0.5 * (band.1 - band.0);
    if needed.0 < band.0 - play || needed.1 > band.1 + play {
        return None;
    }
    let band = (needed.0.min(band.0), needed.1.max(band.1));
    let clear = reach(ends, chord(mate, band), near)?;
    // Above the form circle the tangent of the fillet is outside the involute.
    let inside = (band.1 < mate.fillet_end)
        .then(|| reach(ends, tangent(mate, 0.5 * (band.0 + band.1)), near))
        .flatten();
    with_curvature(clear, inside, angle)
}

/// These bounds with their curvature over `angle`.
fn with_curvature(
    clear: [BorderTouch; 2],
    inside: Option<[BorderTouch; 2]>,
    angle: f64,
) -> Option<FilletBounds> {
    let both = clear.iter().chain(inside.iter().flatten());
    let bend = both
        .map(|one| one.bend(angle))
        .collect::<Option<Vec<f64>>>()?;
    Some(FilletBounds {
        clear,
        inside,
        bend: bend.into_iter().fold(0.0, f64::max),
    })
}

fn reach(ends: [OnFillet; 2], border: StraightLine, near: [f64; 2]) -> Option<[BorderTouch; 2]> {
    let [a, b] = [0, 1].map(|k| ends[k].reach(border, near[k]));
    Some([a?, b?])
}

/// The parameters between which the corner stays; `None` above the form circle.
fn radii(
    mate: &HalfToothShape,
    found: [BorderTouch; 2],
    angle: f64,
    (deepest, end): (f64, f64),
) -> Option<(f64, f64)> {
    let [a, b] = found;
    let play = 0.6 * a.speed.max(b.speed) * angle.abs();
    let (low, high) = (a.radius.min(b.radius) - play, a.radius.max(b.radius) + play);
    let at = |radius: f64| {
        if radius >= mate.form_radius() {
            return end;
        }
        around_radius(mate, radius, deepest, 0.0).map_or(deepest, |(low, high)| 0.5 * (low + high))
    };
    (low <= mate.form_radius()).then(|| (at(low), at(high)))
}

/// The chord between two parameters of a fillet, with the metal behind it.
fn chord(mate: &HalfToothShape, (low, high): (f64, f64)) -> StraightLine {
    let [inner, outer] = [low, high].map(|gamma| mate.at(ProfilePart::Fillet, gamma));
    let along = inner.point - outer.point;
    if along.norm() < 1e-9 * mate.base {
        // Too short for a direction: the tangent, slightly outside.
        return StraightLine {
            point: outer.point + outer.normal * along.norm(),
            normal: outer.normal,
        };
    }
    let normal = -C::i() * along / along.norm();
    let sign = if normal.im > 0.0 { -1.0 } else { 1.0 };
    StraightLine {
        point: outer.point,
        normal: normal * sign,
    }
}

/// The tangent at a parameter.
fn tangent(mate: &HalfToothShape, gamma: f64) -> StraightLine {
    let sample = mate.at(ProfilePart::Fillet, gamma);
    StraightLine {
        point: sample.point,
        normal: sample.normal,
    }
}

impl BorderTouch {
    /// Bound on the second derivative over a stretch of `angle`; `None` if its assumptions on slope and arm fail.
    fn bend(&self, angle: f64) -> Option<f64> {
        let [xx, xm, mm] = self.lengths;
        let angle = angle.abs();
        // Assumptions, checked with the resulting bound: no steeper slope than this, and no shorter arm than that.
        let rate = 1.2 * self.slope.abs();
        let turning = self.turning - (xm + mm * rate) * angle;
        let bend = (xx + 2.0 * xm * rate + mm * rate * rate) / turning;
        let holds = turning > 0.8 * self.turning && self.slope.abs() + bend * angle <= rate;
        holds.then_some(bend)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `(|s_xx| + 2 |s_xμ| |μ'| + |s_μμ| μ'²)/s_μ` with a slope a fifth steeper.
    #[test]
    fn a_bend_is_its_formula() {
        let reached = BorderTouch {
            gap: 0.0,
            slope: -2.0,
            turning: 30.0,
            radius: 31.0,
            speed: 1.0,
            lengths: [5.0, 3.0, 2.0],
        };
        let expected = (5.0 + 2.0 * 3.0 * 2.4 + 2.0 * 2.4 * 2.4) / 30.0;
        assert!((reached.bend(0.0).unwrap() - expected).abs() < 1e-15);
        // Over such a long stretch the arm may be short, and the slope steep.
        assert_eq!(reached.bend(1.0), None);
    }
}
