//! Comparison of assembly phases: which teeth to mark together.

use crate::analysis::tally::RunTally;
use crate::contact::first_least;
use crate::pair::{Mating, ToothNumbers};

/// The phases of one centre distance and material.
#[derive(Debug, Clone)]
pub struct PhaseGroup<'a> {
    /// Its runs, phase by phase.
    pub runs: Vec<&'a RunTally>,
    /// The phase with the least variation of backlash, the first of equals.
    pub best: Option<&'a RunTally>,
    /// The phase with the greatest variation.
    pub worst: Option<&'a RunTally>,
}

/// The assembly phase of `mating`: the least pinion tooth whose right flank meets that of wheel tooth 1.
pub fn phase(assembly: &impl ToothNumbers, mating: &Mating) -> u32 {
    (mating.of_wheel_tooth_1(assembly).pinion_tooth - 1) % assembly.phase_count() + 1
}

/// The runs of phases, grouped by centre distance and material, in order.
pub fn phase_groups(runs: &[RunTally]) -> Vec<PhaseGroup<'_>> {
    let key = |run: &RunTally| (run.assembly.center_distance(), run.material);
    let of_phases: Vec<&RunTally> = runs.iter().filter(|run| run.phase.is_some()).collect();
    of_phases
        .chunk_by(|a, b| key(a) == key(b))
        .map(|runs| {
            let known = runs.iter().filter_map(|run| Some((*run, run.variation()?)));
            let first = |sign: f64| {
                let signed = known.clone();
                first_least(signed.map(|(run, variation)| (run, sign * variation, 0.0)))
            };
            PhaseGroup {
                best: first(1.0),
                worst: first(-1.0),
                runs: runs.to_vec(),
            }
        })
        .collect()
}
