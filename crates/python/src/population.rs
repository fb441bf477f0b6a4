//! Populations and matchings: parts of a run, their sum, and which gears go together.

use crate::call::work;
use crate::error::{error, input};
use gearlash::gear::AsBuilt;
use gearlash::matching::Matrix;
use gearlash::population::SampleError;
use gearlash_files::matching::{MatchResult, NamedGear, read_match};
use gearlash_files::tolerance::{BlockError, Part, ToleranceResult, read_tolerance};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// Part `k` of `n` of the run that `[tolerance]` of the pair file at `path` asks for, as the text of a part's file.
#[pyfunction]
#[pyo3(signature = (path, assemblies, seed, shard, threads=None))]
pub fn tolerance_part(
    py: Python<'_>,
    path: PathBuf,
    assemblies: Option<u64>,
    seed: Option<u64>,
    shard: (u64, u64),
    threads: Option<usize>,
) -> PyResult<String> {
    let file = py.detach(|| read_tolerance(&path));
    let file = file.map_err(|reason| input(py, &reason))?;
    let assemblies = assemblies.unwrap_or(file.tolerance.assemblies.into());
    let seed = seed.unwrap_or(file.tolerance.seed.into());
    let (k, n) = shard;
    if assemblies == 0 || k == 0 || k > n || n > assemblies {
        return Err(error(
            py,
            format!(
                "part {k} of {n} of {assemblies} assemblies: parts from 1 on are allowed, as many as assemblies at most"
            ),
        ));
    }
    let done = work(py, threads, |tick| {
        let mut part = file.part(assemblies, seed, [k, n])?;
        loop {
            match file.go_on(&mut part, None, tick) {
                Ok(true) => (),
                Ok(false) => return Ok(Ok(part)),
                Err(BlockError::Sample(SampleError::Error(reason))) => return Err(reason),
                Err(other) => return Ok(Err(other.to_string())),
            }
        }
    })?;
    Ok(done.map_err(|reason| error(py, reason))?.to_json())
}

/// The result of all `parts` of one run, in any order, as the JSON of `gearlash tolerance`.
#[pyfunction]
pub fn tolerance_result(py: Python<'_>, parts: Vec<String>) -> PyResult<String> {
    let each = parts.iter().enumerate().map(|(index, text)| {
        let name = format!("parts[{index}]");
        Ok((name.clone(), Part::from_json(&name, text)?))
    });
    let merged = each.collect::<Result<_, _>>().and_then(Part::merged);
    let part = merged.map_err(|reason| error(py, reason))?;
    if part.is_impossible() {
        return Err(error(
            py,
            format!(
                "{} of {} draws are of no gear, more than the share of {} that tolerance.max_impossible allows; narrow what scatters",
                part.tally.counts.impossible, part.head.assemblies, part.about.max_impossible
            ),
        ));
    }
    Ok(ToleranceResult::of(part).to_json())
}

/// Which gears of two folders go together, as the JSON of `gearlash match`.
#[pyfunction]
#[pyo3(name = "match", signature = (path, wheels, pinions, target_um=None, threads=None))]
pub fn matched(
    py: Python<'_>,
    path: PathBuf,
    wheels: PathBuf,
    pinions: PathBuf,
    target_um: Option<f64>,
    threads: Option<usize>,
) -> PyResult<String> {
    let folders: [&Path; 2] = [&wheels, &pinions];
    let wanted = target_um.map(|um| 1e-3 * um);
    let file = py.detach(|| read_match(&path, folders, wanted));
    let file = file.map_err(|reasons| match &reasons[..] {
        [only] => input(py, only),
        _ => {
            let lines: Vec<String> = reasons.iter().flat_map(|reason| reason.lines()).collect();
            error(py, lines.join("\n"))
        }
    })?;
    let gears = |named: &[NamedGear]| -> Vec<AsBuilt> {
        named.iter().map(|named| named.gear.clone()).collect()
    };
    let (wheels, pinions) = (gears(&file.wheels), gears(&file.pinions));
    let matrix = work(py, threads, |tick| {
        Matrix::new(&wheels, &pinions, &file.terms, tick)
    })?;
    Ok(MatchResult::of(&file, matrix).to_json())
}
