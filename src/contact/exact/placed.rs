//! A half tooth at its position in a pose.

use super::shape::{C, CurvePoint, HalfToothShape};
use crate::contact::gap::{PlacedCurve, ROUNDING, Rectangle};
use crate::gear::{Osculating, ProfilePart};

/// The gear that a half tooth belongs to. From tip to root, radii about the free axis rise on a locked half tooth and fall on a free one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Locked,
    Free,
}

/// A half tooth at its position in a pose: `centre + direction · P`, from the free gear's axis.
#[derive(Debug, Clone, Copy)]
pub(in crate::contact) struct PlacedHalf<'a> {
    pub shape: &'a HalfToothShape,
    pub centre: C,
    pub direction: C,
    /// Far corner of the tip land, in the half tooth's own frame.
    pub far: C,
    /// Parameter of the end of the root land.
    pub root_end: f64,
}

impl<'a> PlacedHalf<'a> {
    /// One of its curves.
    #[inline]
    pub fn curve(&self, part: ProfilePart) -> PlacedCurve<'a> {
        PlacedCurve {
            curve: self.shape.curve(part),
            mirrored: false,
            centre: self.centre,
            direction: self.direction,
        }
    }

    /// `e^{iθ}` of the tooth's far half, whose curves are mirrored: its far corner is the mirror image of the near one, turned.
    pub fn far_direction(&self) -> C {
        self.direction * self.shape.mirror(self.far)
    }

    /// Radius about the free axis of a point of the half tooth's own frame.
    pub fn own_to_axis(&self, point: C) -> f64 {
        (self.centre + self.direction * point).norm_sqr().sqrt()
    }

    /// Least radius about the free axis of a locked tip land: at a corner, or where it crosses the line of centres.
    pub fn least_land_radius(&self) -> f64 {
        let ends = [self.shape.tip_corner(), self.far].map(|end| self.direction * end);
        let side = ends.map(|end| end.re * self.centre.im - end.im * self.centre.re);
        if side[0] * side[1] <= 0.0 {
            return self.centre.norm_sqr().sqrt() - self.shape.tip_radius;
        }
        let squares = ends.map(|end| (self.centre + end).norm_sqr());
        squares[0].min(squares[1]).sqrt()
    }

    /// Parameters of a curve's two ends, the lesser first. The tip land reaches to its far corner, the root land to the
    /// middle of the space as built. Equal ends: the curve has no length.
    pub fn range(&self, curve: ProfilePart) -> (f64, f64) {
        let (low, high) = self.shape.range(curve);
        match curve {
            ProfilePart::Tip => (-self.far.arg(), high),
            ProfilePart::Root => (low.min(self.root_end), self.root_end),
            _ => (low, high),
        }
    }

    /// A rectangle around one of its curves.
    pub fn around(&self, curve: ProfilePart) -> Rectangle {
        let own = match curve {
            ProfilePart::Involute => self.shape.around()[0],
            ProfilePart::Fillet => self.shape.around()[1],
            ProfilePart::Tip | ProfilePart::Root => {
                let point = |t| self.shape.at(curve, t).point;
                Rectangle::new(self.shape.curve(curve), self.range(curve), point)
            }
        };
        own.placed(self.centre, self.direction)
    }

    /// The rounding of rectangles around curves of both half teeth, mm, and of the squares of radii, mm².
    pub fn rounding(&self, free: &PlacedHalf) -> [f64; 2] {
        let size = self.centre.norm() + self.shape.tip_radius + free.shape.tip_radius;
        [ROUNDING * size, ROUNDING * size * size]
    }

    /// Whether a curve has any length.
    pub fn has(&self, curve: ProfilePart) -> bool {
        let (low, high) = self.range(curve);
        low < high
    }

    /// Whether it is a point without one normal.
    pub fn is_corner(&self, (curve, t): (ProfilePart, f64)) -> bool {
        match curve {
            ProfilePart::Tip | ProfilePart::Root => {
                let (low, high) = self.range(curve);
                t >= high || curve == ProfilePart::Tip && t <= low
            }
            // Without a root land the half tooth ends at the bottom of the fillet.
            ProfilePart::Fillet if t <= 0.0 => !self.has(ProfilePart::Root),
            _ => self.shape.is_corner((curve, t)),
        }
    }

    /// The flank at a roll, at its position in the pose; `None` for a curve that is no involute.
    #[inline]
    pub fn flank(&self, xi: f64) -> Option<(CurvePoint, Osculating)> {
        let own = self.shape.curve(ProfilePart::Involute).osculating(xi)?;
        let sample = CurvePoint {
            point: self.centre + self.direction * C::new(own.point.x, own.point.y),
            normal: self.direction * C::new(own.normal.x, own.normal.y),
        };
        Some((sample, own))
    }

    #[inline]
    pub fn at(&self, curve: ProfilePart, t: f64) -> CurvePoint {
        let sample = self.shape.at(curve, t);
        CurvePoint {
            point: self.centre + self.direction * sample.point,
            normal: self.direction * sample.normal,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::gap::{dot, turn};
    use crate::gear::{GearDesign, Profile};

    fn shape(teeth: u32) -> HalfToothShape {
        HalfToothShape::new(&Profile::new(&GearDesign::plain(teeth, 2.0).gear()))
    }

    /// Source: every thousandth of the land of an eccentric gear, turned to either side of the line of centres.
    #[test]
    fn a_tip_land_is_as_near_as_its_nearest_point() {
        let shape = shape(17);
        let far = shape.tip_corner().conj();
        let half = shape.tip_corner().arg().abs();
        for centre in [C::new(40.0, 0.0), C::new(39.0, 0.7), C::new(0.6, -41.0)] {
            for step in -12..=12 {
                let placed = PlacedHalf {
                    shape: &shape,
                    centre,
                    direction: turn((-centre).arg() + 0.4 * half * f64::from(step)),
                    far,
                    root_end: 0.0,
                };
                let nearest = (-1000..=1000)
                    .map(|k| turn(half * f64::from(k) / 1000.0) * shape.tip_radius)
                    .map(|point| placed.own_to_axis(point))
                    .fold(f64::INFINITY, f64::min);
                let off = placed.least_land_radius() - nearest;
                assert!(off.abs() < 1e-6, "{centre} {step}");
            }
        }
    }

    /// A rectangle around a curve holds its points, and is not much larger. Source: 400 points of each curve, in 36 directions.
    #[test]
    fn a_rectangle_is_around_its_curve() {
        for teeth in [9, 17, 60] {
            let shape = shape(teeth);
            let placed = PlacedHalf {
                shape: &shape,
                centre: C::new(40.0, 3.0),
                direction: turn(2.9),
                far: shape.tip_corner().conj(),
                root_end: shape.range(ProfilePart::Root).0 + 0.03,
            };
            for part in ProfilePart::ALL {
                let around = placed.around(part);
                let (low, high) = placed.range(part);
                let at = |k: u32| low + (high - low) * f64::from(k) / 400.0;
                let points: Vec<C> = (0..=400).map(|k| placed.at(part, at(k)).point).collect();
                for n in (0..36).map(|k| turn(f64::from(k) / 5.73)) {
                    let most = points.iter().map(|p| dot(*p, n)).fold(f64::MIN, f64::max);
                    let over = around.farthest(n) - most;
                    assert!((-1e-12..1.0).contains(&over), "{teeth} {part:?}: {over}");
                }
            }
        }
    }

    /// Corners are the ends of the tip land, the end of the root land, and the joint of an undercut flank. Without a
    /// root land the bottom of the fillet is one too. Source: places where the outline's normals on either side differ.
    #[test]
    fn corners_are_where_the_outline_has_no_one_normal() {
        use ProfilePart::{Fillet, Involute, Root, Tip};
        for (teeth, undercut) in [(20, false), (9, true)] {
            let shape = shape(teeth);
            let (low, high) = shape.range(Root);
            for (root_end, root) in [(high.max(low + 0.01), true), (low, false)] {
                let placed = PlacedHalf {
                    shape: &shape,
                    centre: C::new(40.0, 0.0),
                    direction: turn(3.0),
                    far: shape.tip_corner().conj(),
                    root_end,
                };
                let (far, corner) = placed.range(Tip);
                let (form, tip) = placed.range(Involute);
                let (bottom, end) = placed.range(Fillet);
                assert!(bottom <= 0.0, "{bottom}");
                for (at, expected) in [
                    ((Tip, far), true),
                    ((Tip, far - 1e-3), true),
                    ((Tip, 0.5 * (far + corner)), false),
                    ((Tip, corner), true),
                    ((Involute, tip), true),
                    ((Involute, 0.5 * (form + tip)), false),
                    ((Involute, form), undercut),
                    ((Fillet, end), undercut),
                    ((Fillet, 0.5 * end), false),
                    ((Fillet, bottom), !root),
                    ((Root, root_end), true),
                    ((Root, low), !root),
                    ((Root, 0.5 * (low + root_end)), !root),
                ] {
                    assert_eq!(placed.is_corner(at), expected, "{teeth} {root} {at:?}");
                }
            }
        }
    }
}
