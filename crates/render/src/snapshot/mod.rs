//! Snapshots: one pose of a gear pair, true to scale, on an A4 sheet; its deviations enlarged; its motion over a pitch.

mod animation;
mod caption;
mod contact_bands;
mod contact_marks;
mod difference;
mod exaggerated;
mod gears;
mod inset;
mod legend;
mod main_view;
mod overlap_label;
mod picture;
mod pitch_chart;
mod pose_picture;
mod subject;
mod tooth_numbers;
mod turning;
mod view;

pub use animation::animation;
pub use difference::outline_difference;
pub use exaggerated::exaggerated;
pub use picture::snapshot;
pub use pose_picture::pose_picture;
pub(crate) use pose_picture::pose_picture_in_page;
pub use subject::Snapshot;
