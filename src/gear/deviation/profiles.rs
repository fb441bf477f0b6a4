//! The profiles of a gear as built: the half tooth of each tooth, and gears without deviations that enclose it.

use super::AsBuilt;
use crate::error::GearError;
use crate::gear::modified_flanks::ModifiedHalves;
use crate::gear::{
    Face, Flank, Gear, Modification, PartCurve, Profile, ProfilePart, RollCurve, Side,
};

impl AsBuilt {
    /// The half tooth on `side` of `tooth`, in its own frame.
    pub fn profile(&self, side: Side, tooth: u32) -> Profile<'_> {
        self.shape(side, self.shape_of(side, tooth))
    }

    /// Half teeth on `side` that are not alike: one unless profiles were measured tooth by tooth.
    pub(crate) fn shapes(&self, side: Side) -> usize {
        self.halves(side).map_or(1, |halves| halves.shapes.len())
    }

    /// Which of them a tooth has.
    pub(crate) fn shape_of(&self, side: Side, tooth: u32) -> usize {
        self.halves(side).map_or(0, |halves| halves.shape_of(tooth))
    }

    /// One of them.
    pub(crate) fn shape(&self, side: Side, shape: usize) -> Profile<'_> {
        match self.halves(side) {
            Some(halves) => Profile::of(&self.gear, &halves.shapes[shape]),
            None => Profile::new(&self.gear),
        }
    }

    fn halves(&self, side: Side) -> Option<&ModifiedHalves> {
        let sides = self.modified.as_ref()?;
        Some(&sides[usize::from(side == Side::Left)])
    }

    /// Profile deviation of the flank on `side` of `tooth` over the roll; `None` where the gear has none at all.
    pub fn modification(&self, side: Side, tooth: u32) -> Option<&RollCurve> {
        match &self.profile(side, tooth).part(ProfilePart::Involute).curve {
            PartCurve::Modified(flank) => Some(flank.deviation()),
            _ => None,
        }
    }

    /// Whether the profiles of one side are not all alike.
    pub(crate) fn has_unlike_profiles(&self) -> bool {
        Side::BOTH.into_iter().any(|side| self.shapes(side) > 1)
    }

    /// Whether profiles deviate.
    pub fn is_modified(&self) -> bool {
        self.modified.is_some()
    }

    /// Whether all flanks are involutes and all fillets what the rack leaves: what the formulas of gears are about.
    pub fn is_generated(&self) -> bool {
        self.modified.is_none() && self.gear.is_generated()
    }

    /// A gear without profile deviations whose every half tooth holds this one's, turned out by the greatest deviation of its flank, and
    /// one that this one holds, by the least; and how much any flank's deviations differ, mm.
    ///
    /// An involute with the constant deviation `D` is the same involute turned by `D/r_b`.
    ///
    /// # Errors
    /// As [`AsBuilt::new`] of thickness.
    pub(crate) fn enclosing(&self) -> Result<([AsBuilt; 2], f64), GearError> {
        let mut enclosing = [self.unmodified(), self.unmodified()];
        let mut range = 0.0f64;
        let base = self.gear.base_radius();
        for side in Side::BOTH {
            let bounds = self.deviations(side);
            range = bounds
                .iter()
                .fold(range, |range, [least, most]| range.max(most - least));
            for (which, other) in [1, 0].into_iter().zip(&mut enclosing) {
                let list = match side {
                    Side::Right => &mut other.right,
                    Side::Left => &mut other.left,
                };
                let turned = |(tooth, offset): (u32, &f64)| {
                    let deviation = bounds[self.shape_of(side, tooth)][which];
                    offset + side.sense() * deviation / base
                };
                *list = (1..).zip(list.iter()).map(turned).collect();
            }
        }
        for other in &enclosing {
            other.check_teeth()?;
        }
        Ok((enclosing, range))
    }

    /// Least and greatest deviation, mm, of each of the shapes of a side.
    pub(crate) fn deviations(&self, side: Side) -> Vec<[f64; 2]> {
        let bounds = |shape| {
            let part = self.shape(side, shape).part(ProfilePart::Involute);
            let (low, high) = part.range();
            match &part.curve {
                PartCurve::Modified(flank) => flank.deviation().bounds(low, high)[0],
                _ => [0.0; 2],
            }
        };
        (0..self.shapes(side)).map(bounds).collect()
    }

    /// Whether a profile stands out from its involute anywhere.
    pub(crate) fn stands_out(&self) -> bool {
        let sides = Side::BOTH.iter().flat_map(|side| self.deviations(*side));
        sides.into_iter().any(|[_, most]| most > 0.0)
    }

    /// The same gear without its profile deviations.
    pub fn unmodified(&self) -> AsBuilt {
        AsBuilt {
            modified: None,
            ..self.clone()
        }
    }
}

/// The half teeth on both sides of the picture with the deviations of the gear's own flanks; `None` where there are none.
pub(super) fn modified(
    gear: &Gear,
    face: Face,
    profiles: &[Modification; 2],
) -> Result<Option<[ModifiedHalves; 2]>, GearError> {
    if profiles.iter().all(Modification::is_none) {
        return Ok(None);
    }
    if !gear.is_generated() {
        return Err(GearError::Profile {
            what: "is no involute",
        });
    }
    let halves = Side::BOTH.map(|side| {
        let own = Flank::BOTH.map(|own| face.seen_from_front(own));
        let which = usize::from(own[0] != side);
        ModifiedHalves::new(gear, &profiles[which].curves(gear)?)
    });
    let [right, left] = halves;
    Ok(Some([right?, left?]))
}
