//! `gearlash init`, `schema`, `completions` and `man`: what is needed around the program, made from its own definitions.

use crate::Cli;
use crate::console::print;
use crate::error::Error;
use crate::output::Target;
use clap::{CommandFactory, ValueEnum};
use clap_complete::Shell;
use gearlash_input::{explained, gear_schema, pair_schema};
use gearlash_text::Sources;
use std::path::PathBuf;

/// Write a commented pair file to begin with
///
/// It explains every key, and runs as written; with --outline it names the drawings to put beside it. An existing file is never
/// overwritten.
#[derive(clap::Args)]
pub(super) struct InitArgs {
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

/// Runs `init`.
pub(super) fn init(args: &InitArgs) -> Result<u8, Error> {
    Target::prepare_new(&args.pair, &Sources::default(), "init")?
        .write(&explained(args.from.examples()))?;
    Ok(0)
}

/// Print the JSON Schema of a pair file or a gear file, for editors
///
/// Draft 07. With Taplo (Even Better TOML) write `#:schema ./gearlash.schema.json` into the first line of
/// a pair file, and `gearlash schema > gearlash.schema.json` beside it. The program checks more than a
/// schema can say.
#[derive(clap::Args)]
pub(super) struct SchemaArgs {
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

/// Runs `schema`.
pub(super) fn schema(args: &SchemaArgs) -> Result<u8, Error> {
    print(&match args.files {
        Files::Pair => pair_schema(),
        Files::Gear => gear_schema(),
    })?;
    Ok(0)
}

/// Print a shell's completions of this command line
///
/// For bash: gearlash completions bash > ~/.local/share/bash-completion/completions/gearlash
#[derive(clap::Args)]
pub(super) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

/// Runs `completions`.
pub(super) fn completions(args: &CompletionsArgs) -> Result<u8, Error> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "gearlash", &mut script);
    print(&String::from_utf8_lossy(&script))?;
    Ok(0)
}

/// Print a manual page
///
/// To read one: gearlash man simulate | man -l -
#[derive(clap::Args)]
pub(super) struct ManArgs {
    /// The command [default: gearlash itself]
    command: Option<String>,
}

/// Runs `man`.
pub(super) fn man(args: &ManArgs) -> Result<u8, Error> {
    let program = crate::command_line();
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
    Ok(0)
}
