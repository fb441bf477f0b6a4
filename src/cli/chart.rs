//! `gearlash chart`: curves and bars as SVG.

use super::distances::{self, Distances};
use super::drawing::{End, material, teeth};
use super::method::{MethodArgs, agreement, agreement_within};
use super::progress::Progress;
use super::target::Target;
use super::warn;
use crate::curves::{self, Course};
use crate::error::Error;
use crate::gear::Inspection;
use crate::input;
use crate::render::chart::{self, Chart};
use crate::study::Study;
use clap::ValueEnum;
use std::path::PathBuf;
use std::process::ExitCode;

/// Draw backlash over teeth or centre distance, or a gear's deviations, as SVG
///
/// The poses are the pair file's where it sweeps a revolution, and one wheel revolution at 16 poses a pitch
/// where it does not. Made for 800 px and for A4, for print in black and white and for the colour-blind.
#[derive(clap::Args)]
pub(super) struct Args {
    /// The pair file (TOML or JSON)
    pair: PathBuf,
    /// What to draw
    #[arg(long, value_enum)]
    kind: Kind,
    /// The gear, for --kind inspection [default: wheel]
    #[arg(long, value_enum)]
    gear: Option<Gear>,
    /// Centre distance in mm, for --kind revolution and difference [default: the first of the pair file]
    #[arg(long, value_name = "A", value_parser = distances::parse)]
    center_distance: Option<Distances>,
    /// One end of the thickness tolerances, for --kind revolution and difference [default: both]
    #[arg(long, value_enum)]
    material: Option<End>,
    /// Wheel tooth and pinion tooth, for --kind distance [default: the first mating of the pair file]
    #[arg(long, value_name = "W,P", value_parser = teeth)]
    mating: Option<(u32, u32)>,
    /// The chart [default: out/<file stem>/chart_….svg]; - for standard output
    #[arg(short, long, value_name = "FILE.svg")]
    output: Option<PathBuf>,
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
}

#[derive(Clone, Copy, ValueEnum)]
enum Gear {
    Wheel,
    Pinion,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    check_options(args)?;
    let study = input::read(&args.pair)?;
    warn(&args.pair, &study.warnings, &study.remarks);
    let stem = study.stem.clone();
    let drawn = match args.kind {
        Kind::Revolution | Kind::Difference => over_teeth(args, study)?,
        Kind::Distance => over_distance(args, &study)?,
        Kind::Inspection => inspection(args, &study)?,
    };
    let target = match &args.output {
        Some(file) => file.clone(),
        None => PathBuf::from("out").join(stem).join(drawn.file),
    };
    Target::prepare(target)?.write(drawn.chart.svg)?;
    Ok(if drawn.agrees {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(1)
    })
}

/// A chart and the name of its file.
struct Drawn {
    chart: Chart,
    file: String,
    /// Whether both methods agree, where both were asked for.
    agrees: bool,
}

/// Options that say nothing about the kind asked for are mistakes.
fn check_options(args: &Args) -> Result<(), Error> {
    let over_teeth = matches!(args.kind, Kind::Revolution | Kind::Difference);
    for (given, suits, option, kinds) in [
        (
            args.gear.is_some(),
            args.kind == Kind::Inspection,
            "--gear",
            "inspection",
        ),
        (
            args.mating.is_some(),
            args.kind == Kind::Distance,
            "--mating",
            "distance",
        ),
        (
            args.center_distance.is_some(),
            over_teeth,
            "--center-distance",
            "revolution or difference",
        ),
        (
            args.material.is_some(),
            over_teeth,
            "--material",
            "revolution or difference",
        ),
    ] {
        if given && !suits {
            return Err(Error::Usage(format!(
                "{option} belongs to --kind {kinds}; leave it out"
            )));
        }
    }
    Ok(())
}

fn over_teeth(args: &Args, study: Study) -> Result<Drawn, Error> {
    let mut study = curves::swept(study);
    if let Some(end) = args.material {
        let wanted = material(end, &study)?;
        study.materials.retain(|(material, ..)| *material == wanted);
    }
    let distance = match &args.center_distance {
        Some(Distances(given)) if given.len() == 1 => given.clone(),
        Some(_) => {
            return Err(Error::Usage(
                "--center-distance: a chart is drawn at one centre distance".to_owned(),
            ));
        }
        None => study.center_distances.iter().take(1).copied().collect(),
    };
    if args.center_distance.is_none() && study.center_distances.len() > 1 {
        eprintln!(
            "note: at the first of {} centre distances; choose with --center-distance",
            study.center_distances.len()
        );
    }
    let study = study
        .at(distance)
        .map_err(|reason| Error::Usage(format!("--center-distance: {reason}")))?;
    let progress = Progress::start(curves::revolution_pose_count(&study)?);
    let runs = curves::revolution(&study, args.method.method(), &|| progress.tick())?;
    progress.finish()?;
    let courses = curves::courses(&runs);
    let course = courses
        .first()
        .ok_or_else(|| Error::Usage("the pair file asks for no poses".to_owned()))?;
    if let (Some((wheel, pinion)), true) = (course.phase, courses.len() > 1) {
        eprintln!(
            "note: phase {wheel},{pinion}, the first of {}; for another give [sweep] revolutions and start",
            courses.len()
        );
    }
    let (name, chart) = match args.kind {
        Kind::Difference => (
            "difference",
            chart::difference("chart", &study.title, course, study.tolerance_um)?,
        ),
        _ => (
            "revolution",
            chart::revolution("chart", &study.title, course)?,
        ),
    };
    Ok(Drawn {
        file: file(name, args, course),
        agrees: agreement(&runs),
        chart,
    })
}

fn file(name: &str, args: &Args, course: &Course) -> String {
    let end = match args.material {
        Some(End::Most) => "_most",
        Some(End::Least) => "_least",
        None => "",
    };
    format!("chart_{name}_a{}{end}.svg", course.center_distance)
}

fn over_distance(args: &Args, study: &Study) -> Result<Drawn, Error> {
    let progress = Progress::start(curves::over_distance_pose_count(study));
    let method = args.method.method();
    let curve = curves::over_distance(study, args.mating, method, &|| progress.tick())?;
    progress.finish()?;
    let (wheel, pinion) = curve.mating;
    Ok(Drawn {
        chart: chart::distance("chart", &study.title, &curve)?,
        file: format!("chart_distance_{wheel}_{pinion}.svg"),
        agrees: agreement_within(curve.polygon_difference),
    })
}

fn inspection(args: &Args, study: &Study) -> Result<Drawn, Error> {
    let gears = study.materials.first();
    let (_, wheel, pinion) =
        gears.ok_or_else(|| Error::Usage("the pair file has no gears".to_owned()))?;
    let (name, gear) = match args.gear {
        Some(Gear::Pinion) => ("pinion", pinion),
        Some(Gear::Wheel) | None => ("wheel", wheel),
    };
    let inspection = Inspection::of(gear);
    Ok(Drawn {
        chart: chart::inspection("chart", &study.title, name, &inspection)?,
        file: format!("chart_inspection_{name}.svg"),
        agrees: true,
    })
}
