//! `gearlash report`: the whole result as one page.

use super::check;
use super::date::today;
use super::method::{MethodArgs, agreement_within, all_proven, largest_difference, unproven};
use super::progress::Progress;
use super::target::Target;
use super::{poses, studies};
use crate::error::Error;
use gearlash::curves;
use gearlash::cycle::{self, cycle};
use gearlash::gauge::{GradedReading, Unmeasured, graded};
use gearlash::gear::Inspection;
use gearlash::measured::measured_matings;
use gearlash_files::PairFile;
use gearlash_render::{self, Report};
use std::path::PathBuf;
use std::process::ExitCode;

/// Write a report: one HTML page with verdict, input, checks, curves, formulas and the mesh itself
///
/// The page needs no network and no other file, and prints on A4. Beside the poses the pair file asks for it
/// shows whole revolutions at each centre distance. Its date is that of the environment variable
/// SOURCE_DATE_EPOCH (seconds since 1970) where set, so that the same input gives the same bytes, or else today.
/// Up to 2 million poses, revolutions included, which take 2 GB of memory.
#[derive(clap::Args)]
pub(super) struct Args {
    /// The pair file (TOML or JSON)
    pair: PathBuf,
    /// The page [default: out/<file stem>.html]; - for standard output
    #[arg(short, long, value_name = "FILE.html")]
    output: Option<PathBuf>,
    #[command(flatten)]
    method: MethodArgs,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let date = today()?;
    let pair = studies::pair(&args.pair)?;
    let study = &pair.study;
    let file = match &args.output {
        Some(file) => file.clone(),
        None => PathBuf::from("out").join(format!("{}.html", pair.stem)),
    };
    let target = Target::prepare_beside(file, &pair.sources)?;
    let method = args.method.method();
    let held = curves::with_revolution_pose_count(study)?;
    poses::allow(&args.pair, held as u64, &poses::HELD)?;
    let poses = held + cycle::pose_count(study)?;
    let progress = Progress::start(poses);
    let tick = || progress.tick();
    let [runs, revolution] = curves::with_revolution(study, method, &tick)?;
    let cycle = cycle(study, method, &tick)?;
    let all = revolution.iter().chain(&runs).chain(&cycle.extremes);
    drop(progress);
    let followed = curves::followed(study, curves::binding(study, all));
    let poses = followed.len() * curves::over_distance_pose_count(study);
    let progress = Progress::start(poses);
    let tick = || progress.tick();
    let over_distance = followed
        .into_iter()
        .map(|followed| curves::over_distance(study, followed, method, &tick))
        .collect::<Result<Vec<_>, _>>()?;
    drop(progress);
    let diagnosis = check::diagnosis(study, &runs)?;
    let progress = Progress::working();
    progress.now("accuracy grades");
    let grades = grades(&pair);
    progress.now("page");
    let file = args.pair.file_name().unwrap_or_default().to_string_lossy();
    let page = gearlash_render::report(&Report {
        pair: &pair,
        file: &file,
        date: &date,
        method,
        runs: &runs,
        revolution: &revolution,
        cycle: &cycle,
        over_distance: &over_distance,
        measured: &measured_matings(study, &runs),
        diagnosis: &diagnosis,
        grades: &grades,
    })?;
    drop(progress);
    let agree = agreement_within(
        largest_difference(runs.iter().chain(&revolution).chain(&cycle.extremes))
            .into_iter()
            .chain(
                over_distance
                    .iter()
                    .filter_map(|curve| curve.polygon_difference),
            )
            .reduce(f64::max),
    );
    let all = runs.iter().chain(&revolution).chain(&cycle.extremes);
    let over_distance = over_distance.iter().map(|curve| curve.unproven);
    let proven = all_proven(unproven(all) + over_distance.sum::<usize>());
    target.write(&page)?;
    Ok(match agree && proven {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(1),
    })
}

/// The grades of each gear that has deviations: of the most material where there are two, as the gauge reads that one.
fn grades(pair: &PairFile) -> Vec<(&'static str, Result<Vec<GradedReading>, Unmeasured>)> {
    let Some((_, wheel, pinion)) = pair.study.materials.first() else {
        return Vec::new();
    };
    let deviating = [
        ("wheel", wheel, &pair.spec.wheel),
        ("pinion", pinion, &pair.spec.pinion),
    ]
    .into_iter()
    .filter(|(_, gear, _)| Inspection::of(gear).deviates());
    deviating
        .map(|(name, gear, spec)| (name, graded(gear, spec.thickness.pin_mm())))
        .collect()
}
