//! Two drawings of one gear, read and compared.

use super::gear::{OutlinePart, gear, help};
use super::pair::{OutlineOptions, outline_table};
use crate::check::check;
use crate::spec::DRAWINGS;
use gearlash::outline::{Deviation, OutlineDifference, OutlineGear};
use gearlash_text::{Sources, Table};
use nalgebra::Point2;
use std::path::Path;

/// The drawings' names in messages and results.
const NAMES: [&str; 2] = ["a", "b"];

/// Chords of both outlines, mm: 0.01 µm, a tenth of the finest outline that makes sense to write.
const CHORD_MM: f64 = 1e-5;

/// Two drawings of one gear, read and compared.
#[derive(Debug)]
pub struct ComparedOutlines {
    /// The files as named.
    pub files: [String; 2],
    /// The gears.
    pub gears: [OutlineGear; 2],
    /// Their centres in the drawings, mm.
    pub centres: [Point2<f64>; 2],
    /// The deviations of B from A.
    pub difference: OutlineDifference,
    /// The unit that is not used, of each, for standard error.
    pub warnings: [Option<String>; 2],
    /// Remarks on each, for standard error.
    pub remarks: [Vec<String>; 2],
    /// The files it was read from.
    pub sources: Sources,
}

/// The tables of a pair file for the drawings at `paths`.
pub(crate) fn compared_tables(paths: [&Path; 2], options: [&OutlineOptions; 2]) -> String {
    let table = |k: usize| outline_table(NAMES[k], paths[k], options[k]);
    [0, 1].map(table).concat()
}

/// Compares the drawings at `paths`, read from their tables.
pub(crate) fn compared(file: &Table, paths: [&Path; 2]) -> Option<ComparedOutlines> {
    check(&DRAWINGS, file);
    let [a, b] = NAMES.map(|name| gear(file, name));
    let (a, b): (OutlinePart, OutlinePart) = (a?, b?);
    let gears = [&a, &b].map(|part| part.gears.most().clone());
    let difference = OutlineDifference::new(&gears[0], &gears[1], CHORD_MM);
    let difference = difference.map_err(|error| {
        let help = help(&error);
        file.problem("b.outline.file", error, help)
    });
    Some(ComparedOutlines {
        difference: file.reading().keep(difference)?,
        files: paths.map(|path| path.display().to_string()),
        centres: [a.read.centre, b.read.centre],
        gears,
        warnings: Default::default(),
        remarks: [a.remarks, b.remarks],
        sources: file.reading().sources(),
    })
}

impl ComparedOutlines {
    /// A place on A in its drawing, mm.
    pub fn in_drawing(&self, at: &Deviation) -> Point2<f64> {
        self.centres[0] + at.point.coords
    }

    /// The deviation farthest from 0.
    pub fn farthest(&self) -> &Deviation {
        let OutlineDifference {
            greatest, least, ..
        } = &self.difference;
        if greatest.beyond.abs() >= least.beyond.abs() {
            greatest
        } else {
            least
        }
    }

    /// Whether no deviation exceeds `tolerance_um` + bound. Without a tolerance every comparison passes.
    pub fn passes(&self, tolerance_um: Option<f64>) -> bool {
        tolerance_um.is_none_or(|tolerance| {
            self.farthest().beyond.abs() <= 1e-3 * tolerance + self.difference.bound
        })
    }
}
