//! Path data of an SVG as segments.

use crate::affine::Affine;
use crate::bspline::raised;
use crate::curve::{Curve, elliptic};
use gearlash::outline::PathSegment;
use nalgebra::{Point2, Rotation2, Vector2};
use std::f64::consts::TAU;
use svgtypes::{PathParser, PathSegment as Command};

/// The pen on its way along the path, in user space.
struct Pen<'a> {
    /// From user space to mm.
    map: &'a Affine,
    at: Point2<f64>,
    start: Point2<f64>,
    /// The last control point of the curve before, if that was cubic or quadratic.
    cubic: Option<Point2<f64>>,
    quadratic: Option<Point2<f64>>,
    paths: Vec<Curve>,
}

/// The paths of `data`, mapped to mm by `map`; `Err`: the fault, in words.
pub fn read(data: &str, map: &Affine) -> Result<Vec<Curve>, String> {
    let mut pen = Pen {
        map,
        at: Point2::origin(),
        start: Point2::origin(),
        cubic: None,
        quadratic: None,
        paths: Vec::new(),
    };
    for command in PathParser::from(data) {
        pen.follow(command.map_err(|error| error.to_string())?);
    }
    pen.paths.retain(|path| !path.segments.is_empty());
    Ok(pen.paths)
}

impl Pen<'_> {
    fn to(&self, abs: bool, x: f64, y: f64) -> Point2<f64> {
        if abs {
            Point2::new(x, y)
        } else {
            self.at + Vector2::new(x, y)
        }
    }

    fn follow(&mut self, command: Command) {
        let (cubic, quadratic) = (self.cubic.take(), self.quadratic.take());
        match command {
            Command::MoveTo { abs, x, y } => {
                self.at = self.to(abs, x, y);
                self.start = self.at;
                self.begin();
            }
            Command::LineTo { abs, x, y } => self.line(self.to(abs, x, y)),
            Command::HorizontalLineTo { abs, x } => {
                let x = if abs { x } else { self.at.x + x };
                self.line(Point2::new(x, self.at.y));
            }
            Command::VerticalLineTo { abs, y } => {
                let y = if abs { y } else { self.at.y + y };
                self.line(Point2::new(self.at.x, y));
            }
            Command::CurveTo {
                abs,
                x1,
                y1,
                x2,
                y2,
                x,
                y,
            } => {
                let [b, c, d] = [[x1, y1], [x2, y2], [x, y]].map(|[x, y]| self.to(abs, x, y));
                self.curve(b, c, d);
            }
            Command::SmoothCurveTo { abs, x2, y2, x, y } => {
                let [c, d] = [[x2, y2], [x, y]].map(|[x, y]| self.to(abs, x, y));
                self.curve(self.reflected(cubic), c, d);
            }
            Command::Quadratic { abs, x1, y1, x, y } => {
                let [b, c] = [[x1, y1], [x, y]].map(|[x, y]| self.to(abs, x, y));
                self.parabola(b, c);
            }
            Command::SmoothQuadratic { abs, x, y } => {
                self.parabola(self.reflected(quadratic), self.to(abs, x, y));
            }
            Command::EllipticalArc {
                abs,
                rx,
                ry,
                x_axis_rotation,
                large_arc,
                sweep,
                x,
                y,
            } => {
                let end = self.to(abs, x, y);
                self.arc([rx, ry], x_axis_rotation, [large_arc, sweep], end);
            }
            Command::ClosePath { .. } => {
                self.line(self.start);
                self.begin();
            }
        }
    }

    fn begin(&mut self) {
        self.paths.push(Curve::default());
    }

    fn add(&mut self, curve: Curve) {
        if let Some(path) = self.paths.last_mut() {
            path.add(curve);
        }
    }

    /// The last control point mirrored in the point where the pen is.
    fn reflected(&self, control: Option<Point2<f64>>) -> Point2<f64> {
        control.map_or(self.at, |control| self.at + (self.at - control))
    }

    fn line(&mut self, to: Point2<f64>) {
        if to != self.at {
            let ends = [self.at, to].map(|point| self.map.point(point));
            self.add(Curve::exact(PathSegment::Line(ends)));
        }
        self.at = to;
    }

    fn curve(&mut self, b: Point2<f64>, c: Point2<f64>, d: Point2<f64>) {
        let points = [self.at, b, c, d].map(|point| self.map.point(point));
        self.add(Curve::exact(PathSegment::Cubic(points)));
        (self.at, self.cubic) = (d, Some(c));
    }

    fn parabola(&mut self, b: Point2<f64>, c: Point2<f64>) {
        let points = [self.at, b, c].map(|point| self.map.point(point));
        self.add(Curve::exact(PathSegment::Cubic(raised(points))));
        (self.at, self.quadratic) = (c, Some(b));
    }

    /// An arc by its ends: SVG 2, appendix B.2.4, with the flags for the large arc and for growing angles.
    fn arc(&mut self, radii: [f64; 2], turned: f64, [large, growing]: [bool; 2], end: Point2<f64>) {
        let [mut rx, mut ry] = radii.map(f64::abs);
        let half = (end - self.at) * 0.5;
        if rx == 0.0 || ry == 0.0 || half == Vector2::zeros() {
            return self.line(end);
        }
        let turned = Rotation2::new(turned.to_radians());
        let flat = turned.inverse() * half;
        // Half the chord where the ellipse is a circle of radius 1.
        let mut chord = Vector2::new(flat.x / rx, flat.y / ry);
        let length = chord.norm();
        if length > 1.0 {
            (rx, ry) = (rx * length, ry * length);
            chord /= length;
        }
        let away = (1.0 - chord.norm_squared()).max(0.0).sqrt();
        let side = if large == growing { 1.0 } else { -1.0 };
        // From the middle of the chord to the centre.
        let middle = Vector2::new(chord.y, -chord.x) / chord.norm() * (side * away);
        let [from, to] = [-chord - middle, chord - middle].map(|ray| ray.y.atan2(ray.x));
        let sweep = if growing {
            (to - from).rem_euclid(TAU)
        } else {
            -(from - to).rem_euclid(TAU)
        };
        let centre = self.at + half + turned * Vector2::new(middle.x * rx, middle.y * ry);
        let axes = [Vector2::new(rx, 0.0), Vector2::new(0.0, ry)];
        let axes = axes.map(|axis| self.map.vector(turned * axis));
        self.add(elliptic(self.map.point(centre), axes, from, sweep));
        self.at = end;
    }
}
