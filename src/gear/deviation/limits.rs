//! What deviations leave of a gear: its axis inside its body, and a tip, a neck and a space at every tooth.

use super::AsBuilt;
use crate::error::GearError;
use crate::gear::{ProfilePart, Side};

impl AsBuilt {
    /// The axis stays within the tooth depth and inside the body, and the high tooth is one of the gear's.
    pub(super) fn check_runout(&self) -> Result<(), GearError> {
        let depth = self.gear.tip_radius() - self.gear.root_radius();
        if !(self.eccentricity >= 0.0 && 2.0 * self.eccentricity < depth) {
            return Err(GearError::OutOfRange {
                what: "runout (mm)",
                value: 2.0 * self.eccentricity,
                allowed: "at least 0 and less than the tooth depth",
            });
        }
        if !(self.eccentricity < self.gear.root_radius()) {
            return Err(GearError::OutOfRange {
                what: "runout (mm)",
                value: 2.0 * self.eccentricity,
                allowed: "less than the root diameter: the axis would lie outside the gear's body",
            });
        }
        let teeth = f64::from(self.gear.basic_data().teeth());
        if self.eccentricity > 0.0 && !(self.high_tooth >= 1.0 && self.high_tooth < teeth + 1.0) {
            return Err(GearError::OutOfRange {
                what: "tooth towards which the runout points",
                value: self.high_tooth,
                allowed: "1 up to, but not including, the number of teeth + 1",
            });
        }
        Ok(())
    }

    /// Every tooth keeps a tip land and a neck, and every space some room at the form circle.
    pub(super) fn check_teeth(&self) -> Result<(), GearError> {
        let gear = &self.gear;
        for tooth in 1..=gear.basic_data().teeth() {
            let widening =
                self.flank_offset(Side::Left, tooth) - self.flank_offset(Side::Right, tooth);
            let own = |side: Side, tooth: u32, place: ProfilePart| {
                self.profile(side, tooth).part(place).ends
            };
            let tip: f64 = Side::BOTH
                .map(|side| own(side, tooth, ProfilePart::Tip)[1])
                .iter()
                .sum();
            // What a modified flank is turned at its lower end its fillet is turned, and root land begins so much farther on.
            let land = gear.part(ProfilePart::Root).ends[0];
            let turned = |side: Side, tooth: u32| own(side, tooth, ProfilePart::Root)[0] - land;
            let both: f64 = Side::BOTH.map(|side| turned(side, tooth)).iter().sum();
            let neck = 2.0 * gear.neck_half_angle() + both;
            if !(tip + widening > 0.0) {
                return Err(GearError::OutOfRange {
                    what: "tip thickness of the thinnest tooth (mm)",
                    value: (tip + widening) * gear.tip_radius(),
                    allowed: "above 0: the deviations leave this tooth without a tip",
                });
            }
            if !(neck + widening > 0.0) {
                return Err(GearError::OutOfRange {
                    what: "thickness of the thinnest tooth at its neck (rad)",
                    value: neck + widening,
                    allowed: "above 0: the deviations let undercut from both sides meet and cut this tooth off",
                });
            }
            let next = self.counter_clockwise(tooth, 1);
            let narrowing =
                self.flank_offset(Side::Left, tooth) - self.flank_offset(Side::Right, next);
            let space = gear.basic_data().angular_pitch()
                - 2.0 * gear.form_half_angle()
                - turned(Side::Left, tooth)
                - turned(Side::Right, next);
            if !(space - narrowing > 0.0) {
                return Err(GearError::OutOfRange {
                    what: "space width at the form circle (mm)",
                    value: (space - narrowing) * gear.form_radius(),
                    allowed: "above 0: the deviations close a tooth space",
                });
            }
        }
        Ok(())
    }
}
