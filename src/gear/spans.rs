//! Spans all round: mean base thickness, and each tooth's own thickness where the readings determine it.
//!
//! The span *at tooth i* covers the `k` teeth `i … i + k − 1`, numbers ascending modulo `z`. It runs along a base tangent from
//! the left flank of `i` to the right flank of `i + k − 1`. A flank displaced by `x` (at the reference circle) moves its end by
//! `x cos α`. With pitch deviation `F` and per-tooth thickness `δ` (own derivation, beside K (15)):
//!
//! ```text
//! W_k,i = (k − 1) p_b + s_b + cos α (F_R,i+k−1 − F_L,i) + cos α (δ_i + δ_i+k−1)/2
//! ```
//!
//! The eccentricity does not matter. With all `z` spans and `k > 1`, the `δ` follow from `c_i = (δ_i + δ_i+k−1)/2`. The steps
//! of `k − 1` teeth form `gcd(z, k − 1)` cycles of `L = z/gcd(z, k − 1)` teeth. For odd `L`,
//! `δ_i = c_i − c_i+1 + c_i+2 − … + c_i+L−1` round a cycle. For even `L`, no span shows a thickness that alternates along the
//! cycle. The Fourier transform agrees: the eigenvalues have the absolute values `|cos(π (k − 1) j/z)|`.

use super::{BasicGearData, Deviations, Flank, FlankShifts, Readings};
use crate::error::GearError;
use crate::numeric::gcd;

/// Spans `W_k` over `k` teeth, at stated first teeth.
#[derive(Debug, Clone, PartialEq)]
pub struct Spans {
    basic_data: BasicGearData,
    k: u32,
    readings: Readings,
    /// Excess of the profiles at the contacts.
    touched: FlankShifts,
}

/// Thickness of each tooth beyond the mean, from spans all round.
#[derive(Debug, Clone, PartialEq)]
pub struct PerTooth {
    /// `δ` at the reference circle, mm, tooth 1 first; mean 0.
    pub thickness: Vec<f64>,
    /// `L`: a tooth's base thickness has up to `L` times the error of a reading, or `√L` times for random errors.
    pub amplification: u32,
}

impl Spans {
    /// Spans over `k` teeth, `1..=z`, read at their first teeth.
    ///
    /// # Errors
    /// [`GearError::OutOfRange`] for `k`.
    pub fn new(basic_data: &BasicGearData, k: u32, readings: Readings) -> Result<Spans, GearError> {
        GearError::require(
            (1..=basic_data.teeth()).contains(&k),
            "number of teeth spanned",
            f64::from(k),
            "1 … number of teeth",
        )?;
        Ok(Spans {
            basic_data: *basic_data,
            k,
            readings,
            touched: FlankShifts::default(),
        })
    }

    /// These spans on flanks with the excess `touched` at the contacts.
    pub(crate) fn touching(self, touched: FlankShifts) -> Spans {
        Spans { touched, ..self }
    }

    fn shifts(&self, known: &Deviations) -> Result<FlankShifts, GearError> {
        Ok(FlankShifts::new(&self.basic_data, known)?.plus(&self.touched))
    }

    /// Whether spans over `k` teeth at all `z` teeth determine each tooth: `L = z/gcd(z, k − 1)` is odd.
    pub fn determine(z: u32, k: u32) -> bool {
        !cycle(z, k).is_multiple_of(2)
    }

    /// `k`.
    pub fn teeth(&self) -> u32 {
        self.k
    }

    /// The readings, each at its first tooth.
    pub fn readings(&self) -> &Readings {
        &self.readings
    }

    /// Mean base thickness `s_b`, mm, with which a gear with the deviations `known` has the mean of the readings.
    ///
    /// # Errors
    /// [`GearError::WrongLength`].
    pub fn base_thickness(&self, known: &Deviations) -> Result<f64, GearError> {
        let shifts = self.shifts(known)?;
        Ok(self
            .readings
            .mean(|tooth, span| self.base_at(&shifts, tooth, span)))
    }

    /// The thickness of each tooth beyond mean and `known` that gives every reading.
    ///
    /// `None` with fewer than `z` readings or an even `L`. Along a cycle `δ_i+k−1 = 2 c_i − δ_i` carries an error without growth: the
    /// rounding error is at most `3 L` ulps of the greatest `c_i`.
    ///
    /// # Errors
    /// [`GearError::WrongLength`].
    pub fn per_tooth(&self, known: &Deviations) -> Result<Option<PerTooth>, GearError> {
        let (z, step) = (self.basic_data.teeth(), self.k - 1);
        let length = cycle(z, self.k);
        if !self.readings.all_round() || !Spans::determine(z, self.k) {
            return Ok(None);
        }
        let shifts = self.shifts(known)?;
        let mean = self.base_thickness(known)?;
        let mut beyond = vec![0.0; z as usize];
        for &(tooth, span) in self.readings.list() {
            beyond[tooth as usize - 1] = self.base_at(&shifts, tooth, span) - mean;
        }
        let cos = super::thickness::per_normal_thickness(&self.basic_data);
        let on = |index: usize| (index + step as usize) % z as usize;
        let mut thickness = vec![0.0; z as usize];
        for first in 0..(z / length) as usize {
            let mut sum = 0.0;
            let mut at = first;
            for n in 0..length {
                let sign = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
                sum += sign * beyond[at];
                at = on(at);
            }
            for _ in 0..length {
                thickness[at] = sum / cos;
                sum = 2.0 * beyond[at] - sum;
                at = on(at);
            }
        }
        Ok(Some(PerTooth {
            thickness,
            amplification: length,
        }))
    }

    /// Each reading minus the mean, and its value expected from the deviations `of`, mm, in the order of the readings.
    ///
    /// # Errors
    /// [`GearError::WrongLength`].
    pub fn compare(&self, of: &Deviations) -> Result<Vec<(f64, f64)>, GearError> {
        let shifts = self.shifts(of)?;
        let expected = |tooth, span| span - self.base_at(&shifts, tooth, span);
        Ok(self.readings.compare(expected))
    }

    /// `s_b` from a single reading, without the shifts of its flanks.
    fn base_at(&self, shifts: &FlankShifts, first: u32, span: f64) -> f64 {
        let step = self.k - 1;
        let apart = shifts.at(Flank::Right, first, step) - shifts.at(Flank::Left, first, 0);
        super::thickness::base_from_span(&self.basic_data, self.k, span)
            - self.basic_data.transverse_pressure_angle().cos() * apart
    }
}

/// `L`: number of teeth in a cycle with steps of `k − 1`.
fn cycle(z: u32, k: u32) -> u32 {
    z / gcd(z, k.saturating_sub(1)).max(1)
}

#[cfg(test)]
mod tests {
    use super::cycle;

    /// Steps of `k − 1` teeth return to the first tooth after `lcm(z, k − 1)/(k − 1)` steps.
    #[test]
    fn a_cycle_of_spans_ends_where_its_steps_meet_the_first_tooth() {
        for z in 3..60u32 {
            for k in 2..=z {
                let first_again = (1..=z).find(|steps| steps * (k - 1) % z == 0);
                assert_eq!(Some(cycle(z, k)), first_again, "{k} of {z}");
            }
        }
    }
}
