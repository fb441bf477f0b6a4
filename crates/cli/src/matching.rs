//! `gearlash match`: which measured wheel goes with which pinion, and which teeth meet.

use super::console::{ScreenArgs, guard, print, print_note, tell, warn};
use super::parts::{Kept, WHOLE, shard};
use super::progress::Progress;
use super::tolerance::Format;
use crate::error::{Error, exit_code};
use crate::output::OutputFolder;
use gearlash_files::matching::{MatchFile, MatchPart, MatchResult, read_match};
use gearlash_render::match_map;
use gearlash_results::text;
use gearlash_results::text::Screen;
use std::path::PathBuf;
use std::process::ExitCode;

/// Files of a result.
const FILES: [&str; 3] = ["match.json", "matrix.csv", "match.svg"];

/// Choose which measured wheel goes with which pinion, and which teeth to mark
///
/// Every wheel with every pinion in every assembly phase, each proven over its whole mesh cycle at the centre distances of the pair file; then
/// the assignment with the most pairs within [require] and, among those, the nearest to the wanted backlash. Prints the pairs with the pinion
/// tooth that meets wheel tooth 1, the gears left over, and what random pairing and thickness classes would come to; writes match.json,
/// matrix.csv and match.svg to DIR. Interrupted, it keeps what is done in DIR/part.json; the same command goes on from there. Exit code 1 where a gear is
/// left over that had a mate.
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
    /// Part K of N of all wheels with pinions alone, to DIR/part_K_of_N.json: gearlash merge puts all together
    #[arg(long, value_name = "K/N", value_parser = shard)]
    shard: Option<[u64; 2]>,
    /// Folder for results [default: out/<file stem>; with --format json or csv none]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// What to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
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
    let own = PathBuf::from("out").join(&file.pair.stem);
    let named = args.output.as_deref();
    let folder = args.format.folder(named, &own, args.shard);
    let shard = args.shard.unwrap_or([1, 1]);
    let sources = &file.pair.sources;
    let whole = folder.as_ref().filter(|_| args.shard.is_none());
    let prepared = whole.map(|folder| OutputFolder::prepare(folder, sources, is_own));
    let prepared = prepared.transpose()?;
    let mut kept = folder
        .as_ref()
        .map(|folder| Kept::new(folder, args.shard, sources));
    let begun = file.part(shard)?;
    let part = match &kept {
        Some(kept) => kept.found(begun),
        None => begun,
    };
    let part = work(&file, part, kept.as_mut())?;
    if let (Some(kept), Some(_)) = (&kept, args.shard) {
        print_note(&kept.finish(&part, shard)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    tell_match(part, prepared, args.format, &args.screen.screen())
}

/// Does all of `part` that is left, and keeps what is done from time to time.
fn work(
    file: &MatchFile,
    mut part: MatchPart,
    mut kept: Option<&mut Kept>,
) -> Result<MatchPart, Error> {
    let [all, done] = part.progress();
    let bar = Progress::of(all - done, "pairs");
    while file.go_on(&mut part, &|| bar.tick())? {
        let [all, done] = part.progress();
        if let Some(kept) = kept.as_mut().filter(|_| done < all) {
            kept.keep(&part)?;
        }
    }
    Ok(part)
}

/// Whether a matching may write a file called `name`.
pub(super) fn is_own(name: &str) -> bool {
    FILES.contains(&name) || name == WHOLE
}

/// Prints what the whole `part` comes to and writes it to `folder`, where there is one.
pub(super) fn tell_match(
    part: MatchPart,
    folder: Option<OutputFolder>,
    format: Format,
    screen: &Screen,
) -> Result<ExitCode, Error> {
    let result = MatchResult::of(part)
        .ok_or("a part of it is not done")
        .map_err(Error::unwritable("the result"))?;
    let json = result.to_json();
    let matrix = result
        .matrix_csv()
        .map_err(Error::unwritable("the result"))?;
    let [first, second, third] = FILES.map(str::to_owned);
    let files = [
        (first, json.clone()),
        (second, matrix.clone()),
        (third, match_map(&result)),
    ];
    match format {
        Format::Text => print(&text::matched(&result, screen))?,
        Format::Json => print(&json)?,
        Format::Csv => print(&matrix)?,
    }
    format.write(folder, &files)?;
    Ok(exit_code(result.is_complete()))
}
