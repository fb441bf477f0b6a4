//! Two gears given by their outlines at a centre distance, and their rotations at a mating.

use super::gear::OutlineGear;
use crate::error::OutlineError;
use crate::gear::{Face, Side, steps_near};
use crate::pair::{GearPair, Mating, Member, Pose, ToothNumbers};
use nalgebra::{Complex, Point2, Vector2};

/// A pair with at least one gear given by its outline: wheel axis at the origin, pinion axis at `(a, 0)`, y up.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlinePair {
    gears: [OutlineGear; 2],
    center_distance: f64,
    locked: Member,
    /// Half the angle a mean tooth spans on its operating pitch circle, rad.
    half_angles: [f64; 2],
}

impl OutlinePair {
    /// Two gears at `center_distance` `a`, mm, with `locked` as the locked gear.
    ///
    /// # Errors
    /// [`OutlineError::TooNear`]: a gear reaches the other's axis.
    pub fn new(
        wheel: OutlineGear,
        pinion: OutlineGear,
        center_distance: f64,
        locked: Member,
    ) -> Result<OutlinePair, OutlineError> {
        let mut pair = OutlinePair {
            gears: [wheel, pinion],
            center_distance,
            locked,
            half_angles: [0.0; 2],
        };
        let least_mm = pair.least_distance();
        if !(center_distance > least_mm && center_distance.is_finite()) {
            return Err(OutlineError::TooNear {
                center_distance_mm: center_distance,
                least_mm,
            });
        }
        pair.half_angles = Member::BOTH.map(|member| {
            let radius = pair.operating_pitch_radius(member);
            pair.gear(member).half_angle(radius)
        });
        Ok(pair)
    }

    /// The outlines of a pair by data, spur gears on parallel axes, with its rotations at a mating.
    ///
    /// # Errors
    /// As [`OutlinePair::new`].
    pub(crate) fn of_data(pair: &GearPair) -> Result<OutlinePair, OutlineError> {
        let [wheel, pinion] = Member::BOTH.map(|member| OutlineGear::from(pair.gear(member)));
        let outlines = OutlinePair::new(wheel, pinion, pair.center_distance(), pair.locked())?;
        let half_angles = Member::BOTH.map(|member| pair.operating_half_angle(member));
        Ok(OutlinePair {
            half_angles,
            ..outlines
        })
    }

    /// These gears at another centre distance.
    ///
    /// # Errors
    /// As [`OutlinePair::new`].
    pub fn at(&self, center_distance: f64) -> Result<OutlinePair, OutlineError> {
        let [wheel, pinion] = self.gears.clone();
        OutlinePair::new(wheel, pinion, center_distance, self.locked)
    }

    /// One of the gears.
    pub fn gear(&self, member: Member) -> &OutlineGear {
        &self.gears[usize::from(member == Member::Pinion)]
    }

    /// The centre distance, mm, at which a gear reaches the other's axis.
    pub fn least_distance(&self) -> f64 {
        let [wheel, pinion] = &self.gears;
        let least = |gear: &OutlineGear, mate: &OutlineGear| gear.reach() + mate.eccentricity();
        least(wheel, pinion).max(least(pinion, wheel))
    }

    /// The greatest centre distance, mm, at which a tip circle touches the mate's root circle.
    pub fn tip_on_root(&self) -> f64 {
        let [wheel, pinion] = &self.gears;
        let touch = |gear: &OutlineGear, mate: &OutlineGear| gear.tip_radius() + mate.root_radius();
        touch(wheel, pinion).max(touch(pinion, wheel))
    }

    /// Centre distance `a`, mm.
    pub fn center_distance(&self) -> f64 {
        self.center_distance
    }

    /// The locked gear.
    pub fn locked(&self) -> Member {
        self.locked
    }

    /// The gear that turns.
    pub fn free(&self) -> Member {
        self.locked.mate()
    }

    /// Operating pitch radius `r_w = a z/(z_1 + z_2)`, mm, from the ratio alone.
    pub fn operating_pitch_radius(&self, member: Member) -> f64 {
        let teeth = |member| f64::from(self.gear(member).teeth());
        self.center_distance * teeth(member) / (teeth(Member::Wheel) + teeth(Member::Pinion))
    }

    /// Rotation of a gear at `mating`, rad, counted from tooth 1 pointing at the mate.
    ///
    /// As in [`crate::pair::Pose`], the flank of a mean tooth passes through the operating pitch point; the free gear has its nominal
    /// rotation.
    pub fn rotation(&self, member: Member, mating: &Mating) -> f64 {
        let gear = self.gear(member);
        let half = self.half_angles[usize::from(member == Member::Pinion)];
        let tooth = f64::from(mating.tooth(member));
        let locked = self.gear(self.locked);
        let onward = -locked.face().ascending() * mating.fraction;
        let sense = if member == self.locked { 1.0 } else { -1.0 };
        -mating.flank.sense() * half - gear.tooth_angle(tooth) + sense * onward * gear.pitch()
    }

    /// Least and greatest radial clearance `a − r_a − r_f,mate`, mm, of `member`'s tips in its mate's spaces.
    ///
    /// The least is that of the highest tip in the shallowest space, the greatest that of the lowest tip in the deepest space, about the
    /// geometric centres. Heights and depths are those of the ends of the drawn curves.
    pub fn radial_clearance(&self, member: Member) -> [f64; 2] {
        let (own, mate) = (self.gear(member), self.gear(member.mate()));
        let tips = half_ends(own).map(|[_, greatest]| greatest);
        let roots = half_ends(mate).map(|[least, _]| least);
        let low_tip = tips.fold(own.tip_radius(), f64::min);
        let shallow = roots.fold(mate.root_radius(), f64::max);
        [own.tip_radius() + shallow, low_tip + mate.root_radius()]
            .map(|radii| self.center_distance - radii)
    }

    /// Rotation axis, mm.
    pub fn axis(&self, member: Member) -> Point2<f64> {
        member.axis(self.center_distance)
    }

    /// The closed outline of a gear at `rotation`, rad, in the picture: chords within `chordal_error` mm.
    pub fn outline(&self, member: Member, rotation: f64, chordal_error: f64) -> Vec<Point2<f64>> {
        let tooth_1 = member.mate_direction() + rotation;
        let points = self.gear(member).points(tooth_1, chordal_error);
        let axis = self.axis(member);
        points.iter().map(|point| axis + point.coords).collect()
    }

    /// Centre of a gear's outline at `rotation`, rad, in the picture, mm, displaced from the axis by the eccentricity.
    pub fn centre(&self, member: Member, rotation: f64) -> Point2<f64> {
        let off = self.gear(member).displacement();
        let off = off * Complex::from_polar(1.0, member.mate_direction() + rotation);
        self.axis(member) + Vector2::new(off.re, off.im)
    }

    /// Teeth of a gear at `rotation`, rad, that reach into the disc of radius `reach` (mm) about `place`, and a few more.
    ///
    /// Each has its number and the direction of its even place from [`OutlinePair::centre`], rad, in counter-clockwise order. All teeth
    /// if the disc contains that centre.
    pub fn teeth_near(
        &self,
        member: Member,
        rotation: f64,
        place: Point2<f64>,
        reach: f64,
    ) -> Vec<(u32, f64)> {
        let gear = self.gear(member);
        let tooth_1 = member.mate_direction() + rotation;
        let seen = (place - self.centre(member, rotation), tooth_1);
        let teeth = i64::from(gear.teeth());
        let tooth = |step: i64| {
            let index = (gear.face().ascending() as i64 * step).rem_euclid(teeth);
            (index as u32 + 1, tooth_1 + step as f64 * gear.pitch())
        };
        let steps = steps_near(seen, reach, gear.pitch(), gear.teeth());
        steps.map(tooth).collect()
    }

    /// The pose of `mating`.
    pub fn pose(&self, mating: Mating) -> Pose {
        let rotation = |member| self.rotation(member, &mating);
        Pose::at(mating, rotation(self.locked), rotation(self.free()))
    }
}

impl ToothNumbers for OutlinePair {
    fn teeth(&self, member: Member) -> u32 {
        self.gear(member).teeth()
    }

    fn shown_face(&self, member: Member) -> Face {
        self.gear(member).face()
    }

    fn locked(&self) -> Member {
        self.locked
    }
}

/// Least and greatest radius, mm, of the ends of the pieces of each half tooth.
fn half_ends(gear: &OutlineGear) -> impl Iterator<Item = [f64; 2]> {
    let teeth = (1..=gear.teeth()).flat_map(|tooth| Side::BOTH.map(|side| (side, tooth)));
    teeth.map(|(side, tooth)| gear.half(side, tooth).end_radii())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::Placed;
    use crate::pair::{GearPair, Mating, Pose};

    /// Centres and teeth near a place equal those of the gears given by data, at every pitch of a revolution, on either face. Source:
    /// [`crate::gear::Placed`].
    #[test]
    fn teeth_stand_where_those_of_the_data_do() {
        let assembly = GearPair::plain([20, 13], [0.05; 2], 33.2, Member::Wheel);
        let pair = OutlinePair::of_data(&assembly).unwrap();
        let place = Point2::new(20.0, 1.0);
        for (step, member) in (0..20).flat_map(|step| Member::BOTH.map(|member| (step, member))) {
            let mating = Mating {
                fraction: f64::from(step) + 0.3,
                ..Mating::FIRST
            };
            let rotation = Pose::new(&assembly, mating).locked_rotation();
            let tooth_1 = member.mate_direction() + rotation;
            let placed = Placed::new(assembly.gear(member), pair.axis(member), tooth_1);
            let centre = pair.centre(member, rotation);
            assert!((centre - placed.centre()).norm() < 1e-12);
            for reach in [3.0, 9.0, 200.0] {
                let found = pair.teeth_near(member, rotation, place, reach);
                let numbers: Vec<u32> = found.iter().map(|tooth| tooth.0).collect();
                assert_eq!(numbers, placed.teeth_near(place, reach));
                for (tooth, direction) in found {
                    let off = (direction - placed.direction(tooth)) / std::f64::consts::TAU;
                    assert!((off - off.round()).abs() < 1e-12, "{tooth}");
                }
            }
        }
    }
}
