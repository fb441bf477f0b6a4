//! `gearlash compare`: judges pairs in a CI run.

mod drawings;

use super::console::{ScreenArgs, print_error_line};
use super::judged::{self, JudgedFormat, print_outcome};
use super::method::{MethodArgs, agreement};
use super::outlines::{DrawnArgs, is_drawing};
use super::progress::Progress;
use super::studies;
use super::verdict::failed_checks;
use crate::error::Error;
use clap::ValueEnum;
use gearlash::analysis::compare::tolerance_um;
use gearlash::analysis::extremes::{extremes, run_count};
use gearlash::analysis::tally::{MOST_UNPROVEN, Piece, simulate_by_blocks};
use gearlash_files::PairFile;
use gearlash_results::ComparedPair;
use gearlash_results::judged::Judged;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Compare simulated with analytic backlash, or two outlines of one gear
///
/// Model 3 (line of action) decides: a pose fails when |simulated − model 3| exceeds tolerance + error
/// bound. Contact off the line of action (tip corner, fillet, root) leaves less backlash than the formula
/// gives. That fails too, and is named, unless the pair file says allow_off_line_contact = true. A centre
/// distance where every pose is jammed or out of mesh fails as well: there is nothing to compare.
///
/// Two drawings A and B (.dxf, .svg, .csv, .txt) are taken as outlines of the same gear: how far B lies from A along the normal, once B is
/// turned to fit best. With --tolerance-um, exit 1 where that is more than tolerance + error bound.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair files, - for standard input; or two drawings (.dxf, .svg, .csv, .txt) of one gear
    #[arg(required = true)]
    pairs: Vec<PathBuf>,
    /// Tolerance, µm [default: the pair file's, or 0.1; of drawings none]
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    tolerance_um: Option<f64>,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Gone: --format markdown
    #[arg(long, hide = true, value_name = "FILE")]
    markdown: Option<PathBuf>,
    #[command(flatten)]
    drawn: DrawnArgs,
    /// Also draw the difference of drawings
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    #[command(flatten)]
    screen: ScreenArgs,
    #[command(flatten)]
    method: MethodArgs,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Format {
    /// One file in full; of several a line for each that passes
    Text,
    /// One object with a list of files, of one file as of several
    Json,
    /// JUnit XML: one suite per file
    Junit,
    /// GitHub annotations; the Markdown goes to the step summary ($GITHUB_STEP_SUMMARY)
    Github,
    /// Markdown for reviewers
    Markdown,
    /// Only for two drawings: how far B lies from A, a row for each place along A
    Csv,
}

impl Format {
    /// The format for pair files; `None` for a format of drawings alone.
    fn of_pairs(self) -> Option<JudgedFormat> {
        Some(match self {
            Format::Text => JudgedFormat::Text,
            Format::Json => JudgedFormat::Json,
            Format::Junit => JudgedFormat::Junit,
            Format::Github => JudgedFormat::Github,
            Format::Markdown => JudgedFormat::Markdown,
            Format::Csv => return None,
        })
    }
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    if let Some(tolerance) = args.tolerance_um
        && !(tolerance >= 0.0 && tolerance.is_finite())
    {
        return Err(Error::Usage(format!(
            "--tolerance-um {tolerance}: a tolerance is a number of µm, 0 or more"
        )));
    }
    let slip = args
        .tolerance_um
        .and_then(|um| gearlash_files::tolerance_slip("--tolerance-um", um));
    if let Some(warning) = slip {
        print_error_line(&format!("warning: {warning}"));
    }
    if args.markdown.is_some() {
        return Err(Error::usage(
            "--markdown: use --format markdown, which prints the table; with --format github it goes to $GITHUB_STEP_SUMMARY",
        ));
    }
    if args.pairs.iter().any(|path| is_drawing(path)) {
        return drawings::run(args);
    }
    let Some(format) = args.format.of_pairs() else {
        return Err(of_drawings());
    };
    if args.drawn.given() || args.svg.is_some() {
        return Err(of_drawings());
    }
    let files = judged::read(&args.pairs, studies::pair_by_data)?;
    let mut steps = 0;
    for file in files.iter().filter_map(|(_, file)| file.as_ref().ok()) {
        steps += file.study.pose_count() + run_count(&file.study)?;
    }
    let unproven = MOST_UNPROVEN / files.len();
    let progress = Progress::of(steps, "steps");
    let judge = |path: &Path, file: &PairFile| compared(args, path, file, unproven, &progress);
    let (outcome, summary) = judged::outcome("compare", files, format, judge)?;
    drop(progress);
    print_outcome(&outcome, format, &args.screen, &summary)
}

fn of_drawings() -> Error {
    Error::Usage(format!(
        "{}, --svg and --format csv belong to two drawings; leave them out",
        DrawnArgs::NAMES
    ))
}

/// Compares one pair; keeps at most `unproven` of its unproven poses.
fn compared(
    args: &Args,
    path: &Path,
    file: &PairFile,
    unproven: usize,
    progress: &Progress,
) -> Result<Judged, Error> {
    let (study, method) = (&file.study, args.method.method());
    let tolerance_um = tolerance_um(study, args.tolerance_um);
    let tick = || progress.tick();
    let none = &mut |_: Piece| Ok::<(), Error>(());
    let runs = simulate_by_blocks(study, method, tolerance_um, unproven, &tick, none)?;
    let found = progress.searching(|| extremes(study, method, &tick))?;
    let failed_checks = failed_checks(study, &runs, &found)?;
    let is_proven = agreement(&runs);
    let pair = ComparedPair {
        name: path.display().to_string(),
        file,
        tolerance_um,
        is_proven,
        runs,
        extremes: found.each,
        failed_checks,
    };
    Ok(pair.judged(&args.screen.screen()))
}

/// `error`, with the option that chose the place in its message.
fn of_option(error: Error, option: &str) -> Error {
    match error {
        Error::Output { path, source } => Error::Usage(format!(
            "{}: cannot be written: {source}; choose another place with {option}",
            path.display()
        )),
        other => other,
    }
}
