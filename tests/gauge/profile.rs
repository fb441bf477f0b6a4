//! Gears whose profiles deviate: a stated thickness is that of the flanks where the measurement touches them.

use super::{measure, quick};
use gearlash::gauge::{ProfileReadings, Settings};
use gearlash::gear::{
    BasicGearData, BasicRack, Face, Flank, Gear, GearDesign, Modification, Relief, Trace, involute,
};
use gearlash::metrology::{Measurements, ProbeReadings, ReadWith, RunoutStatement};

pub(super) fn design(teeth: u32) -> GearDesign {
    GearDesign {
        basic_data: BasicGearData::new(teeth, 3.0, 20f64.to_radians()).unwrap(),
        profile_shift: 0.1,
        rack: BasicRack::ISO_53_A,
        tip_diameter: None,
    }
}

/// Slope, crowning, both reliefs and a wavy trace of all teeth, together or one of them.
pub(super) fn profile(teeth: u32, which: usize) -> Modification {
    let basic_data = design(teeth).basic_data;
    let points = (0..40).map(|k| {
        let roll = 0.1 + 0.02 * f64::from(k);
        (roll, 0.003 * (9.0 * roll).sin())
    });
    let relief = |amount, from, parabolic| {
        Some(Relief {
            amount,
            from,
            parabolic,
        })
    };
    let r = basic_data.reference_radius();
    let all = Modification {
        slope: 0.012,
        crowning: 0.008,
        tip_relief: relief(0.02, r + 0.6, false),
        root_relief: relief(0.015, r - 0.4, true),
        traces: vec![Trace {
            tooth: None,
            points: points.collect(),
        }],
        range: Some([r - 1.2, r + 3.0]),
    };
    let none = Modification {
        range: all.range,
        ..Modification::default()
    };
    match which {
        0 => Modification {
            slope: all.slope,
            ..none
        },
        1 => Modification {
            crowning: all.crowning,
            ..none
        },
        2 => Modification {
            tip_relief: all.tip_relief,
            ..none
        },
        3 => Modification {
            root_relief: all.root_relief,
            ..none
        },
        4 => Modification {
            traces: all.traces,
            ..none
        },
        5 => Modification {
            crowning: -0.01,
            ..none
        },
        _ => all,
    }
}

/// The profiles of both flanks: on both, or on one.
pub(super) fn sides(one: &Modification) -> [[Modification; 2]; 3] {
    let none = Modification::default;
    [
        [one.clone(), one.clone()],
        [one.clone(), none()],
        [none(), one.clone()],
    ]
}

/// A gear of nominal thickness with these profiles, gauged over the range that they state.
fn gauged(profiles: &[Modification; 2], face: Face) -> ProfileReadings {
    let measurements = Measurements {
        profiles: profiles.clone(),
        ..Measurements::nominal(design(20), face)
    };
    let gear = measurements.measure().unwrap();
    let settings = Settings {
        evaluation: profiles.each_ref().map(|profile| profile.range),
        ..quick()
    };
    measure(gear.as_built.most(), settings).profile.unwrap()
}

/// Slope and crowning come out as they went in, of each flank its own, on either face. Source: ISO 1328-1, by which a straight line has a slope alone
/// and a parabola of no slope the form `C` and the total `C`. Positive crowning stands out in the middle.
#[test]
fn slope_and_crowning_come_out_as_they_went_in() {
    for face in [Face::Front, Face::Back] {
        let [sloped, crowned] = [profile(20, 0), profile(20, 1)];
        let read = gauged(&[sloped.clone(), crowned.clone()], face);
        let bound = 10.0 * read.error;
        let [right, left] = [read.flank(Flank::Right), read.flank(Flank::Left)];
        assert_eq!((right.shapes.len(), left.shapes.len()), (1, 1));
        let right = &right.shapes[0];
        assert!((right.slope - sloped.slope).abs() < bound, "{right:?}");
        assert!(right.form < bound && (right.total - sloped.slope).abs() < bound);
        let middle = left.evaluated.iter().sum::<f64>() / 2.0;
        let left = &left.shapes[0];
        assert!(left.slope.abs() < bound, "{}", left.slope);
        for value in [left.form, left.total] {
            assert!((value - crowned.crowning).abs() < bound, "{value}");
        }
        let near = |point: &&(f64, f64)| (point.0 - middle).abs() < 0.2;
        let standing = left.points.iter().find(near).unwrap().1;
        assert!((standing - crowned.crowning).abs() < 0.01 * crowned.crowning);
    }
}

/// A straight tip relief over the last part `q` of the evaluation range, to the amount `C` at its end. Source: least squares of the
/// ramp by hand, over the range from 0 to 1: slope `−12 C (q²/3 + (1/2 − q) q/2)`.
#[test]
fn a_ramp_has_the_slope_of_its_mean_line() {
    let mut ramp = profile(20, 2);
    let gear = Gear::nominal(design(20)).unwrap();
    ramp.range = Some([
        gear.basic_data().reference_radius() - 1.2,
        gear.tip_radius(),
    ]);
    let relief = ramp.tip_relief.unwrap();
    let roll = |radius| involute::roll_at(radius, gear.base_radius());
    let [start, end] = ramp.evaluated(&gear);
    let q = (end - roll(relief.from)) / (end - start);
    let expected = -12.0 * relief.amount * (q * q / 3.0 + (0.5 - q) * q / 2.0);
    let read = gauged(&[ramp.clone(), ramp], Face::Front);
    let shape = &read.flank(Flank::Left).shapes[0];
    // The edge lies between two of 201 points.
    assert!(
        (shape.slope - expected).abs() < 1e-4 * relief.amount,
        "{} {expected}",
        shape.slope
    );
    assert!(
        (shape.total - relief.amount).abs() < 10.0 * read.error,
        "{}",
        shape.total
    );
}

/// A trace comes out at its own points, on the tooth it was measured on, and the mean on others.
#[test]
fn traces_come_out_as_they_went_in() {
    let trace = |tooth, sign: f64| Trace {
        tooth: Some(tooth),
        points: (0..9)
            .map(|k| (0.15 + 0.07 * f64::from(k), sign * 0.003 * f64::from(k % 3)))
            .collect(),
    };
    let traced = Modification {
        traces: vec![trace(4, 1.0), trace(9, 3.0)],
        ..Modification::default()
    };
    let base = design(20).basic_data.base_radius();
    let read = gauged(&[traced.clone(), Modification::default()], Face::Front);
    for (tooth, times) in [(4, 1.0), (9, 3.0), (1, 2.0)] {
        let found = &read.flank(Flank::Right).tooth(tooth).points;
        for (roll, mm) in &trace(1, times).points {
            let length = base * roll;
            let Some(pair) = found
                .windows(2)
                .find(|w| w[0].0 <= length && length <= w[1].0)
            else {
                continue;
            };
            let part = (length - pair[0].0) / (pair[1].0 - pair[0].0);
            let there = pair[0].1 + part * (pair[1].1 - pair[0].1);
            // Between two of 201 points of a curve that bends by 9 µm in 0.07 rad.
            assert!((there - mm).abs() < 1e-4, "{tooth} {roll}: {there} {mm}");
        }
        // 0, 3 and 6 µm by turns.
        assert!((read.flank(Flank::Right).tooth(tooth).total - times * 0.006).abs() < 1e-5);
    }
    assert_eq!(read.flank(Flank::Right).worst_tooth(), 9);
    assert!(read.flank(Flank::Left).shapes[0].total < 10.0 * read.error);
}

/// Runout read with a ball on flanks of which each tooth has its own profile: what these do to the readings is no eccentricity.
/// Source: the eccentricity that was put in, 10 µm towards tooth 6.25. The traces alone read as more than 0.1 µm of it. (That of
/// tooth 5 is 1e-19 mm, less than the rounding of a roll: no reason to refuse the flank.)
#[test]
fn profiles_of_single_teeth_are_no_eccentricity() {
    let teeth = 20;
    let flat = |tooth: u32, mm: f64| Trace {
        tooth: Some(tooth),
        points: vec![(0.1, mm), (0.4, 1.2 * mm), (0.8, mm)],
    };
    let wave = |tooth: u32| 0.002 * (f64::from(tooth) * std::f64::consts::TAU / 20.0).cos();
    let traced = Modification {
        traces: (1..=teeth).map(|tooth| flat(tooth, wave(tooth))).collect(),
        ..Modification::default()
    };
    let with = |runout| Measurements {
        profiles: [traced.clone(), traced.clone()],
        runout,
        ..Measurements::nominal(design(teeth), Face::Front)
    };
    let put_in = with(RunoutStatement::Total {
        total_um: 20.0,
        high_tooth: Some(6.25),
    });
    let gear = put_in.measure().unwrap();
    let settings = Settings {
        ball: Some(5.25),
        ..quick()
    };
    let read = measure(gear.as_built.most(), settings).runout.unwrap();
    let um: Vec<f64> = read.deviations().iter().map(|mm| 1e3 * mm).collect();
    let readings = |profiles: bool| {
        let mut measurements = with(RunoutStatement::Readings(ProbeReadings {
            um: um.clone(),
            with: ReadWith::Ball(5.25),
        }));
        if !profiles {
            measurements.profiles = Default::default();
        }
        measurements.measure().unwrap().deviations
    };
    let found = readings(true);
    assert!(
        (found.eccentricity - 0.01).abs() < 1e-8,
        "{}",
        found.eccentricity
    );
    assert!(
        (found.high_tooth - 6.25).abs() < 1e-5,
        "{}",
        found.high_tooth
    );
    let taken = readings(false);
    assert!(
        (taken.eccentricity - 0.01).abs() > 1e-4,
        "{}",
        taken.eccentricity
    );
}
