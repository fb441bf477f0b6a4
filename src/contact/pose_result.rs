//! The result of a sweep at a pose, and the worst of several poses.

use super::class::PoseClass;
use super::kernel::Proof;
use super::lost_motion::{LostMotion, Status};
use crate::pair::{GearPair, Pose};
use std::collections::VecDeque;

/// One pose of a sweep and its result.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PoseResult {
    /// Positions of the gears.
    pub pose: Pose,
    /// Contacts of the free gear, or why they are unproven.
    pub found: Result<LostMotion, Unproven>,
    /// `j_wt`, mm; `None` when jammed, out of mesh or unproven.
    pub backlash: Option<f64>,
    /// Bound on the error of `backlash`, mm.
    pub error_bound: Option<f64>,
    /// `j_wt`, mm, at `a − c` and at `a + c`, where `c` is the sum of both bearing clearances, or why it is not proven
    /// there; `None` without clearance.
    pub with_clearance: Option<[Result<Option<f64>, Unproven>; 2]>,
    /// With [`super::Method::Both`]: the difference of the polygon method; `None` if neither found contacts.
    pub polygon_difference: Option<PolygonDifference>,
    /// Whether polygons found or checked the contacts.
    pub polygon_checked: bool,
    /// With [`super::Method::Both`] and [`super::lost_motion_at`]: the proof of the contacts by directions, if there is one.
    pub proof: Option<Box<Proof>>,
}

/// The difference between the polygon method and the exact one at a pose.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum PolygonDifference {
    /// `j_wt` on polygons minus the exact one, mm; 0 where both are jammed, or both out of mesh.
    Value(f64),
    /// Only one of them has contacts, or their status differs.
    OneAlone,
}

/// The reason why a pose is unproven, and the unverified values. Use them only to investigate.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Unproven {
    /// The method or certificate, and its finding, in words.
    pub reason: String,
    /// `j_wt` of the exact method, mm; `None` if it has none.
    pub exact: Option<f64>,
    /// `j_wt` of the polygon method, mm; `None` if it has none or was not used.
    pub polygon: Option<f64>,
}

impl PoseResult {
    /// Circumferential backlash `j_wt`, mm, the lost motion as an arc of the free gear's operating pitch circle; negative when the
    /// pair interferes, `None` when it is jammed, out of mesh or unproven.
    pub fn j_wt(&self) -> Option<f64> {
        self.backlash
    }

    /// The status of the pose.
    pub fn status(&self) -> Status {
        self.proven().map_or(Status::Unproven, LostMotion::status)
    }

    /// The class of the pose on `assembly`.
    pub fn class(&self, assembly: &GearPair) -> PoseClass {
        self.proven()
            .map_or(PoseClass::Unproven, |found| PoseClass::of(assembly, found))
    }

    /// The contacts; `None` if they are unproven.
    pub fn proven(&self) -> Option<&LostMotion> {
        self.found.as_ref().ok()
    }

    /// The unproven parts: the pose itself, or the ends of the bearing clearance.
    pub fn unproven(&self) -> impl Iterator<Item = &Unproven> {
        let ends = self.with_clearance.iter().flatten();
        let ends = ends.filter_map(|end| end.as_ref().err());
        self.found.as_ref().err().into_iter().chain(ends)
    }

    /// Whether any part of the pose is unproven, including the ends of the bearing clearance.
    pub fn is_unproven(&self) -> bool {
        self.unproven().next().is_some()
    }

    /// `j_wt`, mm, at the two ends of the bearing clearance; `backlash` twice without clearance, none where the axes tilt in it.
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

    /// Whether `backlash` is negative by more than its error bound: rounding alone is no interference.
    pub fn interferes(&self) -> bool {
        let surely = |(backlash, bound): (f64, f64)| backlash < -bound;
        self.backlash.zip(self.error_bound).is_some_and(surely)
    }

    /// Whether `backlash` cannot be distinguished from zero.
    pub fn just_touches(&self) -> bool {
        let none = |(backlash, bound): (f64, f64)| backlash.abs() <= bound;
        self.backlash.zip(self.error_bound).is_some_and(none)
    }
}

/// The worst of `poses`: the first that is jammed, otherwise the one with the least backlash. If several are within
/// their error bounds, it is the first. `None` if none is in mesh; unproven poses are excluded.
pub fn worst_pose<'a, T>(poses: impl Iterator<Item = (T, &'a PoseResult)> + Clone) -> Option<T> {
    let jammed = |pose: &PoseResult| pose.status() == Status::Jammed;
    if let Some((first, _)) = poses.clone().find(|(_, pose)| jammed(pose)) {
        return Some(first);
    }
    first_least(poses.filter_map(|(item, pose)| Some((item, pose.backlash?, pose.error_bound?))))
}

/// The first of `items` (each with a value and a bound on its error) that cannot be distinguished from the least.
pub fn first_least<T>(items: impl Iterator<Item = (T, f64, f64)>) -> Option<T> {
    let mut least = FirstLeast::default();
    for (item, value, bound) in items {
        least.add(value, bound, || item);
    }
    least.open.pop_front().map(|(item, _)| item)
}

/// [`first_least`] of items that arrive one by one, without keeping all of them.
///
/// It keeps the items that can still be the first: none before them can be as low, and none is certainly higher than
/// another. These are few, because their values fall and stay within two error bounds.
#[derive(Debug, Clone)]
pub struct FirstLeast<T> {
    /// Upper bound of the least value.
    limit: f64,
    /// In order, each with its lower bound, which falls from one to the next.
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
    /// Adds the next item, whose `value` is within `bound`.
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

    /// The first of all items so far that cannot be distinguished from the least.
    pub fn first(&self) -> Option<&T> {
        self.open.front().map(|(item, _)| item)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Values on a coarse grid, so that equal ones and bounds that just overlap occur. Source: the definition, in two passes: the first
        /// item that can be as low as the upper bound of the least.
        #[test]
        fn one_by_one_is_the_same_as_by_definition(
            items in prop::collection::vec((-8i32..8, 0i32..4), 0..60)
        ) {
            let items = items.into_iter().enumerate();
            let items: Vec<(usize, f64, f64)> = items
                .map(|(i, (value, bound))| (i, f64::from(value), f64::from(bound)))
                .collect();
            let limit = items.iter().map(|(_, value, bound)| value + bound).reduce(f64::min);
            let expected = items
                .iter()
                .find(|(_, value, bound)| limit.is_some_and(|limit| value - bound <= limit))
                .map(|&(item, ..)| item);
            let mut one_by_one = FirstLeast::default();
            for (i, value, bound) in &items {
                one_by_one.add(*value, *bound, || *i);
            }
            prop_assert_eq!(one_by_one.first().copied(), expected);
            prop_assert_eq!(first_least(items.iter().copied()), expected);
        }
    }
}
