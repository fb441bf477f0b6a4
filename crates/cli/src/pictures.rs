//! What `snapshot --animate` and `--exaggerate` draw.

use crate::error::Error;
use gearlash::contact::{CutPair, Exaggeration, Method, PoseResult, sweep};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use std::ops::ControlFlow;

/// Steps of an animation: ten a second.
const STEPS: u32 = 60;

/// What is found at every step through a pitch from `pose` on, both ends included.
pub(super) fn pitch(assembly: &GearPair, pose: &Pose) -> Result<Vec<PoseResult>, Error> {
    let matings: Vec<Mating> = (0..=STEPS)
        .map(|step| Mating {
            fraction: pose.mating().fraction + f64::from(step) / f64::from(STEPS),
            ..*pose.mating()
        })
        .collect();
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member));
    let cut = CutPair::for_certificates(wheel, pinion);
    let method = Method::Exact { certify: true };
    let tick = || ControlFlow::Continue(());
    Ok(sweep(assembly, &cut, method, &matings, 0.0, &tick)?)
}

/// Factors to fall back on, and the range of those allowed.
const FACTORS: [f64; 16] = [
    100_000.0, 50_000.0, 20_000.0, 10_000.0, 5000.0, 2000.0, 1000.0, 500.0, 200.0, 100.0, 50.0,
    20.0, 10.0, 5.0, 2.0, 1.0,
];

/// Both gears with their deviations `factor` times as large; an error names the factor that would do.
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
