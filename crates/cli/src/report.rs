//! `gearlash report`: the whole result as one page.

use crate::date::today;
use crate::error::{Error, exit_code};
use crate::input;
use crate::options::{MethodArgs, agreed};
use crate::output::{Target, own_folder};
use crate::progress::{Progress, run_under_bar};
use data_encoding::BASE64;
use gearlash::analysis::Plan;
use gearlash::error::go_on;
use gearlash_input::{PairFile, import};
use gearlash_render::{self, Report};
use gearlash_results::gauge::grades;
use serde_json::{Map, json};
use std::path::{Path, PathBuf};

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

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    let date = today()?;
    let pair = &input::pair(&args.pair)?;
    let study = &pair.study;
    let own = || own_folder(format!("{}.html", pair.stem));
    let target = Target::prepare_beside(args.output.clone().unwrap_or_else(own), &pair.sources)?;
    if args.live {
        let page = with_pair(args.page.as_deref(), &args.pair, pair)?;
        target.write(&page)?;
        return Ok(0);
    }
    let method = args.method.of(study)?;
    let plan = Plan::whole(study, method);
    input::allow(&args.pair, plan.poses(), &input::HELD)?;
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
        tick: &go_on,
    })?;
    drop(progress);
    let agree = agreed(&analysis);
    target.write(&page)?;
    Ok(exit_code(agree))
}

/// The place of the pair in the page.
const EMPTY: &str = "<script type=\"application/json\" id=\"own\">null</script>";

/// The name of the page, beside the program.
const NAME: &str = "gearlash.html";

/// The page at `page`, or beside the program, with the files of `pair`, the pair file at `path`, in it.
fn with_pair(page: Option<&Path>, path: &Path, pair: &PairFile) -> Result<String, Error> {
    if path == Path::new("-") {
        return Err(Error::usage(
            "--live holds the files of the pair: name the pair file",
        ));
    }
    let program = std::env::current_exe().unwrap_or_default();
    let page = page.map_or_else(|| program.with_file_name(NAME), Path::to_path_buf);
    let missing = || {
        let shown = page.display();
        Error::Usage(format!(
            "{shown}: the page of gearlash is not there; build it with crates/web/build, or name it with --page"
        ))
    };
    let text = std::fs::read_to_string(&page).map_err(|_| missing())?;
    if !text.contains(EMPTY) {
        return Err(missing());
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let named = |path: &Path| {
        let inside = path.strip_prefix(folder).unwrap_or(path);
        inside.to_string_lossy().replace('\\', "/")
    };
    let mut files = Map::new();
    for source in pair.sources.names() {
        let bytes = import::bytes(source)?;
        files.insert(named(source), BASE64.encode(&bytes).into());
    }
    let held = json!({ "main": named(path), "files": files }).to_string();
    // No text of a file ends the element.
    let held = held.replace('<', "\\u003c");
    Ok(text.replacen(EMPTY, &EMPTY.replace("null", &held), 1))
}
