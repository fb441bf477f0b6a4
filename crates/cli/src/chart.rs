//! `gearlash chart`: curves and bars as SVG.

mod drawn;

use super::distances::{self, Distances};
use super::gears::{GearName, MaterialName, teeth};
use super::method::MethodArgs;
use super::studies;
use super::target::Target;
use super::unit::UnitArgs;
use crate::error::{Error, exit_code};
use clap::ValueEnum;
use drawn::DrawnChart;
use std::path::PathBuf;
use std::process::ExitCode;

/// Draw backlash over teeth or centre distance, or a gear's deviations, as SVG
///
/// The poses are the pair file's where it sweeps a revolution, and one wheel revolution at 16 poses a pitch
/// where it does not; of a pair with an outline they are those of the whole mesh cycle (--kind revolution or map). Legible at 800 px, on A4, in black and white, and for colour-blind readers.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair file (TOML or JSON), - for standard input
    pair: PathBuf,
    /// Kind of chart
    #[arg(long, value_enum)]
    kind: Kind,
    /// Gear, for --kind inspection [default: wheel]
    #[arg(long, value_enum)]
    gear: Option<GearName>,
    /// Centre distance, mm, for --kind revolution, difference and field [default: the least; of a field that which binds]
    #[arg(long, alias = "centre-distance", value_name = "A", value_parser = distances::parse, allow_hyphen_values = true)]
    center_distance: Option<Distances>,
    /// End of the thickness tolerance, for --kind revolution, difference and field [default: both]
    #[arg(long, value_enum)]
    material: Option<MaterialName>,
    /// Wheel and pinion tooth, for --kind distance [default: the pose that binds]
    #[arg(long, value_name = "W,P", value_parser = teeth)]
    mating: Option<(u32, u32)>,
    /// Chart, - for standard output [default: in out/<file stem>]
    #[arg(short, long, value_name = "FILE.svg")]
    output: Option<PathBuf>,
    #[command(flatten)]
    unit: UnitArgs,
    #[command(flatten)]
    method: MethodArgs,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Kind {
    /// Backlash over the wheel's teeth, most to least material, right and left flanks
    Revolution,
    /// Backlash over the centre distance, with bearing clearance, beside what was measured
    Distance,
    /// Simulated minus analytic backlash over the wheel's teeth
    Difference,
    /// Pitch, thickness and runout of one gear, tooth by tooth
    Inspection,
    /// Contacts (backlash for outlines) over centre distance and mesh phase, as `check --map`
    Map,
    /// Helical gears: where over the common face and on the path of contact the teeth touch at the pose that binds
    Field,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    check_options(args)?;
    let file = studies::pair(&args.pair)?;
    let (study, sources) = (&file.study, &file.sources);
    let given = Target::prepare_given(args.output.as_ref(), sources)?;
    let drawn = match args.kind {
        Kind::Revolution | Kind::Difference => DrawnChart::over_teeth(args, study.clone())?,
        Kind::Distance => DrawnChart::over_distance(args, study)?,
        Kind::Inspection => DrawnChart::inspection(args, study)?,
        Kind::Map => DrawnChart::map(args, study)?,
        Kind::Field => DrawnChart::field(args, study.clone())?,
    };
    let target = match given {
        Some(target) => target,
        None => Target::prepare_own(&file.stem, drawn.file, sources)?,
    };
    target.write(&drawn.svg)?;
    Ok(exit_code(drawn.agrees))
}

/// Rejects options that do not apply to the kind of chart.
fn check_options(args: &Args) -> Result<(), Error> {
    let belongs = |is_given: bool, option: &str, kinds: &[Kind]| {
        if !is_given || kinds.contains(&args.kind) {
            return Ok(());
        }
        let names = kinds.iter().filter_map(ValueEnum::to_possible_value);
        let names: Vec<String> = names.map(|kind| kind.get_name().to_owned()).collect();
        let last = names.last().cloned().unwrap_or_default();
        let kinds = match &names[..names.len() - 1] {
            [] => last,
            others => format!("{} or {last}", others.join(", ")),
        };
        Err(Error::Usage(format!(
            "{option} belongs to --kind {kinds}; leave it out"
        )))
    };
    let of_poses = [Kind::Revolution, Kind::Difference, Kind::Field];
    belongs(args.gear.is_some(), "--gear", &[Kind::Inspection])?;
    belongs(args.mating.is_some(), "--mating", &[Kind::Distance])?;
    belongs(
        args.center_distance.is_some(),
        "--center-distance",
        &of_poses,
    )?;
    belongs(args.material.is_some(), "--material", &of_poses)?;
    let with_unit = [Kind::Revolution, Kind::Distance];
    belongs(args.unit.given(), "--unit", &with_unit)
}
