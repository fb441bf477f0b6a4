//! A gear given by its outline: its teeth and its axis of rotation.

use super::half::HalfOutline;
use super::path::{ClosedPath, PathSegment};
use super::teeth::{FoundTooth, find_teeth};
use super::tooth_classes::ToothClasses;
use crate::error::OutlineError;
use crate::gear::{Face, Side};
use crate::numeric::mean;
use nalgebra::{Complex, Point2, UnitComplex, Vector2};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

/// A tooth that points past +y by at most this share of a pitch counts as pointing there: pitch deviations and eccentricities are less.
const UPRIGHT: f64 = 0.1;

/// Greatest distance of a tooth from its even place, in pitches. Contact relies on it for the choice of teeth in reach.
const UNEVEN: f64 = 0.5;

/// How to read a path as a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutlineReading {
    /// The centre of the outline in the drawing, mm.
    pub centre: Point2<f64>,
    /// The face shown in the picture; the drawing shows the reference face.
    pub face: Face,
    /// The expected number of teeth; `None`: any.
    pub teeth: Option<u32>,
    /// Direction of tooth 1 in the drawing, rad counter-clockwise from +x: the nearest tooth is tooth 1.
    ///
    /// `None`: the first tooth at or clockwise of +y.
    pub first_tooth: Option<f64>,
    /// Error bound of the path, mm.
    pub bound: f64,
}

/// A gear given by its outline, in its own frame: tooth 1 on +x, the geometric centre at the origin.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlineGear {
    pub(super) face: Face,
    /// Right half teeth and left ones (mirrored), tooth 1 first.
    pub(super) halves: [Arc<[HalfOutline]>; 2],
    /// The whole path about the geometric centre, turned by `drawn_direction` from tooth 1 on +x.
    pub(super) path: Arc<[PathSegment]>,
    pub(super) drawn_direction: f64,
    pub(super) tip_radius: f64,
    pub(super) root_radius: f64,
    pub(super) displacement: Complex<f64>,
    pub(super) bound: f64,
    /// Equal teeth about the geometric centre.
    pub(super) classes: Arc<ToothClasses>,
    /// The path before it is moved by a flank offset; `None` of a gear given by data.
    pub(super) drawing: Option<Drawing>,
}

/// A path as drawn, in the frame of [`OutlineGear::path`], and the flank offset by which the gear differs from it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Drawing {
    path: Arc<[PathSegment]>,
    bound: f64,
    /// Depth of the teeth, mm.
    depth: f64,
    flank_offset: f64,
}

impl OutlineGear {
    /// The gear drawn by `segments`, in order, each starting at the end of the one before.
    ///
    /// # Errors
    /// [`OutlineError`]: an open or self-crossing path, a centre outside, too few or uneven teeth, an unexpected number of teeth.
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
        let found = find_teeth(&path)?;
        let radii = path.radii();
        let middle = 0.5 * (radii.0 + radii.1);
        let directions: Vec<f64> = found.iter().map(|tooth| direction(tooth, middle)).collect();
        let tip_in_drawing = |tooth: usize| {
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
                tip: tip_in_drawing(tooth),
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
                first: tip_in_drawing(first),
            });
        }
        let (sin, cos) = directions[first].sin_cos();
        let back = Complex::new(cos, -sin);
        let count = found.len();
        // Tooth numbers ascend clockwise on a front face.
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
        let path: Arc<[PathSegment]> = about.collect();
        let gear = OutlineGear {
            face: reading.face,
            drawing: Some(Drawing {
                path: Arc::clone(&path),
                bound: reading.bound,
                depth: radii.1 - radii.0,
                flank_offset: 0.0,
            }),
            path,
            drawn_direction: directions[first],
            halves,
            tip_radius: radii.1,
            root_radius: radii.0,
            displacement: Complex::ZERO,
            bound: reading.bound,
            classes: Arc::default(),
        };
        Ok(gear.classified())
    }

    /// This outline with an eccentricity, mm, towards `high_tooth` (fractional, `1 ≤ … < z + 1`).
    ///
    /// # Errors
    /// [`OutlineError::Eccentric`]: an eccentricity of half the tooth depth or more.
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

    /// The distance by which the drawn outline is moved out, mm; `None` of a gear given by data.
    pub fn flank_offset(&self) -> Option<f64> {
        Some(self.drawing.as_ref()?.flank_offset)
    }

    /// This gear with flanks moved out along their normals so that its teeth are thicker by `by`, mm.
    ///
    /// # Errors
    /// As [`OutlineGear::with_flank_offset`].
    pub fn thicker(&self, by: f64) -> Result<OutlineGear, OutlineError> {
        self.with_flank_offset(self.flank_offset().unwrap_or(0.0) + 0.5 * by)
    }

    /// This gear with its drawn outline moved out by `offset`, mm, along its normal (negative: in). It replaces an earlier offset.
    ///
    /// # Errors
    /// [`OutlineError::Offset`]: the moved outline falls apart, keeps less than half the depth of its teeth, or the gear is given by data.
    #[cfg(feature = "offset")]
    pub fn with_flank_offset(&self, offset: f64) -> Result<OutlineGear, OutlineError> {
        /// Steps per mm to which the greatest possible flank offset is rounded down.
        const STEPS_PER_MM: f64 = 1000.0;
        self.moved_out(offset).ok_or_else(|| {
            let [most, _] = crate::numeric::bisect(0.0, offset.abs(), 0.1 / STEPS_PER_MM, |most| {
                self.moved_out(most.copysign(offset)).is_some()
            });
            OutlineError::Offset {
                offset_mm: offset,
                teeth: self.teeth(),
                greatest_mm: (most * STEPS_PER_MM).floor() / STEPS_PER_MM,
            }
        })
    }

    #[cfg(feature = "offset")]
    fn moved_out(&self, offset: f64) -> Option<OutlineGear> {
        /// Least depth of moved teeth, as a part of the depth drawn: less are waves of a rim.
        const LEAST_DEPTH: f64 = 0.5;
        let drawing = self.drawing.as_ref()?;
        let (path, error) = super::offset::offset_path(&drawing.path, offset)?;
        let path: Vec<PathSegment> = match self.face {
            Face::Front => path,
            Face::Back => path.iter().map(PathSegment::mirrored).collect(),
        };
        let reading = OutlineReading {
            centre: Point2::origin(),
            face: self.face,
            teeth: Some(self.teeth()),
            first_tooth: Some(in_drawing(self.face, self.drawn_direction)),
            bound: drawing.bound + error,
        };
        let gear = OutlineGear::new(&path, &reading).ok()?;
        if gear.tip_radius - gear.root_radius < LEAST_DEPTH * drawing.depth {
            return None;
        }
        Some(OutlineGear {
            displacement: self.displacement,
            drawing: Some(Drawing {
                flank_offset: offset,
                ..drawing.clone()
            }),
            ..gear
        })
    }

    /// Without the feature `offset` no outline is moved.
    ///
    /// # Errors
    /// [`OutlineError::Offset`], always.
    #[cfg(not(feature = "offset"))]
    pub fn with_flank_offset(&self, offset: f64) -> Result<OutlineGear, OutlineError> {
        Err(OutlineError::Offset {
            offset_mm: offset,
            teeth: self.teeth(),
            greatest_mm: 0.0,
        })
    }

    /// Direction of tooth 1 in the picture as drawn, about the geometric centre, rad counter-clockwise from +x.
    pub fn drawn_direction(&self) -> f64 {
        self.drawn_direction
    }

    /// Teeth `z`.
    pub fn teeth(&self) -> u32 {
        self.halves[0].len() as u32
    }

    /// The face shown in the picture.
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
        self.displacement.norm_sqr().sqrt()
    }

    /// The tooth (fractional) towards which the outline is displaced; 1 without an eccentricity.
    pub fn high_tooth(&self) -> f64 {
        let teeth = f64::from(self.teeth());
        let pitches = self.face.ascending() * self.displacement.arg() / self.pitch();
        // A small negative angle is rounded to a whole turn.
        1.0 + pitches.rem_euclid(teeth) % teeth
    }

    /// Displacement of the outline's centre from the axis with tooth 1 on +x, mm.
    pub(crate) fn displacement(&self) -> Complex<f64> {
        self.displacement
    }

    /// Error bound of the outline, mm.
    pub fn bound(&self) -> f64 {
        self.bound
    }

    /// Greatest radius about the axis, mm.
    pub fn reach(&self) -> f64 {
        self.tip_radius + self.eccentricity()
    }

    /// This gear with its classes of teeth, which are equal about the geometric centre.
    pub(super) fn classified(self) -> OutlineGear {
        let classes = ToothClasses::of(&self.halves, |tooth| self.tooth_angle(tooth));
        OutlineGear {
            classes: Arc::new(classes),
            ..self
        }
    }

    /// The classes of teeth that are equal at their even places. Each tooth of an eccentric gear is a class of its own.
    pub(crate) fn tooth_classes(&self) -> Arc<ToothClasses> {
        if self.eccentricity() > 0.0 {
            Arc::new(ToothClasses::each(self.teeth()))
        } else {
            Arc::clone(&self.classes)
        }
    }

    /// The half tooth on a side of `tooth` (1 to z).
    pub(crate) fn half(&self, side: Side, tooth: u32) -> &HalfOutline {
        &self.halves[side.index()][tooth as usize - 1]
    }

    /// Angle of the (fractional) tooth's even place from tooth 1, rad, counter-clockwise.
    pub fn tooth_angle(&self, tooth: f64) -> f64 {
        self.face.ascending() * (tooth - 1.0) * self.pitch()
    }

    /// Points along the closed outline about the axis, with tooth 1 in the direction `tooth_1`, rad.
    ///
    /// Chords are within `chordal_error` mm of the curves; the path of a gear given by data consists of chords already.
    pub fn points(&self, tooth_1: f64, chordal_error: f64) -> Vec<Point2<f64>> {
        let turn = UnitComplex::new(tooth_1 - self.drawn_direction);
        let displaced = self.displacement * Complex::from_polar(1.0, tooth_1);
        let axis = Vector2::new(displaced.re, displaced.im);
        let segments = self.path.iter();
        let each = segments.flat_map(|segment| segment.chords(chordal_error));
        each.map(|point| turn * point + axis).collect()
    }

    /// Angular pitch, rad.
    pub fn pitch(&self) -> f64 {
        TAU / f64::from(self.teeth())
    }

    /// Mean of half the angle that a tooth spans on the circle of `radius`, mm.
    ///
    /// The radius is limited to the middle nine tenths of the depth, which all teeth reach.
    pub(super) fn half_angle(&self, radius: f64) -> f64 {
        let margin = 0.05 * (self.tip_radius - self.root_radius);
        let radius = radius.clamp(self.root_radius + margin, self.tip_radius - margin);
        let angles = (1..=self.teeth()).flat_map(|tooth| {
            let half = Side::BOTH.map(|side| self.half(side, tooth).angle_at(radius));
            // Each flank is clockwise of the centre line in its own frame.
            let [right, left] = half;
            right
                .zip(left)
                .map(|(right, left)| 0.5 * (-left - right).rem_euclid(TAU))
        });
        mean(angles)
    }
}

/// Direction of a tooth's centre line, rad: the middle between its flanks on the circle of `radius`.
fn direction(tooth: &FoundTooth, radius: f64) -> f64 {
    let angle = |half: &HalfOutline| half.angle_at(radius).unwrap_or(0.0);
    let [right, left] = tooth.halves.each_ref().map(angle);
    right + 0.5 * (-left - right).rem_euclid(TAU)
}

/// Distance of each tooth from its even place, rad, from directions in counter-clockwise order.
///
/// The even places minimise the greatest distance.
fn off_even_places(directions: &[f64]) -> Vec<f64> {
    let pitch = TAU / directions.len() as f64;
    let mut off: Vec<f64> = Vec::with_capacity(directions.len());
    for (k, direction) in directions.iter().enumerate() {
        let there = direction - directions[0] - pitch * k as f64;
        // Continue from the tooth before: distances accumulate over the teeth.
        let before = off.last().copied().unwrap_or(0.0);
        off.push(there - TAU * ((there - before) / TAU).round());
    }
    let most = off.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = off.iter().copied().fold(f64::INFINITY, f64::min);
    off.iter().map(|off| off - 0.5 * (most + least)).collect()
}

/// A direction of the picture in the drawing, or of the drawing in the picture, rad.
fn in_drawing(face: Face, angle: f64) -> f64 {
    match face {
        Face::Front => angle,
        Face::Back => PI - angle,
    }
}

/// Index of tooth 1 among the teeth in these directions (rad, in the picture).
fn first_tooth(directions: &[f64], reading: &OutlineReading) -> usize {
    let beyond = |direction: f64| match reading.first_tooth {
        Some(wanted) => {
            let off = (direction - in_drawing(reading.face, wanted)).rem_euclid(TAU);
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
