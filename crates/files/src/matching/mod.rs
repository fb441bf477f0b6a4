//! Selective assembly: folders of measured gears, and which go together.

mod folder;
mod gear;
mod part;
mod read;
mod result;

pub(crate) use part::FORMAT as PART_FORMAT;

pub use gear::NamedGear;
pub use part::{MatchAbout, MatchPart};
pub use read::{MatchFile, read_match};
pub use result::{MatchResult, MatchedPair};
