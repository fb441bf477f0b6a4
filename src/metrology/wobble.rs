//! Wobble: the lean of the teeth's axis from the rotation axis, from runouts at two places.

use super::runout::Runout;
use crate::gear::BasicGearData;
use nalgebra::{UnitComplex, Vector2};

/// Lean of the teeth's axis from the rotation axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wobble {
    /// Its size, mm per mm.
    pub lean: f64,
    /// The tooth (fractional, counted in the measuring plane) towards which the teeth lean away from the reference face.
    pub tooth: f64,
}

impl Default for Wobble {
    fn default() -> Wobble {
        Wobble {
            lean: 0.0,
            tooth: 1.0,
        }
    }
}

/// A place along the axis with its runout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunoutAt {
    /// Height over the measuring plane, mm, away from the reference face.
    pub height: f64,
    /// Total reading, µm: radial runout `F_r`, or axial runout of a shoulder.
    pub total_um: f64,
    /// The tooth (fractional) of this place with the highest reading. Helical teeth wind from place to place.
    pub high_tooth: f64,
}

impl RunoutAt {
    /// The number in the measuring plane of a tooth that stands where the high tooth stands here.
    fn tooth(&self, data: &BasicGearData) -> f64 {
        unwound(data, self.high_tooth, self.height)
    }

    /// Displacement of the outline's centre, mm, in a frame in which tooth numbers run counter-clockwise.
    fn displacement(&self, data: &BasicGearData) -> Vector2<f64> {
        let angle = (self.tooth(data) - 1.0) * data.angular_pitch();
        UnitComplex::new(angle) * Vector2::new(self.total_um / 2000.0, 0.0)
    }
}

/// The number that the tooth `tooth` of the section at `height`, mm over the measuring plane, has in that plane.
fn unwound(data: &BasicGearData, tooth: f64, height: f64) -> f64 {
    let wound = height * data.twist() / data.angular_pitch();
    data.tooth_after(tooth - 1.0 - wound)
}

impl Wobble {
    /// Distance of two wobbles, mm per mm.
    pub(super) fn apart(&self, other: &Wobble, data: &BasicGearData) -> f64 {
        let lean = |wobble: &Wobble| {
            let angle = (wobble.tooth - 1.0) * data.angular_pitch();
            UnitComplex::new(angle) * Vector2::new(wobble.lean, 0.0)
        };
        (lean(self) - lean(other)).norm()
    }

    /// The runout in the measuring plane, and the wobble, of a gear with the radial runouts of two places.
    pub fn of_planes(data: &BasicGearData, [one, other]: [RunoutAt; 2]) -> (Runout, Wobble) {
        let [first, second] = [one, other].map(|at| at.displacement(data));
        let lean = (second - first) / (other.height - one.height);
        let tooth = |direction: Vector2<f64>| data.tooth_towards(direction.y.atan2(direction.x));
        let centre = first - one.height * lean;
        let wobble = Wobble {
            lean: lean.norm(),
            tooth: tooth(lean),
        };
        (Runout::new(2000.0 * centre.norm(), tooth(centre)), wobble)
    }

    /// The wobble of a gear whose shoulder of this diameter, mm, machined with the teeth, runs out by `at.total_um` in all. `is_far`: it looks away
    /// from the reference face.
    ///
    /// The teeth lean away from the reference face towards the high point of a shoulder that looks the way of the reference face.
    pub fn of_shoulder(data: &BasicGearData, at: RunoutAt, diameter: f64, is_far: bool) -> Wobble {
        let across = if is_far {
            0.5 * f64::from(data.teeth())
        } else {
            0.0
        };
        Wobble {
            lean: at.total_um / 1000.0 / diameter,
            tooth: data.tooth_after(at.tooth(data) - 1.0 + across),
        }
    }

    /// The tooth of the section at `height`, mm over the measuring plane, towards which the teeth lean.
    pub fn tooth_at(&self, data: &BasicGearData, height: f64) -> f64 {
        unwound(data, self.tooth, -height)
    }
}
