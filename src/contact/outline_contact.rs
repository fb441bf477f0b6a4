//! The reasons why a pose of outlines is unproven.

/// A pose that was not settled within its effort.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "the search for the contact of wheel tooth {wheel_tooth} and pinion tooth {pinion_tooth} on {flank} flanks did not end"
)]
pub struct SearchExhausted {
    /// Wheel tooth.
    pub wheel_tooth: u32,
    /// Pinion tooth.
    pub pinion_tooth: u32,
    /// `right` or `left`.
    pub flank: &'static str,
}

/// A contact that polygons do not confirm.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("polygons do not confirm the contact on {flank} flanks: {reason}")]
pub struct ContactNotConfirmed {
    /// `right` or `left`.
    pub flank: &'static str,
    /// The finding of the polygons.
    pub reason: &'static str,
}
