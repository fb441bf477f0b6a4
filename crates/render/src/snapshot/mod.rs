//! Snapshots: one pose of a gear pair, true to scale, on an A4 sheet; its deviations enlarged; its motion over a pitch.

mod animation;
mod caption;
mod contacts;
mod difference;
mod exaggerated;
mod gears;
mod inset;
mod labels;
mod legend;
mod picture;
mod subject;
mod view;

pub use animation::animation;
pub use difference::outline_difference;
pub use exaggerated::exaggerated;
pub(crate) use picture::pose_picture_in_page;
pub use picture::{pose_picture, snapshot};
pub use subject::Snapshot;
