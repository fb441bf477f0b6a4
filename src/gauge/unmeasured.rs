//! Why a gauge has no reading.

/// A measurement that this gear does not allow. A result, not a fault: the other gauges still read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{0}")]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Unmeasured(pub String);
