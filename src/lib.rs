//! gearlash
pub mod analytic;
pub mod error;
pub mod gear;
pub mod input;
pub mod mesh;
pub mod pair;
pub mod render;
pub mod study;
