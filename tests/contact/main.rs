//! Contact of outlines by both methods: reference poses, hard pairs, symmetries, the same bits on any number of threads.

#[path = "../common/mod.rs"]
mod common;
mod hard_pairs;
#[path = "../common/kit.rs"]
mod kit;
mod properties;
mod reference;
