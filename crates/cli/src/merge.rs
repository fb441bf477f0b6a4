//! `gearlash merge`: parts of a run as one.

use super::console::{ScreenArgs, guard};
use super::matching;
use super::tolerance::{Format, guard_earlier, is_own, tell_result};
use crate::error::Error;
use crate::output::OutputFolder;
use gearlash_files::matching::MatchPart;
use gearlash_files::tolerance::{Part, ToleranceResult};
use gearlash_files::{PartError, Parts, Sources};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Put the parts of a run together that gearlash tolerance --shard or gearlash match --shard wrote: the same bytes as of one run
///
/// A part that is missing, given twice, unfinished or of another run (other input, seed or version, or numbers that are not the same to the last bit) is
/// named, exit code 2. Writes what that command writes. Exit code 1 where more assemblies miss the requirement than max_ppm allows, or a gear is left over
/// that had a mate.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Parts, in any order
    #[arg(required = true, value_name = "FILE")]
    parts: Vec<PathBuf>,
    /// Folder for results [default: out/merged; with --format json or csv none]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// What to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    screen: ScreenArgs,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let mut sources = Sources::new();
    let mut files = Vec::new();
    for path in &args.parts {
        let name = path.display().to_string();
        let text = std::fs::read_to_string(path).map_err(|error| PartError::Invalid {
            file: name.clone(),
            reason: error.to_string(),
        })?;
        sources.add(path);
        files.push((name, text));
    }
    let parts = Parts::read(files)?;
    guard(&sources)?;
    let folder = args
        .format
        .folder(args.output.as_deref(), Path::new("out/merged"), None);
    let screen = args.screen.screen();
    let prepare = |is_own: fn(&str) -> bool| {
        let folder = folder.as_ref();
        let prepared = folder.map(|folder| OutputFolder::prepare(folder, &sources, is_own));
        prepared.transpose()
    };
    match parts {
        Parts::Tolerance(parts) => {
            let prepared = prepare(is_own)?;
            let result = ToleranceResult::of(Part::merged(parts)?);
            if let Some(reason) = result.part.too_many_impossible() {
                return Err(Error::Usage(reason.to_string()));
            }
            if let Some(folder) = &folder {
                guard_earlier(folder, &result.part.head, None)?;
            }
            tell_result(&result, prepared, args.format, &screen)
        }
        Parts::Match(parts) => {
            let prepared = prepare(matching::is_own)?;
            matching::tell_match(MatchPart::merged(parts)?, prepared, args.format, &screen)
        }
    }
}
