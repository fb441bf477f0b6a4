//! Selective assembly: folders of measured gears, and which of them are paired.

mod folder;
mod gear;
mod read;
mod result;

pub use gear::NamedGear;
pub use read::{MatchFile, read_match};
pub use result::{MatchResult, MatchedPair};
