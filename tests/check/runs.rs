//! Extremes of pairs beside poses found independently: where a pair assembles, with play in its bearings, and with runout in any direction.

use super::*;
use gearlash::analysis::assembles_from::Threshold;
use gearlash::analysis::extremes::BearingExtremes;

/// Both gears 60 µm thin, off their axes by half a runout of 30 and 20 µm.
fn thin_pair(teeth: [u32; 2], module: f64, shifts: [f64; 2], distance: f64) -> GearPair {
    let gear = |k: usize| spur(teeth[k], module).shift(shifts[k]).allowance(-0.06);
    let wheel = gear(0).runout(0.015, 3.0);
    pair(&wheel, &gear(1).runout(0.010, 2.0), distance)
}

/// No pose of 14 000 over the cycle interferes at `high`; one does at `low`.
fn hold(pair: &GearPair) -> Threshold {
    let from = extremes_of(pair).assembles_from.unwrap();
    assert!(from.high - from.low <= 1e-6, "{from:?}");
    let at = pair.at(from.high).unwrap();
    let kernel = ExactKernel::new(&at);
    for pose in cycle::spread(&at, 14_000) {
        let found = kernel.lost_motion(&pose).unwrap();
        let angle = found.angle().expect("in mesh, and not jammed");
        assert!(angle > -1e-11, "{pose:?}: {angle} rad");
    }
    let below = extremes_of(&pair.at(from.low).unwrap());
    assert!(below.least.unwrap().found() < 0.0);
    from
}

/// Jammed: the tips of 200 teeth are in the fillets of 31. An earlier result, 115.5738 mm, was the bound of an
/// abandoned search, 4 µm off and called proven.
#[test]
fn where_tips_in_fillets_bind_it_is_proven() {
    let pair = thin_pair([200, 31], 1.0, [0.0, 0.2], 115.2);
    assert_eq!(extremes_of(&pair).status, Status::Jammed);
    let from = hold(&pair);
    assert_eq!(from.doubt, None);
    near("assembles from", from.high, 115.56958, 1e-5);
}

/// On the line of action alone it is proven. Undercut teeth are sampled, and said to be.
#[test]
fn where_nothing_bounds_it_is_doubted() {
    for (teeth, module, shift, distance, doubt) in [
        ([51, 23], 2.0, 0.1, 74.0, None),
        ([9, 10], 1.0, 0.0, 9.2, Some(Doubt::OffInvolute)),
    ] {
        let from = hold(&thin_pair(teeth, module, [0.0, shift], distance));
        assert_eq!(from.doubt, doubt, "{teeth:?}");
    }
}

/// So far apart that tips pass each other: at `low` no pose of 14 000 is out of mesh, at `high` one is.
#[test]
fn up_to_where_it_is_in_mesh() {
    let pair = thin_pair([51, 23], 2.0, [0.0, 0.1], 78.6);
    let run = extremes_of(&pair);
    assert_eq!(run.status, Status::NoContact);
    let to = run.meshes_to.unwrap();
    assert!(to.low < to.high && to.high - to.low <= 1e-5, "{to:?}");
    let status = |kernel: &ExactKernel, pose: &Pose| kernel.lost_motion(pose).unwrap().status();
    let at = pair.at(to.low).unwrap();
    let kernel = ExactKernel::new(&at);
    for pose in cycle::spread(&at, 14_000) {
        assert_ne!(status(&kernel, &pose), Status::NoContact, "{pose:?}");
    }
    let beyond = pair.at(to.high).unwrap();
    let lost = status(&ExactKernel::new(&beyond), &Pose::new(&beyond, to.mating));
    assert_eq!(lost, Status::NoContact);
}

/// Outlines are in mesh up to the same distance as the pair by data.
#[test]
fn outlines_are_in_mesh_as_far_as_their_data() {
    let by_data = pair(&spur(19, 2.0), &spur(17, 2.0), 39.9);
    let [wheel, pinion] = Member::BOTH.map(|member| OutlineGear::from(by_data.gear(member)));
    let gears = vec![(Material::AsMeasured, wheel, pinion)];
    let sweep = SweepPlan::wheel_revolution(&by_data, 1, (1, 1));
    let study = Study::of_drawn("outlines", gears, by_data.locked(), vec![39.9], sweep);
    let runs = [extremes_of(&by_data), run_of(&study)];
    let [by_data, drawn] = runs.map(|run| run.meshes_to.unwrap());
    assert!(drawn.low < drawn.high && drawn.high - drawn.low <= 1e-5);
    near("low", drawn.low, by_data.low, 1e-5);
    near("high", drawn.high, by_data.high, 1e-5);
}

/// Where involutes bound nothing, the outlines prove both extremes: contact ratio near 1, without a pair that stays on the line of action through a part of
/// a pitch, and made profiles. Source: 14 000 poses of the exact method.
#[test]
fn outlines_prove_what_involutes_do_not_bound() {
    let profiled = study("fixtures/profiled_44x44.toml")
        .runs()
        .unwrap()
        .swap_remove(0);
    let thin = thin_pair([101, 97], 1.0, [0.0, 0.0], 100.6);
    for pair in [thin, profiled.run.assembly.data().unwrap().clone()] {
        let run = extremes_of(&pair);
        let [least, greatest] = [run.least.unwrap(), run.greatest.unwrap()];
        assert!(least.is_proven() && greatest.is_proven());
        let kernel = ExactKernel::new(&pair);
        let radius = pair.operating_pitch_radius(pair.free());
        for pose in cycle::spread(&pair, 14_000) {
            let j = kernel.lost_motion(&pose).unwrap().angle().unwrap() * radius;
            assert!((least.low..=greatest.high).contains(&j), "{j}");
        }
    }
}

/// Perfect gears `e` off their axes in any direction. At every pose, high teeth towards the mate bring the outlines nearer by `e`, and away
/// from it further apart. The pairs assemble from `Σ e` further than without, and are in mesh up to `Σ e` nearer.
#[test]
fn a_runout_in_any_direction_moves_both_ends_by_the_eccentricities() {
    let run = |distance: f64, share: f64| {
        let gear = |teeth, e: f64| spur(teeth, 2.0).runout(share * e, 1.0).open(share > 0.0);
        extremes_of(&pair(&gear(31, 0.012), &gear(17, 0.007), distance))
    };
    // Nominal teeth have no backlash at 48 mm.
    for (share, expected) in [(0.0, 48.0), (1.0, 48.019)] {
        let found = run(47.95, share).assembles_from.unwrap();
        let around = found.low - 1e-9..found.high + 1e-9;
        assert!(around.contains(&expected), "{found:?}");
        assert!(found.high - found.low <= 1e-6, "{found:?}");
    }
    let [without, with] = [0.0, 1.0].map(|share| run(51.9, share).meshes_to.unwrap());
    near("low", without.low - with.low, 0.019, 2e-5);
    near("high", without.high - with.high, 0.019, 2e-5);
    let width = with.high - with.low;
    assert!(width > 0.0 && width <= 1e-5, "{with:?}");
}

/// 31/17 teeth, m 2, 20°: 50 µm thin, with `share` of 20 µm of pitch deviation and of eccentricity.
fn in_bearings(distance: f64, share: f64, any_direction: bool) -> GearPair {
    let [wheel, pinion] = [31, 17].map(|teeth: u32| {
        let mut random = Random::of(31, u64::from(teeth));
        let off = |_| 0.02 * share * random.within(-1.0, 1.0);
        let both = Vec::from_iter((0..2 * teeth).map(off));
        let (right, left) = both.split_at(teeth as usize);
        let gear = spur(teeth, 2.0).allowance(-0.05).runout(0.02 * share, 3.0);
        gear.open(any_direction).pitch(right, left)
    });
    pair(&wheel, &pinion, distance)
}

fn run_with(pair: &GearPair, clearance: f64) -> RunExtremes {
    run_of(&Study {
        bearing_clearance: clearance,
        ..Study::of_pair("bearings", pair, 1)
    })
}

fn play(pair: &GearPair, clearance: f64) -> BearingExtremes {
    run_with(pair, clearance).bearings.unwrap()
}

/// The same brackets as of pairs that are assembled there; the pose that is named has what is said of it, simulated anew; and no pose of any
/// distance between is beyond them.
#[test]
fn deviating_gears_have_the_extremes_of_pairs_that_stand_there() {
    for any_direction in [false, true] {
        let pair = in_bearings(48.05, 1.0, any_direction);
        let found = play(&pair, 0.03);
        let near_by = extremes_of(&pair.at(48.02).unwrap());
        let far = extremes_of(&pair.at(48.08).unwrap());
        assert_eq!(found.clearance, 0.03);
        for (end, there, distance) in [
            (&found.pressed, near_by.least, 48.02),
            (&found.pulled_apart, far.greatest, 48.08),
        ] {
            let stands = end.assembly.center_distance();
            near("distance", stands, distance, 1e-12);
            assert_eq!(end.status, Status::Clear);
            let (end, there) = (end.extreme.as_ref().unwrap(), there.unwrap());
            assert!(end.doubt == there.doubt);
            near("low", end.low, there.low, 1e-9);
            near("high", end.high, there.high, 1e-9);
            let named = end.assembly.data().unwrap();
            let j_wt = backlash(named, &end.pose.simulated.pose);
            let around = end.low - 1e-9..=end.high + 1e-9;
            assert!(around.contains(&j_wt), "{any_direction}: {j_wt}");
        }
        let [pressed, apart] = [found.pressed, found.pulled_apart].map(|end| end.extreme.unwrap());
        let around = pressed.low - 1e-9..=apart.high + 1e-9;
        for step in 0..=6 {
            let pair = pair.at(48.02 + 0.01 * f64::from(step)).unwrap();
            let kernel = ExactKernel::new(&pair);
            for pose in cycle::spread(&pair, 2_000) {
                let angle = kernel.lost_motion(&pose).unwrap().angle().unwrap();
                let j_wt = angle * pair.operating_pitch_radius(pair.free());
                assert!(around.contains(&j_wt), "{j_wt}");
            }
        }
    }
}

/// Half a module nearer, tips are in roots; three modules further, nothing meets.
#[test]
fn ends_without_a_value_say_why() {
    let found = play(&in_bearings(49.5, 0.0, false), 3.0);
    assert_eq!(found.pressed.status, Status::Jammed);
    assert_eq!(found.pulled_apart.status, Status::NoContact);
    assert!(found.pressed.extreme.is_none() && found.pulled_apart.extreme.is_none());
}

/// A limit is of the pair wherever its bearings let it stand.
#[test]
fn a_requirement_holds_for_the_axes_moved_too() {
    let pair = in_bearings(48.05, 0.0, false);
    // Both gears are 50 µm thin.
    let [least, exactly, most] = [48.03, 48.05, 48.07].map(|a| kit::j_wt(a, 48.0, 0.1));
    let [below, above] = [exactly - 1e-3, exactly + 1e-3].map(Some);
    for (clearance, min, max, kept) in [
        (0.0, below, above, true),
        (0.02, below, None, false),
        (0.02, None, above, false),
        (0.02, Some(least - 1e-5), Some(most + 1e-5), true),
    ] {
        let required = vec![(Quantity::OperatingBacklash, Limits { min, max })];
        let run = run_with(&pair, clearance);
        let verdict = Verdict::new(std::slice::from_ref(&run), &required, None, Vec::new());
        let is_met = verdict.requirement == RequirementOutcome::Met;
        assert_eq!(is_met, kept, "{required:?}");
        assert!(verdict.unmet.iter().all(|unmet| unmet.with_clearance));
        let ends = (verdict.least_pressed(), verdict.greatest_apart());
        assert_eq!(ends.0.is_some() && ends.1.is_some(), clearance > 0.0);
    }
}

/// A row of drawn pairs: seed, count, helix angle in degrees, greatest single pitch deviation in modules. Then whether the runout of wheel and pinion
/// has any direction, and the locked gear.
type Drawn = (u64, u32, f64, f64, [bool; 2], Member);

fn gear(random: &mut Random, hand: Hand, (_, _, helix, share, ..): Drawn, open: bool) -> Make {
    let teeth = random.within(17.0, 60.0) as u32;
    let gear = spur(teeth, 2.0).helix(helix, hand).allowance(-0.04);
    let gear = gear.shift(random.within(0.0, 0.4)).open(open);
    let mut pitch = || Vec::from_iter((0..teeth).map(|_| share * 2.0 * random.within(-1.0, 1.0)));
    let (right, left) = (pitch(), pitch());
    let eccentricity = random.within(0.0, 0.04);
    let gear = gear.runout(eccentricity, random.within(1.0, f64::from(teeth) + 1.0));
    if share > 0.0 {
        return gear.pitch(&right, &left);
    }
    gear
}

fn draw(random: &mut Random, drawn: Drawn) -> GearPair {
    let (_, _, helix, _, open, locked) = drawn;
    let wheel = gear(random, Hand::Right, drawn, open[0]);
    let pinion = gear(random, Hand::Left, drawn, open[1]);
    let zero = InvolutePair::new(&wheel.gear(), &pinion.gear());
    let distance = zero.center_distance(0.0).unwrap() + random.within(-0.02, 0.15);
    let pair = kit::locked(&wheel, &pinion, distance, locked);
    // Off the measuring plane's middle, so that one end of the face is nearer.
    let face = if helix > 0.0 { [-9.0, 21.0] } else { [0.0; 2] };
    pair.with_face(face).unwrap()
}

/// `pair` with each gear without a direction turned so that its high tooth lies at an angle from the line to its mate, at `mating`.
fn pointed(pair: &GearPair, mating: Mating, angles: [f64; 2]) -> GearPair {
    let pose = Pose::new(pair, mating);
    let [wheel, pinion] = Member::BOTH.map(|member| {
        let gear = pair.gear(member);
        if !gear.any_direction() {
            return gear.clone();
        }
        let teeth = f64::from(pair.teeth(member));
        let angle = angles[member as usize] - pose.rotation(pair, member);
        let places = (gear.face().ascending() * angle * teeth / TAU).rem_euclid(teeth);
        let tooth = if places < teeth { 1.0 + places } else { 1.0 };
        gear.with_runout(gear.eccentricity(), tooth).unwrap()
    });
    let pointed = GearPair::with_locked(wheel, pinion, pair.center_distance(), pair.locked());
    pointed.unwrap().with_face(pair.face()).unwrap()
}

/// Poses with the high teeth anywhere, and near where they are worst: none lies beyond the bracket, and one attains it.
fn directions_hold(drawn: Drawn) {
    let mut random = Random(drawn.0);
    for _ in 0..drawn.1 {
        let pair = draw(&mut random, drawn);
        let run = extremes_of(&pair);
        let (least, greatest) = (run.least.as_ref().unwrap(), run.greatest.as_ref().unwrap());
        assert!(least.doubt.is_none() && greatest.doubt.is_none());
        for (extreme, end) in [(least, least.high), (greatest, greatest.low)] {
            assert!(extreme.high - extreme.low <= 1.1e-6, "{extreme:?}");
            let attained = extreme.pose.simulated.backlash.unwrap();
            near(drawn, attained, end, 1e-10);
        }
        let bracket = least.low - 1e-10..=greatest.high + 1e-10;
        for k in 0..1000 {
            // In the listed assembly phase.
            let near_by = *[&least.pose, &greatest.pose][k % 2].simulated.pose.mating();
            let cycle = cycle::matings(&pair) as f64;
            let mating = near_by.onward(&pair, cycle * random.within(0.0, 1.0));
            // Anywhere, towards the mate, away from it; of pairs found, a little round where they stand.
            let spread = [PI, 0.1, 0.01][k % 3];
            let away = [0.0, PI][k % 2];
            let mating = match k % 5 {
                0 => near_by.onward(&pair, random.within(-0.01, 0.01)),
                _ => mating,
            };
            let mut angle = || away + random.within(-spread, spread);
            let pointed = pointed(&pair, mating, [angle(), angle()]);
            let j_wt = backlash(&pointed, &Pose::new(&pointed, mating));
            assert!(bracket.contains(&j_wt), "{drawn:?}: {j_wt} of {bracket:?}");
        }
    }
}

const ANY: [bool; 2] = [true, true];
const WHEEL: [bool; 2] = [true, false];
const PINION: [bool; 2] = [false, true];

/// As in a drawing: runout alone. Then the direction of one of them is known. Then with pitch deviations, so that corners of tips decide. The
/// centres of all sections of helical gears are the same along the face.
#[test]
fn gears_off_their_axes_in_any_direction() {
    for drawn in [
        (5, 12, 0.0, 0.0, ANY, Member::Wheel),
        (5, 12, 0.0, 0.0, ANY, Member::Pinion),
        (6, 8, 0.0, 0.0, WHEEL, Member::Wheel),
        (6, 8, 0.0, 0.0, WHEEL, Member::Pinion),
        (6, 8, 0.0, 0.0, PINION, Member::Wheel),
        (7, 12, 0.0, 0.008, ANY, Member::Wheel),
        (8, 6, 18.0, 0.0, ANY, Member::Wheel),
        (8, 6, 18.0, 0.0, WHEEL, Member::Pinion),
        (8, 6, 18.0, 0.004, ANY, Member::Pinion),
        (8, 6, 18.0, 0.004, PINION, Member::Wheel),
    ] {
        directions_hold(drawn);
    }
}

/// The bound's derivation is for eccentricities below a quarter of the free gear's pitch radius; beyond it nothing is claimed.
#[test]
fn a_runout_of_a_quarter_of_a_pitch_radius_is_not_bounded() {
    for (eccentricity, bounded) in [(1.2, true), (2.2, false)] {
        let pinion = spur(8, 2.0).shift(0.1).runout(eccentricity, 1.0).open(true);
        let pair = pair(&spur(40, 2.0), &pinion, 50.4);
        let doubt = extremes_of(&pair).least.unwrap().doubt;
        assert_eq!(doubt != Some(Doubt::Unbounded), bounded, "{doubt:?}");
    }
}
