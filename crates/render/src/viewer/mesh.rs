//! The mesh of a page: its runs, picture, controls and columns; and one pose for a page that asks for each pose.

use super::columns::{Columns, RunColumns, Words};
use super::drawing;
use super::precision::Precision;
use super::readout::{self, HelicalColumns};
use super::viewed::{Viewed, outlines, run_of};
use crate::kit::dark_style;
use gearlash::analysis::compare::{ComparedPose, ComparedRun};
use gearlash::analysis::curves::Course;
use gearlash::analysis::study::{Material, Study};
use gearlash::contact::PoseResult;
use gearlash::outline::AssembledPair;

const CONTROLS: &str = include_str!("controls.html");
const SECTION_CONTROLS: &str = include_str!("section.html");

/// The runs of a page, and the gears that it draws.
pub struct Mesh<'a> {
    study: &'a Study,
    runs: Vec<Viewed<'a>>,
    /// Indices of the run and of its pose that is drawn.
    start: [usize; 2],
    outlines: Vec<&'a AssembledPair>,
    precision: Precision,
}

impl<'a> Mesh<'a> {
    /// The mesh of `runs`, with the gears of `pairs`; `None` without a run.
    pub fn new(
        study: &'a Study,
        runs: Vec<Viewed<'a>>,
        start: [usize; 2],
        pairs: impl Iterator<Item = &'a AssembledPair>,
    ) -> Option<Mesh<'a>> {
        let precision = Precision::of(&runs.get(start[0])?.run.run.assembly);
        Some(Mesh {
            study,
            runs,
            start,
            outlines: outlines(pairs),
            precision,
        })
    }

    /// Controls, picture and readout, with the controls `more` in front.
    pub fn html(&self, more: &str) -> String {
        let [first, number] = self.start;
        let viewed = &self.runs[first];
        let run = viewed.run;
        let (assembly, pose) = (&run.run.assembly, &run.poses[number]);
        let section = if assembly.varies_along_face() {
            SECTION_CONTROLS
        } else {
            ""
        };
        format!(
            "<div class=\"viewer-controls\" id=\"viewer-controls\" hidden>\n{more}{CONTROLS}</div>\n{section}{}{}{}\
             <p class=\"viewer-note\">{} Outlines: chords within {} µm of the curves, places to {} µm, rotations to 1e-6°.</p>\n",
            drawing::draw(&self.outlines, run, pose, self.precision),
            readout::note(assembly, &pose.simulated),
            readout::draw(viewed, number),
            readout::LEGEND,
            self.precision.chord_um(),
            self.precision.place_um(),
        )
    }

    pub fn columns(&self, charts: &[(String, &Course)]) -> Columns {
        let [first, number] = self.start;
        let viewed = &self.runs[first];
        let place = viewed.numbers.binary_search(&number).unwrap_or(0);
        let pose = viewed.poses().nth(place);
        let assembly = &viewed.run.run.assembly;
        let mut words = Words::default();
        let runs = self.runs.iter().map(|viewed| {
            RunColumns::new(viewed, charts, &self.outlines, self.precision, &mut words)
        });
        Columns {
            free: self.study.locked.mate().name(),
            runs: runs.collect(),
            words,
            start: [first, place],
            helical: pose.and_then(|pose| HelicalColumns::of(assembly, &pose.simulated)),
        }
    }
}

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
        let pairs = self.pairs.iter().map(|(_, pair)| pair);
        let runs = vec![Viewed::all(&self.run, false)];
        Mesh::new(self.study, runs, [0, 0], pairs)
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
