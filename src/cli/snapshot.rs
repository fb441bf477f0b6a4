//! `gearlash snapshot`: one contact as a picture.

use super::{print, warn};
use crate::error::Error;
use crate::gear::Side;
use crate::input;
use crate::mesh::{Certifier, CutPair, ExactKernel};
use crate::output::OutputFolder;
use crate::pair::{Assembly, Mating, Member, Pose};
use crate::render::{self, Snapshot};
use crate::study::{Material, Study};
use clap::ValueEnum;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Draw the contact at one pose as SVG
///
/// True to scale: both outlines in the mesh, pitch and base circles, line and path of contact, both
/// contacts with their normals, the gap or overlap, and an enlarged inset of each contact.
#[derive(clap::Args)]
pub(super) struct Args {
    /// The pair file (TOML or JSON)
    pair: PathBuf,
    /// Wheel tooth and pinion tooth that mate, such as 11,11
    #[arg(long, value_name = "W,P", value_parser = teeth)]
    mating: (u32, u32),
    /// Flank, seen from the front, that passes through the operating pitch point
    #[arg(long, value_enum)]
    flank: Flank,
    /// Pitches beyond that pose
    #[arg(
        long,
        value_name = "F",
        default_value_t = 0.0,
        allow_negative_numbers = true
    )]
    fraction: f64,
    /// Centre distance in mm [default: the first of the pair file]
    #[arg(long, value_name = "A")]
    center_distance: Option<f64>,
    /// Which end of the thickness tolerances [default: most, where there are two]
    #[arg(long, value_enum)]
    material: Option<End>,
    /// The picture [default: out/<file stem>/snapshot_….svg]; - for standard output
    #[arg(short, long, value_name = "FILE.svg")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Flank {
    Right,
    Left,
}

#[derive(Clone, Copy, ValueEnum)]
enum End {
    Most,
    Least,
}

fn teeth(text: &str) -> Result<(u32, u32), String> {
    let parsed = text.split_once(',').and_then(|(wheel, pinion)| {
        Some((wheel.trim().parse().ok()?, pinion.trim().parse().ok()?))
    });
    parsed.ok_or_else(|| "two tooth numbers are needed, wheel,pinion, such as 11,11".to_owned())
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, Error> {
    let study = input::read(&args.pair)?;
    warn(&args.pair, &study.warnings);
    let (material, assembly) = assembly(args, &study)?;
    let flank = match args.flank {
        Flank::Right => Side::Right,
        Flank::Left => Side::Left,
    };
    let mating = mating(args, &assembly, flank)?;
    let name = format!(
        "snapshot_{}_{}_{}_a{}_{}.svg",
        mating.wheel_tooth,
        mating.pinion_tooth,
        flank.name(),
        assembly.center_distance(),
        material.name()
    );
    let target = match &args.output {
        Some(file) => file.clone(),
        None => PathBuf::from("out").join(&study.stem).join(name),
    };
    let pose = Pose::new(&assembly, mating);
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member));
    let lost_motion = ExactKernel::new(&assembly).lost_motion(&pose)?;
    let cut = CutPair::new(wheel, pinion, study.chord);
    Certifier::new(cut.kernel(&assembly)).check(&pose, &lost_motion)?;
    let picture = render::snapshot(&Snapshot {
        title: &study.title,
        assembly: &assembly,
        pose: &pose,
        material: material.name(),
        lost_motion: &lost_motion,
    });
    if target == Path::new("-") {
        print(&picture);
        return Ok(ExitCode::SUCCESS);
    }
    let missing_name = || Error::Usage(format!("-o {}: this names no file", target.display()));
    let file = target.file_name().ok_or_else(missing_name)?;
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    OutputFolder::prepare(folder)?.write(&[(file.to_string_lossy().into_owned(), picture)])?;
    print(&format!("{}\n", target.display()));
    Ok(ExitCode::SUCCESS)
}

/// The gears at the material and centre distance asked for.
fn assembly(args: &Args, study: &Study) -> Result<(Material, Assembly), Error> {
    let wanted = match (args.material, study.materials.len()) {
        (None, 1) => Material::AsMeasured,
        (None, _) | (Some(End::Most), 2) => Material::Most,
        (Some(End::Least), 2) => Material::Least,
        (Some(_), _) => {
            return Err(Error::Usage(
                "--material: this pair file states one thickness a gear; leave the option out"
                    .to_owned(),
            ));
        }
    };
    let first = study.center_distances.first().copied();
    let Some(distance) = args.center_distance.or(first) else {
        return Err(Error::Usage(
            "--center-distance: the pair file has none; give one".to_owned(),
        ));
    };
    if args.center_distance.is_none() && study.center_distances.len() > 1 {
        eprintln!(
            "note: at centre distance {distance} mm, the first of {}; choose with --center-distance",
            study.center_distances.len()
        );
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
    Assembly::new(wheel.clone(), pinion.clone(), distance, study.locked)
        .map(|assembly| (*material, assembly))
        .map_err(|reason| Error::Usage(format!("--center-distance {distance}: {reason}")))
}

fn mating(args: &Args, assembly: &Assembly, flank: Side) -> Result<Mating, Error> {
    let (wheel_tooth, pinion_tooth) = args.mating;
    for (member, tooth) in [(Member::Wheel, wheel_tooth), (Member::Pinion, pinion_tooth)] {
        let teeth = assembly.gear(member).gear().toothing().teeth();
        if !(1..=teeth).contains(&tooth) {
            return Err(Error::Usage(format!(
                "--mating {wheel_tooth},{pinion_tooth}: the {} has teeth 1 … {teeth}, not {tooth}",
                member.name()
            )));
        }
    }
    if !(args.fraction.abs() <= 1000.0) {
        return Err(Error::Usage(format!(
            "--fraction {}: a number of pitches between -1000 and 1000",
            args.fraction
        )));
    }
    Ok(Mating {
        wheel_tooth,
        pinion_tooth,
        flank,
        fraction: args.fraction,
    })
}
