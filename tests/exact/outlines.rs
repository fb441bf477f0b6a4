//! Outlines against the exact method, which knows what each curve of a gear is and where it can touch.

#[path = "../common/random_pair.rs"]
#[allow(dead_code)] // its twin tests use the rest
mod random_pair;

use crate::wide::drawn::{Depth, Pair};
use gearlash::contact::{ExactKernel, LostMotion, OutlineKernel, OutlineLostMotion, Status};
use gearlash::gear::Side;
use gearlash::outline::{OutlineGear, OutlinePair};
use gearlash::pair::{GearPair, Mating, Member, Pose};
use proptest::prelude::*;
use random_pair::rough_case;

fn outlines(pair: &GearPair) -> OutlinePair {
    let gear = |member| OutlineGear::from(pair.gear(member));
    let (wheel, pinion) = (gear(Member::Wheel), gear(Member::Pinion));
    OutlinePair::new(wheel, pinion, pair.center_distance(), pair.locked()).unwrap()
}

/// Both methods at one rotation of the locked gear, near `mating`.
fn both(pair: &GearPair, mating: Mating) -> (LostMotion, OutlineLostMotion) {
    let outlines = outlines(pair);
    let pose = Pose::new(pair, mating);
    let locked = pair.gear(pair.locked());
    let pitch = locked.gear().basic_data().angular_pitch();
    let off = outlines.rotation(pair.locked(), &mating) - pose.locked_rotation();
    let same = mating.onward(pair, -locked.face().ascending() * off / pitch);
    let exact = ExactKernel::new(pair).lost_motion(&Pose::new(pair, same));
    let found = OutlineKernel::new(&outlines).lost_motion(&mating);
    (exact.unwrap(), found.unwrap())
}

/// The same contacts, within both bounds and what the two rotations differ by rounding.
fn agree(pair: &GearPair, mating: Mating) -> Result<Status, TestCaseError> {
    let (exact, found) = both(pair, mating);
    for (exact, found) in [(exact.right, found.right), (exact.left, found.left)] {
        prop_assert_eq!(exact.is_some(), found.is_some());
        let Some((exact, found)) = exact.zip(found) else {
            continue;
        };
        let off = exact.rotation - found.rotation;
        let off = off - std::f64::consts::TAU * (off / std::f64::consts::TAU).round();
        let bound = exact.error + found.error + 1e-12;
        prop_assert!(off.abs() <= bound, "{off} rad: {exact:?} {found:?}");
    }
    if let (Some(angle), Some(other)) = (exact.angle(), found.angle()) {
        let bound = exact.error().unwrap() + found.error().unwrap() + 1e-12;
        prop_assert!((angle - other).abs() <= bound, "{angle} {other}");
    }
    Ok(exact.status())
}

fn mating(pair: &GearPair, [wheel, pinion]: [u32; 2], flank: Side, fraction: f64) -> Mating {
    let teeth = |member| pair.gear(member).gear().basic_data().teeth();
    Mating {
        wheel_tooth: wheel % teeth(Member::Wheel) + 1,
        pinion_tooth: pinion % teeth(Member::Pinion) + 1,
        flank,
        fraction,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn of_measured_gears_they_have_the_same_lost_motion(
        case in rough_case(),
        teeth in [any::<u16>(), any::<u16>()],
        left in any::<bool>(),
        fraction in -0.5..0.5f64,
    ) {
        if let Ok(pair) = case.try_assemble(1.0) {
            let flank = if left { Side::Left } else { Side::Right };
            agree(&pair, mating(&pair, teeth.map(u32::from), flank, fraction))?;
        }
    }
}

/// From far beyond any shop: undercut, three teeth, jams, tips in fillets and roots.
#[test]
fn of_wide_pairs_they_have_the_same_contacts() {
    let mut seen = std::collections::HashMap::new();
    for number in 0..400 {
        let drawn = Pair::new(77, number).pose(0, Some(Depth::Any));
        let pair = &drawn.assembly;
        let reach =
            |member: Member| pair.gear(member).reach() + pair.gear(member.mate()).eccentricity();
        if reach(Member::Wheel).max(reach(Member::Pinion)) >= pair.center_distance() {
            continue;
        }
        let status = agree(
            pair,
            mating(
                pair,
                [number as u32 * 7, number as u32 * 11],
                Side::Right,
                0.3,
            ),
        );
        *seen
            .entry(status.unwrap_or_else(|error| panic!("pair {number}: {error}")))
            .or_insert(0) += 1;
    }
    assert!(
        [Status::Clear, Status::Interference, Status::Jammed]
            .iter()
            .all(|status| seen[status] > 10),
        "{seen:?}"
    );
}
