//! K (8), the study's rule against non-involute contact, beside what the outlines do.
//!
//! K (8) forbids a tip to reach past the point where the line of action touches
//! the mate's base circle. A tool that cuts a flank so far down undercuts it, and
//! takes away the very metal that the tip would have touched; on the other
//! hand the involute begins not at the base circle but at the form circle, so a
//! tip may touch a fillet where K (8) is content. Nominal pairs of module 1, at
//! the play-free distance as drawn and closer: what is less than the formula's backlash is lost.
//!
//! `cargo run --release --example k8_against_geometry`

use gearlash::analytic::{InvolutePair, limits};
use gearlash::contact::ExactKernel;
use gearlash::error::Error;
use gearlash::gear::{AsBuilt, BasicGearData, BasicRack, Face, Gear, GearDesign, Side};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use rayon::prelude::*;

/// Poses a pitch.
const PHASES: u32 = 24;
/// Losses below a nanometre are none, mm.
const NOTHING: f64 = 1e-6;

/// Closer than the play-free distance by these, modules: as drawn, and with the radial clearance at its lower limit.
const CLOSER: [f64; 2] = [0.0, limits::RECOMMENDED_CLEARANCE - limits::LEAST_CLEARANCE];
/// Root radii of the tool, modules.
const ROOT_RADII: [f64; 2] = [0.38, 0.2];

/// The findings of both for one pair.
struct Finding {
    k_8: bool,
    undercut: bool,
    loss: f64,
}

fn gear(teeth: u32, root_radius: f64, face: Face) -> Result<AsBuilt, Error> {
    let design = GearDesign {
        basic_data: BasicGearData::new(teeth, 1.0, 20f64.to_radians())?,
        profile_shift: 0.0,
        rack: BasicRack::new(1.0, 1.25, root_radius)?,
        tip_diameter: None,
    };
    Ok(AsBuilt::perfect(Gear::nominal(design)?, face))
}

fn finding(teeth: (u32, u32), root_radius: f64, closer: f64) -> Result<Finding, Error> {
    let assembly = GearPair::with_locked(
        gear(teeth.0, root_radius, Face::Front)?,
        gear(teeth.1, root_radius, Face::Back)?,
        f64::from(teeth.0 + teeth.1) / 2.0 - closer,
        Member::Wheel,
    )?;
    let kernel = ExactKernel::new(&assembly);
    let formula = InvolutePair::of(&assembly).base_backlash(assembly.center_distance());
    let base = assembly.gear(Member::Pinion).gear().base_radius();
    let mut loss = 0f64;
    for phase in 0..PHASES {
        let mating = Mating {
            fraction: f64::from(phase) / f64::from(PHASES),
            ..Mating::at(1, 1, Side::Right)
        };
        let found = kernel.lost_motion(&Pose::new(&assembly, mating))?;
        if let (Some(angle), Some(formula)) = (found.angle(), formula) {
            loss = loss.max(formula - angle * base);
        }
    }
    let margins = Member::BOTH.map(|m| limits::non_involute_margin(&assembly, m));
    let undercut = Member::BOTH.map(|m| {
        let gear = assembly.gear(m).gear();
        let least = limits::least_shift_without_undercut(gear.basic_data(), &gear.design().rack);
        gear.generating_shift() < least
    });
    Ok(Finding {
        k_8: margins.iter().all(|margin| *margin >= -limits::MET_WITHIN),
        undercut: undercut.contains(&true),
        loss,
    })
}

fn main() -> Result<(), Error> {
    println!(
        "lost at 24 phases, µm   as drawn: K (8), 0.38 m, 0.20 m   0.1 m closer: K (8), 0.38 m, 0.20 m"
    );
    for teeth in [(20, 30), (17, 40), (14, 25), (12, 60), (17, 100)] {
        let mut line = format!("z {:<19}", format!("{}/{}", teeth.0, teeth.1));
        for closer in CLOSER {
            let [usual, sharp] = ROOT_RADII.map(|radius| finding(teeth, radius, closer));
            let (usual, sharp) = (usual?, sharp?);
            let k_8 = if usual.k_8 { "kept" } else { "violated" };
            let [usual, sharp] = [usual.loss * 1e3, sharp.loss * 1e3];
            line += &format!("      {k_8:<8} {usual:9.3} {sharp:9.3}   ");
        }
        println!("{}", line.trim_end());
    }
    let grid = (8..=40).flat_map(|z_1| (20..=120).map(move |z_2| (z_1, z_2)));
    let grid: Vec<(u32, u32)> = grid.collect();
    for (closer, place) in CLOSER.into_iter().zip(["as drawn", "0.1 m closer"]) {
        for root_radius in ROOT_RADII {
            let found = grid
                .par_iter()
                .map(|&teeth| finding(teeth, root_radius, closer));
            let found = found.collect::<Result<Vec<Finding>, Error>>()?;
            let (kept, violated): (Vec<&Finding>, Vec<&Finding>) =
                found.iter().partition(|f| f.k_8);
            let lose = |some: &[&Finding]| some.iter().filter(|f| f.loss > NOTHING).count();
            println!(
                "z 8…40 × 20…120, {place}, {root_radius:.2} m: violated {} ({} undercut), {} of them lose; kept {}, {} of them lose, {:.1} µm at most",
                violated.len(),
                violated.iter().filter(|f| f.undercut).count(),
                lose(&violated),
                kept.len(),
                lose(&kept),
                kept.iter().map(|f| f.loss * 1e3).fold(0.0, f64::max),
            );
        }
    }
    Ok(())
}
