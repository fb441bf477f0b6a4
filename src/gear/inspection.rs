//! The inspection sheet of a gear as built.

use super::{AsBuilt, Flank, Pitch, Side};

/// Pitch, thickness and runout of each tooth, tooth 1 first.
///
/// Lengths are mm at the reference circle, about the gear's own centre, positive along ascending numbers. A thick tooth also shows
/// in the pitch of both its flanks, as on a measuring machine.
#[derive(Debug, Clone, PartialEq)]
pub struct Inspection {
    /// Pitch of both flanks.
    pub pitch: Pitch,
    thickness: Vec<f64>,
    runout: Vec<f64>,
}

/// Whether the teeth of `gear` differ: a flank deviates, the gear is eccentric or wobbles, or profiles or leads differ.
pub fn has_different_teeth(gear: &AsBuilt) -> bool {
    Inspection::of(gear).greatest() != 0.0
        || gear.wobble() != 0.0
        || gear.has_different_profiles()
        || !gear.has_one_lead()
}

impl Inspection {
    /// The inspection of `gear`.
    pub fn of(gear: &AsBuilt) -> Inspection {
        let basic_data = gear.gear().basic_data();
        let r = basic_data.reference_radius();
        let teeth = || 1..=basic_data.teeth();
        let ascending = gear.face().ascending();
        let cumulative = |own: Flank| {
            let front = gear.face().seen_from_front(own);
            let place = |tooth| ascending * r * gear.flank_offset(front, tooth);
            teeth().map(place).collect::<Vec<f64>>()
        };
        let thickness = |tooth| {
            r * (gear.flank_offset(Side::Left, tooth) - gear.flank_offset(Side::Right, tooth))
        };
        let runout = |tooth| {
            let from_high = (f64::from(tooth) - gear.high_tooth()) * basic_data.angular_pitch();
            gear.eccentricity() * from_high.cos()
        };
        Inspection {
            pitch: Pitch::from_cumulative(&cumulative(Flank::Right), &cumulative(Flank::Left)),
            thickness: teeth().map(thickness).collect(),
            runout: teeth().map(runout).collect(),
        }
    }

    /// Whether any flank deviates or the gear is eccentric, by more than the rounding of a lead that all flanks share.
    pub fn deviates(&self) -> bool {
        self.greatest() > 1e-12
    }

    /// The greatest amount of a deviation, mm.
    fn greatest(&self) -> f64 {
        let [right, left] = Flank::BOTH.map(|flank| self.pitch.flank(flank));
        let all = [right, left, &self.thickness, &self.runout];
        let amounts = all.into_iter().flatten().map(|mm| mm.abs());
        amounts.fold(0.0, f64::max)
    }

    /// Tooth thickness minus the gear's stated mean thickness.
    pub fn thickness(&self) -> &[f64] {
        &self.thickness
    }

    /// Radial displacement of each tooth by the eccentricity `e`: `e cos` of its angle from the high tooth.
    pub fn runout(&self) -> &[f64] {
        &self.runout
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{Deviations, Face, GearDesign};

    /// A tooth thicker by `t` has flanks `t/2` off their places: pitch counts from their mean.
    #[test]
    fn pitch_is_about_the_mean_of_the_flanks() {
        for face in [Face::Front, Face::Back] {
            for (thicker, own, mean) in [([0.03; 2], 0.0, 0.0), ([0.04, 0.0], 0.02, 0.001)] {
                let mut per_tooth = vec![thicker[1]; 20];
                per_tooth[4] = thicker[0];
                let deviations = Deviations {
                    per_tooth,
                    ..Deviations::default()
                };
                let found = Inspection::of(&GearDesign::plain(20, 2.0).built(face, &deviations));
                for flank in [Flank::Right, Flank::Left] {
                    let found = found.pitch.flank(flank);
                    for (index, found) in found.iter().enumerate() {
                        let own: f64 = if index == 4 { own } else { 0.0 };
                        let off = found.abs() - (own - mean).abs();
                        assert!(off.abs() < 1e-15, "{found} at {index}");
                    }
                    assert!(found.iter().sum::<f64>().abs() < 1e-15);
                }
            }
        }
    }
}
