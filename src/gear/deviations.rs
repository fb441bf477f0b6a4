//! The deviations of a gear's flanks and of its axis from the design.

use super::{BasicGearData, Face, Flank, Lead, Modification, Pitch, Side};
use crate::error::GearError;
use std::f64::consts::PI;

/// Measured deviations beside the mean thickness. Lengths in mm; empty or zero where nothing was measured.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Deviations {
    /// Tooth thickness added to the mean, per tooth, at the reference circle; empty or `z` values.
    pub per_tooth: Vec<f64>,
    /// Pitch deviation of both flanks, free of eccentricity.
    pub pitch: Option<Pitch>,
    /// Distance `e` of the outline's centre from the rotation axis, half the runout `F_r`.
    pub eccentricity: f64,
    /// Tooth (fractional, `1 ≤ … < z + 1`) towards which the outline is displaced.
    pub high_tooth: f64,
    /// Whether the direction is unknown: a pose uses `high_tooth`, extremes cover all directions.
    pub any_direction: bool,
    /// Lean of the teeth's axis from the rotation axis (wobble), mm per mm.
    pub wobble: f64,
    /// Tooth (fractional) towards which the teeth lean away from the reference face.
    pub wobble_tooth: f64,
    /// Profile deviation of the gear's own right flanks, and of its left ones.
    pub profiles: [Modification; 2],
    /// Lead deviation of the gear's own right flanks, and of its left ones.
    pub leads: [Lead; 2],
}

impl Deviations {
    /// Whether leads change spans. They do on helical gears: the contacts of a span are apart along the face.
    pub(crate) fn leads_change_spans(&self, basic_data: &BasicGearData) -> bool {
        basic_data.hand().is_some() && !self.leads.iter().all(Lead::is_none)
    }

    /// Adds thickness, mm, to every tooth, tooth 1 first.
    pub(crate) fn thicken(&mut self, by: &[f64]) {
        self.per_tooth.resize(by.len(), 0.0);
        for (thickness, by) in self.per_tooth.iter_mut().zip(by) {
            *thickness += by;
        }
    }

    /// Adds the rotations by thickness and pitch to the `offsets` of the right and left flanks, rad, counter-clockwise.
    pub(super) fn offsets(
        &self,
        basic_data: &BasicGearData,
        face: Face,
        mut offsets: [Vec<f64>; 2],
    ) -> Result<[Vec<f64>; 2], GearError> {
        let teeth = basic_data.teeth();
        let length = |what, list: &[f64]| match list.len() {
            found if found == teeth as usize => Ok(()),
            found => Err(GearError::WrongLength { what, found, teeth }),
        };
        let r = basic_data.reference_radius();
        if !self.per_tooth.is_empty() {
            length("thickness of each tooth", &self.per_tooth)?;
            for side in Side::BOTH {
                for (offset, thickness) in offsets[side.index()].iter_mut().zip(&self.per_tooth) {
                    *offset += side.sense() * thickness / (2.0 * r * basic_data.helix_cos());
                }
            }
        }
        if let Some(pitch) = &self.pitch {
            for own in Flank::BOTH {
                let curve = pitch.flank(own);
                length("pitch", curve)?;
                for &f in curve {
                    let is_near = f.abs() < PI * basic_data.module() / 2.0;
                    let allowed = "less than half a pitch";
                    GearError::require(is_near, "pitch deviation (mm)", f, allowed)?;
                }
                let side = face.seen_from_front(own);
                for (offset, f) in offsets[side.index()].iter_mut().zip(curve) {
                    *offset += face.ascending() * f / r;
                }
            }
        }
        Ok(offsets)
    }
}
