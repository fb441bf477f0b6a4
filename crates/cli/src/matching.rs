//! `gearlash match`: which measured wheel goes with which pinion, and which teeth meet.

use super::console::{guard, print, print_note, tell, warn};
use super::progress::Progress;
use super::screen::ScreenArgs;
use crate::error::Error;
use crate::output::OutputFolder;
use clap::ValueEnum;
use gearlash::gear::AsBuilt;
use gearlash::matching::Matrix;
use gearlash_files::matching::{MatchResult, NamedGear, read_match};
use gearlash_render::{match_map, text};
use std::path::PathBuf;
use std::process::ExitCode;

/// Files of a result.
const FILES: [&str; 3] = ["match.json", "matrix.csv", "match.svg"];

/// Choose which measured wheel goes with which pinion, and which teeth to mark
///
/// Every wheel with every pinion in every assembly phase, each proven over its whole mesh cycle at the centre distances of the pair file; then
/// the assignment with the most pairs within [require] and, among those, the nearest to the wanted backlash. Prints the pairs with the pinion
/// tooth that meets wheel tooth 1, the gears left over, and what random pairing and thickness classes would come to; writes match.json,
/// matrix.csv and match.svg to DIR. Exit code 1 where a gear is left over that had a mate.
#[derive(clap::Args)]
pub(super) struct Args {
    /// The pair file (TOML or JSON) of centre distance, bearings and [require]
    pair: PathBuf,
    /// Folder of the wheels' gear files, one a gear
    #[arg(long, value_name = "DIR")]
    wheels: PathBuf,
    /// Folder of the pinions' gear files
    #[arg(long, value_name = "DIR")]
    pinions: PathBuf,
    /// Wanted backlash in µm, from which a pair is to stray least over its mesh cycle [default: the middle of [require], or its one limit]
    #[arg(long, value_name = "UM", value_parser = target, allow_negative_numbers = true)]
    target_um: Option<f64>,
    /// Folder for results [default: out/<file stem>; with --format json or csv none]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// What to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    screen: ScreenArgs,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Format {
    /// A readable table
    Text,
    /// The whole result
    Json,
    /// Every wheel with every pinion, a row each
    Csv,
}

/// A backlash in µm.
fn target(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(um) if um.abs() <= 1e5 => Ok(um),
        _ => Err("a number of µm between -100000 and 100000 is needed".to_owned()),
    }
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let folders = [args.wheels.as_path(), args.pinions.as_path()];
    let wanted = args.target_um.map(|um| 1e-3 * um);
    let file = read_match(&args.pair, folders, wanted)
        .map_err(|errors| Error::Several(errors.into_iter().map(Error::Input).collect()))?;
    guard(&file.pair.sources)?;
    let warnings = [&file.pair.warnings[..], &file.warnings].concat();
    warn(&args.pair, &warnings, &file.pair.remarks);
    for (kind, lines) in [
        ("warning", &file.gear_warnings),
        ("note", &file.gear_remarks),
    ] {
        lines
            .iter()
            .for_each(|line| tell(&format!("{kind}: {line}")));
    }
    let folder = match (&args.output, args.format) {
        (Some(folder), _) => Some(folder.clone()),
        (None, Format::Text) => Some(PathBuf::from("out").join(&file.pair.stem)),
        (None, Format::Json | Format::Csv) => None,
    };
    let is_own = |name: &str| FILES.contains(&name);
    let prepare = |folder: PathBuf| OutputFolder::prepare(&folder, &file.pair.sources, is_own);
    let folder = folder.map(prepare).transpose()?;
    let gears = |named: &[NamedGear]| -> Vec<AsBuilt> {
        named.iter().map(|named| named.gear.clone()).collect()
    };
    let (wheels, pinions) = (gears(&file.wheels), gears(&file.pinions));
    let bar = Progress::of((wheels.len() * pinions.len()) as u64, "pairs");
    let matrix = Matrix::new(&wheels, &pinions, &file.terms, &|| bar.tick())?;
    drop(bar);
    let result = MatchResult::of(&file, matrix);
    let unwritable = |error: &dyn std::fmt::Display| {
        Error::Usage(format!("the result cannot be written: {error}"))
    };
    let json = result.to_json();
    let matrix = result.matrix_csv().map_err(|error| unwritable(&error))?;
    let [first, second, third] = FILES.map(str::to_owned);
    let files = [
        (first, json.clone()),
        (second, matrix.clone()),
        (third, match_map(&result)),
    ];
    match args.format {
        Format::Text => print(&text::matched(&result, &args.screen.screen()))?,
        Format::Json => print(&json)?,
        Format::Csv => print(&matrix)?,
    }
    if let Some(folder) = folder {
        let written = folder.write(&files)?;
        if args.format == Format::Text {
            print_note(&format!("\n{written}\n"))?;
        }
    }
    Ok(match result.is_complete() {
        true => ExitCode::SUCCESS,
        false => ExitCode::from(1),
    })
}
