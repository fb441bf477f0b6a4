//! `gearlash snapshot`: one contact as a picture.

use super::console::{tell, tell_verdict};
use super::distances;
use super::drawing::{End, material, teeth};
use super::method::{MethodArgs, all_proven};
use super::pictures::{exaggeration, pitch};
use super::target::Target;
use super::worst::{self, Binding, Wanted};
use super::{outlines, studies};
use crate::error::{Error, exit_code};
use clap::ValueEnum;
use gearlash::analysis::study::{Material, Study};
use gearlash::analysis::{self, outlines::OutlinePose};
use gearlash::contact::{LostMotion, MeshSection, PoseResult, Unproven};
use gearlash::gear::Side;
use gearlash::outline::OutlinePair;
use gearlash::pair::{GearPair, Mating, Member, Pose};
use gearlash_files::{AnyPair, OutlinePairFile, PairFile};
use gearlash_render::Snapshot;
use std::path::PathBuf;
use std::process::ExitCode;

/// Draw the contact at one pose as SVG
///
/// True to scale: both outlines in the mesh, pitch and base circles, line and path of contact, both
/// contacts with their normals, the gap or overlap, and an enlarged inset of each contact.
#[derive(clap::Args)]
pub(super) struct Args {
    /// The pair file (TOML or JSON), - for standard input
    pair: PathBuf,
    /// Wheel tooth and pinion tooth that mate, such as 11,11
    #[arg(long, value_name = "W,P", value_parser = teeth)]
    mating: Option<(u32, u32)>,
    /// Flank, seen from the front, that passes through the operating pitch point
    #[arg(long, value_enum)]
    flank: Option<Flank>,
    /// The pose with the least backlash of the whole mesh cycle, instead of --mating and --flank; with KIND of the poses of the pair file that
    /// such a contact bounds
    #[arg(long, value_name = "KIND", value_enum, num_args = 0..=1, require_equals = true, conflicts_with_all = ["mating", "flank", "fraction"])]
    worst: Option<Option<Binding>>,
    /// The pose with the greatest backlash of the whole mesh cycle
    #[arg(long, conflicts_with_all = ["mating", "flank", "fraction", "worst"])]
    greatest: bool,
    /// Turn on from that pose by this many pitches
    #[arg(
        long,
        value_name = "F",
        default_value_t = 0.0,
        allow_negative_numbers = true
    )]
    fraction: f64,
    /// Centre distance in mm [default: the least of the pair file; with --worst or --greatest all]
    #[arg(long, alias = "centre-distance", value_name = "A", value_parser = distances::one, allow_hyphen_values = true)]
    center_distance: Option<f64>,
    /// Which end of the thickness tolerances [default: most, where there are two; with --worst or --greatest both]
    #[arg(long, value_enum)]
    material: Option<End>,
    /// Of helical gears, the transverse section to draw, mm along the axis from the measuring plane [default: where the flank of the pose touches]
    #[arg(long, value_name = "Z_MM", allow_negative_numbers = true)]
    section: Option<f64>,
    /// Draw the deviations (thickness, pitch, eccentricity) this many times as large, in front of perfect teeth
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    exaggerate: Option<f64>,
    /// Turn the gears through a pitch from this pose on, in contact: an animated SVG for a browser; of helical gears in the section drawn
    #[arg(long, conflicts_with = "exaggerate")]
    animate: bool,
    /// The picture [default: out/<file stem>/snapshot_….svg, worst_….svg or greatest_….svg]; - for standard output
    #[arg(short, long, value_name = "FILE.svg")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Flank {
    Right,
    Left,
}

impl Flank {
    fn side(self) -> Side {
        match self {
            Flank::Right => Side::Right,
            Flank::Left => Side::Left,
        }
    }
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let PairFile {
        study,
        stem,
        sources,
        ..
    } = match studies::any(&args.pair)? {
        AnyPair::Data(file) => *file,
        AnyPair::Outlines(file) => return of_outlines(args, *file),
    };
    check_section(args, &study)?;
    let title = study.title.clone();
    let given = Target::prepare_given(args.output.as_ref(), &sources)?;
    let subject = subject(args, study)?;
    let section = section(args, &subject)?;
    let view = Snapshot {
        title: &title,
        assembly: &subject.assembly,
        pose: &subject.pose,
        material: subject.material,
        found: subject.found.as_ref(),
        section: section.as_ref(),
    };
    let mut unproven = subject.unproven;
    let picture = match args.exaggerate {
        None if args.animate => {
            let steps = pitch(&subject.assembly, &subject.pose)?;
            unproven += steps.iter().filter(|step| step.is_unproven()).count();
            let sections = sections(&subject.assembly, &steps, section.as_ref())?;
            gearlash_render::animation(&view, &steps, &sections)
        }
        None => gearlash_render::snapshot(&view),
        Some(factor) => {
            let drawn = section.as_ref().map(MeshSection::pair);
            let gears = exaggeration(drawn.unwrap_or(&subject.assembly), factor)?;
            gearlash_render::exaggerated(&view, &gears)
        }
    };
    let target = match given {
        Some(target) => target,
        None => {
            let name = match args.section {
                Some(at) => subject.file.replace(".svg", &format!("_z{at}.svg")),
                None => subject.file,
            };
            Target::prepare_own(&stem, name, &sources)?
        }
    };
    target.write(&picture)?;
    Ok(exit_code(all_proven(unproven)))
}

/// That what is asked for can be drawn of this pair.
fn check_section(args: &Args, study: &Study) -> Result<(), Error> {
    match args.section {
        Some(_) if !study.is_helical() => Err(Error::Usage(SPUR_SECTION.to_owned())),
        _ => Ok(()),
    }
}

const SPUR_SECTION: &str =
    "--section is for helical gears: every section of these gears is the same; leave it out";

/// The section of helical gears that is drawn.
fn section(args: &Args, subject: &Subject) -> Result<Option<MeshSection>, Error> {
    let assembly = &subject.assembly;
    if !assembly.is_helical() {
        return Ok(None);
    }
    let found = subject.found.as_ref().ok();
    let at = args
        .section
        .unwrap_or_else(|| MeshSection::of_contact(assembly, &subject.pose, found));
    let section = MeshSection::new(assembly, &subject.pose, found, at);
    section.map(Some).map_err(|reason| match args.section {
        Some(at) => Error::Usage(format!("--section {at}: {reason}")),
        None => reason.into(),
    })
}

/// Each of `steps` in the section that the first is drawn in; none of spur gears.
fn sections(
    assembly: &GearPair,
    steps: &[PoseResult],
    first: Option<&MeshSection>,
) -> Result<Vec<MeshSection>, Error> {
    let Some(first) = first else {
        return Ok(Vec::new());
    };
    let steps = steps.iter();
    let sections =
        steps.map(|step| MeshSection::new(assembly, &step.pose, step.proven(), first.at()));
    Ok(sections.collect::<Result<_, _>>()?)
}

/// The same of a pair of which a gear is an outline.
fn of_outlines(args: &Args, mut file: OutlinePairFile) -> Result<ExitCode, Error> {
    if args.animate || args.exaggerate.is_some() {
        return Err(Error::Usage(
            "--animate and --exaggerate are for gears by their data; leave them out".to_owned(),
        ));
    }
    if args.section.is_some() {
        return Err(Error::Usage(SPUR_SECTION.to_owned()));
    }
    let given = Target::prepare_given(args.output.as_ref(), &file.sources)?;
    if let Some(distance) = args.center_distance {
        file = file.at(vec![distance]);
    }
    if let Some(end) = args.material {
        let wanted = end.material();
        file.study.materials.retain(|gears| gears.0 == wanted);
    }
    let mut unproven = 0;
    let drawn = match (wanted(args), args.mating, args.flank) {
        (Some((asked, Wanted::LeastOf(_))), ..) => {
            return Err(Error::Usage(format!(
                "{asked}: the kinds of contact are of gears by their data; give --worst alone"
            )));
        }
        (Some((_, wanted)), ..) => {
            let runs = outlines::runs(&file, &MethodArgs::default())?;
            unproven = analysis::outlines::unproven(&runs);
            tell_verdict(&gearlash_results::outlines::lines(&file.study, &runs));
            let (chosen, name) = match wanted {
                Wanted::Greatest => (analysis::outlines::greatest(&runs), "greatest"),
                _ => (analysis::outlines::worst(&runs), "worst"),
            };
            chosen.map(|(run, pose)| {
                (
                    run.pair.clone(),
                    run.material,
                    pose.clone(),
                    name.to_owned(),
                )
            })
        }
        (None, Some(teeth), Some(flank)) => {
            let Some((material, wheel, pinion)) = file.study.materials.first().cloned() else {
                return Err(Error::Usage(
                    "--material: this pair has no such material".to_owned(),
                ));
            };
            let distance = file.study.center_distances[0];
            let pair = OutlinePair::new(wheel, pinion, distance, file.study.locked);
            let pair = pair.map_err(gearlash::error::Error::from)?;
            let flank = flank.side();
            let count = |member| pair.gear(member).teeth();
            let mating = mating(teeth, args.fraction, count, flank)?;
            let pose = OutlinePose::of(&pair, mating);
            let name = format!("snapshot_{}_{}_{}", teeth.0, teeth.1, flank.name());
            Some((pair, material, pose, name))
        }
        _ => return Err(which()),
    };
    let Some((pair, material, pose, name)) = drawn else {
        let asked = wanted(args).map_or("--mating", |(asked, _)| asked);
        return Err(Error::Usage(format!(
            "{asked}: no pose is in mesh; there is none to draw"
        )));
    };
    let picture = gearlash_render::outline_snapshot(&file.study.title, &pair, material, &pose);
    let target = match given {
        Some(target) => target,
        None => {
            let name = format!("{name}_a{}_{}.svg", pair.center_distance(), material.name());
            Target::prepare_own(&file.stem, name, &file.sources)?
        }
    };
    target.write(&picture)?;
    Ok(exit_code(all_proven(
        unproven.max(usize::from(pose.found.is_err())),
    )))
}

/// The pose that is asked for by its backlash, and the option that asks for it.
fn wanted(args: &Args) -> Option<(&'static str, Wanted)> {
    match args.worst {
        Some(None) => Some(("--worst", Wanted::Least)),
        Some(Some(binding)) => Some(("--worst", Wanted::LeastOf(binding))),
        None => args.greatest.then_some(("--greatest", Wanted::Greatest)),
    }
}

fn which() -> Error {
    Error::Usage(
        "which pose? give --mating W,P and --flank right|left, --worst or --greatest".to_owned(),
    )
}

/// What is drawn, and the name of its file.
struct Subject {
    material: Material,
    assembly: GearPair,
    pose: Pose,
    found: Result<LostMotion, Unproven>,
    /// Poses that are not proven: this one, or those that the worst was looked for among.
    unproven: usize,
    file: String,
}

/// The pose asked for, by its teeth or by its backlash.
fn subject(args: &Args, study: Study) -> Result<Subject, Error> {
    if let Some((asked, wanted)) = wanted(args) {
        let material = args.material.map(|end| material(end, &study)).transpose()?;
        let (run, pose, unproven) =
            worst::find((asked, wanted), study, args.center_distance, material)?;
        let (distance, end) = (run.assembly.center_distance(), run.material.name());
        let name = match wanted {
            Wanted::Least => "worst".to_owned(),
            Wanted::Greatest => "greatest".to_owned(),
            Wanted::LeastOf(binding) => {
                let kind = binding.to_possible_value();
                format!("worst_{}", kind.as_ref().map_or("", |kind| kind.get_name()))
            }
        };
        return Ok(Subject {
            file: format!("{name}_a{distance}_{end}.svg"),
            material: run.material,
            assembly: run.assembly,
            pose: pose.pose,
            found: pose.found,
            unproven,
        });
    }
    let (Some(teeth), Some(flank)) = (args.mating, args.flank) else {
        return Err(which());
    };
    let (material, assembly) = assembly(args, &study)?;
    let flank = flank.side();
    let count = |member| assembly.teeth(member);
    let mating = mating(teeth, args.fraction, count, flank)?;
    let result = assembly.lost_motion(mating)?;
    Ok(Subject {
        file: format!(
            "snapshot_{}_{}_{}_a{}_{}.svg",
            mating.wheel_tooth,
            mating.pinion_tooth,
            flank.name(),
            assembly.center_distance(),
            material.name()
        ),
        material,
        assembly,
        pose: result.pose,
        unproven: usize::from(result.is_unproven()),
        found: result.found,
    })
}

/// The gears at the material and centre distance asked for.
fn assembly(args: &Args, study: &Study) -> Result<(Material, GearPair), Error> {
    let wanted = match args.material {
        Some(end) => material(end, study)?,
        None if study.materials.len() == 1 => Material::AsMeasured,
        None => Material::Most,
    };
    let first = study.center_distances.first().copied();
    let Some(distance) = args.center_distance.or(first) else {
        return Err(Error::Usage(
            "--center-distance: the pair file has none; give one".to_owned(),
        ));
    };
    if args.center_distance.is_none() && study.center_distances.len() > 1 {
        tell(&format!(
            "note: at centre distance {distance} mm, the least of {}; choose with --center-distance",
            study.center_distances.len()
        ));
    }
    let gears = study
        .materials
        .iter()
        .find(|(material, ..)| *material == wanted);
    let Some((material, wheel, pinion)) = gears else {
        return Err(Error::Usage(
            "--material: the pair file has no such material".to_owned(),
        ));
    };
    study
        .pair(wheel, pinion, distance)
        .map(|assembly| (*material, assembly))
        .map_err(|reason| Error::Usage(format!("--center-distance {distance}: {reason}")))
}

fn mating(
    (wheel_tooth, pinion_tooth): (u32, u32),
    fraction: f64,
    teeth: impl Fn(Member) -> u32,
    flank: Side,
) -> Result<Mating, Error> {
    for (member, tooth) in [(Member::Wheel, wheel_tooth), (Member::Pinion, pinion_tooth)] {
        let teeth = teeth(member);
        if !(1..=teeth).contains(&tooth) {
            return Err(Error::Usage(format!(
                "--mating {wheel_tooth},{pinion_tooth}: the {} has teeth 1 … {teeth}, not {tooth}",
                member.name()
            )));
        }
    }
    if !(fraction.abs() <= 1000.0) {
        return Err(Error::Usage(format!(
            "--fraction {fraction}: a number of pitches between -1000 and 1000"
        )));
    }
    Ok(Mating {
        wheel_tooth,
        pinion_tooth,
        flank,
        fraction,
    })
}
