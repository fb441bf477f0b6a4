//! Entities of a DXF as segments in mm.

use super::Kept;
use crate::drawing::DrawingError;
use crate::drawing::bspline::BSpline;
use crate::drawing::curve::{bulged, elliptic};
use crate::drawing::limits::SAME_MM;
use crate::drawing::piece::Piece;
use crate::drawing::pieces::Pieces;
use dxf::entities::{Entity, EntityType, LwPolyline, Polyline, Spline};
use dxf::{Drawing, Point, Vector};
use gearlash::outline::PathSegment;
use nalgebra::{Point2, Vector2};
use std::f64::consts::TAU;

/// Bits of the flags of polylines and of their vertices.
const CLOSED: i32 = 1;
const SPLINE_FIT: i32 = 4;
const IN_SPACE: i32 = 8 | 16 | 64;

/// Segments, and how far they may lie from what is drawn.
type BoundedSegments = (Vec<PathSegment>, f64);

/// Adds the entities of `text`, of which `kept` says where each stands; their unit is `scale` mm.
pub fn read(
    text: &str,
    kept: &[Kept],
    scale: f64,
    pieces: &mut Pieces,
) -> Result<(), DrawingError> {
    let whole = format!("0\nSECTION\n2\nENTITIES\n{text}0\nENDSEC\n0\nEOF\n");
    let unread = |reason: String| {
        let place = kept.first().map_or("the file", |first| &first.place);
        DrawingError::syntax(place, reason, "export it again as DXF")
    };
    let drawing =
        Drawing::load(&mut whole.as_bytes()).map_err(|error| unread(error.to_string()))?;
    let entities: Vec<_> = drawing.entities().collect();
    if entities.len() != kept.len() {
        let (read, all) = (entities.len(), kept.len());
        return Err(unread(format!("only {read} of {all} entities can be read")));
    }
    let mut height = None;
    for (entity, kept) in entities.into_iter().zip(kept) {
        let mut space = Space {
            scale,
            mirrored: false,
            height: &mut height,
            place: &kept.place,
        };
        let (segments, bound) = space.segments(entity)?;
        pieces.add(
            &kept.layer,
            Piece {
                segments,
                name: kept.layer.clone(),
                bound,
                place: kept.place.clone(),
            },
        )?;
    }
    Ok(())
}

/// The plane of the drawing.
struct Space<'a> {
    /// Length of a unit, mm.
    scale: f64,
    /// Whether an entity is seen from behind: its x points left.
    mirrored: bool,
    /// The z of all points so far, mm.
    height: &'a mut Option<f64>,
    /// Where the entity stands.
    place: &'a str,
}

impl Space<'_> {
    fn refused(&self, kind: impl Into<String>) -> DrawingError {
        let help = "export a flat drawing of lines, arcs, polylines and splines";
        DrawingError::refused(self.place, kind, help)
    }

    /// Its segments.
    fn segments(&mut self, entity: &Entity) -> Result<BoundedSegments, DrawingError> {
        match &entity.specific {
            EntityType::Line(line) => {
                let ends = [self.point(&line.p1)?, self.point(&line.p2)?];
                Ok((vec![PathSegment::Line(ends)], 0.0))
            }
            EntityType::Circle(circle) => {
                self.seen_from(&circle.normal)?;
                self.round(&circle.center, circle.radius, 0.0, TAU)
            }
            EntityType::Arc(arc) => {
                self.seen_from(&arc.normal)?;
                let (start, end) = (arc.start_angle.to_radians(), arc.end_angle.to_radians());
                self.round(&arc.center, arc.radius, start, turn(start, end))
            }
            EntityType::Ellipse(ellipse) => {
                self.seen_from(&ellipse.normal)?;
                let left = if self.mirrored { -1.0 } else { 1.0 };
                // Centre and axes are of the drawing's space, not of the entity's.
                self.mirrored = false;
                let centre = self.point(&ellipse.center)?;
                if ellipse.major_axis.z != 0.0 {
                    return Err(self.refused("an ellipse that is not flat"));
                }
                let major = Vector2::new(ellipse.major_axis.x, ellipse.major_axis.y) * self.scale;
                let minor = Vector2::new(-major.y, major.x) * (left * ellipse.minor_axis_ratio);
                let (start, end) = (ellipse.start_parameter, ellipse.end_parameter);
                Ok(elliptic(centre, [major, minor], start, turn(start, end)))
            }
            EntityType::LwPolyline(line) => self.light(line, entity.common.elevation),
            EntityType::Polyline(line) => self.old(line),
            EntityType::Spline(spline) => self.spline(spline),
            _ => Err(self.refused("an entity of another kind")),
        }
    }

    /// Sets which way x points by the direction an entity is seen from.
    fn seen_from(&mut self, normal: &Vector) -> Result<(), DrawingError> {
        // As printed: 1 up to its last digits.
        if normal.x.abs().max(normal.y.abs()) > 1e-12 || normal.z == 0.0 {
            return Err(self.refused("an extrusion direction other than 0, 0, ±1"));
        }
        self.mirrored = normal.z < 0.0;
        Ok(())
    }

    /// A point in mm; all must be of one height.
    fn point(&mut self, point: &Point) -> Result<Point2<f64>, DrawingError> {
        let z = if self.mirrored { -point.z } else { point.z } * self.scale;
        if !((z - *self.height.get_or_insert(z)).abs() <= SAME_MM) {
            return Err(self.refused("a point of another z than those before"));
        }
        let x = if self.mirrored { -point.x } else { point.x };
        Ok(Point2::new(x, point.y) * self.scale)
    }

    fn round(
        &mut self,
        centre: &Point,
        radius: f64,
        start: f64,
        sweep: f64,
    ) -> Result<BoundedSegments, DrawingError> {
        let centre = self.point(centre)?;
        if !(radius > 0.0) {
            return Err(DrawingError::Number {
                place: self.place.to_owned(),
                reason: format!("radius {radius}, allowed is above 0"),
            });
        }
        let radius = radius * self.scale;
        let side = if self.mirrored { -radius } else { radius };
        Ok(elliptic(
            centre,
            [Vector2::new(side, 0.0), Vector2::new(0.0, radius)],
            start,
            sweep,
        ))
    }

    fn light(&mut self, line: &LwPolyline, z: f64) -> Result<BoundedSegments, DrawingError> {
        self.seen_from(&line.extrusion_direction)?;
        let vertices = line.vertices.iter();
        let vertices = vertices.map(|vertex| (Point::new(vertex.x, vertex.y, z), vertex.bulge));
        self.through(vertices, line.flags & CLOSED != 0)
    }

    fn old(&mut self, line: &Polyline) -> Result<BoundedSegments, DrawingError> {
        self.seen_from(&line.normal)?;
        if line.flags & IN_SPACE != 0 {
            return Err(self.refused("a 3-D POLYLINE or mesh"));
        }
        if line.flags & SPLINE_FIT != 0 {
            return Err(self.refused("a POLYLINE fitted as a spline"));
        }
        let vertices = line.vertices();
        let vertices = vertices.map(|vertex| (vertex.location.clone(), vertex.bulge));
        self.through(vertices, line.flags & CLOSED != 0)
    }

    /// The lines and arcs through vertices, each with the bulge of what follows it.
    fn through(
        &mut self,
        vertices: impl Iterator<Item = (Point, f64)>,
        closed: bool,
    ) -> Result<BoundedSegments, DrawingError> {
        let hand = if self.mirrored { -1.0 } else { 1.0 };
        let vertices: Vec<(Point2<f64>, f64)> = vertices
            .map(|(point, bulge)| Ok((self.point(&point)?, hand * bulge)))
            .collect::<Result<_, DrawingError>>()?;
        let next = vertices
            .iter()
            .skip(1)
            .chain(vertices.first().filter(|_| closed));
        let drawn = vertices.iter().zip(next);
        let drawn = drawn.map(|(&(start, bulge), &(end, _))| bulged(start, end, bulge));
        let (segments, bounds): (Vec<_>, Vec<_>) = drawn.unzip();
        Ok((segments, bounds.into_iter().fold(0.0, f64::max)))
    }

    fn spline(&mut self, spline: &Spline) -> Result<BoundedSegments, DrawingError> {
        if spline.control_points.is_empty() && !spline.fit_points.is_empty() {
            return Err(self.refused("a SPLINE with fit points only"));
        }
        let points = spline.control_points.iter().map(|point| self.point(point));
        let curve = BSpline {
            degree: usize::try_from(spline.degree_of_curve).unwrap_or(0),
            knots: spline.knot_values.clone(),
            points: points.collect::<Result<_, DrawingError>>()?,
            weights: spline.weight_values.clone(),
        };
        if let Some(fault) = curve.fault() {
            return Err(self.refused(fault));
        }
        let drawn = curve.segments();
        drawn
            .ok_or_else(|| self.refused("a spline that 4096 cubic curves do not follow to 0.01 µm"))
    }
}

/// The angle from `start` on to `end`, counter-clockwise, rad: a whole turn where they are one.
fn turn(start: f64, end: f64) -> f64 {
    // A whole turn may be written as one.
    if (end - start - TAU).abs() < 1e-12 {
        return TAU;
    }
    let turn = (end - start).rem_euclid(TAU);
    if turn == 0.0 { TAU } else { turn }
}
