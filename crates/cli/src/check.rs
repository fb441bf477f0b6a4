//! `gearlash check`: does the pair interfere, where, why, and what does it cost.

use super::console::{print, print_note, tell};
use super::method::{MethodArgs, agreed};
use super::progress::{Progress, run_under_bar};
use super::screen::ScreenArgs;
use super::{poses, studies};
use crate::error::Error;
use crate::output::OutputFolder;
use clap::ValueEnum;
use gearlash::analysis::Plan;
use gearlash::analysis::diagnosis::{Diagnosis, Group, MAP_ROWS, Verdict, ZeroDistance, map};
use gearlash::analysis::study::{Material, Study};
use std::path::PathBuf;
use std::process::ExitCode;

/// Check a pair: clearances, interference, backlash and limits, by formula and on the outlines
///
/// Each check has its value by formula, its value on the outlines over the poses of the pair file, its
/// limit, margin and verdict. A limit is met within 1e-9 mm. The largest loss of backlash that no formula
/// predicts is named with its teeth. Up to 2 million poses (2 GB of memory).
#[derive(clap::Args)]
pub(super) struct Args {
    /// The pair file (TOML or JSON), - for standard input
    pair: PathBuf,
    /// What to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Also map the contact over centre distance and mesh phase, as map_<material>.svg and .csv
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
    /// Every check of each centre distance and material
    Json,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let file = studies::pair(&args.pair)?;
    let study = &file.study;
    let folder = || match &args.output {
        Some(folder) => folder.clone(),
        None => PathBuf::from("out").join(&file.stem),
    };
    let folder = args
        .map
        .then(|| OutputFolder::prepare(&folder(), &file.sources, is_own))
        .transpose()?;

    poses::allow(&args.pair, study.pose_count(), &poses::HELD)?;
    let plan = Plan::new(study, args.method.method()).with_checks();
    let analysis = run_under_bar(&plan)?;
    let diagnosis = &analysis.diagnosis;
    let maps = match &folder {
        Some(_) => maps(study, diagnosis)?,
        None => Vec::new(),
    };

    print(&match args.format {
        Format::Text => gearlash_render::text::check::text(study, diagnosis, &args.screen.screen()),
        Format::Json => gearlash_files::results::checks_json(&file, diagnosis)
            .map_err(|error| Error::Usage(format!("the checks cannot be written: {error}")))?,
    })?;
    if let Some(folder) = folder {
        let written = folder.write(&maps)?;
        if args.format == Format::Text {
            print_note(&format!("\n{written}\n"))?;
        }
    }
    let agree = agreed(&analysis);
    let holds = agree && diagnosis.verdict() < Verdict::Unproven;
    Ok(match holds {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(1),
    })
}

/// Whether a run of this command may write a file called `name`.
fn is_own(name: &str) -> bool {
    let map = name.strip_prefix("map_");
    let map = map.and_then(|map| map.strip_suffix(".svg").or(map.strip_suffix(".csv")));
    let materials = [Material::Most, Material::Least, Material::AsMeasured];
    map.is_some_and(|map| materials.iter().any(|material| material.name() == map))
}

/// A map of each material, at the study's first centre distance.
fn maps(study: &Study, diagnosis: &Diagnosis) -> Result<Vec<(String, String)>, Error> {
    let mut drawn: Vec<(&Group, &ZeroDistance)> = Vec::new();
    let mut seen = Vec::new();
    for group in &diagnosis.groups {
        let material = group.material;
        if seen.contains(&material) {
            continue;
        }
        seen.push(material);
        match &group.zero {
            Ok(Some(zero)) => drawn.push((group, zero)),
            Ok(None) => {}
            Err(reason) => {
                tell(&format!(
                    "note: no map of material {}: the pose with the least backlash is unproven ({reason})",
                    material.name()
                ));
            }
        }
    }
    let mut files = Vec::new();
    let progress = Progress::of(drawn.len() as u64 * u64::from(MAP_ROWS), "rows of the map");
    for (group, zero) in drawn {
        let material = group.material;
        let map = map(group, zero.pose, &|| progress.tick())?;
        let caption = format!(
            "{} and {} teeth, material {}: what touches, over one pitch from the pose with the least backlash",
            group
                .assembly
                .gear(gearlash::pair::Member::Wheel)
                .gear()
                .basic_data()
                .teeth(),
            group
                .assembly
                .gear(gearlash::pair::Member::Pinion)
                .gear()
                .basic_data()
                .teeth(),
            material.name(),
        );
        let picture = gearlash_render::map_picture(&map, &study.title, &caption);
        let csv = gearlash_files::results::map_csv(&map)
            .map_err(|error| Error::Usage(format!("the map cannot be written: {error}")))?;
        files.push((format!("map_{}.svg", material.name()), picture));
        files.push((format!("map_{}.csv", material.name()), csv));
    }
    Ok(files)
}
