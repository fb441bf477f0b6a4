//! Extremes and failing checks of commands that keep no poses; the pose that `snapshot --worst`, `snapshot --greatest` and
//! `chart --kind field` draw.

use crate::console::print_verdict_lines;
use crate::error::Error;
use crate::options::name_of;
use crate::progress::Progress;
use clap::ValueEnum;
use gearlash::analysis::compare::ComparedPose;
use gearlash::analysis::diagnosis::{self, CheckName, PoseEvidence};
use gearlash::analysis::extremes::{CycleExtremes, extremes, run_count};
use gearlash::analysis::study::{Material, Study};
use gearlash::analysis::tally::{Piece, RunTally, simulate_by_blocks};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::{ContactClass, ContactKind, Method, PoseResult, Status, lost_motion_at};
use gearlash::error::go_on;
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash::pair::Mating;
use gearlash_input::distance_refused;

/// The checks that fail at the poses of `runs`.
pub(super) fn failed_checks(
    study: &Study,
    runs: &[RunTally],
    cycle: &CycleExtremes,
) -> Result<Vec<CheckName>, Error> {
    let evidence: Vec<PoseEvidence> = runs.iter().filter_map(|run| run.evidence.clone()).collect();
    Ok(diagnosis::failed_checks(study, &evidence, cycle, &go_on)?)
}

/// A pose of the mesh cycle.
#[derive(Clone, Copy)]
pub(super) enum Wanted {
    /// Jammed, or with the least backlash.
    Least,
    /// With the greatest backlash.
    Greatest,
    /// With the least backlash among poses bounded by a contact of this kind.
    LeastOf(Binding),
}

/// Kinds of contact, by the touching part.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(super) enum Binding {
    /// The edge that undercut leaves
    UndercutEdge,
    /// A tip, on an involute or a tip
    Tip,
    /// A fillet, on whatever it touches but a root
    Fillet,
    /// A root
    Root,
}

impl Binding {
    /// The kind that `kind` belongs to; `None` where involutes alone touch.
    fn of(kind: ContactKind) -> Option<Binding> {
        let mut all = Binding::value_variants().iter().copied();
        all.find(|binding| binding.includes(kind))
    }

    fn includes(self, kind: ContactKind) -> bool {
        let own: &[ContactKind] = match self {
            Binding::UndercutEdge => &[ContactKind::Edge],
            Binding::Tip => &[ContactKind::TipInvolute, ContactKind::TipTip],
            Binding::Fillet => &[ContactKind::Fillet, ContactKind::TipFillet],
            Binding::Root => &[ContactKind::Root],
        };
        own.contains(&kind)
    }

    /// The kinds of the contacts of `pose`.
    fn bounding(assembly: &AssembledPair, pose: &PoseResult) -> [Option<Binding>; 2] {
        let found = pose.proven().zip(assembly.data());
        Side::BOTH.map(|side| {
            let (found, pair) = found?;
            let contact = found.on(side)?;
            Binding::of(ContactClass::of(pair, side, &contact).kind)
        })
    }
}

/// A pose of a pair.
pub(super) struct Found {
    pub material: Material,
    pub assembly: AssembledPair,
    pub pose: PoseResult,
    /// The number of unproven poses: this one, or those that were searched.
    pub unproven: usize,
}

/// Finds the extremes of `study`'s mesh cycle, limited to `distance` and `material` where they are given. Prints the verdict on
/// standard error. Returns the pose that is `wanted` by `option`.
pub(super) fn find(
    (option, wanted): (&str, Wanted),
    study: Study,
    distance: Option<f64>,
    material: Option<Material>,
) -> Result<Found, Error> {
    let study = narrowed(option, study, distance, material)?;
    let progress = Progress::of(run_count(&study)? + study.pose_count(), "steps");
    let tick = |steps| progress.tick(steps);
    let certified = Method::Exact { certify: true };
    let found = progress.searching(|| extremes(&study, certified, &tick))?;
    let exact = Method::Exact { certify: false };
    let none = &mut |_: Piece| Ok::<(), Error>(());
    let runs = simulate_by_blocks(&study, exact, study.tolerance_um, 0, &tick, none)?;
    let failed = failed_checks(&study, &runs, &found)?;
    drop(progress);
    let verdict = Verdict::of_study(&study, &found.each, failed);
    print_verdict_lines(&verdict);
    let chosen = match wanted {
        Wanted::Least => verdict
            .worst()
            .map(|(of, pair, pose)| (of.material, pair.clone(), pose.simulated.clone())),
        Wanted::Greatest => verdict.greatest().map(|(of, greatest)| {
            let pose = greatest.pose.simulated.clone();
            (of.material, greatest.assembly.clone(), pose)
        }),
        Wanted::LeastOf(binding) => Some(least_of(option, binding, &study, &found)?),
    };
    let Some((material, assembly, pose)) = chosen else {
        return Err(Error::Usage(format!(
            "{option}: no pose is in mesh; there is none to draw"
        )));
    };
    Ok(Found {
        material,
        assembly,
        pose,
        unproven: found.runs.iter().map(|run| run.unproven().count()).sum(),
    })
}

/// The pose with the least backlash that a contact of this kind bounds, among the extremes and the poses of `study`. A jam without a
/// backlash is the least.
fn least_of(
    option: &str,
    binding: Binding,
    study: &Study,
    found: &CycleExtremes,
) -> Result<(Material, AssembledPair, PoseResult), Error> {
    let mut least: Option<(f64, Material, AssembledPair, Mating)> = None;
    let mut seen: Vec<Binding> = Vec::new();
    let mut add = |material: Material, assembly: &AssembledPair, poses: &[ComparedPose]| {
        for pose in poses.iter().map(|pose| &pose.simulated) {
            let bounding = Binding::bounding(assembly, pose);
            for kind in bounding.into_iter().flatten() {
                if !seen.contains(&kind) {
                    seen.push(kind);
                }
            }
            let jam = (pose.status() == Status::Jammed).then_some(f64::NEG_INFINITY);
            let Some(backlash) = pose.backlash.or(jam) else {
                continue;
            };
            let is_less = least.as_ref().is_none_or(|(least, ..)| backlash < *least);
            if is_less && bounding.contains(&Some(binding)) {
                least = Some((backlash, material, assembly.clone(), *pose.pose.mating()));
            }
        }
    };
    for run in &found.runs {
        add(run.run.material, &run.run.assembly, &run.poses);
    }
    let progress = Progress::of(study.pose_count(), "poses");
    let tick = |steps| progress.tick(steps);
    let exact = Method::Exact { certify: false };
    let take = &mut |piece: Piece| {
        if let Piece::Poses(of, poses) = piece {
            add(of.material, &of.assembly, poses);
        }
        Ok::<(), Error>(())
    };
    simulate_by_blocks(study, exact, study.tolerance_um, 0, &tick, take)?;
    let Some((_, material, assembly, mating)) = least else {
        let names: Vec<String> = seen.iter().map(name_of).collect();
        let kinds = match &names[..] {
            [] if study.drawn.is_empty() => "involutes alone touch, if anything does".to_owned(),
            [] => "kinds are known of gears by data alone".to_owned(),
            names => format!("kinds here: {}", names.join(", ")),
        };
        return Err(Error::Usage(format!(
            "{option}: no pose of the pair file has such a contact; {kinds}"
        )));
    };
    let pose = lost_motion_at(&assembly, mating)?;
    Ok((material, assembly, pose))
}

fn narrowed(
    option: &str,
    mut study: Study,
    distance: Option<f64>,
    material: Option<Material>,
) -> Result<Study, Error> {
    if let Some(material) = material {
        study.keep(material);
    }
    let Some(distance) = distance else {
        return if study.center_distances.is_empty() {
            Err(Error::Usage(format!(
                "{option}: the pair file has no centre distance; give one with --center-distance"
            )))
        } else {
            Ok(study)
        };
    };
    // Measured rows run at their own distances.
    if study.sweep.is_none() && study.center_distances.contains(&distance) {
        study.center_distances = vec![distance];
        return Ok(study);
    }
    let moved = study.at(vec![distance]);
    moved.map_err(|reason| {
        let reason = distance_refused(&reason);
        Error::Usage(format!("--center-distance {distance}: {reason}"))
    })
}
