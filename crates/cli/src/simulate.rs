//! `gearlash simulate`: the lost motion at every pose of a pair file.

use crate::console::{Printer, print};
use crate::cycle::failed_checks;
use crate::distances::{self, Distances};
use crate::error::{Error, exit_code};
use crate::input;
use crate::options::{Format, MethodArgs, ResultsArgs, ScreenArgs, UnitArgs, agreement};
use crate::output::OutputFolder;
use crate::progress::Progress;
use gearlash::analysis::extremes::{extremes, run_count};
use gearlash::analysis::measured::MeasuredTally;
use gearlash::analysis::study::Study;
use gearlash::analysis::tally::{MOST_UNPROVEN, Piece, RunTally, simulate_by_blocks};
use gearlash::analysis::verdict::Verdict;
use gearlash_input::distance_refused;
use gearlash_input::{POSE_BYTES_CSV, POSE_BYTES_JSON};
use gearlash_render::pose_picture;
use gearlash_results::{ResultWriter, drawn_notes};
use std::io::{IsTerminal, Write};
use std::path::PathBuf;

/// Find the lost motion at every pose a pair file asks for
///
/// Prints the verdict and a table, and writes DIR/result.json, DIR/result.csv and DIR/worst.svg, a snapshot of the pose
/// with the least backlash of the whole mesh cycle. Exit code 1 where a [require] of the pair file is not met. Up to 10 million poses (27 GB of results); from a million on the size is printed first. With --format
/// json or csv and without -o the result is streamed: it is complete only if the exit code is 0 or 1.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair file (TOML or JSON), - for standard input
    pair: PathBuf,
    /// Other centre distances, mm: one, or a scan FROM..TO:STEP
    #[arg(long, alias = "centre-distance", value_name = "A", value_parser = distances::parse, allow_hyphen_values = true)]
    center_distance: Option<Distances>,
    /// Also draw the least (a…_min.svg) and greatest (a…_max.svg) pose of each run
    #[arg(long, conflicts_with = "no_files")]
    snapshots: bool,
    #[command(flatten)]
    results: ResultsArgs,
    #[command(flatten)]
    unit: UnitArgs,
    #[command(flatten)]
    screen: ScreenArgs,
    #[command(flatten)]
    method: MethodArgs,
}

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    let mut pair = input::pair(&args.pair)?;
    if let Some(Distances(distances)) = &args.center_distance {
        let moved = pair.at(distances.clone());
        pair = moved.map_err(|reason| {
            let reason = distance_refused(&reason);
            Error::Usage(format!("--center-distance: {reason}"))
        })?;
    }
    let file = &pair;
    let study = &file.study;
    let method = args.method.of(study)?;
    let unit = args
        .unit
        .of_table(study, args.results.format == Format::Text)?;
    input::allow(&args.pair, study.pose_count(), &input::STREAMED)?;
    // Tried before the simulation, not after it.
    let mut folder = args.results.folder(&file.stem, &file.sources, is_own)?;
    let (bytes, streamed) = match args.results.format {
        _ if folder.is_some() => (POSE_BYTES_JSON + POSE_BYTES_CSV, false),
        Format::Csv => (POSE_BYTES_CSV, true),
        Format::Json => (POSE_BYTES_JSON, true),
        Format::Text => (0, false),
    };
    input::report_size(study.pose_count(), bytes);

    // A streamed result appears on the terminal itself.
    let progress = if streamed && std::io::stdout().is_terminal() {
        Progress::none()
    } else {
        Progress::of(study.pose_count() + run_count(study)?, "steps")
    };
    let tick = |steps| progress.tick(steps);
    let found = progress.searching(|| extremes(study, method, &tick))?;
    let [json, csv] = outputs(args.results.format, folder.as_mut())?;
    let mut writer = ResultWriter::begin(file, json, csv).map_err(unwritable)?;
    let mut measured = MeasuredTally::new(study);
    let each = &mut |piece: Piece| {
        match piece {
            Piece::Begin(run) => measured.begin(run.assembly.center_distance(), run.material),
            Piece::Poses(_, poses) => measured.add(poses),
            Piece::End(_) => {}
        }
        writer.take(piece).map_err(unwritable)
    };
    let tolerance = study.tolerance_um;
    let runs = simulate_by_blocks(study, method, tolerance, MOST_UNPROVEN, &tick, each)?;
    let failed = failed_checks(study, &runs, &found)?;
    let verdict = Verdict::of_study(study, &found.each, failed);
    writer.finish(&verdict).map_err(unwritable)?;
    drop(progress);

    match (args.results.format, &mut folder) {
        (Format::Text, _) => {
            let (measured, screen) = (measured.matings(study), args.screen.screen());
            print(&gearlash_results::text::simulation(
                study, &verdict, &runs, &measured, unit, &screen,
            ))?;
            print(&screen.fold(&drawn_notes(file)))?;
        }
        (Format::Json, Some(folder)) => print_file(folder, JSON)?,
        (Format::Csv, Some(folder)) => print_file(folder, CSV)?,
        // Already printed.
        (Format::Json | Format::Csv, None) => {}
    }
    if let Some(mut folder) = folder {
        if let Some((run, assembly, pose)) = verdict.worst() {
            let title = &study.title;
            let picture = pose_picture(title, assembly, run.material, &pose.simulated)?;
            folder.add(WORST, &picture)?;
        }
        if args.snapshots {
            snapshots(study, &runs, &mut folder)?;
        }
        args.results.write(folder, &[])?;
    }
    let kept = verdict.requirement.is_kept();
    Ok(exit_code(agreement(&runs) & kept))
}

const JSON: &str = "result.json";
const CSV: &str = "result.csv";
const WORST: &str = "worst.svg";

/// The targets of JSON and CSV: both in the folder, or one on standard output where there is none.
fn outputs(
    format: Format,
    folder: Option<&mut OutputFolder>,
) -> Result<[Option<Box<dyn Write>>; 2], Error> {
    let Some(folder) = folder else {
        let printed = |of: Format| {
            let wanted = (format == of).then(Printer::new);
            wanted.map(|printer| Box::new(printer) as Box<dyn Write>)
        };
        return Ok([Format::Json, Format::Csv].map(printed));
    };
    let mut file = |name| {
        folder
            .create(name)
            .map(|file| Box::new(file) as Box<dyn Write>)
    };
    Ok([Some(file(JSON)?), Some(file(CSV)?)])
}

/// The error of a file in the folder, or of standard output.
fn unwritable(error: std::io::Error) -> Error {
    error.downcast().unwrap_or_else(Error::Printing)
}

/// Prints a file of the folder before it is renamed.
fn print_file(folder: &mut OutputFolder, name: &str) -> Result<(), Error> {
    let mut file = folder.open(name)?;
    let mut printer = Printer::new();
    std::io::copy(&mut file, &mut printer)
        .and_then(|_| printer.flush())
        .map_err(Error::Printing)
}

/// Whether a run of this command may write a file called `name`.
fn is_own(name: &str) -> bool {
    let picture = |name: &str| {
        let ending = name
            .strip_suffix("_min.svg")
            .or(name.strip_suffix("_max.svg"));
        let run = ending.and_then(|run| run.strip_prefix('a'));
        run.is_some_and(|run| run.starts_with(|c: char| c.is_ascii_digit()) && run.contains('_'))
    };
    matches!(name, JSON | CSV | WORST) || picture(name)
}

/// Snapshots of each run's least and greatest pose, into `folder`.
fn snapshots(study: &Study, runs: &[RunTally], folder: &mut OutputFolder) -> Result<(), Error> {
    for run in runs {
        let Some((least, greatest)) = run.extremes() else {
            continue;
        };
        let phase = run.phase.map_or(String::new(), |(wheel, pinion)| {
            format!("_phase{wheel}-{pinion}")
        });
        for (which, pose) in [("min", least), ("max", greatest)] {
            let name = format!(
                "a{}_{}{phase}_{which}.svg",
                run.assembly.center_distance(),
                run.material.name()
            );
            let pose = &pose.simulated;
            let picture = pose_picture(&study.title, &run.assembly, run.material, pose)?;
            folder.add(&name, &picture)?;
        }
    }
    Ok(())
}
