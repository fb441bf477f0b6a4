//! A gear by its outline: its teeth where they stand, and the axis it turns about.

use super::error::OutlineError;
use super::half::HalfOutline;
use super::path::ClosedPath;
use super::segment::PathSegment;
use super::teeth::{FoundTooth, find};
use crate::gear::{Face, PartCurve, Side};
use crate::numeric::bisect;
use nalgebra::{Complex, Point2, UnitComplex, Vector2};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

/// A tooth that points past +y by no more than this share of a pitch points there: pitch deviations and eccentricities are less, and who
/// means another tooth says so with the direction of tooth 1.
const UPRIGHT: f64 = 0.1;

/// Teeth off their even places by more than this share of a pitch are no gear; contact counts on it when it chooses the teeth in reach.
const UNEVEN: f64 = 0.5;

/// How a path is read as a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutlineReading {
    /// The centre of the outline in the drawing, mm.
    pub centre: Point2<f64>,
    /// The face that the picture shows; the drawing shows the reference face.
    pub face: Face,
    /// The number of teeth there should be; `None`: those found.
    pub teeth: Option<u32>,
    /// Direction of tooth 1 in the drawing, rad counter-clockwise from +x: the tooth nearest to it. `None`: the first at or clockwise of +y.
    pub first_tooth: Option<f64>,
    /// How far the path may lie from what was drawn, mm.
    pub bound: f64,
}

/// A gear by its outline, in its own frame: tooth 1 on +x, the geometric centre at the origin.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlineGear {
    pub(super) face: Face,
    /// Right halves and left ones (mirrored), tooth 1 first.
    pub(super) halves: [Arc<[HalfOutline]>; 2],
    /// The whole path about the geometric centre, turned by `turned` from where tooth 1 is on +x.
    pub(super) path: Arc<[PathSegment]>,
    pub(super) turned: f64,
    pub(super) tip_radius: f64,
    pub(super) root_radius: f64,
    pub(super) displacement: Complex<f64>,
    pub(super) bound: f64,
}

impl OutlineGear {
    /// The gear that `segments` draw, in order, each starting where the one before ends.
    ///
    /// # Errors
    /// [`OutlineError`]: an open or self-crossing path, a centre that is not inside, teeth that are too few, uneven, or others than stated.
    pub fn new(
        segments: &[PathSegment],
        reading: &OutlineReading,
    ) -> Result<OutlineGear, OutlineError> {
        let mirrored: Vec<PathSegment>;
        let (drawn, centre) = match reading.face {
            Face::Front => (segments, reading.centre),
            Face::Back => {
                mirrored = segments.iter().map(PathSegment::mirrored).collect();
                (
                    &mirrored[..],
                    Point2::new(-reading.centre.x, reading.centre.y),
                )
            }
        };
        let path = ClosedPath::new(drawn, centre)?;
        let found = find(&path)?;
        let radii = path.radii();
        let middle = 0.5 * (radii.0 + radii.1);
        let directions: Vec<f64> = found.iter().map(|tooth| direction(tooth, middle)).collect();
        let in_drawing = |tooth: usize| {
            let (sin, cos) = directions[tooth].sin_cos();
            let tip = Point2::new(radii.1 * cos, radii.1 * sin) + centre.coords;
            match reading.face {
                Face::Front => tip,
                Face::Back => Point2::new(-tip.x, tip.y),
            }
        };
        let pitch = TAU / found.len() as f64;
        let off = off_even_places(&directions);
        if let Some(tooth) = (0..off.len()).find(|&tooth| off[tooth].abs() > UNEVEN * pitch) {
            return Err(OutlineError::Uneven {
                tip: in_drawing(tooth),
                pitches: off[tooth] / pitch,
            });
        }
        let first = first_tooth(&directions, reading);
        if let Some(stated) = reading
            .teeth
            .filter(|&stated| stated as usize != found.len())
        {
            return Err(OutlineError::OtherTeeth {
                found: found.len(),
                stated,
                first: in_drawing(first),
            });
        }
        let (sin, cos) = directions[first].sin_cos();
        let back = Complex::new(cos, -sin);
        let count = found.len();
        // Numbers run clockwise on a front face.
        let ascending = reading.face.ascending() as isize;
        let halves = [0, 1].map(|side| {
            let tooth = |number: usize| {
                let index = first as isize + ascending * number as isize;
                let mut half =
                    found[index.rem_euclid(count as isize) as usize].halves[side].clone();
                for piece in &mut half.pieces {
                    piece.turn = if piece.mirrored { back.conj() } else { back };
                }
                half
            };
            (0..count).map(tooth).collect()
        });
        let about = drawn.iter().map(|segment| segment.moved(-centre.coords));
        Ok(OutlineGear {
            face: reading.face,
            path: about.collect(),
            turned: directions[first],
            halves,
            tip_radius: radii.1,
            root_radius: radii.0,
            displacement: Complex::ZERO,
            bound: reading.bound,
        })
    }

    /// The same outline off its axis: the eccentricity, mm, towards `high_tooth` (fractional, `1 ≤ … < z + 1`).
    ///
    /// # Errors
    /// [`OutlineError::Eccentric`]: half the tooth depth or more.
    pub fn with_runout(
        self,
        eccentricity: f64,
        high_tooth: f64,
    ) -> Result<OutlineGear, OutlineError> {
        let depth_mm = self.tip_radius - self.root_radius;
        if !(eccentricity >= 0.0 && 2.0 * eccentricity < depth_mm) {
            return Err(OutlineError::Eccentric {
                eccentricity_mm: eccentricity,
                depth_mm,
            });
        }
        let displacement = Complex::from_polar(eccentricity, self.tooth_angle(high_tooth));
        Ok(OutlineGear {
            displacement,
            ..self
        })
    }

    /// Direction of tooth 1 in the picture as drawn, about the geometric centre, rad counter-clockwise from +x.
    pub fn drawn_direction(&self) -> f64 {
        self.turned
    }

    /// Teeth `z`.
    pub fn teeth(&self) -> u32 {
        self.halves[0].len() as u32
    }

    /// The face the picture shows.
    pub fn face(&self) -> Face {
        self.face
    }

    /// Greatest radius about the geometric centre, mm.
    pub fn tip_radius(&self) -> f64 {
        self.tip_radius
    }

    /// Least radius about the geometric centre, mm.
    pub fn root_radius(&self) -> f64 {
        self.root_radius
    }

    /// Eccentricity `e`, mm.
    pub fn eccentricity(&self) -> f64 {
        self.displacement.norm()
    }

    /// The outline's centre from the axis with tooth 1 on +x, mm.
    pub(crate) fn displacement(&self) -> Complex<f64> {
        self.displacement
    }

    /// How far the outline may lie from what was drawn, mm.
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// Greatest radius about the axis, mm.
    pub fn reach(&self) -> f64 {
        self.tip_radius + self.eccentricity()
    }

    /// The half of tooth `tooth` (1 to z) on a side.
    pub(crate) fn half(&self, side: Side, tooth: u32) -> &HalfOutline {
        &self.halves[usize::from(side == Side::Left)][tooth as usize - 1]
    }

    /// Angle of the (fractional) tooth's even place from tooth 1, rad, counter-clockwise.
    pub fn tooth_angle(&self, tooth: f64) -> f64 {
        self.face.ascending() * (tooth - 1.0) * self.pitch()
    }

    /// Points along the closed outline with tooth 1 turned to the direction `tooth_1`, rad, about its axis: chords within `chord` mm of
    /// its curves (those of a gear by its data are chords already).
    pub fn points(&self, tooth_1: f64, chord: f64) -> Vec<Point2<f64>> {
        let turn = UnitComplex::new(tooth_1 - self.turned);
        let displaced = self.displacement * Complex::from_polar(1.0, tooth_1);
        let axis = Vector2::new(displaced.re, displaced.im);
        let each = self.path.iter().flat_map(|segment| segment.chords(chord));
        each.map(|point| turn * point + axis).collect()
    }

    /// Angular pitch, rad.
    pub fn pitch(&self) -> f64 {
        TAU / f64::from(self.teeth())
    }

    /// Mean of half the angle that a tooth spans on the circle of `radius`, mm, or on the nearest one that all teeth reach within the
    /// middle nine tenths of their depth.
    pub(super) fn half_angle(&self, radius: f64) -> f64 {
        let margin = 0.05 * (self.tip_radius - self.root_radius);
        let radius = radius.clamp(self.root_radius + margin, self.tip_radius - margin);
        let angles = (1..=self.teeth()).flat_map(|tooth| {
            let half = Side::BOTH.map(|side| self.half(side, tooth).angle_at(radius));
            // Clockwise of the centre line on its own side, wherever the tooth stands.
            let [right, left] = half;
            right
                .zip(left)
                .map(|(right, left)| 0.5 * (-left - right).rem_euclid(TAU))
        });
        let angles: Vec<f64> = angles.collect();
        angles.iter().sum::<f64>() / angles.len().max(1) as f64
    }
}

/// Direction of a tooth's centre line, rad: the middle between its flanks on the circle of `radius`.
fn direction(tooth: &FoundTooth, radius: f64) -> f64 {
    let [right, left] = tooth
        .halves
        .each_ref()
        .map(|half| half.angle_at(radius).unwrap_or(0.0));
    right + 0.5 * (-left - right).rem_euclid(TAU)
}

/// How far each of the teeth in these directions, rad, counter-clockwise in order, stands from its even place; the even places are where the
/// greatest distance is least.
fn off_even_places(directions: &[f64]) -> Vec<f64> {
    let pitch = TAU / directions.len() as f64;
    let mut off: Vec<f64> = Vec::with_capacity(directions.len());
    for (k, direction) in directions.iter().enumerate() {
        let there = direction - directions[0] - pitch * k as f64;
        // On from the tooth before: places add up over the teeth.
        let before = off.last().copied().unwrap_or(0.0);
        off.push(there - TAU * ((there - before) / TAU).round());
    }
    let most = off.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = off.iter().copied().fold(f64::INFINITY, f64::min);
    off.iter().map(|off| off - 0.5 * (most + least)).collect()
}

/// Which of the teeth in these directions (rad, in the picture) has the number 1.
fn first_tooth(directions: &[f64], reading: &OutlineReading) -> usize {
    // From the drawing to the picture.
    let seen = |angle: f64| match reading.face {
        Face::Front => angle,
        Face::Back => PI - angle,
    };
    let beyond = |direction: f64| match reading.first_tooth {
        Some(wanted) => {
            let off = (direction - seen(wanted)).rem_euclid(TAU);
            off.min(TAU - off)
        }
        None => {
            let along = reading.face.ascending() * (direction - FRAC_PI_2);
            (along + UPRIGHT * TAU / directions.len() as f64).rem_euclid(TAU)
        }
    };
    let order = directions.iter().enumerate();
    let first = order.min_by(|a, b| beyond(*a.1).total_cmp(&beyond(*b.1)));
    first.map_or(0, |(index, _)| index)
}

impl ClosedPath {
    /// Least and greatest radius, mm.
    fn radii(&self) -> (f64, f64) {
        let mut radii = (f64::INFINITY, 0.0f64);
        for chord in 0..self.marks.len() {
            let [from, to] = self.chord(chord);
            let curve = &self.parts[self.marks[chord].part].curve;
            let (least, most) = radius_range(curve, from, to);
            radii = (radii.0.min(least), radii.1.max(most));
        }
        radii
    }
}

/// Least and greatest radius of a curve between two parameters, mm.
fn radius_range(curve: &PartCurve, from: f64, to: f64) -> (f64, f64) {
    let ends = [curve.radius(from), curve.radius(to)];
    let (least, most) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    // A line's chord ends at the point nearest to the centre.
    if let PartCurve::Line(_) = curve {
        return (least, most);
    }
    // Stationary where the normal points along the radius: one place at most in so short a chord.
    let across = |t: f64| {
        let (point, normal) = curve.at(t);
        point.coords.perp(&normal)
    };
    let start = across(from);
    if start * across(to) >= 0.0 {
        return (least, most);
    }
    let [low, high] = bisect(from, to, 0.0, |t| across(t) * start > 0.0);
    let there = curve.radius(0.5 * (low + high));
    (least.min(there), most.max(there))
}
