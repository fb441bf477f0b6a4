//! `gearlash match`: pairs measured wheels with pinions, and finds the teeth to mark.

use crate::console::warn_of_files;
use crate::error::{Error, exit_code};
use crate::input;
use crate::options::{ResultsArgs, ScreenArgs};
use crate::progress::Progress;
use gearlash_input::matching::{MatchResult, read_match};
use gearlash_render::match_map;
use gearlash_results::matching;
use std::path::{Path, PathBuf};

/// Files of a result.
const FILES: [&str; 3] = ["match.json", "matrix.csv", "match.svg"];

/// Choose which measured wheel goes with which pinion, and which teeth to mark
///
/// Every wheel with every pinion in every assembly phase, each proven over its whole mesh cycle at the centre distances of the pair file; then
/// the assignment with the most pairs within [require] and, among those, the nearest to the wanted backlash. Prints the pairs with the pinion
/// tooth that meets wheel tooth 1, the gears left over, and what random pairing and thickness classes would come to; writes match.json,
/// matrix.csv and match.svg to DIR. Exit code 1 if fewer pairs result than the smaller group has gears.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair file (TOML or JSON), - for standard input
    pair: PathBuf,
    /// Folder of the wheels' gear files
    #[arg(long, value_name = "DIR")]
    wheels: PathBuf,
    /// Folder of the pinions' gear files
    #[arg(long, value_name = "DIR")]
    pinions: PathBuf,
    /// Wanted backlash, µm [default: the middle of [require], or its one limit]
    #[arg(long, value_name = "UM", value_parser = target, allow_negative_numbers = true)]
    target_um: Option<f64>,
    #[command(flatten)]
    results: ResultsArgs,
    #[command(flatten)]
    screen: ScreenArgs,
}

/// A backlash in µm.
fn target(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(um) if um.abs() <= 1e5 => Ok(um),
        _ => Err("a number of µm between -100000 and 100000 is needed".to_owned()),
    }
}

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    let name = gearlash_text::display_path(&args.pair);
    let stem = Path::new(name.file_stem().unwrap_or_default());
    check_folders(args, args.results.path(stem).as_deref())?;
    let folders = [args.wheels.as_path(), args.pinions.as_path()];
    let wanted = args.target_um.map(|um| 1e-3 * um);
    let file = read_match(&args.pair, folders, wanted)
        .map_err(|errors| Error::Several(errors.into_iter().map(Error::Input).collect()))?;
    let sources = &file.pair.sources;
    let warnings = [&file.pair.warnings[..], &file.warnings].concat();
    input::report(&args.pair, sources, &warnings, &file.pair.remarks)?;
    warn_of_files(&file.gear_warnings, &file.gear_remarks);
    let is_own = |name: &str| FILES.contains(&name);
    let prepared = args.results.folder(&file.pair.stem, sources, is_own)?;
    let (wheels, pinions) = (file.wheels.len(), file.pinions.len());
    let bar = Progress::of((wheels * pinions) as u64, "pairs");
    let cells = file.cells(0..wheels, &|steps| bar.tick(steps))?;
    let result = MatchResult::new(&file, cells)?;
    drop(bar);
    let json = matching::json(&result);
    let matrix = matching::csv(&result);
    let text = matching::text(&result, &args.screen.screen());
    let contents = [json.clone(), matrix.clone(), match_map(&result)];
    let files: Vec<_> = FILES.map(str::to_owned).into_iter().zip(contents).collect();
    args.results
        .finish([&text, &json, &matrix], prepared, &files)?;
    Ok(exit_code(result.is_complete()))
}

/// An error where both kinds of gears come from one folder, or the next run would read results in `output` as gears.
fn check_folders(args: &Args, output: Option<&Path>) -> Result<(), Error> {
    let real = |path: &Path| path.canonicalize().ok();
    let [wheels, pinions] = [&args.wheels, &args.pinions].map(|path| real(path));
    if wheels.is_some() && wheels == pinions {
        return Err(Error::Usage(format!(
            "--wheels and --pinions are one folder, {}: each gear would be matched with itself; put wheels and pinions into two folders",
            args.wheels.display()
        )));
    }
    let Some(output) = output else {
        return Ok(());
    };
    for (name, folder) in [("--wheels", wheels), ("--pinions", pinions)] {
        if folder.is_some() && folder == real(output) {
            return Err(Error::Usage(format!(
                "-o {}: this is the folder of {name}, and the next run would read the results as gears; name another folder with -o",
                output.display()
            )));
        }
    }
    Ok(())
}
