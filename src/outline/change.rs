//! The change of one gear into another: thickness, pitch, leads, wobble and runout.

use super::gear::OutlineGear;
use crate::error::{GearError, OutlineError};
use crate::gear::{AsBuilt, Deviations, Lead, Pitch};

/// How a gear differs from the one it is made from; lengths in mm. `None` or empty: as that one has it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct GearChange {
    /// Another gear in its place, which then changes further.
    pub whole: Option<AsBuilt>,
    /// Additional thickness of all teeth: at the reference circle, or of a drawn gear along the normals of its flanks.
    pub thicker: Option<f64>,
    /// Additional thickness of each tooth.
    pub per_tooth: Vec<f64>,
    /// Further pitch deviations.
    pub pitch: Option<Pitch>,
    /// Further leads of the gear's own right and left flanks.
    pub leads: Option<[Lead; 2]>,
    /// Another wobble, mm per mm, and the tooth towards which the teeth lean.
    pub wobble: Option<[f64; 2]>,
    /// Another eccentricity, and the high tooth; without one it has any direction.
    pub runout: Option<(f64, Option<f64>)>,
}

impl GearChange {
    /// `gear` after this change. Where teeth lean, wobble and runout are those of its measuring plane.
    pub(super) fn of_data(&self, gear: &AsBuilt) -> Result<AsBuilt, GearError> {
        let mut gear = self.whole.as_ref().unwrap_or(gear).clone();
        if self.thicker.is_some() || self.pitch.is_some() || !self.per_tooth.is_empty() {
            let further = Deviations {
                per_tooth: self.per_tooth.clone(),
                pitch: self.pitch.clone(),
                ..Deviations::default()
            };
            gear = gear.varied(self.thicker.unwrap_or(0.0), &further)?;
        }
        if let Some(leads) = &self.leads {
            gear = gear.with_further_leads(leads)?;
        }
        let place = gear.place();
        let leans = self.wobble.is_some() || self.runout.is_some() && gear.wobble() != 0.0;
        if leans {
            gear = gear.in_measuring_plane();
        }
        if let Some((eccentricity, tooth)) = self.runout {
            gear = gear.with_runout(eccentricity, tooth)?;
        }
        if let Some([lean, tooth]) = self.wobble {
            gear = gear.with_wobble(lean, tooth);
        }
        Ok(if leans { gear.section_at(place) } else { gear })
    }

    /// Whether this change is possible for `gear` of a pair with a drawn gear: the thickness of a drawn one, and a runout of known direction.
    pub(super) fn is_possible(&self, gear: &OutlineGear) -> bool {
        let outline = GearChange {
            thicker: self.thicker.filter(|_| gear.flank_offset().is_some()),
            runout: self.runout.filter(|(_, tooth)| tooth.is_some()),
            ..GearChange::default()
        };
        *self == outline
    }

    /// `gear` after this change, which [is possible](GearChange::is_possible).
    pub(super) fn of_outline(&self, gear: &OutlineGear) -> Result<OutlineGear, OutlineError> {
        let mut gear = gear.clone();
        if let Some(by) = self.thicker {
            gear = gear.thicker(by)?;
        }
        if let Some((eccentricity, Some(tooth))) = self.runout {
            gear = gear.with_runout(eccentricity, tooth)?;
        }
        Ok(gear)
    }
}
