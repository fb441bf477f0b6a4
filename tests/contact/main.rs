//! Contact of outlines by both methods: hard pairs, symmetries, the same bits on any number of threads.

#[path = "../common/mod.rs"]
mod common;
mod hard_cases;
mod hard_pairs;
mod lost_motion_properties;
mod polygon;
mod same_bits;
