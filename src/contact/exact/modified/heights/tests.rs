//! Heights, their derivatives and their bounds, compared with the flanks themselves.

use super::*;
use crate::contact::exact::section::Section;
use crate::gear::{
    AsBuilt, BasicGearData, BasicRack, Deviations, Face, Gear, GearDesign, Modification, Side,
    Trace,
};
use crate::pair::{GearPair, Mating, Member, Pose};

/// Two gears with waves of `count` points on their flanks, the pinion off its axis, overlapping a little.
fn section(count: u32) -> (Section, GearPair) {
    let built = |teeth, face, phase: f64| {
        let gear = Gear::nominal(GearDesign {
            basic_data: BasicGearData::new(teeth, 3.0, 20f64.to_radians()).unwrap(),
            profile_shift: 0.2,
            rack: BasicRack::ISO_53_A,
            tip_diameter: None,
        })
        .unwrap();
        let (from, to) = (gear.form_roll(), gear.tip_roll());
        let point = |k: u32| {
            let share = f64::from(k) / f64::from(count - 1);
            let wave = 0.004 * (9.0 * share + phase).sin();
            let rough = 0.0005 * f64::from(k * 7919 % 13) / 13.0;
            (from + (to - from) * share, wave + rough)
        };
        let profile = Modification {
            traces: vec![Trace {
                tooth: None,
                points: (0..count).map(point).collect(),
            }],
            crowning: 0.005,
            ..Modification::default()
        };
        let deviations = Deviations {
            eccentricity: 0.02,
            high_tooth: 3.5,
            profiles: [profile.clone(), profile],
            ..Deviations::default()
        };
        AsBuilt::new(gear, face, &deviations).unwrap()
    };
    let (wheel, pinion) = (built(41, Face::Front, 0.3), built(27, Face::Back, 1.9));
    let pair = GearPair::with_locked(wheel, pinion, 103.2, Member::Wheel).unwrap();
    (Section::new(&pair), pair)
}

/// At a few gaps round the contact of some poses.
fn at_gaps(count: u32, mut ask: impl FnMut(&Heights)) {
    let (section, pair) = section(count);
    for k in 0..5 {
        let mating = Mating {
            wheel_tooth: 3,
            pinion_tooth: 5,
            flank: Side::Right,
            fraction: 0.23 * f64::from(k),
        };
        let posed = section.posed(&section.right, &Pose::new(&pair, mating));
        let halves = (posed.locked(0), posed.free(0));
        let flanks = [&halves.0, &halves.1].map(|half| Flank::new(half).unwrap());
        let found = posed.flanks_by_heights(0, f64::NEG_INFINITY, 0.0);
        let gap = found.unwrap().unwrap().gap;
        for off in [-1e-4, 0.0, 1e-4] {
            ask(&posed.heights(&halves, flanks, gap + off));
        }
    }
}

fn rolls(heights: &Heights, count: u32) -> Vec<f64> {
    let (low, high) = heights.locked.range;
    let at = |k| low + (high - low) * (f64::from(k) + 0.37) / f64::from(count);
    (0..count).map(at).collect()
}

/// Source: differences over 2e-6 rad within one piece.
#[test]
fn heights_have_the_stated_derivatives() {
    let mut seen = 0;
    at_gaps(60, |heights| {
        for x in rolls(heights, 40) {
            let step = 1e-6;
            let all = [x - step, x, x + step].map(|x| heights.look(x));
            let [Some(before), Some(look), Some(behind)] = all else {
                continue;
            };
            let rate = |of: fn(&FlankPlace) -> f64| (of(&behind) - of(&before)) / (2.0 * step);
            assert!(
                (rate(|look| look.height) - look.slope).abs() < 1e-6 * (1.0 + look.slope.abs())
            );
            assert!((rate(|look| look.y) - look.follows).abs() < 1e-6);
            // A knot in between has another second derivative on either side.
            let bend = heights.bend(&look);
            if [&before, &behind]
                .map(|near| heights.bend(near))
                .iter()
                .all(|near| (near - bend).abs() < 1e-2 * (1.0 + bend.abs()))
            {
                assert!((rate(|look| look.slope) - bend).abs() < 1e-2 * (1.0 + bend.abs()));
                seen += 1;
            }
        }
    });
    assert!(seen > 300, "{seen}");
}

/// At the greatest gap found the flanks touch: no height is above zero, and at one place it is zero.
#[test]
fn flanks_touch_where_the_height_is_zero() {
    let (section, pair) = section(300);
    for k in 0..40 {
        let mating = Mating {
            wheel_tooth: 1 + k,
            pinion_tooth: 5,
            flank: Side::Right,
            fraction: 0.1,
        };
        let posed = section.posed(&section.right, &Pose::new(&pair, mating));
        let found = posed.flanks_by_heights(0, f64::NEG_INFINITY, 0.0);
        let found = found.unwrap().unwrap();
        let halves = (posed.locked(0), posed.free(0));
        let flanks = [&halves.0, &halves.1].map(|half| Flank::new(half).unwrap());
        let heights = posed.heights(&halves, flanks, found.gap);
        let there = heights.look(found.locked.1).unwrap();
        assert!(there.height.abs() < 1e-12, "{there:?}");
        for x in rolls(&heights, 20_000) {
            if let Some(look) = heights.look(x)
                && heights.reaches(&look)
            {
                assert!(look.height < 1e-12, "{look:?} above {there:?}");
            }
        }
    }
}

/// Bounds hold at every sampled place, over stretches of any length in either sense, and are tight over short ones.
#[test]
fn no_place_is_higher_than_its_bounds() {
    let (mut seen, mut near) = (0, 0);
    at_gaps(200, |heights| {
        let (low, high) = heights.locked.range;
        for x in rolls(heights, 30) {
            let Some(look) = heights.look(x) else {
                continue;
            };
            // `a` rises to both sides of opposite normals.
            if !(look.cos > 0.1 && heights.reaches(&look)) {
                continue;
            }
            for on in [-1.0, 1.0] {
                let rest = if on > 0.0 { high - x } else { x - low };
                for width in [1e-4, 1e-3, 0.01, 0.1, 1.0] {
                    let width = f64::min(width, rest);
                    let bounds = [
                        heights.most(&look, on, width),
                        heights.most_near(&look, on, width),
                    ];
                    let mut greatest = f64::NEG_INFINITY;
                    for k in 0..=200 {
                        let there = heights.look(x + on * width * f64::from(k) / 200.0);
                        if let Some(there) = there
                            && heights.reaches(&there)
                        {
                            greatest = greatest.max(there.height);
                        }
                    }
                    assert!(
                        bounds.iter().all(|bound| greatest <= bound + 1e-13),
                        "{bounds:?} below {greatest}: {look:?} {on} {width}"
                    );
                    let level = bounds[0].min(greatest) - 1e-9;
                    assert!(width < rest || !heights.is_past(&look, on, width, level));
                    seen += 1;
                    near += u32::from(width <= 1e-4 && bounds[1] - greatest < 1e-6);
                }
            }
        }
    });
    assert!(seen > 2000 && near > 200, "{seen} {near}");
}

/// Source: every thousandth of a trace.
#[test]
fn no_deviation_exceeds_the_bound_of_its_table() {
    at_gaps(120, |heights| {
        let Flank {
            range: (low, high),
            heights: table,
            ..
        } = heights.locked;
        let at = |k: u32| low + (high - low) * f64::from(k) / 1000.0;
        let out = |k: u32| heights.locked.jet(at(k))[0];
        for (from, to) in [
            (0, 1000),
            (0, 3),
            (997, 1000),
            (13, 14),
            (200, 480),
            (500, 503),
        ] {
            let most = (from..=to).map(out).fold(f64::NEG_INFINITY, f64::max);
            assert!(table.most(at(from), at(to)) >= most);
        }
        let all: Vec<f64> = (0..=1000).map(out).collect();
        let [greatest, least] = table.whole();
        assert!(all.iter().all(|out| *out <= greatest && *out >= least));
    });
}
