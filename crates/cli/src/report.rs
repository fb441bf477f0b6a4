//! `gearlash report`: the whole result as one page.

use super::date::today;
use super::method::{MethodArgs, agreed};
use super::progress::{Progress, run_under_bar};
use super::target::Target;
use super::{live_page, poses, studies};
use crate::error::{Error, exit_code};
use gearlash::analysis::Plan;
use gearlash_render::{self, Report};
use gearlash_results::grades::grades;
use std::path::PathBuf;
use std::process::ExitCode;

/// Write one HTML page with verdict, input, checks, curves, formulas and the mesh
///
/// The page needs no network and no other file, and prints on A4. In addition to the poses of the pair file it
/// shows whole revolutions at each centre distance. It is dated today, or by the environment variable
/// SOURCE_DATE_EPOCH (seconds since 1970) where set, so that the same input gives the same bytes.
/// Up to 2 million poses, revolutions included (2 GB of memory).
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair file (TOML or JSON), - for standard input
    pair: PathBuf,
    /// Page, - for standard output [default: out/<file stem>.html]
    #[arg(short, long, value_name = "FILE.html")]
    output: Option<PathBuf>,
    /// Write the page for the browser, with this pair and its tables in it
    #[arg(long)]
    live: bool,
    /// The page without a pair [default: gearlash.html beside the program]
    #[arg(long, value_name = "FILE.html", requires = "live")]
    page: Option<PathBuf>,
    #[command(flatten)]
    method: MethodArgs,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let date = today()?;
    let pair = &studies::pair(&args.pair)?;
    let study = &pair.study;
    let own = || PathBuf::from("out").join(format!("{}.html", pair.stem));
    let target = Target::prepare_beside(args.output.clone().unwrap_or_else(own), &pair.sources)?;
    if args.live {
        let page = live_page::with_pair(args.page.as_deref(), &args.pair, pair)?;
        target.write(&page)?;
        return Ok(ExitCode::SUCCESS);
    }
    let method = args.method.of(study)?;
    let plan = Plan::whole(study, method);
    poses::allow(&args.pair, plan.poses(), &poses::HELD)?;
    let analysis = run_under_bar(&plan)?;
    let progress = Progress::working();
    progress.now("accuracy grades");
    let grades = grades(pair);
    progress.now("page");
    let page = gearlash_render::report(&Report {
        pair,
        file: &args.pair.file_name().unwrap_or_default().to_string_lossy(),
        date: &date,
        analysis: &analysis,
        grades: &grades,
    })?;
    drop(progress);
    let agree = agreed(&analysis);
    target.write(&page)?;
    Ok(exit_code(agree))
}
