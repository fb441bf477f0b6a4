//! The poses that `snapshot --animate` and `--exaggerate` draw.

use crate::error::Error;
use gearlash::contact::{CutPair, Exaggeration, Method, PoseResult, sweep_blocks};
use gearlash::outline::AssembledPair;
use gearlash::pair::{GearPair, Mating, Member, Pose};
use std::ops::ControlFlow;

/// Steps of an animation: ten per second.
const STEPS: u32 = 60;

/// Steps between the neighbours of an extreme, and the number of refinements: to a 60 000th of a pitch, over which j_wt changes
/// by less than a hundredth of a micrometre.
const FINER: u32 = 20;
const ROUNDS: usize = 3;
/// Differences below this, mm, are rounding.
const ROUNDING: f64 = 1e-9;

/// The results at every step through a pitch from `pose` on, both ends included, and at the least and greatest backlash between
/// them.
pub(super) fn pitch(assembly: &AssembledPair, pose: &Pose) -> Result<Vec<PoseResult>, Error> {
    let cut = |pair: &GearPair| {
        let [wheel, pinion] = Member::BOTH.map(|member| pair.gear(member));
        CutPair::for_certificates(wheel, pinion)
    };
    let cut = assembly.data().map(cut);
    let method = Method::Exact { certify: true };
    let tick = || ControlFlow::Continue(());
    let between = |[from, to]: [f64; 2], steps: u32| {
        let at = |step: u32| from + (to - from) * (f64::from(step) / f64::from(steps));
        let matings: Vec<Mating> = (0..=steps)
            .map(|step| Mating {
                fraction: at(step),
                ..*pose.mating()
            })
            .collect();
        let mut found = Vec::new();
        let each = &mut |poses: Vec<PoseResult>| {
            found.extend(poses);
            Ok::<(), Error>(())
        };
        sweep_blocks(assembly, cut.as_ref(), method, &matings, 0.0, &tick, each)?;
        Ok::<Vec<PoseResult>, Error>(found)
    };
    let start = pose.mating().fraction;
    let mut steps = between([start, start + 1.0], STEPS)?;
    let mut extremes = Vec::new();
    for sign in [1.0, -1.0] {
        for place in (0..steps.len()).filter(|place| is_extreme(&steps, *place, sign)) {
            let (mut near, mut place) = (steps.clone(), place);
            for _ in 0..ROUNDS {
                let ends = [place.saturating_sub(1), (place + 1).min(near.len() - 1)];
                near = between(ends.map(|place| fraction(&near[place])), FINER)?;
                let Some(found) = extreme(&near, sign) else {
                    break;
                };
                place = found;
            }
            extremes.push(near.swap_remove(place));
        }
    }
    steps.extend(extremes);
    steps.sort_by(|a, b| fraction(a).total_cmp(&fraction(b)));
    steps.dedup_by(|a, b| fraction(a) == fraction(b));
    Ok(steps)
}

fn fraction(step: &PoseResult) -> f64 {
    step.pose.mating().fraction
}

/// The step with the least backlash (`sign` 1) or the greatest (−1).
fn extreme(steps: &[PoseResult], sign: f64) -> Option<usize> {
    let known = steps.iter().enumerate();
    let known = known.filter_map(|(place, step)| Some((place, sign * step.backlash?)));
    let least = known.reduce(|least, next| if next.1 < least.1 { next } else { least });
    least.map(|(place, _)| place)
}

/// Whether backlash at a step is less (`sign` 1) or greater (−1) than at the steps beside it.
fn is_extreme(steps: &[PoseResult], place: usize, sign: f64) -> bool {
    let value = |place: usize| Some(sign * steps.get(place)?.backlash?);
    let beyond = |other: Option<f64>| match (value(place), other) {
        (Some(here), Some(other)) => here < other - ROUNDING,
        (here, None) => here.is_some(),
        (None, _) => false,
    };
    let before = place.checked_sub(1).and_then(value);
    beyond(before) && beyond(value(place + 1))
}

/// Factors to suggest, and the range of allowed ones.
const FACTORS: [f64; 16] = [
    100_000.0, 50_000.0, 20_000.0, 10_000.0, 5000.0, 2000.0, 1000.0, 500.0, 200.0, 100.0, 50.0,
    20.0, 10.0, 5.0, 2.0, 1.0,
];

/// Both gears with their deviations enlarged by `factor`. An error names a factor that works.
pub(super) fn exaggeration(assembly: &GearPair, factor: f64) -> Result<Exaggeration<'_>, Error> {
    if !(FACTORS[15]..=FACTORS[0]).contains(&factor) {
        return Err(Error::Usage(format!(
            "--exaggerate {factor}: a factor between 1 and {}",
            FACTORS[0]
        )));
    }
    Exaggeration::new(assembly, factor).map_err(|reason| {
        let fits =
            |smaller: &f64| *smaller < factor && Exaggeration::new(assembly, *smaller).is_ok();
        let advice = match FACTORS.into_iter().find(fits) {
            Some(smaller) => format!("; {smaller} would do"),
            None => String::new(),
        };
        Error::Usage(format!("--exaggerate {factor}: {reason}{advice}"))
    })
}
