//! `gearlash schema`: the JSON Schema with which an editor completes and checks pair and gear files.

use super::console::print;
use crate::error::Error;
use clap::ValueEnum;
use gearlash_files::{gear_schema, pair_schema};
use std::process::ExitCode;

/// Print the JSON Schema of a pair file or a gear file, for editors
///
/// Draft 07. With Taplo (Even Better TOML) write `#:schema ./gearlash.schema.json` into the first line of
/// a pair file, and `gearlash schema > gearlash.schema.json` beside it. The program checks more than a
/// schema can say.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Which kind of file
    #[arg(value_enum, default_value = "pair")]
    files: Files,
}

#[derive(Clone, Copy, ValueEnum)]
enum Files {
    /// Two gears and their assembly
    Pair,
    /// A title and one [gear], for gearlash gauge
    Gear,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    match args.files {
        Files::Pair => print(&pair_schema())?,
        Files::Gear => print(&gear_schema())?,
    }
    Ok(ExitCode::SUCCESS)
}
