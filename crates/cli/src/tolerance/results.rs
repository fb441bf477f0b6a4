//! The result of a run: printed, and written to a folder.

use crate::console::print;
use crate::date::today;
use crate::error::{Error, exit_code};
use crate::output::OutputFolder;
use crate::results::{Format, ResultsArgs};
use gearlash::population::WORST;
use gearlash_files::tolerance::{
    ToleranceFile, ToleranceResult, is_worst_file, worst_file, worst_name,
};
use gearlash_render::{ToleranceReport, tolerance_pictures, tolerance_report};
use gearlash_results::population;
use gearlash_results::text::Screen;
use std::io::ErrorKind;
use std::path::Path;
use std::process::ExitCode;

const HISTOGRAM: &str = "histogram.svg";
const CONVERGENCE: &str = "convergence.svg";
const CONTRIBUTIONS: &str = "contributions.svg";
const FILES: [&str; 7] = [
    "result.json",
    "result.csv",
    "histogram.csv",
    HISTOGRAM,
    CONVERGENCE,
    CONTRIBUTIONS,
    "index.html",
];

/// Whether a run may write a file called `name`.
pub(super) fn is_own(name: &str) -> bool {
    FILES.contains(&name) || (0..WORST).any(|index| worst_name(index) == name)
}

/// An error where the results in `folder` would replace a pair file that no run wrote.
pub(super) fn check_worst_files(folder: &Path) -> Result<(), Error> {
    for path in (0..WORST).map(|index| folder.join(worst_name(index))) {
        let is_own = match std::fs::read_to_string(&path) {
            Ok(text) => is_worst_file(&text),
            Err(error) => error.kind() == ErrorKind::NotFound,
        };
        if !is_own {
            return Err(Error::Usage(format!(
                "{}: would be replaced, and is not as gearlash tolerance wrote it; rename it, or name another folder with -o",
                path.display()
            )));
        }
    }
    Ok(())
}

/// Prints `result` of the pair file at `path` and writes it to `folder`, if there is one.
pub(super) fn print_result(
    (path, file): (&Path, &ToleranceFile),
    result: &ToleranceResult,
    folder: Option<OutputFolder>,
    args: &ResultsArgs,
    screen: &Screen,
) -> Result<ExitCode, Error> {
    let date = today()?;
    let pictures = tolerance_pictures(result)?;
    let json = population::json(result).map_err(Error::unwritable("the result"))?;
    let csv = population::csv(result).map_err(Error::unwritable("the result"))?;
    let page = tolerance_report(&ToleranceReport {
        file,
        result,
        pictures: &pictures,
        date: &date,
    });
    let mut files = vec![
        ("result.json".to_owned(), json.clone()),
        ("result.csv".to_owned(), csv.clone()),
        (
            "histogram.csv".to_owned(),
            population::histogram_csv(result),
        ),
        ("index.html".to_owned(), page),
        (CONVERGENCE.to_owned(), pictures.convergence.svg),
    ];
    for (name, picture) in [
        (HISTOGRAM, pictures.histogram),
        (CONTRIBUTIONS, pictures.contributions),
    ] {
        files.extend(picture.map(|picture| (name.to_owned(), picture.svg)));
    }
    for (index, worst) in result.worst.iter().enumerate() {
        let (name, text) = worst_file(index, worst, path);
        files.push((name, text.map_err(Error::unwritable("the result"))?));
    }
    match args.format {
        Format::Text => print(&population::text(result, screen))?,
        Format::Json => print(&json)?,
        Format::Csv => print(&csv)?,
    }
    if let Some(folder) = folder {
        args.write(folder, &files)?;
    }
    Ok(exit_code(result.is_met() != Some(false)))
}
