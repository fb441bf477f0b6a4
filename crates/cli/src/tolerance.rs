//! `gearlash tolerance`: what share of a population meets its requirement, and what it depends on.

mod earlier;
mod parquet;
mod results;
mod rows;

use super::console::{guard, print_note, tell, warn};
use super::progress::Progress;
use super::screen::ScreenArgs;
use super::signals;
use crate::error::Error;
use crate::output::{OutputFile, OutputFolder};
use gearlash::population::{CHUNK, SampleError};
use gearlash_files::Sources;
use gearlash_files::tolerance::{
    BlockError, MOST_ASSEMBLIES, MOST_SHARDS, Part, ToleranceFile, ToleranceResult, read_tolerance,
};
use rows::RowsFile;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

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

/// `K/N`.
fn shard(text: &str) -> Result<[u64; 2], String> {
    let parts = text.split_once('/');
    let parts = parts.and_then(|(k, n)| Some([k.parse().ok()?, n.parse().ok()?]));
    match parts {
        Some([k, n]) if 1 <= k && k <= n && n <= MOST_SHARDS => Ok([k, n]),
        _ => Err(format!(
            "expected K/N, such as 3/64, with K from 1 to N and N up to {MOST_SHARDS}"
        )),
    }
}

/// How often what is done is kept (tuned: a part takes some milliseconds to write).
const KEPT_EVERY: Duration = Duration::from_secs(1);

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
    // Many parts go to one folder, from many processes; a whole run has its folder for itself.
    let (folder, name) = match args.shard {
        Some([k, n]) => (
            Some(named.unwrap_or(&own).to_path_buf()),
            format!("part_{k}_of_{n}.json"),
        ),
        None => (args.format.folder(named, &own), results::PART.to_owned()),
    };
    let kept = folder.as_ref().map(|folder| Kept {
        path: folder.join(name),
        sources,
    });
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
    work(&file, &mut part, kept.as_ref(), rows)?;
    if let (Some(kept), Some(_)) = (&kept, args.shard) {
        kept.write(&part)?;
        print_note(&format!(
            "{}: part {} of {}\n",
            kept.path.display(),
            shard[0],
            shard[1]
        ))?;
        return Ok(ExitCode::SUCCESS);
    }
    let result = ToleranceResult::of(part);
    tell_result(&result, prepared, args.format, &args.screen.screen())
}

/// Does all of `part` that is left, and keeps what is done from time to time.
fn work(
    file: &ToleranceFile,
    part: &mut Part,
    kept: Option<&Kept>,
    mut rows: Option<RowsFile>,
) -> Result<(), Error> {
    let steps = |length: u64, done: u64, chunk: u64| length.saturating_sub(done).div_ceil(chunk);
    let length = |range: std::ops::Range<u64>| range.end - range.start;
    let left = steps(length(part.head.numbers()), part.done.assemblies, CHUNK)
        + steps(length(part.head.rows()), part.done.rows, 8);
    let bar = Progress::of(left, "steps");
    let mut last = Instant::now();
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
        if let Some(kept) = kept.filter(|_| rows.is_none())
            && last.elapsed() > KEPT_EVERY
            && !part.is_done()
        {
            kept.write(part)?;
            signals::has_kept(format!(
                "{} of {numbers} assemblies are kept in {}: the same command goes on from there",
                part.done.assemblies,
                kept.path.display()
            ));
            last = Instant::now();
        }
    }
    drop(bar);
    rows.map_or(Ok(()), RowsFile::finish)
}

/// Where what is done of a run is kept.
struct Kept<'a> {
    path: PathBuf,
    sources: &'a Sources,
}

impl Kept<'_> {
    /// What is kept of the run of `begun`; `begun` itself where nothing is.
    fn found(&self, begun: Part) -> Part {
        let name = self.path.display().to_string();
        let found = match std::fs::read_to_string(&self.path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return begun,
            Err(error) => Err(error.to_string()),
            Ok(text) => Part::from_json(&name, &text).map_err(|error| error.to_string()),
        };
        let found = match found {
            Ok(found) => found,
            Err(reason) => {
                // Which names the file, but for what the system says.
                let reason = reason.strip_prefix(&format!("{name}: ")).unwrap_or(&reason);
                tell(&format!(
                    "note: {name}: what was kept there cannot be gone on from, and is done again: {reason}"
                ));
                return begun;
            }
        };
        if found.head != begun.head || found.about != begun.about {
            tell(&format!("note: {name} is of another run, and is replaced"));
            return begun;
        }
        if found.done.assemblies > 0 {
            tell(&format!(
                "note: {name}: goes on after {} assemblies",
                found.done.assemblies
            ));
        }
        found
    }

    fn write(&self, part: &Part) -> Result<(), Error> {
        OutputFile::prepare(&self.path, self.sources)?.write(&part.to_json())
    }
}
