//! Which part of which run, and what of the run it has.

use crate::limits::ASSEMBLIES;
use crate::shards::share;
use serde::{Deserialize, Serialize};

/// What a part's file begins with.
const FORMAT: &str = "gearlash tolerance part 1";

/// Which part of which run it is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct PartHead {
    format: String,
    /// Version of gearlash.
    pub gearlash: String,
    /// SHA-256 of the pair as understood, and of all gears that are drawn.
    pub input_sha256: String,
    /// Seed.
    pub seed: u64,
    /// Assemblies of the whole run.
    pub assemblies: u64,
    /// Rows of the samples for contributions, of the whole run.
    pub contribution_rows: u64,
    /// `k` of `n` parts.
    pub shard: [u64; 2],
}

/// Assemblies of a run, at most.
pub const MOST_ASSEMBLIES: u64 = *ASSEMBLIES.end() as u64;

/// How much of a part is done.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Progress {
    /// Assemblies from the part's first on.
    pub assemblies: u64,
    /// Rows from the part's first on.
    pub rows: u64,
}

impl PartHead {
    /// Part `k` of `n` of a run.
    pub(super) fn new(
        input_sha256: String,
        seed: u64,
        whole: Progress,
        shard: [u64; 2],
    ) -> PartHead {
        PartHead {
            format: FORMAT.to_owned(),
            gearlash: env!("CARGO_PKG_VERSION").to_owned(),
            input_sha256,
            seed,
            assemblies: whole.assemblies,
            contribution_rows: whole.rows,
            shard,
        }
    }

    /// Whether its file is of this version's format.
    pub(super) fn is_of_this_format(&self) -> bool {
        self.format == FORMAT
    }

    /// The numbers, from 1, of what it has of `total`.
    fn range(&self, total: u64) -> std::ops::Range<u64> {
        let share = share(total, self.shard);
        share.start + 1..share.end + 1
    }

    /// Its assemblies.
    pub fn numbers(&self) -> std::ops::Range<u64> {
        self.range(self.assemblies)
    }

    /// Its rows of the samples for contributions.
    pub fn rows(&self) -> std::ops::Range<u64> {
        self.range(self.contribution_rows)
    }
}
