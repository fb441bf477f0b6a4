//! A gear as built: where every flank really sits, and the axis it turns about.

mod limits;
mod profiles;
mod varied;

use super::modified_flanks::ModifiedHalves;
use super::pitch::Pitch;
use super::{BasicGearData, Face, Flank, Gear, Modification, ProfilePart, Side};
use crate::error::GearError;
use nalgebra::{UnitComplex, Vector2};
use profiles::modified;
use std::f64::consts::PI;
use std::sync::Arc;

/// What was measured beyond the mean thickness. Lengths in mm; empty or zero where nothing was.
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
    /// Whether that is not known: a pose takes `high_tooth`, extremes any direction.
    pub any_direction: bool,
    /// Profile deviation of the gear's own right flanks, and of its left ones.
    pub profiles: [Modification; 2],
}

impl Deviations {
    /// `offsets` of the flanks on the right and on the left, and what thickness and pitch turn them beyond, rad, counter-clockwise.
    fn offsets(
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
        let of = |side: Side| usize::from(side == Side::Left);
        if !self.per_tooth.is_empty() {
            length("thickness of each tooth", &self.per_tooth)?;
            for side in Side::BOTH {
                for (offset, thickness) in offsets[of(side)].iter_mut().zip(&self.per_tooth) {
                    *offset += side.sense() * thickness / (2.0 * r * basic_data.helix_cos());
                }
            }
        }
        if let Some(pitch) = &self.pitch {
            for own in Flank::BOTH {
                let curve = pitch.flank(own);
                length("pitch", curve)?;
                if let Some(&worst) = curve
                    .iter()
                    .find(|f| !(f.abs() < PI * basic_data.module() / 2.0))
                {
                    return Err(GearError::OutOfRange {
                        what: "pitch deviation (mm)",
                        value: worst,
                        allowed: "less than half a pitch",
                    });
                }
                let side = face.seen_from_front(own);
                for (offset, f) in offsets[of(side)].iter_mut().zip(curve) {
                    *offset += face.ascending() * f / r;
                }
            }
        }
        Ok(offsets)
    }
}

/// A gear with every tooth where it was measured to be.
///
/// A copy shares its teeth: it takes the same time for any number of them.
#[derive(Debug, Clone, PartialEq)]
pub struct AsBuilt {
    gear: Gear,
    face: Face,
    /// Rotation of each tooth's front-right flank from its undisturbed place, rad, counter-clockwise.
    right: Arc<[f64]>,
    /// The same for the front-left flanks.
    left: Arc<[f64]>,
    eccentricity: f64,
    high_tooth: f64,
    any_direction: bool,
    /// The half teeth on the right and on the left where profiles deviate.
    modified: Option<Arc<[ModifiedHalves; 2]>>,
}

impl AsBuilt {
    /// `gear` with `deviations`, its reference face towards `face`.
    ///
    /// A thickness `δ_s` turns each flank out by `δ_s/(2 r)`, a pitch deviation
    /// `F` turns it by `F/r` along ascending numbers, fillet and all, about the
    /// geometric centre (design section 4).
    ///
    /// # Errors
    /// Lists that are not one value a tooth; a pitch deviation of half a pitch;
    /// a runout of the tooth depth or more; a high tooth outside `1 ≤ … < z + 1`; profile deviations as [`Modification::curves`] says,
    /// on straight flanks or too large for any flank;
    /// deviations that leave a tooth without tip or a space without room.
    pub fn new(gear: Gear, face: Face, deviations: &Deviations) -> Result<AsBuilt, GearError> {
        let teeth = gear.basic_data().teeth() as usize;
        let offsets = Side::BOTH.map(|_| vec![0.0; teeth]);
        let offsets = deviations.offsets(gear.basic_data(), face, offsets)?;
        let [right, left] = offsets.map(Arc::from);
        let as_built = AsBuilt {
            modified: modified(&gear, face, &deviations.profiles)?.map(Arc::new),
            right,
            left,
            face,
            eccentricity: deviations.eccentricity,
            high_tooth: deviations.high_tooth,
            any_direction: deviations.any_direction,
            gear,
        };
        as_built.check_runout()?;
        as_built.check_teeth()?;
        Ok(as_built)
    }

    /// A gear without deviations.
    pub fn perfect(gear: Gear, face: Face) -> AsBuilt {
        let teeth = gear.basic_data().teeth() as usize;
        let undisturbed: Arc<[f64]> = Arc::from(vec![0.0; teeth]);
        AsBuilt {
            gear,
            face,
            right: Arc::clone(&undisturbed),
            left: undisturbed,
            eccentricity: 0.0,
            high_tooth: 1.0,
            any_direction: false,
            modified: None,
        }
    }

    /// This gear with another runout: the eccentricity, mm, towards `high_tooth`.
    ///
    /// # Errors
    /// As [`AsBuilt::new`] of a runout.
    pub fn with_runout(&self, eccentricity: f64, high_tooth: f64) -> Result<AsBuilt, GearError> {
        let other = AsBuilt {
            eccentricity,
            high_tooth,
            any_direction: false,
            ..self.clone()
        };
        other.check_runout()?;
        Ok(other)
    }

    /// This gear with another runout: the eccentricity, mm, in a direction that is not known.
    ///
    /// # Errors
    /// As [`AsBuilt::new`] of a runout.
    pub fn with_runout_of_any_direction(&self, eccentricity: f64) -> Result<AsBuilt, GearError> {
        Ok(AsBuilt {
            any_direction: true,
            ..self.with_runout(eccentricity, 1.0)?
        })
    }

    /// This gear with its deviations `factor` times as large, for a picture: from the perfect gear of nominal
    /// thickness on, mean thickness, per-tooth thickness, pitch and eccentricity. Root and fillet are the nominal gear's,
    /// and turn with their flank.
    ///
    /// # Errors
    /// As [`Gear::new`] for the perfect gear; a factor that leaves a tooth without tip, a space without room
    /// or a runout of the tooth depth.
    pub fn exaggerated(&self, factor: f64) -> Result<AsBuilt, GearError> {
        // Straight flanks have no other thickness than their own.
        let gear = match self.gear.is_generated() {
            true => Gear::nominal(*self.gear.design())?,
            false => self.gear.clone(),
        };
        let thicker = self.gear.half_base_angle() - gear.half_base_angle();
        let enlarged = |list: &[f64], side: Side| {
            let offsets = list.iter();
            offsets
                .map(|offset| factor * (offset + side.sense() * thicker))
                .collect()
        };
        let exaggerated = AsBuilt {
            modified: self.modified_of(&gear, factor)?,
            right: enlarged(&self.right, Side::Right),
            left: enlarged(&self.left, Side::Left),
            eccentricity: factor * self.eccentricity,
            gear,
            ..*self
        };
        exaggerated.check_runout()?;
        exaggerated.check_teeth()?;
        Ok(exaggerated)
    }

    /// This gear with all lengths `factor` times as large: warmer, or colder. What stands at an angle stays there.
    ///
    /// # Errors
    /// As [`Gear::expanded`].
    pub fn expanded(&self, factor: f64) -> Result<AsBuilt, GearError> {
        let gear = self.gear.expanded(factor)?;
        Ok(AsBuilt {
            modified: self.modified_of(&gear, factor)?,
            eccentricity: factor * self.eccentricity,
            gear,
            ..self.clone()
        })
    }

    /// Its half teeth whose profiles deviate, `factor` times as much, of `gear`.
    fn modified_of(
        &self,
        gear: &Gear,
        factor: f64,
    ) -> Result<Option<Arc<[ModifiedHalves; 2]>>, GearError> {
        let Some(sides) = &self.modified else {
            return Ok(None);
        };
        let [right, left] = sides.each_ref().map(|side| side.exaggerated(gear, factor));
        Ok(Some(Arc::new([right?, left?])))
    }

    /// This gear without an eccentricity whose direction is not known.
    pub(crate) fn centred(&self) -> AsBuilt {
        AsBuilt {
            eccentricity: match self.any_direction {
                true => 0.0,
                false => self.eccentricity,
            },
            any_direction: false,
            ..self.clone()
        }
    }

    /// This gear with the flanks of `side` turned by `angle`, rad, counter-clockwise: every tooth is thicker or thinner by as much.
    ///
    /// # Errors
    /// As [`AsBuilt::new`] of thickness.
    pub(crate) fn with_side_turned(&self, side: Side, angle: f64) -> Result<AsBuilt, GearError> {
        let mut other = self.clone();
        let list = match side {
            Side::Right => &mut other.right,
            Side::Left => &mut other.left,
        };
        *list = list.iter().map(|offset| offset + angle).collect();
        other.check_teeth()?;
        Ok(other)
    }

    /// The gear of mean thickness.
    pub fn gear(&self) -> &Gear {
        &self.gear
    }

    /// Which way the reference face looks.
    pub fn face(&self) -> Face {
        self.face
    }

    /// Eccentricity `e`, mm.
    pub fn eccentricity(&self) -> f64 {
        self.eccentricity
    }

    /// The high tooth, fractional.
    pub fn high_tooth(&self) -> f64 {
        self.high_tooth
    }

    /// Whether the direction of the eccentricity is not known; [`AsBuilt::high_tooth`] is then one of many.
    pub fn any_direction(&self) -> bool {
        self.any_direction
    }

    /// Rotation of a tooth's flank from its undisturbed place, rad, counter-clockwise.
    ///
    /// `tooth` counts from 1 and lies in `1..=z`.
    pub fn flank_offset(&self, side: Side, tooth: u32) -> f64 {
        let list = match side {
            Side::Right => &self.right,
            Side::Left => &self.left,
        };
        list[tooth as usize - 1]
    }

    /// Where the root land of a half tooth ends: the middle of the space as the deviations leave it, where the land of
    /// the next half tooth begins. The land's parameter ([`super::ProfilePart::Root`]), rad, about the centre line turned with the
    /// flank; never less than the land's other end.
    pub fn root_end(&self, side: Side, tooth: u32) -> f64 {
        let across = self.counter_clockwise(tooth, side.sense() as i64);
        // The space is wider than its nominal width by what its two flanks are turned apart.
        let widening = side.sense()
            * (self.flank_offset(side.other(), across) - self.flank_offset(side, tooth));
        let (start, _) = self.profile(side, tooth).range(ProfilePart::Root);
        let middle = self.gear.part(ProfilePart::Root).ends[1];
        (middle + 0.5 * widening).max(start)
    }

    /// Where the tip land of a half tooth ends on the other half, at the far corner: the land's parameter
    /// ([`super::ProfilePart::Tip`]), rad, about the centre line turned with the flank. Both flanks' deviations widen the land; of a
    /// tooth left thinner than half of it the far corner lies on the near half (above 0).
    pub fn land_start(&self, side: Side, tooth: u32) -> f64 {
        let widening = self.flank_offset(Side::Left, tooth) - self.flank_offset(Side::Right, tooth);
        let (_, corner) = self.profile(side.other(), tooth).range(ProfilePart::Tip);
        -corner - widening
    }

    /// Angle of the (fractional) tooth's undisturbed centre from tooth 1, rad, counter-clockwise.
    pub fn tooth_angle(&self, tooth: f64) -> f64 {
        self.face.ascending() * (tooth - 1.0) * self.gear.basic_data().angular_pitch()
    }

    /// The number of the tooth `steps` places counter-clockwise of `tooth`.
    pub fn counter_clockwise(&self, tooth: u32, steps: i64) -> u32 {
        let teeth = self.gear.basic_data().teeth();
        self.face.counter_clockwise(teeth, tooth, steps)
    }

    /// Cosine of the angle from the high tooth to the mate, the gear at `rotation`, rad, from where tooth 1 points at it.
    pub fn towards_mate(&self, rotation: f64) -> f64 {
        (rotation + self.tooth_angle(self.high_tooth)).cos()
    }

    /// Displacement of the outline's centre from the axis, mm, with tooth 1 turned to the angle `tooth_1`.
    pub fn displacement(&self, tooth_1: f64) -> Vector2<f64> {
        UnitComplex::new(tooth_1 + self.tooth_angle(self.high_tooth))
            * Vector2::new(self.eccentricity, 0.0)
    }

    /// Greatest radius of the outline about the rotation axis, mm.
    pub fn reach(&self) -> f64 {
        self.gear.tip_radius() + self.eccentricity
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{GearDesign, Profile};

    /// Both half teeth of a space end in the same direction, on either face, whatever the deviations; the land
    /// widens and narrows with the space, and a space closed at its root leaves none.
    #[test]
    fn root_lands_meet_in_the_middle_of_the_space() {
        let gear = Gear::nominal(GearDesign::plain(20, 2.0)).unwrap();
        let mut right = vec![0.0; 20];
        (right[4], right[9]) = (0.9, -0.9);
        let deviations = Deviations {
            per_tooth: (0..20).map(|k| 0.01 * f64::from(k % 3)).collect(),
            pitch: Some(Pitch::from_cumulative(&right, &[0.0; 20])),
            ..Deviations::default()
        };
        let (start, middle) = Profile::new(&gear).range(ProfilePart::Root);
        for face in [Face::Front, Face::Back] {
            let built = AsBuilt::new(gear.clone(), face, &deviations).unwrap();
            let end = |side: Side, tooth: u32| {
                let turned = built.tooth_angle(f64::from(tooth)) + built.flank_offset(side, tooth);
                turned + side.sense() * built.root_end(side, tooth)
            };
            for tooth in 1..=20 {
                let next = built.counter_clockwise(tooth, 1);
                let apart = end(Side::Left, tooth) - end(Side::Right, next);
                let closed = built.root_end(Side::Left, tooth) == start;
                let whole = apart - std::f64::consts::TAU * (apart / std::f64::consts::TAU).round();
                assert!(closed || whole.abs() < 1e-14, "{whole} at tooth {tooth}");
            }
            let ends = (1..=20).map(|tooth| built.root_end(Side::Right, tooth));
            let (least, most) = ends.fold((middle, middle), |(l, m), e| (l.min(e), m.max(e)));
            assert!(least == start && most > middle + 0.02);
        }
    }
}
