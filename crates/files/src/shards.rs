//! A run in parts: which numbers are of which, and whether files are all parts of one run.

use crate::part_error::PartError;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::ops::Range;

/// Parts of a run, at most.
pub const MOST_SHARDS: u64 = 100_000;

/// The numbers, from 0, of `total` that are of part `k` of `n`: equal parts, but for one.
pub fn share(total: u64, [k, n]: [u64; 2]) -> Range<u64> {
    let end = |k: u64| (u128::from(total) * u128::from(k) / u128::from(n.max(1))) as u64;
    end(k.saturating_sub(1))..end(k)
}

/// Whether there is such a part of a run of `total`.
pub fn is_share(total: u64, [k, n]: [u64; 2]) -> bool {
    1 <= k && k <= n && n <= MOST_SHARDS && n <= total
}

/// The hash of `text`, as of what a run is about.
pub fn sha256(text: &str) -> String {
    let digest = Sha256::digest(text.as_bytes());
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A part of a run, as far as putting parts together goes.
pub trait RunPart {
    /// `k` of `n`.
    fn shard(&self) -> [u64; 2];

    /// Whether all of it is done.
    fn is_done(&self) -> bool;

    /// What says that it is of another run than `other`: what, its own and the other's.
    fn differs(&self, other: &Self) -> Option<(&'static str, String, String)>;
}

/// All parts of one run, each with the name of its file, in the order of their numbers.
///
/// # Errors
/// [`PartError`]: none given, one of another run, unfinished, given twice or missing.
pub fn in_order<P: RunPart>(parts: Vec<(String, P)>) -> Result<Vec<P>, PartError> {
    let mut seen: BTreeMap<u64, (String, P)> = BTreeMap::new();
    let mut first: Option<(String, u64)> = None;
    for (file, part) in parts {
        let [shard, _] = part.shard();
        if let Some((first, number)) = &first
            && let Some((what, found, wanted)) = part.differs(&seen[number].1)
        {
            return Err(PartError::Foreign {
                file,
                first: first.clone(),
                what,
                found,
                wanted,
            });
        }
        if !part.is_done() {
            return Err(PartError::Unfinished { file, shard });
        }
        first.get_or_insert_with(|| (file.clone(), shard));
        if let Some((before, _)) = seen.get(&shard) {
            return Err(match file == *before {
                true => PartError::Twice { file },
                false => PartError::Double {
                    file,
                    first: before.clone(),
                    shard,
                },
            });
        }
        seen.insert(shard, (file, part));
    }
    let (_, number) = first.ok_or(PartError::None)?;
    let [_, of] = seen[&number].1.shard();
    let missing = (1..=of).filter(|shard| !seen.contains_key(shard));
    let shards: Vec<u64> = missing.collect();
    match shards.is_empty() {
        true => Ok(seen.into_values().map(|(_, part)| part).collect()),
        false => Err(PartError::Missing { shards, of }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// However many parts there are, each number is of one of them.
    #[test]
    fn shares_are_a_whole() {
        for total in [1, 2, 7, 64, 1000] {
            for n in 1..=total {
                let shares: Vec<u64> = (1..=n).flat_map(|k| share(total, [k, n])).collect();
                assert_eq!(shares, (0..total).collect::<Vec<_>>());
                assert!((1..=n).all(|k| is_share(total, [k, n])));
            }
            assert!(
                ![[0, 1], [2, 1], [1, total + 1]]
                    .iter()
                    .any(|one| is_share(total, *one))
            );
        }
    }
}
