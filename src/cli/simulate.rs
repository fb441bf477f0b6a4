//! `gearlash simulate`: the main job.

use super::console::print;
use super::distances::{self, Distances};
use super::method::{MethodArgs, agreement};
use super::progress::Progress;
use super::results::{Format, ResultsArgs};
use super::studies;
use crate::compare::{ComparedRun, compare};
use crate::error::Error;
use crate::measured::measured_matings;
use crate::render::{self, Snapshot};
use crate::simulate::{pose_count, simulate};
use crate::study::Study;
use std::path::PathBuf;
use std::process::ExitCode;

/// Find the lost motion at every pose a pair file asks for
///
/// Prints a table and writes DIR/result.json, DIR/result.csv and, for each run (a centre distance and a
/// material), snapshots of the pose with the least (…_min.svg) and with the greatest backlash (…_max.svg).
#[derive(clap::Args)]
pub(super) struct Args {
    /// The pair file (TOML or JSON)
    pair: PathBuf,
    /// Other centre distances than the pair file's, mm: one, or a scan FROM..TO:STEP
    #[arg(long, value_name = "A", value_parser = distances::parse, allow_hyphen_values = true)]
    center_distance: Option<Distances>,
    #[command(flatten)]
    results: ResultsArgs,
    #[command(flatten)]
    method: MethodArgs,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let mut study = studies::pair(&args.pair)?;
    if let Some(Distances(distances)) = &args.center_distance {
        let moved = study.at(distances.clone());
        study = moved.map_err(|reason| Error::Usage(format!("--center-distance: {reason}")))?;
    }
    // Before the simulation, not after it.
    let folder = args.results.folder(&study.stem, &study.sources, is_own)?;

    let progress = Progress::start(pose_count(&study)?);
    let runs = simulate(&study, args.method.method(), &|| progress.tick())?;
    drop(progress);
    let runs = compare(runs, study.tolerance_um);

    let result = render::result_file(&study, &runs);
    let unwritable = |error: &dyn std::error::Error| {
        Error::Usage(format!("the result cannot be written as text: {error}"))
    };
    let json = result.to_json().map_err(|error| unwritable(&error))?;
    let csv = result.to_csv().map_err(|error| unwritable(&error))?;
    match args.results.format {
        Format::Text => {
            let measured = measured_matings(&study, &runs);
            print(&render::simulation_table(&study, &runs, &measured))?;
        }
        Format::Json => print(&json)?,
        Format::Csv => print(&csv)?,
    }
    if let Some(folder) = folder {
        let mut files = vec![
            ("result.json".to_owned(), json),
            ("result.csv".to_owned(), csv),
        ];
        files.extend(snapshots(&study, &runs));
        args.results.write(folder, &files)?;
    }
    Ok(match agreement(&runs) {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(1),
    })
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
    matches!(name, "result.json" | "result.csv") || picture(name)
}

/// Snapshots of each run's least and greatest pose.
fn snapshots(study: &Study, runs: &[ComparedRun]) -> Vec<(String, String)> {
    let mut files = Vec::new();
    for run in runs {
        let Some((least, greatest)) = run.extremes() else {
            continue;
        };
        let phase = run.run.phase.map_or(String::new(), |(wheel, pinion)| {
            format!("_phase{wheel}-{pinion}")
        });
        for (which, pose) in [("min", least), ("max", greatest)] {
            let name = format!(
                "a{}_{}{phase}_{which}.svg",
                run.run.assembly.center_distance(),
                run.run.material.name()
            );
            let picture = render::snapshot(&Snapshot {
                title: &study.title,
                assembly: &run.run.assembly,
                pose: &pose.swept.pose,
                material: run.run.material.name(),
                found: pose.swept.found.as_ref(),
            });
            files.push((name, picture));
        }
    }
    files
}
