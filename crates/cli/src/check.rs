//! `gearlash check`: whether the pair interferes, where, why, and how much backlash it loses.

use crate::console::print_note;
use crate::distances::{self, Distances};
use crate::error::Error;
use crate::input;
use crate::judged::{self, JudgedFormat, print_outcome};
use crate::maps::{self, DrawnMap};
use crate::options::{DrawnArgs, MethodArgs, ScreenArgs, agreed, is_drawing, not_two_drawings};
use crate::output::{OutputFolder, own_folder};
use crate::progress::run_under_bar;
use gearlash::analysis::Plan;
use gearlash::analysis::without_play::{WithoutPlay, tips_on_roots};
use gearlash_input::outlines::{APART_MM, Drawings};
use gearlash_input::{PairFile, distance_refused};
use gearlash_results::judged::Judgement;
use gearlash_results::{RemedyRecords, checked};
use gearlash_text::{InputError, Problem, display_path};
use std::path::{Path, PathBuf};

const OPTION: &str = "--center-distance";

/// Check a pair: clearances, interference, backlash and limits, by formula and on the outlines
///
/// Each check has its value by formula, its value on the outlines over the poses of the pair file, its
/// limit, margin and verdict. A limit is met within 1e-9 mm. The largest loss of backlash that no formula
/// predicts is named with its teeth. Exit code 1 where a check fails, the pair does not assemble over its whole mesh
/// cycle, or a [require] is not met or not proven; 2 where a file cannot be read: the others are checked all the same.
/// Up to 2 million poses (2 GB of memory).
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair files, - for standard input; or drawings (.dxf, .svg, .csv, .txt) of wheel and pinion
    #[arg(required = true)]
    pairs: Vec<PathBuf>,
    /// Centre distance, mm, or a scan FROM..TO:STEP, in place of those of the file [default of drawings: without play]
    #[arg(long, alias = "centre-distance", value_name = "A", value_parser = distances::parse, allow_hyphen_values = true)]
    center_distance: Option<Distances>,
    #[command(flatten)]
    drawn: DrawnArgs,
    /// Only print the names of all files that are read, one a line
    #[arg(long)]
    inputs: bool,
    /// Output format
    #[arg(long, value_enum, default_value_t = JudgedFormat::Text)]
    format: JudgedFormat,
    /// Also map contact (of outlines backlash) over centre distance and mesh phase, as map_<material>.svg and .csv
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

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    if args.inputs {
        return match given(args)? {
            Some(drawings) => input::print_inputs([gearlash_input::read_drawings(&drawings)]),
            None => input::print_inputs(args.pairs.iter().map(|path| gearlash_input::read(path))),
        };
    }
    let drawn = drawings(args)?;
    if args.map && drawn.is_none() && args.pairs.len() > 1 {
        return Err(Error::usage("--map draws one pair: give one pair file"));
    }
    let files = match drawn {
        Some(pair) => {
            let path = PathBuf::from(&pair.stem);
            vec![(path, Ok(pair))]
        }
        None => judged::read(&args.pairs, |path| {
            moved(path, args.center_distance.as_ref())
        })?,
    };
    let mut map = None;
    let judge = |path: &Path, file: &PairFile| pair(args, path, file, &mut map);
    let (outcome, summary) = judged::outcome("check", files, args.format, judge)?;
    let code = print_outcome(&outcome, args.format, &args.screen, summary.as_deref())?;
    if let Some(written) = map.filter(|_| args.format == JudgedFormat::Text) {
        print_note(&format!("\n{written}\n"))?;
    }
    Ok(code)
}

/// Checks a pair.
fn pair(
    args: &Args,
    path: &Path,
    file: &PairFile,
    map: &mut Option<String>,
) -> Result<Judgement, Error> {
    let study = &file.study;
    let method = args.method.of(study)?;
    input::allow(path, study.pose_count(), &input::HELD)?;
    let mut folder = None;
    if args.map {
        let own = || own_folder(&file.stem);
        let path = args.output.clone().unwrap_or_else(own);
        folder = Some(OutputFolder::prepare(&path, &file.sources, maps::is_own)?);
    }
    let plan = Plan::new(study, method)
        .with_remedies(file.spec.stated_gears())
        .with_checks();
    let analysis = run_under_bar(&plan)?;
    if let Some(folder) = folder {
        let maps = maps::of(&analysis)?.into_iter();
        let files: Vec<_> = maps.flat_map(DrawnMap::files).collect();
        *map = Some(folder.write(&files)?);
    }
    Ok(checked(
        &path.display().to_string(),
        file,
        &analysis.diagnosis,
        &analysis.verdict(),
        &RemedyRecords::new(file, &analysis.remedies),
        agreed(&analysis),
        &args.screen.screen(),
    ))
}

/// The pair of two drawings on the command line; `None` for pair files.
fn drawings(args: &Args) -> Result<Option<PairFile>, Error> {
    let Some(mut drawings) = given(args)? else {
        return Ok(None);
    };
    let mut warning = None;
    if args.center_distance.is_none() {
        let (distance, taken) = without_play(args, drawings)?;
        drawings.center_distance_mm = distance;
        warning = Some(taken);
    }
    let pair = input::drawings(&drawings, warning)?;
    let scan = args.center_distance.as_ref();
    let Some(scan) = scan.filter(|Distances(scan)| scan.len() > 1) else {
        return Ok(Some(pair));
    };
    let refused = |reason| {
        let reason = distance_refused(&reason);
        Error::Usage(format!("{OPTION} {scan}: {reason}"))
    };
    pair.at(scan.0.clone()).map(Some).map_err(refused)
}

/// Two drawings on the command line, apart if no distance is given; `None` for pair files.
fn given(args: &Args) -> Result<Option<Drawings<'_>>, Error> {
    match &args.pairs[..] {
        [wheel, pinion] if is_drawing(wheel) && is_drawing(pinion) => Ok(Some(Drawings {
            wheel,
            pinion,
            center_distance_mm: args
                .center_distance
                .as_ref()
                .map_or(APART_MM, |Distances(scan)| scan[0]),
            options: args.drawn.options()?,
        })),
        paths if paths.iter().any(|path| is_drawing(path)) => Err(not_two_drawings(
            paths,
            if args.map {
                "two drawings, of wheel and pinion (--map writes into the folder of -o)"
            } else {
                "two drawings, of wheel and pinion"
            },
        )),
        _ if args.drawn.given() => Err(Error::Usage(format!(
            "{} belong to two drawings: pair files state them",
            DrawnArgs::NAMES
        ))),
        _ => Ok(None),
    }
}

/// The pair file at `path`, at the centre distances of the command line if there are any.
fn moved(path: &Path, distances: Option<&Distances>) -> Result<PairFile, InputError> {
    let pair = gearlash_input::read(path)?;
    let Some(distances) = distances else {
        return Ok(pair);
    };
    let mut moved = pair.at(distances.0.clone()).map_err(|reason| {
        let problem = Problem {
            key: OPTION.to_owned(),
            value: Some(distances.to_string()),
            reason: distance_refused(&reason),
            help: "or leave it out".to_owned(),
        };
        InputError::of(display_path(path), vec![problem])
    })?;
    moved.warnings.push(format!(
        "assembly.center_distance_mm: {distances} mm of {OPTION} replaces every distance of the file"
    ));
    Ok(moved)
}

/// The least centre distance, mm, at which the gears of two drawings assemble, and a warning that names it. `drawings`
/// are apart. The search begins where a tip touches a root.
fn without_play(args: &Args, drawings: Drawings) -> Result<(f64, String), Error> {
    let not_found = || {
        Error::usage(
            "two drawings need their centre distance, as none is found at which they mesh without play: add --center-distance A",
        )
    };
    let apart = gearlash_input::read_drawings(&drawings)?;
    let nearest = tips_on_roots(&apart.study)?.ok_or_else(not_found)?;
    let tight = apart.at(vec![nearest])?;
    let plan = Plan::new(&tight.study, args.method.of(&tight.study)?).with_extremes();
    let analysis = run_under_bar(&plan)?;
    let found = WithoutPlay::of(&analysis.verdict(), nearest).ok_or_else(not_found)?;
    let mesh = if found.flanks_bind {
        "the gears mesh without play"
    } else {
        "a tip touches a root and no flank binds"
    };
    let taken = format!(
        "no centre distance is given: at {:.3} mm, rounded up to 0.001 mm and taken here, {mesh}; --center-distance states another",
        found.distance
    );
    Ok((found.distance, taken))
}
