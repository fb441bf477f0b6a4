//! The pose of the whole mesh cycle that `snapshot --worst`, `snapshot --greatest` and `chart --kind field` draw.

use super::console::tell_verdict;
use super::progress::Progress;
use super::verdict;
use crate::error::Error;
use clap::ValueEnum;
use gearlash::analysis::simulate::Run;
use gearlash::analysis::study::{Material, Study};
use gearlash::analysis::tally::{Piece, simulate_by_blocks};
use gearlash::analysis::verdict::Verdict;
use gearlash::contact::{ContactClass, ContactKind, Method, PoseResult};
use gearlash::gear::Side;
use gearlash::outline::AssembledPair;
use gearlash::pair::Mating;
use gearlash_files::distance_refused;
use gearlash_results::verdict::lines;

/// Which pose of the mesh cycle.
#[derive(Clone, Copy)]
pub(super) enum Wanted {
    /// Jammed, or with the least backlash.
    Least,
    /// With the greatest backlash.
    Greatest,
    /// With the least backlash of those that a contact of this kind bounds.
    LeastOf(Binding),
}

/// Kinds of contact, by the part that touches.
#[derive(Clone, Copy, ValueEnum)]
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
    fn includes(self, kind: ContactKind) -> bool {
        let own: &[ContactKind] = match self {
            Binding::UndercutEdge => &[ContactKind::Edge],
            Binding::Tip => &[ContactKind::TipInvolute, ContactKind::TipTip],
            Binding::Fillet => &[ContactKind::Fillet, ContactKind::TipFillet],
            Binding::Root => &[ContactKind::Root],
        };
        own.contains(&kind)
    }

    /// Whether one of the contacts of `pose` is of this kind.
    fn bounds(self, assembly: &AssembledPair, pose: &PoseResult) -> bool {
        let Some(found) = pose.proven() else {
            return false;
        };
        let contacts = [(Side::Right, &found.right), (Side::Left, &found.left)];
        contacts.into_iter().any(|(side, contact)| {
            let class = contact
                .as_ref()
                .zip(assembly.data())
                .map(|(contact, pair)| ContactClass::of(pair, side, contact));
            class.is_some_and(|class| self.includes(class.kind))
        })
    }
}

/// Finds the extremes of `study`'s mesh cycle, at `distance` and with `material` alone where they are given. Tells the verdict on standard
/// error. Returns the pose that is `wanted` by the option `asked`, with its run and the number of poses that are not proven.
pub(super) fn find(
    (asked, wanted): (&str, Wanted),
    study: Study,
    distance: Option<f64>,
    material: Option<Material>,
) -> Result<(Run, PoseResult, usize), Error> {
    if study.is_drawn() && matches!(wanted, Wanted::LeastOf(_)) {
        return Err(Error::Usage(format!(
            "{asked}: the kinds of contact are of gears by their data; give --worst alone"
        )));
    }
    let study = narrowed(asked, study, distance, material)?;
    let (found, failed) = verdict::extremes_and_failed_checks(&study)?;
    let verdict = Verdict::of_study(&study, &found.each, failed);
    tell_verdict(&lines(&verdict));
    let run = |run: (Material, &AssembledPair, Option<(u32, u32)>), pose: &PoseResult| {
        let run = Run {
            material: run.0,
            assembly: run.1.clone(),
            phase: run.2,
            poses: Vec::new(),
        };
        (run, pose.clone())
    };
    let chosen = match wanted {
        Wanted::Least => verdict
            .worst()
            .map(|(of, pair, pose)| run((of.material, pair, of.phase), &pose.simulated)),
        Wanted::Greatest => verdict.greatest().map(|(of, greatest)| {
            run(
                (of.material, &greatest.assembly, of.phase),
                &greatest.pose.simulated,
            )
        }),
        Wanted::LeastOf(binding) => {
            let mut least = Least::default();
            for extremes in &found.runs {
                let poses = extremes.poses.iter().map(|pose| &pose.simulated);
                least.add(binding, &extremes.run, poses);
            }
            least.of_poses(binding, &study)?;
            match least.0 {
                None => None,
                Some((_, run, mating)) => {
                    let pose = run.assembly.lost_motion(mating)?;
                    Some((run, pose))
                }
            }
        }
    };
    let Some((run, pose)) = chosen else {
        return Err(Error::Usage(match wanted {
            Wanted::LeastOf(_) => format!(
                "{asked}: no pose of the pair file has such a contact; `gearlash check` counts the kinds that it has"
            ),
            _ => format!("{asked}: no pose is in mesh; there is none to draw"),
        }));
    };
    let unproven = found.runs.iter().map(|run| run.unproven().count()).sum();
    Ok((run, pose, unproven))
}

/// The pose with the least backlash so far, with its run and mating.
#[derive(Default)]
struct Least(Option<(f64, Run, Mating)>);

impl Least {
    fn add<'a>(
        &mut self,
        binding: Binding,
        run: &Run,
        poses: impl Iterator<Item = &'a PoseResult>,
    ) {
        for pose in poses {
            let Some(backlash) = pose.backlash else {
                continue;
            };
            let less = self.0.as_ref().is_none_or(|(least, ..)| backlash < *least);
            if less && binding.bounds(&run.assembly, pose) {
                let run = Run {
                    poses: Vec::new(),
                    ..run.clone()
                };
                self.0 = Some((backlash, run, *pose.pose.mating()));
            }
        }
    }

    /// Adds the poses that `study` asks for.
    fn of_poses(&mut self, binding: Binding, study: &Study) -> Result<(), Error> {
        let progress = Progress::of(study.pose_count(), "poses");
        let exact = Method::Exact { certify: false };
        let take = &mut |piece: Piece| {
            if let Piece::Poses(of, poses) = piece {
                let run = Run {
                    material: of.material,
                    assembly: of.assembly.clone(),
                    phase: of.phase,
                    poses: Vec::new(),
                };
                self.add(binding, &run, poses.iter().map(|pose| &pose.simulated));
            }
            Ok::<(), Error>(())
        };
        simulate_by_blocks(
            study,
            exact,
            study.tolerance_um,
            0,
            &|| progress.tick(),
            take,
        )?;
        Ok(())
    }
}

fn narrowed(
    asked: &str,
    mut study: Study,
    distance: Option<f64>,
    material: Option<Material>,
) -> Result<Study, Error> {
    if let Some(material) = material {
        study.keep(material);
    }
    let Some(distance) = distance else {
        return match study.center_distances.is_empty() {
            true => Err(Error::Usage(format!(
                "{asked}: the pair file has no centre distance; give one with --center-distance"
            ))),
            false => Ok(study),
        };
    };
    // Measured rows are run at their own distances.
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
