//! The gauges' readings as text, charts and a gear file.

mod charts;
mod text;

pub use charts::{charts, page};
pub use text::text;
