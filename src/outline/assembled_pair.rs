//! A pair as assembled, with gears given by data or by drawings.

use super::change::GearChange;
use super::pair::OutlinePair;
use crate::error::{Error, GearError};
use crate::gear::{AsBuilt, Face};
use crate::pair::{Backlash, GearPair, Mating, Member, Pose, ToothNumbers};
use nalgebra::{Point2, Vector2};
use std::f64::consts::TAU;

/// Two gears at a centre distance.
#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a run has a single pair")]
pub enum AssembledPair {
    /// Both gears are given by data.
    Data(GearPair),
    /// At least one gear is given by a drawing.
    Drawn(OutlinePair),
}

impl From<GearPair> for AssembledPair {
    fn from(pair: GearPair) -> AssembledPair {
        AssembledPair::Data(pair)
    }
}

impl From<OutlinePair> for AssembledPair {
    fn from(pair: OutlinePair) -> AssembledPair {
        AssembledPair::Drawn(pair)
    }
}

impl AssembledPair {
    /// The pair of gears given by data; `None` with a drawn gear.
    pub fn data(&self) -> Option<&GearPair> {
        match self {
            AssembledPair::Data(pair) => Some(pair),
            AssembledPair::Drawn(_) => None,
        }
    }

    /// The pair with a drawn gear; `None` with both gears given by data.
    pub fn drawn(&self) -> Option<&OutlinePair> {
        match self {
            AssembledPair::Data(_) => None,
            AssembledPair::Drawn(pair) => Some(pair),
        }
    }

    /// Centre distance `a`, mm.
    pub fn center_distance(&self) -> f64 {
        match self {
            AssembledPair::Data(pair) => pair.center_distance(),
            AssembledPair::Drawn(pair) => pair.center_distance(),
        }
    }

    /// The centre distance, mm, at and below which the gears cannot be assembled: base circles overlap, or a drawn gear reaches
    /// the other's axis.
    pub fn least_distance(&self) -> f64 {
        match self {
            AssembledPair::Data(pair) => pair.least_distance(),
            AssembledPair::Drawn(pair) => pair.least_distance(),
        }
    }

    /// These gears at another centre distance, mm.
    ///
    /// # Errors
    /// As [`GearPair::at`] and [`OutlinePair::at`].
    pub fn at(&self, center_distance: f64) -> Result<AssembledPair, Error> {
        Ok(match self {
            AssembledPair::Data(pair) => pair.at(center_distance)?.into(),
            AssembledPair::Drawn(pair) => pair.at(center_distance)?.into(),
        })
    }

    /// Whether the gears are helical.
    pub fn is_helical(&self) -> bool {
        self.data().is_some_and(GearPair::is_helical)
    }

    /// Whether transverse sections differ along the face: helical teeth, lead deviations, or leaning axes.
    pub fn varies_along_face(&self) -> bool {
        self.data().is_some_and(GearPair::varies_along_face)
    }

    /// The gear that stands still.
    pub fn locked(&self) -> Member {
        ToothNumbers::locked(self)
    }

    /// The gear that turns.
    pub fn free(&self) -> Member {
        self.locked().mate()
    }

    /// Teeth of one of the gears.
    pub fn teeth(&self, member: Member) -> u32 {
        ToothNumbers::teeth(self, member)
    }

    /// Operating pitch radius `r_w`, mm; `a z/(z_1 + z_2)` for drawn gears.
    pub fn operating_pitch_radius(&self, member: Member) -> f64 {
        match self {
            AssembledPair::Data(pair) => pair.operating_pitch_radius(member),
            AssembledPair::Drawn(pair) => pair.operating_pitch_radius(member),
        }
    }

    /// Lost motion at `member`, rad, for a backlash `j_wt`, mm.
    pub fn angle(&self, member: Member, j_wt: f64) -> f64 {
        j_wt / self.operating_pitch_radius(member)
    }

    /// The centre distance, mm, from which tips pass each other.
    pub fn reach(&self) -> f64 {
        self.gear_reach(Member::Wheel) + self.gear_reach(Member::Pinion)
    }

    /// Greatest distance of a gear's metal from its axis, mm.
    pub fn gear_reach(&self, member: Member) -> f64 {
        match self {
            AssembledPair::Data(pair) => pair.gear(member).reach(),
            AssembledPair::Drawn(pair) => pair.gear(member).reach(),
        }
    }

    /// Distance of a gear's centre from its axis, mm.
    pub fn eccentricity(&self, member: Member) -> f64 {
        match self {
            AssembledPair::Data(pair) => pair.gear(member).eccentricity(),
            AssembledPair::Drawn(pair) => pair.gear(member).eccentricity(),
        }
    }

    /// The tooth, fractional, towards which a gear's centre is displaced from its axis.
    pub fn high_tooth(&self, member: Member) -> f64 {
        match self {
            AssembledPair::Data(pair) => pair.gear(member).high_tooth(),
            AssembledPair::Drawn(pair) => pair.gear(member).high_tooth(),
        }
    }

    /// Least and greatest radial clearance, mm, of `member`'s tips in its mate's spaces, about the centres of the gears.
    pub fn radial_clearance(&self, member: Member) -> [f64; 2] {
        match self {
            AssembledPair::Data(pair) => [pair.radial_clearance(member); 2],
            AssembledPair::Drawn(pair) => pair.radial_clearance(member),
        }
    }

    /// How far the outlines of both gears together may lie from those stated, mm; 0 for gears by data.
    pub fn outline_bound(&self) -> f64 {
        let bound = |pair: &OutlinePair| {
            let bounds = Member::BOTH.map(|member| pair.gear(member).bound());
            bounds.iter().sum()
        };
        self.drawn().map_or(0.0, bound)
    }

    /// A gear by its data; `None` in a pair with a drawn gear.
    pub fn as_built(&self, member: Member) -> Option<&AsBuilt> {
        Some(self.data()?.gear(member))
    }

    /// The distance by which a gear's drawn outline is moved out, mm; `None` of a gear by its data.
    pub fn flank_offset(&self, member: Member) -> Option<f64> {
        self.drawn()?.gear(member).flank_offset()
    }

    /// Whether the eccentricity of a gear has no direction.
    pub fn any_direction(&self, member: Member) -> bool {
        self.as_built(member).is_some_and(AsBuilt::any_direction)
    }

    /// Twist of a gear's teeth, rad per mm of the face.
    pub fn twist(&self, member: Member) -> f64 {
        let gear = self.as_built(member);
        gear.map_or(0.0, |gear| gear.gear().basic_data().twist())
    }

    /// Whether flanks have profile deviations, which formulas leave out.
    pub fn is_modified(&self) -> bool {
        self.data().is_some_and(GearPair::is_modified)
    }

    /// The common face, mm; both ends are 0 where there is none ([`GearPair::with_face`]).
    pub fn face(&self) -> [f64; 2] {
        self.data().map_or([0.0; 2], GearPair::face)
    }

    /// Operating pressure angle, rad; `None` without involutes.
    pub fn operating_pressure_angle(&self) -> Option<f64> {
        self.data().map(GearPair::operating_pressure_angle)
    }

    /// Backlash in units that need a module or a base circle, of a backlash `j_wt`, mm; `None` without involutes.
    pub fn backlash(&self, j_wt: f64) -> Option<Backlash> {
        Some(Backlash::new(self.data()?, j_wt))
    }

    /// Whether both gears can be changed like this. In a pair with a drawn gear fewer changes are possible.
    pub fn allows(&self, changes: &[GearChange; 2]) -> bool {
        self.drawn().is_none_or(|pair| {
            let is_possible =
                |member: Member| changes[member as usize].is_possible(pair.gear(member));
            Member::BOTH.into_iter().all(is_possible)
        })
    }

    /// This pair at another centre distance, mm, its wheel and pinion after these changes.
    ///
    /// # Errors
    /// As [`AssembledPair::at`], and of the changes: [`Error::ChangeOfDrawn`] of one that it does not [allow](AssembledPair::allows).
    pub fn varied(
        &self,
        center_distance: f64,
        changes: &[GearChange; 2],
    ) -> Result<AssembledPair, Error> {
        Ok(match self {
            AssembledPair::Data(pair) => {
                let gear = |member| changes[member as usize].of_data(pair.gear(member));
                let (wheel, pinion) = (gear(Member::Wheel)?, gear(Member::Pinion)?);
                pair.with_gears(wheel, pinion, center_distance)?.into()
            }
            AssembledPair::Drawn(pair) => {
                if !self.allows(changes) {
                    return Err(Error::ChangeOfDrawn);
                }
                let gear = |member| changes[member as usize].of_outline(pair.gear(member));
                let (wheel, pinion) = (gear(Member::Wheel)?, gear(Member::Pinion)?);
                OutlinePair::new(wheel, pinion, center_distance, pair.locked())?.into()
            }
        })
    }

    /// Lean of the pinion's axis from the wheel's, mm per mm ([`GearPair::with_lean`]).
    pub fn lean(&self) -> [f64; 2] {
        self.data().map_or([0.0; 2], GearPair::lean)
    }

    /// This pair with its axes leaning further by `lean`, mm per mm. Axes of a pair without a face stay parallel.
    ///
    /// # Errors
    /// As [`GearPair::with_lean`].
    pub fn leaning_further(self, lean: [f64; 2]) -> Result<AssembledPair, GearError> {
        Ok(match self {
            AssembledPair::Data(pair) => {
                let own = pair.lean();
                pair.with_lean([own[0] + lean[0], own[1] + lean[1]])?.into()
            }
            drawn => drawn,
        })
    }

    /// Module of the gears, mm; for a drawn pair that of its operating pitch circles.
    pub fn module(&self) -> f64 {
        match self {
            AssembledPair::Data(pair) => pair.gear(Member::Wheel).gear().basic_data().module(),
            AssembledPair::Drawn(pair) => {
                let pitch = pair.gear(Member::Wheel).pitch();
                2.0 * pair.operating_pitch_radius(Member::Wheel) * pitch / TAU
            }
        }
    }

    /// Whether the gears of `other` are these gears; centre distances may differ.
    pub fn has_gears_of(&self, other: &AssembledPair) -> bool {
        let mut members = Member::BOTH.into_iter();
        match (self, other) {
            (AssembledPair::Data(own), AssembledPair::Data(other)) => {
                members.all(|member| own.gear(member) == other.gear(member))
            }
            (AssembledPair::Drawn(own), AssembledPair::Drawn(other)) => {
                members.all(|member| own.gear(member) == other.gear(member))
            }
            _ => false,
        }
    }

    /// Rotation axis, mm.
    pub fn axis(&self, member: Member) -> Point2<f64> {
        member.axis(self.center_distance())
    }

    /// The direction in which a gear's outline is displaced from its axis at `pose`; `None` for a drawn gear that is not displaced.
    pub fn displaced_towards(&self, member: Member, pose: &Pose) -> Option<Vector2<f64>> {
        let rotation = pose.rotation(self, member);
        match self {
            AssembledPair::Data(pair) => {
                let gear = pair.gear(member);
                let tooth_1 = member.mate_direction() + rotation;
                Some(gear.displacement_direction(tooth_1))
            }
            AssembledPair::Drawn(pair) => {
                let displaced = pair.centre(member, rotation) - pair.axis(member);
                displaced.try_normalize(0.0)
            }
        }
    }

    /// The pose of `mating`.
    pub fn pose(&self, mating: Mating) -> Pose {
        match self {
            AssembledPair::Data(pair) => Pose::new(pair, mating),
            AssembledPair::Drawn(pair) => pair.pose(mating),
        }
    }
}

impl ToothNumbers for AssembledPair {
    fn teeth(&self, member: Member) -> u32 {
        match self {
            AssembledPair::Data(pair) => pair.teeth(member),
            AssembledPair::Drawn(pair) => pair.gear(member).teeth(),
        }
    }

    fn shown_face(&self, member: Member) -> Face {
        match self {
            AssembledPair::Data(pair) => pair.shown_face(member),
            AssembledPair::Drawn(pair) => pair.shown_face(member),
        }
    }

    fn locked(&self) -> Member {
        match self {
            AssembledPair::Data(pair) => pair.locked(),
            AssembledPair::Drawn(pair) => pair.locked(),
        }
    }
}
