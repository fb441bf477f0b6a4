//! From a pair that touches, in the frame of [`super::facing`], to a [`Contact`] in the picture.

use super::facing::Stand;
use super::shape::{C, Sample, Shape};
use super::ties::Touching;
use crate::gear::{Curve, Side};
use crate::mesh::lost_motion::{Contact, Touch};
use crate::pair::Member;
use nalgebra::{Point2, Vector2};
use std::f64::consts::PI;

/// A contact this near to the tip circle is the tip corner's: the rule of the reference data.
const CORNER_MM: f64 = 1e-7;

/// The contact of `touching`; its rotation counts as [`Stand::rotation`], mirrored back, and is not yet normalised.
pub(super) fn contact(stand: &Stand, touching: &Touching, free: Member) -> Contact {
    let facing = stand.facing;
    let hit = &touching.hit;
    let (ours, theirs) = (stand.locked(touching.step), stand.free(touching.step));
    let p = ours.at(hit.locked.0, hit.locked.1);
    let q = theirs.at(hit.free.0, hit.free.1);
    let corners = [
        is_corner(&facing.locked.shape, hit.locked),
        is_corner(&facing.free.shape, hit.free),
    ];
    let slope = match corners {
        [true, _] => slope(&q),
        [false, true] => slope(&p),
        [false, false] => slope(&p).abs().max(slope(&q).abs()),
    };
    let error = facing.rounding(p.point.norm(), slope) + hit.slack;
    // Out of the locked metal. A corner has no normal: there the other curve's counts, and where
    // two corners meet the direction in which they do.
    let turned = p.point * q.point.conj() / p.point.norm_sqr();
    let outward = match corners {
        [true, true] => p.point * C::i() / p.point.norm(),
        [true, false] => -q.normal * turned,
        _ => p.normal,
    };
    let outward = outward / outward.norm();
    let (locked_place, free_place) = stand.places(touching.step);
    let locked = touch(
        &facing.locked.shape,
        facing.locked.number(locked_place),
        hit.locked,
    );
    let mated = touch(&facing.free.shape, facing.free.number(free_place), hit.free);
    let mirror = |z: C| match facing.side {
        Side::Right => z,
        Side::Left => z.conj(),
    };
    let (point, outward) = (mirror(p.point), mirror(outward));
    let (wheel, pinion, point, normal) = match free {
        Member::Pinion => (locked, mated, C::from(facing.distance) - point, -outward),
        Member::Wheel => (mated, locked, point, -outward),
    };
    Contact {
        rotation: -facing.side.sense() * stand.rotation(touching.greatest),
        error: error.min(PI),
        wheel,
        pinion,
        point: Point2::new(point.re, point.im),
        normal: Vector2::new(normal.re, normal.im),
    }
}

/// `σ = ρ dθ/dρ`.
fn slope(sample: &Sample) -> f64 {
    let z = C::i() * sample.normal * sample.point.conj();
    z.im / z.re
}

/// The tip corner, and the middle of a root land: the ends of a half tooth's flank.
fn is_corner(shape: &Shape, (curve, t): (Curve, f64)) -> bool {
    match curve {
        Curve::Tip | Curve::Root => t == shape.range(curve).1,
        Curve::Involute => t >= shape.tip_roll,
        Curve::Fillet => false,
    }
}

/// Curves as results name them: an involute that ends at the tip circle is the tip corner, a fillet
/// that ends in the involute the involute, one that ends in the root land the root land.
fn touch(shape: &Shape, tooth: u32, (curve, t): (Curve, f64)) -> Touch {
    let radius = shape.radius(curve, t);
    let curve = match curve {
        Curve::Involute if radius > shape.tip_radius - CORNER_MM => Curve::Tip,
        Curve::Fillet if t >= shape.fillet_end => Curve::Involute,
        Curve::Fillet if t <= 0.0 => Curve::Root,
        other => other,
    };
    Touch {
        tooth,
        curve,
        radius,
    }
}
