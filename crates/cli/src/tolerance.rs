//! `gearlash tolerance`: the share of a population that meets its requirement, and what it depends on.

mod rows;

use crate::console::{print_note, warn};
use crate::date::today;
use crate::error::{Error, exit_code};
use crate::input;
use crate::options::{ResultsArgs, ScreenArgs};
use crate::output::OutputFolder;
use crate::progress::Progress;
use gearlash::population::{
    ASSEMBLIES_PER_TICK, ContributionsError, ROWS_PER_TICK, Row, Tally, WORST_KEPT,
};
use gearlash_input::tolerance::{
    BLOCK, MAX_ASSEMBLIES, RowsTally, ToleranceFile, ToleranceResult, ToleranceRun, is_worst_file,
    read_tolerance, worst_file, worst_name,
};
use gearlash_render::{ToleranceReport, tolerance_pictures, tolerance_report};
use gearlash_results::population;
use rows::RowsFile;
use std::io::ErrorKind;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Draw assemblies as [tolerance] says, and find the share that misses [require]
///
/// The least and greatest backlash of each assembly are proven over its whole mesh cycle, and compared with all that [require] states. Prints shares of a
/// million with their 95 % intervals, the spread, worst case and root sum of squares, and what each tolerance contributes. Writes result.json, result.csv,
/// histogram.csv, pictures, index.html and the ten worst assemblies as pair files to DIR, over those of an earlier run. An assembly depends on the seed
/// and its number alone: any number of threads, and rows computed anywhere, give the same bytes. Exit code 1 where more miss the requirement than max_ppm
/// allows.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair file (TOML or JSON), - for standard input
    pair: PathBuf,
    /// Another number of assemblies
    #[arg(long, value_name = "M", value_parser = clap::value_parser!(u64).range(1..=MAX_ASSEMBLIES))]
    assemblies: Option<u64>,
    /// Another seed
    #[arg(long, value_name = "S", value_parser = clap::value_parser!(u64).range(0..=u64::from(u32::MAX)))]
    seed: Option<u64>,
    /// Write a new file with a row for each assembly
    #[arg(long, value_name = "FILE.csv")]
    rows: Option<PathBuf>,
    /// Compute only rows, from assembly N on
    #[arg(long, value_name = "N", requires = "rows", conflicts_with_all = ["output", "format", "no_files"], value_parser = clap::value_parser!(u64).range(1..=MAX_ASSEMBLIES))]
    first: Option<u64>,
    /// Give the statistics of the rows in these files, which have every assembly once; * and ? stand for letters
    #[arg(long, value_name = "FILES", num_args = 1.., conflicts_with_all = ["rows", "first"])]
    from_rows: Vec<PathBuf>,
    #[command(flatten)]
    results: ResultsArgs,
    #[command(flatten)]
    screen: ScreenArgs,
}

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    let file = read_tolerance(&args.pair)?;
    let mut sources = file.pair.sources.clone();
    let rows_files = rows::expanded(&args.from_rows)?;
    rows_files.iter().for_each(|path| sources.add(path));
    let warnings = [&file.pair.warnings[..], &file.warnings].concat();
    input::report(&args.pair, &sources, &warnings, &file.pair.remarks)?;
    if let Some(first) = args.first {
        return range(args, &file, first);
    }
    let run = ToleranceRun::new(&file, &args.pair, args.assemblies, args.seed)?;
    let folder = args.results.path(&file.pair.stem);
    let prepared = args.results.folder(&file.pair.stem, &sources, is_own)?;
    if let Some(folder) = &folder {
        check_worst_files(folder)?;
    }
    let tally = if rows_files.is_empty() {
        let numbers = 1..run.assemblies() + 1;
        let rows = args.rows.as_deref();
        if let (Some(folder), Some(rows)) = (&folder, rows) {
            rows::check_not_result(rows, folder)?;
        }
        let rows = rows.map(|path| RowsFile::begin(path, &run, numbers.clone(), true));
        draw(&run, numbers, rows.transpose()?)?
    } else {
        rows::read(&run, &rows_files)?
    };
    if let Some(reason) = run.too_many_impossible(&tally) {
        return Err(Error::Usage(reason.to_string()));
    }
    let bar = Progress::of(run.contribution_rows().div_ceil(ROWS_PER_TICK), "steps");
    bar.now("contributions");
    let result = run.result(tally, &|steps| bar.tick(steps));
    drop(bar);
    let result = result.map_err(|error| match error {
        ContributionsError::Error(error) => Error::Run(error),
        ContributionsError::Overflow(error) => Error::Usage(error.to_string()),
    })?;
    finish(args, &file, &result, prepared)
}

/// The rows of `args.assemblies` from number `first` on; by default up to the last of the pair file.
fn range(args: &Args, file: &ToleranceFile, first: u64) -> Result<u8, Error> {
    let all = u64::from(file.tolerance.assemblies);
    let rest = (all + 1).checked_sub(first).filter(|rest| *rest > 0);
    let count = args.assemblies.or(rest).ok_or_else(|| {
        Error::Usage(format!(
            "--first {first}: the pair file has {all} assemblies; state with --assemblies how many are computed"
        ))
    })?;
    let end = first + count;
    if end > MAX_ASSEMBLIES + 1 {
        return Err(Error::Usage(format!(
            "--first {first} --assemblies {count}: ends at assembly {}; the last one is {MAX_ASSEMBLIES}",
            end - 1
        )));
    }
    if end > all + 1 {
        let last = end - 1;
        let beyond = format!(
            "tolerance.assemblies = {all}: rows up to {last} are computed; give --from-rows the total of all parts with --assemblies, {last} or more"
        );
        warn(&args.pair, &[beyond], &[]);
    }
    let run = ToleranceRun::new(file, &args.pair, Some(all.max(end - 1)), args.seed)?;
    // --first requires --rows.
    let path = args.rows.as_deref().unwrap_or(Path::new("rows.csv"));
    let rows = RowsFile::begin(path, &run, first..end, false)?;
    draw(&run, first..end, Some(rows))?;
    let path = gearlash_text::characters::plain(&path.display().to_string());
    print_note(&format!("{path}: assemblies {first} to {}\n", end - 1))?;
    Ok(0)
}

/// Draws the assemblies `numbers`: their sums, and their `rows` in a file.
fn draw(
    run: &ToleranceRun,
    numbers: Range<u64>,
    mut rows: Option<RowsFile>,
) -> Result<Tally, Error> {
    let steps = (numbers.end - numbers.start).div_ceil(ASSEMBLIES_PER_TICK);
    let bar = Progress::of(steps, "steps");
    bar.now("assemblies");
    let mut tally = RowsTally::new(run);
    let mut counted = |block| -> Result<Vec<Row>, Error> {
        let drawn = run.rows(block, &|steps| bar.tick(steps))?;
        let added = drawn.iter().try_for_each(|row| tally.add(row));
        added.map_err(|error| Error::Usage(error.to_string()))?;
        match run.too_many_impossible(tally.tally()) {
            Some(reason) => Err(Error::Usage(reason.to_string())),
            None => Ok(drawn),
        }
    };
    for from in numbers.clone().step_by(BLOCK as usize) {
        let drawn = counted(from..(from + BLOCK).min(numbers.end));
        let drawn = drawn.inspect_err(|_| rows.take().map_or((), RowsFile::remove))?;
        if let Some(rows) = &mut rows {
            rows.write(&drawn)?;
        }
    }
    drop(bar);
    rows.map_or(Ok(()), RowsFile::finish)?;
    Ok(tally.into_tally())
}

/// The files of a result, beside the worst assemblies.
const FILES: [&str; 7] = [
    "result.json",
    "result.csv",
    "histogram.csv",
    "histogram.svg",
    "convergence.svg",
    "contributions.svg",
    "index.html",
];

/// Whether a run may write a file called `name`.
fn is_own(name: &str) -> bool {
    FILES.contains(&name) || (0..WORST_KEPT).any(|index| worst_name(index) == name)
}

/// An error where the results in `folder` would replace a pair file that no run wrote.
fn check_worst_files(folder: &Path) -> Result<(), Error> {
    for path in (0..WORST_KEPT).map(|index| folder.join(worst_name(index))) {
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

/// Prints `result` and writes it to `folder`, if there is one.
fn finish(
    args: &Args,
    file: &ToleranceFile,
    result: &ToleranceResult,
    folder: Option<OutputFolder>,
) -> Result<u8, Error> {
    let date = today()?;
    let pictures = tolerance_pictures(result)?;
    let json = population::json(result);
    let csv = population::csv(result);
    let page = tolerance_report(&ToleranceReport {
        file,
        result,
        pictures: &pictures,
        date: &date,
    });
    let contents = [
        Some(json.clone()),
        Some(csv.clone()),
        Some(population::histogram_csv(result)),
        pictures.histogram.map(|picture| picture.svg),
        Some(pictures.convergence.svg),
        pictures.contributions.map(|picture| picture.svg),
        Some(page),
    ];
    let files = FILES.into_iter().zip(contents);
    let files = files.filter_map(|(name, content)| Some((name.to_owned(), content?)));
    let mut files: Vec<(String, String)> = files.collect();
    for (index, worst) in result.worst.iter().enumerate() {
        let (name, text) = worst_file(index, worst, &args.pair);
        files.push((name, text.map_err(Error::unwritable("the result"))?));
    }
    let text = population::text(result, &args.screen.screen());
    args.results.finish([&text, &json, &csv], folder, &files)?;
    Ok(exit_code(result.is_met() != Some(false)))
}
