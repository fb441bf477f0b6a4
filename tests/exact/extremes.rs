//! Proven extremes of the mesh cycle, compared with poses of the exact method, which do not use their bounds.

use super::*;
use crate::cycle::{matings, spread};
use crate::kit;
use crate::random::{self, Random};
use crate::random_pair::{Case, case, rough_case};
use gearlash::contact::{Doubt, Extremes, cycle_extremes};
use gearlash::error::GearError;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use rayon::prelude::*;

/// Width of a bracket, mm.
pub const WIDTH: f64 = 1e-6;

/// Values of one pose are known to 1e-10 mm at the very worst (rounding).
pub const ROUNDING: f64 = 1e-10;

/// The extremes of `matings` from `first` on. No pose is outside a bracket, proven or not; where it has two ends, no jam or gap in the mesh is missed.
pub fn held_from(
    pair: &GearPair,
    first: Mating,
    matings: u64,
    poses: impl Iterator<Item = Pose>,
) -> Result<Extremes, String> {
    let kernel = ExactKernel::new(pair);
    let found = cycle_extremes(&kernel, pair, first, matings, WIDTH).unwrap();
    let radius = pair.operating_pitch_radius(pair.free());
    // Contact lost anywhere along the face leaves no greatest value.
    let bounds_greatest = |doubt: Option<Doubt>| {
        !pair.varies_along_face() || doubt.is_none_or(|doubt| doubt == Doubt::Effort)
    };
    let low = found.least.map_or(f64::NEG_INFINITY, |least| least.low);
    let greatest = found.greatest.filter(|one| bounds_greatest(one.doubt));
    let high = greatest.map_or(f64::INFINITY, |greatest| greatest.high);
    for pose in poses {
        let Ok(lost) = kernel.lost_motion(&pose) else {
            continue;
        };
        let known = match lost.error().filter(|_| pair.leans()) {
            Some(error) => error * radius,
            None => ROUNDING,
        };
        let is_held = match (lost.angle(), lost.status()) {
            (Some(angle), _) => (low - known..=high + known).contains(&(angle * radius)),
            (None, Status::Jammed) => !low.is_finite(),
            (None, _) => !high.is_finite(),
        };
        if !is_held {
            return Err(format!("{lost:?} outside {found:?}"));
        }
    }
    for extreme in [found.least, found.greatest].into_iter().flatten() {
        let is_inside = extreme.low <= extreme.found && extreme.found <= extreme.high;
        let is_narrow = extreme.high - extreme.low <= WIDTH + ROUNDING;
        if !is_inside || extreme.is_proven() != is_narrow {
            return Err(format!("{extreme:?}"));
        }
    }
    Ok(found)
}

/// [`held_from`] the first mating for the whole cycle, with `count` poses spread over it by the golden ratio.
pub fn held(pair: &GearPair, count: u32) -> Result<Extremes, String> {
    held_from(pair, Mating::FIRST, matings(pair), spread(pair, count))
}

/// The number of proven extremes.
pub fn proven(found: &Extremes) -> usize {
    let both = [found.least, found.greatest].into_iter().flatten();
    both.filter(|one| one.is_proven()).count()
}

/// Rough pairs are mostly jammed or off the line of action, where nothing is proven; these are not. Small runouts and pitch deviations make nearly
/// equal matings. Some gears have base pitches that differ by up to 0.4 %; a few of them touch off the line of action.
#[test]
fn ordinary_pairs_are_proven_and_hold() {
    for (count, deviations, expansion, poses, least) in [
        (100, 1.0, 0.0, 150, 100),
        (50, 0.03, 0.0, 60, 50),
        (40, 1.0, 0.002, 1500, 32),
    ] {
        let mut runner = TestRunner::deterministic();
        let drawn = (case(), prop::array::uniform2(-1.0..1.0f64));
        let mut found = 0;
        for _ in 0..count {
            let (mut case, warm) = drawn.new_tree(&mut runner).unwrap().current();
            for recipe in [&mut case.wheel, &mut case.pinion] {
                recipe.runout_um *= deviations;
                let each = recipe.per_tooth_um.as_flattened_mut();
                each.iter_mut().for_each(|um| *um *= deviations);
            }
            if deviations < 1.0 {
                case.radial_play = case.radial_play.abs();
            }
            let pair = case.warmed(warm.map(|warm| expansion * warm)).unwrap();
            found += usize::from(proven(&held(&pair, poses).unwrap()) == 2);
        }
        assert!(found >= least, "{found} for {deviations}, {expansion}");
    }
}

/// Pairs that may be impossible need not hold.
fn holds(pair: Result<GearPair, GearError>, count: u32) -> Result<(), TestCaseError> {
    let Ok(pair) = pair else { return Ok(()) };
    held(&pair, count).map(|_| ()).map_err(TestCaseError::fail)
}

/// All lengths expand equally, including the housing: the angles stay.
fn turns_as_before(case: &Case, expansion: f64) -> Result<(), TestCaseError> {
    let (Ok(pair), Ok(warm)) = (case.try_assemble(1.0), case.warmed([expansion; 2])) else {
        return Ok(());
    };
    let Ok(warm) = warm.at(pair.center_distance() * (1.0 + expansion)) else {
        return Ok(());
    };
    let kernels = [ExactKernel::new(&pair), ExactKernel::new(&warm)];
    for (cold, hot) in spread(&pair, 20).zip(spread(&warm, 20)) {
        let cold = kernels[0].lost_motion(&cold).unwrap();
        let hot = kernels[1].lost_motion(&hot).unwrap();
        prop_assert_eq!(cold.status(), hot.status());
        if let Some((cold, hot)) = cold.angle().zip(hot.angle()) {
            prop_assert!((cold - hot).abs() < 1e-12, "{} {}", cold, hot);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(9))]

    /// Pairs with pitch deviations, runout and odd teeth; nearer by up to 0.4 mm tips are in fillets, which bound the lost motion. Unequal temperatures
    /// make base pitches differ: a bound for equal ones gave 391.85 µm for a POM wheel on a steel pinion at 50 °C, where a pose has 381.96.
    #[test]
    fn no_pose_lies_beyond(
        case in rough_case(),
        expansion in prop::array::uniform2(-0.008..0.008f64),
        closer in 0.0..0.2f64,
    ) {
        let pair = case.try_assemble(1.0);
        holds(pair.clone(), 1000)?;
        holds(case.warmed(expansion), 1000)?;
        let distance = |pair: &GearPair| pair.center_distance() - closer * 2.0;
        holds(pair.and_then(|pair| pair.at(distance(&pair))), 270)?;
        turns_as_before(&case, expansion[0])?;
    }
}

/// Far outside practice: undercut, raised tips, three teeth, jams. A failed search gives a doubt, never a wrong bracket.
#[test]
fn wide_pairs_hold_or_are_doubted() {
    let mut found = 0;
    for number in 0..40 {
        let pair = Pair::new(31, number).pose(0, Some(Depth::Any)).assembly;
        // Long cycles of pairs that must be searched take seconds.
        if pair.teeth(Member::Wheel) * pair.teeth(Member::Pinion) < 900 {
            let least = held(&pair, 340).unwrap().least;
            found += u32::from(least.is_some_and(|least| least.is_proven()));
        }
    }
    assert!(found > 1, "{found}");
}

/// Profiles that deviate, with traces. Source: random poses of the exact method.
#[test]
fn extremes_of_deviating_profiles_hold() {
    let bounded = (0..56u64).into_par_iter().filter_map(|seed| {
        let mut random = Random(seed ^ 0xe47e);
        let pair = crate::profiles::deviating_pair(&mut random, true)?;
        if Member::BOTH.iter().any(|member| pair.teeth(*member) > 80) {
            return None;
        }
        let first = random::mating(&mut random, &pair);
        let poses = (0..100).map(|_| random.within(0.0, 40.0) - first.fraction);
        let poses = poses.map(|pitches| Pose::new(&pair, first.onward(&pair, pitches)));
        let found =
            held_from(&pair, first, 40, poses).unwrap_or_else(|why| panic!("{seed}: {why}"));
        let (least, greatest) = found.least.zip(found.greatest)?;
        (least.low.is_finite() && greatest.high.is_finite()).then_some(seed)
    });
    assert!(bounded.count() > 8);
}

fn perfect(teeth: [u32; 2], distance: f64) -> GearPair {
    kit::pair(&spur(teeth[0], 2.0), &spur(teeth[1], 2.0), distance)
}

/// Perfect gears: on the line of action `j_wt` is the same at every pose and follows from the involute (model 2). Every mating has the extremes; the
/// first is named.
#[test]
fn perfect_gears_have_one_backlash() {
    for (teeth, distance) in [([44, 44], 88.1), ([25, 60], 85.07), ([31, 17], 48.05)] {
        let pair = perfect(teeth, distance);
        let found = held(&pair, 0).unwrap();
        let closed = InvolutePair::of(&pair).circumferential_backlash(distance);
        for extreme in [found.least.unwrap(), found.greatest.unwrap()] {
            assert!(extreme.is_proven());
            let around = extreme.low - WIDTH..=extreme.high + WIDTH;
            assert!(around.contains(&closed.unwrap()), "{extreme:?}");
            assert_eq!(extreme.mating, Mating::FIRST);
        }
        assert_eq!(found.status, Status::Clear);
    }
}

/// Tips in the roots leave no least value, but a pose to report. Tips that lose each other between two teeth leave no greatest value.
#[test]
fn pairs_jammed_or_out_of_mesh_have_no_extreme_there() {
    let jammed = held(&perfect([20, 20], 39.4), 0).unwrap();
    assert_eq!((jammed.status, jammed.least), (Status::Jammed, None));
    assert!(jammed.lost.is_some());
    let apart = held(&perfect([20, 20], 43.995), 0).unwrap();
    assert_eq!((apart.status, apart.greatest), (Status::NoContact, None));
    let doubt = apart.least.and_then(|least| least.doubt);
    assert_ne!(doubt, Some(Doubt::ContactLost));
}

/// 20 and 31 teeth, runouts of 2 µm, at this centre distance.
fn nearly_true(distance: f64) -> GearPair {
    let wheel = spur(20, 2.0).allowance(-0.043).runout(0.001, 3.8);
    let pinion = spur(31, 2.0).allowance(-0.045).runout(0.001, 11.5);
    kit::pair(&wheel, &pinion, distance)
}

/// Only involutes touch, and every mating comes near the extremes. Source: 100 000 poses.
#[test]
fn nearly_true_gears_are_proven() {
    let pair = nearly_true(51.05);
    let found = held(&pair, 0).unwrap();
    assert_eq!(proven(&found), 2, "{found:?}");
    let kernel = ExactKernel::new(&pair);
    let radius = pair.operating_pitch_radius(pair.free());
    let poses = spread(&pair, 100_000);
    let each = poses.map(|pose| kernel.lost_motion(&pose).unwrap().angle().unwrap() * radius);
    let [low, high] = kit::ends(each);
    let (least, greatest) = (found.least.unwrap(), found.greatest.unwrap());
    assert!(least.low <= low && high <= greatest.high, "{found:?}");
    assert!(low < least.high + 2e-6, "{found:?}");
    assert!(greatest.low - 2e-6 < high, "{found:?}");
}

/// The last bits of the distance do not change the named teeth.
#[test]
fn the_last_bits_name_no_other_teeth() {
    let teeth = |distance: f64| {
        let found = held(&nearly_true(distance), 0).unwrap();
        [found.least, found.greatest].map(|extreme| {
            let mating = extreme.unwrap().mating;
            (mating.wheel_tooth, mating.pinion_tooth)
        })
    };
    let mut distance = 51.05f64;
    let expected = teeth(distance);
    for _ in 0..20 {
        distance = distance.next_up();
        assert_eq!(teeth(distance), expected, "{distance}");
    }
}
