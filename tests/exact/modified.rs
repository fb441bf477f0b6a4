//! Gears whose profiles deviate: the exact method against polygons, certificate, outlines and brute force.

use crate::clearance;
use crate::random::{self, Random};
use gearlash::contact::{Certifier, Contact, CutGear, ExactKernel, PolygonKernel, Status};
use gearlash::gear::{AsBuilt, Deviations, Flank, Gear, Modification, Pitch, Relief, Trace};
use gearlash::pair::{GearPair, Member, Pose};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// A profile on some of a gear's flanks, from none to twenty times what a shop tolerates.
pub fn profile(random: &mut Random, gear: &Gear, traces: bool) -> Modification {
    let um = 1e-3 * gear.basic_data().module() * random.decades(0.1, 10.0);
    let base = gear.base_radius();
    let rolls = [gear.form_roll(), gear.tip_roll()];
    let at = |share: f64| rolls[0] + (rolls[1] - rolls[0]) * share;
    let radius = |roll: f64| base * roll.hypot(1.0);
    let mut modification = Modification::default();
    if random.chance(0.4) {
        modification.slope = um * random.within(-5.0, 5.0);
    }
    if random.chance(0.4) {
        modification.crowning = um * random.within(-2.0, 5.0);
    }
    let mut relief = |from: f64| {
        random.chance(0.4).then(|| Relief {
            amount: um * random.within(0.0, 10.0),
            from: radius(at(from + random.within(-0.2, 0.2))),
            parabolic: random.chance(0.5),
        })
    };
    modification.tip_relief = relief(0.7);
    modification.root_relief = relief(0.25);
    let teeth = gear.basic_data().teeth();
    if traces && random.chance(0.4) {
        let mut trace = |tooth| {
            let count = 2 + (random.bits() % 30) as usize;
            let deviation = |k: usize| {
                let roll = at(k as f64 / (count - 1) as f64);
                (roll.max(1e-6 * k as f64), um * random.within(-1.0, 1.0))
            };
            Trace {
                tooth,
                points: (0..count).map(deviation).collect(),
            }
        };
        modification.traces = match teeth % 3 {
            0 => vec![trace(None)],
            _ => (1..=teeth.min(4)).map(|tooth| trace(Some(tooth))).collect(),
        };
    }
    modification
}

/// A random pair with random profiles; `None` where one cannot exist.
pub fn pair(random: &mut Random, traces: bool) -> Option<GearPair> {
    let plain = random::pair(random, random::WILD);
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|member| {
        let built = plain.gear(member);
        let gear = built.gear().clone();
        let deviations = Deviations {
            eccentricity: built.eccentricity(),
            high_tooth: built.high_tooth(),
            pitch: Some(pitch(built)),
            profiles: [0; 2].map(|_| profile(random, &gear, traces)),
            ..Deviations::default()
        };
        AsBuilt::new(gear, built.face(), &deviations).ok()
    });
    GearPair::with_locked(wheel?, pinion?, plain.center_distance(), plain.locked()).ok()
}

/// The places of a gear's flanks as a pitch deviation.
fn pitch(built: &AsBuilt) -> Pitch {
    let r = built.gear().basic_data().reference_radius();
    let curve = |own: Flank| -> Vec<f64> {
        let side = built.face().seen_from_front(own);
        let teeth = 1..=built.gear().basic_data().teeth();
        let along = built.face().ascending() * r;
        teeth
            .map(|tooth| along * built.flank_offset(side, tooth))
            .collect()
    };
    Pitch::from_cumulative(&curve(Flank::Right), &curve(Flank::Left))
}

fn within(one: Option<Contact>, other: Option<Contact>, what: &dyn Fn() -> String) {
    assert_eq!(one.is_some(), other.is_some(), "{}", what());
    if let Some((one, other)) = one.zip(other) {
        let off = one.rotation - other.rotation;
        let turns = (off / TAU).round();
        let off = (off - TAU * turns).abs();
        // The last term is the rounding of an angle of this many turns.
        let bound = one.error + other.error + 1e-14 * (1.0 + turns.abs());
        assert!(
            off <= bound,
            "{off:e} above {bound:e}: {one:?} {other:?} {}",
            what()
        );
    }
}

/// Gears of unequal temperature whose profiles deviate: by every method.
///
/// Source: the polygon method and the certificate, which know no base pitch.
#[test]
fn gears_unequally_warm_agree_by_every_method() {
    let met: Vec<Status> = (0..400u64)
        .into_par_iter()
        .filter_map(|seed| {
            let mut random = Random(seed ^ 0x3a7);
            let cold = pair(&mut random, false)?;
            let mut warm = |member| {
                let built = cold.gear(member);
                built.expanded(1.0 + random.within(-0.008, 0.008)).ok()
            };
            let (wheel, pinion) = (warm(Member::Wheel)?, warm(Member::Pinion)?);
            let warm = GearPair::with_locked(wheel, pinion, cold.center_distance(), cold.locked());
            agree(seed, &warm.ok()?, &mut random, false)
        })
        .collect();
    assert!(met.len() > 300, "{}", met.len());
}

/// One random pair at one pose, by every method. `None` where the pair cannot exist or a search gives up.
fn compare(seed: u64, referee: bool) -> Option<Status> {
    let mut random = Random(seed);
    let assembly = pair(&mut random, true)?;
    agree(seed, &assembly, &mut random, referee)
}

fn agree(seed: u64, assembly: &GearPair, random: &mut Random, referee: bool) -> Option<Status> {
    let mating = random::mating(random, assembly);
    let pose = Pose::new(assembly, mating);
    let what = || format!("seed {seed}: {}", crate::campaign::describe(assembly));
    let exact = ExactKernel::new(assembly).lost_motion(&pose).ok()?;
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member));
    let chord = 1e-4 * wheel.gear().basic_data().module();
    let cut = [wheel, pinion].map(|gear| CutGear::new(gear, chord));
    let kernel = || PolygonKernel::refined(assembly, &cut[0], &cut[1]);
    let polygon = kernel()
        .lost_motion(&pose)
        .unwrap_or_else(|lost| panic!("{lost}: {}", what()));
    within(exact.right, polygon.right, &what);
    within(exact.left, polygon.left, &what);
    let certified = Certifier::new(kernel()).check(&pose, &exact);
    assert!(certified.is_ok(), "{certified:?}: {}", what());
    if referee {
        let against = clearance::against(assembly, &pose, &exact);
        assert!(against.is_empty(), "{against:?}: {exact:?} {}", what());
    }
    Some(exact.status())
}

/// Source: branch and bound over all pairs of curves. Flanks without traces are convex: those have the quick path.
#[test]
fn the_quick_path_finds_what_the_search_finds() {
    let met: Vec<Status> = (0..4000u64)
        .into_par_iter()
        .filter_map(|seed| {
            let mut random = Random(seed ^ 0x5eed_0000);
            let assembly = pair(&mut random, false)?;
            let mating = random::mating(&mut random, &assembly);
            let pose = Pose::new(&assembly, mating);
            let what = || format!("seed {seed}: {}", crate::campaign::describe(&assembly));
            let kernel = ExactKernel::new(&assembly);
            let quick = kernel.lost_motion(&pose).ok()?;
            let search = kernel.lost_motion_by_search(&pose).ok()?;
            within(quick.right, search.right, &what);
            within(quick.left, search.left, &what);
            Some(quick.status())
        })
        .collect();
    let count = |status| met.iter().filter(|met| **met == status).count();
    let found = [Status::Clear, Status::Interference, Status::Jammed].map(count);
    assert!(
        met.len() > 3000 && found.iter().all(|&count| count > 100),
        "{found:?}"
    );
}

/// 150 pairs with slope, crowning, relief and traces: exact against polygon, certificate and, each sixteenth, brute force.
#[test]
fn random_profiles_by_every_method() {
    let met: Vec<Status> = (0..200u64)
        .into_par_iter()
        .filter_map(|seed| compare(seed, seed % 16 == 0))
        .collect();
    let count = |status| met.iter().filter(|met| **met == status).count();
    let found = [Status::Clear, Status::Interference, Status::Jammed].map(count);
    println!("{} pairs, {found:?}", met.len());
    assert!(
        met.len() >= 150 && found.iter().all(|&count| count > 2),
        "{found:?}"
    );
}

/// The extremes of the whole cycle hold every pose of it. Source: the poses themselves, of pairs in ordinary mesh.
#[test]
fn extremes_hold_every_pose() {
    let found: Vec<bool> = (0..80u64)
        .into_par_iter()
        .filter_map(|seed| {
            let mut random = Random(seed ^ 0xe47e);
            let assembly = pair(&mut random, true)?;
            let teeth = |member| assembly.gear(member).gear().basic_data().teeth();
            if teeth(Member::Wheel).max(teeth(Member::Pinion)) > 80 {
                return None;
            }
            let first = random::mating(&mut random, &assembly);
            let kernel = ExactKernel::new(&assembly);
            let matings = 40;
            let extremes = kernel.extremes(&assembly, first, matings, 1e-6).ok()?;
            let (least, greatest) = (extremes.least?, extremes.greatest?);
            let radius = assembly.operating_pitch_radius(assembly.free());
            for _ in 0..100 {
                let mating = first.onward(
                    &assembly,
                    random.within(0.0, matings as f64) - first.fraction,
                );
                let pose = Pose::new(&assembly, mating);
                let Some(angle) = kernel.lost_motion(&pose).ok()?.angle() else {
                    continue;
                };
                let play = angle * radius;
                let rounding = 1e-11 * radius;
                assert!(play >= least.low - rounding, "{seed}: {play} {least:?}");
                assert!(
                    play <= greatest.high + rounding,
                    "{seed}: {play} {greatest:?}"
                );
            }
            Some(least.low.is_finite() && greatest.high.is_finite())
        })
        .collect();
    let held = found.iter().filter(|held| **held).count();
    println!("{held} of {}", found.len());
    assert!(held > 8, "{held} of {}", found.len());
}
