//! Import of REXS, the exchange format for gearboxes.
//!
//! A stage of external gears, spur or helical, becomes a pair file. Every other part is listed and ignored. Internal gears and
//! planetary stages are never read as external pairs. Versions 1.0 to 2.0 are read, as XML, as JSON, and zipped (`.rexsz`). The
//! facts of the format come from the public Java API of its owner (<https://github.com/fva-net/rexs-api-java>, Apache-2.0).

mod attributes;
mod document;
mod gear;
mod json;
mod stage;
mod thickness;
mod xml;

use document::{Component, Document, shown};
use gearlash_text::characters::{cut, plain};
use gearlash_text::node::LONGEST;
use gearlash_text::{InputError, Problem, Reading, Sources, display_path, source};
use stage::Stage;
use std::io::{Cursor, Read};
use std::path::Path;
use zip::ZipArchive;

/// Stages of a file. The largest gearboxes have a dozen.
const MAX_STAGES: usize = 200;

/// A REXS file and the results of its stages.
#[derive(Debug)]
pub struct RexsFile {
    /// Version of the format: "1.4".
    pub version: String,
    /// The program that wrote it.
    pub application: String,
    /// In the order of the file.
    pub stages: Vec<RexsStage>,
    /// Parts that were not read: kinds of components and how many, other parts of the file.
    pub left_out: Vec<(String, usize)>,
    /// The file itself.
    pub sources: Sources,
}

/// A stage.
#[derive(Debug)]
pub struct RexsStage {
    /// Id of its component.
    pub id: i32,
    /// The component's type, such as `cylindrical_stage`.
    pub kind: String,
    /// May be empty.
    pub name: String,
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
}

/// Reads the REXS file at `path`; `-` is standard input.
///
/// # Errors
/// [`InputError`] with the place of a fault of the whole file: line and column, or component and attribute. A fault of one stage
/// is the reason of that stage.
pub fn read(path: &Path) -> Result<RexsFile, InputError> {
    let (name, sources) = (display_path(path), Reading::of(path).sources());
    let file = gearlash_text::bytes(path).and_then(|bytes| of_bytes(name, sources, bytes));
    file.map_err(|problem| InputError::of(name, vec![problem]))
}

/// Reads `bytes`; messages call the file `path`.
fn of_bytes(path: &Path, sources: Sources, bytes: Vec<u8>) -> Result<RexsFile, Problem> {
    let bytes = if bytes.starts_with(b"PK") {
        unpacked(&bytes)?
    } else {
        bytes
    };
    let text = source::text(bytes)?;
    let document = match text.trim_start().chars().next() {
        Some('<') => xml::read(&text)?,
        Some('{') => json::read(&text)?,
        _ => {
            let help = "name a REXS file: .rexs, .rexsj or .rexsz";
            return Err(Problem::at("line 1", "neither XML nor JSON", help));
        }
    };
    document.check()?;
    let source = path.file_name().unwrap_or_default().to_string_lossy();
    let components = document.components.iter();
    let stages = components.filter(|component| component.kind.ends_with("_stage"));
    if let Some(stage) = stages.clone().nth(MAX_STAGES) {
        let reason = format!("stands behind {MAX_STAGES} stages, the most that are read");
        return Err(Problem::at(stage.place(), reason, CHECK_FILE));
    }
    let mut used = Vec::new();
    let stages = stages.map(|component| stage_of(&document, component, &source, &mut used));
    let stages = stages.collect();
    let mut left_out = document.kinds_beside(&used);
    left_out.extend(document.others.iter().map(|other| (cut(other, LONGEST), 1)));
    Ok(RexsFile {
        version: cut(&document.version, LONGEST),
        application: cut(&document.application, LONGEST),
        stages,
        left_out,
        sources,
    })
}

/// The stage of `component`. The components it was read from are added to `used`.
fn stage_of(
    document: &Document,
    component: &Component,
    source: &str,
    used: &mut Vec<i32>,
) -> RexsStage {
    // A fault of one stage does not concern the others.
    let pair = Stage::read(document, component).and_then(|stage| {
        let pair = pair_of(&stage, source)?;
        used.extend(stage.parts().map(|part| part.component().id));
        Ok(pair)
    });
    RexsStage {
        id: component.id,
        kind: cut(&component.kind, LONGEST),
        name: component.name.clone(),
        pair,
    }
}

/// The pair file of a stage, if gearlash supports it.
fn pair_of(stage: &Stage, source: &str) -> Result<RexsPair, String> {
    let pair_file = stage.pair_file(&plain(source));
    let mut remarks = stage.remarks();
    let read = gearlash_input::read_text(Path::new("pair.toml"), &pair_file).map_err(|error| {
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
    })
}

impl RexsFile {
    /// The stage with an id.
    pub fn stage(&self, id: i32) -> Option<&RexsStage> {
        self.stages.iter().find(|stage| stage.id == id)
    }
}

/// Largest unpacked size: 16 MiB, as for a file that is not zipped.
const MAX_UNPACKED: u64 = 16 << 20;
const ARCHIVE: &str = "the archive";
const CHECK_FILE: &str = "check that this is the file you mean";

/// The one REXS file in the archive.
/// Errors: no archive, none or several such files in it, too large, damaged.
fn unpacked(bytes: &[u8]) -> Result<Vec<u8>, Problem> {
    let damaged = |error: &dyn std::error::Error| {
        let reason = format!("not a whole zip archive: {}", shown(&error.to_string()));
        let help = "pack it again, or unpack it and name the .rexs file";
        Problem::at(ARCHIVE, reason, help)
    };
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| damaged(&error))?;
    let mut found = Vec::new();
    for index in 0..archive.len() {
        let part = archive.by_index(index).map_err(|error| damaged(&error))?;
        let name = part.name().map_err(|error| damaged(&error))?;
        let name = name.to_ascii_lowercase();
        // Copies of names by macOS's Finder are not files.
        let is_rexs = name.ends_with(".rexs") || name.ends_with(".rexsj");
        if is_rexs && !name.starts_with("__macosx/") {
            found.push(index);
        }
    }
    let [index] = found[..] else {
        let reason = format!("holds {} files .rexs or .rexsj, expected one", found.len());
        return Err(Problem::at(ARCHIVE, reason, "unpack it and name the file"));
    };
    let part = archive.by_index(index).map_err(|error| damaged(&error))?;
    let mut content = Vec::new();
    part.take(MAX_UNPACKED + 1)
        .read_to_end(&mut content)
        .map_err(|error| damaged(&error))?;
    if content.len() as u64 > MAX_UNPACKED {
        let reason = "its file has more than 16 MiB";
        return Err(Problem::at(ARCHIVE, reason, CHECK_FILE));
    }
    Ok(content)
}
