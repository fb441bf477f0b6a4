//! `[sweep]`: the poses to run.

use super::spec::{DEFAULT_STEPS, ExtremePhases, Revolutions, SweepSpec};
use gearlash::pair::SweepPlan;
use gearlash_text::{Node, Problem, Table};

/// The poses of every run, and their keys in the pair file.
#[derive(Debug)]
pub struct Sweep {
    pub plan: SweepPlan,
    pub spec: SweepSpec,
}

impl Sweep {
    /// Reads `[sweep]`; without it, one wheel revolution.
    pub fn read(file: &Table, teeth: (Option<u32>, Option<u32>)) -> Option<Sweep> {
        let matings = file.get("sweep.mating").map_or(&[][..], Node::list);
        let reading = file.reading();
        reading.list("sweep.mating", || {
            // A mating with a problem of its own is already reported.
            let each = (1..).zip(matings);
            let good = each.filter_map(|(place, one)| Some((place, one.to::<[u32; 2]>().ok()?)));
            for (place, mating) in good {
                let place = format!("value {place} of the list: ");
                if let Some(problem) = beyond_gear("sweep.mating", mating, teeth, &place) {
                    reading.add(problem);
                }
            }
            Some(())
        })?;
        let start = file.read("sweep.start").flatten();
        if let Some(problem) = start.and_then(|start| beyond_gear("sweep.start", start, teeth, ""))
        {
            return reading.refuse(problem);
        }
        let stated = file.read::<SweepSpec>("sweep")?;
        let teeth = (teeth.0?, teeth.1?);
        let several = SweepPlan::phase_count(teeth.0, teeth.1) > 1;
        let mut spec = stated.unwrap_or_default();
        if spec.mating.is_none() && spec.phases.is_none() && spec.revolutions.is_none() {
            spec.revolutions = Some(Revolutions::Wheel);
            // Without a stated start, the listed poses choose no assembly phase.
            if several && spec.start.is_none() {
                spec.extremes = Some(ExtremePhases::AllPhases);
            }
        }
        Sweep::of(spec, teeth)
    }

    /// `spec` on gears with `teeth` teeth, defaults filled in.
    fn of(mut spec: SweepSpec, teeth: (u32, u32)) -> Option<Sweep> {
        if let Some(matings) = &spec.mating {
            let matings = matings
                .iter()
                .map(|&[wheel, pinion]| (wheel, pinion))
                .collect();
            let fractions = spec.fraction.get_or_insert_with(|| vec![0.0]).clone();
            let plan = SweepPlan::Matings { matings, fractions };
            return Some(Sweep { plan, spec });
        }
        let steps_per_pitch = *spec.steps_per_pitch.get_or_insert(DEFAULT_STEPS);
        let Some(revolutions) = spec.revolutions else {
            let plan = SweepPlan::Phases {
                steps_per_pitch,
                teeth,
            };
            return Some(Sweep { plan, spec });
        };
        let [wheel, pinion] = *spec.start.get_or_insert([1, 1]);
        let plan = SweepPlan::Revolution {
            pitches: match revolutions {
                Revolutions::Wheel => u64::from(teeth.0),
                Revolutions::Hunting => SweepPlan::hunting_pitches(teeth.0, teeth.1),
            },
            steps_per_pitch,
            start: (wheel, pinion),
        };
        Some(Sweep { plan, spec })
    }
}

/// The problem of a mating whose teeth do not exist, at `key` and a `place` in it.
fn beyond_gear(
    key: &str,
    mating: [u32; 2],
    teeth: (Option<u32>, Option<u32>),
    place: &str,
) -> Option<Problem> {
    let each = [
        ("wheel", mating[0], teeth.0),
        ("pinion", mating[1], teeth.1),
    ];
    let wrong = each.into_iter().filter_map(|(name, tooth, teeth)| {
        let teeth = teeth.filter(|teeth| tooth > *teeth)?;
        let allowed = format!("allowed is a whole number, 1 … {teeth}");
        Some(format!("{name} tooth is {tooth}, {allowed}"))
    });
    let wrong: Vec<String> = wrong.collect();
    (!wrong.is_empty()).then(|| Problem {
        key: key.to_owned(),
        value: Some(format!("{mating:?}")),
        reason: format!("{place}{}", wrong.join("; ")),
        help: "give wheel tooth and pinion tooth, numbered from 1".to_owned(),
    })
}
