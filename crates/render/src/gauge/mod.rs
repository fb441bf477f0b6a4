//! What the gauges read, as text, as charts and as a gear file that states it.

mod charts;
mod text;

pub use charts::{charts, page};
pub use text::text;
