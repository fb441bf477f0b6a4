//! Which mating binds.

use crate::compare::ComparedRun;
use crate::gear::Side;
use crate::mesh::first_least;
use crate::pair::Mating;
use crate::study::Study;

/// Wheel and pinion tooth, by their right flanks, of the pose with the least backlash of all `runs`, or of the pose half a pitch or less beyond
/// which it stands; `None` where no pose has a value.
pub fn binding_mating<'a>(
    runs: impl Iterator<Item = &'a ComparedRun> + Clone,
) -> Option<(u32, u32)> {
    let poses = runs.flat_map(|run| run.poses.iter().map(move |pose| (run, pose)));
    let known = poses.filter_map(|(run, pose)| {
        let swept = &pose.swept;
        Some((
            (run, swept.pose.mating()),
            swept.backlash?,
            swept.error_bound?,
        ))
    });
    let (run, mating) = first_least(known)?;
    let whole = Mating {
        fraction: 0.0,
        ..*mating
    };
    let assembly = &run.run.assembly;
    let nearest = whole
        .onward(assembly, mating.fraction.round())
        .at_flank(assembly, Side::Right);
    Some((nearest.wheel_tooth, nearest.pinion_tooth))
}

/// The matings whose backlash over the centre distance is worth a look: `binding` first, then those that were measured,
/// in the order of their file.
pub fn matings_of_note(study: &Study, binding: Option<(u32, u32)>) -> Vec<(u32, u32)> {
    let first = binding.unwrap_or_else(|| super::first_mating(study));
    let mut matings = vec![first];
    for row in &study.measured {
        let mating = (row.wheel_tooth, row.pinion_tooth);
        if !matings.contains(&mating) {
            matings.push(mating);
        }
    }
    matings
}
