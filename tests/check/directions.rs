//! Runout without a direction: poses with the high teeth anywhere, and near where they are worst, against the bracket.

use super::*;
use gearlash::contact::Doubt;
use gearlash::gear::{Hand, Pitch, thickness};
use std::f64::consts::{PI, TAU};

/// The drawn data of a pair.
#[derive(Debug, Clone, Copy)]
struct Drawn {
    /// Single pitch deviations up to this share of the module.
    pitch: f64,
    open: [bool; 2],
    locked: Member,
    /// Helix angle, degrees, and length of the face, mm.
    helix: (f64, f64),
}

fn gear(random: &mut Random, face: Face, drawn: &Drawn, open: bool) -> AsBuilt {
    let module = 2.0;
    let teeth = random.within(17.0, 60.0) as u32;
    let hand = if face == Face::Front {
        Hand::Right
    } else {
        Hand::Left
    };
    let data = BasicGearData::new(teeth, module, 20f64.to_radians()).unwrap();
    let data = data.with_helix(drawn.helix.0.to_radians(), hand).unwrap();
    let design = GearDesign {
        profile_shift: random.within(0.0, 0.4),
        ..GearDesign::standard(data)
    };
    let base =
        thickness::base_from_allowance(&design.basic_data, design.nominal_base_thickness(), -0.04);
    let mut pitch = || -> Vec<f64> {
        (0..teeth)
            .map(|_| drawn.pitch * module * random.within(-1.0, 1.0))
            .collect()
    };
    let (right, left) = (pitch(), pitch());
    let deviations = Deviations {
        pitch: (drawn.pitch > 0.0).then(|| Pitch::from_cumulative(&right, &left)),
        eccentricity: random.within(0.0, 0.02 * module),
        high_tooth: random.within(1.0, f64::from(teeth) + 1.0),
        any_direction: open,
        ..Deviations::default()
    };
    AsBuilt::new(Gear::new(design, base).unwrap(), face, &deviations).unwrap()
}

fn draw(random: &mut Random, drawn: &Drawn) -> GearPair {
    let wheel = gear(random, Face::Front, drawn, drawn.open[0]);
    let pinion = gear(random, Face::Back, drawn, drawn.open[1]);
    let zero = gearlash::analytic::InvolutePair::new(wheel.gear(), pinion.gear());
    let distance = zero.center_distance(0.0).unwrap() + random.within(-0.02, 0.15);
    let pair = GearPair::with_locked(wheel, pinion, distance, drawn.locked).unwrap();
    // Off the measuring plane's middle, so that one end of the face is nearer.
    let [from, to] = [-0.3, 0.7].map(|part| part * drawn.helix.1);
    pair.with_face([from, to]).unwrap()
}

/// `pair` with each gear without a direction turned so that its high tooth lies at an angle from the line to its mate, at `mating`.
fn pointed(pair: &GearPair, mating: Mating, angles: [f64; 2]) -> GearPair {
    let pose = Pose::new(pair, mating);
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|member| {
        let gear = pair.gear(member);
        if !gear.any_direction() {
            return gear.clone();
        }
        let rotation = pose.rotation(pair, member);
        let pitch = TAU / f64::from(gear.gear().basic_data().teeth());
        let places = gear.face().ascending() * (angles[member as usize] - rotation) / pitch;
        let tooth = 1.0 + places.rem_euclid(TAU / pitch);
        let tooth = if tooth < TAU / pitch + 1.0 {
            tooth
        } else {
            1.0
        };
        gear.with_runout(gear.eccentricity(), tooth).unwrap()
    });
    let pointed =
        GearPair::with_locked(wheel, pinion, pair.center_distance(), pair.locked()).unwrap();
    pointed.with_face(pair.face()).unwrap()
}

/// No pose in any direction lies beyond the bracket, and one attains it.
fn hold(drawn: &Drawn, seed: u64, pairs: u32, width: f64) {
    let mut random = Random(seed);
    for _ in 0..pairs {
        let pair = draw(&mut random, drawn);
        let run = extremes_of(&pair);
        let (least, greatest) = (run.least.as_ref().unwrap(), run.greatest.as_ref().unwrap());
        assert!(least.doubt.is_none() && greatest.doubt.is_none());
        for (extreme, end) in [(least, least.high), (greatest, greatest.low)] {
            assert!(extreme.high - extreme.low <= width, "{extreme:?}");
            assert!((extreme.pose.simulated.backlash.unwrap() - end).abs() < 1e-10);
        }
        for k in 0..1500 {
            // In the listed assembly phase.
            let near = *[&least.pose, &greatest.pose][k % 2].simulated.pose.mating();
            let cycle = cycle::matings(&pair) as f64;
            let mating = near.onward(&pair, cycle * random.within(0.0, 1.0));
            // Anywhere, towards the mate, away from it; of pairs found, a little round where they stand.
            let spread = [PI, 0.1, 0.01][k % 3];
            let away = if k % 2 == 0 { 0.0 } else { PI };
            let mating = match k % 5 {
                0 => near.onward(&pair, random.within(-0.01, 0.01)),
                _ => mating,
            };
            let mut angle = || away + random.within(-spread, spread);
            let pointed = pointed(&pair, mating, [angle(), angle()]);
            let pose = Pose::new(&pointed, mating);
            let lost = ExactKernel::new(&pointed).lost_motion(&pose).unwrap();
            let j_wt = lost.angle().unwrap() * pointed.operating_pitch_radius(pointed.free());
            assert!(
                j_wt >= least.low - 1e-10 && j_wt <= greatest.high + 1e-10,
                "{drawn:?}: {j_wt} of {} … {} at {mating:?}",
                least.low,
                greatest.high
            );
        }
    }
}

/// As in a drawing: runout alone.
#[test]
fn gears_off_their_axes_in_any_direction() {
    for locked in [Member::Wheel, Member::Pinion] {
        let drawn = Drawn {
            pitch: 0.0,
            open: [true, true],
            locked,
            helix: (0.0, 0.0),
        };
        hold(&drawn, 5, 12, 1.1e-6);
    }
}

/// The direction of one of them is known.
#[test]
fn one_gear_off_its_axis_in_any_direction() {
    for (open, locked) in [
        ([true, false], Member::Wheel),
        ([true, false], Member::Pinion),
        ([false, true], Member::Wheel),
    ] {
        let drawn = Drawn {
            pitch: 0.0,
            open,
            locked,
            helix: (0.0, 0.0),
        };
        hold(&drawn, 6, 8, 1.1e-6);
    }
}

/// With pitch deviations, so that corners of tips decide.
#[test]
fn pitch_and_runout_in_any_direction() {
    let drawn = Drawn {
        pitch: 0.008,
        open: [true, true],
        locked: Member::Wheel,
        helix: (0.0, 0.0),
    };
    hold(&drawn, 7, 12, 1.1e-6);
}

/// Helical gears: the centres of all sections are the same along the face.
#[test]
fn helical_gears_off_their_axes_in_any_direction() {
    for (pitch, open, locked) in [
        (0.0, [true, true], Member::Wheel),
        (0.0, [true, false], Member::Pinion),
        (0.004, [true, true], Member::Pinion),
        (0.004, [false, true], Member::Wheel),
    ] {
        let drawn = Drawn {
            pitch,
            open,
            locked,
            helix: (18.0, 30.0),
        };
        hold(&drawn, 8, 6, 1.1e-6);
    }
}

/// The bound's derivation is for eccentricities below a quarter of the free gear's pitch radius; beyond it nothing is claimed.
#[test]
fn a_runout_of_a_quarter_of_a_pitch_radius_is_not_bounded() {
    let gear = |teeth, shift, face| {
        let data = BasicGearData::new(teeth, 2.0, 20f64.to_radians()).unwrap();
        let design = GearDesign {
            profile_shift: shift,
            ..GearDesign::standard(data)
        };
        Gear::nominal(design).map(|gear| (gear, face)).unwrap()
    };
    let (wheel, front) = gear(40, 0.0, Face::Front);
    let (pinion, back) = gear(8, 0.1, Face::Back);
    for (eccentricity, bounded) in [(1.2, true), (2.2, false)] {
        let open = Deviations {
            eccentricity,
            high_tooth: 1.0,
            any_direction: true,
            ..Deviations::default()
        };
        let wheel = AsBuilt::new(wheel.clone(), front, &Deviations::default()).unwrap();
        let pinion = AsBuilt::new(pinion.clone(), back, &open).unwrap();
        let pair = GearPair::with_locked(wheel, pinion, 50.4, Member::Wheel).unwrap();
        let doubt = extremes_of(&pair).least.unwrap().doubt;
        assert_eq!(doubt != Some(Doubt::Unbounded), bounded, "{doubt:?}");
    }
}
