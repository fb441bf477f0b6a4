//! Selective assembly: folders of measured gears, and which of them are paired.

mod read;
mod result;

pub use read::{MatchFile, NamedGear, read_match};
pub use result::{MatchResult, MatchedPair};
