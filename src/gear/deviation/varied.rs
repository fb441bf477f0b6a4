//! A gear like another, but for what scatters from gear to gear.

use super::{AsBuilt, Deviations};
use crate::error::GearError;
use crate::gear::modified_flanks::ModifiedHalves;
use crate::gear::{Face, Gear, thickness};
use std::sync::Arc;

impl AsBuilt {
    /// This gear with all teeth `thicker`, mm at the reference circle, cut so by the tool (root and fillet follow, as in [`Gear::new`]),
    /// and with pitch and per-tooth thickness of `further` on top of its own. Its runout and its profiles stay.
    ///
    /// # Errors
    /// As [`Gear::new`] and [`AsBuilt::new`]; a gear with straight flanks, whose thickness no tool sets.
    pub fn varied(&self, thicker: f64, further: &Deviations) -> Result<AsBuilt, GearError> {
        if !self.gear.is_generated() {
            return Err(GearError::OutOfRange {
                what: "scatter of straight flanks (mm)",
                value: thicker,
                allowed: "none: only teeth that a rack cuts are varied",
            });
        }
        let basic_data = self.gear.basic_data();
        let base = thickness::base_from_allowance(basic_data, self.gear.base_thickness(), thicker);
        let gear = match thicker == 0.0 {
            true => self.gear.clone(),
            false => Gear::new(*self.gear.design(), base)?,
        };
        let modified = self.modified_of(&gear, 1.0)?;
        let own = [self.right.to_vec(), self.left.to_vec()];
        let [right, left] = further.offsets(basic_data, self.face, own)?;
        let varied = AsBuilt {
            gear,
            modified,
            right: Arc::from(right),
            left: Arc::from(left),
            ..self.clone()
        };
        varied.check_runout()?;
        varied.check_teeth()?;
        Ok(varied)
    }

    /// The transverse section of this helical gear at `b`, mm along the axis from its measuring plane away from the viewer: see [`crate::pair::GearPair::section`].
    #[must_use]
    pub fn section_at(&self, b: f64) -> AsBuilt {
        self.section(b * self.gear.basic_data().twist())
    }

    /// The transverse section of this gear in which its teeth stand turned by `angle`, rad, counter-clockwise as seen from the front, with its teeth
    /// where they are in the measuring plane: the eccentricity, which does not wind about the axis, turned back by as much.
    pub(crate) fn section(&self, angle: f64) -> AsBuilt {
        let teeth = self.face.ascending() * angle / self.gear.basic_data().angular_pitch();
        let count = f64::from(self.gear.basic_data().teeth());
        let high_tooth = 1.0 + (self.high_tooth - 1.0 - teeth).rem_euclid(count);
        AsBuilt {
            high_tooth,
            ..self.clone()
        }
    }

    /// This gear with its reference face towards `face`: turned over, each flank what it is on the gear's own faces.
    ///
    /// Turned over, the gear's own right flanks stand on the other side of the picture, and what was clockwise is counter-clockwise.
    #[must_use]
    pub fn facing(&self, face: Face) -> AsBuilt {
        if face == self.face {
            return self.clone();
        }
        let turned = |list: &[f64]| list.iter().map(|offset| -offset).collect();
        let swapped = |sides: &[ModifiedHalves; 2]| {
            let [right, left] = sides;
            Arc::new([left.clone(), right.clone()])
        };
        AsBuilt {
            face,
            right: turned(&self.left),
            left: turned(&self.right),
            modified: self.modified.as_deref().map(swapped),
            ..self.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{GearDesign, Pitch, Side};

    /// In two steps as in one.
    #[test]
    fn a_gear_varied_is_the_gear_made_so() {
        let design = GearDesign::plain(30, 2.0);
        let wave = |phase: f64| -> Vec<f64> {
            (0..30)
                .map(|k| 0.004 * (f64::from(k) + phase).sin())
                .collect()
        };
        let deviations = |per_tooth: Vec<f64>, phase: f64| Deviations {
            per_tooth,
            pitch: Some(Pitch::from_cumulative(&wave(phase), &wave(2.0 * phase))),
            eccentricity: 0.01,
            high_tooth: 3.0,
            ..Deviations::default()
        };
        let thick = vec![0.002; 30];
        for face in [Face::Front, Face::Back] {
            let nominal = Gear::nominal(design).unwrap();
            let own = deviations(Vec::new(), 1.0);
            let plain = AsBuilt::new(nominal, face, &own).unwrap();
            let varied = plain
                .varied(-0.05, &deviations(thick.clone(), 0.3))
                .unwrap();
            let base = design.nominal_base_thickness() - 0.05 * 20f64.to_radians().cos();
            let gear = Gear::new(design, base).unwrap();
            let own = AsBuilt::new(gear.clone(), face, &own).unwrap();
            let other = AsBuilt::new(gear.clone(), face, &deviations(thick.clone(), 0.3)).unwrap();
            let turned = match face {
                Face::Front => Face::Back,
                Face::Back => Face::Front,
            };
            let over = AsBuilt::new(gear, turned, &deviations(thick.clone(), 0.3)).unwrap();
            assert_eq!(other.facing(turned), over);
            assert_eq!(varied.gear(), own.gear());
            assert_eq!((varied.eccentricity(), varied.high_tooth()), (0.01, 3.0));
            for side in Side::BOTH {
                for tooth in 1..=30 {
                    let sum = own.flank_offset(side, tooth) + other.flank_offset(side, tooth);
                    assert!((varied.flank_offset(side, tooth) - sum).abs() < 1e-16);
                }
            }
        }
    }
}
