//! What a sweep found at a pose, and which pose of several is the worst.

use super::class::PoseClass;
use super::kernel::Proof;
use super::lost_motion::{LostMotion, Status};
use crate::pair::{GearPair, Pose};
use std::collections::VecDeque;

/// One pose of a sweep and what was found there.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PoseResult {
    /// Where the gears stand.
    pub pose: Pose,
    /// Contacts of the free gear; or why there is nothing to vouch for.
    pub found: Result<LostMotion, Unproven>,
    /// `j_wt`, mm; `None` when jammed, out of mesh or unproven.
    pub backlash: Option<f64>,
    /// Bound on the error of `backlash`, mm.
    pub error_bound: Option<f64>,
    /// `j_wt`, mm, at `a − c` and at `a + c`, `c` the sum of both bearing clearances, or why it is not proven there;
    /// `None` without clearance.
    pub with_clearance: Option<[Result<Option<f64>, Unproven>; 2]>,
    /// With [`super::Method::Both`]: how the polygon method lies off the exact one; `None` where neither found contacts.
    pub polygon_difference: Option<PolygonDifference>,
    /// Whether polygons found or checked the contacts.
    pub polygon_checked: bool,
    /// With [`super::Method::Both`], and of [`GearPair::lost_motion`]: what proves the contacts, where directions do.
    pub proof: Option<Box<Proof>>,
}

/// How the polygon method lies off the exact one at a pose.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum PolygonDifference {
    /// `j_wt` on polygons minus the exact one, mm; 0 where both are jammed, or both out of mesh.
    Value(f64),
    /// Only one of them has contacts, or they end differently.
    OneAlone,
}

/// Why a pose is not proven, and the values that nothing vouches for. They are never more than something to look into.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Unproven {
    /// In words: which method or certificate saw what.
    pub reason: String,
    /// `j_wt` of the exact method, mm; `None` where it has none.
    pub exact: Option<f64>,
    /// `j_wt` of the polygon method, mm; `None` where it has none or was not asked.
    pub polygon: Option<f64>,
}

impl PoseResult {
    /// Circumferential backlash `j_wt`, mm, the lost motion as an arc of the free gear's operating pitch circle; negative when the
    /// pair interferes, `None` when it is jammed, out of mesh or unproven.
    pub fn j_wt(&self) -> Option<f64> {
        self.backlash
    }

    /// How the pose ended.
    pub fn status(&self) -> Status {
        self.proven().map_or(Status::Unproven, LostMotion::status)
    }

    /// The class of the pose, which is of `assembly`.
    pub fn class(&self, assembly: &GearPair) -> PoseClass {
        self.proven()
            .map_or(PoseClass::Unproven, |found| PoseClass::of(assembly, found))
    }

    /// The contacts; `None` where they are not proven.
    pub fn proven(&self) -> Option<&LostMotion> {
        self.found.as_ref().ok()
    }

    /// What is not proven: the pose itself, or what the ends of the bearing clearance come to.
    pub fn unproven(&self) -> impl Iterator<Item = &Unproven> {
        let ends = self.with_clearance.iter().flatten();
        let ends = ends.filter_map(|end| end.as_ref().err());
        self.found.as_ref().err().into_iter().chain(ends)
    }

    /// Whether anything of the pose is not proven, the ends of the bearing clearance included.
    pub fn is_unproven(&self) -> bool {
        self.unproven().next().is_some()
    }

    /// `j_wt`, mm, at the two ends of the bearing clearance; `backlash` twice where there is none.
    pub fn range(&self) -> [Option<f64>; 2] {
        match &self.with_clearance {
            None => [self.backlash; 2],
            Some(ends) => ends
                .each_ref()
                .map(|end| end.as_ref().ok().copied().flatten()),
        }
    }

    /// Whether the value of [`PoseResult::range`] at this end (0: `a − c`, 1: `a + c`) is not proven.
    pub fn is_end_unproven(&self, end: usize) -> bool {
        match &self.with_clearance {
            None => self.found.is_err(),
            Some(ends) => ends[end].is_err(),
        }
    }

    /// Whether `backlash` is negative beyond its error bound: rounding alone makes no interference.
    pub fn interferes(&self) -> bool {
        let surely = |(backlash, bound): (f64, f64)| backlash < -bound;
        self.backlash.zip(self.error_bound).is_some_and(surely)
    }

    /// Whether `backlash` cannot be told from none.
    pub fn just_touches(&self) -> bool {
        let none = |(backlash, bound): (f64, f64)| backlash.abs() <= bound;
        self.backlash.zip(self.error_bound).is_some_and(none)
    }
}

/// The worst of `poses`: the first that is jammed, or else the one with the least backlash, of several within their
/// error bounds the first; `None` when none is in mesh. Of an unproven pose nobody knows.
pub fn worst_pose<'a, T>(poses: impl Iterator<Item = (T, &'a PoseResult)> + Clone) -> Option<T> {
    let jammed = |pose: &PoseResult| pose.status() == Status::Jammed;
    if let Some((first, _)) = poses.clone().find(|(_, pose)| jammed(pose)) {
        return Some(first);
    }
    first_least(poses.filter_map(|(item, pose)| Some((item, pose.backlash?, pose.error_bound?))))
}

/// The first of `items` (each with a value and a bound on its error) that cannot be told from the least.
pub fn first_least<T>(items: impl Iterator<Item = (T, f64, f64)>) -> Option<T> {
    let mut least = FirstLeast::default();
    for (item, value, bound) in items {
        least.add(value, bound, || item);
    }
    least.open.pop_front().map(|(item, _)| item)
}

/// [`first_least`] of items that come one by one, without keeping all of them.
///
/// Kept are those that may still turn out to be the first: none before them may lie as low, and none is surely higher than
/// another. These are few: they fall all the way, and within two error bounds.
#[derive(Debug, Clone)]
pub struct FirstLeast<T> {
    /// The least that a value may at most be.
    limit: f64,
    /// In order, each with the least that its value may be, ever lower.
    open: VecDeque<(T, f64)>,
}

impl<T> Default for FirstLeast<T> {
    fn default() -> FirstLeast<T> {
        FirstLeast {
            limit: f64::INFINITY,
            open: VecDeque::new(),
        }
    }
}

impl<T> FirstLeast<T> {
    /// Takes the next item in, which has this `value` within this `bound`.
    pub fn add(&mut self, value: f64, bound: f64, item: impl FnOnce() -> T) {
        self.limit = self.limit.min(value + bound);
        while self.open.front().is_some_and(|(_, low)| *low > self.limit) {
            self.open.pop_front();
        }
        let low = value - bound;
        if low <= self.limit && self.open.back().is_none_or(|(_, last)| low < *last) {
            self.open.push_back((item(), low));
        }
    }

    /// The first of all so far that cannot be told from the least.
    pub fn first(&self) -> Option<&T> {
        self.open.front().map(|(item, _)| item)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The definition, in two passes: the first that may lie as low as the least that a value may at most be.
    fn by_definition(items: &[(usize, f64, f64)]) -> Option<usize> {
        let highest = items.iter().map(|(_, value, bound)| value + bound);
        let limit = highest.reduce(f64::min)?;
        let mut low = items
            .iter()
            .filter(|(_, value, bound)| value - bound <= limit);
        low.next().map(|&(item, ..)| item)
    }

    proptest! {
        /// Values on a coarse grid, so that equal ones and bounds that just overlap occur.
        #[test]
        fn one_by_one_is_the_same_as_by_definition(
            items in prop::collection::vec((-8i32..8, 0i32..4), 0..60)
        ) {
            let items = items.into_iter().enumerate();
            let items: Vec<(usize, f64, f64)> = items
                .map(|(i, (value, bound))| (i, f64::from(value), f64::from(bound)))
                .collect();
            let mut one_by_one = FirstLeast::default();
            for (i, value, bound) in &items {
                one_by_one.add(*value, *bound, || *i);
            }
            prop_assert_eq!(one_by_one.first().copied(), by_definition(&items));
            prop_assert_eq!(first_least(items.iter().copied()), by_definition(&items));
        }
    }
}
