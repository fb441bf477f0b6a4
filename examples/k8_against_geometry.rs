//! K (8), the study's rule against non-involute contact, beside what the outlines do.
//!
//! K (8) forbids a tip to reach past the point where the line of action touches
//! the mate's base circle. A tool that cuts a flank so far down undercuts it, and
//! takes away the very metal that the tip would have touched; on the other
//! hand the involute begins not at the base circle but at the form circle, so a
//! tip may touch a fillet where K (8) is content. Nominal pairs of module 1 at
//! play-free distance: the formula's backlash is 0, what is less is lost.
//!
//! `cargo run --release --example k8_against_geometry`

use gearlash::analytic::{InvolutePair, limits};
use gearlash::error::Error;
use gearlash::gear::{AsBuilt, Blank, Face, Gear, Rack, Side, Toothing};
use gearlash::mesh::ExactKernel;
use gearlash::pair::{Assembly, Mating, Member, Pose};
use rayon::prelude::*;

/// Poses a pitch.
const PHASES: u32 = 24;
/// Losses below a nanometre are none, mm.
const NOTHING: f64 = 1e-6;

/// What both say of one pair.
struct Finding {
    k_8: bool,
    undercut: bool,
    loss: f64,
}

fn gear(teeth: u32, root_radius: f64, face: Face) -> Result<AsBuilt, Error> {
    let blank = Blank {
        toothing: Toothing::new(teeth, 1.0, 20f64.to_radians())?,
        profile_shift: 0.0,
        rack: Rack::new(1.0, 1.25, root_radius)?,
        tip_diameter: None,
    };
    Ok(AsBuilt::perfect(Gear::nominal(blank)?, face))
}

fn finding(teeth: (u32, u32), root_radius: f64) -> Result<Finding, Error> {
    let assembly = Assembly::new(
        gear(teeth.0, root_radius, Face::Front)?,
        gear(teeth.1, root_radius, Face::Back)?,
        f64::from(teeth.0 + teeth.1) / 2.0,
        Member::Wheel,
    )?;
    let kernel = ExactKernel::new(&assembly);
    let formula = InvolutePair::of(&assembly).normal_backlash(assembly.center_distance());
    let base = assembly.gear(Member::Pinion).gear().base_radius();
    let mut loss = 0f64;
    for phase in 0..PHASES {
        let mating = Mating {
            wheel_tooth: 1,
            pinion_tooth: 1,
            flank: Side::Right,
            fraction: f64::from(phase) / f64::from(PHASES),
        };
        let found = kernel.lost_motion(&Pose::new(&assembly, mating))?;
        if let (Some(angle), Some(formula)) = (found.angle(), formula) {
            loss = loss.max(formula - angle * base);
        }
    }
    let members = [Member::Wheel, Member::Pinion];
    Ok(Finding {
        k_8: members
            .iter()
            .all(|m| limits::non_involute_margin(&assembly, *m) >= -limits::MET_WITHIN),
        undercut: members.iter().any(|m| {
            let gear = assembly.gear(*m).gear();
            let least = limits::least_shift_without_undercut(gear.toothing(), &gear.blank().rack);
            gear.generating_shift() < least
        }),
        loss,
    })
}

fn main() -> Result<(), Error> {
    println!("pair      root radius 0.38 m             root radius 0.20 m");
    for teeth in [(20, 30), (17, 40), (14, 25), (12, 60), (17, 100)] {
        let mut line = format!("{:<7}", format!("{}/{}", teeth.0, teeth.1));
        for root_radius in [0.38, 0.2] {
            let found = finding(teeth, root_radius)?;
            let k_8 = if found.k_8 { "kept" } else { "violated" };
            line += &format!("   K (8) {k_8:<8} {:6.3} µm lost", found.loss * 1e3);
        }
        println!("{line}");
    }
    for root_radius in [0.38, 0.2] {
        let grid: Vec<(u32, u32)> = (8..=40)
            .flat_map(|z_1| (20..=120).map(move |z_2| (z_1, z_2)))
            .collect();
        let found: Result<Vec<Finding>, Error> = grid
            .par_iter()
            .map(|&teeth| finding(teeth, root_radius))
            .collect();
        let found = found?;
        let count = |which: fn(&Finding) -> bool| found.iter().filter(|f| which(f)).count();
        let most = found.iter().map(|f| f.loss).fold(0.0, f64::max);
        println!(
            "z 8…40 × 20…120, root radius {root_radius:.2} m: K (8) violated by {} of {} pairs; {} of these lose backlash",
            count(|f| !f.k_8),
            found.len(),
            count(|f| !f.k_8 && f.loss > NOTHING),
        );
        println!(
            "    ({} of them undercut), {} of those that keep it do; most lost {:.3} µm",
            count(|f| !f.k_8 && f.undercut),
            count(|f| f.k_8 && f.loss > NOTHING),
            most * 1e3,
        );
    }
    Ok(())
}
