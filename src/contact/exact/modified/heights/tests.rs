//! Heights, their derivatives and their bounds, compared with the flanks themselves.

use super::*;
use crate::contact::exact::section::Section;
use crate::gear::{Deviations, Face, GearDesign, Modification, Side, Trace};
use crate::pair::{GearPair, Mating, Member, Pose};

/// Two gears with waves of `count` points on their flanks, the pinion off its axis, overlapping a little.
fn pair(count: u32) -> GearPair {
    let built = |teeth, face, phase: f64| {
        let design = GearDesign::plain(teeth, 3.0).shifted(0.2);
        let gear = design.gear();
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
            profiles: [profile.clone(), profile],
            ..Deviations::off_axis(0.02, 3.5)
        };
        design.built(face, &deviations)
    };
    let (wheel, pinion) = (built(41, Face::Front, 0.3), built(27, Face::Back, 1.9));
    GearPair::with_locked(wheel, pinion, 103.2, Member::Wheel).unwrap()
}

/// At a few gaps round the contact of some poses.
fn at_gaps(count: u32, mut ask: impl FnMut(&Heights)) {
    let pair = pair(count);
    let section = Section::new(&pair);
    for k in 0..5 {
        let mating = Mating {
            fraction: 0.23 * f64::from(k),
            ..Mating::at(3, 5, Side::Right)
        };
        let posed = section.posed(&section.right, &Pose::new(&pair, mating));
        let halves = (posed.locked(0), posed.free(0));
        let flanks = [&halves.0, &halves.1].map(|half| Flank::new(half).unwrap());
        let found = greatest_gap_by_heights(&posed, 0, f64::NEG_INFINITY, 0.0);
        let gap = found.unwrap().unwrap().gap;
        for off in [-1e-4, 0.0, 1e-4] {
            ask(&search::heights(&posed, &halves, flanks, gap + off));
        }
    }
}

fn rolls(heights: &Heights, count: u32) -> impl Iterator<Item = f64> {
    let (low, high) = heights.locked.range;
    (0..count).map(move |k| low + (high - low) * (f64::from(k) + 0.37) / f64::from(count))
}

/// Source: differences over 2e-6 rad within one piece.
#[test]
fn heights_have_the_stated_derivatives() {
    let mut seen = 0;
    at_gaps(60, |heights| {
        for x in rolls(heights, 40) {
            let step = 1e-6;
            let all = [x - step, x, x + step].map(|x| heights.place(x));
            let [Some(before), Some(place), Some(behind)] = all else {
                continue;
            };
            let rate = |of: fn(&FlankPlace) -> f64| (of(&behind) - of(&before)) / (2.0 * step);
            let off = (rate(|place| place.height) - place.slope).abs();
            assert!(off < 1e-6 * (1.0 + place.slope.abs()));
            assert!((rate(|place| place.y) - place.follows).abs() < 1e-6);
            // A knot in between has another second derivative on either side.
            let bend = heights.bend(&place);
            let is_near = |found: f64| (found - bend).abs() < 1e-2 * (1.0 + bend.abs());
            if is_near(heights.bend(&before)) && is_near(heights.bend(&behind)) {
                assert!(is_near(rate(|place| place.slope)));
                seen += 1;
            }
        }
    });
    assert!(seen > 300, "{seen}");
}

/// Bounds hold at every sampled place, over stretches of any length in either sense, and are tight over short ones.
#[test]
fn no_place_is_higher_than_its_bounds() {
    let (mut seen, mut near) = (0, 0);
    at_gaps(200, |heights| {
        let (low, high) = heights.locked.range;
        let reached = |x| heights.place(x).filter(|place| heights.reaches(place));
        for x in rolls(heights, 30) {
            // `a` rises to both sides of opposite normals.
            let Some(place) = reached(x).filter(|place| place.cos > 0.1) else {
                continue;
            };
            for on in [-1.0, 1.0] {
                let rest = if on > 0.0 { high - x } else { x - low };
                for width in [1e-4, 1e-3, 0.01, 0.1, 1.0] {
                    let width = f64::min(width, rest);
                    let bounds = [
                        heights.most(&place, on, width),
                        heights.most_near(&place, on, width),
                    ];
                    let places = (0..=200).map(|k| x + on * width * f64::from(k) / 200.0);
                    let found = places.filter_map(|x| reached(x).map(|place| place.height));
                    let greatest = found.fold(f64::NEG_INFINITY, f64::max);
                    assert!(
                        bounds.iter().all(|bound| greatest <= bound + 1e-13),
                        "{bounds:?} below {greatest}: {place:?} {on} {width}"
                    );
                    let level = bounds[0].min(greatest) - 1e-9;
                    assert!(width < rest || !heights.is_past(&place, on, width, level));
                    seen += 1;
                    near += u32::from(width <= 1e-4 && bounds[1] - greatest < 1e-6);
                }
            }
        }
    });
    assert!(seen > 2000 && near > 200, "{seen} {near}");
}
