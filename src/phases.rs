//! Assembly phases against each other: which teeth to mark together.

use crate::compare::ComparedRun;
use crate::outcome::Outcome;
use crate::pair::{Assembly, Mating, Member, SweepPlan};

/// The phases of one centre distance and material.
#[derive(Debug, Clone)]
pub struct PhaseGroup<'a> {
    /// Its runs, phase by phase.
    pub runs: Vec<&'a ComparedRun>,
    /// The phase with the least variation of backlash, the first of equals.
    pub best: Option<&'a ComparedRun>,
    /// The phase with the greatest.
    pub worst: Option<&'a ComparedRun>,
}

/// The assembly phase of `mating`: the least pinion tooth whose right flank ever meets that of wheel tooth 1.
pub fn phase(assembly: &Assembly, mating: &Mating) -> u32 {
    let [wheel, pinion] = [Member::Wheel, Member::Pinion]
        .map(|member| assembly.gear(member).gear().toothing().teeth());
    let ways = SweepPlan::phase_count(wheel, pinion);
    (mating.of_wheel_tooth_1(assembly).pinion_tooth - 1) % ways + 1
}

/// The phases of `runs` in which, at some centre distance or material, a pose interferes, jams or is out of mesh,
/// and the number of all phases; in order.
pub fn failing_phases(runs: &[ComparedRun]) -> (Vec<(u32, u32)>, usize) {
    let (mut failing, mut all) = (Vec::new(), Vec::new());
    for run in runs {
        let Some(phase) = run.run.phase else { continue };
        if !all.contains(&phase) {
            all.push(phase);
        }
        if Outcome::of(&[run], &[]).fails() && !failing.contains(&phase) {
            failing.push(phase);
        }
    }
    failing.sort_unstable();
    (failing, all.len())
}

/// Whether every pose of `run` is proven to have room to turn, or just none too little.
pub fn assembles(run: &ComparedRun) -> bool {
    Outcome::of(&[run], &[]).assembles()
}

/// Variation of backlash over a run, greatest minus least, mm; `None` where a pose has no backlash.
pub fn variation(run: &ComparedRun) -> Option<f64> {
    let summary = run.summary();
    let whole = run.poses.iter().all(|pose| pose.swept.backlash.is_some());
    whole.then_some(summary.max? - summary.min?)
}

/// The runs that are phases, grouped by centre distance and material, in order.
pub fn phase_groups(runs: &[ComparedRun]) -> Vec<PhaseGroup<'_>> {
    let key = |run: &ComparedRun| (run.run.assembly.center_distance(), run.run.material);
    let of_phases: Vec<&ComparedRun> = runs.iter().filter(|run| run.run.phase.is_some()).collect();
    of_phases
        .chunk_by(|a, b| key(a) == key(b))
        .map(|runs| {
            let by = |better: fn(f64, f64) -> bool| {
                let known = runs.iter().filter_map(|run| Some((*run, variation(run)?)));
                let chosen = known.reduce(|chosen, next| match better(next.1, chosen.1) {
                    true => next,
                    false => chosen,
                });
                chosen.map(|(run, _)| run)
            };
            PhaseGroup {
                best: by(|next, chosen| next < chosen),
                worst: by(|next, chosen| next > chosen),
                runs: runs.to_vec(),
            }
        })
        .collect()
}
