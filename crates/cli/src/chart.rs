//! `gearlash chart`: curves and bars as SVG.

use crate::console::{print_note_line, print_verdict_lines};
use crate::cycle::{self, Wanted};
use crate::distances::{self, Distances};
use crate::error::{Error, exit_code};
use crate::input;
use crate::maps;
use crate::options::{self, GEARS, MATERIALS, MethodArgs, UnitArgs};
use crate::options::{agreed, agreement_of, all_proven, material, name_of, one_of, teeth};
use crate::output::Target;
use crate::progress::{Progress, run_under_bar};
use clap::ValueEnum;
use gearlash::analysis::compare::ComparedRun;
use gearlash::analysis::curves::{self, Followed};
use gearlash::analysis::outcome::by_distance;
use gearlash::analysis::study::{Material, Study};
use gearlash::analysis::{Analysis, Plan};
use gearlash::contact::Method;
use gearlash::error::{Error as Run, GearError};
use gearlash::gear::Inspection;
use gearlash::pair::{BacklashUnit, Member};
use gearlash_input::PairFile;
use gearlash_render::chart::{self, Heading};
use gearlash_results::gauge::stated_leads;
use gearlash_results::verdict::extremes_in_short;
use gearlash_text::characters::listed;
use std::path::PathBuf;

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
    #[arg(long, value_parser = one_of(GEARS))]
    gear: Option<Member>,
    /// Centre distance, mm, for --kind revolution, difference and field [default: the least; of a field that which binds]
    #[arg(long, alias = "centre-distance", value_name = "A", value_parser = distances::parse, allow_hyphen_values = true)]
    center_distance: Option<Distances>,
    /// End of the thickness tolerance, for --kind revolution, difference and field [default: both]
    #[arg(long, value_parser = one_of(MATERIALS))]
    material: Option<Material>,
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
    /// Gears that vary along the face: where over it and on the path of contact the teeth touch at the pose that binds
    Field,
}

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    check_options(args)?;
    let file = input::pair(&args.pair)?;
    let (study, sources) = (&file.study, &file.sources);
    let given = Target::prepare_given(args.output.as_ref(), sources)?;
    let drawn = match args.kind {
        Kind::Revolution | Kind::Difference => DrawnChart::over_teeth(args, study.clone())?,
        Kind::Distance => DrawnChart::over_distance(args, study)?,
        Kind::Inspection => DrawnChart::inspection(args, &file)?,
        Kind::Map => DrawnChart::map(args, study)?,
        Kind::Field => DrawnChart::field(args, study.clone())?,
    };
    let target = Target::given_or_own(given, &file.stem, &drawn.file, sources)?;
    target.write(&drawn.svg)?;
    Ok(exit_code(drawn.agrees))
}

/// Rejects options that do not apply to the kind of chart.
fn check_options(args: &Args) -> Result<(), Error> {
    let belongs = |is_given: bool, option: &str, kinds: &[Kind]| {
        if !is_given || kinds.contains(&args.kind) {
            return Ok(());
        }
        let kinds: Vec<String> = kinds.iter().map(name_of).collect();
        let kinds = listed(&kinds, "or");
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

/// A chart and the name of its file.
struct DrawnChart {
    svg: String,
    file: String,
    /// Whether every pose is proven, and both methods agree where both are requested.
    agrees: bool,
}

impl DrawnChart {
    /// A curve over the teeth at one centre distance.
    fn over_teeth(args: &Args, study: Study) -> Result<DrawnChart, Error> {
        let unit = args.unit.unit(&study)?;
        let mut study = curves::with_sweep(study);
        if let Some(end) = args.material {
            let wanted = material(end, &study)?;
            study.keep(wanted);
        }
        let stated = &study.center_distances;
        let requested = requested_distance(args)?;
        if requested.is_none() && stated.len() > 1 {
            print_note_line(&format!(
                "note: at the least of {} centre distances; choose with --center-distance",
                stated.len()
            ));
        }
        let distance = requested.or(stated.first().copied());
        let refused = |reason| Error::Usage(format!("--center-distance: {reason}"));
        let study = study.at(Vec::from_iter(distance)).map_err(refused)?;
        let plan = Plan::new(&study, args.method.of(&study)?);
        let plan = plan.with_revolution().with_extremes();
        input::allow(&args.pair, plan.poses(), &input::HELD)?;
        let analysis = run_under_bar(&plan)?;
        let courses = curves::courses(&analysis.curves);
        let none = || Error::usage("the pair file asks for no poses");
        let course = courses.first().ok_or_else(none)?;
        if let (Some((wheel, pinion)), true) = (course.phase, courses.len() > 1) {
            print_note_line(&format!(
                "note: phase {wheel},{pinion}, the first of {}; for another give [sweep] revolutions and start",
                courses.len()
            ));
        }
        let each = &analysis.extremes.each;
        let course = &course.clone().with_cycle(each, &study.requirements);
        let cycle = print_verdict(&analysis, unit);
        let heading = Heading::alone(&study.title, &cycle);
        let end = args.material.map(|end| format!("_{}", end.name()));
        let (name, chart) = match args.kind {
            Kind::Difference => {
                let chart = chart::difference(&heading, course, study.tolerance_um)?;
                ("difference", chart)
            }
            _ => ("revolution", chart::revolution(unit, &heading, course)),
        };
        Ok(DrawnChart {
            svg: chart.svg,
            file: format!(
                "chart_{name}_a{}{}{}.svg",
                course.center_distance,
                end.unwrap_or_default(),
                suffix(unit)
            ),
            agrees: agreed(&analysis),
        })
    }

    /// One mating over the centre distance.
    fn over_distance(args: &Args, study: &Study) -> Result<DrawnChart, Error> {
        let unit = args.unit.unit(study)?;
        let whole = match args.mating {
            Some(_) => None,
            None => Some(whole_analysis(args, study)?),
        };
        let all: Vec<&ComparedRun> = whole.iter().flat_map(Analysis::all).collect();
        let followed = match args.mating {
            Some((wheel, pinion)) => Followed::Teeth(wheel, pinion),
            None => curves::binding(study, all.iter().copied()),
        };
        let (wheel, pinion) = match followed {
            Followed::Teeth(wheel, pinion) => (wheel, pinion),
            Followed::Pose(mating) => (mating.wheel_tooth, mating.pinion_tooth),
        };
        if args.mating.is_none() {
            print_note_line(&format!(
                "note: mating {wheel},{pinion}, in which the backlash is least (the teeth of the verdict are those in contact); choose with --mating"
            ));
        }
        let poses = curves::over_distance_pose_count(study);
        input::allow(&args.pair, poses, &input::HELD)?;
        let progress = Progress::of(poses, "poses");
        let (method, tick) = (args.method.method(), |steps| progress.tick(steps));
        let cycle = whole.as_ref().map_or(&[][..], |whole| &whole.extremes.each);
        let curve = curves::over_distance(study, followed, cycle, method, &tick);
        let curve = curve.map_err(|error| match (error, args.mating) {
            (Run::Gear(reason @ GearError::NoSuchTooth { .. }), Some((wheel, pinion))) => {
                Error::Usage(format!("--mating {wheel},{pinion}: {reason}"))
            }
            (error, _) => error.into(),
        })?;
        drop(progress);
        let unproven = curve.unproven + whole.as_ref().map_or(0, Analysis::unproven);
        let cycle = whole.as_ref().map(|whole| print_verdict(whole, unit));
        let cycle = cycle.unwrap_or_default();
        let heading = Heading::alone(&study.title, &cycle);
        Ok(DrawnChart {
            svg: chart::distance(unit, &heading, &curve, &by_distance(&all, &[]))?.svg,
            file: format!("chart_distance_{wheel}_{pinion}{}.svg", suffix(unit)),
            agrees: agreement_of(curve.agreement) & all_proven(unproven),
        })
    }

    /// One gear's deviations.
    fn inspection(args: &Args, file: &PairFile) -> Result<DrawnChart, Error> {
        let study = &file.study;
        let reason = "--kind inspection is for gears by their data: a drawing states no deviations";
        let member = args.gear.unwrap_or(Member::Wheel);
        let gear = options::by_data(study, reason)?[member as usize];
        let lead = file.spec.data(member);
        let lead = lead.and_then(|spec| stated_leads(gear, spec));
        let heading = Heading::alone(&study.title, "");
        let inspection = Inspection::of(gear);
        Ok(DrawnChart {
            svg: chart::inspection_and_leads(&heading, member.name(), &inspection, lead.as_ref())?
                .svg,
            file: format!("chart_inspection_{}.svg", member.name()),
            agrees: true,
        })
    }

    /// Contacts over centre distance and mesh phase.
    fn map(args: &Args, study: &Study) -> Result<DrawnChart, Error> {
        input::allow(&args.pair, study.pose_count(), &input::HELD)?;
        let plan = Plan::new(study, args.method.of(study)?)
            .with_extremes()
            .with_checks();
        let analysis = run_under_bar(&plan)?;
        print_verdict_lines(&analysis.verdict());
        let maps = maps::of(&analysis)?;
        if maps.len() > 1 {
            print_note_line("note: with the most material; `gearlash check --map` draws both");
        }
        let first = maps.into_iter().next();
        let none = || Error::usage("no pose with a backlash was found to map from");
        Ok(DrawnChart {
            svg: first.ok_or_else(none)?.svg,
            file: "chart_map.svg".to_owned(),
            agrees: agreed(&analysis),
        })
    }

    /// The field of action at the pose that binds.
    fn field(args: &Args, study: Study) -> Result<DrawnChart, Error> {
        if !study.varies_along_face() {
            return Err(Error::usage(
                "--kind field is for helical gears, leads and leaning axes: along the face of this pair nothing changes",
            ));
        }
        let distance = requested_distance(args)?;
        let end = args.material.map(|end| material(end, &study)).transpose()?;
        let title = study.title.clone();
        let found = cycle::find(("--kind field", Wanted::Least), study, distance, end)?;
        let drawn = chart::field_at_least(&title, found.material, &found.assembly, &found.pose);
        let Some(drawn) = drawn else {
            return Err(Error::usage(
                "--kind field: the worst pose is jammed or unproven; there are no contact lines",
            ));
        };
        let a = found.assembly.center_distance();
        Ok(DrawnChart {
            svg: drawn.svg,
            file: format!("chart_field_a{a}_{}.svg", found.material.name()),
            agrees: all_proven(found.unproven),
        })
    }
}

/// The requested centre distance.
fn requested_distance(args: &Args) -> Result<Option<f64>, Error> {
    match args.center_distance.as_ref().map(|given| &given.0[..]) {
        None => Ok(None),
        Some([only]) => Ok(Some(*only)),
        Some(_) => Err(Error::usage(
            "--center-distance: a chart is drawn at one centre distance",
        )),
    }
}

/// Prints the verdict on standard error; returns it in short for a picture. It is in µm, so a picture of angles has none.
fn print_verdict(analysis: &Analysis, unit: BacklashUnit) -> String {
    let verdict = analysis.verdict();
    print_verdict_lines(&verdict);
    match unit {
        BacklashUnit::Um => extremes_in_short(&verdict),
        BacklashUnit::Arcmin { .. } => String::new(),
    }
}

/// Suffix of the file name of a chart in `unit`; empty for µm.
fn suffix(unit: BacklashUnit) -> String {
    match unit {
        BacklashUnit::Um => String::new(),
        BacklashUnit::Arcmin { at, .. } => format!("_arcmin_{}", at.name()),
    }
}

/// Whole revolutions, the poses of the pair file and the rest of the mesh cycle, as in a report.
fn whole_analysis<'a>(args: &Args, study: &'a Study) -> Result<Analysis<'a>, Error> {
    // These poses only select and bound the curve; the drawn curve itself is certified.
    let method = Method::Exact { certify: false };
    let plan = Plan::new(study, method).with_revolution().with_extremes();
    input::allow(&args.pair, plan.poses(), &input::HELD)?;
    run_under_bar(&plan)
}
