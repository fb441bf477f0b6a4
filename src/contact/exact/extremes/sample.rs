//! Extremes of a pair of which nothing bounds the lost motion between poses: as many poses as seems right, and more round the best.

use super::course::Course;
use super::extreme::PosesSeen;
use crate::error::Error;
use crate::pair::Mating;

/// Poses in all, at most, of a pair that needs no search and of one that does (tuned: some 0.2 s, and 1 s).
const MOST: [u64; 2] = [200_000, 6_000];

/// Poses a pitch, where there are not too many matings.
const PER_PITCH: u64 = 32;

/// Times the neighbourhood of the best poses is cut into a quarter: down to 1/32 000 of a pitch.
const ROUNDS: u32 = 5;

/// Poses looked at beforehand, to know what one takes (tuned: a thousandth of all).
const TRIED: u64 = 8;

/// Poses that are looked at while there is any effort left, however much one takes: a helical one is below 0.1 s.
const FEWEST: u64 = 16;

/// When there is no need to look any further.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Until {
    Jammed,
    Unmeshed,
    End,
}

impl Until {
    fn is_reached(self, found: &PosesSeen) -> bool {
        match self {
            Until::Jammed => found.jammed.is_some(),
            Until::Unmeshed => found.unmeshed.is_some(),
            Until::End => false,
        }
    }
}

/// Looks through the cycle, and closer round the least and the greatest: at as many poses as the effort allows, all through the cycle.
pub(super) fn sample(course: &Course, found: &mut PosesSeen, until: Until) -> Result<(), Error> {
    if std::mem::replace(&mut found.sampled, true) {
        return Ok(());
    }
    let most = MOST[usize::from(!course.kernel.is_direct())];
    let affordable = affordable(course)?;
    let (per_pitch, stride) = match most.min(course.matings * PER_PITCH) <= affordable {
        true => (
            (most / course.matings.max(1)).clamp(1, PER_PITCH),
            (course.matings / most).max(1),
        ),
        false => (
            (affordable / course.matings.max(1)).clamp(1, PER_PITCH),
            course.matings.div_ceil(affordable),
        ),
    };
    let mut index = 0;
    while index < course.matings {
        for part in 0..per_pitch {
            let fraction = (part as f64 + 0.5) / per_pitch as f64;
            found.look(course, course.mating(index, fraction))?;
            if until.is_reached(found) || course.effort.is_spent() {
                return Ok(());
            }
        }
        index += stride;
    }
    let mut width = 0.5 / per_pitch as f64;
    for _ in 0..ROUNDS {
        let best = [found.least, found.greatest];
        for seen in best.into_iter().flatten() {
            for part in -4..=4 {
                if course.effort.is_spent() {
                    return Ok(());
                }
                let mating = seen.mating;
                let beyond = f64::from(part) * 0.25 * width;
                let near: Mating = mating.onward(course.assembly, beyond);
                found.look(course, near)?;
            }
        }
        width *= 0.25;
    }
    Ok(())
}

/// How many poses may be sampled with the effort that is left, of which half is for what comes near the best: by what some of them take, all
/// through the cycle.
fn affordable(course: &Course) -> Result<u64, Error> {
    let mut tried = PosesSeen::default();
    let before = course.effort.left();
    for k in 0..TRIED {
        if course.effort.is_spent() {
            break;
        }
        let place = (k as f64 + 0.5) / TRIED as f64 * course.matings as f64;
        tried.look(course, course.mating(place as u64, place.fract()))?;
    }
    let left = course.effort.left();
    let each = ((before - left) / TRIED).max(1);
    Ok((left / 2 / each).max(FEWEST))
}

#[cfg(test)]
mod tests {
    use super::super::super::ExactKernel;
    use super::*;
    use crate::contact::Effort;
    use crate::gear::{AsBuilt, Face, Gear, GearDesign};
    use crate::pair::{GearPair, Pose};

    /// What is found is no worse than the least and the greatest of sixteen poses of every pitch of the cycle.
    #[test]
    fn every_pitch_is_looked_at() {
        let gear = Gear::nominal(GearDesign::plain(20, 2.0)).unwrap();
        let [wheel, pinion] = [(Face::Front, 0.05), (Face::Back, 0.04)].map(|(face, e)| {
            let perfect = AsBuilt::perfect(gear.clone(), face);
            perfect.with_runout(e, 8.0).unwrap()
        });
        let pair = GearPair::new(wheel, pinion, 40.4).unwrap();
        let kernel = ExactKernel::new(&pair);
        let first = Mating::FIRST;
        let effort = Effort::endless();
        let course = Course::new(&kernel, &pair, (first, 20), &effort);
        let mut found = PosesSeen::default();
        sample(&course, &mut found, Until::End).unwrap();
        let poses = (0..320).map(|k| {
            let mating = first.onward(&pair, f64::from(k) / 16.0);
            let lost = kernel.lost_motion(&Pose::new(&pair, mating)).unwrap();
            lost.angle().unwrap()
        });
        let (least, greatest) = poses.fold((f64::MAX, f64::MIN), |(least, greatest), angle| {
            (least.min(angle), greatest.max(angle))
        });
        let [low, high] = [found.least, found.greatest].map(|seen| seen.unwrap().angle);
        assert!(low <= least + 1e-9 && low > least - 1e-5, "{low} {least}");
        assert!(
            high >= greatest - 1e-9 && high < greatest + 1e-5,
            "{high} {greatest}"
        );
    }
}
