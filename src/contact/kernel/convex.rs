//! Convex pieces of a half tooth, by their support functions.
//!
//! For a direction `n = e^{iω}` the support of a convex piece is `h(ω) = max P·n`. Its derivative `h'` is the coordinate of the support
//! point along `i n`. `h + h''` is the radius of curvature there, at least 0. An involute at the roll `ξ` has the normal `e^{iω}` with `ω =
//! ξ − ψ_b − π/2`, and
//!
//! ```text
//! h = r_b ξ,   h' = r_b,   h'' = 0.
//! ```
//!
//! Directions and points are in the half tooth's own frame: right-hand half, centre line on +x.

use crate::contact::exact::HalfToothShape;
use crate::contact::gap::{C, dot};
use std::f64::consts::{FRAC_PI_2, PI};

/// `a·(i b)`.
#[inline]
pub(super) fn along(a: C, b: C) -> f64 {
    a.im * b.re - a.re * b.im
}

/// A support function in one direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Support {
    /// `h`, mm.
    pub reach: f64,
    /// `h'`, mm.
    pub along: f64,
    /// `h + h''`, mm: radius of curvature of the outline there.
    pub radius: f64,
    /// Least `h'`, mm, while the direction turns clockwise past the next edge between two corners.
    pub lever: f64,
    /// Turn of the direction, rad, clockwise to the end of a tip land, if that is on the way. The arm may fall until there.
    pub ahead: f64,
}

impl Support {
    #[inline]
    fn of_point(point: C, n: C) -> Support {
        let along = along(point, n);
        Support {
            reach: dot(point, n),
            along,
            radius: 0.0,
            lever: along,
            ahead: 0.0,
        }
    }

    /// The support of a land of this radius, mm.
    fn of_land(radius: f64) -> Support {
        Support {
            reach: radius,
            along: 0.0,
            radius,
            lever: 0.0,
            ahead: 0.0,
        }
    }

    fn before_land(self, ahead: f64) -> Support {
        Support { ahead, ..self }
    }

    /// The support of two points with an edge on either side.
    fn of_chord(ends: [C; 2], n: C) -> Support {
        let [one, other] = ends.map(|point| Support::of_point(point, n));
        Support {
            lever: one.along.min(other.along),
            ..one.further(other)
        }
    }

    /// The support of two points, the second at the counter-clockwise end of their edge: past it the support is the first.
    fn of_edge(points: [C; 2], n: C) -> Support {
        let [first, second] = points.map(|point| Support::of_point(point, n));
        let second = Support {
            lever: first.along.min(second.along),
            ..second
        };
        first.further(second)
    }

    #[inline]
    fn further(self, other: Support) -> Support {
        if other.reach > self.reach {
            other
        } else {
            self
        }
    }
}

/// The convex hull of form point, involute, tip corner and tip land of a half tooth, up to the far corner of the land.
#[derive(Debug, Clone, Copy)]
pub(super) struct Top<'a> {
    shape: &'a HalfToothShape,
    far: C,
}

/// An arc about the gear's centre.
#[derive(Debug, Clone, Copy)]
pub(super) struct LandArc {
    radius: f64,
    /// Directions of its ends from the centre, rad, and the points there.
    low: f64,
    high: f64,
    ends: [C; 2],
}

/// A convex piece of a half tooth.
#[derive(Debug, Clone, Copy)]
pub(super) enum Convex<'a> {
    Top(Top<'a>),
    /// Both tops of a locked tooth, whose levers are unknown.
    Tooth(Top<'a>),
    Arc(LandArc),
    /// The hull of two points: a chord of a hollow curve, which reaches no further.
    Chord([C; 2]),
}

impl<'a> Convex<'a> {
    /// The top of a half tooth of this shape; `far` is the far corner of its tip land.
    pub fn top(shape: &'a HalfToothShape, far: C) -> Convex<'a> {
        Convex::Top(Top { shape, far })
    }

    /// Both tops of a tooth whose near half has this shape; `far` is the far corner of its tip land.
    pub fn tooth(shape: &'a HalfToothShape, far: C) -> Convex<'a> {
        Convex::Tooth(Top { shape, far })
    }

    /// The arc of this radius, mm, between two directions, rad.
    pub fn arc(radius: f64, low: f64, high: f64) -> Convex<'a> {
        let at = |angle: f64| C::from_polar(radius, angle);
        Convex::Arc(LandArc {
            radius,
            low,
            high,
            ends: [at(low), at(high)],
        })
    }

    /// The support in the direction `n = e^{iω}`, `ω` within ±π.
    #[inline]
    pub fn support(&self, omega: f64, n: C) -> Support {
        match self {
            Convex::Top(top) => top.support(omega, n),
            Convex::Tooth(top) => top.support_of_tooth(omega, n),
            Convex::Arc(arc) => arc.support(omega, n),
            Convex::Chord(ends) => Support::of_chord(*ends, n),
        }
    }

    /// Greatest distance, mm, from an axis at `−off` in the piece's own frame.
    pub fn farthest(&self, off: C) -> f64 {
        match self {
            Convex::Top(top) => top.farthest(off),
            Convex::Tooth(top) => {
                let far_joint = top.mirrored(top.shape.joint);
                top.farthest(off).max((off + far_joint).norm())
            }
            Convex::Arc(arc) => farthest_of_arc(arc.radius, arc.low, arc.high, off),
            Convex::Chord(ends) => {
                let [a, b] = ends.map(|end| (off + end).norm());
                a.max(b)
            }
        }
    }

    /// Greatest radius of curvature, mm, in directions within `play` of `omega`; infinite at an edge of the hull between several points.
    pub fn greatest_radius(&self, omega: f64, play: f64) -> f64 {
        match self {
            Convex::Top(top) => top.greatest_radius(omega, play),
            Convex::Tooth(top) => {
                let (joint, beta) = (top.shape.joint, top.mirror().arg());
                let mirrored = wrapped(beta - omega);
                let edge = radius_of_edge([top.mirrored(joint), joint], omega, play);
                let near = top.radius_of_curves(omega, play).max(edge);
                near.max(top.radius_of_curves(mirrored, play))
            }
            Convex::Arc(arc) => arc.radius,
            Convex::Chord(_) => 0.0,
        }
    }
}

/// Infinite if the normal of the edge between two corners of a hull, counter-clockwise from one to the other, is within `play` of `omega`.
fn radius_of_edge([from, to]: [C; 2], omega: f64, play: f64) -> f64 {
    let normal = (from - to) * C::i();
    if wrapped(omega - normal.arg()).abs() <= play {
        f64::INFINITY
    } else {
        0.0
    }
}

/// Greatest distance of an arc about the origin from an axis at `−off`.
fn farthest_of_arc(radius: f64, low: f64, high: f64, off: C) -> f64 {
    let from_middle = wrapped(off.arg() - 0.5 * (low + high));
    let half = 0.5 * (high - low);
    let at = 0.5 * (low + high) + from_middle.clamp(-half, half);
    (off + C::from_polar(radius, at)).norm()
}

/// `angle` within ±π, if it is less than three half turns.
#[inline]
pub(super) fn wrapped(angle: f64) -> f64 {
    if angle > PI {
        angle - 2.0 * PI
    } else if angle < -PI {
        angle + 2.0 * PI
    } else {
        angle
    }
}

impl Top<'_> {
    /// `e^{iβ}`: the far half of the tooth is `e^{iβ}` times the conjugate of the near one.
    fn mirror(&self) -> C {
        self.shape.mirror(self.far)
    }

    fn mirrored(&self, own: C) -> C {
        own.conj() * self.mirror()
    }

    /// The support of both tops, which mirror each other.
    #[inline]
    fn support_of_tooth(&self, omega: f64, n: C) -> Support {
        let is_near = dot(n, self.shape.tip_corner()) >= dot(n, self.far);
        if is_near {
            return self.support_of_near_half(omega, n);
        }
        let n = self.mirrored(n);
        let support = self.support_of_near_half(n.arg(), n);
        Support {
            along: -support.along,
            lever: f64::NAN,
            ..support
        }
    }

    /// The support of both tops in a direction nearer to the near one's corner.
    #[inline]
    fn support_of_near_half(&self, omega: f64, n: C) -> Support {
        let shape = self.shape;
        let roll = omega + shape.half_base + FRAC_PI_2;
        let is_behind = roll > shape.tip_roll && dot(n, shape.tip_corner()) < 0.0;
        if roll < shape.form_roll || is_behind {
            let far = self.mirrored(shape.joint);
            return Support::of_edge([shape.joint, far], n);
        }
        self.support(omega, n)
    }

    fn farthest(&self, off: C) -> f64 {
        let [low, high] = [self.shape.tip_corner().arg(), self.far.arg()];
        let land = farthest_of_arc(self.shape.tip_radius, low, high, off);
        let ends = [self.shape.tip_corner(), self.far, self.shape.joint];
        let ends = ends.map(|end| (off + end).norm());
        ends.into_iter().fold(land, f64::max)
    }

    #[inline]
    fn support(&self, omega: f64, n: C) -> Support {
        let shape = self.shape;
        let corner = shape.tip_corner();
        let roll = omega + shape.half_base + FRAC_PI_2;
        if roll < shape.form_roll {
            let inwards = dot(n, shape.joint);
            // Within 30° of straight from behind, the edge to the far corner is the next one; of a wide land that corner reaches further.
            let is_behind = inwards < 0.0 && inwards * inwards > 0.75 * shape.joint.norm_sqr();
            return if is_behind || dot(n, self.far) > inwards {
                let ahead = if omega > 0.0 { omega } else { omega + 2.0 * PI };
                Support::of_edge([self.far, shape.joint], n).before_land(ahead - corner.arg())
            } else {
                Support::of_point(shape.joint, n)
            };
        }
        if roll <= shape.tip_roll {
            return Support {
                reach: shape.base * roll,
                along: shape.base,
                radius: shape.base * roll,
                lever: shape.base,
                ahead: 0.0,
            };
        }
        // Clockwise of the corner's own direction the corner, then the land.
        if along(n, corner) <= 0.0 && dot(n, corner) > 0.0 {
            return Support::of_point(corner, n);
        }
        let ahead = omega - corner.arg();
        if along(n, self.far) <= 0.0 && dot(n, self.far) > 0.0 {
            return Support::of_land(shape.tip_radius).before_land(ahead);
        }
        // From past the far corner to straight from behind.
        Support::of_edge([self.far, shape.joint], n).before_land(ahead)
    }

    fn greatest_radius(&self, omega: f64, play: f64) -> f64 {
        let edge = radius_of_edge([self.far, self.shape.joint], omega, play);
        self.radius_of_curves(omega, play).max(edge)
    }

    fn radius_of_curves(&self, omega: f64, play: f64) -> f64 {
        let shape = self.shape;
        let roll = omega + shape.half_base + FRAC_PI_2;
        let mut most = 0.0f64;
        if roll + play >= shape.form_roll && roll - play <= shape.tip_roll {
            most = shape.base * (roll + play).min(shape.tip_roll);
        }
        let [low, high] = [shape.tip_corner().arg(), self.far.arg()];
        if omega + play >= low && omega - play <= high {
            most = most.max(shape.tip_radius);
        }
        most
    }
}

impl LandArc {
    fn support(&self, omega: f64, n: C) -> Support {
        let half = 0.5 * (self.high - self.low);
        if wrapped(omega - 0.5 * (self.low + self.high)).abs() <= half {
            return Support::of_land(self.radius);
        }
        Support::of_chord(self.ends, n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::gap::turn;
    use crate::gear::{GearDesign, Profile, ProfilePart};
    use std::f64::consts::TAU;

    /// Source: points of the outline, 4000 per curve: none is further than the support, and one is nearly as far. Ordinary, undercut and
    /// large gears; lands that the mate flank's deviation makes wider, also much, and narrower.
    #[test]
    fn a_top_reaches_as_far_as_its_farthest_point() {
        for (teeth, wider) in [(9, 0.0), (20, 0.01), (44, -0.01), (200, 0.0), (9, 0.7)] {
            let gear = GearDesign::plain(teeth, 2.0).gear();
            let shape = HalfToothShape::new(&Profile::new(&gear));
            let far = shape.tip_corner().conj() * turn(wider);
            let along = |low: f64, high: f64, part| {
                let places = (0..=4000).map(move |k| low + (high - low) * f64::from(k) / 4000.0);
                places.map(|t| shape.at(part, t).point).collect::<Vec<C>>()
            };
            let (form, tip) = shape.range(ProfilePart::Involute);
            let (_, corner) = shape.range(ProfilePart::Tip);
            let mut half = along(form, tip, ProfilePart::Involute);
            half.extend(along(-far.arg(), corner, ProfilePart::Tip));
            let mut whole = half.clone();
            whole.extend(half.iter().map(|point| point.conj() * turn(wider)));
            for (top, points) in [
                (Convex::top(&shape, far), &half),
                (Convex::tooth(&shape, far), &whole),
            ] {
                for k in 0..720 {
                    let omega = 0.003 + TAU * f64::from(k) / 720.0;
                    let support = |by: f64| top.support(wrapped(omega + by), turn(omega + by));
                    let n = turn(omega);
                    let farthest = points.iter().map(|p| dot(*p, n)).fold(f64::MIN, f64::max);
                    let over = support(0.0).reach - farthest;
                    assert!((-1e-12..1e-6).contains(&over), "{teeth} {omega}: {over:e}");
                    // h' turns by h'' = ρ − h: an edge between corners within it is a jump.
                    let most = top.greatest_radius(wrapped(omega), 0.02);
                    let turned = (support(0.02).along - support(-0.02).along).abs();
                    let most_turned = 0.04 * (most + 1.1 * shape.tip_radius);
                    assert!(turned <= most_turned + 1e-9, "{teeth} {omega}: {turned}");
                    for off in [-0.02, 0.0, 0.02] {
                        assert!(support(off).radius <= most + 1e-12, "{teeth} {omega} {off}");
                    }
                }
            }
        }
    }
}
