//! `gearlash merge`: parts of a run as one.

use super::console::guard;
use super::screen::ScreenArgs;
use super::tolerance::{Format, guard_earlier, is_own, tell_result};
use crate::error::Error;
use crate::output::OutputFolder;
use gearlash_files::Sources;
use gearlash_files::tolerance::{Part, PartError, ToleranceResult};
use std::path::PathBuf;
use std::process::ExitCode;

/// Put the parts of a run together that gearlash tolerance --shard wrote: the same bytes as of one run
///
/// A part that is missing, given twice, unfinished or of another run (other input, seed or version) is named, exit code 2. Exit code 1
/// where more assemblies miss the requirement than max_ppm allows.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Parts, in any order
    #[arg(required = true, value_name = "FILE")]
    parts: Vec<PathBuf>,
    /// Folder for results
    #[arg(short, long, value_name = "DIR", default_value = "out/merged")]
    output: PathBuf,
    /// What to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    screen: ScreenArgs,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let mut sources = Sources::new();
    let mut parts = Vec::new();
    for path in &args.parts {
        let name = path.display().to_string();
        let text = std::fs::read_to_string(path).map_err(|error| PartError::Invalid {
            file: name.clone(),
            reason: error.to_string(),
        })?;
        sources.add(path);
        let part = Part::from_json(&name, &text)?;
        parts.push((name, part));
    }
    guard(&sources)?;
    let folder = OutputFolder::prepare(&args.output, &sources, is_own)?;
    let result = ToleranceResult::of(Part::merged(parts)?);
    if let Some(reason) = result.part.too_many_impossible() {
        return Err(Error::Usage(reason.to_string()));
    }
    guard_earlier(&args.output, &result.part.head, None)?;
    tell_result(&result, folder, args.format, &args.screen.screen())
}
