//! The path of a tip corner past its mate's fillet over a stretch of the locked gear's turn.
//!
//! Let the locked gear turn by `x` and the free gear by `g x`. In the mate's frame the corner's path is one of two sums of two rotations.
//! `d` is the distance of the axes, `c` the vector from the locked axis to its outline's centre, and `p` and `q` are those from the axes to
//! the corner:
//!
//! ```text
//! free corner:   Q(x) = e^{−iλ} (p e^{i(g−1)x} − d e^{−ix} − c),    |Q'''| ≤ |g−1|³ |p| + d
//! locked corner: Q(x) = e^{−iφ} (d e^{−igx} + q e^{i(1−g)x}) − c_F, |Q'''| ≤ |g|³ d + |1−g|³ |q|
//! ```
//!
//! So two derivatives and a bound of the third bound the path. The fillet is hollow: its chord is outside the metal. The corner is clear if
//! its radius is between those of the chord's ends and it is in front of the chord's line. The half tooth has one point at each radius about
//! the free axis ([`super::super::search_free_proof`], 1.). So a corner that is clear at one rotation is clear at all greater gaps.
//!
//! Above the form circle there is no fillet, but the corner may be inside the mate's involute there. As the free gear opens until the
//! involutes are apart, the corner's radius may fall. It is clear if it stays above the form circle until then, or is in front of the
//! involute's first tangent. Its radius falls no faster than its speed `v` along the radius says: with the distance `p` from the free axis,
//! `r(μ + x) ≥ r − x (−v)⁺ − p x²/2`.

use super::super::shape::{C, HalfToothShape};
use crate::contact::gap::dot;
use crate::gear::ProfilePart;

/// Limit of steps of the search for a fillet's parameter (8 are usual).
const STEPS: usize = 60;

/// Width of its bracket, as a part of the fillet: such a short chord is within 1e-15 mm of it.
const CLOSE: f64 = 1e-9;

/// A chord need not end closer to the band of radii that the corner is in than this share of the band (tuned).
const SHARE: f64 = 0.02;

/// Nor, of a corner in one place, than this share of the form radius, if it is clear of such a chord (tuned).
const COARSE: f64 = 1e-4;

/// Limit of halvings of a stretch.
const MOST_CUTS: u32 = 12;

/// Limit of stretches examined (tuned: 20 are common).
const MOST_LOOKS: u32 = 160;

/// The corner of a tip in its mate's frame, in the middle of a stretch.
#[derive(Debug, Clone, Copy)]
pub(super) struct CornerPath {
    point: C,
    /// Derivatives by the rotation of the locked gear.
    speed: C,
    acceleration: C,
    /// Bound of the third derivative.
    jerk: f64,
    /// Derivative by the rotation of the free gear alone. Its length is the distance from the free axis, mm.
    by_gap: C,
    /// Bound of that derivative's change with the rotation of the locked gear.
    swing: f64,
}

impl CornerPath {
    /// The path of the free gear's corner at `corner` from the free axis. The locked gear's outline has its centre at `centre`, its half
    /// tooth points to `−l`, the axes are `distance` apart, and `rate` is `g`.
    pub fn of_free(corner: C, centre: C, l: C, distance: f64, rate: f64) -> CornerPath {
        let (one, other) = (rate - 1.0, l.conj());
        CornerPath {
            point: (corner - centre) * other,
            speed: C::i() * (corner * one + distance) * other,
            acceleration: (C::from(distance) - corner * (one * one)) * other,
            jerk: one.abs().powi(3) * corner.norm() + distance,
            by_gap: C::i() * corner * other,
            swing: one.abs() * corner.norm(),
        }
    }

    /// The path of the locked gear's corner at `corner` from the locked axis. The free gear's outline has its centre at `centre` from the
    /// free axis, and its half tooth points to `f`.
    pub fn of_locked(corner: C, centre: C, f: C, distance: f64, rate: f64) -> CornerPath {
        let (one, other) = (1.0 - rate, f.conj());
        CornerPath {
            point: (corner + distance - centre) * other,
            speed: C::i() * (corner * one - distance * rate) * other,
            acceleration: -(corner * (one * one) + distance * rate * rate) * other,
            jerk: rate.abs().powi(3) * distance + one.abs().powi(3) * corner.norm(),
            by_gap: -C::i() * (corner + distance) * other,
            swing: one.abs() * corner.norm() + rate.abs() * distance,
        }
    }

    /// Whether the corner is clear of the fillet of `mate`, from `deepest` up, by more than `need` mm at every turn within `half` of the
    /// middle. The involutes are apart once the free gear is `opening` rad further open.
    pub fn is_clear(
        &self,
        mate: &HalfToothShape,
        deepest: f64,
        half: f64,
        (need, opening): (f64, f64),
    ) -> bool {
        let rest = self.jerk * half * half * half / 6.0;
        let radius = self.point.norm();
        let out = self.point / radius;
        let across = C::i() * out;
        let radial = [radius, dot(self.speed, out), dot(self.acceleration, out)];
        let nearest = least(radial, half) - rest;
        if !(nearest > 0.0) {
            return false;
        }
        let beside = dot(self.speed, across).abs() * half
            + 0.5 * dot(self.acceleration, across).abs() * half * half
            + rest;
        let from_axis = self.by_gap.norm();
        // `out` changes by the chord of an angle whose sine is at most `beside/nearest`.
        let changed = self.swing * half + 1.5 * from_axis * beside / nearest;
        let falling = changed - dot(self.by_gap, out);
        let fall = opening * (falling.max(0.0) + 0.5 * from_axis * opening);
        if nearest - fall >= mate.form_radius() {
            return true;
        }
        let farthest = -least(radial.map(|value| -value), half) + rest;
        let farthest = farthest + 0.5 * beside * beside / nearest;
        let clear = |play: f64| {
            let low = around_radius(mate, nearest, deepest, play).map(|(low, _)| low);
            let high = if farthest >= mate.form_radius() {
                Some(mate.fillet_end)
            } else {
                around_radius(mate, farthest, deepest, play).map(|(_, high)| high)
            };
            let (Some(low), Some(high)) = (low, high) else {
                return false;
            };
            let [inner, outer] = [low, high].map(|gamma| mate.at(ProfilePart::Fillet, gamma));
            let chord = outer.point - inner.point;
            let length = chord.norm();
            if !(length > 0.0) {
                return false;
            }
            // The right-hand half tooth has its metal on the left of the way inwards.
            let normal = C::i() * chord / length;
            let normal = if dot(normal, outer.normal) < 0.0 {
                -normal
            } else {
                normal
            };
            let is_before = |point: C, normal: C| {
                let height = [
                    dot(self.point - point, normal),
                    dot(self.speed, normal),
                    dot(self.acceleration, normal),
                ];
                least(height, half) - rest > need
            };
            let is_outside = || {
                let start = mate.at(ProfilePart::Involute, mate.form_roll);
                is_before(start.point, start.normal)
            };
            is_before(outer.point, normal) && (farthest < mate.form_radius() || is_outside())
        };
        let band = SHARE * (farthest - nearest);
        if half > 0.0 {
            return clear(band);
        }
        clear(COARSE * mate.form_radius()) || clear(band)
    }
}

/// The least of `a + b x + c x²/2` for `x` within `half` of 0.
fn least([a, b, c]: [f64; 3], half: f64) -> f64 {
    let end = a - b.abs() * half + 0.5 * c * half * half;
    let turn = b.abs() / c;
    if c > 0.0 && turn < half {
        a - 0.5 * b * b / c
    } else {
        end
    }
}

/// Two parameters of a fillet close together: the radius at the first is at most `radius`, at the second at least; closer than `play` mm is close
/// enough. `None` for a radius below that at `deepest`.
pub(super) fn around_radius(
    mate: &HalfToothShape,
    radius: f64,
    deepest: f64,
    play: f64,
) -> Option<(f64, f64)> {
    let beyond = |gamma: f64| mate.radius(ProfilePart::Fillet, gamma) - radius;
    let (mut low, mut high) = (deepest, mate.fillet_end);
    let (mut below, mut above) = (beyond(low), beyond(high));
    if !(below <= 0.0) {
        return None;
    }
    let close = CLOSE * mate.fillet_end;
    let mut last = None;
    let mut ends = [below, above];
    for _ in 0..STEPS {
        if high - low <= close || ends[1] - ends[0] <= play {
            break;
        }
        let secant = low - below * (high - low) / (above - below);
        // Half the width past either end, so that both ends converge.
        let at = secant.max(low + 0.5 * close).min(high - 0.5 * close);
        let value = beyond(at);
        // An end that stays twice gets half its weight (the Illinois rule).
        let is_low = value <= 0.0;
        ends[usize::from(!is_low)] = value;
        let stays = if last.replace(is_low) == Some(is_low) {
            0.5
        } else {
            1.0
        };
        if is_low {
            (low, below) = (at, value);
            above *= stays;
        } else {
            (high, above) = (at, value);
            below *= stays;
        }
    }
    Some((low, high))
}

/// Whether the corner is clear everywhere within `half` of `at`, as [`CornerPath::is_clear`] says. `per_place` is the locked gear's turn per
/// place, and `path` the path with its middle at a place. A stretch is cut if one chord does not suffice.
pub(super) fn is_clear_over(
    (at, half): (f64, f64),
    per_place: f64,
    mate: &HalfToothShape,
    deepest: f64,
    margins: (f64, f64),
    path: &dyn Fn(f64) -> CornerPath,
) -> bool {
    let mut open = vec![(at, half, 0)];
    for _ in 0..MOST_LOOKS {
        let Some((at, half, cuts)) = open.pop() else {
            return true;
        };
        if path(at).is_clear(mate, deepest, half * per_place.abs(), margins) {
            continue;
        }
        // A single place that is not clear ends it: the middle, and at first both ends.
        let is_clear = |at: f64| path(at).is_clear(mate, deepest, 0.0, margins);
        let ends_clear = || cuts > 0 || (is_clear(at - half) && is_clear(at + half));
        if cuts == MOST_CUTS || !is_clear(at) || !ends_clear() {
            return false;
        }
        let half = 0.5 * half;
        open.extend([(at - half, half, cuts + 1), (at + half, half, cuts + 1)]);
    }
    false
}

#[cfg(test)]
mod tests {
    use super::super::super::shape::turn;
    use super::*;

    /// Source: 1 + 2x + 2x² is least at x = −1/2, or at an end before it.
    #[test]
    fn a_parabola_is_least_at_its_vertex_or_an_end() {
        assert_eq!(least([1.0, 2.0, 4.0], 1.0), 0.5);
        assert_eq!(least([1.0, -2.0, 4.0], 0.25), 0.625);
    }

    /// Both paths agree with points turned about their axes to the third order. Source: the points turned.
    #[test]
    fn a_path_is_that_of_the_points_turned() {
        let (distance, rate, gap) = (50.0, -1.3, 0.2);
        let (centre, free_centre) = (C::new(49.9, 0.3), C::new(0.2, -0.1));
        let (l, f) = (-turn(0.1), turn(-0.05));
        let (locked_corner, free_corner) = (C::new(31.0, 2.0), C::new(21.0, 1.5));
        let about = |point: C, x: f64| turn(x) * (point - distance) + distance;
        let free = |x: f64| {
            let p = turn(gap + rate * x) * (free_centre + f * free_corner);
            (p - about(centre, x)) * (l * turn(x)).conj()
        };
        let locked = |x: f64| {
            let p = about(centre + l * locked_corner, x);
            let turned = turn(gap + rate * x);
            (p - turned * free_centre) * (turned * f).conj()
        };
        let turned = turn(gap);
        let corner = turned * (free_centre + f * free_corner);
        let arm = centre - distance + l * locked_corner;
        let paths = [
            CornerPath::of_free(corner, centre, l, distance, rate),
            CornerPath::of_locked(arm, turned * free_centre, turned * f, distance, rate),
        ];
        for k in -10..=10 {
            let x = 0.02 * f64::from(k);
            for (path, there) in paths.iter().zip([free(x), locked(x)]) {
                let near = path.point + path.speed * x + path.acceleration * (0.5 * x * x);
                let most = path.jerk * x.abs().powi(3) / 6.0 + 1e-12;
                assert!((there - near).norm() <= most, "{x}: {there} {near} {most}");
            }
        }
    }
}
