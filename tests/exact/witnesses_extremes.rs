//! Cycles whose proven extremes expose a small mistake in the program, like `witnesses` for poses.

use super::*;
use crate::cycle;
use crate::extremes::{ROUNDING, WIDTH};
use crate::helical_pairs::try_drawn;
use crate::kit::ends;
use crate::random::{self, Kind, Random};
use crate::witnesses::listed;
use gearlash::contact::{Extreme, cycle_extremes};

/// Poses spread over the stretch by the golden ratio.
const POSES: u32 = 250;

/// A pair, and a stretch of its cycle: a mating, and a number of pitches from there.
fn drawn(number: u64) -> (GearPair, Mating, u64) {
    let index = number / 5 * 4 + number % 5 % 4;
    let mut random = Random(index.wrapping_mul(77) ^ 0xe1);
    let pair = match (number % 5, index % 4) {
        (4, _) => try_drawn(&mut Random(index ^ 0x99)).unwrap(),
        (_, 0 | 1) => {
            let kind = Kind {
                teeth: (6.0, 60.0),
                deviation: if index % 8 < 4 { 1.0 } else { 6.0 },
                shift: (-0.1, if index % 16 < 8 { 0.3 } else { 0.9 }),
            };
            random::pair(&mut random, kind)
        }
        (_, 2) => Pair::new(31, index).pose(0, Some(Depth::Any)).assembly,
        _ => Pair::new(31, index).pose(0, Some(Depth::Grazing)).assembly,
    };
    let first = Mating {
        fraction: 0.0,
        ..random::mating(&mut random, &pair)
    };
    let matings = cycle::matings(&pair).min(30);
    (pair, first, matings)
}

/// The least of `play` over `poses` spread poses, and downhill from there, mm.
fn least(play: impl Fn(f64) -> f64, pitches: f64) -> f64 {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let at = |k: u32| pitches * (f64::from(k) * golden).fract();
    let seen = (0..POSES).map(|k| (play(at(k)), at(k)));
    let mut best = seen.fold((f64::INFINITY, 0.0), |a, b| if b.0 < a.0 { b } else { a });
    let mut step = pitches / f64::from(POSES);
    while step > 1e-6 {
        let beside = [best.1 + step, best.1 - step].map(|place| place.clamp(0.0, pitches));
        let lower = beside.into_iter().find(|&place| play(place) < best.0);
        match lower {
            Some(place) => best = (play(place), place),
            None => step *= 0.4,
        }
    }
    best.0
}

/// Contradictions to the extremes of a stretch, all of which are proven.
fn against(number: u64) -> Vec<String> {
    let (pair, first, matings) = drawn(number);
    let kernel = ExactKernel::new(&pair);
    let found = cycle_extremes(&kernel, &pair, first, matings, WIDTH).unwrap();
    let radius = pair.operating_pitch_radius(pair.free());
    let at = |mating: Mating| kernel.lost_motion(&Pose::new(&pair, mating)).unwrap();
    let play = |place: f64| at(first.onward(&pair, place)).angle().unwrap() * radius;
    let mut against = Vec::new();
    let mut hold = |extreme: Option<Extreme>, sign: f64| {
        let Some(extreme) = extreme.filter(Extreme::is_proven) else {
            return against.push(format!("not proven: {found:?}"));
        };
        let [outer, inner] = ends([extreme.low, extreme.high].map(|end| sign * end));
        let seen = least(|place| sign * play(place), matings as f64);
        let attained = at(extreme.mating).angle();
        let attained = attained.map(|angle| sign * angle * radius);
        let kept = seen >= outer - ROUNDING
            && (outer..=outer + WIDTH + ROUNDING).contains(&inner)
            && attained.is_some_and(|attained| (attained - inner).abs() <= 1e-9);
        if !kept {
            against.push(format!("{seen} and {attained:?} for {extreme:?}"));
        }
    };
    hold(found.least, 1.0);
    hold(found.greatest, -1.0);
    if matches!(found.status, Status::Jammed | Status::NoContact) {
        against.push(format!("{:?}", found.status));
    }
    against
}

/// No pose is outside a bracket, its reported pose attains it, it is narrow, and it is proven. Source: poses of the exact method.
#[test]
fn extremes_of_these_cycles_hold() {
    let against = complaints(&listed("cycles"), |&number| against(number));
    assert!(against.is_empty(), "{against:#?}");
}
