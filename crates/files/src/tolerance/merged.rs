//! All parts of a run as one.

use super::part::Part;
use super::part_head::PartHead;
use crate::part_error::PartError;
use crate::shards::{RunPart, in_order};
use gearlash::population::WORST;

impl Part {
    /// All parts of a run, each with the name of its file, as one.
    ///
    /// # Errors
    /// [`PartError`].
    pub fn merged(parts: Vec<(String, Part)>) -> Result<Part, PartError> {
        let mut parts = in_order(parts)?.into_iter();
        let mut whole = parts.next().ok_or(PartError::None)?;
        for part in parts {
            whole.tally.add(&part.tally)?;
            whole.sums.add(&part.sums)?;
            whole.worst.extend(part.worst);
            whole.done.assemblies += part.done.assemblies;
            whole.done.rows += part.done.rows;
        }
        whole.head.shard = [1, 1];
        whole
            .worst
            .sort_by_key(|worst| (worst.margin, worst.number));
        whole.worst.truncate(WORST);
        Ok(whole)
    }
}

impl RunPart for Part {
    fn shard(&self) -> [u64; 2] {
        self.head.shard
    }

    fn is_done(&self) -> bool {
        Part::is_done(self)
    }

    fn differs(&self, other: &Part) -> Option<(&'static str, String, String)> {
        let (found, wanted) = (&self.head, &other.head);
        let texts: [(&'static str, fn(&PartHead) -> &str); 2] = [
            ("version of gearlash", |head| &head.gearlash),
            ("input", |head| &head.input_sha256),
        ];
        let numbers: [(&'static str, fn(&PartHead) -> u64); 4] = [
            ("seed", |head| head.seed),
            ("assemblies", |head| head.assemblies),
            ("rows for contributions", |head| head.contribution_rows),
            ("number of parts", |head| head.shard[1]),
        ];
        let texts = texts.map(|(what, of)| (what, of(found).to_owned(), of(wanted).to_owned()));
        let numbers =
            numbers.map(|(what, of)| (what, of(found).to_string(), of(wanted).to_string()));
        let mut each = texts.into_iter().chain(numbers);
        each.find(|(_, found, wanted)| found != wanted).or_else(|| {
            let what = self.about.differs(&other.about)?;
            let same = "the same to the last bit";
            Some((what, "another".to_owned(), same.to_owned()))
        })
    }
}
