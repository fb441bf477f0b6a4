//! One drawn tooth, repeated about the gear's centre.

use super::DrawingError;
use super::affine::Affine;
use super::chain::{DrawnPath, Open};
use super::curve::Curve;
use super::limits::{MAX_SEGMENTS, SAME_MM};
use gearlash::outline::PathSegment;
use nalgebra::{Point2, Rotation2};
use std::f64::consts::TAU;

/// How a tooth is repeated.
#[derive(Debug, Clone, PartialEq)]
pub struct Repeat {
    /// The number of teeth.
    pub teeth: u32,
    /// The gear's centre in the drawing, mm.
    pub centre: Point2<f64>,
}

impl Repeat {
    /// Whether a closed polygon is only part of a gear: it does not wind round the centre.
    pub fn is_part(&self, points: &[Point2<f64>]) -> bool {
        let next = points.iter().skip(1).chain(&points[..1]);
        let turns = points.iter().zip(next).map(|(from, to)| {
            let [from, to] = [from, to].map(|point| point - self.centre);
            from.perp(&to).atan2(from.dot(&to))
        });
        turns.sum::<f64>().abs() < 0.5 * TAU
    }

    /// The outline with `tooth`, an open path, as every tooth. Straight lines join each to the next.
    /// Errors: the path takes more than its share of a turn, or the outline has too many segments.
    pub fn outline(&self, tooth: &Open) -> Result<DrawnPath, DrawingError> {
        let [start, end] = tooth.ends.map(|end| end - self.centre);
        let angle = start.perp(&end).atan2(start.dot(&end));
        let pitch = TAU / f64::from(self.teeth);
        // A path over a whole pitch ends where the next begins, but for rounding.
        let rounding = SAME_MM / start.norm().min(end.norm());
        if !(angle.abs() <= pitch + rounding) {
            return Err(DrawingError::number(
                &tooth.path.place,
                format!(
                    "the path takes {:.3}° about the centre, one of {} teeth has {:.3}°",
                    angle.abs().to_degrees(),
                    self.teeth,
                    pitch.to_degrees()
                ),
            ));
        }
        if tooth
            .path
            .segments
            .len()
            .saturating_mul(self.teeth as usize)
            > MAX_SEGMENTS
        {
            return Err(DrawingError::too_large("segments", MAX_SEGMENTS));
        }
        let mut curve = Curve::default();
        for index in 0..self.teeth {
            let turn = Rotation2::new(angle.signum() * pitch * f64::from(index));
            let shift = self.centre - turn * self.centre;
            let map = Affine::new(*turn.matrix(), shift);
            for segment in &tooth.path.segments {
                let image = map.segment(segment);
                if let (Some(last), Some(first)) = (curve.segments.last(), image.segments.first()) {
                    let ends = [last.end(), first.start()];
                    if (ends[1] - ends[0]).norm() > SAME_MM {
                        curve.segments.push(PathSegment::Line(ends));
                    }
                }
                curve.add(image);
            }
        }
        let segments = &mut curve.segments;
        let ends = [segments[segments.len() - 1].end(), segments[0].start()];
        if (ends[1] - ends[0]).norm() > SAME_MM {
            segments.push(PathSegment::Line(ends));
        }
        Ok(DrawnPath {
            segments: curve.segments,
            name: tooth.path.name.clone(),
            bound_mm: tooth.path.bound_mm.max(curve.bound),
            place: tooth.path.place.clone(),
        })
    }
}
