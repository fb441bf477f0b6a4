//! Outlines as paths of lines, arcs and curves.

#![allow(dead_code)] // each test binary uses its part

use gearlash::gear::Face;
use gearlash::outline::{OutlineReading, PathSegment};
use nalgebra::{Point2, Rotation2, Vector2};
use std::f64::consts::TAU;

/// Any path about the origin, read by itself.
pub const READING: OutlineReading = OutlineReading {
    centre: Point2::new(0.0, 0.0),
    face: Face::Front,
    teeth: None,
    first_tooth: None,
    bound: 0.0,
};

pub fn polar(radius: f64, angle: f64) -> Point2<f64> {
    Point2::new(radius * angle.cos(), radius * angle.sin())
}

/// The lines from corner to corner.
pub fn lines(corners: &[Point2<f64>]) -> Vec<PathSegment> {
    let ends = corners.windows(2);
    ends.map(|ends| PathSegment::Line([ends[0], ends[1]]))
        .collect()
}

/// The polygon of `corners`, closed.
pub fn polygon(corners: &[Point2<f64>]) -> Vec<PathSegment> {
    lines(&[corners, &corners[..1]].concat())
}

/// `segments` turned about the origin by `angle`.
pub fn turned(segments: &[PathSegment], angle: f64) -> Vec<PathSegment> {
    let turn = Rotation2::new(angle);
    let one = |segment: &PathSegment| match *segment {
        PathSegment::Line(points) => PathSegment::Line(points.map(|point| turn * point)),
        PathSegment::Cubic(points) => PathSegment::Cubic(points.map(|point| turn * point)),
        PathSegment::Arc {
            centre,
            radius,
            start,
            sweep,
        } => PathSegment::Arc {
            centre: turn * centre,
            radius,
            start: start + angle,
            sweep,
        },
    };
    segments.iter().map(one).collect()
}

/// `segments`, their gaps closed by arcs about the origin.
pub fn closed_by_arcs(segments: &[PathSegment]) -> Vec<PathSegment> {
    let mut path: Vec<PathSegment> = Vec::new();
    for (k, segment) in segments.iter().enumerate() {
        path.push(*segment);
        let next = segments[(k + 1) % segments.len()].start();
        let [from, to] = [segment.end(), next].map(|point| point.coords);
        if (to - from).norm() > 1e-9 {
            path.push(PathSegment::Arc {
                centre: Point2::origin(),
                radius: from.norm(),
                start: from.y.atan2(from.x),
                sweep: from.perp(&to).atan2(from.dot(&to)),
            });
        }
    }
    path
}

/// `teeth` times the segments of one tooth that points up, the next one clockwise; arcs about the origin close the roots.
pub fn repeated(teeth: u32, tooth: &[PathSegment]) -> Vec<PathSegment> {
    let pitch = TAU / f64::from(teeth);
    let each = (0..teeth).flat_map(|k| turned(tooth, -pitch * f64::from(k)));
    closed_by_arcs(&each.collect::<Vec<PathSegment>>())
}

/// A tooth that points up: the mirror image of `half`, from the root to the tip, and then `half`, from the tip to the root.
pub fn symmetrical(half: &[PathSegment]) -> Vec<PathSegment> {
    let left = half.iter().rev();
    let left = left.map(|segment| segment.mirrored().reversed());
    left.chain(half.iter().copied()).collect()
}

/// The arc through three points; a line where they lie on one.
pub fn arc([from, middle, to]: [Point2<f64>; 3]) -> PathSegment {
    let (b, c) = (middle - from, to - from);
    let twice = 2.0 * b.perp(&c);
    if twice.abs() < 1e-9 {
        return PathSegment::Line([from, to]);
    }
    let [bb, cc] = [b.norm_squared(), c.norm_squared()];
    let off = Vector2::new(c.y * bb - b.y * cc, b.x * cc - c.x * bb) / twice;
    let arms = [-off, c - off];
    PathSegment::Arc {
        centre: from + off,
        radius: off.norm(),
        start: arms[0].y.atan2(arms[0].x),
        sweep: arms[0].perp(&arms[1]).atan2(arms[0].dot(&arms[1])),
    }
}
