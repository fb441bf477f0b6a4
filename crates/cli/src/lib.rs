//! The command line: one file per command. The binary and the Python package run the same program.

mod chart;
mod check;
mod compare;
mod console;
mod cycle;
mod date;
mod distances;
mod error;
mod explain;
mod gauge;
mod import;
mod input;
mod judged;
mod maps;
mod matching;
mod options;
mod outline;
mod output;
mod progress;
mod removed;
mod report;
mod setup;
mod signals;
mod simulate;
mod snapshot;
mod tolerance;

use crate::error::Error;
use clap::{CommandFactory, Parser, Subcommand};
use console::{print, print_error_text, print_note_line};
use gearlash_text::characters::plain;
use std::ffi::OsString;
use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};

/// Backlash of a measured gear pair, found by turning one gear's true outline against the other's.
///
/// A pair file (TOML, or JSON with the same keys) states two gears, what was measured on them, and how
/// they are assembled. gearlash builds the real tooth outlines, locks one gear and turns the other to
/// right-flank and to left-flank contact. The angle between is the lost motion; as an arc of the
/// operating pitch circle it is the circumferential backlash j_wt. Negative: the pair interferes.
#[derive(Parser)]
#[command(name = "gearlash", version, max_term_width = 100, after_help = EXIT_CODES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Print only results, warnings and errors
    #[arg(short, long, global = true)]
    quiet: bool,
    /// Print notes, too
    #[arg(short, long, global = true, conflicts_with = "quiet")]
    verbose: bool,
}

const EXIT_CODES: &str = "\
Exit codes: 0 done; 1 a comparison or a check failed, a requirement is not met or not proven, or a pose is unproven;
2 bad input or usage: nothing is written, but check and compare of several files report the others.
Results go to standard output and to files; progress, warnings and errors to standard error.

Example:
  gearlash simulate fixtures/karba_44x44.toml
  gearlash snapshot fixtures/karba_44x44.toml --mating 11,11 --flank right
  gearlash snapshot fixtures/karba_44x44.toml --worst
  gearlash chart fixtures/karba_44x44.toml --kind distance --mating 44,44";

/// The commands. Their arguments have the descriptions.
#[derive(Subcommand)]
enum Command {
    Simulate(simulate::Args),
    Compare(compare::Args),
    Check(check::Args),
    Snapshot(snapshot::Args),
    Gauge(gauge::Args),
    Outline(outline::Args),
    Tolerance(tolerance::Args),
    Match(matching::Args),
    Chart(chart::Args),
    Report(report::Args),
    Import(import::Args),
    Init(setup::InitArgs),
    Schema(setup::SchemaArgs),
    Completions(setup::CompletionsArgs),
    Man(setup::ManArgs),
}

/// Runs the program with its command line `words`, its name first. It prints to this process's standard output and error.
///
/// It permanently takes over the signals that end a process, so call it at the beginning of a program. A signal ends the process.
/// Calls in several threads run one after another.
pub fn run(words: impl IntoIterator<Item = OsString>) -> ExitCode {
    // Unfinished files and verbosity are those of the process.
    static ALONE: Mutex<()> = Mutex::new(());
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    signals::handle();
    let words: Vec<OsString> = words.into_iter().collect();
    let ended = match parse(&words) {
        Ok(cli) => {
            console::set(cli.quiet, cli.verbose);
            cap_threads();
            command(cli.command)
        }
        Err(usage) => removed::error(&words).map_or_else(|| help(&usage), Err),
    };
    drop(output::remove_unfinished());
    let code = ended.unwrap_or_else(|error| {
        print_error_text(&explain::explain(&error));
        error.exit_code()
    });
    code.into()
}

/// The definition of the command line; commands have their full names and the common options.
pub fn command_line() -> clap::Command {
    let mut program = Cli::command();
    program.build();
    program
}

fn command(command: Command) -> Result<u8, Error> {
    match command {
        Command::Simulate(args) => simulate::run(&args),
        Command::Compare(args) => compare::run(&args),
        Command::Check(args) => check::run(&args),
        Command::Snapshot(args) => snapshot::run(&args),
        Command::Gauge(args) => gauge::run(&args),
        Command::Outline(args) => outline::run(&args),
        Command::Import(args) => import::run(&args),
        Command::Init(args) => setup::init(&args),
        Command::Schema(args) => setup::schema(&args),
        Command::Completions(args) => setup::completions(&args),
        Command::Man(args) => setup::man(&args),
        Command::Tolerance(args) => tolerance::run(&args),
        Command::Match(args) => matching::run(&args),
        Command::Chart(args) => chart::run(&args),
        Command::Report(args) => report::run(&args),
    }
}

/// Threads that are allowed beyond the cores of the machine. Each takes 2 MiB of address space and time to start. Threads beyond
/// the cores are only useful to test that results stay equal.
const MAX_THREADS: usize = 64;

/// Limits `RAYON_NUM_THREADS` to what a machine can start.
fn cap_threads() {
    let variable = std::env::var("RAYON_NUM_THREADS").ok();
    let wanted: Option<usize> = variable.and_then(|threads| threads.parse().ok());
    let cores = std::thread::available_parallelism().map_or(1, |cores| cores.get());
    let most = MAX_THREADS.max(cores);
    if let Some(wanted) = wanted.filter(|wanted| *wanted > most) {
        // Fails where a pool exists already; that one is not too large.
        let _ = rayon::ThreadPoolBuilder::new()
            .num_threads(most)
            .build_global();
        print_note_line(&format!(
            "note: RAYON_NUM_THREADS={wanted}: {most} threads are used, the most that make sense on this machine"
        ));
    }
}

/// The parsed command line. A usage error quotes arguments, which can be file names that a shell filled in. Unsafe characters
/// are removed from them.
fn parse(words: &[OsString]) -> Result<Cli, clap::Error> {
    Cli::try_parse_from(words).map_err(|error| {
        let words = words.iter().map(|word| plain(&word.to_string_lossy()));
        Cli::try_parse_from(words).err().unwrap_or(error)
    })
}

/// Prints the text for --help or --version, or the usage error.
fn help(usage: &clap::Error) -> Result<u8, Error> {
    if usage.use_stderr() {
        let _ = usage.print();
        return Ok(2);
    }
    let screen = options::ScreenArgs::default().screen();
    let styled = screen.colour.then(|| usage.render().ansi().to_string());
    print(&screen.fold(&styled.unwrap_or_else(|| usage.render().to_string())))?;
    Ok(0)
}
