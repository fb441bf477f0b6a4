//! Radial runout readings of a ball or a fork → eccentricity.
//!
//! A reading is the distance of a probe from the rotation axis. It contains the outline's displacement `e` and an effect of the
//! flanks: a ball sinks into a wide space, a fork rides on a thick tooth. A first harmonic of the tooth thickness looks like an
//! eccentricity, and readings alone cannot distinguish the two. With known pitch and thickness, their effect is removed exactly.
//! Pitch about the *datum* axis contains the eccentricity in both flanks, so it predicts the whole reading of a ball.
//!
//! In a helical gear everything lies in the measuring plane; `α`, `s_b` and `p_b` are transverse.
//!
//! - A *ball* of diameter `D_M` rests in space `i` on two flanks. The right flank of tooth `i` is `x_R` beyond its place
//!   (ascending, reference circle), the left flank of tooth `i + 1` is `x_L` beyond its own. As for a pin (see [`super::pins`]),
//!   the centre lies at `inv α_K = (D_M − p_b + s_b + (x_R − x_L) cos α)/d_b`, `(x_R + x_L)/(2 r)` from the space's middle. The
//!   reading is the distance of this centre, displaced by `e`, from the axis. On helical flanks `D_M/cos β_b` replaces `D_M`.
//! - A *fork* sits astride tooth `i`, its two plane faces inclined to its axis by `α`. It slides towards the rotation axis while
//!   the gear turns, until both faces touch. Let the outward normal of a face have the angle `π/2 − α` to the fork's axis. The face
//!   touches an involute of half base angle `ψ` at the distance `r_b (ψ + π/2 − α + const)` from the gear's centre. Let the gear
//!   be turned by `σ`, with its centre at `(C_x, C_y)` from the axis. Both faces meet at the apex
//!   `d = C_x + (x_R − x_L)/(2 tan α) + const`, and `r σ = −C_y − (x_R + x_L)/2` (own derivation). At a helical tooth the faces are
//!   inclined to the axis by `β_b` and cross the measuring plane in the lines of this derivation.

use super::{Deviations, Excess, Flank, FlankShifts, Gear, thickness};
use crate::error::GearError;
use crate::numeric::range;
use nalgebra::{Complex, Vector2};
use std::f64::consts::TAU;

/// Most corrections of the eccentricity; each leaves about `e/r` of the error.
const MOST_CORRECTIONS: usize = 50;

/// A probe that touches the flanks.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Probe {
    /// A ball of this diameter, mm, in the space after each tooth, towards the next number.
    Ball(f64),
    /// A fork astride each tooth, its faces at the pressure angle.
    Fork,
}

/// Readings all round, mm, + = outwards, from any common zero: one per tooth, tooth 1 first.
#[derive(Debug, Clone, PartialEq)]
pub struct RunoutReadings {
    /// The probe.
    pub probe: Probe,
    /// The readings.
    pub mm: Vec<f64>,
}

/// Eccentricity fitted to the readings of a gear with known flanks. Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct RunoutFit {
    /// Eccentricity `e`.
    pub eccentricity: f64,
    /// Tooth (fractional, `1 ≤ … < z + 1`) towards which the outline is displaced.
    pub high_tooth: f64,
    /// `F_r` of the readings: greatest minus least.
    pub range: f64,
    /// `F_r` expected from the known gear.
    pub known_range: f64,
    /// Each reading and its value expected from the known flanks, both without mean, eccentricity and first harmonic.
    pub rest: Vec<(f64, f64)>,
}

impl Probe {
    /// Pitches from the centre of a tooth to the place of its reading.
    pub fn ahead(self) -> f64 {
        match self {
            Probe::Ball(_) => 0.5,
            Probe::Fork => 0.0,
        }
    }
}

impl RunoutReadings {
    /// The eccentricity of `gear`, with the flank deviations `known`, that leaves no first harmonic in the readings.
    ///
    /// Over `z` equally spaced readings, 1, `cos θ` and `sin θ` are orthogonal with the norms `z`, `z/2`, `z/2` (`z ≥ 3`). To first
    /// order the correction is `2/z Σ rest (cos θ, sin θ)`.
    ///
    /// # Errors
    /// [`GearError::WrongLength`]; [`GearError::Readings`] when no eccentricity explains the readings.
    pub fn fit(&self, gear: &Gear, known: &Deviations) -> Result<RunoutFit, GearError> {
        let basic_data = gear.basic_data();
        let teeth = basic_data.teeth();
        if self.mm.len() != teeth as usize {
            return Err(GearError::WrongLength {
                what: "runout",
                found: self.mm.len(),
                teeth,
            });
        }
        let shifts = FlankShifts::new(basic_data, known)?.plus(&self.touched(gear, known)?);
        let even = FlankShifts::new(basic_data, &Deviations::default())?;
        let greatest = self.mm.iter().fold(0.0, |most: f64, mm| most.max(mm.abs()));
        // Rounding of readings and radii is some ulps of them.
        let settled = 1e-13 * (basic_data.reference_radius() + greatest);
        let mut e = Vector2::zeros();
        for _ in 0..MOST_CORRECTIONS {
            let expected = self.expected(gear, &shifts, e);
            let correction = self.first_harmonic(&difference(&self.mm, &expected));
            e += correction;
            if correction.norm() <= settled {
                if e.norm() <= settled {
                    e = Vector2::zeros();
                }
                let perfect = self.expected(gear, &even, e);
                let read = self.without_first(difference(&self.mm, &perfect));
                let flanks = self.without_first(difference(&expected, &perfect));
                return Ok(RunoutFit {
                    eccentricity: e.norm(),
                    high_tooth: basic_data.tooth_towards(e.y.atan2(e.x)),
                    range: range(&self.mm),
                    known_range: range(&expected),
                    rest: read.into_iter().zip(flanks).collect(),
                });
            }
            if !(e.norm() < basic_data.reference_radius()) {
                break;
            }
        }
        Err(GearError::Readings(
            "no eccentricity explains these runout readings",
        ))
    }

    /// Excess of the profiles where the probe touches; the fork touches near the reference circle.
    fn touched(&self, gear: &Gear, known: &Deviations) -> Result<FlankShifts, GearError> {
        let Some(excess) = Excess::new(gear, &known.profiles)? else {
            return Ok(FlankShifts::default());
        };
        match self.probe {
            Probe::Ball(diameter) => {
                let near = excess.by_pins(diameter, known, &FlankShifts::default())?;
                excess.by_pins(diameter, known, &near)
            }
            Probe::Fork => Ok(excess.by_reference_circle()),
        }
    }

    /// Expected readings, mm, up to a constant.
    fn expected(&self, gear: &Gear, shifts: &FlankShifts, e: Vector2<f64>) -> Vec<f64> {
        let basic_data = gear.basic_data();
        let (r, alpha) = (
            basic_data.reference_radius(),
            basic_data.transverse_pressure_angle(),
        );
        let e = Complex::new(e.x, e.y);
        let reading = |tooth: u32| {
            let steps = u32::from(matches!(self.probe, Probe::Ball(_)));
            let right = shifts.at(Flank::Right, tooth, 0);
            let left = shifts.at(Flank::Left, tooth, steps);
            let middle = self.angle(tooth as usize - 1) + (right + left) / (2.0 * r);
            let seen = e * Complex::from_polar(1.0, -middle);
            match self.probe {
                Probe::Ball(diameter) => {
                    let base = gear.base_thickness() + (right - left) * alpha.cos();
                    (seen + thickness::pin_centre_radius(basic_data, diameter, base)).norm()
                }
                Probe::Fork => {
                    // The turn is at most e/r; each step multiplies its error by e/r.
                    let turned = (0..MOST_CORRECTIONS)
                        .fold(seen, |at, _| seen * Complex::from_polar(1.0, -at.im / r));
                    turned.re + (right - left) / (2.0 * alpha.tan())
                }
            }
        };
        (1..=basic_data.teeth()).map(reading).collect()
    }

    /// Angle of the reading with this index, rad from the centre of tooth 1, ascending.
    fn angle(&self, index: usize) -> f64 {
        (index as f64 + self.probe.ahead()) * TAU / self.mm.len().max(1) as f64
    }

    fn first_harmonic(&self, list: &[f64]) -> Vector2<f64> {
        let count = list.len().max(1) as f64;
        let mean = list.iter().sum::<f64>() / count;
        let parts = list.iter().enumerate().map(|(index, value)| {
            let (sin, cos) = self.angle(index).sin_cos();
            (value - mean) * Vector2::new(cos, sin)
        });
        parts.sum::<Vector2<f64>>() * (2.0 / count)
    }

    fn without_first(&self, mut list: Vec<f64>) -> Vec<f64> {
        let mean = list.iter().sum::<f64>() / list.len().max(1) as f64;
        let first = self.first_harmonic(&list);
        for (index, value) in list.iter_mut().enumerate() {
            let (sin, cos) = self.angle(index).sin_cos();
            *value -= mean + first.x * cos + first.y * sin;
        }
        list
    }
}

fn difference(list: &[f64], other: &[f64]) -> Vec<f64> {
    list.iter().zip(other).map(|(a, b)| a - b).collect()
}
