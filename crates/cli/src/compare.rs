//! `gearlash compare`: judges pairs in a CI run; the difference of two outlines of one gear.

use crate::console::{check_streams_not_input, print, print_error_line, warn};
use crate::cycle::failed_checks;
use crate::error::{Error, exit_code};
use crate::judged::{self, JudgedFormat, print_outcome};
use crate::options::{DrawnArgs, MethodArgs, ScreenArgs, agreement, is_drawing, not_two_drawings};
use crate::output::Target;
use crate::progress::Progress;
use clap::ValueEnum;
use clap::builder::PossibleValue;
use gearlash::analysis::extremes::{extremes, run_count};
use gearlash::analysis::tally::{MOST_UNPROVEN, Piece, simulate_by_blocks};
use gearlash_input::PairFile;
use gearlash_render::outline_difference;
use gearlash_results::judged::Judgement;
use gearlash_results::text::difference_text;
use gearlash_results::{ComparedPair, comparison_json, difference_csv};
use std::path::{Path, PathBuf};

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
    #[arg(long, value_enum, default_value_t = Format::Judged(JudgedFormat::Text))]
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

#[derive(Clone, Copy, PartialEq)]
enum Format {
    Judged(JudgedFormat),
    /// The CSV of two compared drawings.
    Csv,
}

impl ValueEnum for Format {
    fn value_variants<'a>() -> &'a [Format] {
        &[
            Format::Judged(JudgedFormat::Text),
            Format::Judged(JudgedFormat::Json),
            Format::Judged(JudgedFormat::Junit),
            Format::Judged(JudgedFormat::Github),
            Format::Judged(JudgedFormat::Markdown),
            Format::Csv,
        ]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (name, help) = match self {
            Format::Judged(JudgedFormat::Junit) => ("junit", "JUnit XML: one suite per file"),
            Format::Judged(format) => return format.to_possible_value(),
            Format::Csv => (
                "csv",
                "Only for two drawings: how far B lies from A, a row for each place along A",
            ),
        };
        Some(PossibleValue::new(name).help(help))
    }
}

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    if let Some(tolerance) = args.tolerance_um
        && !(tolerance >= 0.0 && tolerance.is_finite())
    {
        return Err(Error::Usage(format!(
            "--tolerance-um {tolerance}: a tolerance is a number of µm, 0 or more"
        )));
    }
    let slip = args
        .tolerance_um
        .and_then(|um| gearlash_input::tolerance_slip("--tolerance-um", um));
    if let Some(warning) = slip {
        print_error_line(&format!("warning: {warning}"));
    }
    if args.markdown.is_some() {
        return Err(Error::usage(
            "--markdown: use --format markdown, which prints the table; with --format github it goes to $GITHUB_STEP_SUMMARY",
        ));
    }
    if args.pairs.iter().any(|path| is_drawing(path)) {
        return drawings(args);
    }
    if args.drawn.given() || args.svg.is_some() {
        return Err(Error::Usage(format!(
            "{}, and --svg belong to two drawings; leave them out",
            DrawnArgs::NAMES
        )));
    }
    let Format::Judged(format) = args.format else {
        return Err(Error::usage(
            "--format csv belongs to two drawings; of a pair file, `gearlash simulate FILE --format csv` writes simulated and analytic backlash of each pose",
        ));
    };
    let files = judged::read(&args.pairs, gearlash_input::read_by_data)?;
    let mut steps = 0;
    for file in files.iter().filter_map(|(_, file)| file.as_ref().ok()) {
        steps += file.study.pose_count() + run_count(&file.study)?;
    }
    let unproven = MOST_UNPROVEN / files.len();
    let progress = Progress::of(steps, "steps");
    let judge = |path: &Path, file: &PairFile| compared(args, path, file, unproven, &progress);
    let (outcome, summary) = judged::outcome("compare", files, format, judge)?;
    drop(progress);
    print_outcome(&outcome, format, &args.screen, summary.as_deref())
}

/// Compares one pair; keeps at most `unproven` of its unproven poses.
fn compared(
    args: &Args,
    path: &Path,
    file: &PairFile,
    unproven: usize,
    progress: &Progress,
) -> Result<Judgement, Error> {
    let (study, method) = (&file.study, args.method.method());
    let tolerance_um = args.tolerance_um.unwrap_or(study.tolerance_um);
    let tick = |steps| progress.tick(steps);
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

/// Compares two drawings.
fn drawings(args: &Args) -> Result<u8, Error> {
    let [a, b] = match &args.pairs[..] {
        [a, b] if is_drawing(a) && is_drawing(b) => [a, b],
        paths => return Err(not_two_drawings(paths, "two drawings of one gear")),
    };
    let is_of_pairs = matches!(
        args.format,
        Format::Judged(JudgedFormat::Junit | JudgedFormat::Github | JudgedFormat::Markdown)
    );
    if args.method.given() || is_of_pairs {
        return Err(Error::usage(
            "--method, --no-certify and the formats junit, github and markdown are for pair files; leave them out",
        ));
    }
    let compared = gearlash_input::compare_drawings([a, b], args.drawn.options()?)?;
    check_streams_not_input(&compared.sources)?;
    for (k, path) in args.pairs.iter().enumerate() {
        warn(path, compared.warnings[k].as_slice(), &compared.remarks[k]);
    }
    let picture = Target::prepare_given(args.svg.as_ref(), &compared.sources);
    let picture = picture.map_err(|error| of_option(error, "--svg"))?;
    print(&match args.format {
        Format::Judged(JudgedFormat::Json) => comparison_json(&compared, args.tolerance_um),
        Format::Csv => difference_csv(&compared),
        _ => difference_text(&compared, args.tolerance_um, &args.screen.screen()),
    })?;
    if let Some(target) = picture {
        let written = target.write_silently(&outline_difference(&compared));
        written.map_err(|error| of_option(error, "--svg"))?;
    }
    Ok(exit_code(compared.passes(args.tolerance_um)))
}
