//! `gearlash import`: a file of another program, what was understood of it and the pair file it makes.

use super::rexs::{self, RexsArgs};
use super::screen::ScreenArgs;
use crate::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

/// Show what is understood of a gearbox model (REXS), and the pair file that a stage of it makes
///
/// Stages of external spur gears become pair files; everything else is named and left out. Versions 1.0 to 2.0, XML and JSON, and
/// the same zipped.
#[derive(clap::Args)]
pub(super) struct Args {
    /// The file (.rexs, .rexsj, .rexsz), - for standard input
    file: PathBuf,
    #[command(flatten)]
    rexs: RexsArgs,
    #[command(flatten)]
    screen: ScreenArgs,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    rexs::import(&args.file, &args.rexs, &args.screen.screen())
}
