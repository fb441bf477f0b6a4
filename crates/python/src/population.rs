//! Populations and matchings: parts of a run, their sum, and which gears go together.

use crate::call::work;
use crate::error::{error, input};
use gearlash::population::SampleError;
use gearlash_files::matching::{MatchPart, MatchResult, read_match};
use gearlash_files::tolerance::{
    BlockError, MOST_ASSEMBLIES, Part, ToleranceResult, read_tolerance,
};
use gearlash_files::{MOST_SHARDS, PartError};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// The farthest that a wanted backlash may lie from 0, µm, as that of the command.
const MOST_TARGET_UM: f64 = 1e5;

/// Part `k` of `n` of the run that `[tolerance]` of the pair file at `path` asks for, as the text of a part's file, and the warnings of the files.
#[pyfunction]
#[pyo3(signature = (path, assemblies, seed, shard, threads=None))]
pub fn tolerance_part(
    py: Python<'_>,
    path: PathBuf,
    assemblies: Option<u64>,
    seed: Option<u64>,
    shard: (u64, u64),
    threads: Option<usize>,
) -> PyResult<(String, Vec<String>)> {
    let file = py.detach(|| read_tolerance(&path));
    let file = file.map_err(|reason| input(py, &reason))?;
    let assemblies = assemblies.unwrap_or(file.tolerance.assemblies.into());
    let seed = seed.unwrap_or(file.tolerance.seed.into());
    let (k, n) = shard;
    let is_run = (1..=MOST_ASSEMBLIES).contains(&assemblies);
    if !is_run || k == 0 || k > n || n > assemblies || n > MOST_SHARDS {
        return Err(error(
            py,
            format!(
                "part {k} of {n} of {assemblies} assemblies: parts from 1 on are allowed, as many as assemblies and {MOST_SHARDS} at most, and up to {MOST_ASSEMBLIES} assemblies"
            ),
        ));
    }
    let done = work(py, threads, |tick| {
        let mut part = file.part(assemblies, seed, [k, n])?;
        loop {
            let went_on = file.go_on(&mut part, None, tick);
            if let Some(reason) = file.too_many_impossible(&part) {
                return Ok(Err(reason.to_string()));
            }
            match went_on {
                Ok(true) => (),
                Ok(false) => return Ok(Ok(part)),
                Err(BlockError::Sample(SampleError::Error(reason))) => return Err(reason),
                Err(other) => return Ok(Err(other.to_string())),
            }
        }
    })?;
    let part = done.map_err(|reason| error(py, reason))?;
    let warnings = [&file.pair.warnings[..], &file.warnings].concat();
    Ok((part.to_json(), warnings))
}

/// The result of all `parts` of one run, in any order, as the JSON of `gearlash tolerance`.
#[pyfunction]
pub fn tolerance_result(py: Python<'_>, parts: Vec<String>) -> PyResult<String> {
    let part = Part::merged(named(py, &parts, Part::from_json)?);
    let part = part.map_err(|reason| error(py, reason))?;
    if let Some(reason) = part.too_many_impossible() {
        return Err(error(py, reason.to_string()));
    }
    Ok(ToleranceResult::of(part).to_json())
}

/// Part `k` of `n` of all wheels with pinions of two folders, as the text of a part's file, and the warnings of the files.
#[pyfunction]
#[pyo3(signature = (path, wheels, pinions, target_um, shard, threads=None))]
pub fn match_part(
    py: Python<'_>,
    path: PathBuf,
    wheels: PathBuf,
    pinions: PathBuf,
    target_um: Option<f64>,
    shard: (u64, u64),
    threads: Option<usize>,
) -> PyResult<(String, Vec<String>)> {
    let folders: [&Path; 2] = [&wheels, &pinions];
    if let Some(um) = target_um
        && !(um.abs() <= MOST_TARGET_UM)
    {
        return Err(error(
            py,
            format!(
                "target_um is {um}: a number of µm between -{MOST_TARGET_UM} and {MOST_TARGET_UM} is needed"
            ),
        ));
    }
    let wanted = target_um.map(|um| 1e-3 * um);
    let file = py.detach(|| read_match(&path, folders, wanted));
    let file = file.map_err(|reasons| match &reasons[..] {
        [only] => input(py, only),
        _ => {
            let lines: Vec<String> = reasons.iter().flat_map(|reason| reason.lines()).collect();
            error(py, lines.join("\n"))
        }
    })?;
    let (k, n) = shard;
    if k == 0 || k > n || n > MOST_SHARDS {
        return Err(error(
            py,
            format!("part {k} of {n}: parts from 1 on are allowed, {MOST_SHARDS} at most"),
        ));
    }
    let part = work(py, threads, |tick| {
        let mut part = file.part([k, n])?;
        while file.go_on(&mut part, tick)? {}
        Ok(part)
    })?;
    let warnings = [&file.pair.warnings[..], &file.warnings, &file.gear_warnings].concat();
    Ok((part.to_json(), warnings))
}

/// Which gears go together, of all `parts` of one matching in any order, as the JSON of `gearlash match`.
#[pyfunction]
pub fn match_result(py: Python<'_>, parts: Vec<String>) -> PyResult<String> {
    let part = MatchPart::merged(named(py, &parts, MatchPart::from_json)?);
    let part = part.map_err(|reason| error(py, reason))?;
    let result = MatchResult::of(part).ok_or_else(|| error(py, "a part of it is not done"))?;
    Ok(result.to_json())
}

/// Each part with its place as the name of its file.
fn named<P>(
    py: Python<'_>,
    parts: &[String],
    read: fn(&str, &str) -> Result<P, PartError>,
) -> PyResult<Vec<(String, P)>> {
    let each = parts.iter().enumerate().map(|(index, text)| {
        let name = format!("parts[{index}]");
        Ok((name.clone(), read(&name, text)?))
    });
    let each: Result<Vec<_>, PartError> = each.collect();
    each.map_err(|reason| error(py, reason))
}
