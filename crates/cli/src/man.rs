//! `gearlash man`: manual pages, generated from the definition of the command line.

use super::console::print;
use crate::error::Error;
use std::process::ExitCode;

/// Print a manual page
///
/// To read one: gearlash man simulate | man -l -
#[derive(clap::Args)]
pub(super) struct Args {
    /// The command [default: gearlash itself]
    command: Option<String>,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let program = super::command_line();
    let page = match &args.command {
        None => program,
        Some(name) => program.find_subcommand(name).cloned().ok_or_else(|| {
            Error::Usage(format!(
                "man: there is no command {name:?}; gearlash --help lists all"
            ))
        })?,
    };
    let mut text = Vec::new();
    clap_mangen::Man::new(page)
        .render(&mut text)
        .map_err(Error::Printing)?;
    print(&String::from_utf8_lossy(&text))?;
    Ok(ExitCode::SUCCESS)
}
