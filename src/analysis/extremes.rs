//! The least and the greatest backlash of every run of a study, over its whole mesh cycle and every rotation.
//!
//! Tooth numbers of 17 and 100 meet in 1700 pairs, of which one wheel revolution brings 17. Whether the pair assembles, all of them have
//! to say, and every rotation between two poses: [`ExactKernel::extremes`] proves what bounds them. What it found is simulated as every
//! other pose is, certificate and formulas beside it.

use super::assembles_from::AssemblesFrom;
use super::compare::{ComparedPose, ComparedRun, compare};
use super::directions::{self, Directed, Search, is_open};
use super::meshes_to::MeshesTo;
use super::phases::phase;
use super::simulate::simulate_plans;
use super::study::{Material, RunPlan, Study};
use crate::contact::{Doubt, ExactKernel, Extreme, Extremes, Method, Status};
use crate::error::Error;
use crate::gear::Side;
use crate::pair::{GearPair, Mating, Member, SweepPlan};
use crate::parallel;
use std::ops::ControlFlow;

/// Width of a proven bracket of `j_wt`, mm: a nanometre, a hundredth of what any gear is measured to.
pub const WIDTH: f64 = 1e-6;

/// One centre distance, material and assembly phase.
#[derive(Debug, Clone)]
pub struct RunExtremes {
    /// Which thickness.
    pub material: Material,
    /// As assembled.
    pub assembly: GearPair,
    /// Wheel and pinion tooth that name the assembly phase, where the study has several.
    pub phase: Option<(u32, u32)>,
    /// Matings of the cycle: lcm(z_1, z_2).
    pub matings: u64,
    /// How the worst of its poses ends.
    pub status: Status,
    /// The least `j_wt`; `None` where a pose is jammed.
    pub least: Option<RunExtreme>,
    /// The greatest; `None` where a pose is out of mesh.
    pub greatest: Option<RunExtreme>,
    /// A pose that is jammed or out of mesh.
    pub lost: Option<PairPose>,
    /// Where the pair does not assemble: from which centre distance it does; `None` where none was found between this one and tips that
    /// pass each other.
    pub assembles_from: Option<AssemblesFrom>,
    /// Where it is out of mesh: up to which centre distance it is in mesh.
    pub meshes_to: Option<MeshesTo>,
}

/// The extremes of a study.
#[derive(Debug, Clone, Default)]
pub struct CycleExtremes {
    /// Each centre distance, material and assembly phase.
    pub each: Vec<RunExtremes>,
    /// Their poses, run by run: least, greatest, lost, and what binds where the pair begins to assemble.
    pub runs: Vec<ComparedRun>,
}

/// A pose and the pair in it: where a runout has no direction, with its high tooth where it is worst.
#[derive(Debug, Clone)]
pub struct PairPose {
    /// The pair.
    pub assembly: GearPair,
    /// The pose, simulated.
    pub pose: ComparedPose,
}

/// An extreme and the pose that attains it.
#[derive(Debug, Clone)]
pub struct RunExtreme {
    /// `j_wt`, mm: no less than this.
    pub low: f64,
    /// No more than this.
    pub high: f64,
    /// Why that is not proven.
    pub doubt: Option<Doubt>,
    /// The pair: where a runout has no direction, with its high tooth where it is worst.
    pub assembly: GearPair,
    /// The pose, simulated.
    pub pose: ComparedPose,
}

impl RunExtreme {
    /// Whether no rotation of the cycle lies beyond a bracket as narrow as was wanted, and something vouches for the pose itself.
    pub fn is_proven(&self) -> bool {
        self.doubt.is_none() && self.pose.swept.found.is_ok()
    }

    /// Whether no rotation of the cycle lies beyond the bracket, however wide that is.
    pub fn holds(&self) -> bool {
        let wide = [Doubt::Effort, Doubt::SecondOrder, Doubt::Profile];
        self.doubt.is_none_or(|doubt| wide.contains(&doubt)) && self.pose.swept.found.is_ok()
    }

    /// What was found, mm: the end of the bracket that the pose attains.
    pub fn found(&self) -> f64 {
        self.pose
            .swept
            .backlash
            .unwrap_or(0.5 * (self.low + self.high))
    }
}

impl RunExtremes {
    /// Whether the pair assembles over the whole cycle; `None` where that is not proven.
    pub fn assembles(&self) -> Option<bool> {
        match (self.status, &self.least) {
            (Status::Jammed | Status::NoContact, _) => Some(false),
            (_, Some(least)) if least.high < 0.0 => Some(false),
            (_, Some(least)) if least.low >= -WIDTH && least.holds() => Some(true),
            _ => None,
        }
    }

    /// Whether every tooth is alike: no deviation tells them apart, and a runout may have any direction.
    pub fn has_like_teeth(&self) -> bool {
        distinct(&self.assembly) == 1
    }

    /// Whether a runout has no direction: all of them are meant.
    pub fn any_direction(&self) -> bool {
        is_open(&self.assembly)
    }

    /// Whether all that is said of it is proven.
    pub fn is_proven(&self) -> bool {
        let both = self.least.iter().chain(&self.greatest);
        both.into_iter().all(RunExtreme::is_proven)
    }
}

/// The extremes of every run of `study`, in the order of [`Study::runs`], their poses found once more by `method`.
///
/// A study of single matings has the assembly phases that these belong to. `tick` is called as each run begins, from any thread.
///
/// # Errors
/// As [`super::simulate::simulate`].
pub fn extremes(
    study: &Study,
    method: Method,
    tick: &(dyn Fn() -> ControlFlow<()> + Sync),
) -> Result<CycleExtremes, Error> {
    let plans = plans(study)?;
    let found = parallel::map(0..plans.len() as u64, |index| {
        if tick().is_break() {
            return Err(Error::Interrupted);
        }
        plans[index as usize].search()
    });
    let found = found
        .into_iter()
        .collect::<Result<Vec<Searched>, Error>>()?;
    let poses = plans.iter().zip(&found).flat_map(|(planned, searched)| {
        let each = searched.poses.iter();
        each.map(|poses| RunPlan {
            assembly: poses.assembly.clone(),
            matings: poses.matings.clone(),
            ..planned.run.clone()
        })
    });
    let runs = simulate_plans(
        study,
        poses.collect(),
        method,
        &|| ControlFlow::Continue(()),
    )?;
    let runs = compare(runs, study.tolerance_um);
    let mut rest = &runs[..];
    let all = plans.iter().zip(&found);
    let each = all.map(|(planned, searched)| {
        let (own, others) = rest.split_at(searched.poses.len());
        rest = others;
        planned.extremes(searched, own)
    });
    Ok(CycleExtremes {
        each: each.collect(),
        runs,
    })
}

/// How many runs [`extremes`] has: its ticks.
///
/// # Errors
/// As [`Study::runs`].
pub fn run_count(study: &Study) -> Result<u64, Error> {
    Ok(plans(study)?.len() as u64)
}

/// A run and where its cycle begins.
struct Planned {
    run: RunPlan,
    first: Mating,
    /// Matings that differ.
    distinct: u64,
    phase: Option<(u32, u32)>,
}

/// What was found of it, and the poses of that: least, greatest, lost.
struct Searched {
    found: Extremes,
    poses: Vec<Directed>,
    assembles_from: Option<AssemblesFrom>,
    meshes_to: Option<MeshesTo>,
}

impl Planned {
    fn search(&self) -> Result<Searched, Error> {
        let assembly = &self.run.assembly;
        let of = |pair: &GearPair| {
            ExactKernel::new(pair).extremes(pair, self.first, self.distinct, WIDTH)
        };
        if is_open(assembly) {
            let all = directions::extremes(assembly, &of, WIDTH)?;
            let [(near, nearest), (far, farthest)] = &all.ends;
            return Ok(Searched {
                assembles_from: self.assembles_from(near, nearest, all.off)?,
                meshes_to: meshes_to(far, farthest, all.off, &of)?,
                found: all.found,
                poses: all.poses,
            });
        }
        let found = of(assembly)?;
        let extremes = [found.least, found.greatest].into_iter().flatten();
        let matings = extremes.map(|extreme| extreme.mating).chain(found.lost);
        let assembles_from = self.assembles_from(assembly, &found, 0.0)?;
        // Beside them what binds where the pair begins to assemble, for checks that seek distances.
        let binds = assembles_from.map(|from| from.mating);
        Ok(Searched {
            poses: vec![Directed {
                assembly: assembly.clone(),
                matings: matings.chain(binds).collect(),
            }],
            assembles_from,
            meshes_to: meshes_to(assembly, &found, 0.0, &of)?,
            found,
        })
    }

    /// From where on the axes of `pair`, of which `found` was found, have to be `farther` apart than where it assembles.
    fn assembles_from(
        &self,
        pair: &GearPair,
        found: &Extremes,
        farther: f64,
    ) -> Result<Option<AssemblesFrom>, Error> {
        let least = found.least.map(|least| least.low);
        if found.status == Status::NoContact || least.is_some_and(|least| least >= 0.0) {
            return Ok(None);
        }
        let from = AssemblesFrom::new(pair, self.first, self.distinct, least, 0.1 * WIDTH)?;
        Ok(from.map(|from| AssemblesFrom {
            low: from.low + farther,
            high: from.high + farther,
            ..from
        }))
    }

    fn extremes(&self, searched: &Searched, runs: &[ComparedRun]) -> RunExtremes {
        let poses = runs.iter().flat_map(|run| {
            run.poses.iter().map(|pose| PairPose {
                assembly: run.run.assembly.clone(),
                pose: pose.clone(),
            })
        });
        let mut poses = poses.collect::<Vec<PairPose>>().into_iter();
        let mut one = |extreme: Option<Extreme>| {
            extreme.and_then(|extreme| {
                let PairPose { assembly, pose } = poses.next()?;
                Some(RunExtreme {
                    low: extreme.low,
                    high: extreme.high,
                    doubt: extreme.doubt,
                    assembly,
                    pose,
                })
            })
        };
        let found = &searched.found;
        let (least, greatest) = (one(found.least), one(found.greatest));
        RunExtremes {
            material: self.run.material,
            assembly: self.run.assembly.clone(),
            phase: self.phase,
            matings: hunting_pitches(&self.run.assembly),
            status: found.status,
            least,
            greatest,
            lost: found.lost.and_then(|_| poses.next()),
            assembles_from: searched.assembles_from,
            meshes_to: searched.meshes_to,
        }
    }
}

/// Up to where the axes of `pair`, of which `found` was found, may be apart: less than it is in mesh by `nearer`.
fn meshes_to(
    pair: &GearPair,
    found: &Extremes,
    nearer: f64,
    search: &Search<'_>,
) -> Result<Option<MeshesTo>, Error> {
    if found.status != Status::NoContact {
        return Ok(None);
    }
    let to = MeshesTo::new(pair, found, search)?;
    Ok(to.map(|to| MeshesTo {
        low: to.low - nearer,
        high: to.high - nearer,
        ..to
    }))
}

/// Every centre distance and material, each in the phases that the study is about.
fn plans(study: &Study) -> Result<Vec<Planned>, Error> {
    let runs = study.runs()?;
    let mut plans: Vec<Planned> = Vec::new();
    for run in runs {
        let mut firsts: Vec<Mating> = Vec::new();
        for mating in &run.matings {
            let first = first_of_phase(&run.assembly, mating);
            if !firsts.contains(&first) {
                firsts.push(first);
            }
        }
        // Against perfect teeth it does not matter which are met.
        let distinct = distinct(&run.assembly);
        if distinct < hunting_pitches(&run.assembly) {
            firsts.truncate(1);
        }
        let several = firsts.len() > 1;
        firsts.sort_by_key(|first| first.pinion_tooth);
        for first in firsts {
            let own = several.then_some((first.wheel_tooth, first.pinion_tooth));
            plans.push(Planned {
                phase: run.phase.or(own),
                run: RunPlan {
                    matings: Vec::new(),
                    ..run.clone()
                },
                first,
                distinct,
            });
        }
    }
    Ok(plans)
}

/// The mating of wheel tooth 1 that names the assembly phase of `mating`.
fn first_of_phase(assembly: &GearPair, mating: &Mating) -> Mating {
    Mating {
        wheel_tooth: 1,
        pinion_tooth: phase(assembly, mating),
        flank: Side::Right,
        fraction: 0.0,
    }
}

/// lcm(z_1, z_2).
fn hunting_pitches(assembly: &GearPair) -> u64 {
    let teeth = |member| assembly.gear(member).gear().basic_data().teeth();
    SweepPlan::hunting_pitches(teeth(Member::Wheel), teeth(Member::Pinion))
}

/// Matings that differ: after them every deviation of both gears is where it was.
fn distinct(assembly: &GearPair) -> u64 {
    let gear = |member| assembly.gear(member);
    let teeth = |member| gear(member).gear().basic_data().teeth();
    let (wheel, pinion) = (teeth(Member::Wheel), teeth(Member::Pinion));
    // In any direction an eccentricity alone makes no tooth another.
    let deviates = |member| gear(member).centred().has_unlike_teeth();
    match [Member::Wheel, Member::Pinion].map(deviates) {
        [true, true] => hunting_pitches(assembly),
        [true, false] => u64::from(wheel),
        [false, true] => u64::from(pinion),
        [false, false] => 1,
    }
}
