//! Readings all round a gear, and the displacements of the flanks.

use super::{BasicGearData, Deviations, Flank, Gear, Hand, Lead, thickness};
use crate::error::GearError;
use std::collections::HashSet;

/// Lengths read at stated places: at least one reading, and each place at most once.
#[derive(Debug, Clone, PartialEq)]
pub struct Readings {
    teeth: u32,
    /// Place, from 1, and length, mm.
    list: Vec<(u32, f64)>,
}

impl Readings {
    /// Readings from a `list` of places (tooth numbers `1..=z`) and lengths, mm, on a gear of `basic_data`.
    ///
    /// # Errors
    /// [`GearError::Readings`]: no reading, a place outside `1..=z`, a place twice, a length that is not finite.
    pub fn new(basic_data: &BasicGearData, list: Vec<(u32, f64)>) -> Result<Readings, GearError> {
        let mut seen = HashSet::new();
        let teeth = basic_data.teeth();
        if list.is_empty() {
            return Err(GearError::Readings("there is no reading"));
        }
        for (place, mm) in &list {
            if !(1..=teeth).contains(place) {
                return Err(GearError::Readings("a reading is at no tooth of the gear"));
            }
            if !seen.insert(place) {
                return Err(GearError::Readings("two readings are at one tooth"));
            }
            if !mm.is_finite() {
                return Err(GearError::Readings("a reading is not finite"));
            }
        }
        Ok(Readings { teeth, list })
    }

    /// Place and length, mm, in the order given.
    pub fn list(&self) -> &[(u32, f64)] {
        &self.list
    }

    /// Whether every tooth has a reading.
    pub fn all_round(&self) -> bool {
        self.list.len() == self.teeth as usize
    }

    /// Each reading and its `expected` value, both minus their means, mm, in the order given.
    pub(super) fn compare(&self, expected: impl Fn(u32, f64) -> f64) -> Vec<(f64, f64)> {
        let [read, mean] = self.means(|place, mm| [mm, expected(place, mm)]);
        let list = self.list.iter();
        list.map(|&(place, mm)| (mm - read, expected(place, mm) - mean))
            .collect()
    }

    /// Mean of a value over all readings.
    pub(super) fn mean(&self, of: impl Fn(u32, f64) -> f64) -> f64 {
        let [mean] = self.means(|place, mm| [of(place, mm)]);
        mean
    }

    /// Means of several values over all readings.
    pub(super) fn means<const N: usize>(&self, of: impl Fn(u32, f64) -> [f64; N]) -> [f64; N] {
        let mut sums = [0.0; N];
        for &(place, mm) in &self.list {
            for (sum, value) in sums.iter_mut().zip(of(place, mm)) {
                *sum += value;
            }
        }
        sums.map(|sum| sum / self.list.len() as f64)
    }
}

/// Displacement of each of the gear's own flanks, right and left, along ascending numbers, mm at the reference circle.
///
/// A pitch deviation moves a flank by `F`. A thickness `δ` moves the right flank, towards the next number, by `δ/2` and the left
/// flank by `−δ/2`.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct FlankShifts(pub(super) [Vec<f64>; 2]);

impl FlankShifts {
    /// The displacements by `deviations`, without their eccentricity.
    ///
    /// # Errors
    /// [`GearError::WrongLength`].
    pub(super) fn new(
        basic_data: &BasicGearData,
        deviations: &Deviations,
    ) -> Result<FlankShifts, GearError> {
        let teeth = basic_data.teeth();
        let shifts = |side: Flank| {
            let mut shifts = vec![0.0; teeth as usize];
            let thickness = (!deviations.per_tooth.is_empty()).then_some(&deviations.per_tooth[..]);
            let pitch = deviations.pitch.as_ref().map(|pitch| pitch.flank(side));
            // Right flanks are on the ascending side of their tooth.
            let half = -side.sense() / (2.0 * basic_data.helix_cos());
            for (what, list, factor) in [
                ("thickness of each tooth", thickness, half),
                ("pitch", pitch, 1.0),
            ] {
                let Some(list) = list else { continue };
                if list.len() != shifts.len() {
                    let found = list.len();
                    return Err(GearError::WrongLength { what, found, teeth });
                }
                for (shift, value) in shifts.iter_mut().zip(list) {
                    *shift += factor * value;
                }
            }
            Ok(shifts)
        };
        let [right, left] = Flank::BOTH.map(shifts);
        Ok(FlankShifts([right?, left?]))
    }

    /// The displacements by `leads` where the anvils of a span over `k` teeth touch a helical gear; empty for a spur gear.
    ///
    /// A span is normal to the helix. Its contacts are `W_k sin β_b` apart along the face. The height at which the thickness was measured is
    /// midway between them. A lead deviation counts along the transverse base tangent, as a profile deviation does. That the anvils follow a
    /// slope is neglected: 1 nm at 10 µm over 24 mm.
    ///
    /// # Errors
    /// As [`Lead::curves`].
    pub(crate) fn of_leads(
        gear: &Gear,
        leads: &[Lead; 2],
        k: u32,
    ) -> Result<FlankShifts, GearError> {
        let basic_data = gear.basic_data();
        let Some(hand) = basic_data.hand() else {
            return Ok(FlankShifts::default());
        };
        let span = thickness::span_from_base(basic_data, k, gear.base_thickness());
        let half = 0.5 * span * basic_data.base_helix_angle().abs().sin();
        let cos = basic_data.transverse_pressure_angle().cos();
        let teeth = basic_data.teeth();
        let of_side = |own: Flank| -> Result<Vec<f64>, GearError> {
            let lead = &leads[own.index()];
            if lead.is_none() {
                return Ok(vec![0.0; teeth as usize]);
            }
            let curves = lead.curves(teeth)?;
            let is_above = (own == Flank::Right) != (hand == Hand::Right);
            let height = lead.zero + if is_above { half } else { -half };
            let shift = |tooth| -own.sense() / cos * curves.of(tooth).at(height);
            Ok((1..=teeth).map(shift).collect())
        };
        let [right, left] = Flank::BOTH.map(of_side);
        Ok(FlankShifts([right?, left?]))
    }

    /// These and further displacements; either may be empty.
    pub(crate) fn plus(mut self, more: &FlankShifts) -> FlankShifts {
        for (shifts, more) in self.0.iter_mut().zip(&more.0) {
            shifts.resize(shifts.len().max(more.len()), 0.0);
            for (shift, more) in shifts.iter_mut().zip(more) {
                *shift += more;
            }
        }
        self
    }

    /// Whether no displacement differs by more than `most`, mm.
    pub(crate) fn is_near(&self, other: &FlankShifts, most: f64) -> bool {
        let near = |own: Flank| {
            let mut pairs = self.flank(own).iter().zip(other.flank(own));
            pairs.all(|(one, other)| (one - other).abs() <= most)
        };
        Flank::BOTH.into_iter().all(near)
    }

    /// Displacements of the own `flank`, tooth 1 first.
    pub(crate) fn flank(&self, own: Flank) -> &[f64] {
        &self.0[own.index()]
    }

    /// Displacement of the `own` flank of the tooth `steps` after `tooth` (from 1), numbers modulo `z`.
    pub(super) fn at(&self, own: Flank, tooth: u32, steps: u32) -> f64 {
        let list = self.flank(own);
        let index = (tooth as usize + steps as usize).saturating_sub(1) % list.len().max(1);
        list.get(index).copied().unwrap_or(0.0)
    }
}
