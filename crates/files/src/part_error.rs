//! Why files are no parts of a run, or no whole one.

use gearlash::population::Overflow;

/// Parts that make no whole.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PartError {
    /// A file that is no part.
    #[error(
        "{file}: this is no part of a run: {reason}; name files that gearlash tolerance --shard or gearlash match --shard wrote"
    )]
    Invalid {
        /// The file.
        file: String,
        /// Why.
        reason: String,
    },
    /// A part of another run.
    #[error(
        "{file}: is of another run than {first}: {what} {found}, not {wanted}; name the parts of one run"
    )]
    Foreign {
        /// The file.
        file: String,
        /// The one it is compared with.
        first: String,
        /// What differs.
        what: &'static str,
        /// What it has.
        found: String,
        /// What the first has.
        wanted: String,
    },
    /// A part that was not finished.
    #[error(
        "{file}: part {shard} was interrupted; run its command again, which goes on from there"
    )]
    Unfinished {
        /// The file.
        file: String,
        /// Its number.
        shard: u64,
    },
    /// A file given twice.
    #[error("{file}: is named twice; name each part once")]
    Twice {
        /// The file.
        file: String,
    },
    /// A part in two files.
    #[error("{file}: is part {shard}, as {first} is; name each part once")]
    Double {
        /// The file.
        file: String,
        /// The one before.
        first: String,
        /// Its number.
        shard: u64,
    },
    /// Parts that are not there.
    #[error("{} of {of} missing: {}; run the command with --shard K/{of} for each", parts(.shards), listed(.shards))]
    Missing {
        /// Their numbers.
        shards: Vec<u64>,
        /// How many there are in all.
        of: u64,
    },
    /// No part at all.
    #[error(
        "no part of a run; name the files that gearlash tolerance --shard or gearlash match --shard wrote"
    )]
    None,
    /// Sums beyond all bounds.
    #[error(transparent)]
    Overflow(#[from] Overflow),
}

fn parts(shards: &[u64]) -> String {
    match shards.len() {
        1 => "1 part".to_owned(),
        count => format!("{count} parts"),
    }
}

/// The first dozen of them.
fn listed(shards: &[u64]) -> String {
    let first = shards.iter().take(12).map(u64::to_string);
    let mut text = first.collect::<Vec<_>>().join(", ");
    if shards.len() > 12 {
        text += " …";
    }
    text
}
