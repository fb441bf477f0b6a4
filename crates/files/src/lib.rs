//! From a pair file to a [`Study`](gearlash::analysis::study::Study): every key of the interface, every problem at once.
//!
//! A file becomes a tree of values (`source`, `node`). The schema of the spec checks it (`check`), then serde reads the spec.
//! The tables it names are read (`sheet`). The metrology and the geometry take the result: `faults` traces their errors back to keys,
//! `findings` puts their findings into words. Nothing here computes what a gear is.
//!
//! ```no_run
//! use std::path::Path;
//!
//! let pair = gearlash_files::read(Path::new("fixtures/karba_44x44.toml"))?;
//! for warning in &pair.warnings {
//!     eprintln!("{warning}");
//! }
//! println!("{} poses", pair.study.pose_count());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assembly;
pub mod characters;
mod check;
mod common_face;
mod data_file;
pub mod drawing;
mod error;
mod faults;
mod findings;
mod gauged_file;
mod gear;
mod gear_file;
mod gearbox_model;
mod helix;
pub mod import;
mod limits;
mod location;
pub mod matching;
mod measured;
mod nearest;
mod node;
pub mod numbers;
mod outline_file;
pub mod outlines;
mod pair_file;
mod pair_slips;
mod pitch;
mod place;
mod problems;
mod profile;
mod read;
mod require;
pub mod rexs;
mod runout;
mod said_once;
mod sheet;
mod source;
mod sources;
pub mod spec;
mod statements;
mod sweep;
mod synonyms;
mod table;
mod temperature;
mod thickness;
pub mod tolerance;
mod tolerance_table;
mod uncertainty;
mod unmodelled;
mod view;

use node::Node;
use pair_file::PairTables;
use place::Place;
use problems::Problems;
use std::path::Path;

/// The path that stands for standard input.
const STANDARD_INPUT: &str = "-";

/// What the file at `path` is called: `stdin` for `-`, which is standard input.
pub fn named(path: &Path) -> &Path {
    match path == Path::new(STANDARD_INPUT) {
        true => Path::new("stdin"),
        false => path,
    }
}

pub use error::{InputError, Problem};
pub use gauged_file::{NoGearFile, gauged_file};
pub use helix::short_for_span;
pub use limits::{MOST_POSES, POSE_BYTES_CSV, POSE_BYTES_JSON};
pub use outline_file::{OutlineFile, OutlineFormat};
pub use outlines::OutlinePairFile;
pub use pair_slips::in_tolerance as tolerance_slip;
pub use read::{GearEntry, GearsFile, PairFile, distance_refused};
pub use sources::Sources;
pub use spec::{explained, gear_schema, pair_schema};
pub use view::{AnyPair, AnyPairSpec, PairView};

/// Reads the pair file at `path`: TOML, or JSON with the same keys. `-` is standard input, relative to the working folder.
///
/// # Errors
/// [`InputError`] with all problems of the file, each with key, value, what is allowed and what to do.
pub fn read(path: &Path) -> Result<PairFile, InputError> {
    with_entries(path, pair_by_data)
}

/// Reads the pair file `text`, TOML or JSON, called `name` in messages; the files that it names are looked for in the working folder.
///
/// # Errors
/// As [`read`].
pub fn read_text(name: &Path, text: &str) -> Result<PairFile, InputError> {
    let place = Place::of_working_folder();
    with_text(name, &place, Ok(text.to_owned()), pair_by_data)
}

/// Reads the gears of the gear file or pair file `text`, as [`read_text`] does.
///
/// # Errors
/// As [`read`].
pub fn read_gears_text(name: &Path, text: &str) -> Result<GearsFile, InputError> {
    let place = Place::of_working_folder();
    with_text(name, &place, Ok(text.to_owned()), no_outlines)
}

/// Reads the pair file at `path`, be its gears given by data or by outlines. `-` is standard input.
///
/// # Errors
/// As [`read`].
pub fn read_any(path: &Path) -> Result<AnyPair, InputError> {
    with_entries(path, |path, place, entries, problems| {
        if outlines::has_outline(entries) {
            let pair = outlines::read(path, place, entries, problems);
            return pair.map(|pair| AnyPair::Outlines(Box::new(pair)));
        }
        let pair = PairTables::read(path, place, entries, problems).study(problems);
        pair.map(|pair| AnyPair::Data(Box::new(pair)))
    })
}

/// Reads the pair that two drawings make.
///
/// # Errors
/// As [`read`]; keys are those that a pair file would have.
pub fn read_drawings(drawings: &outlines::Drawings) -> Result<OutlinePairFile, InputError> {
    let text = drawings.pair_file();
    let stem = |path: &Path| path.file_stem().unwrap_or_default().to_os_string();
    let mut name = stem(drawings.wheel);
    name.push("_");
    name.push(stem(drawings.pinion));
    let (path, place) = (Path::new(&name), Place::of_working_folder());
    with_text(path, &place, Ok(text), outlines::read).map_err(without_text)
}

/// Reads two drawings of one gear and compares them.
///
/// # Errors
/// As [`read`]; keys are those that a pair file would have, `a` and `b` in place of wheel and pinion.
pub fn compare_drawings(
    drawings: &outlines::TwoDrawings,
) -> Result<outlines::ComparedOutlines, InputError> {
    let place = Place::of_working_folder();
    let tables = Ok(drawings.tables());
    let compared = with_text(
        drawings.paths[1],
        &place,
        tables,
        |_, place, entries, problems| drawings.compared(place, entries, problems),
    );
    compared.map_err(without_text)
}

/// Reads the gears of the file at `path`: a gear file (`title` and one `[gear]` with the keys of `[wheel]`), or a pair file.
///
/// # Errors
/// As [`read`].
pub fn read_gears(path: &Path) -> Result<GearsFile, InputError> {
    with_entries(path, no_outlines)
}

/// The gears of a file of either kind.
#[derive(Debug)]
pub enum AnyGears {
    /// All by their data.
    Data(Box<GearsFile>),
    /// One at least by its outline.
    Outlines(Box<outlines::OutlineGearsFile>),
}

/// Reads the gears of the file at `path`, a gear file or a pair file, be they given by data or by outlines.
///
/// # Errors
/// As [`read`].
pub fn read_any_gears(path: &Path) -> Result<AnyGears, InputError> {
    with_entries(path, |path, place, entries, problems| {
        if !outlines::has_outline(entries) {
            let gears = gears_by_data(path, place, entries, problems);
            return gears.map(|gears| AnyGears::Data(Box::new(gears)));
        }
        let gears = match gear_file::is_one(entries) {
            true => outlines::read_gear(path, place, entries, problems),
            false => outlines::read(path, place, entries, problems).map(From::from),
        };
        gears.map(|gears| AnyGears::Outlines(Box::new(gears)))
    })
}

/// Reads the gear that the drawing at `path` is, with its unit (where it states none) and its centre as a pair file names them.
///
/// # Errors
/// As [`read`]; keys are those that a gear file would have.
pub fn read_drawing(
    path: &Path,
    units: Option<&str>,
    center: Option<&str>,
) -> Result<outlines::OutlineGearsFile, InputError> {
    let text = outlines::of_drawing(path, units, center);
    let place = Place::of_working_folder();
    with_text(path, &place, Ok(text), outlines::read_gear).map_err(without_text)
}

/// The same error of a text that nobody wrote: a place in it would point to nothing.
fn without_text(error: InputError) -> InputError {
    InputError {
        text: String::new(),
        ..error
    }
}

/// The pair, which must be by its data.
fn pair_by_data(
    path: &Path,
    place: &Place,
    entries: &[(String, Node)],
    problems: &mut Problems,
) -> Option<PairFile> {
    if outlines::has_outline(entries) {
        outlines::refused(path, place, entries, problems);
        return None;
    }
    PairTables::read(path, place, entries, problems).study(problems)
}

/// The gears, which must all be by their data.
fn no_outlines(
    path: &Path,
    place: &Place,
    entries: &[(String, Node)],
    problems: &mut Problems,
) -> Option<GearsFile> {
    if outlines::has_outline(entries) {
        outlines::refused(path, place, entries, problems);
        return None;
    }
    gears_by_data(path, place, entries, problems)
}

fn gears_by_data(
    path: &Path,
    place: &Place,
    entries: &[(String, Node)],
    problems: &mut Problems,
) -> Option<GearsFile> {
    if gear_file::is_one(entries) {
        return gear_file::read(path, place, entries, problems);
    }
    let pair = PairTables::read(path, place, entries, problems).study(problems);
    pair.map(GearsFile::from)
}

/// What `understand` makes of the entries of the file at `path`, by the name it has in messages, when nothing was wrong.
fn with_entries<T>(
    path: &Path,
    understand: impl FnOnce(&Path, &Place, &[(String, Node)], &mut Problems) -> Option<T>,
) -> Result<T, InputError> {
    let (path, place, bytes) = located(path);
    let bytes = bytes.and_then(|bytes| gearbox_model::no_model(path, bytes));
    with_text(path, &place, bytes.and_then(source::text), understand)
}

/// What `understand` makes of the bytes of the file at `path`, which is no pair file, when nothing was wrong.
fn with_bytes<T>(
    path: &Path,
    understand: impl FnOnce(&Path, &Place, Result<Vec<u8>, Problem>, &mut Problems) -> Option<T>,
) -> Result<T, InputError> {
    let (path, place, bytes) = located(path);
    let mut problems = Problems::new();
    understand(path, &place, bytes, &mut problems).ok_or_else(|| InputError {
        file: path.to_owned(),
        problems: problems.into_list(),
        text: String::new(),
    })
}

/// The name that the file at `path` has in messages, its place and its bytes.
fn located(path: &Path) -> (&Path, Place, Result<Vec<u8>, Problem>) {
    match path == Path::new(STANDARD_INPUT) {
        true => (
            named(path),
            Place::of_standard_input(),
            source::standard_input(),
        ),
        false => (path, Place::of(path), source::bytes(path)),
    }
}

/// The same of a `text`.
fn with_text<T>(
    path: &Path,
    place: &Place,
    text: Result<String, Problem>,
    understand: impl FnOnce(&Path, &Place, &[(String, Node)], &mut Problems) -> Option<T>,
) -> Result<T, InputError> {
    let mut problems = Problems::new();
    let text = problems.keep(text);
    let entries = text
        .as_ref()
        .and_then(|text| source::parse(path, text, &mut problems));
    let understood = entries.and_then(|entries| understand(path, place, &entries, &mut problems));
    match understood {
        Some(understood) if problems.is_empty() => Ok(understood),
        _ => Err(InputError {
            file: path.to_owned(),
            problems: problems.into_list(),
            text: text
                .filter(|text| !source::is_json(path, text))
                .unwrap_or_default(),
        }),
    }
}
