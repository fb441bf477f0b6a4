//! Pairs of which a gear is an outline: what `simulate` does with them.

use super::console::{ScreenArgs, print};
use super::method::{MethodArgs, all_proven};
use super::progress::Progress;
use super::results::{Format, ResultsArgs};
use super::unit::UnitArgs;
use crate::error::{Error, exit_code};
use gearlash::analysis::outlines::{OutlineRun, unproven, worst};
use gearlash_files::OutlinePairFile;
use gearlash_results::outlines::{to_csv, to_json};
use gearlash_results::text;
use std::path::Path;
use std::process::ExitCode;

const JSON: &str = "result.json";
const CSV: &str = "result.csv";
const WORST: &str = "worst.svg";

/// How drawings on the command line are read.
#[derive(clap::Args)]
pub(super) struct DrawnArgs {
    /// Unit of the drawings, where they state none
    #[arg(long, value_name = "UNIT", value_parser = ["mm", "inch", "cm", "m", "um"])]
    pub(super) units: Option<String>,
    /// Where the axes of the drawings are: of the circle through the tips, or of the one circle inside [default: 0,0]
    #[arg(long, value_name = "HOW", value_parser = ["fit", "bore"])]
    pub(super) center: Option<String>,
}

impl DrawnArgs {
    /// Whether any of it was asked for.
    pub(super) fn given(&self) -> bool {
        self.units.is_some() || self.center.is_some()
    }
}

/// Whether a file is a drawing, by its ending.
pub(super) fn is_drawing(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default();
    ["dxf", "svg", "csv", "txt", "xyz"]
        .iter()
        .any(|drawn| ending.eq_ignore_ascii_case(drawn))
}

/// All runs, under a bar.
pub(super) fn runs(file: &OutlinePairFile, method: &MethodArgs) -> Result<Vec<OutlineRun>, Error> {
    if method.named() {
        return Err(Error::Usage(
            "--method is for gears by their data: an outline's curves are searched as drawn, and polygons bear out every pose; leave it out"
                .to_owned(),
        ));
    }
    let progress = Progress::start(file.study.steps());
    let runs = file.study.runs(method.certifies(), &|| progress.tick())?;
    drop(progress);
    Ok(runs)
}

/// `gearlash simulate` of a pair with an outline.
pub(super) fn simulate(
    file: &OutlinePairFile,
    results: &ResultsArgs,
    screen: &ScreenArgs,
    (method, unit): (&MethodArgs, &UnitArgs),
) -> Result<ExitCode, Error> {
    let unit = unit.of_outlines(&file.study, results.format == Format::Text)?;
    let folder = results.folder(&file.stem, &file.sources, |name| {
        matches!(name, JSON | CSV | WORST)
    })?;
    let runs = runs(file, method)?;
    let (mut json, mut csv) = (String::new(), String::new());
    if folder.is_some() || results.format == Format::Json {
        json = to_json(file, &runs).map_err(Error::unwritable("the result"))?;
    }
    if folder.is_some() || results.format == Format::Csv {
        csv = to_csv(&runs).map_err(Error::unwritable("the result"))?;
    }
    match results.format {
        Format::Text => print(&text::outlines(file, &runs, unit, &screen.screen()))?,
        Format::Json => print(&json)?,
        Format::Csv => print(&csv)?,
    }
    if let Some(folder) = folder {
        let mut files = vec![(JSON.to_owned(), json), (CSV.to_owned(), csv)];
        if let Some((run, pose)) = worst(&runs) {
            let title = &file.study.title;
            let picture = gearlash_render::outline_snapshot(title, &run.pair, run.material, pose);
            files.push((WORST.to_owned(), picture));
        }
        results.write(folder, &files)?;
    }
    // As of gears by their data: a pair that binds is a result, unless a requirement says otherwise.
    let kept = file.study.requirement(&runs).is_kept();
    Ok(exit_code(all_proven(unproven(&runs)) & kept))
}
