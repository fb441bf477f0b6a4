//! One pose for a page that asks for each pose.

use super::mesh::Mesh;
use super::viewed::{Shown, Viewed, run_of};
use crate::kit::dark_style;
use gearlash::analysis::compare::{ComparedPose, ComparedRun};
use gearlash::analysis::study::{Material, Study};
use gearlash::contact::PoseResult;
use gearlash::outline::AssembledPair;

/// A pose, and the gears of every material of its study.
pub struct LivePose<'a> {
    study: &'a Study,
    pairs: &'a [(Material, AssembledPair)],
    run: ComparedRun,
}

impl<'a> LivePose<'a> {
    /// `pose` of the pair at `chosen` of `pairs`, which has every material of `study`; `None` without that pair.
    pub fn new(
        study: &'a Study,
        pairs: &'a [(Material, AssembledPair)],
        chosen: usize,
        pose: PoseResult,
    ) -> Option<LivePose<'a>> {
        let pair = pairs.get(chosen)?.clone();
        Some(LivePose {
            study,
            pairs,
            run: run_of(pair, None, ComparedPose::from(pose)),
        })
    }

    fn mesh(&self) -> Option<Mesh<'_>> {
        let viewed = Viewed {
            shown: Shown {
                run: &self.run,
                is_worst_of_cycle: false,
            },
            numbers: vec![0],
        };
        let pairs = self.pairs.iter().map(|(_, pair)| pair);
        Mesh::new(self.study, vec![viewed], [0, 0], pairs)
    }

    /// The picture with its controls, for `mesh.js`.
    pub fn html(&self) -> String {
        let html = self.mesh().map_or(String::new(), |mesh| mesh.html(""));
        dark_style(&html) + &html
    }

    /// The columns that `mesh.js` moves the picture by.
    ///
    /// # Errors
    /// None for results of a simulation: the columns are numbers and names.
    pub fn columns(&self) -> Result<serde_json::Value, serde_json::Error> {
        serde_json::to_value(self.mesh().map(|mesh| mesh.columns(&[])))
    }
}
