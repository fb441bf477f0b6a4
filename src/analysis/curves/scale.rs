//! Positions of poses on the horizontal axis of a curve over the teeth.

use crate::pair::{Mating, Member, ToothNumbers};

/// Conversion of pitches to places.
pub struct Scale {
    start: f64,
    sense: f64,
    pitches: f64,
    /// Number of wheel teeth if places are tooth numbers.
    pub teeth: Option<u32>,
}

impl Scale {
    /// The scale of consecutive `matings`.
    pub fn of<'a, I: Iterator<Item = &'a Mating>>(
        assembly: &impl ToothNumbers,
        matings: impl Fn() -> I,
    ) -> Scale {
        let pitches = pitches(matings());
        let teeth = assembly.teeth(Member::Wheel);
        let first = matings().next().map_or(1, |mating| mating.wheel_tooth);
        if pitches > f64::from(teeth) {
            return Scale {
                start: 0.0,
                sense: 1.0,
                pitches,
                teeth: None,
            };
        }
        Scale {
            start: f64::from(first),
            sense: wheel_sense(assembly),
            pitches,
            teeth: Some(teeth),
        }
    }

    /// The place of each of `matings`.
    pub fn pitches<'a>(
        &self,
        matings: impl Iterator<Item = &'a Mating>,
    ) -> impl Iterator<Item = f64> {
        places(matings).map(|pitches| self.start + self.sense * pitches)
    }

    /// First and last place.
    pub fn span(&self) -> [f64; 2] {
        let end = self.start + self.sense * self.pitches;
        [self.start.min(end), self.start.max(end)]
    }
}

/// Number of pitches of consecutive `matings`, including the whole last step.
fn pitches<'a>(matings: impl Iterator<Item = &'a Mating>) -> f64 {
    places(matings).last().unwrap_or(0.0).floor() + 1.0
}

/// Pitches from the first mating's tooth to each of `matings`: one more with each change of teeth.
pub(super) fn places<'a>(matings: impl Iterator<Item = &'a Mating>) -> impl Iterator<Item = f64> {
    matings.scan((None, 0u32), |(last, whole), mating| {
        let teeth = (mating.wheel_tooth, mating.pinion_tooth);
        if last.is_some_and(|last| last != teeth) {
            *whole += 1;
        }
        *last = Some(teeth);
        Some(f64::from(*whole) + mating.fraction)
    })
}

/// The sense in which wheel tooth numbers come into mesh: +1 ascending, −1 descending.
///
/// Ascending teeth of the locked gear come into mesh. On its mate numbers ascend with them if the two faces point in opposite directions.
fn wheel_sense(assembly: &impl ToothNumbers) -> f64 {
    let ascending = |member| assembly.shown_face(member).ascending();
    match assembly.locked() {
        Member::Wheel => 1.0,
        Member::Pinion => -ascending(Member::Wheel) * ascending(Member::Pinion),
    }
}
