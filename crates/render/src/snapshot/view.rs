//! Views of the gears: the millimetres that a frame of the sheet shows, and the scale; the view of the mesh zone.

use crate::kit::{Frame, Spot, UNITS_PER_MM, scale};
use gearlash::contact::Scene;
use gearlash::gear::Side;
use gearlash::pair::Member;
use nalgebra::{Point2, Vector2};
use std::f64::consts::{PI, TAU};

/// Greatest distance between a drawn chord and its curve, in units of the sheet: 0.0125 mm of
/// paper, an eighth of the thinnest line.
pub const CHORD: f64 = 0.05;

#[derive(Debug, Clone, Copy)]
pub struct View {
    pub frame: Frame,
    /// The point of the gears at the middle of the frame, mm.
    pub middle: Point2<f64>,
    /// Units of the sheet per millimetre of gear.
    pub scale: f64,
}

impl View {
    /// The view about `middle` at the greatest scale of a `series` that is at most `limit` units per millimetre.
    pub fn at_most(frame: Frame, middle: Point2<f64>, limit: f64, series: &[f64]) -> View {
        View {
            frame,
            middle,
            scale: UNITS_PER_MM * scale::at_most(limit / UNITS_PER_MM, series),
        }
    }

    /// Radius of a disc about [`Self::middle`] that contains the frame's content and a margin, mm.
    pub fn reach(&self) -> f64 {
        let frame = self.frame.grown(MARGIN);
        0.5 * frame.width().hypot(frame.height()) / self.scale
    }

    /// Chordal error that is invisible, mm.
    pub fn chord(&self) -> f64 {
        CHORD / self.scale
    }

    pub fn spot(&self, point: Point2<f64>) -> Spot {
        let from_middle = (point - self.middle) * self.scale;
        let [x, y] = self.frame.middle();
        [x + from_middle.x, y - from_middle.y]
    }

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

/// Pitches shown above and below the line of centres: with one and a half each gear shows three whole teeth, more than ever mate
/// in ordinary pairs.
const PITCHES: f64 = 1.5;
const BORDER: f64 = 1.0;
/// Base tangent points up to this distance are brought into view, modules: two pitches, a third more than is shown anyway.
const NEAR: f64 = 6.3;

/// The view of the mesh zone in `frame`: about the middle between the tip circles, with both root
/// circles, the paths of contact and the contacts in it.
pub fn mesh_view(scene: &Scene, frame: Frame) -> View {
    let [wheel, pinion] = Member::BOTH.map(|member| scene.placed(member).radii());
    let module = scene.module();
    let distance = scene.assembly().center_distance();
    let middle = Point2::new(0.5 * (wheel[0] + distance - pinion[0]), 0.0);
    let mut half = Vector2::new(0.0, PITCHES * std::f64::consts::PI * module);
    let mut include = |point: Point2<f64>| {
        half = half.sup(&((point - middle).abs().add_scalar(BORDER * module)));
    };
    include(Point2::new(wheel[1], 0.0));
    include(Point2::new(distance - pinion[1], 0.0));
    for contact in scene.contacts() {
        include(contact.on_locked);
        include(contact.on_free);
    }
    for side in Side::BOTH {
        let Some(action) = scene.line_of_action(side) else {
            continue;
        };
        action.path.iter().flatten().copied().for_each(&mut include);
        let contacts = scene.contacts().iter();
        for contact in contacts.filter(|contact| contact.side == side) {
            let is_limit = Member::BOTH.map(|m| contact.is_below_form_circle(m));
            let ends = action.ends.into_iter().zip(is_limit);
            // Tangent points of large gears are too far off to justify the smaller scale.
            let is_near = |end: &Point2<f64>| (end - middle).norm() <= NEAR * module;
            ends.filter(|(end, is_limit)| *is_limit && is_near(end))
                .for_each(|(end, _)| include(end));
        }
    }
    let fits = f64::min(0.5 * frame.width() / half.x, 0.5 * frame.height() / half.y);
    View::at_most(frame, middle, fits, scale::FINE)
}
