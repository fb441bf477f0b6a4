//! gearlash
pub mod analytic;
pub mod cli;
pub mod compare;
pub mod error;
pub mod gear;
pub mod input;
pub mod measured;
pub mod mesh;
pub mod output;
pub mod pair;
pub mod render;
pub mod simulate;
pub mod study;
