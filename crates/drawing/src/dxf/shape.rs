//! Entities of a DXF as segments in mm.

use super::Kept;
use super::entity::Entity;
use crate::DrawingError;
use crate::bspline::BSpline;
use crate::chain::DrawnPath;
use crate::curve::{Curve, bulged, elliptic};
use crate::limits::SAME_MM;
use crate::pieces::Pieces;
use gearlash::outline::PathSegment;
use nalgebra::{Point2, Point3, Vector2};
use std::f64::consts::TAU;
use std::fmt::Display;

/// Bits of the flags of polylines and of their vertices.
const CLOSED: i32 = 1;
const SPLINE_FIT: i32 = 4;
const IN_SPACE: i32 = 8 | 16 | 64;

/// Part of a drawing's size that its points may differ in z.
const NOISE: f64 = 1e-6;
const FLAT: &str = "export a flat drawing of lines, arcs, polylines and splines";

/// Adds the `kept` entities; their unit is `scale` mm.
/// Errors: an entity that is not supported, a number no gear has, or a drawing that is not flat.
pub fn read(kept: &[Kept], scale: f64, pieces: &mut Pieces) -> Result<(), DrawingError> {
    let mut corners = [f64::INFINITY, f64::NEG_INFINITY].map(|end| Point2::from([end; 2]));
    let mut heights = Vec::with_capacity(kept.len());
    for one in kept {
        let mut space = Space {
            scale,
            hand: 1.0,
            heights: Vec::new(),
            place: one.entity.place(),
        };
        let curve = one.placed.curve(space.curve(&one.entity)?, scale);
        for segment in &curve.segments {
            for point in [segment.start(), segment.at(0.5), segment.end()] {
                corners = [corners[0].inf(&point), corners[1].sup(&point)];
            }
        }
        let placed = space.heights.iter().map(|z| one.placed.height(*z) * scale);
        heights.push(placed.fold(None, |ends: Option<[f64; 2]>, z| {
            let [low, high] = ends.unwrap_or([z, z]);
            Some([low.min(z), high.max(z)])
        }));
        pieces.add(
            one.layer,
            DrawnPath {
                segments: curve.segments,
                name: one.layer.to_owned(),
                bound_mm: curve.bound,
                place: space.place,
            },
        )?;
    }
    // Some programs write noise.
    let noise = SAME_MM.max(NOISE * (corners[1] - corners[0]).norm());
    let first = heights.iter().flatten().next().map_or(0.0, |ends| ends[0]);
    let off = |ends: &[f64; 2]| !ends.iter().all(|z| (z - first).abs() <= noise);
    let mut each = kept.iter().zip(&heights);
    match each.find(|(_, ends)| ends.as_ref().is_some_and(off)) {
        Some((one, _)) => {
            let kind = "a point of another z than those before";
            Err(DrawingError::refused(one.entity.place(), kind, FLAT))
        }
        None => Ok(()),
    }
}

struct Space {
    /// Length of a unit, mm.
    scale: f64,
    /// The direction of x, 1 or −1.
    hand: f64,
    /// The z of its points, in units of the drawing.
    heights: Vec<f64>,
    /// The place of the entity in the file.
    place: String,
}

impl Space {
    fn refused(&self, kind: impl Display) -> DrawingError {
        DrawingError::refused(&self.place, kind, FLAT)
    }

    fn curve(&mut self, entity: &Entity) -> Result<Curve, DrawingError> {
        // The ends of a line are in the space of the drawing, all else in that of the entity.
        if entity.kind != "LINE" && entity.kind != "SPLINE" {
            self.hand = entity.hand().map_err(|kind| self.refused(kind))?;
        }
        match entity.kind {
            "LINE" => {
                let ends = [self.point(entity.point(10)), self.point(entity.point(11))];
                Ok(Curve::exact(PathSegment::Line(ends)))
            }
            "CIRCLE" => self.round(entity, 0.0, TAU),
            "ARC" => {
                let [start, end] = [50, 51].map(|code| entity.number(code, 0.0).to_radians());
                self.round(entity, start, turn(start, end))
            }
            "ELLIPSE" => {
                // Centre and axes of an ellipse are in the space of the drawing, too.
                let left = std::mem::replace(&mut self.hand, 1.0);
                let centre = self.point(entity.point(10));
                let axis = entity.point(11);
                if axis.z != 0.0 {
                    return Err(self.refused("an ellipse that is not flat"));
                }
                let major = Vector2::new(axis.x, axis.y) * self.scale;
                let minor = Vector2::new(-major.y, major.x) * (left * entity.number(40, 0.0));
                let [start, end] = [41, 42].map(|code| entity.number(code, 0.0));
                Ok(elliptic(centre, [major, minor], start, turn(start, end)))
            }
            "LWPOLYLINE" => {
                let vertices = entity.points(10, entity.number(38, 0.0));
                self.through(vertices, entity.flags() & CLOSED != 0)
            }
            "POLYLINE" => {
                let flags = entity.flags();
                if flags & IN_SPACE != 0 {
                    return Err(self.refused("a 3-D POLYLINE or mesh"));
                }
                if flags & SPLINE_FIT != 0 {
                    return Err(self.refused("a POLYLINE fitted as a spline"));
                }
                self.through(entity.vertices.clone(), flags & CLOSED != 0)
            }
            _ => self.spline(entity),
        }
    }

    /// A point in mm; its height is checked when the size of the drawing is known.
    fn point(&mut self, point: Point3<f64>) -> Point2<f64> {
        self.heights.push(self.hand * point.z);
        Point2::new(self.hand * point.x, point.y) * self.scale
    }

    fn round(&mut self, entity: &Entity, start: f64, sweep: f64) -> Result<Curve, DrawingError> {
        let centre = self.point(entity.point(10));
        let radius = entity.number(40, 0.0);
        if !(radius > 0.0) {
            let reason = format!("radius {radius}, allowed is above 0");
            return Err(DrawingError::number(&self.place, reason));
        }
        let radius = radius * self.scale;
        let axes = [[self.hand * radius, 0.0], [0.0, radius]].map(Vector2::from);
        Ok(elliptic(centre, axes, start, sweep))
    }

    /// The lines and arcs through vertices. Each vertex has the bulge of the segment after it.
    fn through(
        &mut self,
        vertices: Vec<(Point3<f64>, f64)>,
        closed: bool,
    ) -> Result<Curve, DrawingError> {
        let hand = self.hand;
        let vertices: Vec<(Point2<f64>, f64)> = vertices
            .into_iter()
            .map(|(point, bulge)| (self.point(point), hand * bulge))
            .collect();
        let next = vertices
            .iter()
            .skip(1)
            .chain(vertices.first().filter(|_| closed));
        let mut curve = Curve::default();
        for (&(start, bulge), &(end, _)) in vertices.iter().zip(next) {
            curve.add(bulged(start, end, bulge));
        }
        Ok(curve)
    }

    fn spline(&mut self, entity: &Entity) -> Result<Curve, DrawingError> {
        let points = entity.points(10, 0.0).into_iter();
        if points.len() == 0 && entity.value(11).is_some() {
            return Err(self.refused("a SPLINE with fit points only"));
        }
        let points = points.map(|(point, _)| self.point(point));
        let curve = BSpline {
            degree: entity
                .value(71)
                .and_then(|text| text.parse().ok())
                .unwrap_or(0),
            points: points.collect(),
            knots: entity.numbers(40),
            weights: entity.numbers(41),
        };
        if let Some(fault) = curve.fault() {
            return Err(self.refused(fault));
        }
        let drawn = curve.curve();
        drawn
            .ok_or_else(|| self.refused("a spline that 4096 cubic curves do not follow to 0.01 µm"))
    }
}

/// The angle from `start` on to `end`, counter-clockwise, rad: a whole turn where they are equal.
fn turn(start: f64, end: f64) -> f64 {
    // A whole turn may be written as one.
    if (end - start - TAU).abs() < 1e-12 {
        return TAU;
    }
    let turn = (end - start).rem_euclid(TAU);
    if turn == 0.0 { TAU } else { turn }
}
