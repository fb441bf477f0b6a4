//! Populations and matchings: rows of any range, the statistics of rows, and the assignment of gears.

use crate::call::work;
use crate::error::Outcome as Done;
use gearlash::error::Error;
use gearlash::matching::{Fit, PairFit};
use gearlash::population::{ContributionsError, Outcome, OutcomeKind, Row};
use gearlash_input::matching::{MatchFile, MatchResult, read_match};
use gearlash_input::tolerance::{
    BLOCK, MAX_ASSEMBLIES, RowsHead, RowsReader, RowsTally, ToleranceFile, ToleranceRun,
    read_tolerance, row_line, tenths_to_um,
};
use gearlash_results::{matching, population};
use gearlash_text::InputError;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::{Path, PathBuf};

/// The greatest distance of a target backlash from 0, µm, as for the command.
const MOST_TARGET_UM: f64 = 1e5;

fn read(py: Python<'_>, path: &Path) -> Done<ToleranceFile> {
    Ok(py.detach(|| read_tolerance(path))?)
}

fn run<'a>(
    py: Python<'_>,
    file: &'a ToleranceFile,
    path: &'a Path,
    assemblies: Option<u64>,
    seed: Option<u64>,
) -> Done<ToleranceRun<'a>> {
    if let Some(count) = assemblies.filter(|count| !(1..=MAX_ASSEMBLIES).contains(count)) {
        return Err(format!("{count} assemblies: allowed are 1 … {MAX_ASSEMBLIES}").into());
    }
    let run = py.detach(|| ToleranceRun::new(file, path, assemblies, seed));
    Ok(run?)
}

fn warnings(file: &ToleranceFile) -> Vec<String> {
    [&file.pair.warnings[..], &file.warnings].concat()
}

/// Number of assemblies in the pair file at `path`.
#[pyfunction]
pub fn tolerance_assemblies(py: Python<'_>, path: PathBuf) -> Done<u64> {
    Ok(read(py, &path)?.tolerance.assemblies.into())
}

/// The text of a file with the rows of `count` assemblies from `first` on, and the warnings of the files. Default count: up to
/// the last of the pair file.
#[pyfunction]
#[pyo3(signature = (path, first, count, seed, threads=None))]
pub fn tolerance_rows(
    py: Python<'_>,
    path: PathBuf,
    first: u64,
    count: Option<u64>,
    seed: Option<u64>,
    threads: Option<usize>,
) -> Done<(String, Vec<String>)> {
    let file = read(py, &path)?;
    let all = u64::from(file.tolerance.assemblies);
    let count = count.unwrap_or((all + 1).saturating_sub(first));
    let end = first.checked_add(count);
    let end = end.filter(|end| first > 0 && count > 0 && *end <= MAX_ASSEMBLIES + 1);
    let Some(end) = end else {
        let reason = format!(
            "{count} assemblies from {first} on: allowed are one at least, from 1 up to {MAX_ASSEMBLIES}"
        );
        return Err(reason.into());
    };
    let run = run(py, &file, &path, Some(all.max(end - 1)), seed)?;
    let rows = work(py, threads, |tick| run.rows(first..end, tick))?;
    let mut tally = RowsTally::new(&run);
    let counted = rows.iter().try_for_each(|row| tally.add(row));
    counted?;
    if let Some(reason) = run.too_many_impossible(tally.tally()) {
        return Err(reason.into());
    }
    let mut text = RowsHead::of(&run, first, count).lines();
    text.extend(rows.iter().map(row_line));
    Ok((text, warnings(&file)))
}

/// Seed, first assembly and columns of the text of a file of rows. A missing length is NaN.
#[pyfunction]
pub fn rows_columns<'py>(py: Python<'py>, text: &str) -> Done<(u64, u64, Bound<'py, PyDict>)> {
    let (head, rows) = RowsReader::begin("rows", text.as_bytes())?;
    let rows = rows.collect::<Result<Vec<Row>, InputError>>()?;
    let um = |length: fn(&Row) -> Option<i64>| {
        let each = rows.iter().map(length);
        let each = each.map(|tenths| tenths.map_or(f64::NAN, tenths_to_um));
        each.collect::<Vec<f64>>().into_pyarray(py)
    };
    let is = |flag: fn(&Row) -> bool| {
        let each = rows.iter().map(flag);
        each.collect::<Vec<bool>>().into_pyarray(py)
    };
    let numbers: Vec<u64> = rows.iter().map(|row| row.number).collect();
    let codes: Vec<u8> = rows.iter().map(|row| row.kind as u8).collect();
    let columns = PyDict::new(py);
    columns.set_item("assembly", numbers.into_pyarray(py))?;
    columns.set_item("outcome", codes.into_pyarray(py))?;
    columns.set_item("least_um", um(|row| row.least))?;
    columns.set_item("greatest_um", um(|row| row.greatest))?;
    columns.set_item("proven", is(|row| row.is_proven))?;
    columns.set_item("below", is(|row| row.is_below))?;
    columns.set_item("above", is(|row| row.is_above))?;
    columns.set_item("margin_um", um(|row| row.margin))?;
    Ok((head.seed, head.first, columns))
}

/// The result of a run as the JSON of `gearlash tolerance`, and the warnings of the files. It uses the given texts of rows, or
/// draws rows itself.
#[pyfunction]
#[pyo3(signature = (path, assemblies, seed, rows=None, threads=None))]
pub fn tolerance_result(
    py: Python<'_>,
    path: PathBuf,
    assemblies: Option<u64>,
    seed: Option<u64>,
    rows: Option<Vec<String>>,
    threads: Option<usize>,
) -> Done<(String, Vec<String>)> {
    let file = read(py, &path)?;
    let run = run(py, &file, &path, assemblies, seed)?;
    let mut tally = RowsTally::new(&run);
    let tally = if let Some(rows) = rows {
        for (index, text) in rows.iter().enumerate() {
            tally.add_text(&format!("rows[{index}]"), text.as_bytes())?;
        }
        tally.finish()?
    } else {
        let all = run.assemblies();
        let drawn = work(py, threads, |tick| {
            for first in (1..=all).step_by(BLOCK as usize) {
                let rows = run.rows(first..(first + BLOCK).min(all + 1), tick)?;
                let counted = rows.iter().try_for_each(|row| tally.add(row));
                if let Err(reason) = counted {
                    return Ok(Err(reason.to_string()));
                }
                if run.too_many_impossible(tally.tally()).is_some() {
                    break;
                }
            }
            Ok(Ok(tally.into_tally()))
        })?;
        drawn?
    };
    if let Some(reason) = run.too_many_impossible(&tally) {
        return Err(reason.into());
    }
    let result = work(py, threads, |tick| match run.result(tally, tick) {
        Ok(result) => Ok(Ok(result)),
        Err(ContributionsError::Error(reason)) => Err(reason),
        Err(ContributionsError::Overflow(reason)) => Ok(Err(reason.to_string())),
    })?;
    Ok((population::json(&result?), warnings(&file)))
}

/// A wheel with a pinion: pinion tooth of the best phase, outcome, least and greatest backlash, mm, whether both are proven,
/// whether it meets the requirement, and the number of phases that do.
type Cell = (u32, u8, Option<f64>, Option<f64>, bool, bool, u32);

fn cell(found: &PairFit) -> Cell {
    let (best, outcome) = (&found.best, &found.best.outcome);
    (
        best.pinion_tooth,
        outcome.kind as u8,
        outcome.least,
        outcome.greatest,
        outcome.is_proven,
        best.meets,
        found.phases_that_meet,
    )
}

fn pair_fit(cell: &Cell, file: &MatchFile) -> Option<PairFit> {
    let &(pinion_tooth, kind, least, greatest, is_proven, meets, phases_that_meet) = cell;
    let outcome = Outcome {
        kind: *OutcomeKind::ALL.get(usize::from(kind))?,
        least,
        greatest,
        is_proven,
    };
    let target = file.conditions.target_backlash();
    Some(PairFit {
        best: Fit::of(pinion_tooth, outcome, meets, target),
        phases_that_meet,
    })
}

/// A pair file, the folders of wheels and pinions, and the target backlash, µm: a tuple in Python.
#[derive(FromPyObject)]
pub struct MatchInput(PathBuf, PathBuf, PathBuf, Option<f64>);

impl MatchInput {
    fn read(&self, py: Python<'_>) -> Done<MatchFile> {
        let MatchInput(path, wheels, pinions, target_um) = self;
        if let Some(um) = target_um.filter(|um| !(um.abs() <= MOST_TARGET_UM)) {
            let reason = format!(
                "target_um is {um}: a number of µm between -{MOST_TARGET_UM} and {MOST_TARGET_UM} is needed"
            );
            return Err(reason.into());
        }
        let wanted = target_um.map(|um| 1e-3 * um);
        let file = py.detach(|| read_match(path, [wheels, pinions], wanted));
        file.map_err(|mut reasons| match reasons.len() {
            1 => reasons.remove(0).into(),
            _ => {
                let lines = reasons.iter().flat_map(InputError::lines);
                lines.collect::<Vec<String>>().join("\n").into()
            }
        })
    }
}

/// Block `k` (from 0) of `n` of the wheels, each with every pinion: the hash of the input, the cells, and the warnings of the
/// files.
#[pyfunction]
#[pyo3(signature = (files, block, threads=None))]
pub fn match_cells(
    py: Python<'_>,
    files: MatchInput,
    block: (usize, usize),
    threads: Option<usize>,
) -> Done<(String, Vec<Cell>, Vec<String>)> {
    let file = files.read(py)?;
    let (k, n) = block;
    let wheels = file.wheels.len();
    let end = |k: usize| (wheels as u128 * k as u128 / n.max(1) as u128) as usize;
    let wheels = end(k)..end(k + 1);
    let found = work(py, threads, |tick| {
        let cells = file.cells(wheels, tick)?;
        Ok::<_, Error>(cells.iter().map(cell).collect())
    })?;
    let warnings = [&file.pair.warnings[..], &file.warnings, &file.gear_warnings].concat();
    Ok((file.input_sha256(), found, warnings))
}

/// The assignment of the gears, from the cells of all blocks in their order, as the JSON of `gearlash match`.
#[pyfunction]
pub fn match_result(
    py: Python<'_>,
    files: MatchInput,
    blocks: Vec<(String, Vec<Cell>)>,
) -> Done<String> {
    let file = files.read(py)?;
    let own = file.input_sha256();
    if let Some(index) = blocks.iter().position(|(input, _)| *input != own) {
        return Err(format!("blocks[{index}] is of another pair file or of other gears").into());
    }
    let cells = blocks.iter().flat_map(|(_, cells)| cells);
    let cells: Option<Vec<PairFit>> = cells.map(|cell| pair_fit(cell, &file)).collect();
    let cells = cells.ok_or("a cell has an outcome that no pair has")?;
    let result = MatchResult::new(&file, cells)?;
    Ok(matching::json(&result))
}
