//! What the two methods come to at many poses.

use super::pose_result::{PolygonDifference, PoseResult};

/// How far both methods agree at some poses. Whether one of them is off is judged pose by pose, by what is allowed there:
/// such a pose is [`super::Unproven`].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MethodAgreement {
    /// Poses at which both have a value, or end alike.
    pub compared: usize,
    /// Of these the largest amount of `j_wt` on polygons minus the exact one, mm.
    pub largest: f64,
    /// At how many of these it is more than is allowed there.
    pub beyond: usize,
    /// At how many poses only one method has a contact, or they end differently.
    pub one_alone: usize,
}

impl MethodAgreement {
    /// Takes the next pose in; one that was asked of one method alone changes nothing.
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

    /// Of `poses`.
    pub fn of<'a>(poses: impl IntoIterator<Item = &'a PoseResult>) -> MethodAgreement {
        let mut of = MethodAgreement::default();
        poses.into_iter().for_each(|pose| of.add(pose));
        of
    }

    /// Of these poses and `others`.
    pub fn and(self, others: MethodAgreement) -> MethodAgreement {
        MethodAgreement {
            compared: self.compared + others.compared,
            largest: self.largest.max(others.largest),
            beyond: self.beyond + others.beyond,
            one_alone: self.one_alone + others.one_alone,
        }
    }

    /// Whether no pose was asked of both methods, or neither found a contact at any.
    pub fn is_empty(&self) -> bool {
        self.compared + self.one_alone == 0
    }

    /// Whether they agree at all poses.
    pub fn agrees(&self) -> bool {
        self.beyond + self.one_alone == 0
    }
}
