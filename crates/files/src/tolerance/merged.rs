//! All parts of a run as one.

use super::part::Part;
use super::part_error::PartError;
use super::part_head::PartHead;
use gearlash::population::WORST;
use std::collections::BTreeMap;

impl Part {
    /// All parts of a run, each with the name of its file, as one.
    ///
    /// # Errors
    /// [`PartError`].
    pub fn merged(parts: Vec<(String, Part)>) -> Result<Part, PartError> {
        let mut given = parts.into_iter();
        let (first, mut whole) = given.next().ok_or(PartError::None)?;
        unfinished(&first, &whole)?;
        let mut seen = BTreeMap::from([(whole.head.shard[0], first.clone())]);
        for (file, part) in given {
            same(&file, &part, &first, &whole)?;
            unfinished(&file, &part)?;
            let shard = part.head.shard[0];
            if let Some(before) = seen.insert(shard, file.clone()) {
                return Err(match file == before {
                    true => PartError::Twice { file },
                    false => PartError::Double {
                        file,
                        first: before,
                        shard,
                    },
                });
            }
            whole.tally.add(&part.tally)?;
            whole.sums.add(&part.sums)?;
            whole.worst.extend(part.worst);
            whole.done.assemblies += part.done.assemblies;
            whole.done.rows += part.done.rows;
        }
        let of = whole.head.shard[1];
        let missing = (1..=of).filter(|shard| !seen.contains_key(shard));
        let shards: Vec<u64> = missing.collect();
        if !shards.is_empty() {
            return Err(PartError::Missing { shards, of });
        }
        whole.head.shard = [1, 1];
        whole
            .worst
            .sort_by_key(|worst| (worst.margin, worst.number));
        whole.worst.truncate(WORST);
        Ok(whole)
    }
}

fn unfinished(file: &str, part: &Part) -> Result<(), PartError> {
    match part.is_done() {
        true => Ok(()),
        false => Err(PartError::Unfinished {
            file: file.to_owned(),
            shard: part.head.shard[0],
        }),
    }
}

/// Whether `part` is of the run of `whole`, the first of whose parts is `first`.
fn same(file: &str, part: &Part, first: &str, whole: &Part) -> Result<(), PartError> {
    let (found, wanted) = (&part.head, &whole.head);
    let number = |head: &PartHead, of: fn(&PartHead) -> u64| of(head).to_string();
    let each: [(&'static str, String, String); 6] = [
        (
            "version of gearlash",
            found.gearlash.clone(),
            wanted.gearlash.clone(),
        ),
        (
            "input",
            found.input_sha256.clone(),
            wanted.input_sha256.clone(),
        ),
        (
            "seed",
            number(found, |head| head.seed),
            number(wanted, |head| head.seed),
        ),
        (
            "assemblies",
            number(found, |head| head.assemblies),
            number(wanted, |head| head.assemblies),
        ),
        (
            "rows for contributions",
            number(found, |head| head.contribution_rows),
            number(wanted, |head| head.contribution_rows),
        ),
        (
            "number of parts",
            number(found, |head| head.shard[1]),
            number(wanted, |head| head.shard[1]),
        ),
    ];
    let differs = each.into_iter().find(|(_, found, wanted)| found != wanted);
    let differs = differs.or_else(|| {
        let what = part.about.differs(&whole.about)?;
        Some((
            what,
            "another".to_owned(),
            "the same to the last bit".to_owned(),
        ))
    });
    match differs {
        None => Ok(()),
        Some((what, found, wanted)) => Err(PartError::Foreign {
            file: file.to_owned(),
            first: first.to_owned(),
            what,
            found,
            wanted,
        }),
    }
}
