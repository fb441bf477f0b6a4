//! Brackets of random pairs against poses of the exact method, and the share of ordinary pairs that is proven.
//!
//! `GEARLASH_PAIRS=500` draws as many pairs for each test and prints what it finds:
//!
//! ```text
//! GEARLASH_PAIRS=500 cargo test --release --test exact brackets::ordinary -- --nocapture
//! GEARLASH_PAIRS=300 cargo test --release --test exact brackets::no_pose -- --nocapture
//! ```

use crate::extremes::cycle::{matings, spread};
use crate::modified::profile;
use crate::random::Random;
use gearlash::analytic::InvolutePair;
use gearlash::contact::{ExactKernel, Extremes, Status};
use gearlash::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Pitch, thickness,
};
use gearlash::pair::{GearPair, Mating, Member};

/// Greatest width of a proven bracket, and rounding of poses, mm.
const WIDTH: f64 = 1e-6;
const ROUNDING: f64 = 1e-10;

/// Ranges of the values of a gear.
#[derive(Clone, Copy)]
struct Kind {
    teeth: [f64; 2],
    profile_shift: [f64; 2],
    /// Greatest runout and pitch deviation, mm.
    runout: f64,
    pitch: f64,
    profiles: bool,
    /// Greatest expansion of one gear beside the other.
    expansion: f64,
    /// Increase of the centre distance beyond the one without backlash, modules.
    apart: [f64; 2],
}

const ORDINARY: Kind = Kind {
    teeth: [17.0, 60.99],
    profile_shift: [-0.2, 0.6],
    runout: 0.06,
    pitch: 0.01,
    profiles: false,
    expansion: 0.0,
    apart: [0.0, 0.03],
};

fn gear(random: &mut Random, kind: Kind, face: Face) -> Option<AsBuilt> {
    let within = |random: &mut Random, [low, high]: [f64; 2]| random.within(low, high);
    let teeth = within(random, kind.teeth) as u32;
    let basic_data = BasicGearData::new(teeth, 2.0, 20f64.to_radians()).ok()?;
    let design = GearDesign {
        basic_data,
        profile_shift: within(random, kind.profile_shift),
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    };
    let allowance = random.within(-0.1, -0.02);
    let base =
        thickness::base_from_allowance(&basic_data, design.nominal_base_thickness(), allowance);
    let gear = Gear::new(design, base).ok()?;
    let pitch = kind.pitch * random.within(0.0, 1.0);
    let mut curve = || -> Vec<f64> {
        let each = (0..teeth).map(|_| pitch * random.within(-0.5, 0.5));
        each.collect()
    };
    let pitch = Pitch::from_cumulative(&curve(), &curve());
    let profiles = if kind.profiles {
        [0; 2].map(|_| profile(random, &gear, false))
    } else {
        Deviations::default().profiles
    };
    let deviations = Deviations {
        pitch: Some(pitch),
        eccentricity: 0.5 * kind.runout * random.within(0.0, 1.0),
        high_tooth: random.within(1.0, f64::from(teeth) + 0.99),
        profiles,
        ..Deviations::default()
    };
    let built = AsBuilt::new(gear, face, &deviations).ok()?;
    if kind.expansion > 0.0 {
        built
            .expanded(1.0 + kind.expansion * random.within(-1.0, 1.0))
            .ok()
    } else {
        Some(built)
    }
}

fn pair(random: &mut Random, kind: Kind) -> Option<GearPair> {
    let wheel = gear(random, kind, Face::Front)?;
    let pinion = gear(random, kind, Face::Back)?;
    let nominal = |gear: &AsBuilt| Gear::nominal(*gear.gear().design()).ok();
    let closed = InvolutePair::new(&nominal(&wheel)?, &nominal(&pinion)?).center_distance(0.0)?;
    let apart = 2.0 * random.within(kind.apart[0], kind.apart[1]);
    let locked = if random.chance(0.5) {
        Member::Wheel
    } else {
        Member::Pinion
    };
    GearPair::with_locked(wheel, pinion, closed + apart, locked).ok()
}

fn drawn(seed: u64, kind: Kind) -> impl Iterator<Item = GearPair> {
    let mut random = Random(seed);
    std::iter::repeat_with(move || pair(&mut random, kind)).flatten()
}

/// The extremes of a pair, none of `count` poses beyond its brackets.
fn held(pair: &GearPair, count: u32) -> Extremes {
    let kernel = ExactKernel::new(pair);
    let found = kernel
        .extremes(pair, Mating::FIRST, matings(pair), WIDTH)
        .unwrap();
    let radius = pair.operating_pitch_radius(pair.free());
    for pose in spread(pair, count) {
        let Ok(lost) = kernel.lost_motion(&pose) else {
            continue;
        };
        let (least, most) = (found.least, found.greatest);
        match lost.angle() {
            Some(angle) => {
                let j = angle * radius;
                let low = least.is_none_or(|least| j >= least.low - ROUNDING);
                let high = most.is_none_or(|most| j <= most.high + ROUNDING);
                assert!(low && high, "{j}: {found:?} {pair:?}");
            }
            None if lost.status() == Status::Jammed => {
                assert!(
                    least.is_none_or(|least| !least.low.is_finite()),
                    "{found:?}"
                );
            }
            None => assert!(most.is_none_or(|most| !most.high.is_finite()), "{found:?}"),
        }
    }
    found
}

fn is_proven(found: &Extremes) -> bool {
    let both = [found.least, found.greatest];
    both.iter()
        .all(|one| one.is_some_and(|one| one.is_proven()))
}

/// Pairs that a test draws: `GEARLASH_PAIRS`, or `few`.
fn pairs_wanted(few: usize) -> usize {
    let wanted = std::env::var("GEARLASH_PAIRS").ok();
    wanted.map_or(few, |number| {
        number.parse().expect("GEARLASH_PAIRS is a number")
    })
}

/// At least 99 % of ordinary pairs are proven. Small runouts and pitch deviations make nearly equal matings.
#[test]
fn ordinary_pairs_are_proven() {
    let sizes = [(0.06, 0.01), (0.004, 0.0005), (0.002, 0.0)];
    let count = pairs_wanted(150);
    let mut proven = 0;
    for (seed, (runout, pitch)) in (1..).zip(sizes) {
        let kind = Kind {
            runout,
            pitch,
            ..ORDINARY
        };
        let pairs = drawn(seed, kind).take(count / sizes.len());
        let found = pairs.filter(|pair| is_proven(&held(pair, 60))).count();
        println!("runout up to {runout}, pitch up to {pitch}: {found} proven");
        proven += found;
    }
    let drawn = count / sizes.len() * sizes.len();
    println!("{proven} of {drawn} proven");
    assert!(100 * (drawn - proven) <= drawn, "{proven} of {drawn}");
}

/// No pose lies beyond a bracket of undercut, jammed, modified and unequal pairs. Most brackets have two ends.
#[test]
fn no_pose_lies_beyond_a_bracket_of_any_kind() {
    let undercut = Kind {
        teeth: [6.0, 16.99],
        profile_shift: [-0.2, 0.5],
        runout: 0.1,
        pitch: 0.02,
        apart: [-0.05, 0.2],
        ..ORDINARY
    };
    let modified = Kind {
        profiles: true,
        ..ORDINARY
    };
    let warm = Kind {
        expansion: 0.004,
        ..ORDINARY
    };
    let count = pairs_wanted(30);
    for (seed, kind) in [(4, undercut), (5, modified), (6, warm)] {
        let pairs = drawn(seed, kind).filter(|pair| matings(pair) < 800);
        let (mut ends, mut all) = (0, 0);
        for pair in pairs.take(count / 3) {
            let found = held(&pair, 200);
            let least = found.least.into_iter().map(|one| one.low);
            let bounds = least.chain(found.greatest.map(|one| one.high));
            for bound in bounds {
                ends += usize::from(bound.is_finite());
                all += 1;
            }
        }
        println!("kind {seed}: {ends} of {all} ends bounded");
        assert!(10 * ends >= 8 * all, "{seed}: {ends} of {all}");
    }
}

/// 20 and 31 teeth, runouts of 2 µm, at this centre distance.
fn nearly_true(distance: f64) -> GearPair {
    let gear = |teeth, allowance, high_tooth, face| {
        let basic_data = BasicGearData::new(teeth, 2.0, 20f64.to_radians()).unwrap();
        let design = GearDesign::standard(basic_data);
        let base =
            thickness::base_from_allowance(&basic_data, design.nominal_base_thickness(), allowance);
        let deviations = Deviations {
            eccentricity: 0.001,
            high_tooth,
            ..Deviations::default()
        };
        AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap()
    };
    let wheel = gear(20, -0.043, 3.8, Face::Front);
    let pinion = gear(31, -0.045, 11.5, Face::Back);
    GearPair::new(wheel, pinion, distance).unwrap()
}

/// Only involutes touch, and every mating comes near the extremes. Source: 100 000 poses.
#[test]
fn nearly_true_gears_are_proven() {
    let pair = nearly_true(51.05);
    let found = held(&pair, 0);
    assert!(is_proven(&found), "{found:?}");
    let kernel = ExactKernel::new(&pair);
    let radius = pair.operating_pitch_radius(pair.free());
    let poses = spread(&pair, 100_000);
    let each = poses.map(|pose| kernel.lost_motion(&pose).unwrap().angle().unwrap() * radius);
    let [low, high] = each.fold([f64::MAX, f64::MIN], |[low, high], j| {
        [low.min(j), high.max(j)]
    });
    let (least, greatest) = (found.least.unwrap(), found.greatest.unwrap());
    assert!(
        least.low <= low && low < least.high + 2e-6,
        "{low} {least:?}"
    );
    assert!(
        greatest.low - 2e-6 < high && high <= greatest.high,
        "{high} {greatest:?}"
    );
}

/// The last bits of the distance do not change the named teeth.
#[test]
fn the_last_bits_name_no_other_teeth() {
    let teeth = |distance: f64| {
        let found = held(&nearly_true(distance), 0);
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
    // Perfect gears have their extremes at every mating; the first is named.
    let perfect = |teeth, face| {
        let basic_data = BasicGearData::new(teeth, 2.0, 20f64.to_radians()).unwrap();
        AsBuilt::perfect(
            Gear::nominal(GearDesign::standard(basic_data)).unwrap(),
            face,
        )
    };
    let pair = GearPair::new(perfect(20, Face::Front), perfect(31, Face::Back), 51.05).unwrap();
    let found = held(&pair, 0);
    for extreme in [found.least, found.greatest] {
        assert_eq!(extreme.unwrap().mating, Mating::FIRST);
    }
}
