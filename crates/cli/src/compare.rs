//! `gearlash compare`: the referee in a CI run.

mod drawings;

use super::console::{ScreenArgs, print, tell};
use super::method::{MethodArgs, agreement};
use super::outlines::{DrawnArgs, is_drawing};
use super::progress::Progress;
use super::studies;
use super::target::Target;
use crate::error::{Error, exit_code};
use clap::ValueEnum;
use gearlash::analysis::compare::tolerance_um;
use gearlash::analysis::diagnosis::{Seen, failed_checks};
use gearlash::analysis::extremes::{extremes, run_count};
use gearlash::analysis::tally::{MOST_UNPROVEN, simulate_by_blocks};
use gearlash_files::Sources;
use gearlash_results::comparison;
use gearlash_results::{ComparedPair, comparison_json};
use std::io::Write;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Compare simulated with analytic backlash, or two outlines of one gear; exit 1 when they disagree or a [require] is not met
///
/// Model 3 (line of action) decides: a pose fails when |simulated − model 3| exceeds tolerance + error
/// bound. Contact off the line of action (tip corner, fillet, root) leaves less backlash than the formula
/// gives. That fails too, and is named, unless the pair file says allow_off_line_contact = true. A centre
/// distance where every pose is jammed or out of mesh fails as well: there is nothing to compare.
///
/// Two drawings A and B (.dxf, .svg, .csv) are taken as outlines of the same gear: how far B lies from A along the normal, once B is
/// turned to fit best. With --tolerance-um, exit 1 where that is more than tolerance + error bound.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair files (TOML or JSON), - for standard input; or two drawings (.dxf, .svg, .csv) of one gear
    #[arg(required = true)]
    pairs: Vec<PathBuf>,
    /// Tolerance in µm, of j_wt [default: the pair file's, or 0.1] or between two drawings [default: none]
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    tolerance_um: Option<f64>,
    /// What to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Also write the outcome as a Markdown table
    ///
    /// With --format github it goes to the step summary ($GITHUB_STEP_SUMMARY), too.
    #[arg(long, value_name = "FILE")]
    markdown: Option<PathBuf>,
    #[command(flatten)]
    drawn: DrawnArgs,
    /// Also draw the difference of two drawings
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    #[command(flatten)]
    screen: ScreenArgs,
    #[command(flatten)]
    method: MethodArgs,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Format {
    /// One line per run
    Text,
    /// The same as JSON
    Json,
    /// JUnit XML: one suite per file, one case per run
    Junit,
    /// GitHub annotations
    Github,
    /// Of two drawings: how far B lies from A, a row for each place along A
    Csv,
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
        tell(&format!("warning: {warning}"));
    }
    if args.pairs.iter().any(|path| is_drawing(path)) {
        return drawings::run(args);
    }
    if args.drawn.given() || args.svg.is_some() || args.format == Format::Csv {
        return Err(Error::Usage(
            "--units, --center, --svg and --format csv belong to two drawings; leave them out"
                .to_owned(),
        ));
    }
    let files = studies::each(&args.pairs, studies::pair)?;
    let mut sources = Sources::new();
    for file in &files {
        sources.extend(&file.sources);
    }
    let markdown = Target::prepare_given(args.markdown.as_ref(), &sources);
    let markdown = markdown.map_err(|error| of_option(error, "--markdown"))?;
    let summary = summary(args.format, &sources)?;
    let mut steps = 0;
    for file in &files {
        steps += file.study.pose_count() + run_count(&file.study)?;
    }
    let progress = Progress::of(steps, "steps");
    let (mut pairs, each) = (Vec::new(), MOST_UNPROVEN / files.len());
    for (path, file) in args.pairs.iter().zip(files) {
        let study = file.study;
        let tolerance_um = tolerance_um(&study, args.tolerance_um);
        let runs = simulate_by_blocks(
            &study,
            args.method.method(),
            tolerance_um,
            each,
            &|| progress.tick(),
            &mut |_| Ok::<(), Error>(()),
        )?;
        let method = args.method.method();
        let found = progress.searching(|| extremes(&study, method, &|| progress.tick()))?;
        let seen: Vec<Seen> = runs.iter().map(|run| run.seen.clone()).collect();
        let failed = failed_checks(&study, &seen, &found, &|| ControlFlow::Continue(()))?;
        pairs.push(ComparedPair {
            file: path.display().to_string(),
            title: study.title,
            tolerance_um,
            allow_off_line: study.allow_off_line_contact,
            runs,
            extremes: found.each,
            failed_checks: failed,
            requirements: study.requirements,
            uncertainty: study.uncertainty,
        });
    }
    drop(progress);
    print(&match args.format {
        // CSV is of drawings, refused above.
        Format::Text | Format::Csv => comparison::text(&pairs, &args.screen.screen()),
        Format::Json => comparison_json(&pairs).map_err(Error::unwritable("the outcome"))?,
        Format::Junit => comparison::junit(&pairs).map_err(Error::unwritable("the outcome"))?,
        Format::Github => comparison::github(&pairs),
    })?;
    if let Some(target) = markdown {
        let written = target.write_silently(&comparison::markdown(&pairs));
        written.map_err(|error| of_option(error, "--markdown"))?;
    }
    if let Some(summary) = summary {
        append(&summary, &comparison::markdown(&pairs))?;
    }
    let agree = agreement(pairs.iter().flat_map(|pair| &pair.runs));
    Ok(exit_code(agree && pairs.iter().all(ComparedPair::passes)))
}

/// The same error, naming the option that chose the place.
fn of_option(error: Error, option: &str) -> Error {
    match error {
        Error::Output { path, source } => Error::Usage(format!(
            "{}: cannot be written: {source}; choose another place with {option}",
            path.display()
        )),
        other => other,
    }
}

/// The step summary, where it is to be written; never one of `sources`.
fn summary(format: Format, sources: &Sources) -> Result<Option<PathBuf>, Error> {
    let (Format::Github, Some(summary)) = (format, std::env::var_os("GITHUB_STEP_SUMMARY")) else {
        return Ok(None);
    };
    let summary = PathBuf::from(summary);
    match sources.named(&summary) {
        None => Ok(Some(summary)),
        Some(input) => Err(Error::OverInput {
            input: input.to_path_buf(),
            output: summary,
        }),
    }
}

/// Adds `text` to a step summary; what earlier steps wrote stays.
fn append(summary: &Path, text: &str) -> Result<(), Error> {
    let mut options = std::fs::OpenOptions::new();
    let file = options.append(true).create(true).open(summary);
    file.and_then(|mut file| file.write_all(text.as_bytes()))
        .map_err(|source| {
            Error::Usage(format!(
                "GITHUB_STEP_SUMMARY={}: cannot be written: {source}; unset the variable, or have --markdown FILE alone",
                summary.display()
            ))
        })
}
