//! The mesh of a page: its runs, picture, controls and columns.

use super::columns::Columns;
use super::precision::Precision;
use super::viewed::{Viewed, outlines};
use super::{drawing, readout, section};
use gearlash::analysis::curves::Course;
use gearlash::analysis::study::Study;
use gearlash::outline::AssembledPair;

const CONTROLS: &str = include_str!("controls.html");
/// Additional controls for helical gears.
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
        let precision = Precision::of(&runs.get(start[0])?.shown.run.run.assembly);
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
        let run = viewed.shown.run;
        let (assembly, pose) = (&run.run.assembly, &run.poses[number]);
        let section = if assembly.is_helical() {
            SECTION_CONTROLS
        } else {
            ""
        };
        format!(
            "<div class=\"viewer-controls\" id=\"viewer-controls\" hidden>\n{more}{CONTROLS}</div>\n{section}{}{}{}\
             <p class=\"viewer-note\">{} Outlines: chords within {} µm of the curves, places to {} µm, rotations to 1e-6°.</p>\n",
            drawing::draw(&self.outlines, run, pose, self.precision),
            section::note(assembly, &pose.simulated),
            readout::draw(viewed, number),
            readout::LEGEND,
            self.precision.chord_um(),
            self.precision.place_um(),
        )
    }

    /// The columns for the script.
    pub fn columns(&self, charts: &[(&str, &Course)]) -> Columns {
        let [first, number] = self.start;
        let place = self.runs[first].numbers.binary_search(&number);
        let shown = [first, place.unwrap_or(0)];
        Columns::new(
            self.study,
            &self.runs,
            charts,
            shown,
            &self.outlines,
            self.precision,
        )
    }
}
