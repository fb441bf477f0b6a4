//! `gearlash init`: a pair file to begin with.

use super::target::Target;
use crate::error::Error;
use gearlash_files::{Sources, explained};
use std::path::PathBuf;
use std::process::ExitCode;

/// Write a commented pair file to begin with
///
/// It explains every key, and runs as written; with --outline it names the drawings to put beside it. An existing file is never
/// overwritten.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair file to write, - for standard output
    #[arg(default_value = "pair.toml")]
    pair: PathBuf,
    #[command(flatten)]
    from: Template,
}

/// The kind of template.
#[derive(clap::Args)]
#[group(multiple = false)]
struct Template {
    /// Short: for what a drawing states, with tolerances
    #[arg(long)]
    drawing: bool,
    /// Short: for measured gears
    #[arg(long)]
    measured: bool,
    /// Short: for gears by their drawn outlines
    #[arg(long)]
    outline: bool,
}

impl Template {
    /// Example values, which the schema explains.
    fn examples(&self) -> &'static str {
        match self {
            Template { drawing: true, .. } => include_str!("init/drawing.toml"),
            Template { measured: true, .. } => include_str!("init/measured.toml"),
            Template { outline: true, .. } => include_str!("init/outline.toml"),
            _ => include_str!("init/pair.toml"),
        }
    }
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    Target::prepare_new(&args.pair, &Sources::new(), "init")?
        .write(&explained(args.from.examples()))?;
    Ok(ExitCode::SUCCESS)
}
