//! K (8), the study's rule against non-involute contact, beside what the outlines do: `docs/explanation/interference.md`.
//!
//! K (8) forbids a tip to reach past the point where the line of action touches the mate's base circle. A tool that cuts a flank so far down undercuts
//! it, and takes away the metal that the tip would have touched. The involute begins at the form circle, so a tip may touch a fillet where K (8) is
//! met. Nominal pairs of module 1 stand at the play-free distance and closer. The loss is the formula's backlash less that of the outlines.
//!
//! `cargo run --release --example k8_against_geometry`

#[path = "../common/kit.rs"]
mod kit;

use gearlash::analytic::{InvolutePair, limits};
use gearlash::contact::ExactKernel;
use gearlash::pair::{Member, Pose};
use kit::{at, ends, pair, spur};
use rayon::prelude::*;

/// Poses a pitch.
const PHASES: u32 = 24;
/// Losses below a nanometre are none, µm.
const NOTHING: f64 = 1e-3;

/// Closer than the play-free distance by these, modules: as drawn, and with the radial clearance at its lower limit.
const CLOSER: [f64; 2] = [0.0, limits::RECOMMENDED_CLEARANCE - limits::LEAST_CLEARANCE];
/// Root radii of the tool, modules.
const ROOT_RADII: [f64; 2] = [0.38, 0.2];

/// Whether a pair keeps K (8), whether a gear of it is undercut, and the greatest loss, µm.
type Finding = (bool, bool, f64);

fn finding(teeth: [u32; 2], root_radius: f64, closer: f64) -> Finding {
    let gears = teeth.map(|teeth| spur(teeth, 1.0).rack(1.0, 1.25, root_radius));
    let distance = f64::from(teeth[0] + teeth[1]) / 2.0 - closer;
    let assembly = pair(&gears[0], &gears[1], distance);
    let kernel = ExactKernel::new(&assembly);
    let formula = InvolutePair::of(&assembly).base_backlash(distance);
    let base = assembly.gear(Member::Pinion).gear().base_radius();
    let phases = (0..PHASES).map(|phase| f64::from(phase) / f64::from(PHASES));
    let losses = phases.filter_map(|phase| {
        let pose = Pose::new(&assembly, at(1, 1, phase));
        let found = kernel.lost_motion(&pose).unwrap();
        Some(1e3 * (formula? - found.angle()? * base))
    });
    let [_, loss] = ends(losses.chain([0.0]));
    let mut members = Member::BOTH.into_iter();
    let margin = |member| limits::non_involute_margin(&assembly, member);
    let keeps = members.all(|member| margin(member) >= -limits::MET_WITHIN);
    let undercut = gears.iter().any(|gear| {
        let least =
            limits::least_shift_without_undercut(&gear.design.basic_data, &gear.design.rack);
        gear.gear().generating_shift() < least
    });
    (keeps, undercut, loss)
}

fn main() {
    println!(
        "lost at 24 phases, µm   as drawn: K (8), 0.38 m, 0.20 m   0.1 m closer: K (8), 0.38 m, 0.20 m"
    );
    for teeth in [[20, 30], [17, 40], [14, 25], [12, 60], [17, 100]] {
        let mut line = format!("z {:<19}", format!("{}/{}", teeth[0], teeth[1]));
        for closer in CLOSER {
            let [usual, sharp] = ROOT_RADII.map(|radius| finding(teeth, radius, closer));
            let k_8 = if usual.0 { "kept" } else { "violated" };
            line += &format!("      {k_8:<8} {:9.3} {:9.3}   ", usual.2, sharp.2);
        }
        println!("{}", line.trim_end());
    }
    let grid = (8..=40).flat_map(|z_1| (20..=120).map(move |z_2| [z_1, z_2]));
    let grid: Vec<[u32; 2]> = grid.collect();
    for (closer, place) in CLOSER.into_iter().zip(["as drawn", "0.1 m closer"]) {
        for root_radius in ROOT_RADII {
            let found = grid.par_iter();
            let found = found.map(|&teeth| finding(teeth, root_radius, closer));
            let found: Vec<Finding> = found.collect();
            let (kept, violated): (Vec<&Finding>, Vec<&Finding>) =
                found.iter().partition(|found| found.0);
            let lose = |some: &[&Finding]| some.iter().filter(|found| found.2 > NOTHING).count();
            println!(
                "z 8…40 × 20…120, {place}, {root_radius:.2} m: violated {} ({} undercut), {} of them lose; kept {}, {} of them lose, {:.1} µm at most",
                violated.len(),
                violated.iter().filter(|found| found.1).count(),
                lose(&violated),
                kept.len(),
                lose(&kept),
                ends(kept.iter().map(|found| found.2))[1],
            );
        }
    }
}
