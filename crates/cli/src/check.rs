//! `gearlash check`: whether the pair interferes, where, why, and how much backlash it loses.

use super::console::{ScreenArgs, print_note};
use super::judged::{self, JudgedFormat, print_outcome};
use super::maps::{self, DrawnMap};
use super::method::{MethodArgs, agreed};
use super::outlines::{DrawnArgs, is_drawing};
use super::progress::run_under_bar;
use super::{distances, poses, studies};
use crate::error::Error;
use crate::output::OutputFolder;
use gearlash::analysis::Plan;
use gearlash_files::outlines::Drawings;
use gearlash_files::{AnyPair, Sources};
use gearlash_results::judged::Judged;
use gearlash_results::{RemedyRecords, checked};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Check a pair: clearances, interference, backlash and limits, by formula and on the outlines
///
/// Each check has its value by formula, its value on the outlines over the poses of the pair file, its
/// limit, margin and verdict. A limit is met within 1e-9 mm. The largest loss of backlash that no formula
/// predicts is named with its teeth. Exit code 1 where a check fails, the pair does not assemble over its whole mesh
/// cycle, or a [require] is not met or not proven; 2 where a file cannot be read: the others are checked all the same.
/// Up to 2 million poses (2 GB of memory).
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair files (TOML or JSON), - for standard input; or two drawings (.dxf, .svg, .csv, .txt), of the wheel and of the pinion
    #[arg(required = true)]
    pairs: Vec<PathBuf>,
    /// Centre distance of two drawings, mm
    #[arg(long, alias = "centre-distance", value_name = "A", value_parser = distances::one, allow_hyphen_values = true)]
    center_distance: Option<f64>,
    #[command(flatten)]
    drawn: DrawnArgs,
    /// Print the names of the files that the pair files read, themselves included, one a line, and check nothing
    #[arg(long)]
    inputs: bool,
    /// Output format
    #[arg(long, value_enum, default_value_t = JudgedFormat::Text)]
    format: JudgedFormat,
    /// Also map the contact (of outlines the backlash) over centre distance and mesh phase, as map_<material>.svg and .csv; of one pair file
    #[arg(long)]
    map: bool,
    /// Folder for the map [default: out/<file stem>]
    #[arg(short, long, value_name = "DIR", requires = "map")]
    output: Option<PathBuf>,
    #[command(flatten)]
    screen: ScreenArgs,
    #[command(flatten)]
    method: MethodArgs,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let drawn = drawings(args)?;
    if args.inputs && drawn.is_none() {
        return studies::print_inputs(&args.pairs);
    }
    if args.map && drawn.is_none() && args.pairs.len() > 1 {
        return Err(Error::Usage(
            "--map draws one pair: give one pair file".to_owned(),
        ));
    }
    let files = match drawn {
        Some(pair) => {
            let path = PathBuf::from(&pair.stem);
            vec![(path, Ok(pair))]
        }
        None => judged::read(&args.pairs, studies::any)?,
    };
    let mut map = None;
    let judge = |path: &Path, file: &AnyPair| pair(args, path, file, &mut map);
    let (outcome, summary) = judged::outcome("check", files, args.format, judge)?;
    let code = print_outcome(&outcome, args.format, &args.screen, &summary)?;
    if let Some(written) = map.filter(|_| args.format == JudgedFormat::Text) {
        print_note(&format!("\n{written}\n"))?;
    }
    Ok(code)
}

/// Checks a pair.
fn pair(
    args: &Args,
    path: &Path,
    file: &AnyPair,
    map: &mut Option<String>,
) -> Result<Judged, Error> {
    let study = &file.study;
    let method = args.method.of(study)?;
    poses::allow(path, study.pose_count(), &poses::HELD)?;
    let folder = folder(args, &file.stem, &file.sources)?;
    let plan = Plan::new(study, method).with_remedies().with_checks();
    let analysis = run_under_bar(&plan)?;
    if let Some(folder) = folder {
        *map = Some(written(folder, maps::of(&analysis)?)?);
    }
    let name = path.display().to_string();
    let verdict = analysis.verdict();
    let is_proven = agreed(&analysis);
    let screen = args.screen.screen();
    let remedies = RemedyRecords::new(file, &analysis.remedies);
    let diagnosis = &analysis.diagnosis;
    Ok(checked(
        &name, file, diagnosis, &verdict, &remedies, is_proven, &screen,
    ))
}

/// The pair of two drawings on the command line; `None` for pair files.
fn drawings(args: &Args) -> Result<Option<AnyPair>, Error> {
    match (&args.pairs[..], args.center_distance) {
        ([wheel, pinion], Some(distance)) if is_drawing(wheel) && is_drawing(pinion) => {
            let drawings = Drawings {
                wheel,
                pinion,
                center_distance_mm: distance,
                options: args.drawn.options()?,
            };
            studies::drawings(&drawings).map(Some)
        }
        (paths, distance) if paths.iter().any(|path| is_drawing(path)) => {
            Err(Error::Usage(match (paths, distance) {
                ([wheel, pinion], None) if is_drawing(wheel) && is_drawing(pinion) => {
                    "two drawings need their centre distance: add --center-distance A".to_owned()
                }
                _ => "give two drawings, of the wheel and of the pinion, or pair files alone (--map writes into the folder of -o)"
                    .to_owned(),
            }))
        }
        (_, distance) if distance.is_some() || args.drawn.given() => Err(Error::Usage(format!(
            "--center-distance, {} belong to two drawings: pair files state them",
            DrawnArgs::NAMES
        ))),
        _ => Ok(None),
    }
}

/// The folder for maps, where they are requested.
fn folder(args: &Args, stem: &str, sources: &Sources) -> Result<Option<OutputFolder>, Error> {
    let folder = || match &args.output {
        Some(folder) => folder.clone(),
        None => PathBuf::from("out").join(stem),
    };
    args.map
        .then(|| OutputFolder::prepare(&folder(), sources, maps::is_own))
        .transpose()
}

/// Writes `maps`; returns a line that names the files.
fn written(folder: OutputFolder, maps: Vec<DrawnMap>) -> Result<String, Error> {
    let files: Vec<_> = maps.into_iter().flat_map(DrawnMap::files).collect();
    folder.write(&files)
}
