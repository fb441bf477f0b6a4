//! `gearlash export`: the backlash of a pair written into a copy of a gearbox model.

use super::console::tell;
use super::target::Target;
use super::{rexs, studies, verdict};
use crate::error::Error;
use gearlash::analysis::extremes::{RunExtreme, RunExtremes};
use gearlash::analysis::study::Study;
use gearlash::analysis::verdict::Verdict;
use gearlash_files::numbers::rounded;
use gearlash_files::rexs::RexsBacklash;
use gearlash_results::verdict::lines;
use std::path::PathBuf;
use std::process::ExitCode;

/// Write the least and greatest backlash of a pair into a copy of a gearbox model (REXS)
///
/// minimum_ and maximum_normal_backlash and _transverse_backlash (j_bn and j_t on the reference circles, mm) of the stage: the
/// proven extremes over the whole mesh cycle, every centre distance and material of the pair file. Nothing else in the file
/// changes, and the file itself is never written to.
#[derive(clap::Args)]
pub(super) struct Args {
    /// The model (.rexs, .rexsj)
    file: PathBuf,
    /// The pair file of the stage
    pair: PathBuf,
    /// The stage, by its id in the model
    #[arg(long, value_name = "ID", allow_negative_numbers = true)]
    stage: i32,
    /// The copy to write, - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let model = gearlash_files::rexs::read(&args.file)?;
    let name = args.file.display().to_string();
    let stage = rexs::stage(&name, &model, args.stage)?;
    let pair = studies::pair(&args.pair)?;
    stage.is_of(&pair.spec).map_err(|why| {
        let id = stage.id;
        Error::Usage(format!(
            "{name}: stage {id} {why}; export the pair file that gearlash import {name} --stage {id} -o PAIR writes, or correct the model"
        ))
    })?;
    let mut sources = model.sources.clone();
    sources.extend(&pair.sources);
    let target = Target::prepare(args.output.clone(), &sources)?;
    let backlash = backlash(&pair.study)?;
    let copy = model.with_backlash(stage.id, &backlash).ok_or_else(|| {
        Error::Usage(format!(
            "{name}: is zipped; unpack it and name the .rexs file"
        ))
    })?;
    if ["1.0", "1.1"].contains(&model.version.as_str()) {
        tell(&format!(
            "note: {name}: REXS {} does not list these attributes, versions from 1.2 on do",
            model.version
        ));
    }
    target.write(&copy)?;
    Ok(ExitCode::SUCCESS)
}

/// The extremes of `study`, where every one of them is proven.
fn backlash(study: &Study) -> Result<RexsBacklash, Error> {
    let (found, failed) = verdict::extremes_and_failed_checks(study)?;
    let verdict = lines(&Verdict::of_study(study, &found.each, failed)).to_string();
    let unproven = || Error::Unproven(verdict.clone());
    let mut each = Vec::new();
    for run in &found.each {
        each.push([
            ends(run, run.least.as_ref(), |e| e.low).ok_or_else(unproven)?,
            ends(run, run.greatest.as_ref(), |e| e.high).ok_or_else(unproven)?,
        ]);
    }
    // A ten-thousandth of a µm, below the width of a bracket.
    let over = |of: usize| {
        let least = each.iter().map(|[least, _]| least[of]);
        let greatest = each.iter().map(|[_, greatest]| greatest[of]);
        [
            least.fold(f64::INFINITY, f64::min),
            greatest.fold(f64::NEG_INFINITY, f64::max),
        ]
        .map(|mm| rounded(mm, 7))
    };
    Ok(RexsBacklash {
        normal: over(0),
        transverse: over(1),
    })
}

/// `j_bn` and `j_t`, mm, of the end of a proven extreme beyond which no rotation lies.
fn ends(
    run: &RunExtremes,
    extreme: Option<&RunExtreme>,
    end: impl Fn(&RunExtreme) -> f64,
) -> Option<[f64; 2]> {
    let extreme = extreme.filter(|extreme| extreme.is_proven())?;
    let all = run.assembly.backlash(end(extreme));
    Some([all.j_bn, all.j_t])
}
