//! A view of a pair file, be its gears given by data or by drawings.

use crate::outlines::{DrawingRead, OutlinePairFile};
use crate::read::PairFile;
use crate::sources::Sources;
use crate::spec::{OutlinePairSpec, PairSpec};
use gearlash::analysis::study::Study;
use gearlash::error::Error;
use serde::Serialize;

/// A pair file of either kind.
#[derive(Debug)]
pub enum AnyPair {
    /// Both gears are given by their data.
    Data(Box<PairFile>),
    /// One gear at least is given by its drawing.
    Outlines(Box<OutlinePairFile>),
}

impl AnyPair {
    /// A view of the file.
    pub fn view(&self) -> PairView<'_> {
        match self {
            AnyPair::Data(file) => file.as_ref().into(),
            AnyPair::Outlines(file) => file.as_ref().into(),
        }
    }

    /// The pair at other centre distances, mm.
    ///
    /// # Errors
    /// As [`Study::at`].
    pub fn at(self, center_distances: Vec<f64>) -> Result<AnyPair, Error> {
        Ok(match self {
            AnyPair::Data(file) => AnyPair::Data(Box::new(file.at(center_distances)?)),
            AnyPair::Outlines(file) => AnyPair::Outlines(Box::new(file.at(center_distances)?)),
        })
    }
}

/// The input of a pair as understood: keys as in a pair file, defaults filled in.
#[derive(Debug, Clone, Copy, Serialize)]
#[serde(untagged)]
pub enum AnyPairSpec<'a> {
    /// Both gears are given by their data.
    Data(&'a PairSpec),
    /// One gear at least is given by its drawing.
    Outlines(&'a OutlinePairSpec),
}

/// A view of a pair file.
#[derive(Debug, Clone, Copy)]
pub struct PairView<'a> {
    /// The study that it asks for.
    pub study: &'a Study,
    /// File stem, the name of the folder for results.
    pub stem: &'a str,
    /// The input as understood.
    pub spec: AnyPairSpec<'a>,
    /// The drawings of wheel and pinion as read; `None` of a gear by its data.
    pub drawings: [Option<&'a DrawingRead>; 2],
    /// Warnings, for standard error.
    pub warnings: &'a [String],
    /// Notes on the input, for standard error.
    pub remarks: &'a [String],
    /// The files it was read from.
    pub sources: &'a Sources,
}

impl<'a> From<&'a PairFile> for PairView<'a> {
    fn from(file: &'a PairFile) -> PairView<'a> {
        PairView {
            study: &file.study,
            stem: &file.stem,
            spec: AnyPairSpec::Data(&file.spec),
            drawings: [None; 2],
            warnings: &file.warnings,
            remarks: &file.remarks,
            sources: &file.sources,
        }
    }
}

impl<'a> From<&'a OutlinePairFile> for PairView<'a> {
    fn from(file: &'a OutlinePairFile) -> PairView<'a> {
        PairView {
            study: &file.study,
            stem: &file.stem,
            spec: AnyPairSpec::Outlines(&file.spec),
            drawings: file.drawings.each_ref().map(Option::as_ref),
            warnings: &file.warnings,
            remarks: &file.remarks,
            sources: &file.sources,
        }
    }
}

impl<'a> From<&'a AnyPair> for PairView<'a> {
    fn from(file: &'a AnyPair) -> PairView<'a> {
        file.view()
    }
}
