//! Shared parts of several test files: reference data, published cases, random pairs.

#![allow(dead_code, unused_imports)] // each test binary uses its part

pub mod published_case;
pub mod random_pair;
mod reference;

pub use reference::*;
