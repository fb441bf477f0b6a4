//! `gearlash schema`: what an editor needs to complete and check pair files.

use super::print;
use crate::error::Error;
use crate::input::PAIR_SCHEMA;
use std::process::ExitCode;

/// Print the JSON Schema of pair files, for editors
///
/// Draft 07. With Taplo (Even Better TOML) write `#:schema ./gearlash.schema.json` into the first line of
/// a pair file, and `gearlash schema > gearlash.schema.json` beside it. The program checks more than a
/// schema can say.
#[derive(clap::Args)]
pub(super) struct Args {}

/// Runs the command.
pub(super) fn run(_: &Args) -> Result<ExitCode, Error> {
    print(PAIR_SCHEMA);
    Ok(ExitCode::SUCCESS)
}
