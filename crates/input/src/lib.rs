//! From a pair file to a [`Study`](gearlash::analysis::study::Study): every key of the interface, every problem at once.
//!
//! A file becomes a tree of values (`gearlash-text`). The schema of the spec checks it (`check`), then serde reads the spec. The
//! tables it names are read (`gearlash-tables`). Metrology and geometry take the result: `faults` finds the keys of their errors,
//! `findings` puts their findings into words. It computes no result: `pair_slips` and `short_for_span` only estimate whether
//! numbers are likely.
//!
//! ```no_run
//! use std::path::Path;
//!
//! let pair = gearlash_input::read(Path::new("fixtures/karba_44x44.toml"))?;
//! for warning in &pair.warnings {
//!     eprintln!("{warning}");
//! }
//! println!("{} poses", pair.study.pose_count());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assembly;
mod check;
mod common_face;
mod faults;
mod files;
mod findings;
mod gauged_file;
mod gear;
mod helix;
pub mod import;
mod known_gear;
mod lead;
pub mod matching;
mod measured;
pub mod outlines;
mod pair_slips;
mod pair_tables;
mod pitch;
mod profile;
mod runout;
mod shafts;
pub mod spec;
mod statements;
mod sweep;
mod temperature;
mod thickness;
pub mod tolerance;
mod tolerance_table;
mod traces;
mod unit_slips;
mod unknown_key;

use gearlash_text::characters::shell_word;
use gearlash_text::{
    Files, InputError, Problem, Reading, Table, bytes, display_path, has_extension, source,
    without_mark,
};
use pair_tables::PairTables;
use std::path::Path;
use std::rc::Rc;

pub use assembly::with_distance;
pub use files::{GearEntry, GearsFile, PairFile, distance_refused};
pub use gauged_file::{NoGearFile, gauged_file};
pub use gearlash_tables::EXTENSIONS as TABLE_EXTENSIONS;
pub use helix::short_for_span;
pub use pair_slips::tolerance_slip;
pub use pair_tables::{MAX_POSES, POSE_BYTES_CSV, POSE_BYTES_JSON};
pub use spec::{explained, gear_schema, pair_schema, schemas};

/// Whether `file` is a gear file: it has `[gear]`.
fn is_gear_file(file: &Table) -> bool {
    file.has("gear")
}

/// The stem of a checked `file`, and its title without a problem; by default the stem.
fn names(file: &Table) -> (String, Option<String>) {
    let stem = file.reading().name().file_stem().unwrap_or_default();
    let stem = stem.to_string_lossy().into_owned();
    let title = file.read::<String>("title");
    let title = title.map(|title| title.unwrap_or_else(|| stem.clone()));
    (stem, title)
}

/// Reads the pair file at `path`: TOML, or JSON with the same keys. `-` is standard input, relative to the working folder.
///
/// # Errors
/// [`InputError`] with all problems of the file, each with key, value, what is allowed and what to do.
pub fn read(path: &Path) -> Result<PairFile, InputError> {
    with_file(path, pair)
}

/// Reads the pair file at `path`, whose gears must be given by their data.
///
/// # Errors
/// As [`read`]; a gear given by an outline.
pub fn read_by_data(path: &Path) -> Result<PairFile, InputError> {
    with_file(path, pair_by_data)
}

/// Reads the pair file `text`, TOML or JSON, called `name` in messages; the files that it names are looked for in the working folder.
///
/// # Errors
/// As [`read`].
pub fn read_text(name: &Path, text: &str) -> Result<PairFile, InputError> {
    of_text(name, text, pair)
}

/// Reads the pair file `main` of `files`; the files that it names are among them.
///
/// # Errors
/// As [`read`].
pub fn read_files(files: Rc<Files>, main: &str) -> Result<PairFile, InputError> {
    let name = Path::new(main);
    let text = files.bytes(name).and_then(source::text);
    with_text(name, Reading::of_files(files), text, pair)
}

/// Reads a pair from two drawings.
///
/// # Errors
/// As [`read`]; it names options of the command line, not keys.
pub fn read_drawings(drawings: &outlines::Drawings) -> Result<PairFile, InputError> {
    let (drawings, warnings) = drawings.with_units_needed(None);
    let name = drawings.stems().join("_");
    let read = of_text(Path::new(&name), &drawings.pair_file(), pair);
    let mut file = read.map_err(outlines::by_flags)?;
    file.warnings.splice(..0, warnings);
    Ok(file)
}

/// Reads two drawings of one gear and compares them, the second with the first.
///
/// # Errors
/// As [`read_drawings`].
pub fn compare_drawings(
    paths: [&Path; 2],
    options: [outlines::OutlineOptions; 2],
) -> Result<outlines::ComparedOutlines, InputError> {
    let needed = [0, 1].map(|k| options[k].with_unit_needed(paths[k], None));
    let text = outlines::compared_tables(paths, needed.each_ref().map(|(options, _)| options));
    let compared = of_text(paths[1], &text, |file| outlines::compared(file, paths));
    Ok(outlines::ComparedOutlines {
        warnings: needed.map(|(_, warning)| warning),
        ..compared.map_err(outlines::by_flags)?
    })
}

/// Reads the gears of the file at `path`: a gear file (`title` and one `[gear]` with the keys of `[wheel]`), or a pair file.
///
/// # Errors
/// As [`read`].
pub fn read_gears(path: &Path) -> Result<GearsFile, InputError> {
    with_file(path, gears)
}

/// Reads the gears of the file at `path`, which must be given by their data.
///
/// # Errors
/// As [`read_by_data`].
pub fn read_gears_by_data(path: &Path) -> Result<GearsFile, InputError> {
    with_file(path, gears_by_data)
}

/// Reads the gears of the gear file or pair file `text`, which must be given by their data.
///
/// # Errors
/// As [`read_by_data`].
pub fn read_gears_text(name: &Path, text: &str) -> Result<GearsFile, InputError> {
    of_text(name, text, gears_by_data)
}

/// Reads the gear of the drawing at `path`.
///
/// # Errors
/// As [`read_drawings`].
pub fn read_drawing(
    path: &Path,
    options: &outlines::OutlineOptions,
) -> Result<GearsFile, InputError> {
    let (options, warning) = options.with_unit_needed(path, None);
    let text = outlines::outline_table("gear", path, &options);
    let mut file = of_text(path, &text, gears).map_err(outlines::by_flags)?;
    file.warnings.splice(..0, warning);
    Ok(file)
}

fn pair(file: &Table) -> Option<PairFile> {
    PairTables::read(file).study()
}

/// The pair, which must be given by its data.
fn pair_by_data(file: &Table) -> Option<PairFile> {
    outlines::refuse(file)?;
    pair(file)
}

fn gears(file: &Table) -> Option<GearsFile> {
    if is_gear_file(file) {
        files::gear_file(file)
    } else {
        pair(file).map(GearsFile::from)
    }
}

/// The gears, which must all be given by their data.
fn gears_by_data(file: &Table) -> Option<GearsFile> {
    outlines::refuse(file)?;
    gears(file)
}

/// The result of `understand` for the file at `path`.
fn with_file<T>(
    path: &Path,
    understand: impl FnOnce(&Table) -> Option<T>,
) -> Result<T, InputError> {
    let bytes = bytes(path).and_then(|bytes| refuse_other_kinds(path, bytes));
    let text = bytes.and_then(source::text);
    with_text(display_path(path), Reading::of(path), text, understand)
}

/// Whether the file at `path` is to be read as a gearbox model (REXS), by its name.
pub fn is_rexs(path: &Path) -> bool {
    has_extension(path, &["rexs", "rexsj", "rexsz"])
}

/// The `bytes` of the file at `path`, which should be a pair file or gear file.
/// Errors: the file is a drawing, a table or a gearbox model, by its name or as XML.
fn refuse_other_kinds(path: &Path, bytes: Vec<u8>) -> Result<Vec<u8>, Problem> {
    let text = without_mark(&bytes);
    let is_xml = text.trim_ascii_start().starts_with(b"<");
    let holds = |tag: &[u8]| is_xml && text.windows(tag.len()).any(|part| part == tag);
    let is_table = has_extension(path, &TABLE_EXTENSIONS) || has_extension(path, &["ods"]);
    let is_protocol = has_extension(path, &["txt"]) && !names_gear(text);
    let file = shell_word(path);
    let (reason, help) = if is_rexs(path) || holds(b"<model") {
        let help = format!(
            "gearlash import {file} --stage ID -o pair.toml writes the pair file of a stage"
        );
        ("is a gearbox model", help)
    } else if has_extension(path, &["dxf", "dwg"]) || holds(b"<svg") {
        let help = "gearlash init --outline writes a pair file that names drawings; check, compare and gauge also take drawings";
        ("is a drawing", help.to_owned())
    } else if is_table || is_protocol {
        let help = format!(
            "gearlash import {file} shows its numbers and the lines of a pair file that name it"
        );
        ("is a table or protocol", help)
    } else {
        return Ok(bytes);
    };
    Err(Problem::of_file(reason, help))
}

/// Whether a text is JSON, or names a table of a pair file or gear file in TOML.
fn names_gear(text: &[u8]) -> bool {
    let text = String::from_utf8_lossy(text);
    let names = |line: &str| {
        let line = line.trim_start().trim_start_matches('[').trim_start();
        let rest = ["wheel", "pinion", "gear"]
            .iter()
            .find_map(|name| line.strip_prefix(name));
        rest.is_some_and(|rest| rest.trim_start().starts_with(['.', '=', ']']))
    };
    text.trim_start().starts_with('{') || text.lines().any(names)
}

/// The result of `understand` for a `text`.
fn of_text<T>(
    name: &Path,
    text: &str,
    understand: impl FnOnce(&Table) -> Option<T>,
) -> Result<T, InputError> {
    let reading = Reading::default();
    with_text(name, reading, Ok(text.to_owned()), understand)
}

fn with_text<T>(
    path: &Path,
    reading: Reading,
    text: Result<String, Problem>,
    understand: impl FnOnce(&Table) -> Option<T>,
) -> Result<T, InputError> {
    let reading = Rc::new(reading.called(path));
    let text = reading.keep(text);
    let entries = text
        .as_ref()
        .and_then(|text| source::parse(path, text, &reading))
        .map(|mut entries| {
            reading.to_mm(&mut entries);
            entries
        });
    let understood = entries.and_then(|entries| understand(&Table::new("", &reading, &entries)));
    match understood {
        Some(understood) if reading.is_good() => Ok(understood),
        _ => Err(InputError {
            text: text
                .filter(|text| !source::is_json(path, text))
                .unwrap_or_default(),
            ..InputError::of(path, reading.take_problems())
        }),
    }
}
