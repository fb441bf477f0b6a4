//! `gearlash gauge`, as a user runs it, and the files it writes.

mod command;
mod files;
#[path = "../../../../tests/common/made_up.rs"]
mod made_up;
mod outlines;
mod profile;
mod round_trip;
#[path = "../../../../tests/common/skip.rs"]
mod skip;
