//! `gearlash snapshot`: one contact as a picture.

use crate::console::print_note_line;
use crate::cycle::{self, Binding, Found, Wanted};
use crate::distances;
use crate::error::{Error, exit_code};
use crate::input;
use crate::options::{self, FLANKS, MATERIALS, all_proven, material, name_of, one_of, teeth};
use crate::output::Target;
use gearlash::analysis::study::{Material, Study};
use gearlash::contact::{
    Exaggeration, MeshSection, Method, PoseResult, lost_motion_at, sweep_blocks,
};
use gearlash::error::go_on;
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash::pair::{GearPair, Mating, Member, Pose};
use gearlash_render::Snapshot;
use std::path::PathBuf;

/// Draw the contact at one pose as SVG
///
/// True to scale: both outlines in the mesh, pitch and base circles, line and path of contact, both
/// contacts with their normals, the gap or overlap, and an enlarged inset of each contact.
#[derive(clap::Args)]
pub(super) struct Args {
    /// Pair file (TOML or JSON), - for standard input
    pair: PathBuf,
    /// Wheel and pinion tooth that mate, such as 11,11
    #[arg(long, value_name = "W,P", value_parser = teeth)]
    mating: Option<(u32, u32)>,
    /// Flank at the pitch point, seen from the front
    #[arg(long, value_parser = one_of(FLANKS))]
    flank: Option<Side>,
    /// Pose with the least backlash of the mesh cycle; with a kind, of the poses that such a contact bounds
    #[arg(long, value_name = "KIND", value_enum, num_args = 0..=1, require_equals = true, conflicts_with_all = ["mating", "flank", "fraction"])]
    worst: Option<Option<Binding>>,
    /// Pose with the greatest backlash of the mesh cycle
    #[arg(long, conflicts_with_all = ["mating", "flank", "fraction", "worst"])]
    greatest: bool,
    /// Pitches to turn on from that pose
    #[arg(
        long,
        value_name = "F",
        default_value_t = 0.0,
        allow_negative_numbers = true
    )]
    fraction: f64,
    /// Centre distance, mm [default: the least; with --worst or --greatest all]
    #[arg(long, alias = "centre-distance", value_name = "A", value_parser = distances::one, allow_hyphen_values = true)]
    center_distance: Option<f64>,
    /// End of the thickness tolerance [default: most; with --worst or --greatest both]
    #[arg(long, value_parser = one_of(MATERIALS))]
    material: Option<Material>,
    /// Transverse section, mm from the measuring plane [default: where the flank touches]
    #[arg(long, value_name = "Z_MM", allow_negative_numbers = true)]
    section: Option<f64>,
    /// Enlarge thickness, pitch and eccentricity, on perfect teeth
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    exaggerate: Option<f64>,
    /// Turn the gears through a pitch: an animated SVG for a browser
    #[arg(long, conflicts_with = "exaggerate")]
    animate: bool,
    /// Picture, - for standard output [default: in out/<file stem>]
    #[arg(short, long, value_name = "FILE.svg")]
    output: Option<PathBuf>,
}

pub(super) fn run(args: &Args) -> Result<u8, Error> {
    let file = input::pair(&args.pair)?;
    let (study, sources) = (&file.study, &file.sources);
    if args.section.is_some() && !study.varies_along_face() {
        return Err(Error::usage(
            "--section: every section of these gears is the same; leave it out",
        ));
    }
    if args.exaggerate.is_some() {
        options::by_data(
            study,
            "--exaggerate is for gears by their data: a drawing states no deviations; leave it out",
        )?;
    }
    let given = Target::prepare_given(args.output.as_ref(), sources)?;
    let (subject, name) = subject(args, study.clone())?;
    let (picture, unproven) = picture(args, &study.title, &subject)?;
    let section = args.section.map(|at| format!("_z{at}"));
    let name = format!("{name}{}.svg", section.unwrap_or_default());
    let target = Target::given_or_own(given, &file.stem, &name, sources)?;
    target.write(&picture)?;
    Ok(exit_code(all_proven(subject.unproven + unproven)))
}

/// The picture, and the number of unproven poses in it beside the subject.
fn picture(args: &Args, title: &str, subject: &Found) -> Result<(String, usize), Error> {
    let pose = &subject.pose;
    let assembly = &subject.assembly;
    let pair = assembly.data();
    let varied = pair.filter(|pair| pair.varies_along_face());
    let section = varied.map(|pair| section(args, pair, pose)).transpose()?;
    let view = Snapshot::of_result(title, assembly, subject.material, pose, section.as_ref());
    Ok(match (pair, args.exaggerate) {
        _ if args.animate => {
            let steps = pitch(assembly, &pose.pose)?;
            let unproven = steps.iter().filter(|step| step.is_unproven()).count();
            // Each step in the section of the first.
            let mut sections = Vec::new();
            if let (Some(pair), Some(first)) = (varied, &section) {
                for step in &steps {
                    let found = step.proven();
                    sections.push(MeshSection::new(pair, &step.pose, found, first.at())?);
                }
            }
            let picture = gearlash_render::animation(&view, &steps, &sections);
            (picture, unproven)
        }
        (Some(pair), Some(factor)) => {
            let drawn = section.as_ref().and_then(|section| section.pair().data());
            let gears = exaggeration(drawn.unwrap_or(pair), factor)?;
            (gearlash_render::exaggerated(&view, &gears), 0)
        }
        _ => (gearlash_render::snapshot(&view), 0),
    })
}

/// The section to draw.
fn section(args: &Args, assembly: &GearPair, pose: &PoseResult) -> Result<MeshSection, Error> {
    let found = pose.proven();
    let at = args
        .section
        .unwrap_or_else(|| MeshSection::of_contact(assembly, &pose.pose, found));
    let section = MeshSection::new(assembly, &pose.pose, found, at);
    section.map_err(|reason| match args.section {
        Some(at) => Error::Usage(format!("--section {at}: {reason}")),
        None => reason.into(),
    })
}

/// The requested pose, by its teeth or by its backlash, and the name of its file without extension.
fn subject(args: &Args, study: Study) -> Result<(Found, String), Error> {
    let wanted = match args.worst {
        Some(None) => Some(("--worst", Wanted::Least)),
        Some(Some(binding)) => Some(("--worst", Wanted::LeastOf(binding))),
        None => args.greatest.then_some(("--greatest", Wanted::Greatest)),
    };
    if let Some((option, wanted)) = wanted {
        let material = args.material.map(|end| material(end, &study)).transpose()?;
        let found = cycle::find((option, wanted), study, args.center_distance, material)?;
        let (distance, end) = (found.assembly.center_distance(), found.material.name());
        let name = match wanted {
            Wanted::Least => "worst".to_owned(),
            Wanted::Greatest => "greatest".to_owned(),
            Wanted::LeastOf(binding) => format!("worst_{}", name_of(&binding)),
        };
        return Ok((found, format!("{name}_a{distance}_{end}")));
    }
    let (Some(teeth), Some(flank)) = (args.mating, args.flank) else {
        return Err(Error::usage(
            "which pose? give --mating W,P and --flank right|left, --worst or --greatest",
        ));
    };
    let (material, assembly) = assembly(args, &study)?;
    let mating = mating(teeth, args.fraction, &assembly, flank)?;
    let result = lost_motion_at(&assembly, mating)?;
    let file = format!(
        "snapshot_{}_{}_{}_a{}_{}",
        mating.wheel_tooth,
        mating.pinion_tooth,
        flank.name(),
        assembly.center_distance(),
        material.name()
    );
    let found = Found {
        material,
        assembly,
        unproven: usize::from(result.is_unproven()),
        pose: result,
    };
    Ok((found, file))
}

/// The gears at the requested material and centre distance.
fn assembly(args: &Args, study: &Study) -> Result<(Material, AssembledPair), Error> {
    let wanted = match args.material {
        Some(end) => material(end, study)?,
        None if study.material_count() == 1 => Material::AsMeasured,
        None => Material::Most,
    };
    let first = study.center_distances.first().copied();
    let Some(distance) = args.center_distance.or(first) else {
        return Err(Error::usage(
            "--center-distance: the pair file has none; give one",
        ));
    };
    if args.center_distance.is_none() && study.center_distances.len() > 1 {
        print_note_line(&format!(
            "note: at centre distance {distance} mm, the least of {}; choose with --center-distance",
            study.center_distances.len()
        ));
    }
    let pairs = study
        .pairs(distance)
        .map_err(|reason| Error::Usage(format!("--center-distance {distance}: {reason}")))?;
    let pair = pairs.into_iter().find(|(material, _)| *material == wanted);
    pair.ok_or_else(|| Error::usage("--material: the pair file has no such material"))
}

fn mating(
    (wheel_tooth, pinion_tooth): (u32, u32),
    fraction: f64,
    assembly: &AssembledPair,
    flank: Side,
) -> Result<Mating, Error> {
    for (member, tooth) in [(Member::Wheel, wheel_tooth), (Member::Pinion, pinion_tooth)] {
        let teeth = assembly.teeth(member);
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
        fraction,
        ..Mating::at(wheel_tooth, pinion_tooth, flank)
    })
}

/// Steps of an animation: ten per second.
const STEPS: u32 = 60;

/// Steps between the neighbours of an extreme, and the number of refinements: to a 60 000th of a pitch, over which j_wt changes
/// by less than a hundredth of a micrometre.
const FINER: u32 = 20;
const ROUNDS: usize = 3;
/// Differences below this, mm, are rounding.
const ROUNDING: f64 = 1e-9;

/// The results at every step through a pitch from `pose` on, both ends included, and at the least and greatest backlash between
/// them.
fn pitch(assembly: &AssembledPair, pose: &Pose) -> Result<Vec<PoseResult>, Error> {
    let method = Method::Exact { certify: true };
    let between = |[from, to]: [f64; 2], steps: u32| {
        let at = |step: u32| from + (to - from) * (f64::from(step) / f64::from(steps));
        let matings: Vec<Mating> = (0..=steps)
            .map(|step| Mating {
                fraction: at(step),
                ..*pose.mating()
            })
            .collect();
        let mut found = Vec::new();
        let each = &mut |poses: Vec<PoseResult>| {
            found.extend(poses);
            Ok::<(), Error>(())
        };
        sweep_blocks(assembly, None, method, &matings, 0.0, &go_on, each)?;
        Ok::<Vec<PoseResult>, Error>(found)
    };
    let start = pose.mating().fraction;
    let mut steps = between([start, start + 1.0], STEPS)?;
    let mut extremes = Vec::new();
    for sign in [1.0, -1.0] {
        for place in (0..steps.len()).filter(|place| is_extreme(&steps, *place, sign)) {
            let (mut near, mut place) = (steps.clone(), place);
            for _ in 0..ROUNDS {
                let ends = [place.saturating_sub(1), (place + 1).min(near.len() - 1)];
                near = between(ends.map(|place| fraction(&near[place])), FINER)?;
                let Some(found) = extreme(&near, sign) else {
                    break;
                };
                place = found;
            }
            extremes.push(near.swap_remove(place));
        }
    }
    steps.extend(extremes);
    steps.sort_by(|a, b| fraction(a).total_cmp(&fraction(b)));
    steps.dedup_by(|a, b| fraction(a) == fraction(b));
    Ok(steps)
}

fn fraction(step: &PoseResult) -> f64 {
    step.pose.mating().fraction
}

/// The step with the least backlash (`sign` 1) or the greatest (−1).
fn extreme(steps: &[PoseResult], sign: f64) -> Option<usize> {
    let known = steps.iter().enumerate();
    let known = known.filter_map(|(place, step)| Some((place, sign * step.backlash?)));
    let least = known.reduce(|least, next| if next.1 < least.1 { next } else { least });
    least.map(|(place, _)| place)
}

/// Whether backlash at a step is less (`sign` 1) or greater (−1) than at the steps beside it.
fn is_extreme(steps: &[PoseResult], place: usize, sign: f64) -> bool {
    let value = |place: usize| Some(sign * steps.get(place)?.backlash?);
    let beyond = |other: Option<f64>| match (value(place), other) {
        (Some(here), Some(other)) => here < other - ROUNDING,
        (here, None) => here.is_some(),
        (None, _) => false,
    };
    let before = place.checked_sub(1).and_then(value);
    beyond(before) && beyond(value(place + 1))
}

/// Factors to suggest, and the range of allowed ones.
const FACTORS: [f64; 16] = [
    100_000.0, 50_000.0, 20_000.0, 10_000.0, 5000.0, 2000.0, 1000.0, 500.0, 200.0, 100.0, 50.0,
    20.0, 10.0, 5.0, 2.0, 1.0,
];

/// Both gears with their deviations enlarged by `factor`. An error names a factor that works.
fn exaggeration(assembly: &GearPair, factor: f64) -> Result<Exaggeration<'_>, Error> {
    if !(FACTORS[15]..=FACTORS[0]).contains(&factor) {
        return Err(Error::Usage(format!(
            "--exaggerate {factor}: a factor between 1 and {}",
            FACTORS[0]
        )));
    }
    Exaggeration::new(assembly, factor).map_err(|reason| {
        let fits =
            |smaller: &f64| *smaller < factor && Exaggeration::new(assembly, *smaller).is_ok();
        let advice = match FACTORS.into_iter().find(fits) {
            Some(smaller) => format!("; {smaller} would do"),
            None => String::new(),
        };
        Error::Usage(format!("--exaggerate {factor}: {reason}{advice}"))
    })
}
