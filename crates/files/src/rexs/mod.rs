//! REXS, the exchange format for gearboxes: stages of external gears, spur and helical, become pair files, all else is named and left out, and the
//! backlash of a stage goes back into a copy of the file.
//!
//! Versions 1.0 to 2.0, XML and JSON, and the same zipped (`.rexsz`). Facts of the format are those of its owner's public Java API
//! (<https://github.com/fva-net/rexs-api-java>, Apache-2.0). Internal gears and planetary stages are never read as external pairs.

mod archive;
mod document;
mod fault;
mod gear;
mod generated;
mod json;
mod same;
mod stage;
mod thickness;
mod xml;

pub use crate::gearbox_model::is_rexs;

use crate::characters::{cut, plain};
use crate::error::{InputError, Problem};
use crate::node::LONGEST;
use crate::place::Place;
use crate::spec::PairSpec;
use crate::{source, with_bytes};
use document::{Component, Document, problem};
use fault::Fault;
use stage::Stage;
use std::ops::Range;
use std::path::Path;

/// Stages of a file. The largest gearboxes have a dozen.
const MOST_STAGES: usize = 200;

/// A REXS file and what its stages became.
#[derive(Debug)]
pub struct RexsFile {
    /// Of the format: "1.4".
    pub version: String,
    /// What wrote it.
    pub application: String,
    /// In the order of the file.
    pub stages: Vec<RexsStage>,
    /// What was not read: kinds of components and how many, other parts of the file.
    pub left_out: Vec<(String, usize)>,
    /// The file itself.
    pub sources: crate::Sources,
    document: Document,
    content: Content,
}

/// A stage.
#[derive(Debug)]
pub struct RexsStage {
    /// The component's.
    pub id: i32,
    /// Such as `cylindrical_stage`.
    pub kind: String,
    /// May be empty.
    pub name: String,
    /// Teeth and normal module (mm) of both gears, where these are cylindrical and external.
    pub gears: Option<[(u32, f64); 2]>,
    /// The pair, or why there is none.
    pub pair: Result<RexsPair, String>,
}

/// A stage of external gears.
#[derive(Debug)]
pub struct RexsPair {
    /// Its numbers in a line.
    pub summary: String,
    /// The pair file, TOML: gear 1 is the wheel.
    pub pair_file: String,
    /// Remarks for the user.
    pub remarks: Vec<String>,
    /// Attributes that were not used, by component.
    pub unused: Vec<(String, Vec<String>)>,
    /// The pair file as understood.
    spec: PairSpec,
}

/// Least and greatest backlash of a stage, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RexsBacklash {
    /// `j_bn`.
    pub normal: [f64; 2],
    /// `j_t`, on the reference circles.
    pub transverse: [f64; 2],
}

#[derive(Debug)]
enum Content {
    Xml(String),
    Json(String),
    /// Cannot be written to.
    Zipped,
}

/// Reads the REXS file at `path`; `-` is standard input.
///
/// # Errors
/// [`InputError`] with the place of what is wrong with the file as a whole: a line and a column, or a component and an attribute. What is
/// wrong with one stage is the reason of that stage.
pub fn read(path: &Path) -> Result<RexsFile, InputError> {
    with_bytes(path, |path, place, bytes, problems| {
        let file = bytes.and_then(|bytes| of_bytes(path, place, bytes));
        problems.keep(file)
    })
}

/// Reads `bytes`, called `path` in messages.
fn of_bytes(path: &Path, place: &Place, bytes: Vec<u8>) -> Result<RexsFile, Problem> {
    let zipped = bytes.starts_with(b"PK");
    let bytes = match zipped {
        true => archive::unpacked(&bytes)?,
        false => bytes,
    };
    let text = source::text_with_mark(bytes)?;
    let (document, content) = match text
        .trim_start_matches('\u{feff}')
        .trim_start()
        .chars()
        .next()
    {
        Some('<') => (xml::read(&text)?, Content::Xml(text)),
        Some('{') => (json::read(&text)?, Content::Json(text)),
        _ => {
            return Err(problem(
                "line 1",
                "neither XML nor JSON",
                "name a REXS file: .rexs, .rexsj or .rexsz",
            ));
        }
    };
    document.check()?;
    let source = path.file_name().unwrap_or_default().to_string_lossy();
    let stages: Vec<&Component> = document
        .components
        .iter()
        .filter(|component| component.kind.ends_with("_stage"))
        .collect();
    if stages.len() > MOST_STAGES {
        return Err(problem(
            &stages[MOST_STAGES].place(),
            format!("stands behind {MOST_STAGES} stages, the most that are read"),
            "check that this is the file you mean",
        ));
    }
    let mut used = Vec::new();
    let stages = stages
        .into_iter()
        .map(|component| stage_of(&document, component, &source, &mut used))
        .collect();
    let mut left_out = document.kinds_beside(&used);
    left_out.extend(document.others.iter().map(|other| (cut(other, LONGEST), 1)));
    Ok(RexsFile {
        version: cut(&document.version, LONGEST),
        application: cut(&document.application, LONGEST),
        stages,
        left_out,
        sources: place.sources(),
        document,
        content: match zipped {
            true => Content::Zipped,
            false => content,
        },
    })
}

/// The stage that `component` is; the components it was read from are added to `used`.
fn stage_of(
    document: &Document,
    component: &Component,
    source: &str,
    used: &mut Vec<i32>,
) -> RexsStage {
    let pair = match Stage::read(document, component) {
        Ok(stage) => {
            let parts: Vec<&Component> = stage.parts().map(|part| part.component()).collect();
            pair_of(&stage, source).inspect(|_| used.extend(parts.iter().map(|part| part.id)))
        }
        Err(Fault::LeftOut(why)) => Err(why),
        // What is wrong with one stage is nothing to the others.
        Err(Fault::Wrong(problem)) => Err(problem.to_string()),
    };
    RexsStage {
        id: component.id,
        kind: cut(&component.kind, LONGEST),
        name: component.name.clone(),
        gears: stage::external_gears(document, component).ok(),
        pair,
    }
}

/// The pair file of a stage, if gearlash takes it.
fn pair_of(stage: &Stage, source: &str) -> Result<RexsPair, String> {
    let pair_file = stage.pair_file(&plain(source));
    let mut remarks = stage.remarks();
    let read = crate::read_text(Path::new("pair.toml"), &pair_file).map_err(|error| {
        let problems = error.problems.iter().map(ToString::to_string);
        format!("makes no pair: {}", problems.collect::<Vec<_>>().join("; "))
    })?;
    remarks.extend(read.warnings);
    remarks.extend(read.remarks);
    let unused = stage.parts().filter_map(|part| {
        let ids: Vec<String> = part.unread().iter().map(|id| cut(id, LONGEST)).collect();
        (!ids.is_empty()).then(|| (part.component().place(), ids))
    });
    Ok(RexsPair {
        summary: stage.summary(),
        remarks,
        unused: unused.collect(),
        pair_file,
        spec: read.spec,
    })
}

impl RexsStage {
    /// Whether `pair` is a pair file of this stage, whose backlash may be written into it: teeth, module, pressure angle, profile shift,
    /// allowances of the thickness and centre distance are those of [`RexsPair::pair_file`], or lie within its tolerances.
    ///
    /// # Errors
    /// What tells them apart with both values, to be set behind "stage 3"; the reason why the stage is left out.
    pub fn is_of(&self, pair: &PairSpec) -> Result<(), String> {
        match (&self.pair, self.gears) {
            (Ok(own), _) => same::same(&own.spec, pair),
            (Err(why), None) => Err(format!("has no two external cylindrical gears: {why}")),
            (Err(why), Some(_)) => Err(format!("is left out: {why}")),
        }
    }
}

impl RexsFile {
    /// The stage of that id.
    pub fn stage(&self, id: i32) -> Option<&RexsStage> {
        self.stages.iter().find(|stage| stage.id == id)
    }

    /// The file's text with the backlash of a stage: every byte outside the four attributes as it was. `None` of a zipped file and
    /// where there is no such stage.
    pub fn with_backlash(&self, stage: i32, backlash: &RexsBacklash) -> Option<String> {
        let component = self.document.components.iter().find(|c| c.id == stage)?;
        let values = [
            ("minimum_normal_backlash", backlash.normal[0]),
            ("maximum_normal_backlash", backlash.normal[1]),
            ("minimum_transverse_backlash", backlash.transverse[0]),
            ("maximum_transverse_backlash", backlash.transverse[1]),
        ];
        let mut edits: Vec<(Range<usize>, String)> = Vec::new();
        let text = match &self.content {
            Content::Xml(text) => {
                xml::edited(text, component, &values, &mut edits);
                text
            }
            Content::Json(text) => {
                json::edited(text, component, &values, &mut edits);
                text
            }
            Content::Zipped => return None,
        };
        edits.sort_by_key(|(range, _)| (range.start, range.end));
        let mut text = text.clone();
        for (range, new) in edits.into_iter().rev() {
            text.replace_range(range, &new);
        }
        Some(text)
    }
}
