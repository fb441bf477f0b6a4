//! Dimension over two pins all round: the mean base thickness.
//!
//! The pin *in space i* lies between the right flank of tooth `i` and the left flank of tooth `i + 1`, numbers ascending.
//! A reading *at space i* has one pin there and the other in the most opposite space: `i + z/2` for even `z`, `i + (z − 1)/2`
//! for odd `z`. For even `z` the readings at `i` and `i + z/2` measure the same pair.
//!
//! The centre of a circle of diameter `D_M` that touches an involute lies on that involute turned by `D_M/d_b`. Let the flanks be
//! `x_R` and `x_L` beyond their places (ascending, reference circle). The centre then lies, from the space's middle, at (own
//! derivation; for `x = 0` see [`super::thickness::base_from_pins`])
//!
//! ```text
//! inv α_K = (D_M − p_b + s_b + (x_R − x_L) cos α)/d_b        angle = middle + (x_R + x_L)/(2 r)
//! ```
//!
//! `M` is the greatest distance of two parallel planes that touch both pins: the distance of the centres plus `D_M`. The
//! eccentricity does not matter. In a helical gear, `D_M/cos β_b` replaces `D_M` in `inv α_K`. Helical pins slide along their
//! spaces until they are opposite each other: `M` is then the sum of both radii and `D_M`.
//!
//! Readings over pins do not give the thickness of each tooth: each depends on four flanks, and for even `z` only `z/2` differ.

use super::thickness::MeasuringBody;
use super::{BasicGearData, Deviations, Flank, FlankShifts, Readings, involute, thickness};
use crate::error::GearError;

/// Most steps of Newton's method for the mean thickness; it needs some five.
const MOST_STEPS: usize = 50;

/// Dimensions `M_dK` over two pins or balls, at stated spaces.
#[derive(Debug, Clone, PartialEq)]
pub struct PinReadings {
    basic_data: BasicGearData,
    body: MeasuringBody,
    pin: f64,
    readings: Readings,
    /// Excess of the profiles at the contacts.
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

    /// These readings on flanks with the excess `touched` at the contacts.
    pub(crate) fn touching(self, touched: FlankShifts) -> PinReadings {
        PinReadings { touched, ..self }
    }

    fn shifts(&self, known: &Deviations) -> Result<FlankShifts, GearError> {
        Ok(FlankShifts::new(&self.basic_data, known)?.plus(&self.touched))
    }

    /// `D_M`, mm.
    pub fn pin(&self) -> f64 {
        self.pin
    }

    /// The readings, each at its space.
    pub fn readings(&self) -> &Readings {
        &self.readings
    }

    /// Mean base thickness `s_b`, mm, with which a gear with the deviations `known` has the mean of the readings.
    ///
    /// # Errors
    /// [`GearError::WrongLength`]; readings that place the pins inside the base circle.
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
            // A pin inside the base circle has no slope.
            if !(step.is_finite() && slope.is_finite()) {
                break;
            }
            base += step;
            // Settled to rounding, or no longer shrinking.
            if step.abs() <= settled || (step.abs() >= last && last <= 1e3 * settled) {
                return Ok(base);
            }
            last = step.abs();
        }
        Err(GearError::Readings(
            "no mean thickness gives these dimensions over pins with this pitch",
        ))
    }

    /// Each reading minus the mean, and its value expected from the deviations `of`, mm, in the order of the readings.
    ///
    /// # Errors
    /// As [`PinReadings::base_thickness`].
    pub fn compare(&self, of: &Deviations) -> Result<Vec<(f64, f64)>, GearError> {
        let shifts = self.shifts(of)?;
        let base = self.base_thickness(of)?;
        let expected = |space, _| self.over(&shifts, space, base)[0];
        Ok(self.readings.compare(expected))
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

    /// The centre of the pin in the space `steps` after `space`.
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

/// The centre of a pin.
struct Centre {
    /// `r_K`, mm.
    radius: f64,
    /// Angle from the middle of its space, rad, ascending.
    angle: f64,
    /// `dr_K/ds_b`.
    slope: f64,
}
