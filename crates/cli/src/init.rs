//! `gearlash init`: a pair file to begin with.

use super::target::Target;
use crate::error::Error;
use gearlash_files::Sources;
use std::path::PathBuf;
use std::process::ExitCode;

const PAIR: &str = include_str!("init_pair.toml");

/// Write a commented pair file to begin with
///
/// It runs as written and explains every key. An existing file is never overwritten.
#[derive(clap::Args)]
pub(super) struct Args {
    /// The pair file to write, - for standard output
    #[arg(default_value = "pair.toml")]
    pair: PathBuf,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    if args.pair.exists() {
        return Err(Error::Usage(format!(
            "{}: already exists, and init never overwrites; name another, or remove it",
            args.pair.display()
        )));
    }
    Target::prepare(args.pair.clone(), &Sources::new())?.write(PAIR)?;
    Ok(ExitCode::SUCCESS)
}
