//! Least and greatest backlash of the whole mesh cycle, and every check of a pair.

use crate::call::{analysed, work};
use crate::error;
use crate::pair::Pair;
use gearlash::analysis::Plan;
use gearlash::analysis::extremes as cycle;
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::Method;
use gearlash_results::judged::{JudgedFile, Outcome};
use gearlash_results::text::Screen;
use gearlash_results::{RemedyRecords, checked, extremes_json};
use pyo3::prelude::*;

const METHOD: Method = Method::Exact { certify: true };

/// The extremes of each centre distance, material and assembly phase as the JSON of results.
#[pyfunction]
#[pyo3(signature = (pair, threads=None))]
pub fn extremes(py: Python<'_>, pair: &Pair, threads: Option<usize>) -> error::Outcome<String> {
    let study = pair.study();
    let found = work(py, threads, |tick| cycle::extremes(study, METHOD, tick))?;
    let verdict = Verdict::of_study(study, &found.each, Vec::new());
    Ok(extremes_json(&verdict))
}

/// Verdict, extremes and every check as the JSON of `gearlash check`.
#[pyfunction]
#[pyo3(signature = (pair, threads=None))]
pub fn check(py: Python<'_>, pair: &Pair, threads: Option<usize>) -> error::Outcome<String> {
    let plan = Plan::new(pair.study(), METHOD)
        .with_remedies(pair.file.spec.stated_gears())
        .with_checks();
    let analysis = analysed(py, threads, &plan)?;
    let (name, screen) = (&pair.file.stem, Screen::default());
    let is_proven = analysis.unproven() == 0 && analysis.agreement().agrees();
    let verdict = analysis.verdict();
    let remedies = RemedyRecords::new(&pair.file, &analysis.remedies);
    let judged = checked(
        name,
        &pair.file,
        &analysis.diagnosis,
        &verdict,
        &remedies,
        is_proven,
        &screen,
    );
    let files = vec![JudgedFile::Judged(Box::new(judged))];
    let outcome = Outcome {
        command: "check",
        files,
    };
    Ok(outcome.json())
}
