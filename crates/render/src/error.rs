//! Why a picture cannot be drawn.

/// A picture that cannot be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("the chart cannot be drawn: {0}")]
pub struct PictureError(pub String);
