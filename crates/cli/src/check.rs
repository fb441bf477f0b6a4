//! `gearlash check`: does the pair interfere, where, why, and what does it cost.

use super::console::{ScreenArgs, print, print_note};
use super::maps::{self, DrawnMap};
use super::method::{MethodArgs, agreed};
use super::outlines::{DrawnArgs, is_drawing};
use super::progress::run_under_bar;
use super::{distances, outlines, poses, studies};
use crate::error::{Error, exit_code};
use crate::output::OutputFolder;
use clap::ValueEnum;
use gearlash::analysis::Plan;
use gearlash::analysis::diagnosis::Verdict;
use gearlash::analysis::verdict::Requirement;
use gearlash_files::outlines::Drawings;
use gearlash_files::{AnyPair, OutlinePairFile, PairFile, Sources};
use gearlash_results::checked::{self, CheckedPair};
use gearlash_results::verdict::sentence;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Check a pair: clearances, interference, backlash and limits, by formula and on the outlines
///
/// Each check has its value by formula, its value on the outlines over the poses of the pair file, its
/// limit, margin and verdict. A limit is met within 1e-9 mm. The largest loss of backlash that no formula
/// predicts is named with its teeth. Exit code 1 where a check fails, the pair does not assemble over its whole mesh
/// cycle, or a [require] is not met. Up to 2 million poses (2 GB of memory).
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair files (TOML or JSON), - for standard input; or two drawings (.dxf, .svg, .csv), of the wheel and of the pinion
    #[arg(required = true)]
    pairs: Vec<PathBuf>,
    /// Centre distance of two drawings, mm
    #[arg(long, alias = "centre-distance", value_name = "A", value_parser = distances::one, allow_hyphen_values = true)]
    center_distance: Option<f64>,
    #[command(flatten)]
    drawn: DrawnArgs,
    /// What to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
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

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Format {
    /// A readable table
    Text,
    /// Every check of each centre distance and material; of several files a list
    Json,
    /// JUnit XML: one suite per file, one case per check
    Junit,
    /// GitHub annotations
    Github,
    /// Markdown for reviewers
    Markdown,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let drawn = drawings(args)?;
    if args.map && drawn.is_none() && args.pairs.len() > 1 {
        return Err(Error::Usage(
            "--map draws one pair: give one pair file".to_owned(),
        ));
    }
    let (paths, files) = match drawn {
        Some(pair) => {
            let path = PathBuf::from(&pair.stem);
            (vec![path], vec![AnyPair::Outlines(Box::new(pair))])
        }
        None => {
            let files = studies::each(&args.pairs, studies::any)?;
            (args.pairs.clone(), files)
        }
    };
    let mut done = Checked::default();
    for (path, file) in paths.iter().zip(&files) {
        match file {
            AnyPair::Data(file) => {
                poses::allow(path, file.study.pose_count(), &poses::HELD)?;
                one(args, path, file, &mut done)?;
            }
            AnyPair::Outlines(file) => {
                let folder = folder(args, &file.stem, &file.sources)?;
                let as_json = args.format == Format::Json;
                let (text, pair, runs) =
                    outlines::check(path, file, &args.screen, &args.method, as_json)?;
                if let Some(folder) = folder {
                    let maps = maps::of_outlines(file, &runs)?;
                    done.written = Some(written(folder, maps)?);
                }
                done.texts.push(text);
                done.pairs.push(pair);
            }
        }
    }
    let pairs = &done.pairs;
    print(&match args.format {
        Format::Text => done.texts.join("\n"),
        Format::Json => match &done.texts[..] {
            [only] => only.clone(),
            several => format!("[\n{}]\n", several.join(",\n")),
        },
        Format::Junit => checked::junit(pairs).map_err(Error::unwritable("the checks"))?,
        Format::Github => checked::github(pairs),
        Format::Markdown => checked::markdown(pairs),
    })?;
    if let Some(written) = done.written
        && args.format == Format::Text
    {
        print_note(&format!("\n{written}\n"))?;
    }
    Ok(exit_code(pairs.iter().all(|pair| pair.passes)))
}

/// The pair of two drawings on the command line; `None` of pair files.
fn drawings(args: &Args) -> Result<Option<OutlinePairFile>, Error> {
    match (&args.pairs[..], args.center_distance) {
        ([wheel, pinion], Some(distance)) if is_drawing(wheel) && is_drawing(pinion) => {
            let drawings = Drawings {
                wheel,
                pinion,
                center_distance_mm: distance,
                units: args.drawn.units.as_deref(),
                center: args.drawn.center.as_deref(),
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
        (_, distance) if distance.is_some() || args.drawn.given() => Err(Error::Usage(
            "--center-distance, --units and --center belong to two drawings: pair files state them"
                .to_owned(),
        )),
        _ => Ok(None),
    }
}

/// What was checked so far.
#[derive(Default)]
struct Checked {
    pairs: Vec<CheckedPair>,
    /// Of text and JSON what each comes to.
    texts: Vec<String>,
    /// What was written of the map.
    written: Option<String>,
}

/// The folder for maps, where they are asked for.
fn folder(args: &Args, stem: &str, sources: &Sources) -> Result<Option<OutputFolder>, Error> {
    let folder = || match &args.output {
        Some(folder) => folder.clone(),
        None => PathBuf::from("out").join(stem),
    };
    args.map
        .then(|| OutputFolder::prepare(&folder(), sources, maps::is_own))
        .transpose()
}

/// Writes `maps`, and says so.
fn written(folder: OutputFolder, maps: Vec<DrawnMap>) -> Result<String, Error> {
    let files: Vec<_> = maps.into_iter().flat_map(DrawnMap::files).collect();
    folder.write(&files)
}

/// Checks one pair.
fn one(args: &Args, path: &Path, file: &PairFile, done: &mut Checked) -> Result<(), Error> {
    let study = &file.study;
    let folder = folder(args, &file.stem, &file.sources)?;
    let plan = Plan::new(study, args.method.method())
        .with_extremes()
        .with_checks();
    let analysis = run_under_bar(&plan)?;
    let (diagnosis, verdict) = (&analysis.diagnosis, analysis.verdict());
    let maps = match &folder {
        Some(_) => maps::of_data(study, diagnosis)?,
        None => Vec::new(),
    };
    let text = match args.format {
        Format::Text => {
            gearlash_results::text::check::text(study, &verdict, diagnosis, &args.screen.screen())
        }
        Format::Json => gearlash_results::checks_json(file, diagnosis, &verdict)
            .map_err(Error::unwritable("the checks"))?,
        Format::Junit | Format::Github | Format::Markdown => String::new(),
    };
    if let Some(folder) = folder {
        done.written = Some(written(folder, maps)?);
    }
    let kept = match verdict.requirement {
        Requirement::None => verdict.assembles() == Some(true),
        Requirement::Met => true,
        Requirement::NotMet => false,
    };
    let passes = agreed(&analysis) && diagnosis.verdict() < Verdict::Unproven && kept;
    done.texts.push(text);
    done.pairs.push(CheckedPair {
        file: path.display().to_string(),
        title: study.title.clone(),
        sentence: sentence(&verdict),
        passes,
        warnings: file.warnings.clone(),
        remarks: file.remarks.clone(),
        diagnosis: analysis.diagnosis.clone(),
    });
    Ok(())
}
