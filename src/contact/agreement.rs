//! Agreement of the two methods over many poses.

use super::pose_result::{PolygonDifference, PoseResult};

/// Agreement of both methods over some poses. Each pose is judged by its own allowance; one that exceeds it is [`super::Unproven`].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MethodAgreement {
    /// Poses at which both methods have a value or the same status.
    pub compared: usize,
    /// Largest amount among them of `j_wt` on polygons minus the exact one, mm.
    pub largest: f64,
    /// How many of them exceed their allowance.
    pub beyond: usize,
    /// Poses at which only one method has a contact, or the status differs.
    pub one_alone: usize,
}

impl MethodAgreement {
    /// Adds the next pose. A pose of one method alone changes nothing.
    pub fn add(&mut self, pose: &PoseResult) {
        match pose.polygon_difference {
            None => {}
            Some(PolygonDifference::OneAlone) => self.one_alone += 1,
            Some(PolygonDifference::Value(difference)) => {
                self.compared += 1;
                self.largest = self.largest.max(difference.abs());
                self.beyond += usize::from(pose.found.is_err());
            }
        }
    }

    /// The agreement over `poses`.
    pub fn of<'a>(poses: impl IntoIterator<Item = &'a PoseResult>) -> MethodAgreement {
        let mut of = MethodAgreement::default();
        poses.into_iter().for_each(|pose| of.add(pose));
        of
    }

    /// The agreement over these poses and `others`.
    pub fn and(self, others: MethodAgreement) -> MethodAgreement {
        MethodAgreement {
            compared: self.compared + others.compared,
            largest: self.largest.max(others.largest),
            beyond: self.beyond + others.beyond,
            one_alone: self.one_alone + others.one_alone,
        }
    }

    /// Whether no pose had both methods, or neither found a contact at any.
    pub fn is_empty(&self) -> bool {
        self.compared + self.one_alone == 0
    }

    /// Whether they agree at all poses.
    pub fn agrees(&self) -> bool {
        self.beyond + self.one_alone == 0
    }
}
