//! Dimension over two pins all round: the mean base thickness.
//!
//! The pin *in space i* lies between the right flank of tooth `i` and the left flank of tooth `i + 1`, numbers ascending.
//! A reading *at space i* has one pin there and the other in the most opposite space: `i + z/2` for even `z`,
//! `i + (z − 1)/2` for odd `z` (so `z` readings take every most opposite pair once; for even `z` the readings at
//! `i` and `i + z/2` are of the same pair).
//!
//! A circle of diameter `D_M` touches an involute where its centre lies on that involute turned by `D_M/d_b`. Flanks that
//! stand `x_R` and `x_L` beyond their places (ascending, reference circle) therefore put the centre, off the space's
//! middle, to (own derivation, with [`super::thickness::base_from_pins`] for `x = 0`)
//!
//! ```text
//! inv α_K = (D_M − p_b + s_b + (x_R − x_L) cos α)/d_b        angle = middle + (x_R + x_L)/(2 r)
//! ```
//!
//! `M` is the greatest distance of two parallel planes that touch both pins: the distance of the
//! centres and `D_M`. The eccentricity does not enter. Of a helical gear `D_M/cos β_b` takes the place of `D_M` in `inv α_K`, and pins, which slide along their
//! spaces until they stand opposite each other, have both radii and `D_M` between the planes.
//!
//! Thickness by tooth is not taken from such readings: each holds four flanks, and for even `z` there are
//! only `z/2` of them.

use super::thickness::MeasuringBody;
use super::{BasicGearData, Deviations, Flank, FlankShifts, Readings, involute, thickness};
use crate::error::GearError;

/// Newton's steps before the mean thickness is given up; it needs some five.
const MOST_STEPS: usize = 50;

/// Dimensions `M_dK` over two pins or balls, at stated spaces.
#[derive(Debug, Clone, PartialEq)]
pub struct PinReadings {
    basic_data: BasicGearData,
    body: MeasuringBody,
    pin: f64,
    readings: Readings,
    /// What the flanks stand out where they are touched, beyond where they stand.
    touched: FlankShifts,
}

impl PinReadings {
    /// Readings over pins or balls of diameter `pin`, mm, at their spaces.
    pub fn new(
        basic_data: &BasicGearData,
        body: MeasuringBody,
        pin: f64,
        readings: Readings,
    ) -> PinReadings {
        PinReadings {
            basic_data: *basic_data,
            body,
            pin,
            readings,
            touched: FlankShifts::default(),
        }
    }

    /// The same on flanks that stand out by `touched` where they are touched.
    pub(crate) fn touching(self, touched: FlankShifts) -> PinReadings {
        PinReadings { touched, ..self }
    }

    fn shifts(&self, known: &Deviations) -> Result<FlankShifts, GearError> {
        let mut shifts = FlankShifts::new(&self.basic_data, known)?;
        shifts.add(&self.touched);
        Ok(shifts)
    }

    /// `D_M`, mm.
    pub fn pin(&self) -> f64 {
        self.pin
    }

    /// The readings, each at its space.
    pub fn readings(&self) -> &Readings {
        &self.readings
    }

    /// Mean base thickness `s_b`, mm: the one with which the gear, with the deviations `known` of it, has the readings' mean.
    ///
    /// # Errors
    /// [`GearError::WrongLength`]; readings of pins that would lie inside the base circle.
    pub fn base_thickness(&self, known: &Deviations) -> Result<f64, GearError> {
        let shifts = self.shifts(known)?;
        let read = self.readings.mean(|_, over| over);
        let mut base = thickness::base_from_over(&self.basic_data, self.body, self.pin, read)?;
        // Rounding of M is some ulps of the diameter.
        let settled = 4.0 * f64::EPSILON * read;
        let mut last = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            let [over, slope] = self
                .readings
                .means(|space, _| self.over(&shifts, space, base));
            let step = (read - over) / slope;
            // A pin in the base circle has no slope.
            if !(step.is_finite() && slope.is_finite()) {
                break;
            }
            base += step;
            // At the rounding, or as near as it gets.
            if step.abs() <= settled || (step.abs() >= last && last <= 1e3 * settled) {
                return Ok(base);
            }
            last = step.abs();
        }
        Err(GearError::Readings(
            "no mean thickness gives these dimensions over pins with this pitch",
        ))
    }

    /// What each reading is beyond the readings' mean, and what the deviations `of` say it is, mm, in the order of the readings.
    ///
    /// # Errors
    /// Those of [`PinReadings::base_thickness`].
    pub fn beside(&self, of: &Deviations) -> Result<Vec<(f64, f64)>, GearError> {
        let shifts = self.shifts(of)?;
        let base = self.base_thickness(of)?;
        let said = |space, _| self.over(&shifts, space, base)[0];
        Ok(self.readings.beside(said))
    }

    /// `M` at `space`, mm, and its derivative by `s_b`.
    fn over(&self, shifts: &FlankShifts, space: u32, base: f64) -> [f64; 2] {
        let apart = self.basic_data.teeth() / 2;
        let (one, other) = (
            self.centre(shifts, space, 0, base),
            self.centre(shifts, space, apart, base),
        );
        if self.body == MeasuringBody::Pin && self.basic_data.hand().is_some() {
            return [
                one.radius + other.radius + self.pin,
                one.slope + other.slope,
            ];
        }
        let angle = f64::from(apart) * self.basic_data.angular_pitch() + other.angle - one.angle;
        let (sin, cos) = angle.sin_cos();
        let (x, y) = (other.radius * cos - one.radius, other.radius * sin);
        let distance = x.hypot(y);
        let slope = (x * (other.slope * cos - one.slope) + y * other.slope * sin) / distance;
        [distance + self.pin, slope]
    }

    /// The pin's centre in the space `steps` on from `space`.
    fn centre(&self, shifts: &FlankShifts, space: u32, steps: u32, base: f64) -> Centre {
        let basic_data = &self.basic_data;
        let right = shifts.at(Flank::Right, space, steps);
        let left = shifts.at(Flank::Left, space, steps + 1);
        let thicker = (right - left) * basic_data.transverse_pressure_angle().cos();
        let radius = thickness::pin_centre_radius(basic_data, self.pin, base + thicker);
        // r_K = r_b √(1 + ξ²) and d inv/dξ = ξ²/(1 + ξ²): dr_K/ds_b = r_K/(2 r_b ξ) = 1/(2 sin α_K).
        let roll = involute::roll_at(radius, basic_data.base_radius());
        Centre {
            radius,
            angle: (right + left) / (2.0 * basic_data.reference_radius()),
            slope: radius / (2.0 * basic_data.base_radius() * roll),
        }
    }
}

/// Where a pin's centre lies.
struct Centre {
    /// `r_K`, mm.
    radius: f64,
    /// From the middle of its space, rad, ascending.
    angle: f64,
    /// `dr_K/ds_b`.
    slope: f64,
}
