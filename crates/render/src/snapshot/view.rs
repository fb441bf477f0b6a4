//! A view of the gears: the millimetres that a frame of the sheet shows, and the scale.

use crate::kit::{Frame, Spot};
use nalgebra::{Point2, Vector2};
use std::f64::consts::{PI, TAU};

/// Greatest distance between a drawn chord and its curve, in units of the sheet: 0.0125 mm of
/// paper, an eighth of the thinnest line.
pub const CHORD: f64 = 0.05;

/// A frame of the sheet and what it shows.
#[derive(Debug, Clone, Copy)]
pub struct View {
    pub frame: Frame,
    /// The point of the gears at the middle of the frame, mm.
    pub middle: Point2<f64>,
    /// Units of the sheet per millimetre of gear.
    pub scale: f64,
}

impl View {
    /// Radius of a disc about [`Self::middle`] that contains the frame's content and a margin, mm.
    pub fn reach(&self) -> f64 {
        let frame = self.frame.grown(MARGIN);
        0.5 * frame.width().hypot(frame.height()) / self.scale
    }

    /// Chordal error that is invisible, mm.
    pub fn chord(&self) -> f64 {
        CHORD / self.scale
    }

    /// The place of a point of the gears on the sheet.
    pub fn spot(&self, point: Point2<f64>) -> Spot {
        let from_middle = (point - self.middle) * self.scale;
        let [x, y] = self.frame.middle();
        [x + from_middle.x, y - from_middle.y]
    }

    /// The places of points on the sheet.
    pub fn spots(&self, points: &[Point2<f64>]) -> Vec<Spot> {
        points.iter().map(|point| self.spot(*point)).collect()
    }

    /// The arc of a circle that can be in view, as points whose chords cannot be distinguished from it.
    pub fn arc(&self, centre: Point2<f64>, radius: f64) -> Vec<Spot> {
        let to_middle = self.middle - centre;
        let (distance, reach) = (to_middle.norm(), self.reach());
        if (distance - radius).abs() > reach {
            return Vec::new();
        }
        let half = if distance > reach {
            (reach / distance).asin()
        } else {
            PI
        };
        // A chord over the angle Δ leaves the arc by r (1 − cos Δ/2) ≤ r Δ²/8.
        let step = (8.0 * self.chord() / radius).sqrt().min(TAU / 16.0);
        let steps = (2.0 * half / step).ceil();
        let towards = to_middle.y.atan2(to_middle.x);
        (0..=steps as u32)
            .map(|i| {
                let angle = towards - half + 2.0 * half * f64::from(i) / steps;
                self.spot(centre + radius * Vector2::new(angle.cos(), angle.sin()))
            })
            .collect()
    }
}

/// Distance beyond a frame's edge that is drawn before clipping, so that no outline runs along the edge.
pub const MARGIN: f64 = 12.0;
