//! What touches where two half teeth are closest: curves, radii, point and normal.

use super::Facing;
use crate::gear::{Curve, Gear, Profile};
use crate::mesh::contact::Closest;
use crate::mesh::lost_motion::Touch;
use crate::mesh::polygon::CutHalf;
use crate::pair::Member;
use nalgebra::{Point2, Vector2};

/// A radius this near the tip circle, mm, is the tip corner (the reference data's own rule).
const CORNER: f64 = 1e-7;

/// What touches, and where in the picture.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub locked: Touch,
    pub free: Touch,
    pub point: Point2<f64>,
    /// Out of the locked gear's metal.
    pub normal: Vector2<f64>,
}

impl Facing<'_> {
    /// What touches at the opening `touching`.
    pub(super) fn place(&self, touching: f64, closest: &Closest) -> Place {
        let Closest {
            segments, points, ..
        } = *closest;
        let free_frame = self.free_frame(touching);
        let at = [
            points[0],
            free_frame.inverse_transform_point(&(self.locked_frame * points[1])),
        ];
        let describe = |half: &CutHalf, member: Member, tooth: u32, i: usize| {
            let gear = self.assembly.gear(member).gear();
            let (curve, parameter) = half.polygon.locate(segments[i] as usize, &at[i]);
            let radius = at[i].coords.norm();
            let normal = Profile::new(gear).normal(curve, parameter, self.side);
            let edge = is_edge(gear, half.polygon.land_start(), curve, parameter, radius);
            let on_tip_circle = radius >= gear.tip_radius() - CORNER;
            let touch = Touch {
                tooth,
                curve: if on_tip_circle { Curve::Tip } else { curve },
                radius,
            };
            (touch, (!edge).then_some(normal))
        };
        let (locked_member, free_member) = (self.assembly.locked(), self.assembly.free());
        let (locked, locked_normal) = describe(self.locked, locked_member, self.locked_tooth, 0);
        let (free, free_normal) = describe(self.free, free_member, self.free_tooth, 1);
        let point = self.locked_frame * nalgebra::center(&points[0], &points[1]);
        // An edge has no normal of its own: the other gear's curve gives it, and of
        // two edges the direction in which they meet.
        let normal: Vector2<f64> = match (locked_normal, free_normal) {
            (Some(normal), _) => self.locked_frame * normal,
            (None, Some(normal)) => -(free_frame * normal),
            (None, None) => {
                let arm = (point - self.assembly.axis(free_member)).normalize();
                self.side.sense() * Vector2::new(arm.y, -arm.x)
            }
        };
        Place {
            locked,
            free,
            point,
            normal,
        }
    }
}

/// Whether a half tooth has an edge or ends at the place: a corner of its tip, or the middle of the space.
fn is_edge(gear: &Gear, land_start: f64, curve: Curve, parameter: f64, radius: f64) -> bool {
    let profile = Profile::new(gear);
    let (root_start, root_end) = profile.range(Curve::Root);
    match curve {
        Curve::Tip => {
            let inside = CORNER / radius;
            parameter >= profile.range(Curve::Tip).1 - inside || parameter <= land_start + inside
        }
        Curve::Involute => radius >= gear.tip_radius() - CORNER,
        Curve::Fillet => root_start >= root_end && radius <= gear.root_radius() + CORNER,
        Curve::Root => parameter >= root_end - CORNER / radius,
    }
}
