//! `gearlash tolerance`: what share of a population meets its requirement, and what it depends on.

mod earlier;
mod parquet;
mod results;
mod rows;

use super::console::{ScreenArgs, guard, print_note, warn};
use super::parts::{Kept, shard};
use super::progress::Progress;
use crate::error::Error;
use crate::output::OutputFolder;
use gearlash::population::{CHUNK, SampleError};
use gearlash_files::tolerance::{
    BlockError, MOST_ASSEMBLIES, Part, ToleranceFile, ToleranceResult, read_tolerance,
};
use rows::RowsFile;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub(super) use earlier::guard as guard_earlier;
pub(super) use results::{Format, is_own, tell_result};

/// Draw assemblies as [tolerance] of the pair file says, and find what share of them misses [require]
///
/// Each assembly's least and greatest backlash are proven over its whole mesh cycle, and held against all that [require] states. Prints shares of a
/// million with their intervals of 95 %, the spread, worst case and root sum of squares, and what each tolerance contributes; writes result.json, result.csv,
/// histogram.csv, pictures, index.html and the ten worst assemblies as pair files to DIR, over those of an earlier run. An assembly depends on the seed
/// and its number alone: any number of threads and shards gives the same bytes. Interrupted, it keeps what is done in DIR/part.json; the same
/// command goes on from there. Exit code 1 where more miss the requirement than max_ppm allows.
#[derive(clap::Args)]
pub(super) struct Args {
    /// The pair file (TOML or JSON) with [tolerance], - for standard input
    pair: PathBuf,
    /// Folder for results [default: out/<file stem>; with --format json or csv none]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// How many assemblies, in place of the pair file's
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MOST_ASSEMBLIES))]
    assemblies: Option<u64>,
    /// Another seed than the pair file's
    #[arg(long, value_name = "S", value_parser = clap::value_parser!(u64).range(0..=u64::from(u32::MAX)))]
    seed: Option<u64>,
    /// Part K of N of the run alone, to DIR/part_K_of_N.json: gearlash merge puts all together
    #[arg(long, value_name = "K/N", value_parser = shard)]
    shard: Option<[u64; 2]>,
    /// Also each assembly's least and greatest backlash, to FILE.csv or FILE.parquet, over rows alone and never those of another part; such a run begins
    /// anew where it was interrupted
    #[arg(long, value_name = "FILE")]
    rows: Option<PathBuf>,
    /// What to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    screen: ScreenArgs,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let file = read_tolerance(&args.pair)?;
    guard(&file.pair.sources)?;
    let warnings = [&file.pair.warnings[..], &file.warnings].concat();
    warn(&args.pair, &warnings, &file.pair.remarks);
    let assemblies = args.assemblies.unwrap_or(file.tolerance.assemblies.into());
    let seed = args.seed.unwrap_or(file.tolerance.seed.into());
    let shard = args.shard.unwrap_or([1, 1]);
    if shard[1] > assemblies {
        return Err(Error::Usage(format!(
            "--shard: {assemblies} assemblies do not make {} parts; take fewer",
            shard[1]
        )));
    }
    let own = Path::new("out").join(&file.pair.stem);
    let (named, sources) = (args.output.as_deref(), &file.pair.sources);
    let folder = args.format.folder(named, &own, args.shard);
    let mut kept = folder
        .as_ref()
        .map(|folder| Kept::new(folder, args.shard, sources));
    let whole = folder.as_ref().filter(|_| args.shard.is_none());
    let prepared = whole.map(|folder| OutputFolder::prepare(folder, sources, is_own));
    let mut prepared = prepared.transpose()?;
    let begun = file.part(assemblies, seed, shard)?;
    let rows = args.rows.as_deref();
    if let Some(folder) = whole {
        guard_earlier(folder, &begun.head, rows)?;
    }
    let results = whole.map(PathBuf::as_path).zip(prepared.as_mut());
    let first = begun.head.numbers().start;
    let rows = rows.map(|path| RowsFile::begin(path, first, &file.pair.sources, results));
    let rows = rows.transpose()?;
    let mut part = match (&rows, &kept) {
        (None, Some(kept)) => kept.found(begun),
        _ => begun,
    };
    work(&file, &mut part, kept.as_mut(), rows)?;
    if let (Some(kept), Some(_)) = (&kept, args.shard) {
        print_note(&kept.finish(&part, shard)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    let result = ToleranceResult::of(part);
    tell_result(&result, prepared, args.format, &args.screen.screen())
}

/// Does all of `part` that is left, and keeps what is done from time to time.
fn work(
    file: &ToleranceFile,
    part: &mut Part,
    mut kept: Option<&mut Kept>,
    mut rows: Option<RowsFile>,
) -> Result<(), Error> {
    let steps = |length: u64, done: u64, chunk: u64| length.saturating_sub(done).div_ceil(chunk);
    let length = |range: std::ops::Range<u64>| range.end - range.start;
    let left = steps(length(part.head.numbers()), part.done.assemblies, CHUNK)
        + steps(length(part.head.rows()), part.done.rows, 8);
    let bar = Progress::of(left, "steps");
    loop {
        let numbers = length(part.head.numbers());
        bar.now(match part.done.assemblies < numbers {
            true => "assemblies",
            false => "contributions",
        });
        let mut take = rows.as_mut().map(|rows| |each: &[_]| rows.take(each));
        let take = take.as_mut().map(|take| take as &mut dyn FnMut(&[_]) -> _);
        let went_on = file
            .go_on(part, take, &|| bar.tick())
            .map_err(|error| match error {
                BlockError::Sample(SampleError::Error(error)) => Error::Run(error),
                BlockError::Sample(other) => Error::Usage(other.to_string()),
                BlockError::Rows(source) => Error::Printing(source),
            })?;
        if let Some(reason) = file.too_many_impossible(part) {
            return Err(Error::Usage(reason.to_string()));
        }
        if !went_on {
            break;
        }
        if let Some(kept) = kept.as_mut().filter(|_| rows.is_none())
            && !part.is_done()
        {
            kept.keep(part)?;
        }
    }
    drop(bar);
    rows.map_or(Ok(()), RowsFile::finish)
}
