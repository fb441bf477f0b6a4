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
        let each = |head: &PartHead| {
            [
                ("version of gearlash", head.gearlash.clone()),
                ("input", head.input_sha256.clone()),
                ("seed", head.seed.to_string()),
                ("assemblies", head.assemblies.to_string()),
                ("rows for contributions", head.contribution_rows.to_string()),
                ("number of parts", head.shard[1].to_string()),
            ]
        };
        let mut both = each(&self.head).into_iter().zip(each(&other.head));
        let differs = both.find(|((_, found), (_, wanted))| found != wanted);
        let of_run = || {
            let what = self.about.differs(&other.about)?;
            let same = "the same to the last bit".to_owned();
            Some((what, "another".to_owned(), same))
        };
        let found = differs.map(|((what, found), (_, wanted))| (what, found, wanted));
        found.or_else(of_run)
    }
}
