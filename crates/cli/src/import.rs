//! `gearlash import`: the content of a file of measurements, as a table and as lines for a pair file; of a gearbox model, and the
//! pair file of a stage.

use crate::console::{check_streams_not_input, print};
use crate::error::Error;
use crate::options::{ScreenArgs, one_of};
use crate::output::Target;
use clap::ValueEnum;
use gearlash_drawing::Unit;
use gearlash_input::import::{self, Imported, Kind, Options};
use gearlash_input::is_rexs;
use gearlash_input::outlines::{listed_outlines, lists_outlines};
use gearlash_results::text::{self, Screen};
use gearlash_rexs::{self as rexs, RexsFile, RexsPair};
use gearlash_text::{Problem, STANDARD_INPUT, without_mark};
use std::path::{Path, PathBuf};

/// Show what is read of a table, protocol, drawing or gearbox model, and the lines of a pair file that name it
///
/// Reads every table of the file as a pair file does: pitch, runout, thickness, spans and pins by tooth, profile and lead traces. Prints
/// their numbers, the parts of the file that were left out, and the TOML to paste into a pair file or gear file; writes nothing
/// else.
/// The options are the keys that a pair file may have beside `file`.
///
/// Lists the outlines of a drawing (.dxf, .svg) by number, layer, place and size.
///
/// Turns stages of external gears of a gearbox model (REXS 1.0 to 2.0, XML, JSON, or zipped) into pair files; lists everything
/// else.
#[derive(clap::Args)]
pub(super) struct Args {
    /// CSV, workbook (.xlsx), text protocol, curve file (.mka), drawing (.dxf, .svg) or gearbox model (.rexs, .rexsj, .rexsz; - for standard input)
    file: PathBuf,
    /// Data to read [default: all]
    #[arg(long, value_name = "ONLY", value_parser = Kind::NAMED.map(|(name, _)| name))]
    only: Option<String>,
    /// Sheet of a workbook
    #[arg(long, value_name = "NAME")]
    sheet: Option<String>,
    /// Line of the header; 0: none [default: found by its names]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=1_048_576))]
    header_row: Option<u32>,
    /// Column of tooth numbers, by heading or letter
    #[arg(long, value_name = "COLUMN")]
    tooth_column: Option<String>,
    /// Column of left flanks
    #[arg(long, value_name = "COLUMN")]
    left: Option<String>,
    /// Column of right flanks
    #[arg(long, value_name = "COLUMN")]
    right: Option<String>,
    /// Column of the values that --only names
    #[arg(long, value_name = "COLUMN", requires = "only")]
    column: Option<String>,
    /// Decimal sign of a text table
    #[arg(long, value_name = "SIGN")]
    decimal: Option<String>,
    /// Unit of drawings that state none
    #[arg(long, value_name = "UNIT", value_parser = Unit::NAMED.map(|(name, _)| name))]
    units: Option<String>,
    /// Gear of the TOML
    #[arg(long, value_parser = one_of(TABLES), default_value = "wheel")]
    gear: &'static str,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    rexs: RexsArgs,
    #[command(flatten)]
    screen: ScreenArgs,
}

/// Values of `--gear`.
const TABLES: [(&str, &str, &str); 3] = [
    ("wheel", "wheel", "A wheel of a pair file"),
    ("pinion", "pinion", "A pinion of a pair file"),
    ("gear", "gear", "The gear of a gear file"),
];

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Format {
    /// Tables and TOML
    Text,
    /// One JSON object, for a program
    Json,
}

impl Args {
    /// The keys beside `file`, with the values that options state.
    fn keys(&self) -> [(&'static str, Option<String>); 7] {
        [
            ("sheet", self.sheet.clone()),
            ("header_row", self.header_row.map(|row| row.to_string())),
            ("tooth_column", self.tooth_column.clone()),
            ("left", self.left.clone()),
            ("right", self.right.clone()),
            ("column", self.column.clone()),
            ("decimal", self.decimal.clone()),
        ]
    }

    /// Whether an option for tables alone is given.
    fn of_tables(&self) -> bool {
        let states_key = self.keys().iter().any(|(_, stated)| stated.is_some());
        states_key || self.only.is_some() || self.format == Format::Json
    }

    /// Words about keys of a pair file in those of options: `tooth_column = "A"` is `--tooth-column A`.
    fn as_options(&self, words: &str) -> String {
        let mut words = words.to_owned();
        for (key, _) in self.keys() {
            let option = format!("--{} ", key.replace('_', "-"));
            while let Some((before, rest)) = words.split_once(&format!("{key} = ")) {
                let quoted = rest.strip_prefix('"').and_then(|rest| rest.split_once('"'));
                // A name of a shell's signs keeps its quotation marks.
                let is_plain = |name: &str| name.chars().all(|c| c.is_alphanumeric() || c == '…');
                words = match quoted.filter(|(name, _)| is_plain(name)) {
                    Some((name, after)) => format!("{before}{option}{name}{after}"),
                    None => format!("{before}{option}{rest}"),
                };
            }
        }
        words.replace(", --", " --")
    }
}

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    let holds_points = || listed_outlines(&args.file, Some("mm")).is_ok();
    if lists_outlines(&args.file) || args.units.is_some() && holds_points() {
        return outlines(args);
    }
    if args.units.is_some() {
        return Err(Error::usage("--units belongs to a drawing; leave it out"));
    }
    // Decides by the content of the file, not by its name.
    let mut bytes = Vec::new();
    if args.file.as_path() != Path::new(STANDARD_INPUT) {
        bytes = import::bytes(&args.file)?;
    }
    let of_other = |what: &str, options: &str| {
        let file = args.file.display();
        Err(Error::Usage(format!(
            "{file}: is {what}, which has no {options}"
        )))
    };
    if !is_gearbox_model(&args.file, &bytes) {
        if args.rexs.is_given() {
            return of_other("a table", "--stage and no --output");
        }
        let found = table(args, bytes).map_err(|error| {
            if !holds_points() {
                return error;
            }
            Error::Usage(format!(
                "{}: holds the points of an outline, no readings; use it with `gearlash check`, or in [wheel.outline]",
                args.file.display()
            ))
        })?;
        check_streams_not_input(&found.sources)?;
        print(&match args.format {
            Format::Text => text::imported(&found, &args.screen.screen()),
            Format::Json => found.to_json(),
        })?;
        return Ok(0);
    }
    if args.of_tables() {
        return of_other(
            "a gearbox model",
            "columns, sheets or --format json: -o FILE writes the pair file of a stage",
        );
    }
    model(&args.file, &args.rexs, &args.screen.screen())
}

/// Whether the file at `path` with these bytes is a gearbox model, as standard input is; else it holds tables.
fn is_gearbox_model(path: &Path, bytes: &[u8]) -> bool {
    // No table begins like XML or JSON.
    let first = without_mark(bytes).trim_ascii_start().first();
    let begins = matches!(first, Some(b'<' | b'{'));
    begins || is_rexs(path) || path == Path::new(STANDARD_INPUT)
}

/// The outlines of a drawing.
fn outlines(args: &Args) -> Result<u8, Error> {
    if args.of_tables() || args.rexs.is_given() {
        return Err(Error::usage(
            "a drawing has no columns, sheets, stages, --output or --format json; leave them out",
        ));
    }
    let found = listed_outlines(&args.file, args.units.as_deref())?;
    let name = args.file.file_name().unwrap_or_default().to_string_lossy();
    let screen = args.screen.screen();
    print(&text::listed_outlines(&name, &found, args.gear, &screen))?;
    Ok(0)
}

/// A table in cells, or of a protocol.
fn table(args: &Args, bytes: Vec<u8>) -> Result<Imported, Error> {
    let keys = args.keys().into_iter();
    let keys = keys.filter_map(|(key, stated)| Some((key, stated?)));
    let keys: Vec<(&str, String)> = keys.collect();
    let kind = |only: &String| Kind::NAMED.into_iter().find(|(name, _)| name == only);
    let options = Options {
        only: args.only.as_ref().and_then(kind).map(|(_, kind)| kind),
        keys: &keys,
        gear: args.gear,
    };
    let found = import::tables(&args.file, bytes, &options);
    Ok(found.map_err(|mut error| {
        let unnamed = |problem: &&mut Problem| problem.help == import::NAME_COLUMNS;
        for problem in error.problems.iter_mut().filter(unnamed) {
            problem.help +=
                "; as options --only pitch --tooth-column A --left B --right C, or --only span --tooth-column A --column B";
        }
        if args.of_tables() {
            for problem in &mut error.problems {
                problem.help = args.as_options(&problem.help);
            }
        }
        error
    })?)
}

/// Options for a gearbox model.
#[derive(clap::Args)]
struct RexsArgs {
    /// Stage of a gearbox model, by its id
    #[arg(long, value_name = "ID", allow_negative_numbers = true)]
    stage: Option<i32>,
    /// Pair file of a gearbox model, - for standard output alone
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl RexsArgs {
    /// Whether an option is given.
    fn is_given(&self) -> bool {
        self.stage.is_some() || self.output.is_some()
    }
}

/// Prints the content of the model at `path`, and the pair file of a stage.
fn model(path: &Path, args: &RexsArgs, screen: &Screen) -> Result<u8, Error> {
    let file = rexs::read(path)?;
    check_streams_not_input(&file.sources)?;
    let name = gearlash_text::display_path(path).display().to_string();
    let chosen = match args.stage {
        Some(id) => Ok(pair_of(&name, &file, id)?),
        None => only_readable_stage(&file),
    };
    if let (Err(why), Some(_)) = (&chosen, &args.output) {
        let reasons = file.stages.iter().filter_map(|stage| {
            let reason = stage.pair.as_ref().err()?;
            Some(format!("; stage {}: {reason}", stage.id))
        });
        let is_readable = file.stages.iter().any(|stage| stage.pair.is_ok());
        let reasons: String = reasons.filter(|_| !is_readable).collect();
        return Err(Error::Usage(format!("{name}: {why}{reasons}")));
    }
    if args.output.as_deref() != Some(Path::new("-")) {
        let mut text = text::gearbox(&name, &file, screen);
        match &chosen {
            Ok(pair) => text += &format!("\n{}", text::gearbox_pair(pair, screen)),
            Err(why) => text += &format!("\n{why}\n"),
        }
        if let (Ok(pair), None) = (&chosen, &args.output) {
            text += &format!("\n{}", pair.pair_file);
        }
        print(&text)?;
    }
    if let (Some(output), Ok(pair)) = (&args.output, chosen) {
        Target::prepare_new(output, &file.sources, "import")?.write(&pair.pair_file)?;
    }
    Ok(0)
}

/// The only readable stage, or the remedy.
fn only_readable_stage(file: &RexsFile) -> Result<&RexsPair, String> {
    let stages = file.stages.iter();
    let mut pairs = stages.filter_map(|stage| stage.pair.as_ref().ok());
    match (pairs.next(), pairs.next()) {
        (Some(pair), None) => Ok(pair),
        (None, _) => Err("No stage can be read".to_owned()),
        _ => Err("Several stages can be read: choose one with --stage ID.".to_owned()),
    }
}

/// The pair of the stage with an id in the model called `name`.
fn pair_of<'a>(name: &str, file: &'a RexsFile, id: i32) -> Result<&'a RexsPair, Error> {
    let Some(stage) = file.stage(id) else {
        let ids = file.stages.iter().map(|stage| stage.id.to_string());
        let ids = ids.collect::<Vec<_>>().join(", ");
        return Err(Error::Usage(format!(
            "{name}: has no stage {id}, its stages are {ids}"
        )));
    };
    let left_out = |why| Error::Usage(format!("{name}: stage {id} is left out: {why}"));
    stage.pair.as_ref().map_err(left_out)
}
